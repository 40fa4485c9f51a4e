#include "core/contour/certify.h"

#include <algorithm>
#include <bit>

#include "core/contour/certify_column.h"
#include "core/contour/certify_curve.h"
#include "core/contour/certify_events.h"

namespace slipstick {
namespace {

// Blocks up to this size are a step as a whole where the solid only begins or only ends: flat faces
// need not be looked at square by square.
constexpr int kStepBlock = 4;

// Shorter expressions pay above this size.
constexpr int kNarrowBlock = 4;

std::int64_t squares_passed(const BitImage& image) {
  using Word = std::uint64_t;
  std::int64_t sum = 0;
  for (int row = 1; row < image.rows(); ++row) {
    const auto lower = image.row(row - 1), upper = image.row(row);
    Word any_before = 0, all_before = 0;
    for (std::size_t w = 0; w < lower.size(); ++w) {
      const Word any = lower[w] | upper[w], all = lower[w] & upper[w];
      const Word some = any | any << 1 | any_before;
      const Word every = all & (all << 1 | all_before);
      sum += std::popcount(some & ~every);
      any_before = any >> (BitImage::kBitsPerWord - 1);
      all_before = all >> (BitImage::kBitsPerWord - 1);
    }
  }
  return sum;
}

// A square of squares of the lattice, by its lower left node.
struct Block {
  int column = 0;
  int row = 0;
  int size = 0;
};

class Certifier {
 public:
  enum class Look : std::uint8_t { kCurveAndSlab, kSlab };

  Certifier(const SliceGrid& grid, double z, double above, Look at,
            std::int64_t boxes_max = kCertifyBoxesMax)
      : grid_(grid),
        z_(z),
        above_(above),
        curve_(at == Look::kCurveAndSlab),
        boxes_max_(boxes_max) {}

  LayerCertificate run(Field& field) {
    const auto across = static_cast<unsigned>(std::max(grid_.columns(), grid_.rows()) - 1);
    look(field, {0, 0, static_cast<int>(std::bit_ceil(across))}, true);
    result_.events = merged(std::move(hidden_), SlabEvent::Kind::kHidden, grid_);
    const auto steps = merged(std::move(steps_), SlabEvent::Kind::kStep, grid_);
    result_.events.insert(result_.events.end(), steps.begin(), steps.end());
    return std::move(result_);
  }

 private:
  [[nodiscard]] Block clipped(const Block& b) const {
    const int right = std::min(b.column + b.size, grid_.columns() - 1);
    const int top = std::min(b.row + b.size, grid_.rows() - 1);
    return {right, top, 0};
  }

  [[nodiscard]] Box3 box_of(const Block& b, double top) const {
    const Block end = clipped(b);
    return {{grid_.node_x(b.column), grid_.node_y(b.row), z_},
            {grid_.node_x(end.column), grid_.node_y(end.row), top}};
  }

  // `open`: the slab above the block is still to be looked at, not only its squares.
  void look(Field& field, const Block& b, bool open) {
    if (b.column >= grid_.columns() - 1 || b.row >= grid_.rows() - 1) return;
    if (++boxes_ > boxes_max_) {
      result_.complete = false;
      return;
    }
    const GradientRange range = field.over(box_of(b, open ? above_ : z_));
    if (range.no_surface() || range.x.never_zero() || range.y.never_zero()) return;
    if (b.size == 1) return judge_square(field, b, range, open);
    if (open) open = !settled(b, range);
    if (!open && !curve_) return;
    const auto narrowed =
        b.size > kNarrowBlock ? field.narrowed(box_of(b, open ? above_ : z_)) : nullptr;
    Field& inner = narrowed ? *narrowed : field;
    const int half = b.size / 2;
    for (int part = 0; part < 4; ++part) {
      look(inner, {b.column + (part & 1) * half, b.row + (part >> 1) * half, half}, open);
    }
  }

  // Whether the slab above the block is known as a whole.
  bool settled(const Block& b, const GradientRange& range) {
    if (no_critical_point(range)) return true;
    const bool begins = range.z.low < 0 && range.z.high<0, ends = range.z.low> 0;
    if (b.size > kStepBlock || !(begins || ends)) return false;
    const Block end = clipped(b);
    for (int row = b.row; row < end.row; ++row) {
      for (int column = b.column; column < end.column; ++column) {
        steps_.push_back({column, row, z_, above_});
      }
    }
    return true;
  }

  void judge_square(Field& field, const Block& b, const GradientRange& range, bool open) {
    if (curve_) look_at_curve(field, b);
    if (!open || no_critical_point(range)) return;
    const ColumnVerdict verdict = judge_column(field, box_of(b, above_));
    boxes_ += verdict.boxes;
    if (!verdict.event) return;
    auto& squares = *verdict.event == SlabEvent::Kind::kHidden ? hidden_ : steps_;
    squares.push_back({b.column, b.row, verdict.low, verdict.high});
  }

  void look_at_curve(Field& field, const Block& b) {
    const CurveVerdict verdict = judge_curve(field, box_of(b, z_));
    boxes_ += verdict.boxes;
    if (verdict.certified) return;
    ++result_.uncertified;
    if (result_.uncertified_at.size() >= kPlacesMax) return;
    const Vec3 c = box_of(b, z_).centre();
    result_.uncertified_at.push_back({c.x, c.y});
  }

  const SliceGrid grid_;
  const double z_;
  const double above_;
  const bool curve_;
  const std::int64_t boxes_max_;
  std::int64_t boxes_ = 0;
  std::vector<EventSquare> hidden_;
  std::vector<EventSquare> steps_;
  LayerCertificate result_;
};

}  // namespace

std::int64_t LayerCertificate::hidden() const {
  return std::count_if(events.begin(), events.end(),
                       [](const SlabEvent& e) { return e.kind == SlabEvent::Kind::kHidden; });
}

LayerCertificate& LayerCertificate::operator+=(const LayerCertificate& other) {
  cells += other.cells;
  uncertified += other.uncertified;
  for (const Vec2 p : other.uncertified_at) {
    if (uncertified_at.size() < kPlacesMax) uncertified_at.push_back(p);
  }
  events.insert(events.end(), other.events.begin(), other.events.end());
  complete = complete && other.complete;
  return *this;
}

LayerCertificate certify_layer(Field& field, const BitImage& image, double z, double above,
                               CertifyEffort effort) {
  const std::int64_t squares = squares_passed(image);
  const std::int64_t boxes_max =
      effort == CertifyEffort::kThorough
          ? kCertifyBoxesMax
          : std::min(kCertifyBoxesMax, kQuickBoxesMin + kQuickBoxesPerSquare * squares);
  LayerCertificate result =
      Certifier(image.grid(), z, above, Certifier::Look::kCurveAndSlab, boxes_max).run(field);
  result.cells = squares;
  return result;
}

LayerCertificate certify_slab(Field& field, const SliceGrid& grid, double z, double above) {
  return Certifier(grid, z, above, Certifier::Look::kSlab).run(field);
}

}  // namespace slipstick
