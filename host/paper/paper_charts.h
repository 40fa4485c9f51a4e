#pragma once

#include <filesystem>

#include "host/paper/paper_run.h"

namespace slipstick {

/// Whether the paper has charts of a row over the clustering ratio: figs. 21 and 22.
[[nodiscard]] bool has_charts(const PaperRow& row);

/// Slices the stand-in of a row by the paper's method for each of `kStudyAlphas` and draws
/// `alpha_NAME.svg` into `folder`. \return the file; errors as run_paper_row.
[[nodiscard]] Result<std::filesystem::path> chart_paper_row(const PaperRow& row,
                                                            PaperOptions options,
                                                            const std::filesystem::path& folder);

}  // namespace slipstick
