// Whole layers of the subjects, and what comes behind the outline: toolpaths, text.
#include <benchmark/benchmark.h>

#include "core/contour/place_roots.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/gcode/write.h"
#include "core/image/sample.h"
#include "core/toolpath/plan_layer.h"
#include "tests/bench/stages/stages.h"
#include "tests/bench/subjects.h"

namespace slipstick {
namespace {

BitImage image_of(const bench::Subject& s) {
  return sample(*s.solid->section(s.z), s.grid).value();
}

Simplified contours_of(const bench::Subject& s, const BitImage& image) {
  ContourSet contours = trace(image, Ambiguity::kSolid);
  place_roots(contours, *s.solid->section(s.z));
  SimplifyOptions options;
  options.tolerance = 0.1 * s.grid.width();
  return simplify_fewest(contours, options);
}

void whole_layer(benchmark::State& state, const bench::Subject& subject) {
  for (auto _ : state) benchmark::DoNotOptimize(contours_of(subject, image_of(subject)));
}

LayerToolpaths toolpaths_of(const bench::Subject& s, const BitImage& image,
                            const Outline& outline) {
  return plan_layer({3, 0.8, 0.2, image, outline, image, image}, PrintSettings{});
}

void toolpaths(benchmark::State& state, const bench::Subject& subject) {
  const BitImage image = image_of(subject);
  const Outline outline = contours_of(subject, image).outline;
  for (auto _ : state) benchmark::DoNotOptimize(toolpaths_of(subject, image, outline));
}

void gcode(benchmark::State& state, const bench::Subject& subject) {
  const BitImage image = image_of(subject);
  const LayerToolpaths layer = toolpaths_of(subject, image, contours_of(subject, image).outline);
  for (auto _ : state) benchmark::DoNotOptimize(write_layer(layer, PrintSettings{}));
}

}  // namespace

void register_layer_stages() {
  for (const bench::Subject& s : bench::edge_subjects()) {
    benchmark::RegisterBenchmark(("whole_layer/" + s.name).c_str(), whole_layer, s);
    benchmark::RegisterBenchmark(("toolpaths/" + s.name).c_str(), toolpaths, s);
    benchmark::RegisterBenchmark(("gcode/" + s.name).c_str(), gcode, s);
  }
}

}  // namespace slipstick
