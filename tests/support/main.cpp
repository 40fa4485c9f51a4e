// Catch's main function, compiled once for all suites.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

// What the library of fonts keeps until the end is not ours. Also in lsan.txt, for programs that
// tests run.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the sanitizer's name
extern "C" const char* __lsan_default_suppressions();
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
