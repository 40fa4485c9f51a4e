#include "core/formats/lda_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <utility>

#include "core/formats/sealed.h"

namespace slipstick {
namespace {

constexpr std::size_t kHeadSize = 5 * 4;
constexpr std::size_t kBytesPerSample = 3 * 4;

double take_f32(std::string_view& rest) {
  return static_cast<double>(std::bit_cast<float>(take_u32(rest)));
}

float f32_at(std::string_view numbers, std::size_t index) {
  std::string_view rest = numbers.substr(4 * index, 4);
  return std::bit_cast<float>(take_u32(rest));
}

tl::unexpected<Error> cut_short(std::size_t axis) {
  return fail(ErrorCode::kInput,
              fmt::format("ends within axis {}; it is cut short, make it again", "xyz"[axis]));
}

class AxisReader {
 public:
  AxisReader(const LdniGrid& grid, std::size_t axis) : grid_(grid), axis_(axis) {}

  Result<LdniRays> read(std::string_view& rest) {
    std::vector<std::uint32_t> first;
    if (rest.size() / 4 < grid_.rays() + 1) return cut_short(axis_);
    first.reserve(grid_.rays() + 1);
    for (std::size_t ray = 0; ray <= grid_.rays(); ++ray) first.push_back(take_u32(rest));
    const std::size_t count = first.back();
    if (rest.size() / kBytesPerSample < count) return cut_short(axis_);
    xs_ = rest.substr(0, 4 * count);
    ys_ = rest.substr(4 * count, 4 * count);
    depths_ = rest.substr(8 * count, 4 * count);
    rest.remove_prefix(kBytesPerSample * count);
    for (std::size_t ray = 0; ray < grid_.rays(); ++ray) {
      if (first[ray] > first[ray + 1] || first[ray + 1] > count) return wrong(ray, "overlaps");
      for (std::size_t k = first[ray]; k < first[ray + 1]; ++k) {
        if (!add(k, rays_.first.back())) return wrong(ray, "has a depth or normal that is none");
      }
      rays_.end_ray();
    }
    return std::move(rays_);
  }

 private:
  [[nodiscard]] tl::unexpected<Error> wrong(std::size_t ray, const char* what) const {
    return fail(ErrorCode::kInput,
                fmt::format("ray {} of axis {} {}; make it again", ray, "xyz"[axis_], what));
  }

  bool add(std::size_t k, std::size_t ray_begin) {
    const double x = f32_at(xs_, k), y = f32_at(ys_, k), depth = f32_at(depths_, k);
    const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    const auto normal = LdniNormal::of({x, y, std::signbit(depth) ? -z : z});
    const double units = std::abs(depth) / grid_.width() * LdniGrid::kUnits;
    if (!normal || !(units < static_cast<double>(grid_.depth_end()) - 1)) return false;
    const auto whole = static_cast<std::uint32_t>(std::llround(units));
    std::vector<LdniSample>& samples = rays_.samples;
    if (samples.size() > ray_begin && samples.back().depth == whole) {
      samples.pop_back();
    } else {
      samples.push_back({whole, *normal});
    }
    return true;
  }

  const LdniGrid& grid_;
  std::size_t axis_;
  LdniRays rays_;
  std::string_view xs_;
  std::string_view ys_;
  std::string_view depths_;
};

Result<std::unique_ptr<LdniModel>> read(std::string_view bytes) {
  if (bytes.size() < kHeadSize) return fail(ErrorCode::kInput, "ends in its head; make it again");
  const std::uint32_t resolution = take_u32(bytes);
  const double width = take_f32(bytes), x = take_f32(bytes), y = take_f32(bytes),
               z = take_f32(bytes);
  const int side = resolution > LdniGrid::kResolutionMax ? -1 : static_cast<int>(resolution);
  const auto grid = LdniGrid::of(side, width, {x, y, z});
  if (!grid) return fail(grid.error());
  LdniAxes axes;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    auto rays = AxisReader(*grid, axis).read(bytes);
    if (!rays) return fail(rays.error());
    axes[axis] = *std::move(rays);
  }
  if (!bytes.empty()) return fail(ErrorCode::kInput, "goes on after its last axis; make it again");
  auto ldni = Ldni::of(*grid, std::move(axes));
  if (!ldni) return fail(ldni.error());
  return std::make_unique<LdniModel>(*std::move(ldni));
}

}  // namespace

Result<std::unique_ptr<LdniModel>> load_lda_model(std::string_view bytes, std::string_view name) {
  auto model = read(bytes);
  if (!model) return fail(model.error().within(name));
  return model;
}

}  // namespace slipstick
