#include "host/paper/paper_charts.h"

#include <fmt/format.h>

#include "host/paper/alpha_study.h"

namespace slipstick {

bool has_charts(const PaperRow& row) {
  return row.name == "Hand" || row.name == "Spine";
}

Result<std::filesystem::path> chart_paper_row(const PaperRow& row, PaperOptions options,
                                              const std::filesystem::path& folder) {
  options.method = PaperMethod::kTheirs;
  const auto subject = paper_subject(row, options);
  if (!subject) return fail(subject.error());
  const auto results = alpha_study(subject->placed, subject->request, kStudyAlphas);
  if (!results) return fail(results.error().within(row.name));
  const std::string title =
      fmt::format("{}: {:g} x {:g} x {:g} in, r' = {:g} in, all layers, {}", row.name, row.size.x,
                  row.size.y, row.size.z, row.sampling, subject->model->size_text());
  const auto path = folder / fmt::format("alpha_{}.svg", row.name);
  if (const auto ok = draw_alpha_study(*results, title, path); !ok) return fail(ok.error());
  return path;
}

}  // namespace slipstick
