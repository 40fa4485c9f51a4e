#include "host/serve/hook.h"

#include <fmt/format.h>
#include <unistd.h>

#include "host/serve/hook_program.h"
#include "host/serve/hook_web.h"

namespace slipstick {

Result<HookTarget> HookTarget::from(std::string_view text) {
  const HookTarget target(text);
  if (text.starts_with("http://") || text.starts_with("https://")) return target;
  if (target.is_program() && ::access(target.text_.c_str(), X_OK) == 0) return target;
  return fail(ErrorCode::kInput,
              fmt::format("'{}' is neither http://…, https://… nor the absolute path of a program "
                          "that may be run",
                          text));
}

Result<void> HookTarget::tell(std::string_view name, const nlohmann::ordered_json& facts) const {
  const std::string json =
      facts.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  if (is_program()) return run_program(text_, name, json, std::chrono::seconds(kHookSeconds));
  return post_json(text_, json);
}

Result<Hook> parse_hook(std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto kind = occasion_kind(text.substr(0, equals));
  if (equals == text.npos || !kind) {
    return fail(ErrorCode::kInput,
                fmt::format("--hook wants EVENT=TARGET, the event one of {}, not '{}'",
                            occasion_names(), text));
  }
  auto target = HookTarget::from(text.substr(equals + 1));
  if (!target) return fail(target.error().within("--hook"));
  return Hook{*kind, *std::move(target)};
}

}  // namespace slipstick
