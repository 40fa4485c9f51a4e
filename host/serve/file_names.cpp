#include "host/serve/file_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace slipstick {
namespace {

constexpr std::array<std::string_view, 3> kGcode{".gcode", ".gco", ".g"};
constexpr std::array<std::string_view, 13> kModels{".lua", ".vm",  ".ldni", ".lda", ".bsp",
                                                   ".rbf", ".stl", ".obj",  ".ply", ".off",
                                                   ".3mf", ".xyz", ".pwn"};

template <std::size_t kCount>
bool among(const std::array<std::string_view, kCount>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string lower_extension(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  std::string extension(name.substr(dot));
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// Bytes that follow a first byte, and the range of the second; 0 for what cannot begin a character.
struct Lead {
  int following = -1;
  unsigned char low = 0x80;
  unsigned char high = 0xbf;
};

Lead lead_of(unsigned char c) {
  if (c < 0x80) return {0};
  if (c >= 0xc2 && c <= 0xdf) return {1};
  if (c == 0xe0) return {2, 0xa0};        // shorter forms exist
  if (c == 0xed) return {2, 0x80, 0x9f};  // surrogates
  if (c >= 0xe1 && c <= 0xef) return {2};
  if (c == 0xf0) return {3, 0x90};
  if (c >= 0xf1 && c <= 0xf3) return {3};
  if (c == 0xf4) return {3, 0x80, 0x8f};  // beyond U+10FFFF
  return {};
}

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    Lead lead = lead_of(static_cast<unsigned char>(text[i]));
    if (lead.following < 0) return false;
    for (; lead.following > 0; --lead.following) {
      if (++i == text.size()) return false;
      const auto c = static_cast<unsigned char>(text[i]);
      if (c < lead.low || c > lead.high) return false;
      lead.low = 0x80;
      lead.high = 0xbf;
    }
  }
  return true;
}

std::string_view last_segment(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

Result<FileName> FileName::from(std::string_view text) {
  const auto refuse = [&](std::string_view why) {
    return fail(ErrorCode::kInput, fmt::format("file name: {}", why));
  };
  if (text.empty()) return refuse("is empty");
  if (text.size() > kSizeMax) return refuse("is longer than 200 bytes");
  if (!is_utf8(text)) return refuse("is not UTF-8");
  if (std::any_of(text.begin(), text.end(), is_control)) return refuse("has control characters");
  if (text.find_first_of("/\\") != std::string_view::npos) return refuse("has slashes");
  if (text[0] == '.') return refuse("begins with a dot");
  std::string extension = lower_extension(text);
  if (!among(kGcode, extension) && !among(kModels, extension)) {
    return refuse(fmt::format("nothing that can be printed; there are {}, {}",
                              fmt::join(kModels, ", "), fmt::join(kGcode, ", ")));
  }
  return FileName(std::string(text), std::move(extension));
}

bool FileName::is_gcode() const {
  return among(kGcode, extension_);
}

}  // namespace slipstick
