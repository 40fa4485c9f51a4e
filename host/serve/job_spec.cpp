#include "host/serve/job_spec.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/load_model.h"

namespace slipstick {
namespace {

using Json = nlohmann::json;

constexpr double kInch = 25.4;
constexpr std::size_t kSettingsMax = 200;

tl::unexpected<Error> refuse(std::string_view member, std::string_view what) {
  return fail(ErrorCode::kInput, fmt::format("{}: {}", member, what));
}

// A name of a file in configs/: `load_settings` would take anything else for a path.
Result<void> take_name(const Json& json, std::string_view member, std::string& name) {
  if (!json.is_string()) return refuse(member, "must be a name");
  const auto& text = json.get_ref<const std::string&>();
  const bool plain = text.size() <= 64 && text.find_first_of("/\\.") == std::string::npos;
  if (!plain) return refuse(member, "must be a name, not a path");
  name = text;
  return {};
}

Result<double> number(const Json& json, std::string_view member) {
  if (!json.is_number()) return refuse(member, "must be a number");
  const double value = json.get<double>();
  if (!std::isfinite(value)) return refuse(member, "is out of range");
  return value;
}

template <std::size_t kCount>
Result<std::array<double, kCount>> numbers(const Json& json, std::string_view member) {
  const auto wrong = [&] { return refuse(member, fmt::format("must be {} numbers", kCount)); };
  if (!json.is_array() || json.size() != kCount) return wrong();
  std::array<double, kCount> values{};
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto value = number(json[i], member);
    if (!value) return wrong();
    values[i] = *value;
  }
  return values;
}

Result<Vec3> vector(const Json& json, std::string_view member) {
  const auto v = numbers<3>(json, member);
  if (!v) return fail(v.error());
  return Vec3{(*v)[0], (*v)[1], (*v)[2]};
}

Result<void> take_settings(const Json& json, JobSpec& spec) {
  const auto texts = setting_texts(json);
  if (!texts) return fail(texts.error());
  for (const auto& [key, text] : *texts)
    spec.settings.overrides.push_back(fmt::format("{}={}", key, text));
  return {};
}

Result<void> take_bounds(const Json& json, JobSpec& spec) {
  const auto b = numbers<6>(json, "bounds");
  if (!b) return fail(b.error());
  spec.bounds = {{(*b)[0], (*b)[1], (*b)[2]}, {(*b)[3], (*b)[4], (*b)[5]}};
  if ((*b)[0] < (*b)[3] && (*b)[1] < (*b)[4] && (*b)[2] < (*b)[5]) return {};
  return refuse("bounds", "wants x0 < x1, y0 < y1 and z0 < z1");
}

Result<void> take_units(const Json& json, JobSpec& spec) {
  if (json != "mm" && json != "inch") return refuse("units", "must be \"mm\" or \"inch\"");
  spec.placement.unit = json == "inch" ? kInch : 1;
  return {};
}

Result<void> take_vector(const Json& json, std::string_view member, JobSpec& spec) {
  const auto v = vector(json, member);
  if (!v) return fail(v.error());
  if (member == "fit") spec.placement.fit = *v;
  if (member == "rotate") spec.placement.rotate = *v;
  if (member == "direction") spec.placement.direction = *v;
  return {};
}

Result<void> take_placement(const Json& json, JobSpec& spec) {
  if (!json.is_object()) return refuse("placement", "must be an object");
  for (const auto& [key, value] : json.items()) {
    Result<void> taken;
    if (key == "units") {
      taken = take_units(value, spec);
    } else if (key == "scale") {
      const auto scale = number(value, key);
      if (!scale) return fail(scale.error());
      spec.placement.scale = *scale;
    } else if (key == "bounds") {
      taken = take_bounds(value, spec);
    } else if (key == "fit" || key == "rotate" || key == "direction") {
      taken = take_vector(value, key, spec);
    } else {
      return refuse(key, "unknown; there are units, scale, fit, rotate, direction and bounds");
    }
    if (!taken) return taken;
  }
  return {};
}

Result<void> take_member(const std::string& key, const Json& value, JobSpec& spec) {
  if (key == "printer") return take_name(value, key, spec.settings.printer);
  if (key == "material") return take_name(value, key, spec.settings.material);
  if (key == "profile") return take_name(value, key, spec.settings.profile);
  if (key == "settings") return take_settings(value, spec);
  if (key == "placement") return take_placement(value, spec);
  return refuse(key, "unknown; there are printer, material, profile, settings and placement");
}

}  // namespace

Result<SettingTexts> setting_texts(const Json& json) {
  if (!json.is_object() || json.size() > kSettingsMax)
    return refuse("settings", "must be an object of settings");
  SettingTexts texts;
  for (const auto& [key, value] : json.items()) {
    if (!value.is_string() && !value.is_number()) return refuse(key, "must be a number or a text");
    texts.emplace(key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return texts;
}

SettingsRequest default_settings(const JobDefaults& defaults) {
  return {defaults.printer, defaults.material, defaults.profile, {}, {}};
}

Result<JobSpec> job_spec(const Json& json, const JobDefaults& defaults) {
  if (!json.is_object()) return fail(ErrorCode::kInput, "a job must be a JSON object");
  JobSpec spec;
  spec.settings = default_settings(defaults);
  for (const auto& [key, value] : json.items()) {
    if (const auto ok = take_member(key, value, spec); !ok) return fail(ok.error());
  }
  if (const auto settings = load_settings(spec.settings); !settings) return fail(settings.error());
  return spec;
}

Result<JobSpec> job_spec_from_text(std::string_view text, const JobDefaults& defaults) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return fail(ErrorCode::kInput, "not JSON");
  return job_spec(json, defaults);
}

Result<PreparedModel> prepare_model(const std::string& path, const std::string& name,
                                    const JobSpec& spec, SliceGoal goal) {
  auto settings = load_settings(spec.settings);
  if (!settings) return fail(settings.error());
  const auto loaded = load_model(path, {.bounds = spec.bounds});
  if (!loaded) return fail(loaded.error().within(name));
  const PrinterSettings& printer = settings->printer;
  auto placed = place_on_bed(*loaded->model, spec.placement, bed_centre(printer));
  if (!placed) return fail(placed.error().within(name));
  if (const auto fits = check_build_volume(placed->bounds, printer); !fits) {
    return fail(fits.error().within(name));
  }
  return PreparedModel{
      std::move(*placed), {std::move(*settings), goal, 0, 0, {}, {}}, loaded->warning};
}

}  // namespace slipstick
