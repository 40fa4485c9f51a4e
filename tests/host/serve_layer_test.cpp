// What is told of a print besides its state: the layer under way, how long it will take, pictures
// of files, the camera.
#include <catch2/catch.hpp>

#include "host/serve/camera_url.h"
#include "host/serve/printed_layer.h"
#include "host/serve/time_left.h"
#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

PrintedLayer layer_of(std::string program) {
  const std::int64_t lines = lines_of_layer(program);
  return {3, 0.6, 100, lines, std::move(program)};
}

json told_of(const std::string& program) {
  return json::parse(to_json_text(layer_of(program)));
}

std::string fault_of(std::string_view url) {
  const auto camera = CameraUrl::from(url);
  return camera ? "" : camera.error().message;
}

}  // namespace

TEST_CASE("A layer is told as paths of what is laid, each piece with the line that lays it") {
  const json layer = told_of(
      ";LAYER:2\nG0 Z0.6 F600\nG0 X1 Y2 F7200\nG1 E1 F2100\nG1 X3 E.1 F1800\nG1 Y4 E.1\nG0 X9\n"
      "G1 X9.126 Y5 E.2\nG1 E-1\n");

  CHECK(layer["layer"] == 3);
  CHECK(layer["height"] == 0.6);
  CHECK(layer["lines_before"] == 100);
  CHECK(layer["lines"] == 8);
  CHECK(layer["complete"] == true);
  CHECK(layer["paths"] == json::parse(R"([{"line": 3, "points": [[1, 2], [3, 2], [3, 4]]},
                                          {"line": 6, "points": [[9, 4], [9.13, 5]]}])"));
}

TEST_CASE("An empty layer has no paths and is never begun") {
  const PrintedLayer layer = layer_of(";LAYER:0\n");

  CHECK(json::parse(to_json_text(layer))["paths"].empty());
  CHECK(share_done(layer, 1000) == 0);
}

TEST_CASE("What is told of a layer is bounded") {
  std::string program;
  for (int i = 0; i < PrintedLayer::kPointsMax; ++i) {
    program += "G1 X" + std::to_string(i % 100) + " E.1\n";
  }

  const json layer = told_of(program);

  CHECK(layer["complete"] == false);
  CHECK(layer["paths"][0]["points"].size() == PrintedLayer::kPointsMax);
  CHECK(layer["lines"] == PrintedLayer::kPointsMax);
}

TEST_CASE("The share of a layer goes from 0 to 1 with its lines") {
  const PrintedLayer layer = layer_of("G0 X1\nG0 X2\nG0 X3\nG0 X4\n");

  CHECK(share_done(layer, 90) == 0);
  CHECK(share_done(layer, 101) == 0.25);
  CHECK(share_done(layer, 104) == 1);
  CHECK(share_done(layer, 900) == 1);
}

TEST_CASE("The time left is by the pace since the printer was hot; pauses do not count") {
  TimeLeft left;
  left.moved(120, 0);
  CHECK(!left.seconds());

  left.moved(200, 0.01);
  CHECK(!left.seconds());
  left.moved(210, 0.11);  // a tenth in ten seconds
  REQUIRE(left.seconds());
  CHECK(*left.seconds() == Approx(89));
  left.stood(510);
  left.moved(520, 0.21);

  CHECK(*left.seconds() == Approx(79));
}

TEST_CASE("A camera has an address that browsers may be sent to") {
  CHECK(fault_of("http://camera.local:8080/?action=stream").empty());
  CHECK(fault_of("https://[fe80::1]/a.jpg").empty());
  CHECK(CameraUrl::from("http://camera.local:8080/?action=stream")->origin() ==
        "http://camera.local:8080");
  CHECK_THAT(fault_of("rtsp://camera/"), Contains("only http:// and https://"));
  CHECK_THAT(fault_of("http:///a"), Contains("no host"));
  CHECK_THAT(fault_of("http://me:secret@camera/"), Contains("name or password"));
  CHECK_THAT(fault_of("http://camera/; script-src *"), Contains("no address has"));
  CHECK_THAT(fault_of("http://camera;/"), Contains("no address has"));
  CHECK_THAT(fault_of("http://*/"), Contains("no host"));
  CHECK_THAT(fault_of("http://c/" + std::string(CameraUrl::kSizeMax, 'a')), Contains("too long"));
}

TEST_CASE("The layer that is printed is told, in the lines that the state counts") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  CHECK(daemon.get("/api/v1/printer/layer").status == 204);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);
  REQUIRE(daemon
              .post("/api/v1/jobs", R"({"file": "part.lua", "spec": {"placement": {"fit":
      [60, 60, 60]}, "settings": {"certify": "off"}}})")
              .status == 201);
  static_cast<void>(events.wait("progress", [](const json& status) {
    return !status["job"].is_null() && status["job"]["layer"] > 1;
  }));
  REQUIRE(daemon.post("/api/v1/printer/pause").status == 204);
  static_cast<void>(events.wait("state", [](const json& s) { return s["state"] == "paused"; }));

  const json job = test::json_of(daemon.get("/api/v1/printer"))["job"];
  const json layer = test::json_of(daemon.get("/api/v1/printer/layer"));

  CHECK(layer["layer"] == job["layer"]);
  CHECK(layer["height"].get<double>() == Approx(job["height"].get<double>()));
  const auto done = job["lines"].get<int>() - layer["lines_before"].get<int>();
  CHECK(done >= -1);
  CHECK(done <= layer["lines"].get<int>());
  CHECK(layer["paths"].size() > 2);
  const double layers = job["layers"].get<double>();
  CHECK(job["completion"].get<double>() >= (job["layer"].get<double>() - 1) / layers);
  CHECK(job["completion"].get<double>() <= job["layer"].get<double>() / layers);
  REQUIRE(daemon.post("/api/v1/jobs/1/cancel").status == 204);
  static_cast<void>(events.wait("state", [](const json& s) { return s["job"].is_null(); }));
  CHECK(daemon.get("/api/v1/printer/layer").status == 204);
}

TEST_CASE("A model has a small picture, drawn once; it goes with the file") {
  const test::RunningDaemon daemon;
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("gyroid_sphere.lua")).status == 201);

  const auto drawn = daemon.get("/api/v1/files/part.lua/picture");

  REQUIRE(drawn.status == 200);
  CHECK(drawn.headers.at("content-type") == "image/png");
  CHECK(drawn.body.substr(1, 3) == "PNG");
  CHECK(drawn.body.size() < 100'000);
  const auto kept = daemon.data() / "pictures" / "1.png";
  REQUIRE(std::filesystem::exists(kept));
  std::ofstream(kept) << "as it was kept";
  CHECK(daemon.get("/api/v1/files/part.lua/picture").body == "as it was kept");
  REQUIRE(daemon.remove("/api/v1/files/part.lua").status == 204);
  CHECK(!std::filesystem::exists(kept));
  CHECK(daemon.get("/api/v1/files/part.lua/picture").status == 404);
}

TEST_CASE("What cannot be sliced has no picture, and why is said") {
  const test::RunningDaemon daemon;
  REQUIRE(daemon.put("/api/v1/files/broken.lua", "return sphere(").status == 201);
  REQUIRE(daemon.put("/api/v1/files/moves.gcode", "G28\n").status == 201);

  const auto broken = daemon.get("/api/v1/files/broken.lua/picture");
  const auto gcode = daemon.get("/api/v1/files/moves.gcode/picture");

  CHECK(broken.status == 400);
  CHECK_THAT(broken.body, Contains("broken.lua"));
  CHECK(gcode.status == 400);
  CHECK_THAT(gcode.body, Contains("G-code file has no picture"));
}

TEST_CASE("The page may show the camera's pictures, and nothing else from elsewhere") {
  const test::RunningDaemon without;
  const std::string url = "http://camera.local:8080/stream";
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", {}, url);

  const auto page = daemon.get("/");

  CHECK_THAT(page.headers.at("content-security-policy"),
             Contains("img-src 'self' data: http://camera.local:8080") &&
                 Contains("default-src 'none'") && Contains("connect-src 'self';"));
  CHECK(test::json_of(daemon.get("/api/v1/camera"))["url"] == url);
  CHECK(test::json_of(without.get("/api/v1/camera"))["url"].is_null());
  CHECK_THAT(without.get("/").headers.at("content-security-policy"), !Contains("http"));
}
