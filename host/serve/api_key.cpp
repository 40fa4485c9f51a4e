#include "host/serve/api_key.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include "host/atomic_file.h"
#include "host/serve/secrets.h"

namespace slipstick {

Result<std::string> load_or_make_secret(const std::filesystem::path& path, std::size_t least,
                                        const std::function<std::string()>& make) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) {
    auto text = read_file(path);
    if (!text) return fail(text.error());
    while (text->ends_with('\n')) text->pop_back();
    if (text->size() >= least) return text;
    return fail(ErrorCode::kUnavailable,
                fmt::format("{}: has fewer than {} characters; remove the file for a new one",
                            path.string(), least));
  }
  std::string secret = make();
  const mode_t before = ::umask(0077);
  const auto written = write_file(path, secret + "\n");
  ::umask(before);
  if (!written) return fail(written.error());
  return secret;
}

Result<std::string> load_or_make_key(const std::filesystem::path& path) {
  constexpr std::size_t kCharactersMin = 32;
  return load_or_make_secret(path, kCharactersMin, random_token);
}

}  // namespace slipstick
