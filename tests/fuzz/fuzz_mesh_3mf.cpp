// Any bytes are a 3MF or none. A first line "zip": what follows is the file as it is. Else the
// bytes are XML, packed here: the root part, and, after a line "====", the part 3D/a.model.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/formats/mesh.h"
#include "tests/support/mesh_promise.h"
#include "tests/support/zip_bytes.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kZip = "zip\n", kPart = "\n====\n";
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string bytes;
  if (text.starts_with(kZip)) {
    bytes = text.substr(kZip.size());
  } else if (const auto at = text.find(kPart); at != std::string_view::npos) {
    const std::string part(text.substr(at + kPart.size()));
    bytes = package_3mf(std::string(text.substr(0, at)), {{"3D/a.model", part}});
  } else {
    bytes = package_3mf(std::string(text));
  }
  if (const auto mesh = read_mesh(bytes, "3mf")) check_mesh_promise(*mesh);
  return 0;
}
