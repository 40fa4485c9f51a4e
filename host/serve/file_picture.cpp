#include "host/serve/file_picture.h"

#include <algorithm>

#include "host/figures/stack_figure.h"

namespace slipstick {
namespace {

// As coarse as a picture may be: neither a tall nor a wide model takes longer than others.
SlicingRequest coarse(const PreparedModel& model) {
  SlicingRequest request = model.request;
  SlicingSettings& slicing = request.settings.slicing;
  const Vec3 size = model.placed.bounds.high - model.placed.bounds.low;
  slicing.sampling = std::max(size.x, size.y) / kPictureSamples;
  slicing.layer_height = size.z / kPictureLayers;
  slicing.first_layer_height = slicing.layer_height;
  slicing.tolerance = slicing.sampling / 4;
  slicing.regularize = 0;
  slicing.certify = Certification::kOff;
  request.threads = 1;  // the others are for the print
  return request;
}

}  // namespace

Result<void> draw_file(const std::filesystem::path& path, const StoredFile& file,
                       const JobDefaults& defaults, const std::filesystem::path& picture) {
  const auto name = FileName::from(file.name);
  if (!name) return fail(name.error());
  if (name->is_gcode()) return fail(ErrorCode::kInput, "a G-code file has no picture");
  const auto spec = job_spec_from_text("{}", defaults);
  if (!spec) return fail(spec.error());
  const auto model = prepare_model(path, file.name, *spec, SliceGoal::kContours);
  if (!model) return fail(model.error());
  auto job = SlicingJob::start(model->placed, coarse(*model));
  if (!job) return fail(job.error().within(file.name));
  const auto drawn = draw_stack(**job, kPictureSide, picture);
  if (!drawn) return fail(drawn.error().within(file.name));
  return {};
}

}  // namespace slipstick
