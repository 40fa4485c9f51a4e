#include "host/paper/paper_run.h"

#include <fmt/format.h>

#include "core/formats/lua_script.h"
#include "core/formats/point_cloud.h"
#include "core/solid/ldni_build.h"
#include "core/solid/ldni_model.h"
#include "core/solid/ldni_sample.h"
#include "core/solid/mesh_model.h"
#include "core/solid/rbf_fit.h"
#include "host/atomic_file.h"
#include "host/mesh_as.h"
#include "host/paper/slice_through.h"
#include "host/process_memory.h"
#include "host/stopwatch.h"

namespace slipstick {
namespace {

constexpr double kToleranceOfSampling = 0.1;  // as the paper's contours keep to their r'

// Not evenly: the windows are the paper's, whatever the shape of the stand-in.
Affine3 stretch(const Model& model, const PaperRow& row) {
  const Affine3 upright = row.lies_on_its_back ? rotation_to_z({0, 1, 0}) : scaling({1, 1, 1});
  const Box3 box = model.bounds_under(upright);
  const Vec3 size = box.size();
  const Vec3 wanted = kInch * row.size;
  const Affine3 to_size =
      composed(scaling({wanted.x / size.x, wanted.y / size.y, wanted.z / size.z}),
               translation({-box.low.x, -box.low.y, -box.low.z}));
  return composed(to_size, upright);
}

Result<LdniGrid> grid_of(const PaperRow& row) {
  const double width = kInch * row.ray_width;
  const double half = 0.5 * (row.rays - 1) * width;
  return LdniGrid::of(row.rays, width, 0.5 * kInch * row.size - Vec3{half, half, half});
}

/// Another model, larger.
class StretchedModel final : public Model {
 public:
  StretchedModel(const Model& model, const Affine3& map) : model_(model), map_(map) {}

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override {
    return model_.bounds_under(composed(map, map_));
  }
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override {
    return model_.placed(composed(map, map_));
  }
  [[nodiscard]] std::string_view kind() const override { return model_.kind(); }
  [[nodiscard]] std::string size_text() const override { return model_.size_text(); }

 private:
  const Model& model_;
  Affine3 map_;
};

/// A model and how it becomes as large as the paper's.
struct Subject {
  std::unique_ptr<Model> model;
  Affine3 map;
};

Subject stretched(std::unique_ptr<Model> model, const PaperRow& row) {
  const Affine3 map = stretch(*model, row);
  return {std::move(model), map};
}

// Rays are as far apart as the paper's in the stretched solid.
Result<Subject> images_of_mesh(TriangleMesh mesh, const PaperRow& row) {
  const Affine3 map = stretch(MeshModel(mesh), row);
  for (Vec3& p : mesh.vertices) p = map(p);
  const auto grid = grid_of(row);
  if (!grid) return fail(grid.error());
  auto made = ldni_of(MeshModel(std::move(mesh)), *grid);
  if (!made) return fail(made.error());
  return Subject{std::make_unique<LdniModel>(std::move(made->ldni)), {}};
}

Result<Subject> subject_of_script(const PaperRow& row) {
  auto model = load_lua_model(truss_script(), row.name);
  if (!model) return fail(model.error());
  if (row.table != PaperTable::kLdni) return stretched(*std::move(model), row);
  const StretchedModel larger(**model, stretch(**model, row));
  const auto grid = grid_of(row);
  if (!grid) return fail(grid.error());
  auto made = ldni_by_sampling(larger, *grid);
  if (!made) return fail(made.error());
  return Subject{std::make_unique<LdniModel>(*std::move(made)), {}};
}

Result<Subject> tree_of_mesh(TriangleMesh mesh, const PaperRow& row) {
  auto tree = bsp_model(MeshModel(std::move(mesh)));
  if (!tree) return fail(tree.error());
  return stretched(*std::move(tree), row);
}

Result<Subject> fit_of_points(std::string_view bytes, const PaperRow& row) {
  auto fit = load_point_model(bytes, row.stand_in);
  if (!fit) return fail(fit.error());
  return stretched(*std::move(fit), row);
}

Result<Subject> subject_of(const PaperRow& row, const std::filesystem::path& models) {
  if (row.stand_in.empty()) return subject_of_script(row);
  const auto bytes = read_file(models / row.stand_in);
  if (!bytes) return fail(bytes.error());
  if (row.table == PaperTable::kRbf) return fit_of_points(*bytes, row);
  auto mesh = read_mesh(*bytes, "ply");
  if (!mesh) return fail(mesh.error());
  return row.table == PaperTable::kBsp ? tree_of_mesh(*std::move(mesh), row)
                                       : images_of_mesh(*std::move(mesh), row);
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
  auto subject = subject_of(row, options.models);
  if (!subject) return fail(subject.error().within(row.name));
  PlacedSolid placed{
      subject->model->placed(subject->map), {{0, 0, 0}, kInch * row.size}, inverse(subject->map)};
  return PaperSubject{std::move(subject->model), std::move(placed), request_for(row, options)};
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
