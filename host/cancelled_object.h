#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// An object that a print goes on without, named by a point of it in a layer.
struct CancelledObject {
  int layer = 0;
  double x = 0;  ///< mm on the bed.
  double y = 0;
  friend bool operator==(const CancelledObject&, const CancelledObject&) = default;
};

/// Stands beside the settings of a SettingsChange, with such a text as value.
inline constexpr const char* kCancelObject = "cancel_object";

/// "12 30.5 40.25", and back as the very same numbers; nothing for any other text.
[[nodiscard]] std::string cancelled_object_text(const CancelledObject& object);
[[nodiscard]] std::optional<CancelledObject> parse_cancelled_object(std::string_view text);

}  // namespace slipstick
