// Prints the table of targets: what, how much was wanted, how much was measured. `scripts/targets`
// builds and runs it.
#include <fmt/format.h>

#include "tests/bench/targets/targets.h"

using namespace slipstick::targets;

int main() {
  std::vector<Row> rows;
  for (const auto group :
       {memory_rows, layer_rows, image_rows, scaling_rows, edge_rows, error_rows}) {
    for (Row& row : group()) rows.push_back(std::move(row));
    fmt::print(stderr, "{} rows\n", rows.size());
  }
  print(rows);
}
