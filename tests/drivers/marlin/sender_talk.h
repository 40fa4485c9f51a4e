#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "drivers/marlin/sender.h"

namespace slipstick {

/// A sender and a printer played by the test.
class Talk {
 public:
  /// Past the greeting: lines 0 to 2 are M110, M115 and M155; the job begins with 3.
  void greet() {
    expects("");
    silence(std::chrono::milliseconds(2500));
    expects("\nN0 M110 N0*125\n");
    says("ok");
    silence(std::chrono::milliseconds(60));
    expects("N1 M115*39\n");
    says("FIRMWARE_NAME:Marlin 2.1.2 SOURCE_CODE_URL:x");
    says("Cap:AUTOREPORT_TEMP:1");
    says("Cap:EMERGENCY_PARSER:1");
    says("ok");
    expects(frame(2, "M155 S2"));
    says("ok");
    expects("");
    (void)sender.take_events();
  }

  void says(std::string_view line) { sender.receive(std::string(line) + "\n", now); }

  void expects(std::string_view bytes) { REQUIRE(sender.take_output(now) == bytes); }

  void silence(Moment time) { now += time; }

  void job(std::string_view text) { sender.push(*Line::make(text)); }

  /// Sends `text` as `number` and has it accepted.
  void prints(LineNumber number, std::string_view text) {
    job(text);
    expects(frame(number, text));
    says("ok");
  }

  /// The job is over: is asked, as `number`, to report no more.
  void falls_silent(LineNumber number) {
    expects(frame(number, "M155 S0"));
    says("ok");
  }

  void refuses(LineNumber last, std::string_view why = "checksum mismatch") {
    says("Error:" + std::string(why) + ", Last Line: " + std::to_string(last));
    says("Resend: " + std::to_string(last + 1));
    says("ok");
  }

  /// Is asked, twice from `number` on, where the nozzle is.
  void is_asked_and_stands_at(LineNumber number, std::string_view position) {
    for (const LineNumber question : {number, number + 1}) {
      silence(std::chrono::milliseconds(60));
      expects(frame(question, "M114"));
      says(std::string(position) + " Count X:0 Y:0 Z:0");
      says("ok");
    }
  }

  /// Numbers from 0, so that they can be read.
  Sender sender{{.first_number = 0, .kept = {}}};
  Moment now{};
};

}  // namespace slipstick
