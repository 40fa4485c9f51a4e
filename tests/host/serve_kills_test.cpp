// kill -9 at moments drawn from a seed, in the middle of uploads, changes of the queue and prints:
// nothing that was accepted is lost, nothing is half there, nothing is printed twice.
// SLIPSTICK_KILLS=100 for as many; SLIPSTICK_SEED=S for another voyage.
#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "core/base/rng.h"
#include "host/atomic_file.h"
#include "host/serve/store.h"
#include "tests/support/daemon_process.h"
#include "tests/support/environment.h"
#include "tests/support/http_client.h"
#include "tests/support/obedient_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using nlohmann::json;

namespace {

constexpr std::uint64_t kNames = 5;
constexpr std::uint64_t kNothing = 0;  // among programs

std::string name_of(std::uint64_t number) {
  return "part" + std::to_string(number) + ".gcode";
}

// A program that says whose it is, and is long enough to be cut off.
std::string program(std::uint64_t number) {
  std::string text = "M117 part" + std::to_string(number) + "\n";
  for (int i = 0; i < 400; ++i) text += "G1 X" + std::to_string(i % 9) + "\n";
  return text;
}

// Which program a file is, whole to the last byte; kNothing if it is none.
std::uint64_t program_in(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text || !text->starts_with("M117 part")) return kNothing;
  const std::uint64_t number = std::stoull(text->substr(9));
  return *text == program(number) ? number : kNothing;
}

struct Request {
  std::string method;
  std::string target;
  std::string body = {};

  [[nodiscard]] std::string text() const {
    return method + " " + target +
           " HTTP/1.1\r\nHost: localhost\r\nContent-Length: " + std::to_string(body.size()) +
           "\r\n\r\n" + body;
  }
};

/// What the daemon has accepted and, of what it was asked last, may have. Every program is uploaded
/// once and queued once, by attempt: so the printer's commands tell how often a job was printed.
class Ledger {
 public:
  explicit Ledger(Rng& rng) : rng_(rng) {
    for (std::uint64_t i = 0; i < kNames; ++i) content_[name_of(i)] = {kNothing};
  }

  // Each returns a request, if there is reason for one, of which nobody knows yet what it does.
  Request upload() {
    const std::string name = any_name();
    content_[name].insert(++programs_);
    asked_ = {Kind::kUpload, name, programs_, 0};
    return {"PUT", "/api/v1/files/" + name, program(programs_)};
  }
  std::optional<Request> remove() {
    const std::string name = any_name();
    if (!known(name)) return {};
    content_[name].insert(kNothing);
    asked_ = {Kind::kRemove, name, kNothing, 0};
    return Request{"DELETE", "/api/v1/files/" + name};
  }
  std::optional<Request> queue() {
    const std::string name = any_name();
    const auto number = known(name);
    if (!number || attempted_ || !queued_.insert(*number).second) return {};
    attempted_ = Attempt{name, *number};
    asked_ = {Kind::kQueue, name, *number, 0};
    if (rng_.below(2) == 0) return Request{"POST", "/api/v1/jobs", json{{"file", name}}.dump()};
    return Request{"POST", "/api/files/local/" + name, R"({"command": "select", "print": true})"};
  }
  std::optional<Request> cancel() {
    if (jobs_.empty()) return {};
    auto at = jobs_.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(rng_.below(jobs_.size())));
    asked_ = {Kind::kCancel, "", 0, at->first};
    return Request{"POST", "/api/v1/jobs/" + std::to_string(at->first) + "/cancel"};
  }

  // What was asked last was answered.
  void answered(int status, std::int64_t newest_job) {
    INFO("asked for " << asked_.name << " " << asked_.program);
    switch (asked_.kind) {
      case Kind::kUpload:
        REQUIRE(status == 201);
        content_[asked_.name] = {asked_.program};
        return;
      case Kind::kRemove:
        REQUIRE(status == 204);
        content_[asked_.name] = {kNothing};
        return;
      case Kind::kQueue:
        REQUIRE((status == 201 || status == 204));
        REQUIRE(jobs_.emplace(newest_job, asked_.program).second);
        attempted_.reset();
        return;
      case Kind::kCancel:
        REQUIRE((status == 204 || status == 409));  // or it was over
        if (status == 204) cancelled_.insert(asked_.job);
    }
  }

  // What there is, after a start.
  void check_files(Store& store) {
    for (auto& [name, may_be] : content_) {
      const auto file = store.file(name);
      REQUIRE(file);
      const std::uint64_t is =
          *file ? program_in(store.path_of((*file)->id, (*file)->extension)) : kNothing;
      INFO(name << " is " << is);
      CHECK(may_be.contains(is));
      if (*file) CHECK(is != kNothing);
      may_be = {is};
    }
  }

  void check_jobs(Store& store, const std::vector<std::string>& commands) {
    const auto listed = store.jobs(1'000);
    REQUIRE(listed);
    std::set<std::int64_t> there;
    for (const StoredJob& job : *listed) {
      there.insert(job.id);
      if (!jobs_.contains(job.id)) adopt(job.id);
      check_job(job, jobs_.at(job.id), store, commands);
    }
    for (const auto& [id, number] : jobs_) CHECK(there.contains(id));
    attempted_.reset();
  }

  [[nodiscard]] std::int64_t printed() const { return printed_; }
  [[nodiscard]] auto ended_as(const std::string& state) const {
    return std::ranges::count_if(over_, [&](const auto& job) { return job.second == state; });
  }

 private:
  enum class Kind : std::uint8_t { kUpload, kRemove, kQueue, kCancel };
  struct Attempt {
    std::string name;
    std::uint64_t program = 0;
  };
  struct Asked {
    Kind kind = Kind::kUpload;
    std::string name;
    std::uint64_t program = 0;
    std::int64_t job = 0;
  };

  // Not one that is being queued: it would be open which content the job has.
  std::string any_name() {
    const std::uint64_t at = rng_.below(kNames);
    const std::string name = name_of(at);
    return attempted_ && attempted_->name == name ? name_of((at + 1) % kNames) : name;
  }

  // The content of a file of which there is no doubt.
  std::optional<std::uint64_t> known(const std::string& name) {
    const auto& may_be = content_[name];
    if (may_be.size() != 1 || may_be.contains(kNothing)) return {};
    return *may_be.begin();
  }

  // A job that was asked for when the end came.
  void adopt(std::int64_t id) {
    INFO("job " << id);
    REQUIRE(attempted_);
    jobs_.emplace(id, std::exchange(attempted_, std::nullopt)->program);
  }

  void check_job(const StoredJob& job, std::uint64_t number, const Store& store,
                 const std::vector<std::string>& commands) {
    const std::string state(name_of(job.state));
    INFO("job " << job.id << ", part" << number << ", " << state);
    const auto times = std::ranges::count(commands, "M117 part" + std::to_string(number));
    CHECK(times <= 1);
    if (state == "done") CHECK(times == 1);
    if (state == "queued") CHECK(program_in(store.path_of(job.file, job.extension)) == number);
    if (cancelled_.contains(job.id)) CHECK(state != "queued");
    CHECK(state != "failed");
    if (const auto before = over_.find(job.id); before != over_.end()) {
      CHECK(before->second == state);
    } else if (state != "queued" && state != "printing") {
      over_.emplace(job.id, state);
      printed_ += times;
    }
  }

  Rng& rng_;
  Asked asked_;
  std::uint64_t programs_ = 0;
  std::map<std::string, std::set<std::uint64_t>> content_;
  std::set<std::uint64_t> queued_;
  std::optional<Attempt> attempted_;  // what may have become a job
  std::map<std::int64_t, std::uint64_t> jobs_;
  std::set<std::int64_t> cancelled_;
  std::map<std::int64_t, std::string> over_;
  std::int64_t printed_ = 0;
};

class Voyage {
 public:
  explicit Voyage(std::uint64_t seed) : rng_(seed), ledger_(rng_) {}

  // Looks at what is there, does something, and ends in the middle of more.
  void live_and_die() {
    test::DaemonProcess daemon(folder_.path(), printer_.address());
    check();
    const std::uint64_t requests = 2 + rng_.below(8);
    for (std::uint64_t i = 0; i < requests; ++i) act(daemon.port());
    print_on(daemon.port(), rng_.below(600));
    std::deque<test::HttpClient> unanswered;
    for (std::uint64_t i = 0; i <= rng_.below(3); ++i) {
      const auto request = some_request();
      if (!request) continue;
      const std::string text = request->text();
      const bool whole = rng_.below(2) == 0;
      unanswered.emplace_back(daemon.port())
          .send(text.substr(0, whole ? text.size() : 1 + rng_.below(text.size())));
    }
    if (!unanswered.empty()) {
      static_cast<void>(unanswered.front().ended_within(std::chrono::milliseconds(rng_.below(12))));
    }
    CHECK(daemon.end(SIGKILL) == 128 + SIGKILL);
  }

  // What a few kills come upon is up to the machine; many come upon everything.
  void arrive(std::uint64_t kills) {
    constexpr std::uint64_t kMany = 50;
    test::DaemonProcess daemon(folder_.path(), printer_.address());
    check();
    INFO("printed " << ledger_.printed() << ", done " << ledger_.ended_as("done")
                    << ", interrupted " << ledger_.ended_as("interrupted") << ", cancelled "
                    << ledger_.ended_as("cancelled"));
    if (kills >= kMany) {
      CHECK(ledger_.printed() > 0);
      CHECK(ledger_.ended_as("interrupted") > 0);
    }
    CHECK(daemon.end(SIGTERM) == 0);
  }

 private:
  std::optional<Request> some_request() {
    switch (rng_.below(6)) {
      case 0:
        return ledger_.remove();
      case 1:
        return ledger_.cancel();
      case 2:
      case 3:
        return ledger_.queue();
      default:
        return ledger_.upload();
    }
  }

  void act(std::uint16_t port) {
    if (rng_.below(3) == 0) {
      static_cast<void>(test::request(port, "POST", "/api/v1/printer/bed-cleared"));
    }
    const auto request = some_request();
    if (!request) return;
    const auto reply = test::request(port, request->method, request->target, request->body);
    const json jobs = json::parse(test::request(port, "GET", "/api/v1/jobs").body)["jobs"];
    ledger_.answered(reply.status, jobs.empty() ? 0 : jobs[0]["id"].get<std::int64_t>());
  }

  // So many commands further, without looking at a clock; not at all if nothing is printed.
  void print_on(std::uint16_t port, std::uint64_t commands) {
    const std::size_t enough = printer_.count() + commands;
    for (int i = 0; i < 20'000 && printer_.count() < enough; ++i) {
      const auto now = test::request(port, "GET", "/api/v1/printer");
      if (json::parse(now.body)["state"] != "printing") break;
    }
  }

  void check() {
    auto database = Database::open(folder_.path() / "slipstick.db");
    REQUIRE(database);
    CHECK((*database->query("PRAGMA integrity_check"))[0].text(0) == "ok");
    CHECK(database->query("PRAGMA foreign_key_check")->empty());
    CHECK(std::filesystem::is_empty(folder_.path() / "incoming"));
    for (const auto& file : std::filesystem::directory_iterator(folder_.path() / "files")) {
      INFO(file.path());
      CHECK(program_in(file.path()) != kNothing);
    }
    auto store = Store::open(folder_.path());
    REQUIRE(store);
    ledger_.check_files(*store);
    ledger_.check_jobs(*store, printer_.commands());
  }

  test::TemporaryFolder folder_;
  test::ObedientPrinter printer_;
  Rng rng_;
  Ledger ledger_;
};

}  // namespace

TEST_CASE("Killed at any moment, the daemon loses nothing it accepted and prints nothing twice") {
  const std::uint64_t seed = test::from_environment("SLIPSTICK_SEED", 1);
  const std::uint64_t kills = test::from_environment("SLIPSTICK_KILLS", 6);
  INFO("SLIPSTICK_SEED=" << seed << " SLIPSTICK_KILLS=" << kills);
  Voyage voyage(seed);

  for (std::uint64_t i = 0; i < kills; ++i) {
    INFO("kill " << i);
    voyage.live_and_die();
  }

  voyage.arrive(kills);
}
