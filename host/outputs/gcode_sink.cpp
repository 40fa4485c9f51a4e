#include "host/outputs/gcode_sink.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/gcode/write.h"
#include "host/atomic_file.h"

namespace slipstick {
namespace {

// Somewhere that text goes: a file that appears when complete, or standard output.
class TextOut {
 public:
  explicit TextOut(std::optional<AtomicFile> file) : file_(std::move(file)) {}

  Result<void> write(std::string_view text) {
    if (file_) return file_->write(text);
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
        std::fflush(stdout) == 0) {
      return {};
    }
    return fail(ErrorCode::kUnavailable, fmt::format("cannot write to standard output: {}",
                                                     std::generic_category().message(errno)));
  }
  Result<void> finish() { return file_ ? file_->commit() : Result<void>(); }

 private:
  std::optional<AtomicFile> file_;
};

class GcodeSink final : public LayerSink {
 public:
  GcodeSink(TextOut out, const SinkContext& context)
      : out_(std::move(out)), settings_(*context.settings) {}

  Result<void> start() { return out_.write(write_start(settings_).text); }

  Result<void> add(const SlicedLayer& layer) override {
    SLIPSTICK_CHECK(layer.program);
    return out_.write(layer.program->text);
  }

  Result<void> finish() override {
    if (auto ok = out_.write(write_end(settings_).text); !ok) return ok;
    return out_.finish();
  }

 private:
  TextOut out_;
  const PrintSettings& settings_;
};

}  // namespace

Result<std::unique_ptr<LayerSink>> make_gcode_sink(const std::filesystem::path& path,
                                                   const SinkContext& context) {
  std::optional<AtomicFile> file;
  if (path != "-") {
    auto created = AtomicFile::create(path);
    if (!created) return fail(created.error());
    file.emplace(std::move(*created));
  }
  auto sink = std::make_unique<GcodeSink>(TextOut(std::move(file)), context);
  if (const auto ok = sink->start(); !ok) return fail(ok.error());
  return sink;
}

}  // namespace slipstick
