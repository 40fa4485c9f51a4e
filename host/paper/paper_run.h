#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "host/paper/paper_tables.h"
#include "host/slicing_job.h"

namespace slipstick {

/// Whose method a row is run by.
enum class PaperMethod : std::uint8_t {
  kOurs,    ///< Roots on the sticks, fewest edges within a tenth of r'.
  kTheirs,  ///< Sliding smoothing and variational simplification, as the paper has them.
};

/// What came of a row.
struct PaperRun {
  std::string representation;   ///< "mesh: 871306 triangles"
  double build_seconds = 0;     ///< To read it, and to make the tree or the fit.
  double seconds = 0;           ///< To slice it: wall time.
  double sampling_seconds = 0;  ///< Of that, added up over threads.
  std::size_t edges_before = 0;
  std::size_t edges_after = 0;
  double distortion = 0;  ///< in³
  int layers = 0;
  std::size_t violations = 0;
  double solid_mb = 0;   ///< Memory with the solid in it,
  double beyond_mb = 0;  ///< and what slicing took beyond that.
};

struct PaperOptions {
  std::filesystem::path models;  ///< Where the stand-ins are.
  PaperMethod method = PaperMethod::kOurs;
  int threads = 0;  ///< 0: one a core.
};

/// A row ready to be sliced as there: layers 0.01 in thick, on its r'.
struct PaperSubject {
  std::unique_ptr<Model> model;
  PlacedSolid placed;  ///< Stretched to the paper's size.
  SlicingRequest request;
};

/// \return kInput if there is no such file, or as the loaders.
[[nodiscard]] Result<PaperSubject> paper_subject(const PaperRow& row, const PaperOptions& options);

/// The stand-in of a row, stretched to the paper's size, sliced as there: layers 0.01 in thick, on
/// its r'. \return kInput if there is no such file, or as the loaders and SlicingJob.
[[nodiscard]] Result<PaperRun> run_paper_row(const PaperRow& row, const PaperOptions& options);

}  // namespace slipstick
