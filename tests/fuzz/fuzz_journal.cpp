// Any bytes are a journal or none; what is believed of it stands in its whole records, and numbers
// tell of no more lines than there are.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/check.h"
#include "host/print_journal.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto content = parse_journal(bytes);
  if (!content) return 0;
  SLIPSTICK_CHECK(content->size <= size && bytes[content->size - 1] == '\n');
  const auto whole = parse_journal(bytes.substr(0, content->size));
  SLIPSTICK_CHECK(whole && whole->taken == content->taken && whole->end == content->end);
  SLIPSTICK_CHECK(whole->layers == content->layers);
  SLIPSTICK_CHECK(whole->changes == content->changes);
  if (!content->session) return 0;
  for (const OtherLine& line : content->session->others) {
    if (line.number < content->session->first) continue;
    static_cast<void>(content->session->tail(line.number));
  }
  return 0;
}
