#include "host/journalled_print.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/gcode/write.h"
#include "core/job/settings_table_text.h"
#include "host/atomic_file.h"
#include "host/checksum.h"

namespace slipstick {
namespace {

std::uint32_t settings_checksum(const PrintSettings& settings) {
  std::string text;
  for (const SettingGroup group : kSettingGroups) text += commented_toml(settings, group);
  return checksum(text);
}

}  // namespace

Result<void> JournalledPrint::identify(const std::filesystem::path& model,
                                       const PrintSettings& settings) {
  if (!header_ && !content_) return {};
  const auto bytes = read_file(model);
  if (!bytes) return fail(bytes.error());
  const std::uint32_t model_sum = checksum(*bytes);
  start_ = write_start(settings).text;
  const std::uint32_t settings_sum = settings_checksum(settings);
  if (header_) {
    header_->model = model_sum;
    header_->settings = settings_sum;
    return {};
  }
  const auto other = [&](std::string_view what) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: {} not what it was when the print began; put the old one back, or "
                            "clear the bed and start again",
                            path_.string(), what));
  };
  if (content_->header.model != model_sum) return other(model.string() + " is");
  if (content_->header.settings != settings_sum) return other("the printer's settings are");
  return {};
}

Result<void> JournalledPrint::keep(std::shared_ptr<SettingsTimeline> timeline) {
  timeline_ = std::move(timeline);
  if (!content_) return {};
  changes_written_ = content_->changes.size();
  const int begun = content_->layers.empty() ? 0 : content_->layers.back().layer + 1;
  const auto taken_up = timeline_->take_up(content_->changes, begun);
  if (!taken_up) return fail(taken_up.error().within(path_.string()));
  return {};
}

Result<void> JournalledPrint::find(Transport& transport, const Clock& clock) {
  if (header_) {
    auto journal = Journal::create(path_, *header_);
    if (!journal) return fail(journal.error());
    journal_.emplace(*std::move(journal));
  }
  if (!content_) return {};
  const auto found = find_session(transport, clock, beyond(*content_));
  if (!found) return fail(found.error());
  auto point = resume_point(*content_, *found, consent_);
  if (!point) return fail(point.error().within(path_.string()));
  point_ = *std::move(point);
  return {};
}

std::optional<LayerMark> JournalledPrint::first_layer() const {
  return content_ ? point_.layer : std::nullopt;
}

Result<LineSource*> JournalledPrint::begin(LineSource& source, const Clock& clock,
                                           StreamOptions& options) {
  if (!header_ && !content_) return &source;
  if (point_.layer) {
    lines_.emplace(source, point_.layer->line, PrintStateTracker(point_.layer->state));
  } else {
    lines_.emplace(source);
  }
  // Motors that are switched off because nobody prints for two minutes lose their place. What was
  // said between prints, or changed in the last, is not meant for this one.
  if (header_) {
    for (const char* text : {"M84 S0", "G90", "M82", "M220 S100", "M221 S100"})
      options.first.push_back(*Line::make(text));
  }
  if (content_) {
    if (const auto ok = go_on(options); !ok) return fail(ok.error().within(path_.string()));
  }
  options.journal = journal_->descriptor();
  options.listeners = {[this](const SenderEvent& event) { journal_->heard(event); },
                       [this, &clock](SenderState, const StreamFigures& figures) {
                         journal_->turn(figures.counters, clock.now());
                       }};
  return &*lines_;
}

Result<void> JournalledPrint::go_on(StreamOptions& options) {
  if (const auto ok = lines_->skip_to(point_.line); !ok) return fail(ok.error());
  if (!same_layer_) {
    return fail(ErrorCode::kInput,
                fmt::format("layer {} would not be what it was; take the print up with the version "
                            "of slipstick that began it",
                            point_.layer->layer));
  }
  auto start = resume_start(point_, *content_, lines_->state(), *options.parking);
  if (!start) return fail(start.error());
  options.sender = std::move(start->sender);
  if (!point_.kept) options.first = board_settings();
  options.first.insert(options.first.end(), start->lines.begin(), start->lines.end());
  options.state = lines_->state();
  auto journal = Journal::go_on(path_, *content_, point_.line);
  if (!journal) return fail(journal.error());
  journal_.emplace(*std::move(journal));
  write_changes();
  if (timeline_) timeline_->go_on();
  return {};
}

// Of the layers that were begun.
void JournalledPrint::write_changes() {
  if (!journal_ || !timeline_) return;
  const auto changes = timeline_->changes();
  for (; changes_written_ < changes.size(); ++changes_written_) {
    if (changes[changes_written_].from_layer > layer_) return;
    journal_->changed(changes[changes_written_]);
  }
}

// What the print has set up before the line where it goes on, for a board that has forgotten it.
std::vector<Line> JournalledPrint::board_settings() const {
  BoardSettings settings;
  std::string_view rest = point_.layer ? std::string_view(start_) : std::string_view();
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const auto line = normalise(rest.substr(0, end));
    if (line && *line) settings.follow(**line);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  for (const Line& line : lines_->settings().lines()) settings.follow(line);
  return settings.lines();
}

void JournalledPrint::began(int layer, std::string_view program) {
  const std::uint32_t sum = checksum(program);
  const auto first = first_layer();
  if (first && first->layer == layer) same_layer_ = sum == first->program;
  layer_ = layer;
  write_changes();
  if (journal_ && lines_) journal_->began({layer, lines_->line(), sum, lines_->state().state()});
}

void JournalledPrint::ended(const Result<StreamOutcome>& outcome) {
  if (!journal_) return;
  if (outcome) journal_->ended(JournalEnd::kFinished);
  // Whatever else ends a print, a safe stop was sent.
  const auto out_of_reach = [](ErrorCode code) {
    return code == ErrorCode::kDisconnected || code == ErrorCode::kTimedOut ||
           code == ErrorCode::kPrinter;
  };
  if (!outcome && !out_of_reach(outcome.error().code)) journal_->ended(JournalEnd::kStopped);
}

}  // namespace slipstick
