#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/serve/job_spec.h"
#include "host/serve/store.h"

namespace slipstick {

/// Contours of any layer of a model, sliced on the spot. Keeps the last model loaded, so that a
/// slider through one solid loads it once.
///
/// Threads: one.
class LayerPreview {
 public:
  struct Question {
    std::string path;
    StoredFile file;
    std::string spec;  ///< JSON: job_spec.h.
    JobDefaults defaults;
  };

  /// How many layers and what box: JSON. \return kInput for a G-code file, too.
  [[nodiscard]] Result<std::string> describe(const Question& question);
  /// Layer `layer`, from 0, as a line of a contours file.
  [[nodiscard]] Result<std::string> layer(const Question& question, int layer);

 private:
  struct Loaded {
    std::int64_t file;
    std::string spec;
    PreparedModel model;
  };
  [[nodiscard]] Result<const PreparedModel*> model(const Question& question);

  std::optional<Loaded> loaded_;
};

}  // namespace slipstick
