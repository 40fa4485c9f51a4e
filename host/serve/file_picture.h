#pragma once

#include <filesystem>

#include "host/serve/job_spec.h"
#include "host/serve/store.h"

namespace slipstick {

/// Draws a small picture of a model, seen from obliquely above, into `picture`, a PNG: contours of
/// at most `kPictureLayers` layers, `kPictureSamples` samples wide, however large the model is.
///
/// \param path where the bytes of `file` are. \return kInput for a G-code file and for what cannot
/// be sliced; otherwise as the loaders and `draw_stack`.
[[nodiscard]] Result<void> draw_file(const std::filesystem::path& path, const StoredFile& file,
                                     const JobDefaults& defaults,
                                     const std::filesystem::path& picture);

inline constexpr int kPictureLayers = 60;
inline constexpr int kPictureSamples = 200;
inline constexpr int kPictureSide = 200;  ///< Pixels.

}  // namespace slipstick
