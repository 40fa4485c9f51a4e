#include "core/contour/ledger.h"

#include "core/contour/ledger_euler.h"

#include <limits>

namespace slipstick {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

Touch solid_touch(Ambiguity ambiguity) {
  return ambiguity == Ambiguity::kSolid ? Touch::kCorners : Touch::kFaces;
}

Touch void_touch(Ambiguity ambiguity) {
  return ambiguity == Ambiguity::kSolid ? Touch::kFaces : Touch::kCorners;
}

}  // namespace

StackLedger::StackLedger(Ambiguity ambiguity)
    : touch_(solid_touch(ambiguity)),
      solid_(RunImage::Of::kInside, touch_),
      void_(RunImage::Of::kOutside, void_touch(ambiguity)) {}

void StackLedger::add(const BitImage& image) {
  // Below the print all is void.
  if (!below_) void_.add(BitImage(image.grid()));
  solid_.add(image);
  void_.add(image);
  euler_ += euler_number(image, touch_);
  if (below_) euler_ -= euler_number_in_common(*below_, image, touch_);
  below_ = image;
}

Topology StackLedger::topology() const {
  if (!below_) return {};
  Phase around = void_;
  around.add(BitImage(below_->grid()));
  Topology t;
  t.components = solid_.complete() + solid_.open();
  t.cavities = around.complete() + around.open() - 1;
  t.tunnels = t.components + t.cavities - euler_;
  return t;
}

void StackLedger::Phase::join_within(const RunImage& runs, DisjointSets& sets) const {
  const auto join = [&](std::size_t i, std::size_t j) { sets.join(open_ + i, open_ + j); };
  for (int row = 1; row < runs.rows(); ++row)
    each_touching({runs, row}, {runs, row - 1}, touch_, join);
}

void StackLedger::Phase::join_below(const RunImage& runs, DisjointSets& sets) const {
  if (!below_) return;
  const auto join = [&](std::size_t i, std::size_t j) { sets.join(open_ + i, component_[j]); };
  const int reach = touch_ == Touch::kCorners ? 1 : 0;
  for (int row = 0; row < runs.rows(); ++row) {
    for (int other = row - reach; other <= row + reach; ++other) {
      each_touching({runs, row}, {*below_, other}, touch_, join);
    }
  }
}

void StackLedger::Phase::add(const BitImage& image) {
  RunImage runs(image, what_);
  DisjointSets sets(open_ + runs.size());  // the components below, then the runs of this layer
  join_within(runs, sets);
  join_below(runs, sets);
  std::vector<std::size_t> number(open_ + runs.size(), kNone);
  std::vector<std::size_t> component(runs.size());
  std::size_t open = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::size_t& n = number[sets.find(open_ + i)];
    if (n == kNone) n = open++;
    component[i] = n;
  }
  for (std::size_t c = 0; c < open_; ++c) {
    // Joined below only: each set once, by the number that stands for it.
    if (sets.find(c) == c && number[c] == kNone) ++complete_;
  }
  below_ = std::move(runs);
  component_ = std::move(component);
  open_ = open;
}

}  // namespace slipstick
