#pragma once

#include <map>
#include <string>

#include "core/base/result.h"
#include "sim/printer.h"

namespace slipstick {

struct SimOptions {
  PrinterOptions printer;
  bool realtime = false;  ///< Virtual time is paced to the machine's clock.
};

/// What the options of an address say: `sim:?seed=7&corrupt=0.002&baud=250000&realtime=1&
/// firmware=marlin-2.1.2&fault=lose-ok,reset@line200&kinematics=corexy&jerk=classic`.
///
/// \param machine what the options do not speak of.
/// \return kInput for an option or a value that does not exist, with the ones that do.
[[nodiscard]] Result<SimOptions> sim_options(const std::map<std::string, std::string>& options,
                                             const MachineOptions& machine = {});

}  // namespace slipstick
