#pragma once

#include <string>

namespace slipstick {

/// Which printer there is: what `--printer` and `--machine` say, or what was chosen on the page.
struct PrinterChoice {
  std::string port;     ///< As transport_address.h reads it.
  std::string machine;  ///< Name of a file in `configs/printers`.
  friend bool operator==(const PrinterChoice&, const PrinterChoice&) = default;
};

}  // namespace slipstick
