#pragma once

#include <filesystem>
#include <vector>

#include "core/image/grid.h"
#include "core/job/placement.h"
#include "core/job/settings.h"
#include "sim/gcode_player.h"
#include "sim/print_judge.h"

namespace slipstick {

/// What a program does on the machine, and what is wrong with the thing that it prints.
struct GcodeVerdict {
  PrintVerdict print;
  Topology printed;  ///< Infill's cells taken as solid.
  Topology wanted;   ///< Of the model's sections at the same heights and pixels.
  double top_missing =
      0;               ///< mm of the model above the last layer, if that is more than one layer.
  double seconds = 0;  ///< From power on until the machine stands.
  std::int64_t moves = 0;
  std::int64_t travels = 0;      ///< Moves across the bed that push no filament.
  std::int64_t retractions = 0;  ///< Moves that pull filament back.
  double filament_mm = 0;
  std::int64_t refused = 0;  ///< Lines that the machine did not do as they say.
  std::vector<Refusal> refusals;

  [[nodiscard]] bool right() const { return print.wrong() == 0 && top_missing == 0; }
};

/// Who sees what while a program is judged; what is empty sees nothing.
struct GcodeWatch {
  PrintJudge::Watcher layers;
  GcodePlayer::Watcher machine;
  Planner::Sink moves;
};

/// Prints the program in `path` on the simulated machine and judges each layer by the section of
/// `placed` half way up in it. Any slicer's program will do that lays the model where `placed` is.
/// Reads line by line; keeps two layers. The same numbers, bit for bit, each time.
/// \return kInput if the file cannot be read or holds nothing that prints, or if the model is
/// undefined somewhere or too large for the sampling.
[[nodiscard]] Result<GcodeVerdict> judge_gcode(const std::filesystem::path& path,
                                               const PlacedSolid& placed,
                                               const PrintSettings& settings,
                                               const GcodeWatch& watch = {});

}  // namespace slipstick
