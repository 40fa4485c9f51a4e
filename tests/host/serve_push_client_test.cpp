// One listener of OctoPrint's push socket, without the socket: what it hears when, and what it
// says.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/serve/push_client.h"

using namespace slipstick;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

using Names = std::vector<std::string>;
using Heard = PushClient::Heard;
using Framing = PushClient::Framing;
using Admission = PushClient::Admission;

/// A listener and what it listens to; time is what the test says.
struct Listening {
  explicit Listening(Framing framing = Framing::kRaw, Admission admission = Admission::kGranted)
      : client(framing, admission) {}

  EventLog log{[] {}};
  PushHub hub{{[] { return OctoMoment{}; }, [](const HttpRequest&) { return false; },
               [](std::string_view user, std::string_view session) {
                 return user == "slipstick" && session == "secret";
               }},
              log};
  PushClient client;
  PushClient::Time now{1h};

  void happens(const std::string& file) {
    log.publish("files", json{{"name", file}, {"size", 1}, {"created", 1}}.dump());
    hub.follow();
  }
  /// All that is said now.
  std::vector<std::string> frames() {
    std::vector<std::string> all;
    hub.follow();
    while (auto frame = client.next(hub, now)) all.push_back(*frame);
    return all;
  }
  /// The keys of the messages, of events their types.
  Names said() {
    Names names;
    for (const std::string& frame : frames()) {
      const json message = json::parse(frame);
      const std::string kind = message.items().begin().key();
      names.push_back(kind == "event" ? message["event"]["type"].get<std::string>() : kind);
    }
    return names;
  }
  Heard hear(const std::string& text) { return client.hear(text, hub, now); }
};

}  // namespace

TEST_CASE("A listener hears history, events at once and the state twice a second at most") {
  Listening listening;

  CHECK(listening.said() == Names{"connected", "history"});
  listening.happens("a.lua");
  CHECK(listening.said() == Names{"FileAdded", "UpdatedFiles"});
  listening.now += 499ms;
  CHECK(listening.said().empty());
  listening.now += 1ms;
  CHECK(listening.said() == Names{"current"});
  listening.now += 10s;
  CHECK(listening.said().empty());  // nothing has happened
}

TEST_CASE("A throttled listener hears the state as seldom as it says") {
  Listening listening;
  static_cast<void>(listening.said());
  CHECK(listening.hear(R"({"throttle": 4})") == Heard::kFine);
  listening.log.publish("progress", "{}");

  listening.now += 1999ms;
  CHECK(listening.said().empty());
  listening.now += 1ms;
  CHECK(listening.said() == Names{"current"});

  for (const char* nonsense : {R"({"throttle": 0})", R"({"throttle": -1})", R"({"throttle": 1e9})",
                               R"({"throttle": 18446744073709551615})", R"({"throttle": "x"})",
                               R"({"throttle": 1001})", R"({"throttle": null})"}) {
    CHECK(listening.hear(nonsense) == Heard::kFine);
  }
  listening.log.publish("progress", "{}");
  listening.now += 2s;
  CHECK(listening.said() == Names{"current"});
}

TEST_CASE("Who may not listen hears that it is connected, and nothing before a valid session") {
  Listening listening(Framing::kRaw, Admission::kByAuth);
  CHECK(listening.said() == Names{"connected"});
  listening.happens("secret.lua");

  for (const char* wrong :
       {R"({"auth": "slipstick:wrong"})", R"({"auth": "slipstick:"})", R"({"auth": "slipstick"})",
        R"({"auth": ":"})", R"({"auth": ""})", R"({"auth": 7})", R"({"auth": null})",
        R"({"auth": "other:secret"})", R"({"throttle": 1})", R"({"subscribe": {"state": true}})"}) {
    INFO(wrong);
    CHECK(listening.hear(wrong) == Heard::kFine);
    CHECK(!listening.client.admitted());
    CHECK(listening.said().empty());
  }
  CHECK(listening.hear(R"({"auth": "slipstick:secret"})") == Heard::kFine);
  CHECK(listening.client.admitted());
  CHECK(listening.said() == Names{"history"});
  CHECK(listening.hear(R"({"auth": "slipstick:wrong"})") == Heard::kFine);
  listening.happens("more.lua");
  CHECK(listening.said().empty());
}

TEST_CASE("A listener hears what it subscribes to") {
  Listening listening;
  static_cast<void>(listening.said());
  listening.log.publish("log", R"({"text": "echo:busy"})");

  SECTION("some events and no state") {
    static_cast<void>(listening.hear(R"({"subscribe": {"events": ["UpdatedFiles", 7]}})"));
    listening.happens("a.lua");
    listening.now += 1s;
    CHECK(listening.said() == Names{"UpdatedFiles"});
  }
  SECTION("the state without what the printer says") {
    static_cast<void>(listening.hear(R"({"subscribe": {"state": {"messages": true}}})"));
    listening.now += 1s;
    const auto frames = listening.frames();
    REQUIRE(frames.size() == 1);
    CHECK(json::parse(frames[0])["current"]["logs"].empty());
  }
  SECTION("a pattern stands for all") {
    static_cast<void>(listening.hear(R"({"subscribe": {"state": {"logs": "(a*)*b"}}})"));
    listening.now += 1s;
    const auto frames = listening.frames();
    REQUIRE(frames.size() == 1);
    CHECK(json::parse(frames[0])["current"]["logs"] == json{"Recv: echo:busy"});
  }
  SECTION("all of it") {
    static_cast<void>(
        listening.hear(R"({"subscribe": {"state": true, "events": true, "plugins": true}})"));
    listening.happens("a.lua");
    listening.now += 1s;
    CHECK(listening.said() == Names{"FileAdded", "UpdatedFiles", "current"});
  }
}

TEST_CASE("SockJS has its own frames, and says that it is there") {
  Listening listening(Framing::kSockJs, Admission::kByAuth);

  const auto first = listening.frames();
  REQUIRE(first.size() == 2);
  CHECK(first[0] == "o");
  CHECK(json::parse(json::parse(first[1].substr(1))[0].get<std::string>()).contains("connected"));
  CHECK(listening.hear(R"(["{\"auth\": \"slipstick:secret\"}"])") == Heard::kFine);
  CHECK(listening.frames().size() == 1);
  listening.now += 24s;
  CHECK(listening.frames().empty());
  listening.now += 1s;
  CHECK(listening.frames() == std::vector<std::string>{"h"});
  CHECK(listening.client.farewell() == "c[3000,\"Go away!\"]");
}

TEST_CASE("A client says twenty things a second, whatever they are") {
  Listening listening(GENERATE(Framing::kRaw, Framing::kSockJs));

  for (int i = 0; i < PushClient::kMessagesMax; ++i) {
    CHECK(listening.hear(i % 2 == 0 ? "{}" : "no JSON") == Heard::kFine);
  }
  CHECK(listening.hear("{}") == Heard::kTooMuch);
  listening.now += 1s;
  CHECK(listening.hear("{}") == Heard::kFine);
}

TEST_CASE("Many messages in a frame, and pings, are counted one by one") {
  Listening listening(Framing::kSockJs);
  json many = json::array();
  for (int i = 0; i <= PushClient::kMessagesMax; ++i) many.push_back("{}");

  CHECK(listening.hear(many.dump()) == Heard::kTooMuch);
  listening.now += 1s;
  for (int i = 0; i < PushClient::kMessagesMax; ++i) {
    CHECK(listening.client.count(listening.now) == Heard::kFine);
  }
  CHECK(listening.client.count(listening.now) == Heard::kTooMuch);
}

TEST_CASE("Who asks seldom misses events, and hears the last state only") {
  Listening listening;
  static_cast<void>(listening.said());
  for (int i = 0; i < 1'000; ++i) listening.happens("a" + std::to_string(i) + ".lua");
  listening.now += 1h;

  const Names said = listening.said();

  CHECK(said.size() == PushHub::kKept + 1);
  CHECK(std::count(said.begin(), said.end(), "current") == 1);
  CHECK(listening.hub.items().size() == PushHub::kKept);
}

TEST_CASE("However many listen, how things are is looked up once a turn") {
  int looks = 0;
  EventLog log{[] {}};
  PushHub hub({[&] {
                 ++looks;
                 return OctoMoment{};
               },
               {},
               {}},
              log);

  hub.follow();
  for (int i = 0; i < 64; ++i) {
    PushClient client(Framing::kRaw, Admission::kGranted);
    while (client.next(hub, PushClient::Time{1h})) {
    }
  }

  CHECK(looks == 1);
}
