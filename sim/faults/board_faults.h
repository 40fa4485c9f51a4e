#pragma once

#include "core/base/rng.h"
#include "sim/faults/byte_faults.h"
#include "sim/firmware.h"
#include "sim/machine.h"

namespace slipstick {

/// The board starts anew, for a reason that it tells or does not.
class Reset final : public Fault {
 public:
  Reset(const FaultWhen& when, ResetCause cause) : Fault(when), cause_(cause) {}

 private:
  void strike(Printer& printer) override;
  [[nodiscard]] bool momentary() const override { return true; }
  ResetCause cause_;
};

/// The firmware stops for good, as after M112.
class Kill final : public Fault {
 public:
  using Fault::Fault;

 private:
  void strike(Printer& printer) override;
  [[nodiscard]] bool momentary() const override { return true; }
};

/// The main loop stands: nothing is read or said, moves under way are made, heaters keep the power
/// that they have.
class Freeze final : public Fault {
 public:
  using Fault::Fault;

 private:
  void strike(Printer& printer) override;
  void relent(Printer& printer) override;
};

/// The cable is out. The board goes on.
class Unplug final : public Fault {
 public:
  using Fault::Fault;

 private:
  void strike(Printer& printer) override;
  void relent(Printer& printer) override;
};

/// Words that are not an answer come from the board, or reach it from another program.
class Words final : public Fault {
 public:
  Words(const FaultWhen& when, WireSide side, std::string words)
      : Fault(when), side_(side), words_(std::move(words)) {}

 private:
  void strike(Printer& printer) override;
  [[nodiscard]] bool momentary() const override { return true; }
  WireSide side_;
  std::string words_;
};

/// Something of a heater is broken.
class BrokenHeater final : public Fault {
 public:
  BrokenHeater(const FaultWhen& when, Heater Machine::*heater, HeaterDefect defect)
      : Fault(when), heater_(heater), defect_(defect) {}

 private:
  void strike(Printer& printer) override;
  void relent(Printer& printer) override;
  Heater Machine::*heater_;
  HeaterDefect defect_;
};

/// The motor turns and no plastic comes: the spool is empty or the nozzle blocked. The board has no
/// sensor for it.
class NoFilament final : public Fault {
 public:
  using Fault::Fault;

 private:
  void strike(Printer& printer) override;
  void relent(Printer& printer) override;
};

}  // namespace slipstick
