#include "host/outputs/contours_sink.h"

#include <nlohmann/json.hpp>

#include "host/atomic_file.h"
#include "host/outputs/contours_text.h"

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

class ContoursSink final : public LayerSink {
 public:
  explicit ContoursSink(AtomicFile file) : file_(std::move(file)) {}

  Result<void> write(const std::string& text) { return file_.write(text); }
  Result<void> add(const SlicedLayer& layer) override { return file_.write(contours_line(layer)); }
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
