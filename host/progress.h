#pragma once

#include <chrono>
#include <string_view>

namespace slipstick {

/// A progress bar on standard error, if that is a terminal; otherwise nothing.
class Progress {
 public:
  /// \param verb "slicing", "printing".
  Progress(std::string_view verb, int layers);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` layers are finished, up to `height` mm. \param seconds_left as known, or < 0: guessed
  /// from the time passed.
  void show(int done, double height, double seconds_left = -1);

 private:
  std::string_view verb_;
  int layers_;
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace slipstick
