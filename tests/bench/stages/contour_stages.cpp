// Image to outline, stage by stage, on a sheet of gyroid; items are sticks.
#include <benchmark/benchmark.h>

#include "core/contour/audit.h"
#include "core/contour/certify.h"
#include "core/contour/ledger.h"
#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "tests/bench/subjects.h"
#include "tests/support/outlines.h"

namespace slipstick {
namespace {

// What the stages take, made once for each benchmark.
struct Prepared {
  bench::Subject subject = bench::smooth_subjects()[2];
  std::unique_ptr<Section> section = subject.solid->section(subject.z);
  BitImage image = sample(*section, subject.grid).value();
  ContourSet contours = rooted();
  SimplifyOptions options = tenth_of_a_cell();

  [[nodiscard]] ContourSet rooted() const {
    ContourSet result = trace(image, Ambiguity::kSolid);
    place_roots(result, *section);
    return result;
  }
  [[nodiscard]] SimplifyOptions tenth_of_a_cell() const {
    SimplifyOptions result;
    result.tolerance = 0.1 * subject.grid.width();
    return result;
  }
};

template <typename Stage>
void per_stick(benchmark::State& state, const Prepared& prepared, Stage stage) {
  for (auto _ : state) benchmark::DoNotOptimize(stage());
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(prepared.contours.sticks().size()));
}

void image(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p,
            [&] { return sample(*p.subject.solid->section(p.subject.z), p.subject.grid); });
}
BENCHMARK(image);

void tracing(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] { return trace(p.image, Ambiguity::kSolid); });
}
BENCHMARK(tracing);

void roots(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] {
    ContourSet contours = p.contours;
    place_roots(contours, *p.section);
    return contours;
  });
}
BENCHMARK(roots);

void sliding(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] {
    ContourSet contours = p.contours;
    place_sliding(contours);
    return contours;
  });
}
BENCHMARK(sliding);

void fewest(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] { return simplify_fewest(p.contours, p.options); });
}
BENCHMARK(fewest);

void fewest_of_one_candidate(benchmark::State& state) {
  Prepared p;
  p.options.candidates = Candidates::kOne;
  per_stick(state, p, [&] { return simplify_fewest(p.contours, p.options); });
}
BENCHMARK(fewest_of_one_candidate);

void greedy(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] { return simplify_greedy(p.contours, p.options); });
}
BENCHMARK(greedy);

void segmentation(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] { return simplify_vsa(p.contours, p.options); });
}
BENCHMARK(segmentation);

void audit(benchmark::State& state) {
  const Prepared p;
  const auto loops = test::audit_loops_of(simplify_fewest(p.contours, p.options).outline);
  per_stick(state, p,
            [&] { return audit_loops(loops).size() + audit_samples(loops, p.image).size(); });
}
BENCHMARK(audit);

void certificate(benchmark::State& state) {
  const Prepared p;
  const auto field = p.subject.solid->field();
  per_stick(state, p, [&] {
    return certify_layer(*field, p.image, p.subject.z, p.subject.z + 2 * p.subject.grid.width());
  });
}
BENCHMARK(certificate);

void ledger(benchmark::State& state) {
  const Prepared p;
  per_stick(state, p, [&] {
    StackLedger stack(Ambiguity::kSolid);
    stack.add(p.image);
    stack.add(p.image);
    return stack.topology();
  });
}
BENCHMARK(ledger);

}  // namespace
}  // namespace slipstick
