#include "host/outputs/deposit_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/outputs/canvas.h"
#include "host/outputs/coloured_squares.h"

namespace slipstick {
namespace {

constexpr double kLongSide = 1000;  // of the picture, in its units
constexpr double kCaption = 48;
constexpr double kText = 16;
constexpr double kMark = 14;  // radius of the ring round a defect
constexpr std::uint32_t kNothing = 0xFFFFFF, kRight = 0x5B7FB4, kCell = 0xDCE6F2,
                        kTooMuch = 0xD03030, kTooLittle = 0xF0A030;

std::uint32_t colour_at(const JudgedLayer& layer, int row, int column) {
  const bool laid = layer.laid.at(row, column);
  if (layer.wanted.at(row, column)) {
    if (laid) return kRight;
    return layer.support.at(row, column) ? kCell : kTooLittle;
  }
  return laid ? kTooMuch : kNothing;
}

void mark_defects(cairo_t* cairo, std::span<const Defect> defects, const PixelFrame& frame,
                  double scale) {
  cairo_set_font_size(cairo, kText);
  for (const Defect& defect : defects) {
    const double x = (defect.place.x - frame.low.x) / frame.size * scale;
    const double up = (defect.place.y - frame.low.y) / frame.size;
    const double y = kCaption + (frame.rows - up) * scale;
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_set_line_width(cairo, 2);
    cairo_arc(cairo, x, y, kMark, 0, 2 * std::numbers::pi);
    cairo_stroke(cairo);
    cairo_move_to(cairo, x + kMark + 3, y + kText / 3);
    cairo_show_text(cairo, std::string(describe(defect.kind)).c_str());
  }
}

void write_caption(cairo_t* cairo, const std::string& text) {
  cairo_set_source_rgb(cairo, 0, 0, 0);
  cairo_set_font_size(cairo, kText);
  cairo_move_to(cairo, kText / 2, kCaption / 2 + kText / 3);
  cairo_show_text(cairo, text.c_str());
}

}  // namespace

void DepositPicture::see(int layer, double top, const JudgedLayer& judged) {
  if (asked_ && layer != *asked_) return;
  if (!asked_ && kept_ && !kept_->judged.verdict.defects.empty()) return;
  kept_.emplace(Kept{layer, top, judged});
}

Result<void> DepositPicture::write_to(const std::filesystem::path& path,
                                      std::span<const PrintDefect> defects) const {
  const auto format = Canvas::format_of(path);
  if (!format) {
    return fail(ErrorCode::kInput, fmt::format("{}: a picture is .png or .svg", path.string()));
  }
  if (!kept_) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: there is no layer {} to draw", path.string(), asked_.value_or(0)));
  }
  const JudgedLayer& layer = kept_->judged;
  const PixelFrame& frame = layer.laid.frame();
  std::vector<Defect> marked;
  for (const PrintDefect& d : defects) {
    if (d.layer == kept_->layer) marked.push_back(d.defect);
  }
  const double scale = kLongSide / std::max(frame.columns, frame.rows);
  Canvas canvas(*format, std::ceil(frame.columns * scale),
                std::ceil(frame.rows * scale + kCaption));
  const auto colour = [&layer](int row, int column) { return colour_at(layer, row, column); };
  paint_squares(canvas.cairo(), {frame.columns, frame.rows, colour}, 0, kCaption, scale);
  mark_defects(canvas.cairo(), marked, frame, scale);
  write_caption(canvas.cairo(),
                fmt::format("layer {}, z = {:.4g} mm: {} defects; {:.1f} mm across", kept_->layer,
                            kept_->top, marked.size(), frame.columns * frame.size));
  return canvas.write_to(path);
}

}  // namespace slipstick
