#include <fmt/format.h>

#include "core/base/check.h"
#include "core/contour/place_roots.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

constexpr int kRounds = 20;

BitImage image_of(const Subject& s) {
  const auto section = s.solid->section(s.z);
  auto image = sample(*section, s.grid);
  SLIPSTICK_CHECK(image.has_value());
  return std::move(*image);
}

ContourSet rooted(const Subject& s, const BitImage& image) {
  ContourSet contours = trace(image, Ambiguity::kSolid);
  place_roots(contours, *s.solid->section(s.z));
  return contours;
}

SimplifyOptions tenth_of_a_cell(const Subject& s) {
  SimplifyOptions options;
  options.tolerance = 0.1 * s.grid.width();
  return options;
}

Row whole_layer(const Subject& s) {
  std::size_t sticks = 0;
  const Timing sampling = cpu_seconds(kRounds, [&s] { static_cast<void>(image_of(s)); });
  const Timing all = cpu_seconds(kRounds, [&s, &sticks] {
    const ContourSet contours = rooted(s, image_of(s));
    sticks = contours.sticks().size();
    static_cast<void>(simplify_fewest(contours, tenth_of_a_cell(s)));
  });
  return {fmt::format("Filigree-size layer, {}², {} ({} sticks), all stages, one core",
                      s.grid.columns(), s.name, sticks),
          "≤ 20 ms",
          fmt::format("{}, {:.0f} ns a stick, of it sampling {}", all.text("ms"),
                      1e9 * all.least / static_cast<double>(sticks), sampling.text("ms")),
          all.least <= 0.020};
}

// One stage's share of a stick.
struct PerStick {
  Timing trace;
  Timing roots;
  Timing fewest;
  Timing greedy;
};

PerStick per_stick(const Subject& s, std::size_t& sticks) {
  const BitImage image = image_of(s);
  const ContourSet traced = trace(image, Ambiguity::kSolid);
  const ContourSet contours = rooted(s, image);
  sticks = traced.sticks().size();
  PerStick result;
  result.trace = cpu_seconds(kRounds, [&] { static_cast<void>(trace(image, Ambiguity::kSolid)); });
  result.roots = cpu_seconds(kRounds, [&] {
    ContourSet copy = traced;
    place_roots(copy, *s.solid->section(s.z));
  });
  result.fewest = cpu_seconds(
      kRounds, [&] { static_cast<void>(simplify_fewest(contours, tenth_of_a_cell(s))); });
  result.greedy = cpu_seconds(
      kRounds, [&] { static_cast<void>(simplify_greedy(contours, tenth_of_a_cell(s))); });
  return result;
}

std::vector<Row> stick_rows() {
  const Subject s = smooth_subjects()[2];
  std::size_t sticks = 0;
  const PerStick t = per_stick(s, sticks);
  const double each = 1e9 / static_cast<double>(sticks);
  const double fewest = (t.trace.least + t.roots.least + t.fewest.least) * each;
  const double greedy = (t.trace.least + t.roots.least + t.greedy.least) * each;
  const std::string parts =
      fmt::format("trace {:.0f}, roots {:.0f}", t.trace.least * each, t.roots.least * each);
  return {{fmt::format("trace + roots + fewest edges, per stick, one core ({}, {} sticks)", s.name,
                       sticks),
           "≤ 500 ns",
           fmt::format("{:.0f} ns ({}, fewest {:.0f})", fewest, parts, t.fewest.least * each),
           fewest <= 500},
          {"the same with greedy", "≤ 150 ns",
           fmt::format("{:.0f} ns ({}, greedy {:.0f})", greedy, parts, t.greedy.least * each),
           greedy <= 150}};
}

}  // namespace

std::vector<Row> layer_rows() {
  std::vector<Row> rows;
  for (const Subject& s : filigree_layers()) rows.push_back(whole_layer(s));
  for (Row& row : stick_rows()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace slipstick::targets
