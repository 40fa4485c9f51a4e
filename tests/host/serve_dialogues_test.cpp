// What slicers say to their print hosts, byte by byte: dialogues/*.http. Each finds in the replies
// what it looks for, and the file is stored or printed as it was asked for. A key is needed.
#include <catch2/catch.hpp>

#include "tests/host/serve_fixture.h"
#include "tests/support/http_dialogue.h"

using namespace slipstick;
using nlohmann::json;
using test::WantedOfReply;

namespace {

std::vector<std::filesystem::path> dialogues() {
  std::vector<std::filesystem::path> paths;
  const std::string folder = std::string(SLIPSTICK_SOURCE_DIR) + "/tests/host/dialogues";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".http") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void check_wanted(const test::HttpReply& reply, const WantedOfReply& wanted) {
  INFO(wanted.where << " " << wanted.what);
  if (wanted.kind == WantedOfReply::Kind::kHeader) {
    const auto at = reply.headers.find(wanted.where);
    REQUIRE(at != reply.headers.end());
    CHECK_THAT(at->second, Catch::Contains(wanted.what));
    return;
  }
  const json body = test::json_of(reply);
  const json::json_pointer where(wanted.where);
  REQUIRE(body.contains(where));
  if (wanted.kind == WantedOfReply::Kind::kValue) CHECK(body[where] == json::parse(wanted.what));
  if (wanted.kind == WantedOfReply::Kind::kTextThatBegins) {
    CHECK_THAT(body[where].get<std::string>(), Catch::StartsWith(wanted.what));
  }
}

/// A daemon off the loopback, as a slicer finds it, and a way to look at it.
class Host {
 public:
  void replay(const test::HttpDialogue& dialogue) {
    std::optional<test::HttpClient> client;
    const std::string host = "127.0.0.1:" + std::to_string(daemon_.port());
    for (const test::DialogueTurn& turn : dialogue.turns) {
      if (turn.connects) client.emplace(daemon_.port());
      REQUIRE(client);
      INFO(turn.bytes);
      client->send(
          test::with_value(test::with_value(turn.bytes, "host", host), "key", daemon_.key()));
      const auto reply = client->reply();
      INFO(reply.body);
      REQUIRE(reply.status == turn.status);
      for (const WantedOfReply& wanted : turn.wanted) check_wanted(reply, wanted);
    }
  }
  json get(const std::string& target) {
    return test::json_of(test::request(daemon_.port(), "GET", target, "", key()));
  }
  void wait_for_print() { static_cast<void>(events_.wait_for_rest()); }

 private:
  [[nodiscard]] std::string key() const { return "X-Api-Key: " + daemon_.key() + "\r\n"; }

  test::RunningDaemon daemon_{"sim:", test::kNeedsKey};
  test::EventReader events_{daemon_, key()};
};

}  // namespace

TEST_CASE("Every recorded dialogue goes as the slicer expects, and does what it asks for") {
  const auto paths = dialogues();
  REQUIRE(paths.size() >= 8);
  for (const auto& path : paths) {
    DYNAMIC_SECTION(path.stem().string()) {
      const auto dialogue = test::read_dialogue(path.string());
      Host host;

      host.replay(dialogue);

      if (!dialogue.printed.empty()) host.wait_for_print();
      for (const auto& file : dialogue.stored) {
        CHECK(host.get("/api/v1/files/" + percent_encoded(file.name))["size"] == file.size);
      }
      const json jobs = host.get("/api/v1/jobs")["jobs"];
      CHECK(jobs.size() == (dialogue.printed.empty() ? 0 : 1));
      for (const json& job : jobs) {
        CHECK(job["file"] == dialogue.printed);
        CHECK(job["state"] == "done");
        CHECK(job["result"]["lines"] == 3);
      }
    }
  }
}
