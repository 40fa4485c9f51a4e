#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/judge.h"

namespace slipstick {

/// The finding on a print so far.
struct PrintVerdict {
  int layers = 0;            ///< Judged.
  int layers_unknown = 0;    ///< Printed where there are no contours to judge by.
  int components_wrong = 0;  ///< Sums over the layers judged.
  int holes_wrong = 0;
  double area_error_max = 0;   ///< Of one layer.
  double area_error_mean = 0;  ///< Over the layers judged.
  double stray_mm2 = 0;
  std::vector<double>
      wrong_at;  ///< mm: the tops of the first wrong layers, `kWrongListed` at most.
};

/// Judges a print layer by layer while it is made; keeps the beads of one layer.
class PrintJudge {
 public:
  static constexpr std::size_t kWrongListed = 20;

  /// The contours of the layer whose top is at `z` and which is `height` high, or nothing if there
  /// is none.
  using ContoursOf = std::function<std::optional<Contours>(double z, double height)>;

  explicit PrintJudge(ContoursOf contours_of, const JudgeOptions& options = {})
      : contours_of_(std::move(contours_of)), options_(options) {}

  /// Takes the next bead. One at another z ends the layer before it.
  void add(const ExtrudedSegment& bead);

  /// Ends the last layer. \return The finding on all layers.
  const PrintVerdict& finish();

  [[nodiscard]] const PrintVerdict& verdict() const { return verdict_; }

 private:
  void judge();

  ContoursOf contours_of_;
  JudgeOptions options_;
  std::vector<ExtrudedSegment> beads_;
  PrintVerdict verdict_;
};

}  // namespace slipstick
