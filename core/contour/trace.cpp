#include "core/contour/trace.h"

#include <bit>
#include <optional>

namespace slipstick {
namespace {

Outward turned(Outward outward, int quarters) {
  return static_cast<Outward>((static_cast<int>(outward) + quarters) % 4);
}

Stick stick_at(int column, int row, Outward outward) {
  return {static_cast<std::int16_t>(column), static_cast<std::int16_t>(row), outward};
}

// The two samples ahead of a stick when the inside node is on the left.
struct Ahead {
  bool left;
  bool right;
};

Ahead ahead(const BitImage& image, Stick s) {
  const Step e = step(s.outward), m = step(turned(s.outward, 1));
  return {image.at(s.column + m.x, s.row + m.y), image.at(s.column + e.x + m.x, s.row + e.y + m.y)};
}

Stick turn_left(Stick s) {
  return stick_at(s.column, s.row, turned(s.outward, 1));
}

Stick go_straight(Stick s) {
  const Step m = step(turned(s.outward, 1));
  return stick_at(s.column + m.x, s.row + m.y, s.outward);
}

Stick turn_right(Stick s) {
  const Step e = step(s.outward), m = step(turned(s.outward, 1));
  return stick_at(s.column + e.x + m.x, s.row + e.y + m.y, turned(s.outward, 3));
}

Stick next(Stick s, Ahead samples, Ambiguity ambiguity) {
  if (samples.left && samples.right) return turn_right(s);
  if (samples.left) return go_straight(s);
  if (samples.right && ambiguity == Ambiguity::kSolid) return turn_right(s);
  return turn_left(s);
}

// The column left of a horizontal stick, or nothing for a vertical one.
std::optional<int> left_column(Stick s) {
  if (s.outward == Outward::kEast) return s.column;
  if (s.outward == Outward::kWest) return s.column - 1;
  return {};
}

}  // namespace

/// Scans rows upwards; where it meets a horizontal stick that no loop has yet, it follows that
/// loop. Nesting comes from the loop met just before on the row, as in Suzuki and Abe's border
/// following (1985).
class Tracer {
 public:
  Tracer(const BitImage& image, Ambiguity ambiguity)
      : image_(image),
        ambiguity_(ambiguity),
        contours_(image.grid()),
        met_later_(static_cast<std::size_t>(image.rows())),
        loop_of_column_(static_cast<std::size_t>(image.columns()), kNone) {}

  ContourSet run() {
    for (int row = 0; row < image_.rows(); ++row) scan(row);
    contours_.places_.resize(contours_.sticks_.size());
    // Both passes through an ambiguous square meet two outside or two inside samples crosswise.
    contours_.ambiguous_squares_ = ambiguous_steps_ / 2;
    return std::move(contours_);
  }

 private:
  static constexpr int kNone = -1;

  struct Met {
    int column;
    int loop;
  };

  void scan(int row) {
    row_ = row;
    auto& met = met_later_[static_cast<std::size_t>(row)];
    for (const Met& m : met) loop_at(m.column) = m.loop;
    here_.clear();
    int last = kNone;
    for_each_horizontal_stick(row, [&](int column) {
      int& loop = loop_at(column);
      if (loop == kNone) follow(start(column), last);
      last = loop;
    });
    for (const Met& m : met) loop_at(m.column) = kNone;
    for (const Met& m : here_) loop_at(m.column) = kNone;
    met = {};
  }

  template <typename Visit>
  void for_each_horizontal_stick(int row, Visit visit) {
    const auto words = image_.row(row);
    std::uint64_t before = 0;  // the last sample of the word before, in bit 0
    for (std::size_t w = 0; w < words.size(); ++w) {
      std::uint64_t changes = words[w] ^ (words[w] << 1 | before);
      before = words[w] >> 63;
      for (; changes != 0; changes &= changes - 1) {
        visit(static_cast<int>(w) * BitImage::kBitsPerWord + std::countr_zero(changes) - 1);
      }
    }
  }

  // The stick between `column` and the next.
  Stick start(int column) const {
    return image_.at(column, row_) ? stick_at(column, row_, Outward::kEast)
                                   : stick_at(column + 1, row_, Outward::kWest);
  }

  void follow(const Stick first, int last) {
    const int number = static_cast<int>(contours_.loops_.size());
    const std::size_t begin = contours_.sticks_.size();
    Stick stick = first;
    do {
      contours_.sticks_.push_back(stick);
      if (const auto column = left_column(stick)) remember({*column, number}, stick.row);
      const Ahead samples = ahead(image_, stick);
      if (!samples.left && samples.right) ++ambiguous_steps_;
      stick = next(stick, samples, ambiguity_);
    } while (!(stick == first));
    contours_.loops_.push_back({begin, contours_.sticks_.size() - begin, depth(first, last)});
  }

  void remember(Met met, int row) {
    SLIPSTICK_DCHECK(row >= row_);
    if (row > row_) return met_later_[static_cast<std::size_t>(row)].push_back(met);
    loop_at(met.column) = met.loop;
    here_.push_back(met);
  }

  // The loop `last` borders the region in which the new loop begins.
  int depth(Stick first, int last) const {
    if (last == kNone) return 0;
    const bool is_hole = first.outward == Outward::kEast;
    const int beside = contours_.loops_[static_cast<std::size_t>(last)].depth;
    return (beside % 2 == 1) == is_hole ? beside : beside + 1;
  }

  // Column -1 never is a stick: the border is outside.
  int& loop_at(int column) { return loop_of_column_[static_cast<std::size_t>(column)]; }

  const BitImage& image_;
  const Ambiguity ambiguity_;
  ContourSet contours_;
  std::vector<std::vector<Met>> met_later_;  // by row, for rows above the one being scanned
  std::vector<int> loop_of_column_;          // of the row being scanned
  std::vector<Met> here_;                    // what loops found on this row put into it
  int row_ = 0;
  std::int64_t ambiguous_steps_ = 0;
};

ContourSet trace(const BitImage& image, Ambiguity ambiguity) {
  return Tracer(image, ambiguity).run();
}

}  // namespace slipstick
