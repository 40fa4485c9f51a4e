// Prints the table of targets: what, how much was wanted, how much was measured. `scripts/targets`
// builds and runs it. Names of groups may follow: only those are measured.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "host/process_memory.h"
#include "tests/bench/targets/targets.h"

using namespace slipstick::targets;

int main(int argc, char** argv) {
  using Group = std::pair<std::string_view, std::vector<Row> (*)()>;
  constexpr std::array<Group, 12> kGroups{{{"memory", memory_rows},
                                           {"layer", layer_rows},
                                           {"image", image_rows},
                                           {"scaling", scaling_rows},
                                           {"edges", edge_rows},
                                           {"errors", error_rows},
                                           {"placements", placement_rows},
                                           {"certificates", certificate_rows},
                                           {"fit", fit_rows},
                                           {"simulation", simulation_rows},
                                           {"sender", sender_rows},
                                           {"daemon", daemon_rows}}};
  for (int i = 1; i < argc; ++i) {
    const auto named = [&](const Group& group) { return group.first == argv[i]; };
    if (std::any_of(kGroups.begin(), kGroups.end(), named)) continue;
    fmt::print(stderr,
               "targets: no group '{}' (memory, layer, image, scaling, edges, errors, placements, "
               "certificates, fit, simulation, sender, daemon)\n",
               argv[i]);
    return 2;
  }
  slipstick::keep_freed_memory();  // as the program does
  std::vector<Row> rows;
  for (const auto& [name, group] : kGroups) {
    if (argc > 1 && std::find(argv + 1, argv + argc, name) == argv + argc) continue;
    for (Row& row : group()) rows.push_back(std::move(row));
    fmt::print(stderr, "{} rows\n", rows.size());
  }
  print(rows);
}
