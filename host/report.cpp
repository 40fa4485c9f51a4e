#include "host/report.h"

#include <sys/resource.h>

namespace slipstick {

long peak_rss_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;  // Linux counts in KiB
}

namespace {

// Why there are no certificates at all, if there are none.
const char* why_nothing(const SlicingJob& job, const SlicingSettings& slicing) {
  if (job.certification() == Certification::kOff) return "certify is off";
  if (slicing.regularize > 0) return "a regularized solid is no longer its formula";
  return "a solid that is not a formula has no gradient to prove anything from";
}

nlohmann::ordered_json certified_json(const SlicingJob& job, const SlicingSettings& slicing) {
  const CertifiedTotals& c = job.totals().certified;
  nlohmann::ordered_json json{{"cells", c.cells},
                              {"uncertified", c.uncertified},
                              {"events", c.events},
                              {"steps", c.steps},
                              {"unfinished_layers", c.unfinished_layers}};
  if (c.layers == 0) json["why"] = why_nothing(job, slicing);
  json["first"] = nlohmann::ordered_json::array();
  for (const CertifiedTotals::Place& p : c.first) {
    json["first"].push_back(
        {{"layer", p.layer}, {"at", {p.at.x, p.at.y, p.at.z}}, {"what", p.what}});
  }
  return json;
}

}  // namespace

nlohmann::ordered_json slicing_report(const SlicingJob& job, const PrintSettings& settings,
                                      const ReportContext& context) {
  const SlicingTotals& t = job.totals();
  nlohmann::ordered_json json;
  json["model"] = context.model;
  json["representation"] = context.representation;
  json["layers"] = t.layers;
  json["sampling"] = settings.slicing.sampling;
  json["lattice_width"] = job.grid().width();
  json["aligned"] = job.stack().aligned(job.grid().width());
  json["grid"] = {job.grid().columns(), job.grid().rows()};
  json["threads"] = job.threads();
  json["seconds"] = {{"load", context.load_seconds},
                     {"sample", t.seconds.sample},
                     {"contour", t.seconds.contour},
                     {"place", t.seconds.place},
                     {"simplify", t.seconds.simplify},
                     {"verify", t.seconds.verify},
                     {"certify", t.seconds.certify},
                     {"toolpath", t.seconds.toolpath},
                     {"gcode", t.seconds.gcode},
                     {"total", context.total_seconds},
                     {"first_extrusion", context.first_extrusion_seconds}};
  json["edges"] = {{"before", t.edges_before}, {"after", t.edges_after}};
  json["max_deviation"] = t.max_deviation;
  json["max_regional_distortion"] = t.max_regional_distortion;
  json["ambiguous_squares"] = t.ambiguous_squares;
  json["certified"] = certified_json(job, settings.slicing);
  const Topology topology = job.topology();
  json["topology"] = {{"components", topology.components},
                      {"tunnels", topology.tunnels},
                      {"cavities", topology.cavities}};
  json["verified"] = {{"layers", t.layers}, {"violations", t.violations}};
  json["filament_mm"] = t.filament_mm;
  json["estimated_print_seconds"] = t.print_seconds;
  json["peak_rss_bytes"] = peak_rss_bytes();
  return json;
}

}  // namespace slipstick
