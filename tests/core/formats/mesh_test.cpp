#include "core/formats/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <string>

#include "core/base/rng.h"

using namespace slipstick;

namespace {

// A unit cube of six squares.
constexpr std::array<std::array<int, 3>, 8> kCorners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr std::array<std::array<std::size_t, 4>, 6> kSquares{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

enum class Order : std::uint8_t { kLittle, kBig };

template <typename T>
std::string binary(T value, Order order = Order::kLittle) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order == Order::kBig) std::reverse(bytes.begin(), bytes.end());
  return {bytes.data(), bytes.size()};
}

std::string vertex_lines(std::string_view prefix = "") {
  std::string text;
  for (const auto& p : kCorners) text += fmt::format("{}{} {} {}\n", prefix, p[0], p[1], p[2]);
  return text;
}

std::string face_lines() {
  std::string text;
  for (const auto& f : kSquares) text += fmt::format("4 {} {} {} {}\n", f[0], f[1], f[2], f[3]);
  return text;
}

std::string off() {
  return "OFF\n# a cube\n8 6 12\n" + vertex_lines() + face_lines();
}

std::string obj() {
  std::string text = "mtllib missing.mtl\n" + vertex_lines("v ") + "usemtl red\n";
  for (const auto& f : kSquares) {
    text += fmt::format("f {} {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1, f[3] + 1);
  }
  return text;
}

std::string ply_header(std::string_view format) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n",
      format);
}

std::string text_ply() {
  return ply_header("ascii") + vertex_lines() + face_lines();
}

std::string binary_ply(Order order, float first_x = 0) {
  std::string bytes =
      ply_header(order == Order::kLittle ? "binary_little_endian" : "binary_big_endian");
  for (const auto& p : kCorners) {
    const bool first = &p == kCorners.data();
    bytes += binary(first ? first_x : static_cast<float>(p[0]), order);
    bytes += binary(static_cast<float>(p[1]), order) + binary(static_cast<float>(p[2]), order);
  }
  for (const auto& f : kSquares) {
    bytes += '\4';
    for (const std::size_t i : f) bytes += binary(static_cast<std::int32_t>(i), order);
  }
  return bytes;
}

template <typename Facet>
std::string for_each_triangle(Facet facet) {
  std::string text;
  for (const auto& f : kSquares) {
    text += facet(kCorners[f[0]], kCorners[f[1]], kCorners[f[2]]);
    text += facet(kCorners[f[0]], kCorners[f[2]], kCorners[f[3]]);
  }
  return text;
}

std::string text_stl() {
  const auto vertex = [](const std::array<int, 3>& p) {
    return fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
  };
  return "solid cube\n" + for_each_triangle([&](auto a, auto b, auto c) {
           return "facet normal 0 0 0\nouter loop\n" + vertex(a) + vertex(b) + vertex(c) +
                  "endloop\nendfacet\n";
         }) +
         "endsolid cube\n";
}

std::string binary_stl() {
  std::string title = "solid in name only";
  title.resize(80);
  const auto vertex = [](const std::array<int, 3>& p) {
    return binary(static_cast<float>(p[0])) + binary(static_cast<float>(p[1])) +
           binary(static_cast<float>(p[2]));
  };
  return title + binary(std::uint32_t{12}) + for_each_triangle([&](auto a, auto b, auto c) {
           return std::string(12, '\0') + vertex(a) + vertex(b) + vertex(c) + std::string(2, '\0');
         });
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string error_of(std::string_view bytes, std::string_view extension) {
  const auto mesh = read_mesh(bytes, extension);
  REQUIRE_FALSE(mesh);
  CHECK(mesh.error().code == ErrorCode::kInput);
  CHECK(mesh.error().message.find('\n') == std::string::npos);
  return mesh.error().message;
}

// Six times the volume: the same for every fan and vertex order.
double sixfold_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c]));
  }
  return sum;
}

}  // namespace

TEST_CASE("Every format gives the same cube of welded vertices") {
  const std::array<std::pair<std::string, std::string>, 7> files{{
      {"off", off()},
      {"OBJ", obj()},
      {"ply", text_ply()},
      {"ply", binary_ply(Order::kLittle)},
      {"ply", binary_ply(Order::kBig)},
      {"stl", text_stl()},
      {"stl", binary_stl()},
  }};
  for (const auto& [extension, bytes] : files) {
    CAPTURE(extension, bytes.substr(0, 40));

    const auto mesh = read_mesh(bytes, extension);

    REQUIRE(mesh);
    CHECK(mesh->vertices.size() == 8);
    CHECK(mesh->triangles.size() == 12);
    CHECK(sixfold_volume(*mesh) == 6);
  }
}

TEST_CASE("A binary PLY may begin with the byte of a line feed") {
  const float x = std::bit_cast<float>(std::uint32_t{0x3F00000A});

  const auto mesh = read_mesh(binary_ply(Order::kLittle, x), "ply");

  REQUIRE(mesh);
  CHECK(mesh->vertices[0] == Vec3{double{x}, 0, 0});
}

TEST_CASE("Lines may end as on Windows") {
  std::string text;
  for (const char c : text_ply()) text += c == '\n' ? "\r\n" : std::string(1, c);

  CHECK(read_mesh(text, "ply"));
}

TEST_CASE("Faces of an OBJ count from either end, and lines go on behind a backslash") {
  const auto mesh = read_mesh(
      "v 0 0 0 1.0 # weight\nv 1 0 0\nv 0 \\\n1 0\nf -3/1/1 2//1 \\\r\n3\nv 9 9 9\nl 1 2\n", "obj");

  REQUIRE(mesh);
  CHECK(mesh->vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh->triangles == std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
}

TEST_CASE("Elements, properties and vertices that are not needed are dropped") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement tag 1\nproperty list uchar float notes\nelement vertex 4\n"
      "property uchar red\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 2\nproperty list uchar uint vertex_index\nproperty float quality\nend_header\n"
      "2 7.5 8\n255 0 0 0\n255 1 0 0\n255 0 1 0\n0 5 5 5\n3 0 1 2 0.5\n3 1 1 2 0.5\n";

  const auto mesh = read_mesh(ply, "ply");

  REQUIRE(mesh);
  CHECK(mesh->vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh->triangles == std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
}

TEST_CASE("A file that is no mesh says what is wrong") {
  using Catch::Contains;

  CHECK_THAT(error_of("solid", "step"), Contains("no mesh format; use stl, obj, ply, off or 3mf"));
  CHECK_THAT(error_of("", "ply"), Contains("does not begin with \"ply\""));
  CHECK_THAT(error_of("", "off"), Contains("expected \"OFF\""));
  CHECK_THAT(error_of("", "stl"), Contains("is not readable as stl"));
  CHECK_THAT(error_of("", "obj"), Contains("has no faces"));
  CHECK_THAT(error_of("v 0 0 0\nv 0 x 1\n", "obj"), Contains("line 2: expected a vertex"));
  CHECK_THAT(error_of("v 0 0 0\nf 1 1 1.5\n", "obj"), Contains("line 2: expected the indices"));
  CHECK_THAT(error_of("\xEF\xBB\xBF" + binary_stl(), "stl"), Contains("byte order mark"));
  CHECK_THAT(error_of(replaced(text_ply(), "float z", "float w"), "ply"),
             Contains("lack x, y or z"));
  CHECK_THAT(error_of(replaced(text_ply(), "list uchar", "list text"), "ply"),
             Contains("a line \"property list text int vertex_indices\""));
}

TEST_CASE("Points without faces are no mesh") {
  const std::string points = replaced(ply_header("ascii"), "face 6", "face 0") + vertex_lines();

  CHECK_THAT(error_of(points, "ply"), Catch::Contains("has no faces"));
  CHECK_THAT(error_of("OFF\n8 0 0\n" + vertex_lines(), "off"), Catch::Contains("has no faces"));
}

TEST_CASE("Only degenerate faces are no faces") {
  CHECK_THAT(error_of("OFF\n3 1 0\n0 0 0\n-0 0 0\n1 0 0\n3 0 1 2\n", "off"),
             Catch::Contains("other than degenerate"));
}

TEST_CASE("A vertex of degenerate faces only is not used") {
  const auto mesh = read_mesh("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 0 3\n", "off");

  REQUIRE(mesh);
  CHECK(mesh->vertices.size() == 3);
  CHECK(mesh->triangles.size() == 1);
}

TEST_CASE("Coordinates that are not finite are refused") {
  const float nan = std::bit_cast<float>(std::uint32_t{0x7FC00000});

  CHECK_THAT(error_of(binary_ply(Order::kLittle, nan), "ply"), Catch::Contains("vertex 0 is (nan"));
  CHECK_THAT(error_of(replaced(off(), "1 0 0", "inf 0 0"), "off"),
             Catch::Contains("line 5: expected a vertex of three finite numbers"));
  CHECK_THAT(error_of(replaced(off(), "1 0 0", "1e10 0 0"), "off"), Catch::Contains("vertex 1 is"));
  CHECK_THAT(error_of(replaced(text_stl(), "vertex 1 1 0", "vertex nan 1 0"), "stl"),
             Catch::Contains("coordinates must be finite"));
}

TEST_CASE("Indices of vertices that do not exist are refused") {
  CHECK_THAT(error_of(replaced(off(), "4 0 3 2 1", "4 0 3 2 88"), "off"),
             Catch::Contains("triangle 1 uses a vertex that does not exist (there are 8)"));
  CHECK_THAT(error_of(replaced(text_ply(), "4 0 3 2 1", "4 0 3 2 -1"), "ply"),
             Catch::Contains("triangle 1 uses a vertex"));
  CHECK_THAT(error_of(replaced(obj(), "f 1 4 3 2", "f 1 4 3 77"), "obj"),
             Catch::Contains("triangle 1 uses a vertex"));
  CHECK_THAT(error_of(replaced(obj(), "f 1 4 3 2", "f 0 4 3 2"), "obj"),
             Catch::Contains("triangle 0 uses a vertex"));
  CHECK_THAT(error_of(replaced(obj(), "f 1 4 3 2", "f -9 4 3 2"), "obj"),
             Catch::Contains("triangle 0 uses a vertex"));
}

TEST_CASE("Counts beyond the bytes of the file are refused before they take memory") {
  CHECK_THAT(error_of(replaced(text_ply(), "vertex 8", "vertex 4000000000"), "ply"),
             Catch::Contains("do not fit"));
  CHECK_THAT(error_of(replaced(off(), "8 6 12", "8 1999999999 0"), "off"),
             Catch::Contains("expected the numbers"));
  CHECK_FALSE(
      error_of(replaced(binary_stl(), std::string("\x0C\0\0\0", 4), "\xFF\xFF\xFF\xFF"), "stl")
          .empty());
}

TEST_CASE("A binary file cut anywhere is an error") {
  const std::string ply = binary_ply(Order::kLittle);
  const std::string stl = binary_stl();
  for (std::size_t size = 0; size < ply.size(); ++size) {
    CHECK_FALSE(read_mesh(std::string_view(ply).substr(0, size), "ply"));
  }
  for (std::size_t size = 0; size < stl.size(); size += 7) {
    CHECK_FALSE(read_mesh(std::string_view(stl).substr(0, size), "stl"));
  }
}

TEST_CASE("Damaged files give a sound mesh or an error") {
  Rng rng(1);
  const std::array<std::pair<std::string, std::string>, 5> files{{
      {"off", off()},
      {"obj", obj()},
      {"ply", text_ply()},
      {"ply", binary_ply(Order::kLittle)},
      {"ply", binary_ply(Order::kBig)},
  }};
  for (const auto& [extension, bytes] : files) {
    for (int trial = 0; trial < 300; ++trial) {
      std::string damaged = bytes;
      for (int i = 0; i < 3; ++i) {
        damaged[rng.below(damaged.size())] = static_cast<char>(rng.below(256));
      }

      const auto mesh = read_mesh(damaged, extension);

      if (!mesh) continue;
      for (const auto& triangle : mesh->triangles) {
        for (const std::uint32_t v : triangle) REQUIRE(v < mesh->vertices.size());
      }
    }
  }
}
