#include "host/layer_lines.h"

#include "core/gcode/write.h"

namespace slipstick {

LayerLines::LayerLines(SlicingJob& job, const PrintSettings& settings, OnLayer on_layer,
                       Beginning beginning)
    : job_(job),
      settings_(settings),
      on_layer_(std::move(on_layer)),
      text_(beginning == Beginning::kStart ? write_start(settings).text : ""),
      next_layer_(job.first_layer()) {}

Result<std::optional<Line>> LayerLines::next() {
  while (true) {
    while (const auto text = next_text()) {
      auto line = normalise(*text);
      if (!line || *line) return line;
    }
    if (stage_ == Stage::kOver) return std::optional<Line>();
    if (const auto ok = refill(); !ok) return fail(ok.error());
  }
}

bool LayerLines::ready() const {
  return at_ < text_.size() || stage_ != Stage::kLayers || job_.ready();
}

bool LayerLines::take_pause() {
  while (at_ < text_.size() && (text_[at_] == ';' || text_[at_] == '\n')) next_text();
  if (at_ < text_.size() || stage_ != Stage::kLayers || asked_) return false;
  asked_ = true;
  return pause_before_ && pause_before_(next_layer_);
}

std::optional<std::string_view> LayerLines::next_text() {
  if (at_ >= text_.size()) return {};
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  const std::string_view line = std::string_view(text_).substr(at_, end - at_);
  at_ = end + 1;
  return line;
}

Result<void> LayerLines::refill() {
  at_ = 0;
  if (stage_ == Stage::kEnd) {
    text_.clear();
    stage_ = Stage::kOver;
    return {};
  }
  auto layer = job_.next();
  if (!layer) return fail(layer.error());
  if (!*layer) {
    text_ = write_end(settings_).text;
    stage_ = Stage::kEnd;
    return {};
  }
  next_layer_ = (*layer)->index + 1;
  asked_ = false;
  on_layer_(**layer);
  SLIPSTICK_CHECK((*layer)->program);
  text_ = std::move((*layer)->program->text);
  return {};
}

}  // namespace slipstick
