#include "host/outputs/picture_sink.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "host/atomic_file.h"
#include "host/outputs/canvas.h"
#include "host/outputs/layer_picture.h"

namespace slipstick {
namespace {

constexpr double kTile = 320;
constexpr double kSingle = 1000;

LayerPicture picture_of(const SlicedLayer& layer) {
  return {layer.index, layer.middle, layer.contours.outline,
          layer.toolpaths ? layer.toolpaths->beads : std::vector<Bead>()};
}

Box2 area_of(const SlicingJob& job) {
  const SliceGrid& grid = job.grid();
  return {{grid.node_x(0), grid.node_y(0)},
          {grid.node_x(grid.columns() - 1), grid.node_y(grid.rows() - 1)}};
}

class SheetSink final : public LayerSink {
 public:
  SheetSink(std::filesystem::path path, Canvas::Format format, const SinkContext& context)
      : path_(std::move(path)), format_(format), area_(area_of(*context.job)) {
    const int first = context.job->first_layer();
    const int count = context.job->end_layer() - first;
    const int tiles = std::min(count, kSheetTilesMax);
    for (int i = 0; i < tiles; ++i) chosen_.insert(first + (2 * i + 1) * count / (2 * tiles));
  }

  Result<void> add(const SlicedLayer& layer) override {
    if (chosen_.contains(layer.index)) pictures_.push_back(picture_of(layer));
    return {};
  }

  Result<void> finish() override {
    const auto tiles = static_cast<double>(pictures_.size());
    const double columns = std::ceil(std::sqrt(tiles * 1.25));
    const double rows = std::ceil(tiles / columns);
    Canvas canvas(format_, columns * kTile, rows * kTile);
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      const double at = static_cast<double>(i);
      const Frame frame{std::fmod(at, columns) * kTile, std::floor(at / columns) * kTile, kTile};
      draw_layer(canvas.cairo(), pictures_[i], area_, frame);
    }
    return canvas.write_to(path_);
  }

 private:
  const std::filesystem::path path_;
  const Canvas::Format format_;
  const Box2 area_;
  std::set<int> chosen_;
  std::vector<LayerPicture> pictures_;
};

// Draws into a folder beside the wanted one and gives it its name at the end.
class FolderSink final : public LayerSink {
 public:
  FolderSink(std::filesystem::path path, std::filesystem::path part, Canvas::Format format,
             const SinkContext& context)
      : path_(std::move(path)),
        part_(std::move(part)),
        format_(format),
        area_(area_of(*context.job)) {}

  ~FolderSink() override {
    std::error_code ignored;
    std::filesystem::remove_all(part_, ignored);
  }

  Result<void> add(const SlicedLayer& layer) override {
    Canvas canvas(format_, kSingle, kSingle);
    draw_layer(canvas.cairo(), picture_of(layer), area_, {0, 0, kSingle});
    return canvas.write_to(part_ /
                           fmt::format("layer_{:05}{}", layer.index, path_.extension().string()));
  }

  Result<void> finish() override {
    std::error_code error;
    std::filesystem::rename(part_, path_, error);
    if (!error) return {};
    return fail(ErrorCode::kUnavailable,
                fmt::format("cannot write {}: {}", path_.string(), error.message()));
  }

 private:
  const std::filesystem::path path_;
  const std::filesystem::path part_;
  const Canvas::Format format_;
  const Box2 area_;
};

Result<std::unique_ptr<LayerSink>> make_folder_sink(const std::filesystem::path& path,
                                                    Canvas::Format format,
                                                    const SinkContext& context) {
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    return fail(ErrorCode::kInput,
                fmt::format("{} exists; remove it or name another folder", path.string()));
  }
  std::filesystem::path part = path;
  part += fmt::format(".part{}", ::getpid());
  if (!std::filesystem::create_directory(part, error)) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("cannot write {}: {}", path.string(), error.message()));
  }
  return std::make_unique<FolderSink>(path, part, format, context);
}

}  // namespace

Result<std::unique_ptr<LayerSink>> make_picture_sink(const std::filesystem::path& path,
                                                     PictureLayout layout,
                                                     const SinkContext& context) {
  const auto format = Canvas::format_of(path);
  if (!format) {
    return fail(ErrorCode::kInput, fmt::format("{}: pictures are .svg or .png", path.string()));
  }
  if (layout == PictureLayout::kFolder) return make_folder_sink(path, *format, context);
  // Find out now, not after hours of slicing, whether the file can be written.
  if (const auto probe = AtomicFile::create(path); !probe) return fail(probe.error());
  return std::make_unique<SheetSink>(path, *format, context);
}

}  // namespace slipstick
