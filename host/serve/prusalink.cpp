// PrusaLink's API: what PrusaSlicer asks of it. Its version is OctoPrint's, which it takes.
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/received_file.h"
#include "host/serve/slicer_hosts.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

// A boolean of RFC 8941.
bool is_true(const std::string& value) {
  return value == "?1";
}

std::int64_t free_bytes(const Services& services) {
  std::error_code error;
  const auto space = std::filesystem::space(services.store.incoming(".").parent_path(), error);
  return error ? 0 : static_cast<std::int64_t>(space.available);
}

}  // namespace

// A storage without room is not offered by the slicer.
HttpResponse link_storage(const HttpRequest&, Services& services) {
  return json_response({{"storage_list", Json::array({Json{{"path", "/local"},
                                                           {"name", "slipstick"},
                                                           {"type", "LOCAL"},
                                                           {"free_space", free_bytes(services)},
                                                           {"read_only", false},
                                                           {"available", true}}})}});
}

// Folders are not kept.
HttpResponse link_put_file(const HttpRequest& request, Services& services) {
  const auto name = FileName::from(last_segment(request.parameter("path")));
  if (!name) return error_response(name.error());
  const auto before = services.store.file(name->text());
  if (!before) return error_response(before.error());
  if (*before && !is_true(request.header("overwrite"))) {
    return error_response(409, "there is a file " + name->text() + " already");
  }
  const ReceivedFile received = receive_file(*name, request, services);
  if (received.refusal) return *received.refusal;
  if (is_true(request.header("print-after-upload"))) {
    const auto ok = print_file(received.file, services);
    if (!ok) return error_response(ok.error());
  }
  return json_response(to_json(received.file), 201);
}

}  // namespace slipstick
