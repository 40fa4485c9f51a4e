#include "host/outputs/canvas.h"

#include <cairo-svg.h>
#include <fmt/format.h>

#include "host/atomic_file.h"

namespace slipstick {
namespace {

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(Canvas::Format format, double width, double height,
                              std::string* bytes) {
  if (format == Canvas::Format::kSvg) {
    return cairo_svg_surface_create_for_stream(append, bytes, width, height);
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                    static_cast<int>(height));
}

}  // namespace

std::optional<Canvas::Format> Canvas::format_of(const std::filesystem::path& path) {
  if (path.extension() == ".svg") return Format::kSvg;
  if (path.extension() == ".png") return Format::kPng;
  return {};
}

Canvas::Canvas(Format format, double width, double height)
    : format_(format),
      bytes_(std::make_unique<std::string>()),
      surface_(make_surface(format, width, height, bytes_.get())),
      cairo_(cairo_create(surface_.get())) {
  cairo_set_source_rgb(cairo_.get(), 1, 1, 1);
  cairo_paint(cairo_.get());
}

Result<void> Canvas::write_to(const std::filesystem::path& path) {
  cairo_.reset();
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  if (format_ == Format::kPng) {
    status = cairo_surface_write_to_png_stream(surface_.get(), append, bytes_.get());
  } else {
    cairo_surface_finish(surface_.get());
    status = cairo_surface_status(surface_.get());
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("cannot draw {}: {}", path.string(), cairo_status_to_string(status)));
  }
  return write_file(path, *bytes_);
}

}  // namespace slipstick
