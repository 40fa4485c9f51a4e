#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/print_control.h"
#include "host/resume_point.h"
#include "host/serve/job_spec.h"
#include "host/serve/printed_layer.h"
#include "host/serve/serial_log.h"
#include "host/serve/store.h"

namespace slipstick {

/// A file to be printed, and where.
struct PrintTask {
  std::string path;
  std::string name;  ///< As users know it.
  bool is_gcode = false;
  JobSpec spec;
  std::string port;
  std::filesystem::path journal;   ///< Where it is kept; of a printer inside this program, none.
  std::optional<Consent> take_up;  ///< The print was cut off: go on with it.
  std::shared_ptr<SettingsTimeline> timeline = nullptr;  ///< Of a model: settings by layer.
  std::shared_ptr<SerialLog> serial_log = nullptr;       ///< Told of all bytes, if there is one.
};

/// How a task tells how far it is, and asks; called by the printing thread.
struct TaskListeners {
  std::function<void(int layers)> on_start;  ///< 0 for G-code.
  std::function<void(PrintedLayer)> on_layer;
  std::function<void(double share)> on_completion;
  std::function<bool(int layer)> pause_before = {};  ///< Of a model: whether to pause there.
};

/// Prints it, from the file to the last acknowledged line. A G-code file is read through before its
/// first line is sent, so that no print ends at a line that no printer could take.
/// \return kInput if it cannot be taken up, or not without consent, as resume_point. Otherwise what
/// was printed, as JSON: lines, resends, and of a simulated printer what it laid down.
[[nodiscard]] Result<std::string> run_print_task(const PrintTask& task, PrintControl& control,
                                                 const TaskListeners& listeners);

}  // namespace slipstick
