// What slicers send to an OctoPrint, replayed: requests in their order and form, and what each
// needs to find in the answers (PrusaSlicer 2.9, OrcaSlicer 2.x: OctoPrint.cpp; Cura's plugin
// OctoPrintConnection: OctoPrintOutputDevice.py).
#include <catch2/catch.hpp>

#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using Catch::StartsWith;
using nlohmann::json;

namespace {

constexpr const char* kGcode = "G90\nG28\nM400\n";

std::string part(const std::string& name, const std::string& value) {
  return "Content-Disposition: form-data; name=\"" + name + "\"\r\n\r\n" + value + "\r\n";
}

std::string file_part(const std::string& name, const std::string& bytes) {
  return "Content-Disposition: form-data; name=\"file\"; filename=\"" + name +
         "\"\r\nContent-Type: application/octet-stream\r\n\r\n" + bytes + "\r\n";
}

std::string form(const std::vector<std::string>& parts) {
  std::string body;
  for (const std::string& each : parts)
    body += "--------------------------d74496d66958873e\r\n" + each;
  return body + "--------------------------d74496d66958873e--\r\n";
}

// As libcurl sends a body of more than a megabyte, or any with an older one: it asks first.
test::HttpReply upload(const test::RunningDaemon& daemon, const std::string& body) {
  test::HttpClient client(daemon.port());
  client.send("POST /api/files/local HTTP/1.1\r\nHost: localhost:" + std::to_string(daemon.port()) +
              "\r\nUser-Agent: PrusaSlicer/2.9.0\r\nAccept: */*\r\nX-Api-Key: any\r\n"
              "Content-Length: " +
              std::to_string(body.size()) +
              "\r\nContent-Type: multipart/form-data; "
              "boundary=------------------------d74496d66958873e\r\n"
              "Expect: 100-continue\r\n\r\n");
  CHECK(client.reply().status == 100);
  client.send(body);
  return client.reply();
}

}  // namespace

TEST_CASE("PrusaSlicer and OrcaSlicer find an OctoPrint, upload and print") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  const auto version = test::json_of(daemon.get("/api/version"));
  CHECK(version.contains("api"));
  CHECK_THAT(version["text"].get<std::string>(), StartsWith("OctoPrint"));

  const auto reply = upload(daemon, form({part("print", "true"), part("path", "sub\\folder"),
                                          file_part("Shape-Box 0.2mm.gcode", kGcode)}));

  CHECK(reply.status == 201);
  static_cast<void>(events.wait_for_rest());
  const auto job = test::json_of(daemon.get("/api/v1/jobs/1"));
  CHECK(job["file"] == "Shape-Box 0.2mm.gcode");
  CHECK(job["state"] == "done");
  CHECK(job["result"]["lines"] == 3);
}

TEST_CASE("Without print=true a file is uploaded and nothing moves") {
  const test::RunningDaemon daemon;

  CHECK(
      upload(daemon, form({part("print", "false"), part("path", ""), file_part("a.gcode", kGcode)}))
          .status == 201);

  CHECK(test::json_of(daemon.get("/api/v1/jobs"))["jobs"].empty());
  CHECK(test::json_of(daemon.get("/api/files/local/a.gcode"))["size"] == 13);
}

TEST_CASE("Cura looks around, uploads with the file first, selects and prints") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  CHECK(test::json_of(daemon.get("/api/settings"))["feature"]["sdSupport"] == false);
  CHECK(daemon.post("/api/login", R"({"passive": true})").status == 200);
  CHECK(test::json_of(daemon.get("/api/printerprofiles"))["profiles"].contains("_default"));
  const auto printer = test::json_of(daemon.get("/api/printer"));
  CHECK(printer["state"]["flags"]["operational"] == true);
  CHECK(test::json_of(daemon.get("/api/job"))["state"] == "Operational");
  CHECK(daemon.post("/api/connection", R"({"command": "connect"})").status == 204);

  const auto reply = upload(daemon, form({part("path", "/"), file_part("CE3_box.gcode", kGcode),
                                          part("select", "false"), part("print", "false")}));

  REQUIRE(reply.status == 201);
  const std::string location = reply.headers.at("location");
  const std::size_t at = location.find("api/");
  REQUIRE(at != location.npos);
  CHECK(daemon.post("/" + location.substr(at), R"({"command": "select", "print": true})").status ==
        204);
  static_cast<void>(events.wait_for_rest());
  const auto job = test::json_of(daemon.get("/api/job"));
  CHECK(job["job"]["file"]["name"] == "CE3_box.gcode");
  CHECK(job["state"] == "Operational");
}

TEST_CASE("A print is watched, paused and cancelled as OctoPrint's clients do it") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("gyroid_sphere.lua")).status == 201);
  REQUIRE(daemon.post("/api/job", R"({"command": "start"})").status == 409);
  REQUIRE(daemon.post("/api/files/local/part.lua", R"({"command": "select"})").status == 204);
  REQUIRE(daemon.post("/api/job", R"({"command": "start"})").status == 204);
  static_cast<void>(events.wait("progress", [](const json& s) { return s["job"]["layer"] > 0; }));

  const auto job = test::json_of(daemon.get("/api/job"));
  CHECK(job["state"] == "Printing");
  CHECK(job["progress"]["completion"].get<double>() >= 0);
  CHECK(daemon.post("/api/job", R"({"command": "start"})").status == 409);
  CHECK(daemon.post("/api/job", R"({"command": "pause", "action": "pause"})").status == 204);
  static_cast<void>(events.wait("state", [](const json& s) { return s["state"] == "paused"; }));
  CHECK(test::json_of(daemon.get("/api/printer"))["state"]["flags"]["paused"] == true);
  CHECK(daemon.post("/api/job", R"({"command": "pause", "action": "resume"})").status == 204);
  CHECK(daemon.post("/api/job", R"({"command": "cancel"})").status == 204);
  static_cast<void>(events.wait_for_rest());
  CHECK(daemon.post("/api/job", R"({"command": "cancel"})").status == 409);
  CHECK(test::json_of(daemon.get("/api/v1/jobs/1"))["state"] == "cancelled");
}

TEST_CASE("A file that cannot be called so is refused before its bytes come") {
  const test::RunningDaemon daemon;
  test::HttpClient form(daemon.port()), whole(daemon.port()), link(daemon.port());
  const std::string host = " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000000\r\n";
  const std::string expect = "Expect: 100-continue\r\n\r\n";

  form.send("POST /api/files/local" + host +
            "Content-Type: multipart/form-data; boundary=XX\r\n\r\n--XX\r\n" +
            file_part("page.html", "<script>"));
  whole.send("PUT /api/v1/files/page.html" + host + expect);
  link.send("PUT /api/v1/files/local/folder/page.html" + host + expect);

  CHECK(form.reply().status == 415);
  CHECK(whole.reply().status == 400);
  CHECK(link.reply().status == 400);
  CHECK(std::filesystem::is_empty(daemon.data() / "incoming"));
}

TEST_CASE("PrusaLink's uploads replace nothing that they do not say they do") {
  const test::RunningDaemon daemon;
  const std::string target = "/api/v1/files/local/a.gcode";
  REQUIRE(daemon.put(target, kGcode).status == 201);

  CHECK(daemon.put(target, "G28\n").status == 409);
  CHECK(test::request(daemon.port(), "PUT", target, "G28\n", "Overwrite: ?0\r\n").status == 409);
  CHECK(test::json_of(daemon.get("/api/v1/files/a.gcode"))["size"] == 13);
  CHECK(test::request(daemon.port(), "PUT", target, "G28\n", "Overwrite: ?1\r\n").status == 201);
  CHECK(test::json_of(daemon.get("/api/v1/files/a.gcode"))["size"] == 4);
  CHECK(daemon.put("/api/v1/files/local/", kGcode).status == 404);
  CHECK(daemon.put("/api/v1/files/local/..%2f..%2fa.html", kGcode).status == 400);
  CHECK(test::json_of(daemon.get("/api/v1/jobs"))["jobs"].empty());
}

TEST_CASE("A busy printer's slicers are told that their print waits") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("gyroid_sphere.lua")).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "part.lua"})").status == 201);
  static_cast<void>(events.wait("state", [](const json& s) { return !s["job"].is_null(); }));
  const std::string body =
      form({part("root", "gcodes"), part("print", "true"), file_part("a.gcode", kGcode)});

  const auto reply = test::json_of(test::request(
      daemon.port(), "POST", "/server/files/upload", body,
      "Content-Type: multipart/form-data; boundary=------------------------d74496d66958873e\r\n"));

  CHECK(reply["result"]["print_started"] == false);
  CHECK(reply["result"]["print_queued"] == true);
  CHECK(daemon.post("/api/v1/jobs/1/cancel").status == 204);
}

TEST_CASE("Requests to hosts that this is none of are refused") {
  const test::RunningDaemon daemon;
  const auto post = [&](const std::string& target, const std::vector<std::string>& parts) {
    return test::request(daemon.port(), "POST", target, form(parts),
                         "Content-Type: multipart/form-data; "
                         "boundary=------------------------d74496d66958873e\r\n")
        .status;
  };

  CHECK(post("/printer/model/other", {part("a", "upload"), file_part("a.gcode", kGcode)}) == 404);
  CHECK(post("/printer/api/other", {part("a", "listModelGroups")}) == 404);
  CHECK(post("/printer/api/slipstick", {part("a", "ping")}) == 400);
  CHECK(post("/printer/model/slipstick", {file_part("a.gcode", kGcode)}) == 400);
  CHECK(post("/printer/model/slipstick", {part("a", "upload")}) == 400);
  CHECK(post("/server/files/upload", {part("root", "config"), file_part("a.gcode", kGcode)}) ==
        400);
  CHECK(post("/server/files/upload", {part("root", "gcodes")}) == 400);
  CHECK(daemon.get("/plugin/appkeys/probe").status == 404);
  CHECK(test::json_of(daemon.get("/api/v1/files"))["files"].empty());
}

TEST_CASE("Uploads that are none are refused, and name no file of the server") {
  const test::RunningDaemon daemon;

  CHECK(upload(daemon, form({part("print", "true")})).status == 400);
  CHECK(upload(daemon, form({file_part("", kGcode)})).status == 400);
  CHECK(upload(daemon, form({file_part("page.html", "<script>")})).status == 415);
  CHECK(upload(daemon, "--------------------------d74496d66958873e\r\nbroken off").status == 400);
  // An upload rewriter in front of OctoPrint named the received file in fields like these.
  CHECK(upload(daemon, form({part("file.path", "/etc/passwd"), part("file.name", "a.gcode")}))
            .status == 400);
  CHECK(upload(daemon, form({file_part("../../etc/a.gcode", kGcode)})).status == 201);
  CHECK(daemon.post("/api/files/local", "x").status == 415);
  CHECK(daemon.post("/api/files/sdcard", "x").status == 404);

  const auto files = test::json_of(daemon.get("/api/files"))["files"];
  REQUIRE(files.size() == 1);
  CHECK(files[0]["name"] == "a.gcode");
  CHECK(daemon.remove("/api/files/local/a.gcode").status == 204);
}
