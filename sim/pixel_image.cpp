#include "sim/pixel_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "sim/pixel_runs.h"

namespace slipstick {

namespace {

constexpr int kWordBits = 64;
constexpr double kDiagonal = 1.4143;  // of a pixel of side 1, rounded up

int clamped_ceil(double value, int high) {
  return static_cast<int>(std::ceil(std::clamp(value, 0.0, static_cast<double>(high))));
}

/// A closed interval that begins empty.
struct Interval {
  double low = 1;
  double high = 0;

  [[nodiscard]] bool empty() const { return low > high; }
  void unite(double a, double b) {
    const bool was_empty = empty();
    low = was_empty ? a : std::min(low, a);
    high = was_empty ? b : std::max(high, b);
  }
  /// Keeps x with |slope·x + offset| <= bound.
  void keep(double slope, double offset, double bound) {
    if (slope == 0) {
      if (std::abs(offset) > bound) *this = {};
      return;
    }
    const double a = (-bound - offset) / slope;
    const double b = (bound - offset) / slope;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
};

/// The part of the line at height `y` that is within `radius` of the segment. The capsule is
/// convex, so that its two discs and the band between them make one interval.
Interval capsule_at(double y, Vec2 a, Vec2 b, double radius) {
  Interval part;
  for (const Vec2 centre : {a, b}) {
    const double h2 = radius * radius - (y - centre.y) * (y - centre.y);
    if (h2 >= 0) part.unite(centre.x - std::sqrt(h2), centre.x + std::sqrt(h2));
  }
  const Vec2 d = b - a;
  const double d2 = dot(d, d);
  if (d2 <= 0) return part;
  Interval band{std::min(a.x, b.x) - radius, std::max(a.x, b.x) + radius};
  const Vec2 middle = 0.5 * (a + b);
  const double dy = y - middle.y;
  band.keep(d.x, d.y * dy - d.x * middle.x, d2 / 2);  // Between the ends,
  band.keep(-d.y, d.x * dy + d.y * middle.x,
            radius * std::sqrt(d2));  // and no farther to the side.
  if (!band.empty()) part.unite(band.low, band.high);
  return part;
}

}  // namespace

PixelFrame PixelFrame::over(const Box2& area, double size) {
  SLIPSTICK_CHECK(size > 0);
  if (area.empty()) return {{}, size, 1, 1, 0, 0};
  constexpr std::int64_t kMost = 1 << 15;
  const auto first = [&](double from) {
    return static_cast<std::int64_t>(std::floor(from / size)) - 1;
  };
  const auto count = [&](double to, std::int64_t begin) {
    const auto end = static_cast<std::int64_t>(std::ceil(to / size)) + 1;
    return static_cast<int>(std::min(kMost, end - begin));
  };
  PixelFrame frame;
  frame.size = size;
  frame.first_column = first(area.low.x);
  frame.first_row = first(area.low.y);
  frame.low = {static_cast<double>(frame.first_column) * size,
               static_cast<double>(frame.first_row) * size};
  frame.columns = count(area.high.x, frame.first_column);
  frame.rows = count(area.high.y, frame.first_row);
  return frame;
}

int PixelFrame::column_from(double x) const {
  return clamped_ceil((x - low.x) / size - 0.5, columns);
}

int PixelFrame::row_from(double y) const {
  return clamped_ceil((y - low.y) / size - 0.5, rows);
}

PixelImage::PixelImage(const PixelFrame& frame)
    : frame_(frame),
      words_per_row_(static_cast<std::size_t>((frame.columns + kWordBits - 1) / kWordBits)),
      words_(words_per_row_ * static_cast<std::size_t>(frame.rows)) {}

std::int64_t PixelImage::count() const {
  std::int64_t n = 0;
  for (const std::uint64_t word : words_) n += std::popcount(word);
  return n;
}

bool PixelImage::at(int r, int column) const {
  if (r < 0 || column < 0 || r >= frame_.rows || column >= frame_.columns) return false;
  const std::uint64_t word = row(r)[static_cast<std::size_t>(column / kWordBits)];
  return ((word >> (column % kWordBits)) & 1u) != 0;
}

template <typename Apply>
void PixelImage::for_words(int row, int begin, int end, Apply apply) {
  if (begin >= end) return;
  std::uint64_t* words = words_.data() + static_cast<std::size_t>(row) * words_per_row_;
  const int first = begin / kWordBits;
  const int last = (end - 1) / kWordBits;
  for (int w = first; w <= last; ++w) {
    std::uint64_t mask = ~std::uint64_t{0};
    if (w == first) mask &= ~std::uint64_t{0} << (begin % kWordBits);
    if (w == last) mask &= ~std::uint64_t{0} >> (kWordBits - 1 - (end - 1) % kWordBits);
    apply(words[w], mask);
  }
}

void PixelImage::set(int row, int begin, int end) {
  for_words(row, begin, end, [](std::uint64_t& word, std::uint64_t mask) { word |= mask; });
}

void PixelImage::clear(int row, int begin, int end) {
  for_words(row, begin, end, [](std::uint64_t& word, std::uint64_t mask) { word &= ~mask; });
}

void PixelImage::draw_capsule(Vec2 a, Vec2 b, double width) {
  const double radius = std::max(width, frame_.size * kDiagonal) / 2;
  const int last = frame_.row_from(std::max(a.y, b.y) + radius);
  for (int r = frame_.row_from(std::min(a.y, b.y) - radius); r < std::min(last + 1, frame_.rows);
       ++r) {
    const Interval part = capsule_at(frame_.centre_y(r), a, b, radius);
    if (part.empty()) continue;
    const int end = static_cast<int>(std::floor(
        std::clamp((part.high - frame_.low.x) / frame_.size + 0.5, 0.0, 1.0 * frame_.columns)));
    set(r, frame_.column_from(part.low), end);
  }
}

PixelImage PixelImage::grown() const {
  PixelImage result = *this;
  for (int r = 0; r < frame_.rows; ++r) {
    std::uint64_t before = 0;
    for (std::size_t w = 0; w < words_per_row_; ++w) {
      const std::uint64_t word = row(r)[w];
      const std::uint64_t after = w + 1 < words_per_row_ ? row(r)[w + 1] : 0;
      const std::uint64_t wide = word | word << 1 | word >> 1 | before >> 63 | after << 63;
      before = word;
      for (int to = std::max(r - 1, 0); to <= std::min(r + 1, frame_.rows - 1); ++to) {
        result.words_[static_cast<std::size_t>(to) * words_per_row_ + w] |= wide;
      }
    }
  }
  return result;
}

PixelImage PixelImage::inverted() const {
  PixelImage result(frame_);
  for (int r = 0; r < frame_.rows; ++r) result.set(r, 0, frame_.columns);
  return result -= *this;
}

PixelImage PixelImage::shrunk() const {
  PixelImage result = inverted().grown().inverted();
  for (const int r : {0, frame_.rows - 1}) result.clear(r, 0, frame_.columns);
  for (int r = 0; r < frame_.rows; ++r) {
    result.clear(r, 0, 1);
    result.clear(r, frame_.columns - 1, frame_.columns);
  }
  return result;
}

PixelImage PixelImage::within(const PixelFrame& frame) const {
  SLIPSTICK_CHECK(frame.size == frame_.size);
  PixelImage result(frame);
  const auto place = [](std::int64_t i, int count) {
    return static_cast<int>(std::clamp<std::int64_t>(i, 0, count));
  };
  for (int r = 0; r < frame_.rows; ++r) {
    const std::int64_t to = r + frame_.first_row - frame.first_row;
    if (to < 0 || to >= frame.rows) continue;
    for_set_runs(row(r), frame_.columns, [&](int begin, int end) {
      const std::int64_t shift = frame_.first_column - frame.first_column;
      result.set(static_cast<int>(to), place(begin + shift, frame.columns),
                 place(end + shift, frame.columns));
    });
  }
  return result;
}

PixelImage& PixelImage::operator-=(const PixelImage& other) {
  SLIPSTICK_CHECK(words_.size() == other.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
  return *this;
}

PixelImage& PixelImage::operator|=(const PixelImage& other) {
  SLIPSTICK_CHECK(words_.size() == other.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  return *this;
}

std::int64_t PixelImage::count_without(const PixelImage& other) const {
  SLIPSTICK_CHECK(words_.size() == other.words_.size());
  std::int64_t n = 0;
  for (std::size_t i = 0; i < words_.size(); ++i) n += std::popcount(words_[i] & ~other.words_[i]);
  return n;
}

}  // namespace slipstick
