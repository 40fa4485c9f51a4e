#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/solid/rbf_function.h"
#include "core/solid/solid.h"

namespace slipstick {

/// The solid {f <= 0} of a blend of basis functions; outside where no support reaches.
class RbfModel final : public Model {
 public:
  /// What a function must be made of for f to be a number everywhere.
  static constexpr double kCoordinateMax = 1e9;
  static constexpr double kRadiusMin = 1e-9;
  static constexpr double kCoefficientMax = 1e12;

  /// \return kInput, naming the function, if one is beyond the limits above; if there is none.
  [[nodiscard]] static Result<std::unique_ptr<RbfModel>> of(std::vector<RbfFunction> functions);

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "rbf"; }
  [[nodiscard]] std::string size_text() const override;

  [[nodiscard]] const std::vector<RbfFunction>& functions() const { return *functions_; }

 private:
  explicit RbfModel(std::shared_ptr<const std::vector<RbfFunction>> functions)
      : functions_(std::move(functions)) {}

  std::shared_ptr<const std::vector<RbfFunction>> functions_;
};

}  // namespace slipstick
