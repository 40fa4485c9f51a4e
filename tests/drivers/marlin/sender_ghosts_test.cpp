#include <catch2/catch.hpp>

#include "tests/drivers/marlin/sender_talk.h"
#include "tests/support/marlin_model_voyage.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

const std::string kText = "G1 X1.5 E.4";
const std::vector<std::string> kJob{"G28", "M83", kText, "M104 S1"};

/// A byte of what the printer says from the line on.
struct BadReply {
  std::size_t at = 0;
  char byte = 0;
};

/// A printer that is handed `damaged` instead of the line with `kText`, once; the rest is clean,
/// but for one byte of its replies.
class Substitution {
 public:
  Substitution(MarlinModelOptions options, std::string damaged, std::optional<BadReply> reply)
      : printer_(options, 1), damaged_(std::move(damaged)), bad_reply_(reply) {}

  SenderState print() {
    std::size_t next = 0;
    for (int step = 0; step < 5000; ++step) {
      while (next < kJob.size() && sender_.wants_line()) sender_.push(*Line::make(kJob[next++]));
      if (next == kJob.size()) sender_.end_of_job();
      take_turn();
      const SenderState state = sender_.state();
      if (state == SenderState::kDone || state == SenderState::kLost) return state;
    }
    return sender_.state();
  }

  std::vector<std::string> executed() const { return job_lines(printer_.executed()); }
  const Sender& sender() const { return sender_; }
  std::size_t replied() const { return replied_; }

 private:
  void take_turn() {
    std::string sent = sender_.take_output(now_);
    printer_.announce(sent);
    if (!replaced_ && sent.find(kText) != std::string::npos) {
      replaced_ = true;
      sent = damaged_;
    }
    printer_.hear(sent, now_);
    std::string said = printer_.speak(now_);
    if (replaced_) spoil(said);
    now_ += std::chrono::milliseconds(2);
    sender_.receive(said, now_);
    if (said.empty()) pass_time();
  }

  void spoil(std::string& said) {
    const std::size_t before = replied_;
    replied_ += said.size();
    if (!bad_reply_ || bad_reply_->at < before || bad_reply_->at >= replied_) return;
    said[bad_reply_->at - before] = bad_reply_->byte;
  }

  void pass_time() {
    Moment next = sender_.wakeup().value_or(now_ + std::chrono::milliseconds(100));
    if (const auto event = printer_.next_event()) next = std::min(next, *event);
    now_ = std::max(now_ + Moment(1), next);
  }

  Sender sender_;
  MarlinModel printer_;
  std::string damaged_;
  std::optional<BadReply> bad_reply_;
  Moment now_{};
  std::size_t replied_ = 0;
  bool replaced_ = false;
};

/// \return how many bytes the printer said from the line on.
std::size_t check_exact(MarlinModelOptions options, const std::string& damaged,
                        std::optional<BadReply> reply = {}) {
  Substitution line(options, damaged, reply);
  const SenderState end = line.print();
  INFO("damaged to: " << Catch::StringMaker<std::string>::convert(damaged) << " reply "
                      << (reply ? reply->at : 0) << " is " << (reply ? int{reply->byte} : 0)
                      << " reason " << line.sender().reason());
  REQUIRE(end == SenderState::kDone);
  REQUIRE(line.executed() == kJob);
  return line.replied();
}

const std::vector<MarlinModelOptions> kBoards{
    {.undetected = Undetected::kObeyGhosts, .flush = Flush::kAll},
    {.undetected = Undetected::kObeyGhosts, .flush = Flush::kNothing},
    {.swallows_duplicates = false,
     .ok_after_resend = false,
     .undetected = Undetected::kObeyGhosts,
     .flush = Flush::kNothing}};

std::string clean_line() {
  // M110, M115 and M155, then the job.
  return frame(10'005, kText);
}

/// The number's blank became a newline: the move is obeyed, the number refused.
std::string cut_line() {
  std::string line = clean_line();
  line[line.find(' ')] = '\n';
  return line;
}

TEST_CASE("Any byte of a line changed to any other: the job is executed once and in order") {
  const std::string clean = clean_line();
  for (const MarlinModelOptions& board : kBoards) {
    for (std::size_t at = 0; at < clean.size(); ++at) {
      for (int byte = 0; byte < 256; ++byte) {
        std::string damaged = clean;
        damaged[at] = static_cast<char>(byte);
        check_exact(board, damaged);
      }
    }
  }
}

TEST_CASE("Any byte lost, and a newline put anywhere: the job is executed once and in order") {
  const std::string clean = clean_line();
  for (const MarlinModelOptions& board : kBoards) {
    for (std::size_t at = 0; at < clean.size(); ++at) {
      check_exact(board, std::string(clean).erase(at, 1));
      check_exact(board, std::string(clean).insert(at, 1, '\n'));
    }
  }
}

TEST_CASE("Any byte of the reply changed to any other: the job is executed once and in order") {
  for (std::size_t at = 0; at < 3; ++at) {
    for (int byte = 0; byte < 256; ++byte) {
      check_exact(kBoards[0], clean_line(), BadReply{at, static_cast<char>(byte)});
    }
  }
}

TEST_CASE("Any byte changed of all that is said about a cut line: executed once and in order") {
  for (const MarlinModelOptions& board : kBoards) {
    const std::size_t replied = check_exact(board, cut_line());
    for (std::size_t at = 0; at < replied; ++at) {
      for (const char byte : {'\n', '\0', ' ', '0', '1', '5', 'o', 'k', '\xff'}) {
        check_exact(board, cut_line(), BadReply{at, byte});
      }
    }
  }
}

// One move is made, and `move` comes without its number.
void refuse_second_move(Talk& talk, const char* move) {
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.job(move);
  talk.expects(frame(4, move));
  talk.refuses(3, "No Checksum with line number");
}

TEST_CASE("A move that was obeyed though its line was refused is not made again") {
  Talk talk;
  refuse_second_move(talk, "G1 X2 E.4");
  talk.says("ok");
  talk.is_asked_and_stands_at(4, "X:2.00 Y:0.00 Z:0.00 E:0.40");

  talk.expects(frame(6, "M105"));
  talk.says("ok T:20.00 /0.00");
  talk.job("G1 X3");
  talk.expects(frame(7, "G1 X3"));
  CHECK(talk.sender.counters().ghosts == 1);
  CHECK(talk.sender.counters().lines_acknowledged == 2);
}

TEST_CASE("A retraction is told from none because the printer was asked where its extruder is") {
  Talk talk;
  talk.greet();
  talk.prints(3, "M83");
  talk.job("G1 E-1");
  talk.is_asked_and_stands_at(4, "X:0.00 Y:0.00 Z:0.00 E:7.00");
  talk.expects(frame(6, "G1 E-1"));

  talk.refuses(5, "No Checksum with line number");
  talk.is_asked_and_stands_at(6, "X:0.00 Y:0.00 Z:0.00 E:7.00");

  talk.expects(frame(8, "G1 E-1"));
}

TEST_CASE("Reports that fit neither place end the print, as what they tell is not known") {
  Talk talk;
  refuse_second_move(talk, "G1 X2");
  talk.silence(60ms);

  for (LineNumber question = 4; question < 4 + Sender::kMaxQuestions; ++question) {
    talk.expects(frame(question, "M114"));
    talk.says("X:7.00 Y:0.00 Z:0.00 E:0.40 Count X:0 Y:0 Z:0");
    talk.says("ok");
  }
  (void)talk.sender.take_output(talk.now);

  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK_THAT(talk.sender.reason(), Catch::StartsWith("line 24 (G1 X2) was damaged on its way"));
}

TEST_CASE("A line that may not be given twice and leaves no trace is not sent again") {
  Talk talk;
  talk.greet();
  talk.job("M290 Z0.1");
  talk.expects(frame(3, "M290 Z0.1"));
  const bool whole = GENERATE(true, false);

  talk.refuses(2, whole ? "checksum mismatch" : "No Checksum with line number");
  talk.silence(60ms);
  const std::string sent = talk.sender.take_output(talk.now);

  CHECK((sent == frame(3, "M290 Z0.1")) == whole);
  CHECK((talk.sender.state() == SenderState::kLost) == !whole);
}

}  // namespace
}  // namespace slipstick
