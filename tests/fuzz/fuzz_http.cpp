// Addresses and forms as a network sends them: the first line is an address, the rest a form. A
// form comes out the same in one piece and in small ones; what an address was decoded from it can
// be encoded to again.
#include <string>

#include "core/base/check.h"
#include "host/serve/file_names.h"
#include "host/serve/multipart.h"
#include "host/serve/routes.h"

using namespace slipstick;

namespace {

struct Form {
  std::string text;
  bool good = true;
  friend bool operator==(const Form&, const Form&) = default;
};

Form parsed(std::string_view body, std::size_t piece) {
  Form form;
  MultipartParser parser("b", {[&](const std::string& name, const std::string& value) {
                                 form.text += "field " + name + "=" + value + ";";
                               },
                               [&](const std::string& name) -> Result<void> {
                                 form.text += "file " + name + ";";
                                 return {};
                               },
                               [&](std::string_view bytes) -> Result<void> {
                                 form.text += bytes;
                                 return {};
                               }});
  for (; form.good && !body.empty(); body.remove_prefix(std::min(piece, body.size()))) {
    form.good = parser.feed(body.substr(0, piece)).has_value();
  }
  if (!form.good) form.text.clear();  // how far it came depends on the pieces
  form.good = form.good && parser.complete();
  return form;
}

void check_target(std::string_view text) {
  const auto target = parse_http_target(text);
  if (!target) return;
  std::string again;
  for (const std::string& segment : target->path) again += "/" + percent_encoded(segment);
  if (again.size() <= HttpTarget::kSizeMax) {
    SLIPSTICK_CHECK(parse_http_target(again)->path == target->path);
  }
  const Found found = find_route(HttpMethod::kGet, *target);
  SLIPSTICK_CHECK(found.route != nullptr || found.refusal.status >= 400);
  for (const std::string& segment : target->path) {
    const auto name = FileName::from(segment);
    if (name) SLIPSTICK_CHECK(name->text().find('/') == std::string::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t line = std::min(input.find('\n'), input.size());
  check_target(input.substr(0, line));
  const std::string_view body = input.substr(std::min(line + 1, input.size()));
  SLIPSTICK_CHECK(parsed(body, 1) == parsed(body, 64 << 10));
  SLIPSTICK_CHECK(parsed(body, 7) == parsed(body, 64 << 10));
  return 0;
}
