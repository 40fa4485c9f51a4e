#include "host/serve/caller.h"

#include <algorithm>
#include <array>

namespace slipstick {
namespace {

constexpr std::array<std::string_view, 4> kNames{"read", "print", "control", "admin"};

}  // namespace

std::string_view name_of(Scope scope) {
  return kNames[static_cast<std::size_t>(scope)];
}

std::optional<Scope> scope_named(std::string_view name) {
  const auto at = std::find(kNames.begin(), kNames.end(), name);
  if (at == kNames.end()) return {};
  return static_cast<Scope>(at - kNames.begin());
}

}  // namespace slipstick
