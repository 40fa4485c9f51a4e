#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/solid/ldni_blocks.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Layered depth-normal images as a solid; `LdniSight` says which points are inside, wherever the
/// solid lies. What is uniform is never sampled, on an axis or not.
class LdniModel final : public Model {
 public:
  explicit LdniModel(Ldni ldni);

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "ldni"; }
  [[nodiscard]] std::string size_text() const override;

  [[nodiscard]] const Ldni& ldni() const { return parts_->ldni; }

  struct Parts {
    Ldni ldni;
    LdniBlocks blocks;
  };

 private:
  std::shared_ptr<const Parts> parts_;
};

/// "1000 x 1000 rays an axis, 812345 samples"
[[nodiscard]] std::string size_text_of(const Ldni& ldni);

}  // namespace slipstick
