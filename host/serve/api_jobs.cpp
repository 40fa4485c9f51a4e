// /api/v1/jobs: the queue and the history.
#include <charconv>
#include <ctime>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "host/serve/api.h"
#include "host/serve/pause_layers.h"
#include "host/settings_changes_text.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kListed = 200;

// Zero stands for never.
Json moment(std::int64_t seconds) {
  return seconds == 0 ? Json() : Json(seconds);
}

// Numbers as numbers again.
Json value_of(const std::string& key, const std::string& text) {
  const auto setting = find_setting(key);
  const auto number = parse_number(text);
  if (!setting || !number) return text;
  if (std::holds_alternative<IntegerSetting>((*setting)->kind)) return static_cast<int>(*number);
  return std::holds_alternative<NumberSetting>((*setting)->kind) ? Json(*number) : Json(text);
}

Json changes_of(const StoredJob& job) {
  Json all = Json::array();
  const auto changes = parse_changes(job.changes);
  for (const auto& change : changes.value_or(std::vector<SettingsChange>())) {
    Json settings = Json::object();
    for (const auto& [key, text] : change.values) settings[key] = value_of(key, text);
    all.push_back({{"from_layer", change.from_layer}, {"settings", settings}});
  }
  return all;
}

Json to_json(const StoredJob& job) {
  return {{"id", job.id},
          {"file", job.file_name},
          {"state", name_of(job.state)},
          {"spec", Json::parse(job.spec, nullptr, false)},
          {"created", job.created},
          {"started", moment(job.started)},
          {"ended", moment(job.ended)},
          {"message", job.message},
          {"changes", changes_of(job)},
          {"pauses", pauses_of(job)},
          {"result", job.result.empty() ? Json() : Json::parse(job.result, nullptr, false)}};
}

Json to_json(const StoredJob& job, const Store& store) {
  Json json = to_json(job);
  json["can_be_taken_up"] = store.can_be_taken_up(job);
  return json;
}

HttpResponse no_such_job() {
  return error_response(404, "there is no such job");
}

HttpResponse add_job(const std::string& name, const Json& spec, Services& services) {
  const auto checked = job_spec(nlohmann::json(spec), services.printer.defaults());
  if (!checked) return error_response(checked.error());
  const auto file = services.store.file(name);
  if (!file) return error_response(file.error());
  if (!*file) return error_response(404, "there is no file " + name);
  const auto job = queue_job(**file, spec.dump(), QueuePlace::kLast, services);
  if (!job) return error_response(job.error());
  HttpResponse response = json_response(to_json(*job), 201);
  response.headers.emplace_back("Location", "/api/v1/jobs/" + std::to_string(job->id));
  return response;
}

}  // namespace

std::optional<std::int64_t> id_in(const HttpRequest& request) {
  const std::string& text = request.parameter("id");
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return id;
}

Result<StoredJob> queue_job(const StoredFile& file, std::string_view spec, QueuePlace place,
                            Services& services) {
  auto job = services.store.add_job(file, spec, std::int64_t{std::time(nullptr)});
  if (!job) return job;
  if (place == QueuePlace::kNow) {
    if (const auto put = services.store.put_first(job->id); !put) return fail(put.error());
    const bool free = services.board.get().job == 0;
    if (free) {
      if (const auto ok = services.store.clear_bed(); !ok) return fail(ok.error());
    }
  }
  services.events.publish("jobs", to_json(*job).dump());
  services.printer.wake();
  return job;
}

HttpResponse get_jobs(const HttpRequest&, Services& services) {
  const auto jobs = services.store.jobs(kListed);
  if (!jobs) return error_response(jobs.error());
  Json list = Json::array();
  for (const StoredJob& job : *jobs) list.push_back(to_json(job, services.store));
  return json_response({{"jobs", list}});
}

HttpResponse post_job(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  if (!json.is_object()) return error_response(400, "the body must be a JSON object");
  std::string name;
  Json spec = Json::object();
  for (const auto& [key, value] : json.items()) {
    if (key == "file" && value.is_string()) {
      name = value.get<std::string>();
    } else if (key == "spec") {
      spec = value;
    } else {
      return error_response(400, key + ": unknown; a job has a file (its name) and a spec");
    }
  }
  return add_job(name, spec, services);
}

HttpResponse get_job(const HttpRequest& request, Services& services) {
  const auto id = id_in(request);
  if (!id) return no_such_job();
  const auto job = services.store.job(*id);
  if (!job) return error_response(job.error());
  return *job ? json_response(to_json(**job, services.store)) : no_such_job();
}

HttpResponse cancel_job(const HttpRequest& request, Services& services) {
  const auto id = id_in(request);
  if (!id) return no_such_job();
  const auto cancelled = services.store.cancel_queued(*id, std::int64_t{std::time(nullptr)});
  if (!cancelled) return error_response(cancelled.error());
  if (*cancelled) {
    services.events.publish("jobs", Json{{"id", *id}, {"state", "cancelled"}}.dump());
    return empty_response();
  }
  if (services.printer.cancel(*id)) return empty_response();
  const auto job = services.store.job(*id);
  if (!job) return error_response(job.error());
  return *job ? error_response(409, "the job is over") : no_such_job();
}

HttpResponse take_up_job(const HttpRequest& request, Services& services) {
  const auto id = id_in(request);
  if (!id) return no_such_job();
  const Json json = request.body.empty() ? Json::object() : parse_json(request.body);
  const bool fits = json.is_object() && json.size() == json.count("recover") &&
                    json.value("recover", Json(false)).is_boolean();
  if (!fits) return error_response(400, "the body is empty or {\"recover\": true or false}");
  const auto job = services.store.job(*id);
  if (!job) return error_response(job.error());
  if (!*job) return no_such_job();
  if (!services.store.can_be_taken_up(**job)) {
    return error_response(409, "this print was not cut off, or its bed was cleared");
  }
  const Consent consent = json.value("recover", false) ? Consent::kRecover : Consent::kNone;
  if (services.printer.take_up(*id, consent)) return empty_response();
  return error_response(409, "a print is under way");
}

}  // namespace slipstick
