// /api/v1/jobs/N/settings and cancel-object: other settings, or one object less, in what is not
// made yet.
#include <nlohmann/json.hpp>

#include "core/region/islands.h"
#include "host/serve/api.h"
#include "host/settings_changes_text.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTries = 2;  // a job leaves the queue once

HttpResponse from_layer(std::int64_t job, int layer, Services& services) {
  services.events.publish("jobs", Json{{"id", job}, {"changed_from_layer", layer}}.dump());
  return json_response({{"from_layer", layer}});
}

// Nothing if the job is not queued any more.
Result<std::optional<HttpResponse>> change_queued(const StoredJob& job, const Json& settings,
                                                  Services& services) {
  Json spec = parse_json(job.spec);
  for (const auto& [key, value] : settings.items()) spec["settings"][key] = value;
  const auto checked = job_spec(nlohmann::json(spec), services.printer.defaults());
  if (!checked) return fail(checked.error());
  const auto queued = services.store.set_spec(job.id, spec.dump());
  if (!queued) return fail(queued.error());
  if (!*queued) return std::optional<HttpResponse>();
  return from_layer(job.id, 0, services);
}

HttpResponse change_print(const StoredJob& job, const SettingTexts& values, Services& services) {
  const auto timeline = services.printer.timeline_of(job.id);
  if (!timeline) return error_response(409, "this print begins or ends just now; try again");
  const auto layer = timeline->change(values);
  if (!layer) return error_response(layer.error());
  if (!*layer) return error_response(409, "every layer of this print is made already");
  const auto kept = services.store.set_changes(job.id, changes_text(timeline->changes()));
  if (!kept) return error_response(kept.error());
  return from_layer(job.id, **layer, services);
}

bool is_gcode(const StoredJob& job) {
  const auto name = FileName::from(job.file_name);
  return name && name->is_gcode();
}

}  // namespace

HttpResponse change_settings(const HttpRequest& request, Services& services) {
  const auto id = id_in(request);
  const Json json = parse_json(request.body);
  const auto values = setting_texts(nlohmann::json(json));
  if (!values) return error_response(values.error());
  if (values->empty()) return error_response(400, "no setting is named");
  for (int i = 0; id && i < kTries; ++i) {
    const auto job = services.store.job(*id);
    if (!job) return error_response(job.error());
    if (!*job) break;
    if (is_gcode(**job)) return error_response(409, "a G-code file has its settings in it");
    if ((*job)->state == JobState::kPrinting) return change_print(**job, *values, services);
    if ((*job)->state != JobState::kQueued) return error_response(409, "the job is over");
    auto done = change_queued(**job, json, services);
    if (!done) return error_response(done.error());
    if (*done) return **std::move(done);
  }
  return error_response(404, "there is no such job");
}

// The layer is the one that whoever asks has before him.
HttpResponse cancel_object(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const bool fits = json.is_object() && json.size() == 2 && json.contains("x") &&
                    json.contains("y") && json["x"].is_number() && json["y"].is_number();
  if (!fits) return error_response(400, R"(the body is {"x": 110.5, "y": 87})");
  const auto id = id_in(request);
  const auto layer = services.board.layer();
  if (!id || services.board.get().job != *id || !layer || !layer->image)
    return error_response(409, "no layer of this job is being printed");
  const CancelledObject object{layer->layer - 1, json["x"], json["y"]};
  const BitImage island = island_at(*layer->image, object.x, object.y);
  if (!island.any()) return error_response(409, "nothing of this layer is there");
  if (island == *layer->image)
    return error_response(409, "that is all there is in this layer: cancel the print");
  const auto job = services.store.job(*id);
  if (!job) return error_response(job.error());
  if (!*job) return error_response(404, "there is no such job");
  return change_print(**job, {{kCancelObject, cancelled_object_text(object)}}, services);
}

}  // namespace slipstick
