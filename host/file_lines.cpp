#include "host/file_lines.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace slipstick {

Result<std::unique_ptr<FileLines>> FileLines::open(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return fail(ErrorCode::kInput, fmt::format("cannot read {}: {}", path.string(),
                                               std::generic_category().message(errno)));
  }
  return std::unique_ptr<FileLines>(new FileLines(path, std::move(stream)));
}

Result<std::optional<Line>> FileLines::next() {
  for (std::string text; std::getline(stream_, text);) {
    ++number_;
    auto line = normalise(text);
    if (!line) return fail(line.error().within(fmt::format("{}:{}", path_.string(), number_)));
    if (*line) return line;
  }
  if (stream_.bad()) {
    return fail(ErrorCode::kUnavailable, fmt::format("cannot read {}", path_.string()));
  }
  return std::optional<Line>();
}

}  // namespace slipstick
