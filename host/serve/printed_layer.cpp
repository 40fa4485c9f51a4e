#include "host/serve/printed_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/base/vec.h"
#include "core/gcode/parse.h"

namespace slipstick {
namespace {

bool is_comment(std::string_view line) {
  return line.starts_with(';');
}

/// Follows the nozzle through the lines of a layer, and writes down where it lays plastic.
class Paths {
 public:
  /// False once there is no room for more.
  bool add(std::string_view text, std::int64_t line) {
    const auto command = parse_gcode(text);
    const bool moves = command && (command->is('G', 0) || command->is('G', 1));
    if (!moves || !(command->has('X') || command->has('Y'))) {
      end();
      return true;
    }
    const Vec2 from = at_;
    at_ = {command->value('X').value_or(at_.x), command->value('Y').value_or(at_.y)};
    const bool lays = command->value('E').value_or(0) > 0;
    if (!lays) {
      end();
      return true;
    }
    if (points_ >= PrintedLayer::kPointsMax) return false;
    if (!open_) begin(from, line);
    point(at_);
    return true;
  }

  [[nodiscard]] std::string take() {
    end();
    return std::move(text_);
  }

 private:
  void begin(Vec2 from, std::int64_t line) {
    fmt::format_to(std::back_inserter(text_), R"({}{{"line":{},"points":[)",
                   text_.empty() ? "" : ",", line);
    open_ = true;
    fmt::format_to(std::back_inserter(text_), "[{:.2f},{:.2f}]", from.x, from.y);
    ++points_;
  }
  void point(Vec2 p) {
    fmt::format_to(std::back_inserter(text_), ",[{:.2f},{:.2f}]", p.x, p.y);
    ++points_;
  }
  void end() {
    if (open_) text_ += "]}";
    open_ = false;
  }

  std::string text_;
  Vec2 at_;
  bool open_ = false;
  int points_ = 0;
};

// Calls `act(line)` for each line of `program` that is no comment, while it says so.
template <typename Act>
void for_each_line(std::string_view program, Act act) {
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string_view line = program.substr(0, end);
    program.remove_prefix(std::min(end + 1, program.size()));
    if (!line.empty() && !is_comment(line) && !act(line)) return;
  }
}

}  // namespace

std::int64_t lines_of_layer(const std::string& program) {
  std::int64_t lines = 0;
  for_each_line(program, [&](std::string_view) { return ++lines > 0; });
  return lines;
}

double share_done(const PrintedLayer& layer, std::int64_t lines) {
  if (layer.lines == 0) return 0;
  return std::clamp(double(lines - layer.lines_before) / double(layer.lines), 0.0, 1.0);
}

std::string to_json_text(const PrintedLayer& layer) {
  Paths paths;
  bool complete = true;
  std::int64_t line = 0;
  for_each_line(layer.program, [&](std::string_view text) {
    complete = paths.add(text, line++);
    return complete;
  });
  return fmt::format(
      R"({{"layer":{},"height":{:.3f},"lines_before":{},"lines":{},"complete":{},"paths":[{}]}})",
      layer.layer, layer.height, layer.lines_before, layer.lines, complete, paths.take());
}

}  // namespace slipstick
