#include "host/contours_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

namespace slipstick {
namespace {

using Json = nlohmann::json;

// nlohmann throws on missing keys and wrong types; this is the one place that calls it to read.
template <typename T, typename Read>
std::optional<T> parsed(const std::string& line, std::string& reason, Read read) {
  try {
    return read(Json::parse(line));
  } catch (const Json::exception& e) {
    reason = e.what();
    return {};
  }
}

ContoursFile::Header header_of(const Json& json) {
  ContoursFile::Header header;
  header.model = json.value("model", "");
  header.sampling = json.at("sampling").get<double>();
  header.grid_width = json.value("grid_width", 0.0);
  header.layer_height = json.at("layer_height").get<double>();
  header.layers = json.at("layers").get<int>();
  const auto numbers = json.at("to_model").get<std::array<double, 16>>();
  for (std::size_t i = 0; i < 12; ++i) header.to_model.rows[i / 4][i % 4] = numbers[i];
  return header;
}

ContoursFile::Layer layer_of(const Json& json) {
  ContoursFile::Layer layer{json.at("layer").get<int>(), json.at("z").get<double>(), {}};
  for (const Json& loop : json.at("loops")) {
    AuditLoop read{{}, loop.at("depth").get<int>()};
    for (const Json& p : loop.at("points")) {
      const auto xy = p.get<std::array<double, 2>>();
      read.points.push_back({xy[0], xy[1]});
    }
    layer.loops.push_back(std::move(read));
  }
  return layer;
}

}  // namespace

Result<ContoursFile> ContoursFile::open(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return fail(ErrorCode::kInput, fmt::format("cannot read {}: {}", path.string(),
                                               std::generic_category().message(errno)));
  }
  ContoursFile file(path, std::move(stream));
  if (const auto ok = file.read_header(); !ok) return fail(ok.error());
  return file;
}

Result<void> ContoursFile::read_header() {
  std::string line;
  line_ = 1;
  if (!std::getline(stream_, line)) return fail(error("the file is empty"));
  std::string reason;
  const auto is_ours = parsed<bool>(line, reason, [](const Json& json) {
    return json.at("format") == "slipstick-contours" && json.at("version") == 1;
  });
  if (!is_ours || !*is_ours) {
    return fail(error("not a contours file of version 1: the header says otherwise"));
  }
  auto header = parsed<Header>(line, reason, header_of);
  if (!header) return fail(error(reason));
  header_ = std::move(*header);
  return {};
}

Result<std::optional<ContoursFile::Layer>> ContoursFile::next() {
  std::string line;
  const int read = line_ - 1;
  if (!std::getline(stream_, line)) {
    if (read == header_.layers) return std::optional<Layer>();
    return fail(error(fmt::format("{} layers, but the header says {}", read, header_.layers)));
  }
  ++line_;
  std::string reason;
  auto layer = parsed<Layer>(line, reason, layer_of);
  if (!layer) return fail(error(reason));
  return layer;
}

Error ContoursFile::error(std::string_view what) const {
  return {ErrorCode::kInput, fmt::format("{}:{}: {}", path_.string(), line_, what)};
}

}  // namespace slipstick
