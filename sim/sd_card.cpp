#include "sim/sd_card.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace slipstick {

namespace {

/// "/PART~1.GCO" of what stands behind a command: a card's names have no lower case.
std::string name_of(std::string_view text) {
  const std::size_t from = std::min(text.find_first_not_of(" /"), text.size());
  text.remove_prefix(from);
  std::string name(text.substr(0, text.find(' ')));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

}  // namespace

std::size_t SdCard::bytes() const {
  std::size_t sum = 0;
  for (const auto& [name, text] : files_) sum += name.size() + text.size();
  return sum;
}

bool SdCard::writes(std::string_view line) {
  if (writing_.empty() || line.starts_with("M29")) return false;
  if (bytes() + line.size() < kBytesMax) files_[writing_].append(line).append("\n");
  return true;
}

std::string SdCard::list() const {
  std::string text = "Begin file list\n";
  for (const auto& [name, content] : files_) text += fmt::format("{} {}\n", name, content.size());
  return text + "End file list\n";
}

std::string SdCard::open(std::string_view name) {
  const auto file = files_.find(std::string(name));
  printing_ = false;
  at_ = 0;
  if (file == files_.end()) {
    selected_.clear();
    return fmt::format("open failed, File: {}.\n", name);
  }
  selected_ = name;
  return fmt::format("File opened: {} Size: {}\nFile selected\n", name, file->second.size());
}

std::string SdCard::status() const {
  if (!printing_) return "Not SD printing\n";
  return fmt::format("SD printing byte {}/{}\n", at_, files_.at(selected_).size());
}

std::optional<std::string> SdCard::run(const GcodeCommand& command) {
  if (command.letter() != 'M') return std::nullopt;
  const std::string name = name_of(command.text());
  switch (command.code()) {
    case 20:
      return mounted_ ? list() : "echo:No media\n";
    case 21:
      mounted_ = true;
      return "echo:SD card ok\n";
    case 22:
      mounted_ = printing_ = false;
      return "echo:SD card released\n";
    case 23:
      return open(name);
    case 24:
      printing_ = !selected_.empty() && mounted_;
      return "";
    case 25:
      printing_ = false;
      return "";
    case 26:
      at_ = static_cast<std::size_t>(
          std::clamp(command.value('S').value_or(0), 0.0,
                     selected_.empty() ? 0.0 : static_cast<double>(files_.at(selected_).size())));
      return "";
    case 27:
      return status();
    case 28:
      if (name.empty()) return "open failed, File: .\n";
      writing_ = name;
      files_[name].clear();
      return fmt::format("Writing to file: {}\n", name);
    case 29:
      writing_.clear();
      return "Done saving file.\n";
    case 30:
      if (selected_ == name) {
        selected_.clear();
        printing_ = false;
      }
      return fmt::format(
          "{}{}\n", files_.erase(name) > 0 ? "File deleted:" : "Deletion failed, File: ", name);
    default:
      return std::nullopt;
  }
}

std::optional<SdCard::Next> SdCard::next() {
  if (!printing_) return std::nullopt;
  const std::string& text = files_.at(selected_);
  if (at_ >= text.size()) {
    printing_ = false;
    return Next{std::nullopt, "Done printing file\n"};
  }
  const std::size_t end = std::min(text.find('\n', at_), text.size());
  Next next{text.substr(at_, end - at_), ""};
  at_ = end + 1;
  return next;
}

}  // namespace slipstick
