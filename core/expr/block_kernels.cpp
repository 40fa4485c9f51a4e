#include "core/expr/block_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/elementary.h"
#include "core/base/pi_reduction.h"
#include "core/expr/interval.h"

// Sizeless vectors cannot be members; 16-byte x86 vectors before SSE4.1 are all old machines have.
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/expr/block_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace slipstick::HWY_NAMESPACE {

#include "core/expr/lanes-inl.h"
// clang-format sorts within a group; the lanes come first.
#include "core/expr/boxes-inl.h"
#include "core/expr/points-inl.h"
#include "core/expr/spans-inl.h"
#include "core/expr/tile-inl.h"

}  // namespace slipstick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace slipstick {

HWY_EXPORT(RunPoints);
HWY_EXPORT(RunTile);
HWY_EXPORT(RunSigns);
HWY_EXPORT(RunBoxes);
HWY_EXPORT(RunChain);

void run_points(const PointRun& run) {
  HWY_DYNAMIC_DISPATCH(RunPoints)(run);
}
void run_tile(const TileRun& run) {
  HWY_DYNAMIC_DISPATCH(RunTile)(run);
}
void run_signs(const SignRun& run) {
  HWY_DYNAMIC_DISPATCH(RunSigns)(run);
}
void run_boxes(const BoxRun& run) {
  HWY_DYNAMIC_DISPATCH(RunBoxes)(run);
}
void run_chain(const ChainRun& run) {
  HWY_DYNAMIC_DISPATCH(RunChain)(run);
}

}  // namespace slipstick
#endif
