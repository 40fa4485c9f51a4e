#include "core/formats/bsp_file.h"

#include <fmt/format.h>

#include "core/formats/sealed.h"

namespace slipstick {
namespace {

constexpr SealedKind kKind{"SLIPBSP\n", 1};
constexpr std::size_t kNodeSize = 4 * sizeof(double) + 2 * sizeof(std::uint32_t);
constexpr std::uint64_t kNodesMax = std::uint64_t{1} << 30;

BspNode take_node(std::string_view& rest) {
  BspNode node;
  node.plane.normal.x = take_f64(rest);
  node.plane.normal.y = take_f64(rest);
  node.plane.normal.z = take_f64(rest);
  node.plane.offset = take_f64(rest);
  node.front = static_cast<BspChild>(take_u32(rest));
  node.back = static_cast<BspChild>(take_u32(rest));
  return node;
}

Result<std::unique_ptr<BspModel>> read(std::string_view bytes) {
  const auto body = unseal(kKind, bytes);
  if (!body) return fail(body.error());
  std::string_view rest = *body;
  const std::uint64_t count = rest.size() < sizeof(count) ? kNodesMax + 1 : take_u64(rest);
  if (rest.size() % kNodeSize != 0 || count != rest.size() / kNodeSize || count > kNodesMax) {
    return fail(ErrorCode::kInput, fmt::format("says {} nodes but has {} bytes of them; it is "
                                               "damaged, make it again",
                                               count, rest.size()));
  }
  std::vector<BspNode> nodes;
  nodes.reserve(count);
  while (!rest.empty()) nodes.push_back(take_node(rest));
  auto tree = BspTree::of(std::move(nodes));
  if (!tree) return fail(tree.error());
  return BspModel::of(*std::move(tree));
}

}  // namespace

std::string write_bsp(const BspTree& tree) {
  std::string body;
  body.reserve(sizeof(std::uint64_t) + tree.nodes().size() * kNodeSize);
  append_u64(body, tree.nodes().size());
  for (const BspNode& node : tree.nodes()) {
    const Vec3 n = node.plane.normal;
    for (const double v : {n.x, n.y, n.z, node.plane.offset}) append_f64(body, v);
    append_u32(body, static_cast<std::uint32_t>(node.front));
    append_u32(body, static_cast<std::uint32_t>(node.back));
  }
  return seal(kKind, body);
}

Result<std::unique_ptr<BspModel>> load_bsp_model(std::string_view bytes, std::string_view name) {
  auto model = read(bytes);
  if (!model) return fail(model.error().within(name));
  return model;
}

}  // namespace slipstick
