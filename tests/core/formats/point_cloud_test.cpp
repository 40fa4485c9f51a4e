#include "core/formats/point_cloud.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <limits>
#include <string>

using namespace slipstick;

namespace {

constexpr int kCount = 20;

std::string six(int i) {
  return fmt::format("{} {} {} 0 0 {}\n", i, i * i, -i, i + 1);
}

std::string xyz() {
  std::string text = "# made by hand\n\n";
  for (int i = 0; i < kCount; ++i) text += six(i);
  return text;
}

std::string ply() {
  std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", kCount);
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    text += fmt::format("property float {}\n", name);
  }
  text += "end_header\n";
  for (int i = 0; i < kCount; ++i) text += six(i);
  return text;
}

// Binary, the normal of point 7 as given.
std::string binary_ply(Vec3 normal) {
  std::string bytes = ply();
  bytes.erase(bytes.find("end_header\n") + 11);
  bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
  for (int i = 0; i < kCount; ++i) {
    const Vec3 n = i == 7 ? normal : Vec3{0, 0, 1};
    for (const double v : {1.0 * i, 1.0 * i * i, -1.0 * i, n.x, n.y, n.z}) {
      const auto bits = std::bit_cast<std::array<char, 4>>(static_cast<float>(v));
      bytes.append(bits.data(), bits.size());
    }
  }
  return bytes;
}

std::string ohtake_pwn() {
  std::string text = fmt::format("{}\n", kCount);
  for (int i = 0; i < kCount; ++i) text += fmt::format("{} {} {}\n", i, i * i, -i);
  for (int i = 0; i < kCount; ++i) text += fmt::format("0 0 {}\n", i + 1);
  return text;
}

std::string error_of(const std::string& bytes, std::string_view extension) {
  const auto cloud = read_point_cloud(bytes, extension);
  REQUIRE_FALSE(cloud);
  CHECK(cloud.error().code == ErrorCode::kInput);
  return cloud.error().message;
}

}  // namespace

TEST_CASE("Every format of points gives the same points and unit normals") {
  for (const auto& [bytes, extension] : {std::pair{xyz(), "XYZ"}, std::pair{xyz(), "pwn"},
                                         std::pair{ohtake_pwn(), "pwn"}, std::pair{ply(), "ply"}}) {
    const auto cloud = read_point_cloud(bytes, extension);
    REQUIRE(cloud);
    REQUIRE(cloud->points.size() == kCount);
    CHECK(cloud->points[3] == Vec3{3, 9, -3});
    for (const Vec3 n : cloud->normals) CHECK(n == Vec3{0, 0, 1});
  }
}

TEST_CASE("A PLY file without faces is a point cloud") {
  CHECK(ply_is_point_cloud(ply()));
  std::string mesh = ply();
  mesh.insert(mesh.find("end_header"), "element face 1\nproperty list uchar int vertex_indices\n");
  CHECK_FALSE(ply_is_point_cloud(mesh + "3 0 1 2\n"));
  CHECK_FALSE(ply_is_point_cloud("not a ply"));
}

TEST_CASE("A normal that is not a number is refused, whichever of its coordinates it is") {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  REQUIRE(read_point_cloud(binary_ply({0, 1, 0}), "ply"));
  for (const Vec3 normal : {Vec3{kNaN, 0, 1}, Vec3{1, kNaN, 0}, Vec3{1, 0, kNaN}}) {
    CHECK(error_of(binary_ply(normal), "ply").starts_with("point 7 is beyond 1e+09"));
  }
}

TEST_CASE("Bad point clouds are refused with the place and the reason") {
  CHECK(error_of(xyz() + "1 2 3\n", "xyz") ==
        "line 23 is not six numbers; points need normals (x y z nx ny nz)");
  CHECK(error_of("1 2 3 0 0 1\n", "xyz") == "has 1 points; 16 to 16777216 can be fitted");
  CHECK(error_of(xyz() + "nan 2 3 0 0 1\n", "xyz").starts_with("line 23 is not six numbers"));
  CHECK(error_of(xyz() + "1e300 2 3 0 0 1\n", "xyz").starts_with("point 20 is beyond 1e+09"));
  CHECK(error_of(xyz() + "1 2 3 0 0 0\n", "xyz").starts_with("point 20 is beyond 1e+09"));
  CHECK(error_of("1000000000\n1 2 3\n", "pwn").starts_with("says it has 1e+09 points but only"));
  CHECK(error_of("4\n1 2 3\n", "pwn").starts_with("ends after 2 lines, 4 points"));
  CHECK(error_of(ohtake_pwn() + "1 1 1\n", "pwn").starts_with("line 42 is not the end"));
  CHECK(error_of(ply().substr(0, 300), "ply").starts_with("ends or turns into something else"));
  std::string no_normals = ply();
  no_normals.replace(no_normals.find("float nz"), 8, "float mz");
  CHECK(error_of(no_normals, "ply").starts_with("has no vertices with x y z nx ny nz"));
  CHECK(error_of(xyz(), "abc").starts_with("\"abc\" is no format of points"));
  std::string one_place;
  for (int i = 0; i < kCount; ++i) one_place += "1 2 3 0 0 1\n";
  CHECK(error_of(one_place, "xyz") == "has all its points in one place");
}
