#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// What a firmware can be built with that Marlin's default configuration leaves out.
enum class Feature : std::uint8_t {
  kAdvancedOk,
  kBedLeveling,
  kEeprom,
  kEmergencyParser,
  kFilamentChange,
  kFilamentSensor,
  kHostPrompts,
  kLinearAdvance,
  kMeatPack,
  kPositionReports,
  kProgress,
  kSdCard,
};

/// A set of them.
class Features {
 public:
  Features() = default;
  Features(std::initializer_list<Feature> features) {
    for (const Feature f : features) add(f);
  }

  void add(Feature feature) { bits_ |= bit(feature); }
  [[nodiscard]] bool has(Feature feature) const { return (bits_ & bit(feature)) != 0; }

 private:
  [[nodiscard]] static std::uint32_t bit(Feature feature) {
    return std::uint32_t{1} << static_cast<unsigned>(feature);
  }

  std::uint32_t bits_ = 0;
};

/// The feature of that name, as in `sim:?with=NAME,NAME`.
[[nodiscard]] std::optional<Feature> find_feature(std::string_view name);

/// All names, as a user is told them: "a, b, c".
[[nodiscard]] std::string feature_names();

/// `capability` ("ARCS:1") as a firmware with these features says it: those that features bring are
/// on.
[[nodiscard]] std::string capability_with(const Features& features, std::string_view capability);

}  // namespace slipstick
