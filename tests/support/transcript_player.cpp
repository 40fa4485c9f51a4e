// A transcript said again to a simulated printer.
#include "tests/support/transcript_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "tests/support/bench_cable.h"
#include "tests/support/printer_ear.h"

namespace slipstick::test {
namespace {

using Kind = TranscriptLine::Kind;

constexpr Moment kQuiet{100'000};
constexpr Moment kPatience{600'000'000};
constexpr Moment kBoot{1'000'000};
constexpr std::string_view kNothing = "nothing";

double seconds(Moment m) {
  return std::chrono::duration<double>(m).count();
}

/// What the host says at once, and what is answered.
struct Exchange {
  const TranscriptLine* said = nullptr;  ///< Its first line; none in what begins with a banner.
  std::string bytes;
  bool resets = false;  ///< Before it.
  std::vector<const TranscriptLine*> answers;

  /// Whether nobody wrote down what the printer says when it is switched on.
  [[nodiscard]] bool is_boot() const { return answers.empty() && (said == nullptr || resets); }

  [[nodiscard]] const TranscriptLine* last() const {
    return answers.empty() ? said : answers.back();
  }
};

/// "reset", "reset 1", "reset: host opened the port".
bool is_reset(const TranscriptLine& line) {
  return line.kind == Kind::kBench && line.text.starts_with("reset");
}

/// Whether the clock went back because only the bench's port was opened anew.
bool is_unplugged(const TranscriptLine& line) {
  return line.kind == Kind::kBench && line.text.starts_with("port gone");
}

/// Whether `line` begins something new after `before`.
bool begins_exchange(const TranscriptLine& line, const Exchange& before) {
  const TranscriptLine* last = before.last();
  if (last == nullptr) return line.kind != Kind::kPrinter;
  if (line.at && last->at && *line.at < *last->at) return true;
  const bool at_once = line.at && line.at == last->at && before.answers.empty();
  return line.kind != Kind::kPrinter && !at_once;
}

std::vector<Exchange> exchanges_of(const std::vector<TranscriptLine>& lines) {
  std::vector<Exchange> exchanges(1);
  for (const TranscriptLine& line : lines) {
    if (begins_exchange(line, exchanges.back())) {
      const TranscriptLine* last = exchanges.back().last();
      const bool back =
          last != nullptr && line.at && last->at && *line.at < *last->at && !is_unplugged(*last);
      exchanges.emplace_back();
      if (line.kind != Kind::kPrinter) exchanges.back().said = &line;
      exchanges.back().resets = back;
    }
    Exchange& now = exchanges.back();
    if (line.kind == Kind::kHost) now.bytes += line.text;
    if (line.kind == Kind::kPrinter) now.answers.push_back(&line);
    now.resets = now.resets || is_reset(line);
  }
  return exchanges;
}

/// How long after the start of `exchange` its answer `line` was written down.
std::optional<double> delay_of(const Exchange& exchange, const TranscriptLine& line) {
  if (exchange.said == nullptr || !exchange.said->at || !line.at) return std::nullopt;
  return seconds(*line.at - *exchange.said->at);
}

/// How long the host is silent between `exchange` and the `next` one.
Moment pause_between(const Exchange& exchange, const Exchange& next) {
  if (exchange.is_boot()) return kBoot;
  const TranscriptLine* last = exchange.last();
  const bool written = last->at && next.said != nullptr && next.said->at && !next.resets;
  return written ? *next.said->at - *last->at : kQuiet;
}

/// "nozzle open", "bed cold"; anything else is nothing that can be done.
void do_to(Printer& printer, const std::string& what) {
  const std::pair<std::string_view, Heater Machine::*> heaters[] = {{"nozzle", &Machine::nozzle},
                                                                    {"bed", &Machine::bed}};
  const std::pair<std::string_view, HeaterDefect> defects[] = {
      {"open", HeaterDefect::kSensorOpen},
      {"short", HeaterDefect::kSensorShorted},
      {"cold", HeaterDefect::kCold},
      {"stuck", HeaterDefect::kStuck}};
  for (const auto& [part, heater] : heaters) {
    for (const auto& [word, defect] : defects) {
      if (what == fmt::format("{} {}", part, word)) printer.break_heater(heater, defect);
    }
  }
}

class Player {
 public:
  Player(const PrinterOptions& options, const Tolerance& tolerance)
      : options_(options), tolerance_(tolerance), ear_(options) {}

  void play(const Exchange& exchange, Moment pause) {
    if (exchange.resets) ear_ = PrinterEar(options_);
    heard_.clear();
    if (exchange.said != nullptr && exchange.said->kind == Kind::kBench) {
      bench(exchange.said->text);
    }
    const Moment began = ear_.printer().now();
    const std::string through = cable_.to_board(exchange.bytes);
    if (!through.empty()) ear_.printer().receive(through, began);
    Moment last = began;
    while (heard_.size() < exchange.answers.size()) {
      const auto line = ear_.next_line(began + patience(exchange));
      if (!line) break;
      last = line->at;
      hear(*line, began);
    }
    while (const auto line = ear_.next_line(last + pause)) hear(*line, began);
    if (!exchange.is_boot()) compare(exchange);
  }

  [[nodiscard]] const std::vector<Difference>& differences() const { return differences_; }

 private:
  /// Something is done to the cable or to the printer; "say X" comes as if from the printer.
  void bench(const std::string& words) {
    if (words.starts_with("say ")) heard_.push_back({Moment(0), words.substr(4)});
    if (!cable_.command(words)) do_to(ear_.printer(), words);
  }

  void hear(const PrinterEar::Heard& line, Moment began) {
    for (std::string& text : cable_.to_host(line.text)) {
      heard_.push_back({line.at - began, std::move(text)});
    }
  }

  [[nodiscard]] double allowed(double delay) const {
    return tolerance_.seconds + tolerance_.share * delay;
  }

  [[nodiscard]] Moment patience(const Exchange& exchange) const {
    const auto delay =
        exchange.answers.empty() ? std::nullopt : delay_of(exchange, *exchange.answers.back());
    if (!delay) return kPatience;
    return Moment(static_cast<Moment::rep>((*delay + 2 * allowed(*delay)) * 1e6));
  }

  /// Stops at the first line that differs: those behind it would only be out of step.
  void compare(const Exchange& exchange) {
    const auto& answers = exchange.answers;
    for (std::size_t i = 0; i < std::max(answers.size(), heard_.size()); ++i) {
      const bool expects = i < answers.size();
      const bool hears = i < heard_.size();
      std::string expected(expects ? answers[i]->text : kNothing);
      if (expects) expected.erase(0, cable_.take_noise());
      std::string heard(hears ? heard_[i].text : kNothing);
      if (expects && hears && says_the_same(heard, expected, tolerance_)) {
        const auto delay = delay_of(exchange, *answers[i]);
        const double came = seconds(heard_[i].at);
        if (!delay || std::abs(came - *delay) <= allowed(*delay)) continue;
        expected += fmt::format(" after {:.2f} s", *delay);
        heard += fmt::format(" after {:.2f} s", came);
      }
      const TranscriptLine* said = exchange.said;
      differences_.push_back({said != nullptr ? said->number : exchange.answers.front()->number,
                              exchange.bytes.substr(0, exchange.bytes.find('\n')),
                              std::move(expected), std::move(heard)});
      return;
    }
  }

  PrinterOptions options_;
  Tolerance tolerance_;
  PrinterEar ear_;
  BenchCable cable_;
  std::vector<PrinterEar::Heard> heard_;  ///< In this exchange, since its start.
  std::vector<Difference> differences_;
};

}  // namespace

std::string text_of(const Difference& d) {
  return fmt::format("line {}: \"{}\": expected {}, heard {}", d.line, d.said, d.expected, d.heard);
}

std::vector<Difference> play_transcript(const std::vector<TranscriptLine>& lines,
                                        const PrinterOptions& options, const Tolerance& tolerance) {
  const std::vector<Exchange> exchanges = exchanges_of(lines);
  Player player(options, tolerance);
  for (std::size_t i = 0; i < exchanges.size(); ++i) {
    const bool is_last = i + 1 == exchanges.size();
    player.play(exchanges[i], is_last ? kQuiet : pause_between(exchanges[i], exchanges[i + 1]));
  }
  return player.differences();
}

}  // namespace slipstick::test
