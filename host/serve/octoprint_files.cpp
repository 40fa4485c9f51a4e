// OctoPrint's API: uploads, and files to be printed.
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/octoprint.h"
#include "host/serve/received_file.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

std::string address_of(const HttpRequest& request, const std::string& name) {
  return "http://" + request.header("host") + "/api/files/local/" + percent_encoded(name);
}

Json to_json(const StoredFile& file, const HttpRequest& request) {
  const Json types = octo_type_path(file.name);
  return {{"name", file.name},
          {"display", file.name},
          {"path", file.name},
          {"type", types[0]},
          {"typePath", types},
          {"origin", "local"},
          {"size", file.size},
          {"date", file.created},
          {"refs", {{"resource", address_of(request, file.name)}}}};
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

// The fields may stand before the file or behind it.
HttpResponse octo_upload(const HttpRequest& request, Services& services) {
  const ReceivedFile received = receive_form(request, services);
  if (received.refusal) return *received.refusal;
  const StoredFile& file = received.file;
  const bool print = form_field(request, "print") == "true";
  const bool select = print || form_field(request, "select") == "true";
  if (select) {
    if (const auto ok = services.store.select(file.name); !ok) return error_response(ok.error());
  }
  if (print) {
    if (const auto ok = print_file(file, services); !ok) return error_response(ok.error());
  }
  HttpResponse response = json_response({{"files", {{"local", to_json(file, request)}}},
                                         {"done", true},
                                         {"effectiveSelect", select},
                                         {"effectivePrint", print}},
                                        201);
  response.headers.emplace_back("Location", address_of(request, file.name));
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
