// /metrics: the state for Prometheus, in its text format. What belongs to a job is there while one
// is under way; what is counted in a job begins anew with each.
#include <prometheus/text_serializer.h>

#include <cmath>

#include "host/process_memory.h"
#include "host/serve/api.h"

namespace slipstick {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

constexpr double kBytesOfMb = 1024 * 1024;

/// The families, in the order in which they were added.
class Page {
 public:
  void gauge(const char* name, const char* help, double value) { gauges(name, help, {}, value); }
  /// One of several that differ in `label`; those of one name follow each other.
  void gauges(const char* name, const char* help, const ClientMetric::Label& label, double value) {
    if (!std::isfinite(value)) return;  // a broken sensor has no temperature
    ClientMetric metric;
    metric.gauge.value = value;
    if (!label.name.empty()) metric.label.push_back(label);
    family(name, help, MetricType::Gauge).metric.push_back(std::move(metric));
  }
  void counter(const char* name, const char* help, double value) {
    ClientMetric metric;
    metric.counter.value = value;
    family(name, help, MetricType::Counter).metric.push_back(std::move(metric));
  }

  [[nodiscard]] std::string text() const {
    return prometheus::TextSerializer().prometheus::Serializer::Serialize(families_);
  }

 private:
  MetricFamily& family(const char* name, const char* help, MetricType type) {
    if (families_.empty() || families_.back().name != name) {
      families_.push_back({name, help, type, {}});
    }
    return families_.back();
  }

  std::vector<MetricFamily> families_;
};

void add_printer(const PrinterStatus& status, Page& page) {
  using enum PrinterActivity;
  for (const PrinterActivity each : {kIdle, kPrinting, kPaused, kEnding, kStopped}) {
    page.gauges("slipstick_printer_state", "1 for what the printer does",
                {"state", std::string(name_of(each))}, status.activity == each ? 1 : 0);
  }
  page.gauge("slipstick_printer_connected", "1 while somebody talks with the printer",
             status.connected ? 1 : 0);
  page.gauge("slipstick_bed_occupied", "1 until somebody says that the bed is clear",
             status.bed_occupied ? 1 : 0);
}

void add_temperatures(const Temperatures& seen, Page& page) {
  const std::pair<const char*, const std::optional<HeaterReading>*> heaters[] = {
      {"nozzle", &seen.hotend}, {"bed", &seen.bed}, {"chamber", &seen.chamber}};
  for (const auto& [name, heater] : heaters) {
    if (!*heater) continue;
    page.gauges("slipstick_temperature_celsius", "What the sensor says", {"heater", name},
                (*heater)->celsius);
  }
  for (const auto& [name, heater] : heaters) {
    if (!*heater || !(*heater)->target) continue;
    page.gauges("slipstick_target_celsius", "What the heater is to reach; 0 is off",
                {"heater", name}, *(*heater)->target);
  }
}

void add_job(const PrinterStatus& status, Page& page) {
  if (status.job != 0) {
    page.gauge("slipstick_job_completion_ratio", "Of the layers, or of the bytes of a file",
               status.completion);
    page.gauge("slipstick_job_layer", "Layers handed to the sender", status.layer);
    page.gauge("slipstick_job_layers", "Of the job; 0 for a G-code file", status.layers);
    page.gauge("slipstick_job_seconds", "Since the job began", status.seconds);
  }
  page.counter("slipstick_job_lines_sent_total", "Lines of the job", double(status.lines_sent));
  page.counter("slipstick_job_lines_acknowledged_total", "Lines the printer has taken",
               double(status.lines));
  page.counter("slipstick_job_resends_total", "Lines sent again", double(status.resends));
  page.counter("slipstick_job_starved_seconds_total",
               "The printer wanted a line and there was none", status.starved_seconds);
  constexpr const char* kTurnaround = "slipstick_job_turnaround_seconds";
  constexpr const char* kHelp = "From what was read to what was sent for it: this share is within";
  page.gauges(kTurnaround, kHelp, {"share", "0.5"}, status.turnaround_half);
  page.gauges(kTurnaround, kHelp, {"share", "0.99"}, status.turnaround_99);
}

}  // namespace

HttpResponse get_metrics(const HttpRequest&, Services& services) {
  const auto queued = services.store.queued();
  if (!queued) return error_response(queued.error());
  const PrinterStatus status = services.board.get();
  Page page;
  page.gauges("slipstick_info", "1: which slipstick this is", {"version", SLIPSTICK_VERSION}, 1);
  add_printer(status, page);
  if (status.temperatures) add_temperatures(*status.temperatures, page);
  add_job(status, page);
  page.gauge("slipstick_queued_jobs", "Jobs that wait", *queued);
  const auto up = std::chrono::steady_clock::now() - services.began;
  page.gauge("slipstick_uptime_seconds", "Since the daemon began",
             std::chrono::duration<double>(up).count());
  page.gauge("process_resident_memory_bytes", "Of the daemon", resident_mb() * kBytesOfMb);
  return {200, "text/plain; version=0.0.4; charset=utf-8", page.text(), {}};
}

}  // namespace slipstick
