// What the printer says and is told, for who looks for what is wrong: answers, and the serial log.
#include <catch2/catch.hpp>

#include "host/serve/serial_log.h"
#include "tests/host/serve_fixture.h"
#include "tests/support/live_printer.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

struct Bench {
  Bench() {
    static_cast<void>(
        events.wait("state", [](const json& state) { return state["connected"] == true; }));
  }
  int say(const std::string& line) const {
    return daemon.post("/api/v1/printer/commands", json{{"commands", {line}}}.dump()).status;
  }
  bool hears(const std::string& text) {
    const auto said = [&](const json& log) {
      return log["text"].get<std::string>().find(text) != std::string::npos;
    };
    return !events.wait("log", said).is_null();
  }
  int record(bool on) const {
    return daemon.put("/api/v1/printer/serial-log", json{{"on", on}}.dump()).status;
  }
  std::string lines() const { return daemon.get("/api/v1/printer/serial-log/lines").body; }

  test::TemporaryFolder folder;
  std::string port = (folder.path() / "printer").string();
  test::LivePrinter printer{port};
  test::RunningDaemon daemon{"pty:" + port};
  test::EventReader events{daemon};
};

// A printer that takes five bytes at a time and says what it is given to say.
class Wire final : public Transport {
 public:
  explicit Wire(std::string answer) : answer_(std::move(answer)) {}
  Result<std::size_t> read_some(std::span<char> buffer, std::chrono::microseconds) override {
    const std::size_t size = answer_.copy(buffer.data(), buffer.size());
    answer_.erase(0, size);
    return size;
  }
  Result<std::size_t> write_some(std::string_view bytes, std::chrono::microseconds) override {
    return std::min<std::size_t>(bytes.size(), 5);
  }
  Result<void> write_all(std::string_view, std::chrono::microseconds) override { return {}; }
  void shut_down() noexcept override {}
  std::string_view name() const override { return "wire"; }

 private:
  std::string answer_;
};

}  // namespace

TEST_CASE("Who asks the printer something hears its answer") {
  Bench bench;

  REQUIRE(bench.say("G28") == 204);
  REQUIRE(bench.say("G1 X12.5 Y3 F6000") == 204);
  REQUIRE(bench.say("M114") == 204);

  CHECK(bench.hears("X:12.50 Y:3.00 Z:0.00 E:0.00"));
}

TEST_CASE("All that goes over the wire is written down while somebody wants it, and no longer") {
  Bench bench;
  CHECK(bench.lines().empty());

  REQUIRE(bench.record(true) == 204);
  REQUIRE(bench.say("M118 first") == 204);
  REQUIRE(bench.hears("first"));
  CHECK_THAT(bench.lines(), Contains("M118 first*") && Contains(" < ok"));
  CHECK(test::json_of(bench.daemon.get("/api/v1/printer/serial-log"))["on"] == true);
  REQUIRE(bench.record(false) == 204);
  REQUIRE(bench.say("M118 second") == 204);
  REQUIRE(bench.hears("second"));

  CHECK_THAT(bench.lines(), !Contains("second"));
  CHECK(bench.daemon.put("/api/v1/printer/serial-log", R"({"on": 1})").status == 400);
}

TEST_CASE("A print is written down, too") {
  test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/printer/serial-log", R"({"on": true})").status == 204);
  REQUIRE(daemon.put("/api/v1/files/a.gcode", "G28\nM117 seen\n").status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
  static_cast<void>(events.wait_for_rest());

  CHECK_THAT(daemon.get("/api/v1/printer/serial-log/lines").body,
             Contains("M117 seen*") && Contains(" < start"));
}

TEST_CASE(
    "Bytes become lines as they were said, however they are cut; noise is told by its number") {
  const test::TemporaryFolder folder;
  SerialLog log(folder.path());
  REQUIRE(log.start());
  LoggedTransport printer(std::make_unique<Wire>("ok T:2\x1b[31m\xff\r\n" + std::string(600, 'x')),
                          log);
  std::array<char, 7> buffer{};

  std::string_view out = "N1 G28*18\nM105\n";
  while (!out.empty()) out.remove_prefix(*printer.write_some(out, {}));
  for (int i = 0; i < 90; ++i) REQUIRE(printer.read_some(buffer, {}));

  const std::string text = *log.tail();
  CHECK_THAT(text, Contains(" > N1 G28*18\n") && Contains(" > M105\n"));
  CHECK_THAT(text, Contains(" < ok T:2\\x1b[31m\\xff\n"));
  CHECK_THAT(text, Contains(" < " + std::string(256, 'x') + "\n"));
}

TEST_CASE("The files of the log are bounded, and its end is given from the beginning of a line") {
  const test::TemporaryFolder folder;
  SerialLog log(folder.path());
  REQUIRE(log.start());
  const std::string line = std::string(200, 'y') + "\n";
  for (std::size_t said = 0; said < 3 * SerialLog::kFileMost; said += line.size()) log.sent(line);

  std::uintmax_t size = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
    size += file.file_size();
  }
  CHECK(size <= 2 * (SerialLog::kFileMost + 1024));
  const std::string tail = *log.tail();
  CHECK(tail.size() <= SerialLog::kTailMost);
  CHECK(tail.starts_with("20"));
}

TEST_CASE("A serial log that cannot be written is refused with a reason") {
  SerialLog log("/proc/none");

  const auto started = log.start();

  REQUIRE_FALSE(started);
  CHECK(started.error().code == ErrorCode::kUnavailable);
  CHECK_THAT(started.error().message, Contains("serial.log"));
  CHECK_FALSE(log.is_on());
}
