#include "sim/sim_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"

namespace slipstick {

namespace {

constexpr double kBaudMax = 10'000'000;
constexpr double kSeedMax = 9e15;

/// The number `text` if it is within the limits.
std::optional<double> number_in(const std::string& text, double low, double high) {
  const auto value = parse_number(text);
  if (!value || *value < low || *value > high) return std::nullopt;
  return value;
}

bool is_whole(double value) {
  return value == std::floor(value);
}

// Each takes a value, or says what is wrong with it.

using Taken = std::optional<std::string>;

Taken take_baud(SimOptions& options, const std::string& value) {
  const auto baud = number_in(value, 0, kBaudMax);
  if (!baud || !is_whole(*baud)) return "give bits per second, 0 for USB";
  options.printer.baud = static_cast<int>(*baud);
  return {};
}

Taken take_corrupt(SimOptions& options, const std::string& value) {
  const auto share = number_in(value, 0, 1);
  if (!share) return "give the share of bytes damaged, 0 to 1";
  options.printer.corrupt = *share;
  return {};
}

Taken take_faults(SimOptions& options, const std::string& value) {
  for (std::string_view list = value; !list.empty();) {
    const std::size_t end = std::min(list.find(','), list.size());
    const auto spec = FaultSpec::parse(list.substr(0, end));
    if (!spec) return spec.error().message;
    if (options.printer.faults.size() == FaultSet::kMost) {
      return fmt::format("give at most {} faults", FaultSet::kMost);
    }
    options.printer.faults.push_back(*spec);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return {};
}

Taken take_firmware(SimOptions& options, const std::string& value) {
  const auto personality = find_personality(value);
  if (!personality) return "give one of " + personality_names();
  options.printer.personality = *personality;
  return {};
}

Taken take_jerk(SimOptions& options, const std::string& value) {
  if (value != "classic" && value != "deviation") return "give classic or deviation";
  auto& limits = options.printer.machine.limits;
  limits.jerk = value == "classic" ? std::optional(kDefaultJerk) : std::nullopt;
  return {};
}

Taken take_kinematics(SimOptions& options, const std::string& value) {
  const auto kinematics = Kinematics::named(value);
  if (!kinematics) return "give cartesian, corexy or delta";
  options.printer.machine.kinematics = *kinematics;
  return {};
}

Taken take_latency(SimOptions& options, const std::string& value) {
  constexpr double kMost = 255;  // of an FTDI adapter
  const auto ms = number_in(value, 0, kMost);
  if (!ms) return "give the ms of an adapter's latency timer, 0 to 255; 16 is usual";
  options.printer.latency = Moment(static_cast<Moment::rep>(*ms * 1000));
  return {};
}

Taken take_noise(SimOptions& options, const std::string& value) {
  constexpr double kMost = 20;
  const auto celsius = number_in(value, 0, kMost);
  if (!celsius) return "give °C that a reading may be off, 0 to 20";
  options.printer.machine.sensor_noise = *celsius;
  return {};
}

Taken take_realtime(SimOptions& options, const std::string& value) {
  if (value != "0" && value != "1") return "give 0 or 1";
  options.realtime = value == "1";
  return {};
}

Taken take_seed(SimOptions& options, const std::string& value) {
  const auto seed = number_in(value, 0, kSeedMax);
  if (!seed || !is_whole(*seed)) return "give a whole number";
  options.printer.seed = options.printer.machine.seed = static_cast<std::uint64_t>(*seed);
  return {};
}

Taken take_features(SimOptions& options, const std::string& value) {
  for (std::string_view list = value; !list.empty();) {
    const std::size_t end = std::min(list.find(','), list.size());
    const auto feature = find_feature(list.substr(0, end));
    if (!feature) return "give some of " + feature_names();
    options.printer.machine.features.add(*feature);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return {};
}

struct Option {
  std::string_view name;
  Taken (*take)(SimOptions&, const std::string&);
};

constexpr std::array kOptions = std::to_array<Option>({{"baud", take_baud},
                                                       {"corrupt", take_corrupt},
                                                       {"fault", take_faults},
                                                       {"firmware", take_firmware},
                                                       {"jerk", take_jerk},
                                                       {"kinematics", take_kinematics},
                                                       {"latency", take_latency},
                                                       {"noise", take_noise},
                                                       {"realtime", take_realtime},
                                                       {"seed", take_seed},
                                                       {"with", take_features}});

std::string option_names() {
  std::string names;
  for (const Option& option : kOptions) names.append(names.empty() ? "" : ", ").append(option.name);
  return names;
}

}  // namespace

Result<SimOptions> sim_options(const std::map<std::string, std::string>& options,
                               const MachineOptions& machine) {
  SimOptions result;
  result.printer.machine = machine;
  for (const auto& [name, value] : options) {
    const auto* known = std::ranges::find(kOptions, name, &Option::name);
    if (known == kOptions.end()) {
      return fail(ErrorCode::kInput,
                  fmt::format("sim: no option {}: there are {}", name, option_names()));
    }
    if (const Taken wanted = known->take(result, value)) {
      return fail(ErrorCode::kInput, fmt::format("sim: option {}={}: {}", name, value, *wanted));
    }
  }
  result.printer.machine = built(result.printer.machine);
  return result;
}

}  // namespace slipstick
