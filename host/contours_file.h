#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "core/base/affine.h"
#include "core/base/result.h"
#include "core/contour/audit.h"

namespace slipstick {

/// Reads contours written as JSON Lines, a layer at a time. Everything in the file is checked;
/// errors are kInput and name file and line.
class ContoursFile {
 public:
  struct Header {
    std::string model;
    double sampling = 0;      ///< mm, as asked for.
    double grid_width = 0;    ///< mm, exact width of the lattice; 0 if the file does not say.
    double layer_height = 0;  ///< mm
    int layers = 0;
    Affine3 to_model;
  };
  struct Layer {
    int index = 0;
    double z = 0;
    std::vector<AuditLoop> loops;
  };

  [[nodiscard]] static Result<ContoursFile> open(const std::filesystem::path& path);

  [[nodiscard]] const Header& header() const { return header_; }

  /// The next layer; nothing at the end. A missing layer is an error.
  [[nodiscard]] Result<std::optional<Layer>> next();

 private:
  ContoursFile(std::filesystem::path path, std::ifstream stream)
      : path_(std::move(path)), stream_(std::move(stream)) {}

  [[nodiscard]] Result<void> read_header();
  [[nodiscard]] Error error(std::string_view what) const;

  std::filesystem::path path_;
  std::ifstream stream_;
  Header header_;
  int line_ = 0;
};

}  // namespace slipstick
