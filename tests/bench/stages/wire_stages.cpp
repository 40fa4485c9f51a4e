// The line protocol without a port: items are lines.
#include <benchmark/benchmark.h>

#include "drivers/marlin/line.h"
#include "drivers/marlin/reply.h"
#include "drivers/marlin/sender.h"

namespace slipstick {
namespace {

constexpr std::string_view kMove = "G1 X101.234 Y87.655 E0.03412 F2700 ; perimeter";

void normalising(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(normalise(kMove));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(normalising);

void parsing_replies(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(parse_reply("ok T:204.9 /205.0 B:59.9 /60.0 @:64 B@:21"));
    benchmark::DoNotOptimize(parse_reply("ok"));
  }
  state.SetItemsProcessed(2 * state.iterations());
}
BENCHMARK(parsing_replies);

}  // namespace
}  // namespace slipstick
