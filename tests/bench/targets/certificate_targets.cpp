// How much of a slice is proved.
#include <fmt/format.h>

#include "core/base/check.h"
#include "core/contour/certify.h"
#include "core/image/sample.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

std::vector<Row> certificate_rows() {
  std::vector<Row> rows;
  for (const Subject& s : smooth_subjects()) {
    const auto image = sample(*s.solid->section(s.z), s.grid);
    SLIPSTICK_CHECK(image.has_value());
    const auto field = s.solid->field();
    const LayerCertificate proof = certify_layer(*field, *image, s.z, s.z);
    SLIPSTICK_CHECK(proof.cells > 0);
    rows.push_back({fmt::format("certified boundary cells of a slice, {}", s.name), "100 %",
                    fmt::format("{} of {} cells open", proof.uncertified, proof.cells),
                    proof.complete && proof.uncertified == 0});
  }
  return rows;
}

}  // namespace slipstick::targets
