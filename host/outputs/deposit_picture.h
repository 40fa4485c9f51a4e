#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "core/base/result.h"
#include "sim/print_judge.h"

namespace slipstick {

/// A picture of what was laid in one layer over what was wanted, with its defects: blue is right,
/// pale the cells of infill, red too much, orange too little.
///
/// Give it every layer as it is judged; it keeps the one that was asked for or, if none was, the
/// first that is wrong by itself, else the last.
class DepositPicture {
 public:
  explicit DepositPicture(std::optional<int> layer) : asked_(layer) {}

  void see(int layer, double top, const JudgedLayer& judged);

  /// Draws it as `.png` or `.svg`, with those of the print's `defects` that are in it.
  /// \return kInput if the extension is another, or there was no such layer.
  [[nodiscard]] Result<void> write_to(const std::filesystem::path& path,
                                      std::span<const PrintDefect> defects) const;

 private:
  struct Kept {
    int layer;
    double top;
    JudgedLayer judged;
  };

  std::optional<int> asked_;
  std::optional<Kept> kept_;
};

}  // namespace slipstick
