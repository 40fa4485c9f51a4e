#include "host/layer_slicer.h"

#include <algorithm>

#include "core/contour/audit.h"
#include "core/contour/trace.h"
#include "core/gcode/write.h"
#include "core/toolpath/plan_layer.h"
#include "host/place_contours.h"
#include "host/stopwatch.h"

namespace slipstick {
namespace {

std::size_t count_violations(const Outline& outline, const BitImage& image) {
  std::vector<AuditLoop> loops;
  for (const Outline::Loop& loop : outline.loops()) {
    loops.push_back({{}, loop.depth});
    for (const GridPoint p : loop.points) loops.back().points.push_back(outline.mm(p));
  }
  return audit_loops(loops).size() + audit_sticks(loops, image.grid().width()).size() +
         audit_samples(loops, image).size();
}

}  // namespace

LayerSlicer::LayerSlicer(const PlacedSolid& placed, const SliceGrid& grid, const LayerStack& stack,
                         SettingsTimeline& settings, SliceGoal goal)
    : solid_(placed.solid),
      bounds_(placed.bounds),
      stack_(stack),
      settings_(settings),
      slicing_(settings.original().slicing),
      goal_(goal),
      images_(placed.solid, grid, stack, slicing_.regularize),
      kept_(images_, grid, stack.count()) {}

Result<SlicedLayer> LayerSlicer::slice(int layer) {
  const SettingsTimeline::OfLayer settings = settings_.begin(layer);
  const auto whole = images_.image(layer);
  if (!whole) return fail(whole.error());
  const auto image = kept_.image(layer, settings.cancelled);
  if (!image) return fail(image.error());
  SlicedLayer result = contours(layer, *image);
  if (slicing_.certify != Certification::kOff) certify(**whole, result);
  if (goal_ == SliceGoal::kToolpaths) {
    if (const auto ok = add_toolpaths(settings, result); !ok) return fail(ok.error());
  }
  return result;
}

void LayerSlicer::finished_below(int layer) {
  const int needed = layer - settings_.bottom_layers_from(layer);
  images_.forget_below(needed);
  kept_.forget_below(needed);
}

SlicedLayer LayerSlicer::contours(int layer, const ImageWindow::Image& image) const {
  StepSeconds seconds;
  Stopwatch watch;
  ContourSet traced = trace(*image, slicing_.ambiguity);
  seconds.contour = watch.lap();
  place_contours(traced, slicing_.place, *solid_, stack_.middle(layer));
  seconds.place = watch.lap();
  Simplified simplified = simplify(traced);
  seconds.simplify = watch.lap();
  const std::size_t violations = count_violations(simplified.outline, *image);
  seconds.verify = watch.lap();
  return {layer,
          stack_.middle(layer),
          stack_.top(layer),
          image,
          std::move(simplified),
          violations,
          traced.ambiguous_squares(),
          {},
          {},
          {},
          seconds};
}

// The slice of the whole solid, whose formula it is, and the slab above it; what is below the first
// slice belongs to that, too.
void LayerSlicer::certify(const BitImage& image, SlicedLayer& layer) const {
  const auto field = solid_->field();
  if (!field || slicing_.regularize > 0) return;
  Stopwatch watch;
  const double beyond = image.grid().width();
  const bool last = layer.index + 1 == stack_.count();
  const double above =
      last ? std::max(bounds_.high.z, layer.middle) + beyond : stack_.middle(layer.index + 1);
  const CertifyEffort effort =
      slicing_.certify == Certification::kStrict ? CertifyEffort::kThorough : CertifyEffort::kQuick;
  LayerCertificate certificate = certify_layer(*field, image, layer.middle, above, effort);
  if (layer.index == 0) {
    const double low = std::min(bounds_.low.z, layer.middle) - beyond;
    certificate += certify_slab(*field, image.grid(), low, layer.middle);
  }
  layer.certificate = std::move(certificate);
  layer.seconds.certify = watch.lap();
}

Simplified LayerSlicer::simplify(const ContourSet& contours) const {
  const SimplifyOptions options{slicing_.tolerance, slicing_.alpha, slicing_.candidates};
  switch (slicing_.simplify) {
    case Simplification::kFewest:
      return simplify_fewest(contours, options);
    case Simplification::kVsa:
      return simplify_vsa(contours, options);
    case Simplification::kGreedy:
      return simplify_greedy(contours, options);
    case Simplification::kNone:
      break;
  }
  return keep_all(contours);
}

Result<void> LayerSlicer::add_toolpaths(const SettingsTimeline::OfLayer& settings,
                                        SlicedLayer& layer) {
  const ToolpathSettings& toolpath = settings.own->toolpath;
  const auto above =
      common_part(layer.index + 1, layer.index + toolpath.top_layers, settings.cancelled);
  if (!above) return fail(above.error());
  const auto below =
      common_part(layer.index - toolpath.bottom_layers, layer.index - 1, settings.cancelled);
  if (!below) return fail(below.error());
  Stopwatch watch;
  layer.toolpaths = plan_layer({layer.index, layer.top, stack_.thickness(layer.index), *layer.image,
                                layer.contours.outline, *above, *below},
                               *settings.own);
  layer.seconds.toolpath = watch.lap();
  layer.program = write_layer(*layer.toolpaths, *settings.own, *settings.below);
  layer.seconds.gcode = watch.lap();
  return {};
}

// What the images of layers `from` to `to` have in common.
Result<BitImage> LayerSlicer::common_part(int from, int to, const Cancelled& cancelled) {
  auto first = kept_.image(from, cancelled);
  if (!first) return fail(first.error());
  BitImage common = **first;
  for (int layer = from + 1; layer <= to && common.any(); ++layer) {
    const auto image = kept_.image(layer, cancelled);
    if (!image) return fail(image.error());
    common &= **image;
  }
  return common;
}

}  // namespace slipstick
