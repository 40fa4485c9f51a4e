// The daemon's values: addresses, names, jobs, events; without sockets.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/load_model.h"
#include "host/serve/event_log.h"
#include "host/serve/file_names.h"
#include "host/serve/http.h"
#include "host/serve/job_spec.h"
#include "host/serve/routes.h"

using namespace slipstick;
using Catch::Contains;

namespace {

std::string refusal_of(std::string_view name) {
  const auto made = FileName::from(name);
  return made ? "" : made.error().message;
}

std::string fault_of(std::string_view job) {
  const auto spec = job_spec_from_text(job, {});
  return spec ? "" : spec.error().message;
}

}  // namespace

TEST_CASE("An address is decoded segment by segment: an escaped slash separates nothing") {
  const auto target = parse_http_target("/api/v1/files/..%2f%2e%2e%2Fetc?a=1+2&b=%26&c");

  REQUIRE(target);
  CHECK(target->path == std::vector<std::string>{"api", "v1", "files", "../../etc"});
  CHECK(target->query.at("a") == "1 2");
  CHECK(target->query.at("b") == "&");
  CHECK(target->query.at("c").empty());
}

TEST_CASE("Addresses that are none are refused") {
  for (const char* text : {"", "api", "http://localhost/", "/%", "/%4", "/%zz", "/a?b=%g0", "*"}) {
    INFO(text);
    CHECK(!parse_http_target(text));
  }
  CHECK(parse_http_target("/" + std::string(HttpTarget::kSizeMax - 1, 'a')));
  CHECK(!parse_http_target("/" + std::string(HttpTarget::kSizeMax, 'a')));
  std::string deep;
  for (std::size_t i = 0; i < HttpTarget::kSegmentsMax; ++i) deep += "/a";
  CHECK(parse_http_target(deep));
  CHECK(!parse_http_target(deep + "/a"));
}

TEST_CASE("A file name is one that no file system is troubled by") {
  CHECK(refusal_of("Würfel 2.STL").empty());
  CHECK_THAT(refusal_of(""), Contains("empty"));
  CHECK_THAT(refusal_of("../a.stl"), Contains("slashes"));
  CHECK_THAT(refusal_of("a\\b.stl"), Contains("slashes"));
  CHECK_THAT(refusal_of(".stl"), Contains("dot"));
  CHECK_THAT(refusal_of(std::string_view("a\0.stl", 6)), Contains("control"));
  CHECK_THAT(refusal_of("a\n.stl"), Contains("control"));
  CHECK_THAT(refusal_of("\xff.stl"), Contains("UTF-8"));
  CHECK_THAT(refusal_of("\xc0\xaf.stl"), Contains("UTF-8"));          // a slash, too long
  CHECK_THAT(refusal_of("\xed\xa0\x80.stl"), Contains("UTF-8"));      // a surrogate
  CHECK_THAT(refusal_of("\xf4\x90\x80\x80.stl"), Contains("UTF-8"));  // beyond Unicode
  CHECK_THAT(refusal_of("page.html"), Contains(".stl"));
  CHECK_THAT(refusal_of("stl"), Contains("printed"));
  CHECK(refusal_of(std::string(196, 'a') + ".stl").empty());
  CHECK_THAT(refusal_of(std::string(197, 'a') + ".stl"), Contains("200"));
}

TEST_CASE("Whatever may be uploaded as a model is a kind that can be read") {
  for (const char* kind : {"lua", "vm", "ldni", "lda", "bsp", "rbf", "3mf", "stl", "obj", "ply",
                           "off", "xyz", "pwn"}) {
    const std::string name = std::string("nowhere.") + kind;
    REQUIRE(FileName::from(name));

    const auto model = load_model("/nowhere/" + name, {});

    REQUIRE(!model);
    CHECK_THAT(model.error().message, !Contains("unknown kind"));
  }
}

TEST_CASE("A path of the client's machine is cut down to its last segment") {
  CHECK(last_segment("C:\\prints\\a.gcode") == "a.gcode");
  CHECK(last_segment("/home/me/a.gcode") == "a.gcode");
  CHECK(last_segment("a.gcode") == "a.gcode");
}

TEST_CASE("A job says what is to be done, and every mistake in it is named") {
  const auto spec = job_spec_from_text(
      R"({"printer": "ender3", "settings": {"perimeters": 3, "place": "midpoints"},
          "placement": {"units": "inch", "scale": 2, "rotate": [0, 0, 90]}})",
      {});
  REQUIRE(spec);
  CHECK(spec->settings.printer == "ender3");
  CHECK(spec->settings.material == "pla");
  CHECK(spec->settings.overrides == std::vector<std::string>{"perimeters=3", "place=midpoints"});
  CHECK(spec->placement.unit == 25.4);
  CHECK(spec->placement.rotate == Vec3{0, 0, 90});

  CHECK_THAT(fault_of("{"), Contains("JSON"));
  CHECK_THAT(fault_of("[]"), Contains("object"));
  CHECK_THAT(fault_of(R"({"speed": 1})"), Contains("speed"));
  CHECK_THAT(fault_of(R"({"printer": "nobody"})"), Contains("nobody"));
  CHECK_THAT(fault_of(R"({"settings": {"perimeter": 3}})"), Contains("perimeter"));
  CHECK_THAT(fault_of(R"({"settings": {"perimeters": []}})"), Contains("perimeters"));
  CHECK_THAT(fault_of(R"({"settings": {"perimeters": -3}})"), Contains("perimeters"));
  CHECK_THAT(fault_of(R"({"placement": {"scale": "big"}})"), Contains("scale"));
  CHECK_THAT(fault_of(R"({"placement": {"fit": [1, 2]}})"), Contains("fit"));
  CHECK_THAT(fault_of(R"({"placement": {"turn": 1}})"), Contains("turn"));
  CHECK_THAT(fault_of(R"({"placement": {"bounds": [0, 0, 0, 1, 1, 0]}})"), Contains("bounds"));
}

TEST_CASE("No job reads a file by its path") {
  for (const char* name : {"/etc/passwd", "../x", "a.toml", "..\\x"}) {
    for (const char* member : {"printer", "material", "profile"}) {
      const nlohmann::json json{{member, name}};
      CHECK_THAT(fault_of(json.dump()), Contains("not a path"));
    }
  }
}

TEST_CASE("A slow listener misses events, is told so, and holds nothing up") {
  int woken = 0;
  EventLog log([&] { ++woken; });
  for (std::size_t i = 0; i < EventLog::kKept + 10; ++i) log.publish("log", std::to_string(i));

  const auto late = log.since(0);
  const auto in_time = log.since(log.last() - 2);

  CHECK(woken == static_cast<int>(EventLog::kKept) + 10);
  CHECK(late.missed);
  CHECK(late.events.size() == EventLog::kKept);
  CHECK(!in_time.missed);
  REQUIRE(in_time.events.size() == 2);
  CHECK(in_time.events[1].number == log.last());
  CHECK(log.since(log.last()).events.empty());
  CHECK(!log.since(log.last()).missed);
}

TEST_CASE("Every route is found by its own pattern, and no other method by it") {
  for (const Route& route : routes()) {
    INFO(route.pattern);
    const auto target = parse_http_target(route.pattern);
    REQUIRE(target);

    CHECK(find_route(route.method, *target).route == &route);
    const auto other = find_route(HttpMethod::kOther, *target);
    CHECK(other.route == nullptr);
    CHECK(other.refusal.status == 405);
    CHECK(find_route(route.method, *parse_http_target(std::string(route.pattern) + "/"))
              .refusal.status == 404);
  }
}
