#pragma once

#include <memory>

#include "core/base/result.h"
#include "host/sliced_layer.h"
#include "host/slicing_job.h"

namespace slipstick {

/// Where sliced layers go: G-code, contours or pictures. Nothing is left under its name unless
/// `finish` succeeded.
class LayerSink {
 public:
  LayerSink() = default;
  LayerSink(const LayerSink&) = delete;
  LayerSink& operator=(const LayerSink&) = delete;
  virtual ~LayerSink() = default;

  /// Takes the next layer, bottom to top. \return kUnavailable if it cannot be written.
  [[nodiscard]] virtual Result<void> add(const SlicedLayer& layer) = 0;

  /// After the last layer. Once.
  [[nodiscard]] virtual Result<void> finish() = 0;
};

/// All that outputs may want to know beforehand.
struct SinkContext {
  std::string model;              ///< File name of the model.
  const PrintSettings* settings;  ///< Outlives the sink.
  const SlicingJob* job;          ///< Likewise.
  Affine3 to_model;
};

}  // namespace slipstick
