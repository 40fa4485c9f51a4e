#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/clock.h"
#include "drivers/marlin/line.h"
#include "drivers/marlin/line_splitter.h"
#include "drivers/marlin/position.h"
#include "drivers/marlin/reply.h"
#include "drivers/marlin/sender_events.h"
#include "drivers/marlin/sent_lines.h"

namespace slipstick {

/// A count of lines that another sender began, as a SessionProbe finds it.
struct KeptSession {
  LineNumber last = 0;    ///< The last line that the printer has taken.
  PositionTracker place;  ///< After it.
};

struct SenderOptions {
  /// How long a board that resets when its port is opened may take to say `start`.
  Moment banner_wait = std::chrono::milliseconds(2500);
  /// Seconds between temperature reports, 1 to 60.
  int report_seconds = 2;
  /// The number of the M110. From 10,000 on, damage that makes a G, M or T of the N gives no
  /// command that any firmware has: N28 could become G28, N112 a kill.
  LineNumber first_number = 10'000;
  /// Bytes of moves that may be under way to the printer; 0 is one line at a time. At most
  /// kWindowMax. A window keeps the wire full, but where a line in it is damaged, what a board
  /// obeys of the lines behind cannot be taken back: the print ends then, and says so.
  int window = 0;
  /// Lines that must be acknowledged one by one, with nothing odd, before it opens, and opens
  /// again.
  int proving = 64;
  /// Goes on with that count, without a greeting.
  std::optional<KeptSession> kept;
};

/// Takes the lines of a job to a Marlin: each executed exactly once, in order, over a wire that
/// damages and loses bytes both ways.
///
/// A pure state machine: bytes and time go in, bytes come out; no thread, no I/O, no clock. One
/// line is in flight at a time, or, where a window is asked for and the wire has proved good, moves
/// as long as the window (sender_window.cpp). `ok`s are hints and never counted: the truth is
/// Marlin's own rule that a numbered line is executed only as the successor of the last (see
/// SentLines), and the sender finds out where the printer stands by sending a new number and
/// reading which one it would rather have.
///
/// Use: call `take_output` after every other call and whenever `wakeup` has come, and write what it
/// gives; `push` a line while `wants_line`.
class Sender {
 public:
  /// Probes after one silence; the n-th waits 2^n times as long as the first. As many fit into the
  /// receive buffer of a board that is merely busy.
  static constexpr int kMaxProbes = 5;
  /// A printer that says anything within this time is not given up, whatever it owes.
  static constexpr Moment kAliveWindow = std::chrono::seconds(60);
  /// But not for longer than this without an answer, and without a word that it is busy or heating:
  /// what still reports temperatures may have stopped listening.
  static constexpr Moment kDeafMax = std::chrono::minutes(30);
  /// Requests to send again without a step forward.
  static constexpr int kMaxRewinds = 40;
  /// Requests for lines that cannot be meant, in a row: the number was damaged, or the board was
  /// reset.
  static constexpr int kMaxOddRequests = 4;
  /// Questions about one line that may have been executed though it was refused.
  static constexpr int kMaxQuestions = 20;
  static constexpr int kGreetingAttempts = 10;
  /// How often a printer that is killed, or given up, is told so: noise may eat any of them.
  static constexpr int kEmergencyStops = 5;
  static constexpr int kSafeStops = 20;
  static constexpr std::size_t kMaxEvents = 256;
  /// The receive buffer of the smallest boards holds 127 bytes.
  static constexpr int kWindowMax = 120;
  /// Lines in a window, and after how many of them a question proves that all were taken.
  static constexpr LineNumber kWindowLines = 16;
  static constexpr LineNumber kProofEvery = 24;

  explicit Sender(SenderOptions options = {});

  /// Bytes came from the printer.
  void receive(std::string_view bytes, Moment now);

  /// What to write now, maybe nothing. The first call begins the greeting.
  [[nodiscard]] std::string take_output(Moment now);

  /// When to call `take_output` again though nothing happened; never, if nothing.
  [[nodiscard]] std::optional<Moment> wakeup() const;

  [[nodiscard]] SenderState state() const;
  /// Why the state is kHalted or kLost: one line for a person.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] const SenderCounters& counters() const { return counters_; }

  /// Whether there is room for a line of the job.
  [[nodiscard]] bool wants_line() const;
  /// The next line of the job, or one that its owner puts between them: those are executed in the
  /// same order, but not counted. \pre wants_line().
  void push(Line line, LineOwner owner = LineOwner::kJob);
  /// No more lines come. The state becomes kDone once all were surely accepted.
  void end_of_job();

  /// Gives the job up: no line that was not sent yet, then heaters, fan and motors off, then kDone.
  /// Cuts waiting for a heater short on boards with an emergency parser.
  void stop();
  /// Kills the printer at once. The state becomes kHalted.
  void emergency_stop();
  /// Whether the printer said that it has stopped itself.
  [[nodiscard]] bool printer_stopped() const { return printer_stopped_; }
  /// Gives the printer up: the state becomes kLost.
  void abandon(std::string reason);

  /// What happened since the last call, oldest first, at most `kMaxEvents`.
  [[nodiscard]] std::vector<SenderEvent> take_events();

 private:
  /// The time after trouble in which nothing is sent, so that all answers under way arrive.
  struct Drain {
    Moment began;
    std::optional<LineNumber> requested;  ///< By a Resend.
    std::optional<LineNumber> last_line;  ///< By an Error.
    bool refused = false;                 ///< Any of the two came, readable or not.
    bool several = false;                 ///< More than one line was under way.
    bool mismatch = false;  ///< By a whole "checksum mismatch": nothing of the line was executed.
  };

  /// A line that was refused, and yet may have been executed. It is not sent before that is known.
  struct Doubt {
    LineNumber line = 0;
    int questions = 0;
    std::optional<Position> report;  ///< The last one.
  };

  // sender.cpp: time.
  void advance(Moment now);
  void step(Moment now);
  void send_next(Moment now);
  [[nodiscard]] bool bind_next(Moment now);
  void ask_for_reports(int seconds);
  LineNumber bind(std::string text, LineOwner owner);
  void trust(LineNumber number);
  void transmit(Moment now);

  // sender_window.cpp: several lines under way.
  [[nodiscard]] bool has_room_behind() const;
  [[nodiscard]] bool wants_proof() const;
  [[nodiscard]] std::optional<LineNumber> answered(const Ok& ok) const;
  void prove(LineNumber number);
  [[nodiscard]] LineNumber first_move_from(LineNumber number) const;
  void say_last_words(Moment now);
  void tell(SenderEvent event);
  void give_up(SenderState state, std::string reason);
  [[nodiscard]] bool over() const { return fate_.has_value(); }
  [[nodiscard]] bool idle() const;

  // sender_greeting.cpp: from silence to the first line of a job.
  void listen(Moment now, Moment patience);
  void listen_to_banner(Moment now);
  void say_hello(Moment now);
  void greet_again(Moment now);
  [[nodiscard]] bool bind_greeting(Moment now);

  // sender_replies.cpp: what the printer says.
  void handle(const Reply& reply, Moment now);
  void on(const Ok& ok, Moment now);
  void on(const Resend& resend, Moment now);
  void on(const LineError& error, Moment now);
  void on(const Fatal& fatal, Moment now);
  void on(const ErrorText& error, Moment now);
  void on(const Busy& busy, Moment now);
  void on(const UnknownCommand& command, Moment now);
  void on(const Echo& echo, Moment now);
  void on(const Action& action, Moment now);
  void on(const PositionReport& report, Moment now);
  void on(const FirmwareName& firmware, Moment now);
  void on(const Capability& capability, Moment now);
  void on(const Temperatures& temperatures, Moment now);
  void on(const Start& start, Moment now);
  void on(const Wait& wait, Moment now);
  void on(const Unknown& unknown, Moment now);
  [[nodiscard]] bool asked_for_temperatures() const;
  [[nodiscard]] bool may_answer(const Ok& ok, LineNumber number) const;
  void acknowledge(LineNumber number, Moment now);
  void stay_patient(Moment now);

  // sender_recovery.cpp: finding out where the printer stands.
  void start_drain(Moment now);
  [[nodiscard]] Moment drain_end() const;
  void finish_drain(Moment now);
  [[nodiscard]] bool can_be_next(std::optional<LineNumber> number) const;
  void rewind(LineNumber number);

  // sender_ghosts.cpp: a refused line whose tail was obeyed.
  struct Refusal {
    bool whole = false;    ///< Nothing of the line was executed.
    bool lost = false;     ///< It never came.
    bool several = false;  ///< Others were under way behind it.
  };
  void doubt(LineNumber next, const Refusal& refusal);
  [[nodiscard]] bool ask_about_doubt();

  void on_odd_request(std::optional<LineNumber> number, Moment now);
  void on_silence(Moment now);
  /// A blocking command may be running still: what was taken for its `ok` is not proved to be that.
  [[nodiscard]] bool may_be_blocked() const;
  void ask_for_truth(Moment now);
  void probe(Moment now);

  const SenderOptions options_;
  LineSplitter splitter_;
  std::string output_;
  std::vector<SenderEvent> events_;
  SenderCounters counters_;
  std::optional<SenderState> fate_;  ///< kHalted or kLost, for good.
  std::string reason_;
  bool printer_stopped_ = false;
  std::string last_words_;    ///< For a printer that is killed or given up,
  int last_words_left_ = 0;   ///< this often,
  Moment next_last_words_{};  ///< from then on.

  // Greeting.
  bool greeting_ = true;
  bool started_ = false;
  std::optional<Moment> listening_until_;
  Moment listening_since_{};
  bool booting_ = false;
  bool heard_ = false;  ///< Anything at all.
  int attempts_ = 0;
  int name_requests_ = 0;
  std::string firmware_;
  bool reports_ = false;    ///< The printer can report temperatures by itself…
  bool reporting_ = false;  ///< …and does,
  Moment next_poll_{};      ///< otherwise it is asked, this often.

  // The sequence.
  SentLines lines_;
  LineNumber cursor_ = 0;     ///< The number to send next.
  LineNumber first_ = 0;      ///< The number of the M110.
  LineNumber accepted_ = -1;  ///< Believed to be the last the printer took.
  LineNumber sure_ = -1;  ///< Known to be taken; a request for it or less is nonsense or a reset.
  LineNumber last_clean_ = -2;  ///< The last that was acknowledged with nothing odd around it.
  std::optional<LineNumber> outstanding_;  ///< The first that is not answered.
  bool unproven_ = false;  ///< Several were, and no proof came since: more may be than is known.
  bool several_ = false;   ///< Those up to the cursor are under way as well.
  int proven_ = 0;         ///< Acknowledged in a row, with nothing odd.
  LineNumber proof_ = 0;   ///< The last line that asked for a proof.
  bool odd_text_ = false;  ///< Something unreadable came since the outstanding line was sent.
  Moment sent_at_{};
  Moment deadline_{};
  Moment patience_{};
  Moment last_heard_{};
  Moment last_heeded_{};  ///< Something was acknowledged, or takes its time.
  std::optional<Drain> drain_;
  std::optional<Doubt> doubt_;
  std::string busy_with_;           ///< By its last word.
  int position_requests_ = 0;       ///< In a row, before two reports agree.
  std::optional<Position> learnt_;  ///< The last report.
  int loose_ends_ = 0;  ///< What came since the last line but probes, that may have been an `ok`.
  int probes_ = 0;
  int rewinds_ = 0;
  int odd_requests_ = 0;

  // The job.
  std::optional<Line> queued_;
  LineOwner queued_for_ = LineOwner::kJob;
  std::vector<Line> stop_lines_;       ///< In reverse.
  std::optional<LineNumber> closing_;  ///< The M105 whose answer proves that the job was taken.
  bool ended_ = false;
  bool done_ = false;
};

}  // namespace slipstick
