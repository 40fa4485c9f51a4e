#include "host/certified_totals.h"

#include <fmt/format.h>

namespace slipstick {
namespace {

std::vector<CertifiedTotals::Place> unproved_places(const SlicedLayer& layer) {
  std::vector<CertifiedTotals::Place> places;
  const LayerCertificate& c = *layer.certificate;
  for (const Vec2 p : c.uncertified_at) {
    places.push_back({layer.index,
                      {p.x, p.y, layer.middle},
                      "the contour is not proved here: an edge, a corner or a feature finer than "
                      "the samples"});
  }
  for (const SlabEvent& e : c.events) {
    if (e.kind != SlabEvent::Kind::kHidden) continue;
    places.push_back({layer.index, e.box.centre(), "possible feature thinner than the layer"});
  }
  if (!c.complete) {
    places.push_back({layer.index, {0, 0, layer.middle}, "too much of the layer is unclear"});
  }
  return places;
}

}  // namespace

void CertifiedTotals::add(const SlicedLayer& layer) {
  if (!layer.certificate) return;
  const LayerCertificate& c = *layer.certificate;
  ++layers;
  cells += c.cells;
  uncertified += c.uncertified;
  events += c.hidden();
  steps += static_cast<std::int64_t>(c.events.size()) - c.hidden();
  unfinished_layers += c.complete ? 0 : 1;
  if (c.proved() || first.size() == kPlacesKept) return;
  for (CertifiedTotals::Place& place : unproved_places(layer)) {
    if (first.size() < kPlacesKept) first.push_back(std::move(place));
  }
}

std::string unproved_text(const SlicedLayer& layer) {
  const CertifiedTotals::Place place = unproved_places(layer).front();
  return fmt::format(
      "layer {} at ({:.2f}, {:.2f}, {:.3f}) mm: {}; use a finer --sampling or --layer-height, or "
      "--certify report",
      place.layer, place.at.x, place.at.y, place.at.z, place.what);
}

}  // namespace slipstick
