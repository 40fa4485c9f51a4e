#pragma once

namespace slipstick {

/// Benchmarks of whole layers, toolpaths and text, one a subject: subjects are known when the
/// program runs.
void register_layer_stages();

}  // namespace slipstick
