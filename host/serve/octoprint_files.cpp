// OctoPrint's API: uploads, and files to be printed.
#include <ctime>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/octoprint.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

std::string address_of(const HttpRequest& request, const std::string& name) {
  return "http://" + request.header("host") + "/api/files/local/" + percent_encoded(name);
}

Json to_json(const StoredFile& file, const HttpRequest& request) {
  const auto name = FileName::from(file.name);
  const bool is_gcode = name && name->is_gcode();
  const char* type = is_gcode ? "machinecode" : "model";
  return {{"name", file.name},
          {"display", file.name},
          {"path", file.name},
          {"type", type},
          {"typePath", Json::array({type, is_gcode ? "gcode" : "stl"})},
          {"origin", "local"},
          {"size", file.size},
          {"date", file.created},
          {"refs", {{"resource", address_of(request, file.name)}}}};
}

std::string field(const HttpUpload& upload, const std::string& name) {
  const auto at = upload.fields.find(name);
  return at == upload.fields.end() ? "" : at->second;
}

// Starts it now, or as soon as what is being printed is over.
Result<void> print_file(const StoredFile& file, Services& services) {
  const auto job = queue_job(file, "{}", QueuePlace::kNow, services);
  if (!job) return fail(job.error());
  return {};
}

// The file the address names, or the refusal.
struct Named {
  StoredFile file;
  std::optional<HttpResponse> refusal;
};
Named named_file(const HttpRequest& request, Store& store) {
  const auto file = store.file(request.parameter("name"));
  if (!file) return {{}, error_response(file.error())};
  if (!*file) return {{}, error_response(404, "there is no file " + request.parameter("name"))};
  return {**file, {}};
}

}  // namespace

HttpResponse octo_files(const HttpRequest& request, Services& services) {
  const auto files = services.store.files();
  if (!files) return error_response(files.error());
  Json list = Json::array();
  for (const StoredFile& file : *files) list.push_back(to_json(file, request));
  return json_response({{"files", list}});
}

HttpResponse octo_file(const HttpRequest& request, Services& services) {
  const Named named = named_file(request, services.store);
  return named.refusal ? *named.refusal : json_response(to_json(named.file, request));
}

// The fields may stand before the file or behind it. Folders are not kept: `path` says nothing.
HttpResponse octo_upload(const HttpRequest& request, Services& services) {
  const HttpUpload& upload = *request.upload;
  if (upload.name.empty() || upload.size == 0) return error_response(400, "no file to upload");
  const auto name = FileName::from(last_segment(upload.name));
  if (!name) return error_response(415, name.error().message);
  const auto file = services.store.add_file(*name, upload.path, std::int64_t{std::time(nullptr)});
  if (!file) return error_response(file.error());
  services.events.publish("files", to_json(*file, request).dump());
  const bool print = field(upload, "print") == "true";
  const bool select = print || field(upload, "select") == "true";
  if (select) {
    if (const auto ok = services.store.select(file->name); !ok) return error_response(ok.error());
  }
  if (print) {
    if (const auto ok = print_file(*file, services); !ok) return error_response(ok.error());
  }
  HttpResponse response = json_response({{"files", {{"local", to_json(*file, request)}}},
                                         {"done", true},
                                         {"effectiveSelect", select},
                                         {"effectivePrint", print}},
                                        201);
  response.headers.emplace_back("Location", address_of(request, file->name));
  return response;
}

HttpResponse octo_select(const HttpRequest& request, Services& services) {
  const Named named = named_file(request, services.store);
  if (named.refusal) return *named.refusal;
  const Json json = parse_json(request.body);
  if (!json.is_object() || !json.contains("command") || json["command"] != "select") {
    return error_response(400, "command: select");
  }
  if (const auto ok = services.store.select(named.file.name); !ok) {
    return error_response(ok.error());
  }
  if (!json.contains("print") || json["print"] != true) return empty_response();
  const auto ok = print_file(named.file, services);
  return ok ? empty_response() : error_response(ok.error());
}

}  // namespace slipstick
