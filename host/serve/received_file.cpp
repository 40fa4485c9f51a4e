#include "host/serve/received_file.h"

#include <ctime>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"

namespace slipstick {

ReceivedFile receive_file(const FileName& name, const HttpRequest& request, Services& services) {
  if (!request.upload || request.upload->size == 0) {
    return {{}, error_response(400, "the file is empty")};
  }
  auto file = services.store.add_file(name, request.upload->path, std::int64_t{std::time(nullptr)});
  if (!file) return {{}, error_response(file.error())};
  services.events.publish("files", to_json(*file).dump());
  return {std::move(*file), {}};
}

// Folders are not kept: what the form says of a path says nothing.
ReceivedFile receive_form(const HttpRequest& request, Services& services) {
  if (!request.upload || request.upload->name.empty()) {
    return {{}, error_response(400, "no file to upload")};
  }
  const auto name = FileName::from(last_segment(request.upload->name));
  if (!name) return {{}, error_response(415, name.error().message)};
  return receive_file(*name, request, services);
}

std::string form_field(const HttpRequest& request, const std::string& name) {
  if (!request.upload) return "";
  const auto at = request.upload->fields.find(name);
  return at == request.upload->fields.end() ? "" : at->second;
}

Result<void> print_file(const StoredFile& file, Services& services) {
  const auto job = queue_job(file, "{}", QueuePlace::kNow, services);
  if (!job) return fail(job.error());
  return {};
}

}  // namespace slipstick
