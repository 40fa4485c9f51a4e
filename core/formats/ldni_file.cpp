#include "core/formats/ldni_file.h"

#include <fmt/format.h>

#include <utility>

#include "core/formats/inflate.h"
#include "core/formats/sealed.h"

namespace slipstick {
namespace {

constexpr SealedKind kKind{"SLIPLDN\n", 1};
constexpr std::size_t kHeadSize = 4 + 4 * 8;
constexpr int kVarintBits = 35;  // more than any number here has

void append_varint(std::string& text, std::uint32_t value) {
  while (value >= 0x80) {
    text += static_cast<char>(static_cast<unsigned char>(value | 0x80));
    value >>= 7;
  }
  text += static_cast<char>(value);
}

std::optional<std::uint32_t> take_varint(Inflater& bytes) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < kVarintBits; shift += 7) {
    const auto byte = bytes.next();
    if (!byte) return {};
    value |= std::uint64_t{*byte & 0x7Fu} << shift;
    if ((*byte & 0x80u) != 0) continue;
    // Each number is written in one way only.
    if ((*byte == 0 && shift > 0) || value > UINT32_MAX) return {};
    return static_cast<std::uint32_t>(value);
  }
  return {};
}

std::optional<LdniNormal> take_normal(Inflater& bytes) {
  std::uint32_t word = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto byte = bytes.next();
    if (!byte) return {};
    word |= std::uint32_t{*byte} << shift;
  }
  return LdniNormal::from_word(word);
}

// False where the bytes end, name no normal, or come to more than an `Ldni` holds.
bool take_ray(Inflater& bytes, LdniRays& rays) {
  const auto count = take_varint(bytes);
  if (!count || *count > Ldni::kSamplesMax - rays.samples.size()) return false;
  const std::size_t first = rays.samples.size();
  std::uint32_t depth = 0;
  for (std::uint32_t k = 0; k < *count; ++k) {
    const auto step = take_varint(bytes);
    if (!step || *step > UINT32_MAX - depth) return false;
    depth += *step;
    rays.samples.push_back({depth, {}});
  }
  for (std::size_t k = first; k < rays.samples.size(); ++k) {
    const auto normal = take_normal(bytes);
    if (!normal) return false;
    rays.samples[k].normal = *normal;
  }
  rays.end_ray();
  return true;
}

Result<std::unique_ptr<LdniModel>> read(std::string_view bytes) {
  const auto body = unseal(kKind, bytes);
  if (!body) return fail(body.error());
  std::string_view rest = *body;
  if (rest.size() < kHeadSize) return fail(ErrorCode::kInput, "ends in its head; make it again");
  const std::uint32_t resolution = take_u32(rest);
  const double width = take_f64(rest), x = take_f64(rest), y = take_f64(rest), z = take_f64(rest);
  const int side = resolution > LdniGrid::kResolutionMax ? -1 : static_cast<int>(resolution);
  const auto grid = LdniGrid::of(side, width, {x, y, z});
  if (!grid) return fail(grid.error());
  Inflater inflater(rest);
  LdniAxes axes;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    for (std::size_t ray = 0; ray < grid->rays(); ++ray) {
      if (take_ray(inflater, axes[axis])) continue;
      return fail(ErrorCode::kInput,
                  fmt::format("ray {} of axis {} is damaged; make it again", ray, "xyz"[axis]));
    }
  }
  if (inflater.next() || !inflater.complete()) {
    return fail(ErrorCode::kInput, "goes on after its last ray; make it again");
  }
  auto ldni = Ldni::of(*grid, std::move(axes));
  if (!ldni) return fail(ldni.error());
  return std::make_unique<LdniModel>(*std::move(ldni));
}

}  // namespace

std::string write_ldni(const Ldni& ldni) {
  std::string rays;
  for (const LdniRays& axis : ldni.axes()) {
    for (std::size_t ray = 0; ray < axis.size(); ++ray) {
      const auto samples = axis.of(ray);
      append_varint(rays, static_cast<std::uint32_t>(samples.size()));
      std::uint32_t before = 0;
      for (const LdniSample& s : samples) {
        append_varint(rays, s.depth - std::exchange(before, s.depth));
      }
      for (const LdniSample& s : samples) append_u32(rays, s.normal.word());
    }
  }
  const Vec3 origin = ldni.grid().origin();
  std::string body;
  append_u32(body, static_cast<std::uint32_t>(ldni.grid().resolution()));
  for (const double v : {ldni.grid().width(), origin.x, origin.y, origin.z}) append_f64(body, v);
  body += deflated(rays);
  return seal(kKind, body);
}

Result<std::unique_ptr<LdniModel>> load_ldni_model(std::string_view bytes, std::string_view name) {
  auto model = read(bytes);
  if (!model) return fail(model.error().within(name));
  return model;
}

}  // namespace slipstick
