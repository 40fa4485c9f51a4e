// What a journal says, whatever became of its end.
#include "host/print_journal.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "host/checksum.h"

using namespace slipstick;
using Catch::Contains;

namespace {

const JournalHeader kHeader{"/home/me", {"print", "a b.lua", "--port", "x"}, 12, 4'000'000'000};

LayerMark mark(int layer, std::uint64_t line) {
  PrintState state;
  state.position = {1.5, 2.0, 0.3, std::nullopt};
  state.relative_extrusion = true;
  state.nozzle = 205.0;
  state.feed = 1800.0;
  return {layer, line, 77, state};
}

std::string journal() {
  return header_record(kHeader) + session_record(10'000, 0) + other_record(10'001, "") +
         layer_record(mark(0, 20)) + taken_record(5) + other_record(10'050, "G0 X5 Y215") +
         taken_record(40) + layer_record(mark(1, 60));
}

}  // namespace

TEST_CASE("A journal is read as it was written") {
  const auto content = parse_journal(journal());

  REQUIRE(content);
  CHECK(content->header == kHeader);
  CHECK(content->session->first == 10'000);
  CHECK(content->session->others == std::vector<OtherLine>{{10'001, ""}, {10'050, "G0 X5 Y215"}});
  CHECK(content->layers == std::vector<LayerMark>{mark(0, 20), mark(1, 60)});
  CHECK(content->taken == 40);
  CHECK(content->end == JournalEnd::kCutOff);
  CHECK(content->size == journal().size());
}

TEST_CASE("A journal cut off at any byte tells what its whole records tell") {
  const std::string whole = journal();
  const std::size_t header = header_record(kHeader).size();

  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto content = parse_journal(std::string_view(whole).substr(0, size));
    REQUIRE(content.has_value() == (size >= header));
    if (!content) continue;
    CHECK(content->size == whole.rfind('\n', size - 1) + 1);
    CHECK(content->taken <= 40);
  }
  const auto zeros = parse_journal(whole + std::string(100, '\0'));
  REQUIRE(zeros);
  CHECK(zeros->size == whole.size());
}

TEST_CASE("A journal damaged before its end is refused, with the place") {
  std::string damaged = journal();
  const std::size_t at = damaged.find("T 5");
  damaged[at + 2] = '6';

  const auto content = parse_journal(damaged);

  REQUIRE(!content);
  CHECK_THAT(content.error().message, Contains("damaged at byte " + std::to_string(at)));
}

TEST_CASE("What is no journal is refused") {
  for (const std::string text : {"", "G1 X1\n", "H {} *00000000\n",
                                 "\x7f"
                                 "ELF"}) {
    CHECK(!parse_journal(text));
  }
  CHECK(!parse_journal(journal().substr(header_record(kHeader).size())));
}

TEST_CASE("A record that no program writes ends what is believed") {
  const std::string header = header_record(kHeader);

  for (const std::string& record :
       {other_record(3, ""), inserted_record(3), session_record(-5, 0)}) {
    const auto content = parse_journal(header + record);
    REQUIRE(content);
    CHECK(content->size == header.size());
  }
}

TEST_CASE("All numbers that are not said to mean something else mean lines of the job, in order") {
  const auto content = parse_journal(header_record(kHeader) + session_record(100, 7) +
                                     other_record(101, "") + other_record(104, "M400"));
  REQUIRE(content);
  const JournalSession& session = *content->session;

  CHECK(session.job_lines(100) == 7);
  CHECK(session.job_lines(101) == 7);
  CHECK(session.job_lines(103) == 9);
  CHECK(session.job_lines(104) == 9);
  CHECK(session.job_lines(110) == 15);
  CHECK(session.tail(104) == std::vector<OtherLine>{{104, "M400"}});
  CHECK(session.tail(103).empty());
}

TEST_CASE("A question that was put between moves the numbers behind it up") {
  const auto content =
      parse_journal(header_record(kHeader) + session_record(100, 0) + other_record(101, "") +
                    other_record(105, "") + inserted_record(104));

  REQUIRE(content);
  CHECK(content->session->others == std::vector<OtherLine>{{101, ""}, {104, ""}, {106, ""}});
}

TEST_CASE("A number given out again is one number, and a new session forgets those of the last") {
  const std::string head = header_record(kHeader) + session_record(100, 0);

  CHECK(
      parse_journal(head + other_record(101, "") + other_record(101, "M84 S0"))->session->others ==
      std::vector<OtherLine>{{101, "M84 S0"}});
  const auto content =
      parse_journal(head + other_record(101, "") + taken_record(50) + layer_record(mark(0, 20)) +
                    layer_record(mark(1, 45)) + end_record(JournalEnd::kStopped) +
                    session_record(100, 30) + layer_record(mark(0, 20)));
  REQUIRE(content);
  CHECK(content->session->others.empty());
  CHECK(content->taken == 30);
  CHECK(content->end == JournalEnd::kCutOff);
  CHECK(content->layers == std::vector<LayerMark>{mark(0, 20)});
}

TEST_CASE("A journal tells what was changed, and from which layer on, to the last digit") {
  const SettingsChange first{3, {{"infill_density", "0.30000000000000004"}, {"fan", "1e-1"}}};
  const SettingsChange second{3, {{"perimeters", "4"}}};

  const auto content = parse_journal(journal() + change_record(first) + layer_record(mark(3, 90)) +
                                     change_record(second));

  REQUIRE(content);
  CHECK(content->changes == std::vector<SettingsChange>{first, second});
}

TEST_CASE("Changes that no program writes end what is believed") {
  const auto sealed = [](const std::string& payload) {
    return fmt::format("{} *{:08x}\n", payload, checksum(payload));
  };
  const std::string later = change_record({5, {{"fan", "1"}}});

  for (const std::string& record :
       {sealed("C"), sealed("C {}"), sealed(R"(C {"from_layer":-1,"settings":{}})"),
        sealed(R"(C {"from_layer":1,"settings":{"fan":1}})"), sealed("C 5"),
        sealed(R"(C {"from_layer":9999999999,"settings":{}})"),
        change_record({4, {{"fan", "1"}}})}) {
    const auto content = parse_journal(journal() + later + record);
    REQUIRE(content);
    CHECK(content->size == journal().size() + later.size());
    CHECK(content->changes.size() == 1);
  }
}

TEST_CASE("A journal of the version without changes is read, one of a later version is not") {
  const auto of_version = [](int version) {
    const std::string payload = fmt::format(
        R"(H {{"slipstick":{},"folder":"/","words":["print"],"model":1,"settings":2}})", version);
    return fmt::format("{} *{:08x}\n", payload, checksum(payload));
  };

  CHECK(parse_journal(of_version(2)));
  CHECK(parse_journal(of_version(3)));
  CHECK(!parse_journal(of_version(1)));
  CHECK(!parse_journal(of_version(4)));
}
