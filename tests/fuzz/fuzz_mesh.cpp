// Any bytes are a mesh or none; the first line is the extension. (For 3MF see fuzz_mesh_3mf.)
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/formats/mesh.h"
#include "core/formats/mesh_words.h"
#include "tests/support/mesh_promise.h"

using namespace slipstick;

// assimp 5.2.5 leaks the scene of an STL file that it refuses.
// NOLINTNEXTLINE: the name is the sanitizer's
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libassimp";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto extension = take_line(bytes);
  if (!extension || *extension == "3mf") return 0;
  if (const auto mesh = read_mesh(bytes, *extension)) check_mesh_promise(*mesh);
  return 0;
}
