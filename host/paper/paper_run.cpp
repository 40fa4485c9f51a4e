#include "host/paper/paper_run.h"

#include <fmt/format.h>

#include "core/formats/lua_script.h"
#include "core/formats/point_cloud.h"
#include "core/solid/bsp_build.h"
#include "core/solid/bsp_model.h"
#include "core/solid/mesh_model.h"
#include "core/solid/rbf_fit.h"
#include "host/atomic_file.h"
#include "host/paper/slice_through.h"
#include "host/process_memory.h"
#include "host/stopwatch.h"

namespace slipstick {
namespace {

constexpr double kToleranceOfSampling = 0.1;  // as the paper's contours keep to their r'

Result<std::unique_ptr<Model>> bsp_model(std::string_view bytes) {
  const auto mesh = read_mesh(bytes, "ply");
  if (!mesh) return fail(mesh.error());
  auto tree = bsp_of(*mesh);
  if (!tree) return fail(tree.error());
  return BspModel::of(*std::move(tree));
}

Result<std::unique_ptr<Model>> model_of(const PaperRow& row, const std::filesystem::path& models) {
  if (row.stand_in.empty()) return load_lua_model(truss_script(), row.name);
  const auto bytes = read_file(models / row.stand_in);
  if (!bytes) return fail(bytes.error());
  if (row.table == PaperTable::kBsp) return bsp_model(*bytes);
  if (row.table == PaperTable::kRbf) return load_point_model(*bytes, row.stand_in);
  return load_mesh_model(*bytes, row.stand_in);
}

// Not evenly: the windows are the paper's, whatever the shape of the stand-in.
PlacedSolid stretched(const Model& model, const PaperRow& row) {
  const Affine3 upright = row.lies_on_its_back ? rotation_to_z({0, 1, 0}) : scaling({1, 1, 1});
  const Box3 box = model.bounds_under(upright);
  const Vec3 size = box.size();
  const Vec3 wanted = kInch * row.size;
  const Affine3 to_size =
      composed(scaling({wanted.x / size.x, wanted.y / size.y, wanted.z / size.z}),
               translation({-box.low.x, -box.low.y, -box.low.z}));
  const Affine3 map = composed(to_size, upright);
  return {model.placed(map), {{0, 0, 0}, wanted}, inverse(map)};
}

SlicingRequest request_for(const PaperRow& row, const PaperOptions& options) {
  SlicingRequest request;
  request.goal = SliceGoal::kContours;
  request.threads = options.threads;
  SlicingSettings& slicing = request.settings.slicing;
  slicing.layer_height = slicing.first_layer_height = kPaperLayerHeight * kInch;
  slicing.sampling = row.sampling * kInch;
  slicing.certify = Certification::kOff;
  slicing.tolerance = kToleranceOfSampling * slicing.sampling;
  if (options.method == PaperMethod::kTheirs) {
    slicing.place = Placement::kSliding;
    slicing.simplify = Simplification::kVsa;
  }
  return request;
}

}  // namespace

Result<PaperSubject> paper_subject(const PaperRow& row, const PaperOptions& options) {
  auto model = model_of(row, options.models);
  if (!model) return fail(model.error().within(row.name));
  PlacedSolid placed = stretched(**model, row);
  return PaperSubject{*std::move(model), std::move(placed), request_for(row, options)};
}

Result<PaperRun> run_paper_row(const PaperRow& row, const PaperOptions& options) {
  PaperRun run;
  Stopwatch building;
  const auto subject = paper_subject(row, options);
  if (!subject) return fail(subject.error());
  run.representation = fmt::format("{}: {}", subject->model->kind(), subject->model->size_text());
  run.build_seconds = building.lap();
  run.solid_mb = begin_peak_anew();
  Stopwatch slicing;
  const auto totals = slice_through(subject->placed, subject->request);
  if (!totals) return fail(totals.error().within(row.name));
  run.seconds = slicing.lap();
  run.beyond_mb = peak_mb() - run.solid_mb;
  run.sampling_seconds = totals->seconds.sample;
  run.edges_before = totals->edges_before;
  run.edges_after = totals->edges_after;
  run.distortion = totals->max_regional_distortion / kCubicInch;
  run.layers = totals->layers;
  run.violations = totals->violations;
  return run;
}

}  // namespace slipstick
