// /api/v1/jobs/N/pauses: layers before which the print waits for somebody.
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/pause_layers.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

HttpResponse put_pauses(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const bool fits = json.is_object() && json.size() == 1 && json.contains("layers");
  if (!fits) return error_response(400, R"(the body is {"layers": [12, 40]})");
  const auto layers = pause_layers(nlohmann::json(json["layers"]));
  if (!layers) return error_response(layers.error());
  const auto id = id_in(request);
  if (!id) return error_response(404, "there is no such job");
  const auto job = services.store.job(*id);
  if (!job) return error_response(job.error());
  if (!*job) return error_response(404, "there is no such job");
  const auto name = FileName::from((*job)->file_name);
  if (name && name->is_gcode()) return error_response(409, "a G-code file has its pauses in it");
  const Json kept = *layers;
  const auto set = services.store.set_pauses(*id, kept.dump());
  if (!set) return error_response(set.error());
  if (!*set) return error_response(409, "the job is over");
  services.events.publish("jobs", Json{{"id", *id}, {"pauses", kept}}.dump());
  return json_response({{"layers", kept}});
}

}  // namespace slipstick
