// Times each stage: `stages --benchmark_filter=roots`. scripts/compare sets two commits side by
// side.
#include <benchmark/benchmark.h>

#include "host/process_memory.h"
#include "tests/bench/stages/stages.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  slipstick::keep_freed_memory();  // as the program does
  slipstick::register_layer_stages();
  benchmark::RunSpecifiedBenchmarks();
}
