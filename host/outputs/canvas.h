#pragma once

#include <cairo.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace slipstick {

/// A white drawing, kept in memory until it is written whole.
class Canvas {
 public:
  enum class Format { kSvg, kPng };

  /// \return nothing if the extension of `path` names no format.
  [[nodiscard]] static std::optional<Format> format_of(const std::filesystem::path& path);

  Canvas(Format format, double width, double height);

  [[nodiscard]] cairo_t* cairo() const { return cairo_.get(); }

  /// Ends the drawing and writes it to a file, whole or not at all.
  [[nodiscard]] Result<void> write_to(const std::filesystem::path& path);

 private:
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };

  Format format_;
  std::unique_ptr<std::string> bytes_;  // cairo keeps its address
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

}  // namespace slipstick
