#include "core/formats/point_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/number_text.h"
#include "core/formats/mesh.h"
#include "core/formats/mesh_words.h"
#include "core/formats/point_cloud_ply.h"

namespace slipstick {
namespace {

// The numbers of a line; nothing if it has anything else or more than six.
struct LineNumbers {
  std::array<double, 6> values{};
  std::size_t count = 0;
};

std::optional<LineNumbers> numbers_of(std::string_view line) {
  LineNumbers numbers;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    const auto value = parse_number(word);
    if (!value || numbers.count == numbers.values.size()) return {};
    numbers.values[numbers.count++] = *value;
  }
  return numbers;
}

bool is_blank(std::string_view line) {
  const std::string_view word = take_word(line);
  return word.empty() || word.starts_with('#');
}

tl::unexpected<Error> bad_line(std::size_t number, std::string_view wanted) {
  return fail(
      ErrorCode::kInput,
      fmt::format("line {} is not {}; points need normals (x y z nx ny nz)", number, wanted));
}

class TextReader {
 public:
  explicit TextReader(std::string_view rest) : rest_(rest) {}

  // The next line that says something; nothing at the end.
  std::optional<std::string_view> line() {
    while (const auto next = take_line(rest_)) {
      ++number_;
      if (!is_blank(*next)) return next;
    }
    return {};
  }

  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

Result<PointCloud> read_lines(std::string_view bytes) {
  PointCloud cloud;
  TextReader reader(bytes);
  while (const auto line = reader.line()) {
    const auto n = numbers_of(*line);
    if (!n || n->count != 6) return bad_line(reader.number(), "six numbers");
    const auto& v = n->values;
    cloud.points.push_back({v[0], v[1], v[2]});
    cloud.normals.push_back({v[3], v[4], v[5]});
  }
  return cloud;
}

Result<void> read_triples(TextReader& reader, std::size_t count, std::vector<Vec3>& triples) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto line = reader.line();
    if (!line) {
      return fail(ErrorCode::kInput, fmt::format("ends after {} lines, {} points and as many "
                                                 "normals were to come; it is cut short",
                                                 reader.number(), count));
    }
    const auto n = numbers_of(*line);
    if (!n || n->count != 3) return bad_line(reader.number(), "three numbers");
    triples.push_back({n->values[0], n->values[1], n->values[2]});
  }
  return {};
}

Result<PointCloud> read_pwn(std::string_view bytes) {
  TextReader reader(bytes);
  const auto first = reader.line();
  const auto head = first ? numbers_of(*first) : std::nullopt;
  if (!head || head->count != 1) return read_lines(bytes);
  const double count = head->values[0];
  if (!(count >= 0 && count <= static_cast<double>(reader.bytes_left())) ||
      count != std::floor(count)) {
    return fail(ErrorCode::kInput, fmt::format("says it has {:g} points but only {} bytes; it is "
                                               "cut short or damaged",
                                               count, reader.bytes_left()));
  }
  PointCloud cloud;
  const auto points = static_cast<std::size_t>(count);
  if (const auto ok = read_triples(reader, points, cloud.points); !ok) return fail(ok.error());
  if (const auto ok = read_triples(reader, points, cloud.normals); !ok) return fail(ok.error());
  if (reader.line()) return bad_line(reader.number(), "the end of the file");
  return cloud;
}

Result<PointCloud> read_raw(std::string_view bytes, std::string_view extension) {
  std::string kind(extension);
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind == "xyz") return read_lines(bytes);
  if (kind == "pwn") return read_pwn(bytes);
  if (kind == "ply") return read_ply_points(bytes);
  return fail(ErrorCode::kInput,
              fmt::format("\"{}\" is no format of points; use xyz, pwn or ply", extension));
}

bool in_range(Vec3 p) {
  const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most <= kMeshCoordinateMax && std::isfinite(p.x + p.y + p.z);
}

// Unit length, or nothing; scaled first, so that no square overflows or vanishes.
std::optional<Vec3> normalised(Vec3 n) {
  const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  if (!(most > 0 && std::isfinite(most) && std::isfinite(1 / most))) return {};
  const Vec3 scaled = (1 / most) * n;
  // The largest of three does not see every NaN.
  if (std::isnan(scaled.x + scaled.y + scaled.z)) return {};
  return (1 / length(scaled)) * scaled;
}

Result<PointCloud> cleaned(PointCloud cloud) {
  if (cloud.points.size() < kCloudPointsMin || cloud.points.size() > kCloudPointsMax) {
    return fail(ErrorCode::kInput,
                fmt::format("has {} points; {} to {} can be fitted", cloud.points.size(),
                            kCloudPointsMin, kCloudPointsMax));
  }
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const auto normal = normalised(cloud.normals[i]);
    if (!in_range(cloud.points[i]) || !normal) {
      return fail(ErrorCode::kInput,
                  fmt::format("point {} is beyond {:g} or not a number, or its normal has no "
                              "direction; export the points again",
                              i, kMeshCoordinateMax));
    }
    cloud.normals[i] = *normal;
  }
  if (std::all_of(cloud.points.begin(), cloud.points.end(),
                  [&](Vec3 p) { return p == cloud.points[0]; })) {
    return fail(ErrorCode::kInput, "has all its points in one place");
  }
  return cloud;
}

}  // namespace

Result<PointCloud> read_point_cloud(std::string_view bytes, std::string_view extension) {
  if (bytes.size() > kMeshBytesMax) {
    return fail(ErrorCode::kInput, fmt::format("has {} bytes, at most {} are read; thin it out",
                                               bytes.size(), kMeshBytesMax));
  }
  auto raw = read_raw(bytes, extension);
  if (!raw) return fail(raw.error());
  return cleaned(*std::move(raw));
}

}  // namespace slipstick
