#include "core/formats/ldni_file.h"

#include <bit>
#include <catch2/catch.hpp>

#include "core/formats/lda_file.h"
#include "core/formats/sealed.h"
#include "core/solid/ldni_build.h"
#include "tests/support/shapes.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

Ldni torus_images() {
  const MeshModel mesh(mesh_of(shapes()[1], 12));
  const auto made = ldni_of(mesh, *LdniGrid::around(mesh.bounds_under({}), 24));
  REQUIRE(made);
  return made->ldni;
}

void append_f32(std::string& bytes, double value) {
  append_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

// Written as the format is described, by nothing that reads it.
std::string lda_of(const Ldni& ldni) {
  const LdniGrid& grid = ldni.grid();
  std::string bytes;
  append_u32(bytes, static_cast<std::uint32_t>(grid.resolution()));
  for (const double v : {grid.width(), grid.origin().x, grid.origin().y, grid.origin().z}) {
    append_f32(bytes, v);
  }
  for (const LdniRays& rays : ldni.axes()) {
    for (const std::uint32_t first : rays.first) append_u32(bytes, first);
    const auto unit = [](const LdniNormal& n) {
      const Vec3 v{double(n.along(0)), double(n.along(1)), double(n.along(2))};
      return 1 / length(v) * v;
    };
    for (const LdniSample& s : rays.samples) append_f32(bytes, unit(s.normal).x);
    for (const LdniSample& s : rays.samples) append_f32(bytes, unit(s.normal).y);
    for (const LdniSample& s : rays.samples) {
      const double depth = double(s.depth) / LdniGrid::kUnits * grid.width();
      append_f32(bytes, s.normal.along(2) < 0 ? -depth : depth);
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("What is written as .ldni is read as it was") {
  const Ldni ldni = torus_images();
  const std::string bytes = write_ldni(ldni);
  const auto model = load_ldni_model(bytes, "a.ldni");
  REQUIRE(model);
  CHECK((*model)->ldni() == ldni);
  CHECK((*model)->size_text().find("24 x 24 rays an axis") == 0);
}

TEST_CASE("Any byte changed and any end cut off makes a .ldni an error that names it") {
  const std::string bytes = write_ldni(torus_images());
  for (std::size_t i = 0; i < bytes.size(); i += 97) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    const auto read = load_ldni_model(damaged, "a.ldni");
    REQUIRE(!read);
    CHECK(read.error().message.find("a.ldni: ") == 0);
    CHECK(!load_ldni_model(std::string_view(bytes).substr(0, i), "a.ldni"));
  }
}

TEST_CASE("A .ldni with a right checksum is still checked ray by ray") {
  std::string body;
  append_u32(body, 1 << 20);
  for (const double v : {1.0, 0.0, 0.0, 0.0}) append_f64(body, v);
  const auto huge = load_ldni_model(seal({"SLIPLDN\n", 1}, body), "a.ldni");
  REQUIRE(!huge);
  CHECK(huge.error().message.find("rays a side") != std::string::npos);
  std::string cut = write_ldni(torus_images());
  cut = cut.substr(20, cut.size() - 24 - 30);
  const auto ended = load_ldni_model(seal({"SLIPLDN\n", 1}, cut), "a.ldni");
  REQUIRE(!ended);
  CHECK(ended.error().message.find("is damaged") != std::string::npos);
}

TEST_CASE("A .lda has the memberships of the images that it was written from") {
  const Ldni ldni = torus_images();
  const std::string bytes = lda_of(ldni);
  const auto read = load_lda_model(bytes, "a.lda");
  REQUIRE(read);
  REQUIRE((*read)->ldni().samples() == ldni.samples());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < ldni.axes()[axis].samples.size(); ++k) {
      const LdniSample a = ldni.axes()[axis].samples[k],
                       b = (*read)->ldni().axes()[axis].samples[k];
      // A float has 24 bits, a depth of 24 widths 25.
      CHECK(std::abs(double(a.depth) - double(b.depth)) <= 2);
      for (std::size_t n = 0; n < 3; ++n)
        CHECK(std::abs(a.normal.along(n) - b.normal.along(n)) <= 1);
    }
  }
  for (const std::size_t cut : {std::size_t{3}, std::size_t{30}, bytes.size() - 1}) {
    CHECK(!load_lda_model(std::string_view(bytes).substr(0, cut), "a.lda"));
  }
  CHECK(!load_lda_model(bytes + "x", "a.lda"));
}
