#include "host/outputs/contours_sink.h"

#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "host/atomic_file.h"

namespace slipstick {
namespace {

std::string header(const SinkContext& context) {
  std::vector<double> to_model;
  for (const auto& row : context.to_model.rows)
    to_model.insert(to_model.end(), row.begin(), row.end());
  to_model.insert(to_model.end(), {0, 0, 0, 1});
  nlohmann::ordered_json json;
  json["format"] = "slipstick-contours";
  json["version"] = 1;
  json["model"] = context.model;
  json["unit"] = "mm";
  json["sampling"] = context.settings->slicing.sampling;
  json["grid_width"] = context.job->grid().width();
  json["layer_height"] = context.settings->slicing.layer_height;
  json["layers"] = context.job->end_layer() - context.job->first_layer();
  json["to_model"] = to_model;
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void append_point(std::string& text, Vec2 p) {
  text += '[';
  append_exact(text, p.x);
  text += ',';
  append_exact(text, p.y);
  text += ']';
}

void append_loop(std::string& text, const Outline& outline, const Outline::Loop& loop) {
  text += "{\"depth\":" + std::to_string(loop.depth) + ",\"points\":[";
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    if (i > 0) text += ',';
    append_point(text, outline.mm(loop.points[i]));
  }
  text += "]}";
}

std::string line(const SlicedLayer& layer) {
  std::string text = "{\"layer\":" + std::to_string(layer.index) + ",\"z\":";
  append_exact(text, layer.middle);
  text += ",\"loops\":[";
  const Outline& outline = layer.contours.outline;
  for (std::size_t i = 0; i < outline.loops().size(); ++i) {
    if (i > 0) text += ',';
    append_loop(text, outline, outline.loops()[i]);
  }
  text += "]}\n";
  return text;
}

class ContoursSink final : public LayerSink {
 public:
  explicit ContoursSink(AtomicFile file) : file_(std::move(file)) {}

  Result<void> write(const std::string& text) { return file_.write(text); }
  Result<void> add(const SlicedLayer& layer) override { return file_.write(line(layer)); }
  Result<void> finish() override { return file_.commit(); }

 private:
  AtomicFile file_;
};

}  // namespace

Result<std::unique_ptr<LayerSink>> make_contours_sink(const std::filesystem::path& path,
                                                      const SinkContext& context) {
  auto file = AtomicFile::create(path);
  if (!file) return fail(file.error());
  auto sink = std::make_unique<ContoursSink>(std::move(*file));
  if (const auto ok = sink->write(header(context)); !ok) return fail(ok.error());
  return sink;
}

}  // namespace slipstick
