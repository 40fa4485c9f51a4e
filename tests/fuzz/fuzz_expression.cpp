// Any bytes are an expression over a box; what is pruned, vectorised and painted is what the
// operations give one by one.
#include <cstddef>
#include <cstdint>

#include "tests/support/expression_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  slipstick::test::check_against_oracle(slipstick::test::expression_of({data, size}));
  return 0;
}
