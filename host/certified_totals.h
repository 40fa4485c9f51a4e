#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec.h"
#include "host/sliced_layer.h"

namespace slipstick {

/// What the certificates of a job add up to, so far.
struct CertifiedTotals {
  struct Place {
    int layer = 0;
    Vec3 at;  ///< mm
    std::string what;
  };
  static constexpr std::size_t kPlacesKept = 8;

  std::int64_t layers = 0;  ///< Of which there is a certificate.
  std::int64_t cells = 0;
  std::int64_t uncertified = 0;
  std::int64_t events = 0;  ///< Features that may hide between two slices.
  std::int64_t steps = 0;   ///< Changes of topology that the slices show.
  std::int64_t unfinished_layers = 0;
  std::vector<Place> first;  ///< The first few of what is not proved.

  void add(const SlicedLayer& layer);
};

/// The first thing that `layer`'s certificate leaves open, as a line for a person that says where
/// and what to do. \pre It has one, and it proves less than all.
[[nodiscard]] std::string unproved_text(const SlicedLayer& layer);

}  // namespace slipstick
