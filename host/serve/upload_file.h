#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// Bytes that come in pieces and go to the disk as they come; removed again unless somebody moved
/// the file away.
class UploadFile {
 public:
  [[nodiscard]] static Result<UploadFile> create(const std::filesystem::path& path);
  UploadFile(UploadFile&&) noexcept = default;
  UploadFile& operator=(UploadFile&&) noexcept = delete;
  ~UploadFile();

  /// \return kUnavailable, as on a full disk.
  [[nodiscard]] Result<void> write(std::string_view bytes);
  /// Everything is on the disk once this returns.
  [[nodiscard]] Result<void> sync();
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  UploadFile(std::filesystem::path path, std::FILE* file) : path_(std::move(path)), file_(file) {}
  [[nodiscard]] Error error() const;

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t size_ = 0;
};

}  // namespace slipstick
