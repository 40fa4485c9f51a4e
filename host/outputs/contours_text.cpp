#include "host/outputs/contours_text.h"

#include "core/base/number_text.h"

namespace slipstick {
namespace {

void append_point(std::string& text, Vec2 p) {
  text += '[';
  append_exact(text, p.x);
  text += ',';
  append_exact(text, p.y);
  text += ']';
}

void append_loop(std::string& text, const Outline& outline, const Outline::Loop& loop) {
  text += "{\"depth\":" + std::to_string(loop.depth) + ",\"points\":[";
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    if (i > 0) text += ',';
    append_point(text, outline.mm(loop.points[i]));
  }
  text += "]}";
}

}  // namespace

std::string contours_line(const SlicedLayer& layer) {
  std::string text = "{\"layer\":" + std::to_string(layer.index) + ",\"z\":";
  append_exact(text, layer.middle);
  text += ",\"loops\":[";
  const Outline& outline = layer.contours.outline;
  for (std::size_t i = 0; i < outline.loops().size(); ++i) {
    if (i > 0) text += ',';
    append_loop(text, outline, outline.loops()[i]);
  }
  text += "]}\n";
  return text;
}

}  // namespace slipstick
