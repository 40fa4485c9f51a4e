// /api/v1/files: what can be printed, and layers of it before it is.
#include <charconv>
#include <nlohmann/json.hpp>

#include "host/atomic_file.h"
#include "host/serve/api.h"
#include "host/serve/file_picture.h"
#include "host/serve/received_file.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

HttpResponse no_such_file(const std::string& name) {
  return error_response(404, "there is no file " + name);
}

// The file of the address, or the refusal.
struct Sought {
  StoredFile file;
  std::optional<HttpResponse> refusal;
};
Sought sought_file(const HttpRequest& request, Store& store) {
  const std::string& name = request.parameter("name");
  const auto file = store.file(name);
  if (!file) return {{}, error_response(file.error())};
  if (!*file) return {{}, no_such_file(name)};
  return {**file, {}};
}

LayerPreview::Question question(const HttpRequest& request, Services& services,
                                const StoredFile& file) {
  const auto spec = request.target.query.find("spec");
  return {services.store.path_of(file.id, file.extension).string(), file,
          spec == request.target.query.end() ? "{}" : spec->second, services.printer.defaults()};
}

HttpResponse json_text(const Result<std::string>& text) {
  if (!text) return error_response(text.error());
  return {200, "application/json", *text, {}};
}

}  // namespace

Json to_json(const StoredFile& file) {
  return {{"name", file.name}, {"size", file.size}, {"created", file.created}};
}

HttpResponse get_files(const HttpRequest&, Services& services) {
  const auto files = services.store.files();
  if (!files) return error_response(files.error());
  Json list = Json::array();
  for (const StoredFile& file : *files) list.push_back(to_json(file));
  return json_response({{"files", list}});
}

HttpResponse get_file(const HttpRequest& request, Services& services) {
  const Sought sought = sought_file(request, services.store);
  return sought.refusal ? *sought.refusal : json_response(to_json(sought.file));
}

HttpResponse put_file(const HttpRequest& request, Services& services) {
  const auto name = FileName::from(request.parameter("name"));
  if (!name) return error_response(name.error());
  const ReceivedFile received = receive_file(*name, request, services);
  return received.refusal ? *received.refusal : json_response(to_json(received.file), 201);
}

HttpResponse delete_file(const HttpRequest& request, Services& services) {
  const auto removed = services.store.remove_file(request.parameter("name"));
  if (!removed) return error_response(removed.error());
  if (!*removed) return no_such_file(request.parameter("name"));
  services.events.publish("files", Json{{"removed", request.parameter("name")}}.dump());
  return empty_response();
}

HttpResponse get_picture(const HttpRequest& request, Services& services) {
  const Sought sought = sought_file(request, services.store);
  if (sought.refusal) return *sought.refusal;
  const auto picture = services.store.picture_of(sought.file.id);
  std::error_code ignored;
  if (!std::filesystem::exists(picture, ignored)) {
    const auto path = services.store.path_of(sought.file.id, sought.file.extension);
    const auto drawn = draw_file(path, sought.file, services.printer.defaults(), picture);
    if (!drawn && !std::filesystem::exists(path, ignored)) return no_such_file(sought.file.name);
    if (!drawn) return error_response(drawn.error());
  }
  auto bytes = read_file(picture);
  if (!bytes) return error_response(bytes.error());
  return {200, "image/png", *std::move(bytes), {}};
}

HttpResponse get_layers(const HttpRequest& request, Services& services) {
  const Sought sought = sought_file(request, services.store);
  if (sought.refusal) return *sought.refusal;
  return json_text(services.preview.describe(question(request, services, sought.file)));
}

HttpResponse get_layer(const HttpRequest& request, Services& services) {
  const Sought sought = sought_file(request, services.store);
  if (sought.refusal) return *sought.refusal;
  const std::string& text = request.parameter("layer");
  int layer = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), layer);
  if (error != std::errc() || end != text.data() + text.size()) {
    return error_response(400, "layer: must be a number from 0");
  }
  return json_text(services.preview.layer(question(request, services, sought.file), layer));
}

}  // namespace slipstick
