#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "host/serve/occasions.h"

namespace slipstick {

/// Who is told: a web address, which gets JSON by POST, or a program, which gets a name as its only
/// argument and the JSON on its standard input.
class HookTarget {
 public:
  /// \param text "http://…", "https://…", or the absolute path of a program that is there and that
  /// we may run. \return kInput for anything else.
  [[nodiscard]] static Result<HookTarget> from(std::string_view text);

  /// Tells it and waits for it, at most `kHookSeconds`; a program that takes longer is killed. No
  /// shell is involved, redirections are not followed. \return kUnavailable, why not.
  [[nodiscard]] Result<void> tell(std::string_view name, const nlohmann::ordered_json& facts) const;

 private:
  explicit HookTarget(std::string_view text) : text_(text) {}
  [[nodiscard]] bool is_program() const { return text_.starts_with('/'); }

  std::string text_;
};
inline constexpr int kHookSeconds = 20;

struct Hook {
  OccasionKind on = OccasionKind::kStarted;
  HookTarget target;
};

/// "layer=http://10.0.0.7/snapshot", "done=/usr/local/bin/lights-out". \return kInput for anything
/// else.
[[nodiscard]] Result<Hook> parse_hook(std::string_view text);

}  // namespace slipstick
