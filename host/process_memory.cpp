#include "host/process_memory.h"

#include <malloc.h>

#include <fstream>
#include <string>

namespace slipstick {
namespace {

// Holds all that a layer of 30,000 sticks takes.
constexpr int kKeptBytes = 16 << 20;

// A line of /proc/self/status, in MB.
double status_mb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kib = 0;
    if (word == name && status >> kib) return kib / 1024;
  }
  return 0;
}

}  // namespace

void keep_freed_memory() {
  ::mallopt(M_MMAP_THRESHOLD, kKeptBytes);
  ::mallopt(M_TRIM_THRESHOLD, kKeptBytes);
}

void give_back_freed_memory() {
  ::malloc_trim(0);
}

double resident_mb() {
  return status_mb("VmRSS:");
}

double begin_peak_anew() {
  give_back_freed_memory();
  std::ofstream("/proc/self/clear_refs") << 5;
  return resident_mb();
}

double peak_mb() {
  return status_mb("VmHWM:");
}

}  // namespace slipstick
