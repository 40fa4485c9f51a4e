#pragma once

#include "sim/faults/fault.h"

namespace slipstick {

/// The host hears nothing of what the board says.
class Mute final : public Fault {
 public:
  using Fault::Fault;
  [[nodiscard]] std::string to_host(std::string text, Moment now) override {
    return active(now) ? std::string() : text;
  }

 private:
  void strike(Printer&) override { harm(); }
};

/// The board hears nothing of what the host says.
class Deaf final : public Fault {
 public:
  using Fault::Fault;
  [[nodiscard]] std::string to_board(std::string bytes, Moment now) override {
    return active(now) ? std::string() : bytes;
  }

 private:
  void strike(Printer&) override { harm(); }
};

/// What the board says comes late.
class Late final : public Fault {
 public:
  Late(const FaultWhen& when, Moment by) : Fault(when), by_(by) {}
  [[nodiscard]] Moment delay(Moment now) const override { return active(now) ? by_ : Moment(0); }

 private:
  void strike(Printer&) override { harm(); }
  Moment by_;
};

}  // namespace slipstick
