#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/judge.h"
#include "sim/layer_series.h"
#include "sim/print_ledger.h"

namespace slipstick {

/// A fault of a print.
struct PrintDefect {
  int layer = 0;  ///< Counted from 0 over the layers judged; the one above what was left out.
  double z = 0;   ///< mm: its top, or the top of the layer that was left out.
  Defect defect;

  friend bool operator==(const PrintDefect&, const PrintDefect&) = default;
};

/// The finding on a print so far.
struct PrintVerdict {
  int layers = 0;            ///< Judged.
  int layers_unknown = 0;    ///< Printed where there are no contours to judge by.
  int components_wrong = 0;  ///< Sums over the layers judged.
  int holes_wrong = 0;
  int rims_bare = 0;
  int in_the_air = 0;
  int infill_missing = 0;      ///< Layers with a void out of proportion (layer_series.h).
  int layers_missing = 0;      ///< Left out below others.
  double area_error_max = 0;   ///< Of one layer.
  double area_error_mean = 0;  ///< Over the layers judged.
  double stray_mm2 = 0;
  double overhang_mm2 = 0;
  double top = 0;         ///< mm: of the last layer judged.
  double height_max = 0;  ///< mm: of the highest layer judged.
  std::vector<double>
      wrong_at;  ///< mm: the tops of the first wrong layers, `kWrongListed` at most.
  std::vector<PrintDefect> defects;  ///< The first ones, `kDefectsListed` at most.

  static constexpr std::size_t kWrongListed = 20;
  static constexpr std::size_t kDefectsListed = 1000;

  [[nodiscard]] int wrong() const {
    return components_wrong + holes_wrong + rims_bare + in_the_air + infill_missing +
           layers_missing;
  }
};

/// Judges a print layer by layer while it is made; keeps the beads of one layer, the pixels of
/// the one below and five numbers of each.
///
/// Beads that touch no island before any layer did (a prime line at a height of its own) are not a
/// layer; they count as unknown.
class PrintJudge {
 public:
  /// The contours of the layer whose top is at `z` and which is `height` high, or nothing if there
  /// is none.
  using ContoursOf = std::function<std::optional<Contours>(double z, double height)>;

  /// Gets every layer as it is judged: its number and its top, mm.
  using Watcher = std::function<void(int layer, double top, const JudgedLayer&)>;

  explicit PrintJudge(ContoursOf contours_of, const JudgeOptions& options = {})
      : contours_of_(std::move(contours_of)), options_(options) {}

  /// Lets it count what was printed and what was wanted, too. Each ledger is for pixels of
  /// `JudgeOptions`. \pre No bead has come.
  void keep_ledgers(PrintLedger printed, PrintLedger wanted);

  /// Lets `watcher` see the layers. \pre No bead has come.
  void show_to(Watcher watcher);

  /// Takes the next bead. One at another z ends the layer before it.
  void add(const ExtrudedSegment& bead);

  /// Ends the last layer, and looks at the layers as a series. \return The finding on all layers.
  const PrintVerdict& finish();

  [[nodiscard]] const PrintVerdict& verdict() const { return verdict_; }
  /// The topology of what was printed, infill's cells taken as solid, and of the contours. Nothing
  /// without ledgers.
  [[nodiscard]] std::optional<Topology> printed_topology() const;
  [[nodiscard]] std::optional<Topology> wanted_topology() const;

 private:
  void judge();
  void note(const LayerVerdict& layer);
  void list(const PrintDefect& defect);
  void look_at_series();
  void note_gap(const LayerGap& gap);

  ContoursOf contours_of_;
  JudgeOptions options_;
  Watcher watcher_;
  std::vector<ExtrudedSegment> beads_;
  std::optional<PixelImage> below_;
  std::optional<PrintLedger> printed_;
  std::optional<PrintLedger> wanted_;
  std::vector<LayerTrace> traces_;  ///< Of the layers judged.
  bool finished_ = false;
  PrintVerdict verdict_;
};

}  // namespace slipstick
