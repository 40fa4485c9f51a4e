#include "host/gcode_judge.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/contour/place_roots.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "core/job/layers.h"
#include "core/region/level.h"
#include "host/interrupt.h"
#include "host/printer_link.h"
#include "sim/deposit.h"

namespace slipstick {
namespace {

constexpr double kLedgerMargin = 2;  // mm around the model: what hangs on it farther out is cut off
constexpr std::size_t kLineMax = 4096;

/// Sections of the model at any height.
class Sections {
 public:
  Sections(std::shared_ptr<const Solid> solid, const SliceGrid& grid, Ambiguity ambiguity)
      : solid_(std::move(solid)), grid_(grid), ambiguity_(ambiguity) {}

  Result<Contours> at(double z) const {
    const auto section = solid_->section(z);
    const auto image = sample(*section, grid_);
    if (!image) return fail(image.error().within(fmt::format("z={:.4g}", z)));
    ContourSet contours = trace(*image, ambiguity_);
    place_roots(contours, *section);
    return polygons_of(keep_all(contours).outline);
  }

 private:
  std::shared_ptr<const Solid> solid_;
  SliceGrid grid_;
  Ambiguity ambiguity_;
};

JudgeOptions judge_options(const PrintSettings& settings) {
  JudgeOptions options;
  options.pixel = settings.slicing.sampling / 2;
  return options;
}

class Run {
 public:
  Run(const PlacedSolid& placed, const PrintSettings& settings, const Sections& sections)
      : placed_(placed),
        sections_(sections),
        judge_([this](double z, double height) { return contours_at(z - height / 2); },
               judge_options(settings)),
        deposit_(settings.printer.filament_diameter,
                 [this](const ExtrudedSegment& bead) { judge_.add(bead); }),
        player_(built(machine_like(settings.printer)),
                [this](const ExecutedMove& move) { take(move); }) {}

  void show_to(const GcodeWatch& watch) {
    if (watch.layers) judge_.show_to(watch.layers);
    player_.show_to(watch.machine);
    moves_ = watch.moves;
  }

  Result<void> keep_ledgers(const Box2& area, double pixel) {
    auto printed = PrintLedger::over(area, pixel);
    auto wanted = PrintLedger::over(area, pixel);
    if (!printed) return fail(printed.error());
    judge_.keep_ledgers(std::move(*printed), std::move(*wanted));
    return {};
  }

  Result<void> read(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const auto cannot = [&](ErrorCode code) {
      return fail(code, fmt::format("cannot read {}: {}", path.string(),
                                    std::generic_category().message(errno)));
    };
    if (!stream) return cannot(ErrorCode::kInput);
    long number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      if (line.size() > kLineMax) {
        return fail(ErrorCode::kInput, fmt::format("{}:{}: {} characters; this is no G-code",
                                                   path.string(), number, line.size()));
      }
      if (line.ends_with('\r')) line.pop_back();
      player_.play(line);
      if (failure_) return fail(*failure_);
      if (Interrupt::requested()) return fail(ErrorCode::kCancelled, "interrupted");
    }
    if (stream.bad()) return cannot(ErrorCode::kUnavailable);
    return {};
  }

  Result<GcodeVerdict> finish() {
    verdict_.seconds = player_.finish();
    verdict_.print = judge_.finish();
    if (failure_) return fail(*failure_);
    verdict_.printed = judge_.printed_topology().value_or(Topology{});
    verdict_.wanted = judge_.wanted_topology().value_or(Topology{});
    const double missing = placed_.bounds.high.z - verdict_.print.top;
    verdict_.top_missing = missing > verdict_.print.height_max ? missing : 0;
    verdict_.moves = player_.motion().moves;
    verdict_.refused = player_.refused();
    verdict_.refusals = player_.refusals();
    return verdict_;
  }

 private:
  std::optional<Contours> contours_at(double z) {
    auto contours = sections_.at(z);
    if (contours) return std::move(*contours);
    if (!failure_) failure_ = contours.error();
    return {};
  }

  void take(const ExecutedMove& move) {
    const double filament = move.filament();
    const bool crosses = move.to.x != move.from.x || move.to.y != move.from.y;
    verdict_.filament_mm += filament;
    verdict_.retractions += filament < 0 ? 1 : 0;
    verdict_.travels += crosses && filament <= 0 ? 1 : 0;
    if (moves_) moves_(move);
    deposit_.add(move);
  }

  const PlacedSolid& placed_;
  const Sections& sections_;
  GcodeVerdict verdict_;
  Planner::Sink moves_;
  std::optional<Error> failure_;
  PrintJudge judge_;
  Deposit deposit_;
  GcodePlayer player_;  // last: it calls what stands above
};

}  // namespace

Result<GcodeVerdict> judge_gcode(const std::filesystem::path& path, const PlacedSolid& placed,
                                 const PrintSettings& settings, const GcodeWatch& watch) {
  const Box3& b = placed.bounds;
  const auto grid = SliceGrid::over({{b.low.x, b.low.y}, {b.high.x, b.high.y}},
                                    LayerStack::aligned_sampling(settings.slicing));
  if (!grid) return fail(grid.error());
  const Sections sections(placed.solid, *grid, settings.slicing.ambiguity);
  Run run(placed, settings, sections);
  run.show_to(watch);
  const Vec2 margin{kLedgerMargin, kLedgerMargin};
  const Box2 area{Vec2{b.low.x, b.low.y} - margin, Vec2{b.high.x, b.high.y} + margin};
  if (const auto ok = run.keep_ledgers(area, judge_options(settings).pixel); !ok) {
    return fail(ok.error());
  }
  if (const auto ok = run.read(path); !ok) return fail(ok.error());
  auto verdict = run.finish();
  if (verdict && verdict->print.layers == 0) {
    return fail(ErrorCode::kInput,
                fmt::format("{} lays nothing where the model is ({} lines were refused{})",
                            path.string(), verdict->refused,
                            verdict->refusals.empty()
                                ? ""
                                : fmt::format(", the first: {}: {}", verdict->refusals.front().text,
                                              verdict->refusals.front().why)));
  }
  return verdict;
}

}  // namespace slipstick
