#include "host/serve/api_key.h"

#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <array>

#include "host/atomic_file.h"

namespace slipstick {

namespace {

constexpr std::size_t kBytes = 32;

}  // namespace

Result<std::string> random_key() {
  std::array<unsigned char, kBytes> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != ssize_t{kBytes}) {
    return fail(ErrorCode::kUnavailable, "the system has no random numbers for a key");
  }
  std::string key;
  for (const unsigned char byte : bytes) key += fmt::format("{:02x}", byte);
  return key;
}

Result<std::string> load_or_make_key(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) {
    auto text = read_file(path);
    if (!text) return fail(text.error());
    while (text->ends_with('\n')) text->pop_back();
    if (text->size() >= kBytes) return text;
    return fail(ErrorCode::kUnavailable,
                fmt::format("{}: a key has at least 32 characters; remove the file for a new one",
                            path.string()));
  }
  auto key = random_key();
  if (!key) return key;
  const mode_t before = ::umask(0077);
  const auto written = write_file(path, *key + "\n");
  ::umask(before);
  if (!written) return fail(written.error());
  return key;
}

}  // namespace slipstick
