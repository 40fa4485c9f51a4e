#include "host/serve/layer_preview.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/outputs/contours_text.h"

namespace slipstick {
namespace {

nlohmann::ordered_json triple(Vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

Result<std::string> LayerPreview::describe(const Question& question) {
  const auto prepared = model(question);
  if (!prepared) return fail(prepared.error());
  const PreparedModel& m = **prepared;
  const auto stack = LayerStack::over(m.placed.bounds.high.z, m.request.settings.slicing);
  if (!stack) return fail(stack.error());
  return nlohmann::ordered_json{{"layers", stack->count()},
                                {"low", triple(m.placed.bounds.low)},
                                {"high", triple(m.placed.bounds.high)},
                                {"bed", triple(m.request.settings.printer.bed_size)},
                                {"warning", m.warning}}
      .dump();
}

Result<std::string> LayerPreview::layer(const Question& question, int layer) {
  const auto prepared = model(question);
  if (!prepared) return fail(prepared.error());
  if (layer >= LayerStack::kLayersMax) return fail(ErrorCode::kInput, "no such layer");
  SlicingRequest request = (*prepared)->request;
  request.threads = 1;  // the others are for the print
  request.first_layer = layer;
  request.end_layer = layer + 1;
  request.settings.slicing.certify = Certification::kOff;
  const auto job = SlicingJob::start((*prepared)->placed, request);
  if (!job) return fail(job.error());
  const auto sliced = (*job)->next();
  if (!sliced) return fail(sliced.error());
  return contours_line(**sliced);
}

Result<const PreparedModel*> LayerPreview::model(const Question& question) {
  if (loaded_ && loaded_->file == question.file.id && loaded_->spec == question.spec) {
    return &loaded_->model;
  }
  const auto name = FileName::from(question.file.name);
  if (!name) return fail(name.error());
  if (name->is_gcode()) return fail(ErrorCode::kInput, "a G-code file has no layers to slice");
  const auto spec = job_spec_from_text(question.spec, question.defaults);
  if (!spec) return fail(spec.error());
  auto prepared = prepare_model(question.path, question.file.name, *spec, SliceGoal::kContours);
  if (!prepared) return fail(prepared.error());
  loaded_.emplace(Loaded{question.file.id, question.spec, std::move(*prepared)});
  return &loaded_->model;
}

}  // namespace slipstick
