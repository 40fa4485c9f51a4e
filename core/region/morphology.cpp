#include "core/region/morphology.h"

#include <algorithm>

namespace slipstick {
namespace {

enum class Along { kRows, kColumns };

// Grows along one axis: a node is in if the last or the next inside node is at most `radius` away.
BitImage grown(const BitImage& image, int radius, Along along) {
  BitImage result(image.grid());
  const bool rows = along == Along::kRows;
  const int lines = rows ? image.rows() : image.columns();
  const int nodes = rows ? image.columns() : image.rows();
  const auto at = [&](int line, int node) {
    return rows ? image.at(node, line) : image.at(line, node);
  };
  for (int line = 1; line < lines - 1; ++line) {
    int filled = 1;  // next node not yet decided
    for (int node = 1; node < nodes - 1; ++node) {
      if (!at(line, node)) continue;
      for (filled = std::max(filled, node - radius); filled < nodes - 1 && filled <= node + radius;
           ++filled) {
        rows ? result.set(filled, line, true) : result.set(line, filled, true);
      }
    }
  }
  return result;
}

}  // namespace

BitImage dilated(const BitImage& image, int radius) {
  return grown(grown(image, radius, Along::kRows), radius, Along::kColumns);
}

}  // namespace slipstick
