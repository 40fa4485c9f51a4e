#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "sim/faults/fault.h"

namespace slipstick {

/// A fault that there is, as a user names it: `NAME[=VALUE][@WHEN]`.
///
/// WHEN is `SECONDS` since power on, `FROM-TO`, or `lineN`: when the board has taken N lines. What
/// the value means, and what is taken without one, each name's row in fault_names.h tells.
class FaultSpec {
 public:
  /// \return kInput for a name, value or time that cannot be, with what can.
  [[nodiscard]] static Result<FaultSpec> parse(std::string_view text);

  /// The same fault, its time counted from `now` and its line from `lines`; at once where none is
  /// said.
  [[nodiscard]] FaultSpec from(Moment now, std::int64_t lines) const;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] double number() const { return number_; }
  [[nodiscard]] const std::string& words() const { return words_; }
  [[nodiscard]] const FaultWhen& when() const { return when_; }

 private:
  FaultSpec() = default;

  std::string name_;
  double number_ = 0;
  std::string words_;
  FaultWhen when_;
};

}  // namespace slipstick
