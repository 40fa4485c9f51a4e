#pragma once

#include <memory>
#include <string_view>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Limits of expression text.
inline constexpr std::size_t kVmBytesMax = std::size_t{64} << 20;
inline constexpr std::size_t kVmStatementsMax = std::size_t{1} << 20;

/// Reads an expression as Fidget writes it (`.vm`): a statement `name op operands…` a line, `#`
/// before comments, the last statement is f. Lenient about blanks and CR LF. Inside is f < 0,
/// strictly, as the format has it.
///
/// \param bounds the extent in the model's units: the text has none.
/// \return kInput with `name` and the line of the first fault. `rand` and `mix` are refused: they
/// have no
///   definition that this program knows.
[[nodiscard]] Result<std::unique_ptr<Model>> load_vm_model(std::string_view text,
                                                           std::string_view name,
                                                           const Box3& bounds);

}  // namespace slipstick
