#include "core/formats/rbf_file.h"

#include <fmt/format.h>

#include "core/formats/sealed.h"

namespace slipstick {
namespace {

constexpr SealedKind kKind{"SLIPRBF\n", 1};
constexpr std::size_t kFunctionSize = 14 * sizeof(double);

RbfFunction take_function(std::string_view& rest) {
  RbfFunction f;
  f.centre.x = take_f64(rest);
  f.centre.y = take_f64(rest);
  f.centre.z = take_f64(rest);
  f.radius = take_f64(rest);
  for (double& c : f.quadric) c = take_f64(rest);
  return f;
}

Result<std::unique_ptr<RbfModel>> read(std::string_view bytes) {
  const auto body = unseal(kKind, bytes);
  if (!body) return fail(body.error());
  std::string_view rest = *body;
  const std::uint64_t count = rest.size() < sizeof(count) ? 0 : take_u64(rest);
  if (rest.size() % kFunctionSize != 0 || count != rest.size() / kFunctionSize) {
    return fail(ErrorCode::kInput, fmt::format("says {} basis functions but has {} bytes of them; "
                                               "it is damaged, make it again",
                                               count, rest.size()));
  }
  std::vector<RbfFunction> functions;
  functions.reserve(count);
  while (!rest.empty()) functions.push_back(take_function(rest));
  return RbfModel::of(std::move(functions));
}

}  // namespace

std::string write_rbf(const RbfModel& model) {
  std::string body;
  body.reserve(sizeof(std::uint64_t) + model.functions().size() * kFunctionSize);
  append_u64(body, model.functions().size());
  for (const RbfFunction& f : model.functions()) {
    for (const double v : {f.centre.x, f.centre.y, f.centre.z, f.radius}) append_f64(body, v);
    for (const double c : f.quadric) append_f64(body, c);
  }
  return seal(kKind, body);
}

Result<std::unique_ptr<RbfModel>> load_rbf_model(std::string_view bytes, std::string_view name) {
  auto model = read(bytes);
  if (!model) return fail(model.error().within(name));
  return model;
}

}  // namespace slipstick
