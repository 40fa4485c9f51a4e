#pragma once

#include <filesystem>
#include <fstream>

#include "host/line_source.h"

namespace slipstick {

/// The lines of a G-code file, read as they are needed. A line that no printer could take is an
/// error that names file and line.
class FileLines final : public LineSource {
 public:
  [[nodiscard]] static Result<std::unique_ptr<FileLines>> open(const std::filesystem::path& path);

  [[nodiscard]] Result<std::optional<Line>> next() override;
  [[nodiscard]] bool ready() const override { return true; }

 private:
  FileLines(std::filesystem::path path, std::ifstream stream)
      : path_(std::move(path)), stream_(std::move(stream)) {}

  std::filesystem::path path_;
  std::ifstream stream_;
  long number_ = 0;
};

}  // namespace slipstick
