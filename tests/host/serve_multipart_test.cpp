// Forms as clients send them, in pieces of any size, and as none should.
#include <catch2/catch.hpp>
#include <map>

#include "core/base/rng.h"
#include "host/serve/multipart.h"

using namespace slipstick;
using Catch::Contains;

namespace {

struct Form {
  std::map<std::string, std::string> fields;
  std::string file_name;
  std::string bytes;
  bool complete = false;
  std::string fault;
  friend bool operator==(const Form&, const Form&) = default;
};

// What comes out when `body` comes in pieces, whose sizes `piece` draws.
template <typename Piece>
Form parsed(const std::string& body, Piece piece, const std::string& boundary = "XX") {
  Form form;
  MultipartParser parser(
      boundary, {[&](std::string name, std::string value) { form.fields[name] = std::move(value); },
                 [&](std::string name) -> Result<void> {
                   form.file_name = std::move(name);
                   return {};
                 },
                 [&](std::string_view bytes) -> Result<void> {
                   form.bytes += bytes;
                   return {};
                 }});
  for (std::size_t at = 0; at < body.size();) {
    const std::size_t size = std::min(body.size() - at, std::size_t(piece()));
    const auto ok = parser.feed(std::string_view(body).substr(at, size));
    if (!ok) {
      form.fault = ok.error().message;
      return form;
    }
    at += size;
  }
  form.complete = parser.complete();
  return form;
}

Form whole(const std::string& body) {
  return parsed(body, [] { return 1'000'000; });
}

std::string field(const std::string& name, const std::string& value) {
  return "--XX\r\nContent-Disposition: form-data; name=\"" + name + "\"\r\n\r\n" + value + "\r\n";
}

std::string file(const std::string& name, const std::string& bytes) {
  return "--XX\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" + name +
         "\"\r\nContent-Type: application/octet-stream\r\n\r\n" + bytes + "\r\n";
}

}  // namespace

TEST_CASE("The boundary is found in what clients say, and only of a form") {
  CHECK(MultipartParser::boundary_of("multipart/form-data; boundary=abc") == "abc");
  CHECK(MultipartParser::boundary_of("Multipart/Form-Data;charset=x; boundary=\"a b\"") == "a b");
  CHECK(!MultipartParser::boundary_of("multipart/form-data"));
  CHECK(!MultipartParser::boundary_of("multipart/form-data; boundary="));
  CHECK(!MultipartParser::boundary_of("multipart/mixed; boundary=abc"));
  CHECK(!MultipartParser::boundary_of("multipart/form-data; boundary=" + std::string(71, 'a')));
  CHECK(!MultipartParser::boundary_of(""));
}

TEST_CASE("A form comes out the same whatever pieces it comes in") {
  // Bytes that look like the beginning of a boundary, and a file that ends in one.
  const std::string tricky = std::string("G1\r\n--X\r\n--\r\r\n--Y\0\xff\r\n", 22);
  const std::string body = "preamble\r\n" + field("print", "true") + field("path", "") +
                           file("a b.gcode", tricky) + field("select", "\r\n--X") +
                           "--XX--\r\nepilogue";
  const Form expected = whole(body);
  CHECK(expected.complete);
  CHECK(expected.fields ==
        std::map<std::string, std::string>{{"print", "true"}, {"path", ""}, {"select", "\r\n--X"}});
  CHECK(expected.file_name == "a b.gcode");
  CHECK(expected.bytes == tricky);

  CHECK(parsed(body, [] { return 1; }) == expected);
  Rng rng(7);
  for (int round = 0; round < 300; ++round) {
    CHECK(parsed(body, [&] { return 1 + rng.below(40); }) == expected);
  }
}

TEST_CASE("A quote in a name is read as curl and as browsers write it; backslashes are of paths") {
  CHECK(whole(file("a\\\"b.gcode", "x") + "--XX--").file_name == "a\"b.gcode");
  CHECK(whole(file("C:\\prints\\a.gcode", "x") + "--XX--").file_name == "C:\\prints\\a.gcode");
}

TEST_CASE("A form that breaks off is not complete") {
  const std::string body = field("print", "true") + file("a.gcode", "G28") + "--XX--";

  for (std::size_t size = 0; size < body.size(); ++size) {
    const Form form = whole(body.substr(0, size));
    CHECK(!form.complete);
  }
}

TEST_CASE("What is no form is said to be none") {
  CHECK_THAT(whole("--XXgarbage").fault, Contains("boundary"));
  CHECK_THAT(whole("--XX\r\n\r\nx\r\n--XX--").fault, Contains("no name"));
  CHECK_THAT(whole("--XX\r\nContent-Disposition: form-data\r\n\r\nx\r\n--XX--").fault,
             Contains("no name"));
  CHECK_THAT(whole(file("a", "1") + file("b", "2") + "--XX--").fault, Contains("one file"));
}

TEST_CASE("A form has bounds, and memory with it") {
  std::string many;
  for (int i = 0; i <= MultipartParser::kPartsMax; ++i) many += field(std::to_string(i), "");
  CHECK_THAT(whole(many).fault, Contains("too many"));
  CHECK_THAT(whole(field("a", std::string(MultipartParser::kFieldMax + 1, 'x')) + "--XX--").fault,
             Contains("too long"));
  CHECK_THAT(whole("--XX\r\n" + std::string(MultipartParser::kHeadMax + 10, 'x')).fault,
             Contains("head"));
}
