#include "core/formats/mesh_off.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/formats/mesh_build.h"
#include "core/formats/mesh_words.h"

namespace slipstick {
namespace {

class OffReader {
 public:
  explicit OffReader(std::string_view bytes) : rest_(bytes) {}

  Result<TriangleMesh> read() {
    std::string_view line = next_line();
    const std::string_view magic = take_word(line);
    if (!magic.ends_with("OFF") || magic.starts_with("4") || magic.starts_with("n")) {
      return damaged("expected \"OFF\"");
    }
    if (line.find_first_not_of(" \t") == std::string_view::npos) line = next_line();
    const auto vertices = take_count(line);
    const auto faces = take_count(line);
    if (!vertices || !faces) return damaged("expected the numbers of vertices and faces");
    if (const auto read = read_vertices(*vertices); !read) return fail(read.error());
    if (const auto read = read_faces(*faces); !read) return fail(read.error());
    return std::move(mesh_);
  }

 private:
  // The next line that says something, empty at the end of the file.
  std::string_view next_line() {
    while (const auto line = take_line(rest_)) {
      ++line_;
      const std::string_view text = line->substr(0, line->find('#'));
      if (text.find_first_not_of(" \t") != std::string_view::npos) return text;
    }
    return {};
  }

  // Every vertex and face needs bytes, so a count beyond those left is a lie.
  std::optional<std::size_t> take_count(std::string_view& line) const {
    const auto value = parse_number(take_word(line));
    if (!value || *value < 0 || *value > static_cast<double>(rest_.size())) return {};
    return static_cast<std::size_t>(*value);
  }

  Result<void> read_vertices(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view line = next_line();
      const auto point = take_point(line);
      if (!point) return damaged("expected a vertex of three finite numbers");
      mesh_.vertices.push_back(*point);
    }
    return {};
  }

  Result<void> read_faces(std::size_t count) {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view line = next_line();
      const auto corner_count = parse_number(take_word(line));
      if (!corner_count) return damaged("expected a face");
      corners.clear();
      while (static_cast<double>(corners.size()) < *corner_count) {
        const auto index = parse_number(take_word(line));
        if (!index) return damaged("expected the indices of a face");
        corners.push_back(to_vertex_index(*index));
      }
      add_polygon(mesh_, corners);
    }
    return {};
  }

  [[nodiscard]] tl::unexpected<Error> damaged(std::string_view what) const {
    return fail(ErrorCode::kInput,
                fmt::format("line {}: {}; export the model as text OFF again", line_, what));
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  TriangleMesh mesh_;
};

}  // namespace

Result<TriangleMesh> read_off(std::string_view bytes) {
  return OffReader(bytes).read();
}

}  // namespace slipstick
