#include "core/formats/mesh_3mf.h"

#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "core/base/box.h"
#include "core/base/rng.h"
#include "tests/support/zip_bytes.h"

using namespace slipstick;
using Catch::Contains;

namespace {

// A right-angled corner of three unit edges: six times its volume is 1.
constexpr std::string_view kCorner =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>)"
    R"(<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>)"
    R"(<triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>)"
    R"(<triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh>)";

std::string object(int id, std::string_view body = kCorner, std::string_view attributes = "") {
  return fmt::format(R"(<object id="{}" {}>{}</object>)", id, attributes, body);
}

std::string component(int id, std::string_view attributes = "") {
  return fmt::format(R"(<components><component objectid="{}" {}/></components>)", id, attributes);
}

std::string item(int id, std::string_view attributes = "") {
  return fmt::format(R"(<item objectid="{}" {}/>)", id, attributes);
}

std::string model(std::string_view resources, std::string_view build,
                  std::string_view attributes = "") {
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>)"
                     "\n"
                     R"(<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
                     R"(xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" )"
                     R"(xmlns:b="urn:beams" {}>)"
                     "\n<resources>\n{}</resources>\n<build>{}</build></model>",
                     attributes, resources, build);
}

TriangleMesh mesh_of(const std::string& bytes) {
  const auto mesh = read_mesh(bytes, "3MF");
  INFO((mesh ? std::string() : mesh.error().message));
  REQUIRE(mesh);
  return *mesh;
}

Box3 box_of(const std::string& bytes) {
  Box3 box;
  for (const Vec3 p : mesh_of(bytes).vertices) box = box.with(p);
  return box;
}

double sixfold_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c]));
  }
  return sum;
}

std::string error_of(const std::string& bytes) {
  const auto mesh = read_mesh(bytes, "3mf");
  REQUIRE_FALSE(mesh);
  CHECK(mesh.error().code == ErrorCode::kInput);
  CHECK(mesh.error().message.find('\n') == std::string::npos);
  return mesh.error().message;
}

std::string error_of_model(std::string_view resources, std::string_view build,
                           std::string_view attributes = "") {
  return error_of(package_3mf(model(resources, build, attributes)));
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("The build of a 3MF is its mesh") {
  const TriangleMesh mesh = mesh_of(package_3mf(model(object(1), item(1))));

  CHECK(mesh.vertices == std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
  CHECK(mesh.triangles.size() == 4);
  CHECK(sixfold_volume(mesh) == 1);
}

TEST_CASE("Every unit of a 3MF becomes millimetres") {
  constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{{{"micron", 0.001},
                                                                       {"millimeter", 1},
                                                                       {"centimeter", 10},
                                                                       {"inch", 25.4},
                                                                       {"foot", 304.8},
                                                                       {"meter", 1000}}};
  for (const auto& [unit, millimetres] : kUnits) {
    CAPTURE(unit);

    // The transform is in the unit as well.
    const Box3 box = box_of(package_3mf(model(object(1),
                                              item(1, R"(transform="1 0 0 0 1 0 0 0 1 )"
                                                      R"(2 0 0")"),
                                              fmt::format("unit=\"{}\"", unit))));

    CHECK(box.high.z == millimetres);
    CHECK(box.high.x == Approx(3 * millimetres).epsilon(1e-15));
  }
  CHECK_THAT(error_of_model(object(1), item(1), "unit=\"furlong\""),
             Contains("line 2: the unit \"furlong\" is none of"));
}

TEST_CASE("Transforms of a 3MF multiply row vectors, the component's before the item's") {
  const std::string parts =
      object(1) + object(2, component(1, R"(transform="0 2 0 -2 0 0 0 0 2 5 0 0")"));

  const Box3 box =
      box_of(package_3mf(model(parts, item(2, R"(transform="1 0 0 0 1 0 0 0 3 0 100 7")"))));

  // x goes to 2 y, y to -2 x, z to 2 z; then by 5 along x; then z to 3 z and away.
  CHECK(box.low == Vec3{3, 100, 7});
  CHECK(box.high == Vec3{5, 102, 13});
}

TEST_CASE("A mirrored object keeps its outside outside") {
  const TriangleMesh mesh =
      mesh_of(package_3mf(model(object(1), item(1, R"(transform="-1 0 0 0 1 0 0 0 1 0 0 0")"))));

  CHECK(sixfold_volume(mesh) == 1);
}

TEST_CASE("An object is there as often as the build has it, and not otherwise") {
  const std::string move = R"(transform="1 0 0 0 1 0 0 0 1 4 0 0")";
  const auto volume = [](std::string_view resources, std::string_view build) {
    return sixfold_volume(mesh_of(package_3mf(model(resources, build))));
  };

  CHECK(volume(object(1), item(1) + item(1, move)) == Approx(2).epsilon(1e-14));
  CHECK(volume(object(1) + object(2), item(2)) == 1);
  CHECK(volume(object(1) + object(2), item(2) + item(1, move + R"( printable="0")")) == 1);
}

TEST_CASE("Supports and modifiers are not printed, wherever they are used") {
  const std::string two = R"(<components><component objectid="1"/><component objectid="2"/>)"
                          R"(</components>)";
  for (const std::string_view type : {"support", "solidsupport", "surface", "other"}) {
    const std::string other = object(2, replaced(std::string(kCorner), "x=\"1\"", "x=\"9\""),
                                     fmt::format("type=\"{}\"", type));

    CHECK(box_of(package_3mf(model(object(1) + other, item(1) + item(2)))).high.x == 1);
    CHECK(box_of(package_3mf(model(object(1) + other + object(3, two), item(3)))).high.x == 1);
    CHECK_THAT(error_of_model(other, item(2)), Contains("has nothing to be built"));
  }
}

TEST_CASE("Objects may be in parts of their own") {
  const std::string root = model(object(1, component(7, R"(p:path="/3D/Objects/a.model")")),
                                 item(1) + item(8, R"(p:path="/3D/Objects/a.model" )"
                                                   R"(transform="1 0 0 0 1 0 0 0 1 4 0 0")"),
                                 "requiredextensions=\"p\"");
  const std::string part = model(object(7) + object(8), "");

  CHECK(sixfold_volume(mesh_of(package_3mf(root, {{"3D/Objects/a.model", part}}))) ==
        Approx(2).epsilon(1e-14));
  CHECK_THAT(error_of(package_3mf(root)), Contains("has no part 3D/Objects/a.model"));
  CHECK_THAT(
      error_of(package_3mf(root, {{"3D/Objects/a.model", model(object(7), "", "unit=\"inch\"")}})),
      Contains("object 7 is in a part with another unit"));
}

TEST_CASE("A 3MF that requires what is not known here is refused") {
  CHECK_THAT(error_of_model(object(1), item(1), "requiredextensions=\"p b\""),
             Contains("requires the extension \"b\" (urn:beams)"));
  CHECK_THAT(error_of_model(object(1), item(1), "requiredextensions=\"q\""),
             Contains("requires the extension \"q\""));
}

TEST_CASE("A tag means something only where it belongs") {
  const std::string foreign = R"(<b:mesh><b:vertex/></b:mesh><metadata><vertex x="a"/></metadata>)";

  CHECK(sixfold_volume(mesh_of(package_3mf(
            model(object(1, foreign + std::string(kCorner)) + foreign, item(1))))) == 1);
}

TEST_CASE("What is no 3MF says what is wrong") {
  CHECK_THAT(error_of(""), Contains("is not a zip file"));
  CHECK_THAT(error_of("solid"), Contains("is not a zip file"));
  CHECK_THAT(error_of(zip_of({{"a", "b"}})), Contains("names no model part"));
  CHECK_THAT(error_of(zip_of({{"_rels/.rels", "<Relationships/>"}})),
             Contains("names no model part"));
  CHECK_THAT(error_of(package_3mf("<model/>")),
             Contains("3D/3dmodel.model line 1: the document is not a 3MF model"));
  CHECK_THAT(error_of(package_3mf("")), Contains("line 1: no element found"));
  CHECK_THAT(error_of_model(object(1) + "\n\n<object", item(1)),
             Contains("line 6: not well-formed"));
  CHECK_THAT(error_of_model(object(1), ""), Contains("has nothing to be built"));
  CHECK_THAT(error_of_model(object(1), item(2)), Contains("object 2 is used but not defined in"));
  CHECK_THAT(error_of_model(object(1) + "\n" + object(1), item(1)),
             Contains("line 5: there is an object 1 already"));
  CHECK_THAT(error_of_model("<object/>", item(1)), Contains("an object needs a whole number"));
  CHECK_THAT(error_of_model(object(1), "<item/>"), Contains("needs an objectid"));
}

TEST_CASE("Numbers of a 3MF are checked where they stand") {
  const auto with = [](std::string_view from, std::string_view to) {
    return error_of_model(object(5, replaced(std::string(kCorner), from, to)), item(5));
  };
  const auto moved = [](std::string_view transform) {
    return error_of_model(object(1), item(1, fmt::format("transform=\"{}\"", transform)));
  };

  CHECK_THAT(with("v1=\"1\"", "v1=\"4\""),
             Contains("triangle 3 of object 5 uses vertex 4, and there are 4"));
  CHECK_THAT(with("v1=\"1\"", "v1=\"-1\""), Contains("line 4: a triangle needs indices"));
  CHECK_THAT(with("v1=\"1\"", "v1=\"1.5\""), Contains("a triangle needs indices"));
  CHECK_THAT(with("v1=\"1\"", ""), Contains("a triangle needs indices"));
  CHECK_THAT(with("x=\"1\"", "x=\"nan\""), Contains("line 4: a vertex needs finite numbers"));
  CHECK_THAT(with("x=\"1\"", "x=\"1e999\""), Contains("a vertex needs finite numbers"));
  CHECK_THAT(with("x=\"1\"", "x=\"1e10\""), Contains("coordinates must be finite and at most"));
  CHECK_THAT(moved("1 0 0 0 1 0 0 0 1 0 0"), Contains("a transform is twelve numbers"));
  CHECK_THAT(moved("1 0 0 0 1 0 0 0 1 0 0 0 0"), Contains("a transform is twelve numbers"));
  CHECK_THAT(moved("1 0 0 0 1 0 0 0 1 0 0 inf"), Contains("a transform is twelve numbers"));
  CHECK_THAT(moved("1 0 0 0 1 0 1 1 0 0 0 0"), Contains("do not flatten"));
}

TEST_CASE("An object within itself is refused, and so are too many within each other") {
  std::string chain = object(0);
  for (int i = 1; i < 20; ++i) chain += object(i, component(i - 1));

  CHECK_THAT(error_of_model(object(1, component(2)) + object(2, component(1)), item(1)),
             Contains("object 1 is a component of itself"));
  CHECK(sixfold_volume(mesh_of(package_3mf(model(chain, item(15))))) == 1);
  CHECK_THAT(error_of_model(chain, item(16)), Contains("object 0 lies within more than 15 others"));
}

TEST_CASE("Objects that multiply are refused before they take memory") {
  std::string doubling = object(0);
  std::string empty = object(0, "");
  for (int i = 1; i < 15; ++i) {
    std::string eight;
    for (int k = 0; k < 8; ++k) eight += fmt::format(R"(<component objectid="{}"/>)", i - 1);
    doubling += object(i, "<components>" + eight + "</components>");
    empty += object(i, "<components>" + eight + "</components>");
  }

  CHECK_THAT(error_of_model(doubling, item(14)), Contains("more than the 65536 objects"));
  CHECK_THAT(error_of_model(empty, item(14)), Contains("more than the 65536 objects"));
}

TEST_CASE("A 3MF that uses more parts than are read is refused") {
  std::string build;
  std::vector<std::pair<std::string, std::string>> parts;
  for (std::size_t i = 0; i < k3mfPartsMax; ++i) {
    build += item(1, fmt::format(R"(p:path="/3D/{}.model")", i));
    parts.emplace_back(fmt::format("3D/{}.model", i), model(object(1), ""));
  }

  CHECK_THAT(error_of(package_3mf(model("", build), parts)), Contains("more than 1024 parts"));
}

TEST_CASE("What unpacks to far more than it is, is refused") {
  const std::string blanks(5'000'000, ' ');

  CHECK_THAT(error_of_model(blanks + object(1), item(1)), Contains("unpacks to more than"));
}

TEST_CASE("Document types and tags without end are refused") {
  std::string random;
  Rng rng(1);
  for (int i = 0; i < 2'000'000; ++i) random += static_cast<char>('a' + rng.below(26));

  CHECK_THAT(
      error_of(package_3mf("<!DOCTYPE model [<!ENTITY a \"b\">]>\n" + model(object(1), item(1)))),
      Contains("line 1: document types are not allowed"));
  CHECK_THAT(error_of_model(object(1, "<!-- " + random + "-->"), item(1)),
             Contains("a tag is longer than"));
}

TEST_CASE("A damaged 3MF is a sound mesh or an error") {
  const std::string whole = package_3mf(model(object(1), item(1)));
  Rng rng(1);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CHECK_FALSE(read_mesh(whole.substr(0, size), "3mf"));
  }
  for (int trial = 0; trial < 1000; ++trial) {
    std::string damaged = whole;
    damaged[rng.below(damaged.size())] = static_cast<char>(rng.below(256));

    const auto mesh = read_mesh(damaged, "3mf");

    if (mesh) CHECK(sixfold_volume(*mesh) == 1);
  }
}
