#include "tests/support/http_dialogue.h"

#include <fstream>
#include <utility>

#include "core/base/check.h"

namespace slipstick::test {
namespace {

// Takes the first word and the blank behind it off.
std::string take_word(std::string& text) {
  const std::size_t blank = std::min(text.find(' '), text.size());
  std::string word = text.substr(0, blank);
  text.erase(0, std::min(blank + 1, text.size()));
  return word;
}

WantedOfReply wanted_member(std::string text) {
  using Kind = WantedOfReply::Kind;
  const std::string where = take_word(text);
  if (text.empty()) return {Kind::kMember, where, ""};
  SLIPSTICK_CHECK(text[0] == '^' || text[0] == '=');
  return {text[0] == '^' ? Kind::kTextThatBegins : Kind::kValue, where, text.substr(1)};
}

WantedOfReply wanted_header(std::string text) {
  std::string where = take_word(text);
  return {WantedOfReply::Kind::kHeader, std::move(where), std::move(text)};
}

void add_line(HttpDialogue& dialogue, DialogueTurn& turn, std::string line) {
  const std::string word = take_word(line);
  if (word.empty() || word == "#") return;
  if (word == "connect") {
    turn.connects = true;
  } else if (word == ">") {
    turn.bytes += line + "\r\n";
  } else if (word == "|") {
    turn.bytes += line + "\n";
  } else if (word == ".") {
    turn.bytes += line;
  } else if (word == "<") {
    turn.status = std::stoi(line);
    dialogue.turns.push_back(std::exchange(turn, {}));
  } else if (word == "<header") {
    dialogue.turns.back().wanted.push_back(wanted_header(line));
  } else if (word == "<json") {
    dialogue.turns.back().wanted.push_back(wanted_member(line));
  } else if (word == "stored") {
    std::string name = take_word(line);
    dialogue.stored.push_back({std::move(name), std::stoi(line)});
  } else {
    SLIPSTICK_CHECK(word == "printed");
    dialogue.printed = line;
  }
}

}  // namespace

HttpDialogue read_dialogue(const std::string& path) {
  std::ifstream file(path);
  SLIPSTICK_CHECK(file.is_open());
  HttpDialogue dialogue;
  DialogueTurn turn;
  for (std::string line; std::getline(file, line);) add_line(dialogue, turn, line);
  SLIPSTICK_CHECK(turn.bytes.empty() && !dialogue.turns.empty());
  return dialogue;
}

std::string with_value(std::string text, const std::string& name, const std::string& value) {
  const std::string place = "{" + name + "}";
  for (std::size_t at = 0; (at = text.find(place, at)) != text.npos; at += value.size()) {
    text.replace(at, place.size(), value);
  }
  return text;
}

}  // namespace slipstick::test
