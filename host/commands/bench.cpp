// `slipstick bench paper`: the tables of the paper, and ours beside them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/paper/paper_charts.h"
#include "host/paper/paper_run.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

struct BenchCommand {
  std::string models;
  std::vector<std::string> only;
  std::string method = "ours";
  std::string output;
  std::string charts;
  int threads = 0;
  bool json = false;
};

constexpr const char* kHead =
    "| table | model | layers | s a layer, theirs | ours | times | edges after, theirs | ours | "
    "largest D', theirs (in³) | ours | MB beyond the solid | violations |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|\n";

double seconds_a_layer(const PaperRow& row) {
  return row.minutes * 60 / row.layers;
}

std::string line_of(const PaperRow& row, const PaperRun& run) {
  const double ours = run.seconds / run.layers;
  const auto share = [](double after, double before) { return after / before; };
  return fmt::format(
      "| {} | {} | {} | {:.2f} | {:.4f} | {:.0f} | {:.3f} of {:.0f} k | {:.3f} of {:.0f} k | "
      "{:.2e} "
      "| {:.2e} | {:.0f} | {} |\n",
      static_cast<int>(row.table), row.name, run.layers, seconds_a_layer(row), ours,
      seconds_a_layer(row) / ours, share(row.edges_after, row.edges_before), row.edges_before / 1e3,
      share(double(run.edges_after), double(run.edges_before)), double(run.edges_before) / 1e3,
      row.distortion, run.distortion, run.beyond_mb, run.violations);
}

Json json_of(const PaperRow& row, const PaperRun& run) {
  return {{"table", static_cast<int>(row.table)},
          {"model", row.name},
          {"stand_in", row.stand_in.empty() ? Json() : Json(row.stand_in)},
          {"size_in", {row.size.x, row.size.y, row.size.z}},
          {"sampling_in", row.sampling},
          {"paper",
           {{"seconds", row.minutes * 60},
            {"sampling_seconds", row.sampling_minutes * 60},
            {"layers", row.layers},
            {"edges", {{"before", row.edges_before}, {"after", row.edges_after}}},
            {"max_regional_distortion_in3", row.distortion}}},
          {"ours",
           {{"representation", run.representation},
            {"build_seconds", run.build_seconds},
            {"seconds", run.seconds},
            {"sampling_seconds", run.sampling_seconds},
            {"layers", run.layers},
            {"edges", {{"before", run.edges_before}, {"after", run.edges_after}}},
            {"max_regional_distortion_in3", run.distortion},
            {"solid_mb", run.solid_mb},
            {"beyond_mb", run.beyond_mb},
            {"violations", run.violations}}}};
}

bool is_there(const PaperRow& row, const std::filesystem::path& models) {
  return row.stand_in.empty() || std::filesystem::exists(models / row.stand_in);
}

class PaperBench {
 public:
  explicit PaperBench(const BenchCommand& command) : command_(command) {
    options_.models = command.models;
    options_.threads = command.threads;
    options_.method = command.method == "paper" ? PaperMethod::kTheirs : PaperMethod::kOurs;
  }

  CommandResult run() {
    if (const auto ok = check_names(); !ok) return fail(ok.error());
    if (!command_.charts.empty()) return charts();
    for (const PaperRow& row : paper_rows()) {
      if (!wanted(row)) continue;
      if (const auto ok = one(row); !ok) return fail(ok.error());
    }
    if (json_.empty()) return nothing_run();
    if (command_.json) std::cout << json_.dump(2) << '\n';
    if (const auto ok = write(); !ok) return fail(ok.error());
    return violations_ == 0 ? 0 : 1;
  }

 private:
  [[nodiscard]] Result<void> check_names() const {
    for (const std::string& name : command_.only) {
      if (std::ranges::count(paper_rows(), name, &PaperRow::name) > 0) continue;
      std::string names;
      for (const PaperRow& row : paper_rows()) {
        names += (names.empty() ? "" : ", ") + std::string(row.name);
      }
      return fail(ErrorCode::kInput,
                  fmt::format("{}: there is no such row in the paper; it has {}", name, names));
    }
    return {};
  }

  [[nodiscard]] bool wanted(const PaperRow& row) const {
    return command_.only.empty() || std::ranges::count(command_.only, row.name) > 0;
  }

  [[nodiscard]] static tl::unexpected<Error> nothing_run() {
    return fail(ErrorCode::kInput,
                "no row was run; name the folder of the models by --models or SLIPSTICK_MODELS");
  }

  // Says so where it is not.
  [[nodiscard]] bool found(const PaperRow& row) const {
    if (is_there(row, options_.models)) return true;
    fmt::print(stderr, "{}: skipped: there is no {} in '{}'\n", row.name, row.stand_in,
               options_.models.string());
    return false;
  }

  CommandResult charts() {
    const std::filesystem::path folder = command_.charts;
    if (!std::filesystem::is_directory(folder)) {
      return fail(ErrorCode::kInput,
                  fmt::format("--charts {}: there is no such folder; make it", folder.string()));
    }
    for (const PaperRow& row : paper_rows()) {
      if (!has_charts(row) || !wanted(row) || !found(row)) continue;
      const auto path = chart_paper_row(row, options_, folder);
      if (!path) return fail(path.error());
      if (!command_.json) fmt::print("{}\n", path->string());
      json_.push_back({{"model", row.name}, {"chart", path->string()}});
    }
    if (json_.empty()) return nothing_run();
    if (command_.json) std::cout << json_.dump(2) << '\n';
    return 0;
  }

  Result<void> one(const PaperRow& row) {
    if (!found(row)) return {};
    const auto done = run_paper_row(row, options_);
    if (!done) return fail(done.error());
    violations_ += done->violations;
    if (json_.empty()) say(kHead);
    json_.push_back(json_of(row, *done));
    say(line_of(row, *done));
    return {};
  }

  // At once: rows take their time.
  void say(const std::string& text) {
    table_ += text;
    if (!command_.json) std::cout << text << std::flush;
  }

  [[nodiscard]] Result<void> write() const {
    const std::filesystem::path path = command_.output;
    if (path.empty()) return {};
    return write_file(path, path.extension() == ".json" ? json_.dump(2) + "\n" : table_);
  }

  const BenchCommand& command_;
  PaperOptions options_;
  std::string table_;
  Json json_ = Json::array();
  std::size_t violations_ = 0;
};

}  // namespace

void add_bench_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<BenchCommand>();
  if (const char* models = std::getenv("SLIPSTICK_MODELS")) command->models = models;
  CLI::App* bench = app.add_subcommand("bench", "measurements");
  bench->require_subcommand(1);
  CLI::App* sub = bench->add_subcommand("paper", "the paper's tables, and ours beside them");
  sub->add_option("--models", command->models,
                  "folder of the models that stand for the paper's; default: SLIPSTICK_MODELS");
  sub->add_option("--only", command->only, "rows by name: Dragon, Gear")
      ->delimiter(',')
      ->allow_extra_args(false);
  sub->add_option("--method", command->method, "ours, or the paper's on the same images")
      ->check(CLI::IsMember({"ours", "paper"}));
  sub->add_option("--threads", command->threads, "0: one a core")->check(CLI::Range(0, 256));
  auto* output = sub->add_option("-o,--output", command->output, "FILE.md or FILE.json");
  sub->add_option("--charts", command->charts,
                  "instead of the tables: charts over alpha of Hand and Spine, into this folder")
      ->excludes(output);
  sub->add_flag("--json", command->json, "print JSON instead of the table");
  sub->footer("Example: slipstick bench paper --models ~/models --only Bunny,Gear");
  sub->callback([command, &run] { run = [command] { return PaperBench(*command).run(); }; });
}

}  // namespace slipstick
