#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/clock.h"
#include "drivers/marlin/framing.h"
#include "drivers/marlin/line_splitter.h"
#include "drivers/marlin/position.h"
#include "drivers/marlin/reply.h"

namespace slipstick {

/// Asks a printer that a print was cut off from where it stands, and changes nothing there.
///
/// A line numbered beyond all that were sent is refused, with the number that the printer took
/// last; M114 tells the place it was sent to. Each answer counts once it came twice. That a number
/// and a place are those of the print is for the owner to see: a board that was reset has taken
/// line 0.
///
/// Pure: bytes and time in, bytes out. Call `take_output` after every other call and at `wakeup`.
class SessionProbe {
 public:
  enum class State : std::uint8_t {
    kAsking,
    kFound,
    kReset,   ///< It says that it has just started.
    kSilent,  ///< It says nothing for `kPatience`, or nothing that answers the questions.
  };
  struct Found {
    LineNumber last = 0;  ///< The last line it has taken; all up to it are executed in their turn.
    Position position;    ///< Where those lead.
  };

  /// How long a board that resets when its port is opened may take to say `start`.
  static constexpr Moment kBannerWait = std::chrono::milliseconds(2500);
  static constexpr Moment kPatience = std::chrono::seconds(60);
  static constexpr int kQuestionsMax = 400;

  /// \param beyond a number that was never reached.
  explicit SessionProbe(LineNumber beyond) : beyond_(beyond) {}

  void receive(std::string_view bytes, Moment now);
  [[nodiscard]] std::string take_output(Moment now);
  [[nodiscard]] Moment wakeup() const { return next_; }

  [[nodiscard]] State state() const { return state_; }
  /// \pre state() is kFound.
  [[nodiscard]] const Found& found() const { return found_; }

 private:
  void hear(const Reply& reply);
  void conclude();

  const LineNumber beyond_;
  LineSplitter splitter_;
  State state_ = State::kAsking;
  Found found_;
  std::optional<LineNumber> requested_;  ///< In the answer to the last question, and
  std::optional<LineNumber> last_line_;
  std::optional<Position> position_;
  std::optional<LineNumber> last_;  ///< once in the one before.
  std::optional<Position> place_;
  bool counted_ = false;  ///< The number is known.
  bool begun_ = false;
  int questions_ = 0;
  Moment next_{};
  Moment last_heard_{};
};

}  // namespace slipstick
