#include "host/conversion.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "core/formats/bsp_file.h"
#include "core/formats/ldni_file.h"
#include "core/formats/rbf_file.h"
#include "core/solid/bsp_merge.h"
#include "core/solid/ldni_boolean.h"
#include "core/solid/ldni_sample.h"
#include "core/solid/rbf_model.h"
#include "host/mesh_as.h"

namespace slipstick {
namespace {

struct Operands {
  LoadedModel first;
  std::optional<LoadedModel> second;
};

Result<Operands> loaded_operands(const ConversionRequest& request) {
  auto first = load_model(request.model, request.loading);
  if (!first) return fail(first.error());
  if (request.with.empty()) return Operands{*std::move(first), {}};
  auto second = load_model(request.with, request.loading);
  if (!second) return fail(second.error());
  return Operands{*std::move(first), *std::move(second)};
}

Box3 bounds_of(const Operands& operands) {
  const Box3 box = operands.first.model->bounds_under({});
  if (!operands.second) return box;
  const Box3 more = operands.second->model->bounds_under({});
  return more.empty() ? box : box.with(more.low).with(more.high);
}

const Ldni* images_of(const LoadedModel& loaded) {
  const auto* model = dynamic_cast<const LdniModel*>(loaded.model.get());
  return model == nullptr ? nullptr : &model->ldni();
}

class Converter {
 public:
  Converter(const ConversionRequest& request, Operands operands)
      : request_(request), operands_(std::move(operands)) {
    warn(operands_.first.name, operands_.first.warning);
    if (operands_.second) warn(operands_.second->name, operands_.second->warning);
  }

  Result<Conversion> to_ldni() {
    const auto grid = common_grid();
    if (!grid) return fail(grid.error());
    auto images = images_on(operands_.first, *grid);
    if (images && operands_.second) {
      const auto more = images_on(*operands_.second, *grid);
      if (!more) return fail(more.error());
      images = merged(*images, request_.operation, *more);
    }
    if (!images) return fail(images.error());
    return done(write_ldni(*images), "ldni", size_text_of(*images));
  }

  Result<Conversion> to_bsp() {
    auto tree = tree_of(operands_.first);
    if (tree && operands_.second) {
      const auto more = tree_of(*operands_.second);
      if (!more) return fail(more.error());
      tree = merged(*tree, request_.operation, *more);
    }
    if (!tree) return fail(tree.error());
    std::string bytes = write_bsp(*tree);
    const auto model = BspModel::of(*std::move(tree));
    if (!model) return fail(model.error());
    return done(std::move(bytes), (*model)->kind(), (*model)->size_text());
  }

  Result<Conversion> to_rbf() {
    if (operands_.second) {
      return fail(ErrorCode::kInput,
                  "there is no Boolean operation of fits; join them as .ldni instead");
    }
    const auto* model = dynamic_cast<const RbfModel*>(operands_.first.model.get());
    if (model == nullptr) {
      return no_way(operands_.first, ".rbf",
                    "points with normals (.xyz, .pwn, .ply without faces)");
    }
    return done(write_rbf(*model), model->kind(), model->size_text());
  }

 private:
  // That of images that are there already; else around all.
  [[nodiscard]] Result<LdniGrid> common_grid() const {
    if (const Ldni* images = images_of(operands_.first)) return images->grid();
    if (operands_.second) {
      if (const Ldni* images = images_of(*operands_.second)) return images->grid();
    }
    return LdniGrid::around(bounds_of(operands_), request_.loading.resolution);
  }

  Result<Ldni> images_on(const LoadedModel& loaded, const LdniGrid& grid) {
    if (const Ldni* images = images_of(loaded)) return *images;
    if (const auto* mesh = dynamic_cast<const MeshModel*>(loaded.model.get())) {
      auto made = ldni_of(*mesh, grid);
      if (!made) return fail(made.error().within(loaded.name));
      warn(loaded.name, warning_of(made->mended));
      return std::move(made->ldni);
    }
    auto sampled = ldni_by_sampling(*loaded.model, grid);
    if (!sampled) return fail(sampled.error().within(loaded.name));
    return sampled;
  }

  static Result<BspTree> tree_of(const LoadedModel& loaded) {
    if (const auto* tree = dynamic_cast<const BspModel*>(loaded.model.get())) return tree->tree();
    const auto* mesh = dynamic_cast<const MeshModel*>(loaded.model.get());
    if (mesh == nullptr) return no_way(loaded, ".bsp", "a mesh");
    const auto made = bsp_model(*mesh);
    if (!made) return fail(made.error().within(loaded.name));
    return (*made)->tree();
  }

  static tl::unexpected<Error> no_way(const LoadedModel& loaded, const char* to, const char* from) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: there is no way from {} to {}; it is made from {}", loaded.name,
                            loaded.model->kind(), to, from));
  }

  void warn(const std::string& name, const std::string& warning) {
    if (!warning.empty()) warnings_.push_back(name + ": " + warning);
  }

  Conversion done(std::string bytes, std::string_view kind, std::string size_text) {
    return {std::move(bytes), std::string(kind), std::move(size_text), std::move(warnings_)};
  }

  const ConversionRequest& request_;
  Operands operands_;
  std::vector<std::string> warnings_;
};

}  // namespace

Result<Conversion> convert(const ConversionRequest& request) {
  const std::string kind = request.output.extension().string();
  if (kind != ".ldni" && kind != ".bsp" && kind != ".rbf") {
    return fail(ErrorCode::kInput,
                fmt::format("{}: outputs are .ldni, .bsp and .rbf", request.output.string()));
  }
  auto operands = loaded_operands(request);
  if (!operands) return fail(operands.error());
  Converter converter(request, *std::move(operands));
  if (kind == ".ldni") return converter.to_ldni();
  return kind == ".bsp" ? converter.to_bsp() : converter.to_rbf();
}

}  // namespace slipstick
