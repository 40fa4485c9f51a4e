#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "drivers/marlin/temperatures.h"
#include "host/serve/printed_layer.h"

namespace slipstick {

enum class PrinterActivity : std::uint8_t { kIdle, kPrinting, kPaused, kEnding, kStopped };
/// "idle", "printing", "paused", "ending" (a print was asked to end and does), "stopped" (after an
/// emergency stop, a fault or a lost printer: somebody must look at it).
[[nodiscard]] std::string_view name_of(PrinterActivity activity);

/// What the printer is doing, at one moment.
struct PrinterStatus {
  PrinterActivity activity = PrinterActivity::kIdle;
  std::string message;   ///< Why it stopped, or what it last said.
  std::string firmware;  ///< Of the last connection.
  std::optional<Temperatures> temperatures;
  std::int64_t job = 0;  ///< Under way, or 0.
  std::string file;
  std::int64_t lines = 0;  ///< Acknowledged.
  std::int64_t lines_sent = 0;
  std::int64_t resends = 0;
  double starved_seconds = 0;  ///< The printer wanted a line and there was none.
  double turnaround_half = 0;  ///< Seconds from what was read to what was sent for it: half within.
  double turnaround_99 = 0;    ///< 99 of 100 within.
  int layer = 0;               ///< Layers handed to the sender.
  int layers = 0;              ///< Of the job, or 0: a G-code file has none.
  double height = 0;           ///< mm: top of that layer.
  double completion = 0;       ///< 0 to 1: of the layers, or of the bytes of a file.
  double seconds = 0;          ///< Since the job began.
  std::optional<double> seconds_left;  ///< Where it can be told.
  bool bed_occupied = false;
  bool connected = false;  ///< Somebody talks with it, in a print or between prints.
};

[[nodiscard]] nlohmann::ordered_json to_json(const PrinterStatus& status);
[[nodiscard]] nlohmann::ordered_json to_json(const Temperatures& temperatures);

/// The status, for whoever asks. Threads: any.
class StatusBoard {
 public:
  [[nodiscard]] PrinterStatus get() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }
  void put(const PrinterStatus& status) {
    const std::lock_guard lock(mutex_);
    status_ = status;
  }
  /// What is being printed; null between prints, and of a G-code file.
  [[nodiscard]] std::shared_ptr<const PrintedLayer> layer() const {
    const std::lock_guard lock(mutex_);
    return layer_;
  }
  void put_layer(std::shared_ptr<const PrintedLayer> layer) {
    const std::lock_guard lock(mutex_);
    layer_.swap(layer);
  }

 private:
  mutable std::mutex mutex_;  ///< Protects what follows.
  PrinterStatus status_;
  std::shared_ptr<const PrintedLayer> layer_;
};

}  // namespace slipstick
