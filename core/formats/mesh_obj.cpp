#include "core/formats/mesh_obj.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/formats/mesh_build.h"
#include "core/formats/mesh_words.h"

namespace slipstick {
namespace {

class ObjReader {
 public:
  explicit ObjReader(std::string_view bytes) : rest_(bytes) {}

  Result<TriangleMesh> read() {
    while (auto line = take_line(rest_)) {
      ++line_;
      std::string joined;
      while (line->ends_with('\\')) {
        joined.append(line->substr(0, line->size() - 1)) += ' ';
        line = take_line(rest_).value_or(std::string_view());
        ++line_;
      }
      const std::string_view whole = joined.empty() ? *line : std::string_view(joined += *line);
      if (const auto read = read_line(whole.substr(0, whole.find('#'))); !read) {
        return fail(read.error());
      }
    }
    return std::move(mesh_);
  }

 private:
  Result<void> read_line(std::string_view words) {
    const std::string_view keyword = take_word(words);
    if (keyword == "v") return read_vertex(words);
    if (keyword == "f") return read_face(words);
    return {};
  }

  Result<void> read_vertex(std::string_view words) {
    const auto point = take_point(words);
    if (!point) return damaged("expected a vertex of three finite numbers");
    mesh_.vertices.push_back(*point);
    return {};
  }

  Result<void> read_face(std::string_view words) {
    corners_.clear();
    for (auto word = take_word(words); !word.empty(); word = take_word(words)) {
      const auto index = parse_number(word.substr(0, word.find('/')));
      if (!index || *index != std::floor(*index)) return damaged("expected the indices of a face");
      const auto count = static_cast<double>(mesh_.vertices.size());
      corners_.push_back(to_vertex_index(*index < 0 ? count + *index : *index - 1));
    }
    add_polygon(mesh_, corners_);
    return {};
  }

  [[nodiscard]] tl::unexpected<Error> damaged(std::string_view what) const {
    return fail(ErrorCode::kInput,
                fmt::format("line {}: {}; export the model as OBJ again", line_, what));
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

Result<TriangleMesh> read_obj(std::string_view bytes) {
  return ObjReader(bytes).read();
}

}  // namespace slipstick
