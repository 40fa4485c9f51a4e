#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// A file that appears under its name only when it is complete: written beside it, synced, renamed.
/// What is not committed is removed.
class AtomicFile {
 public:
  /// \return kUnavailable if the file cannot be made; the message names it and says why.
  [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& path);

  AtomicFile(AtomicFile&&) noexcept = default;
  AtomicFile& operator=(AtomicFile&&) noexcept = delete;
  ~AtomicFile();

  /// \return kUnavailable if not everything could be written, as on a full disk.
  [[nodiscard]] Result<void> write(std::string_view bytes);

  /// Gives the file its name. Once.
  [[nodiscard]] Result<void> commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  AtomicFile(std::filesystem::path path, std::filesystem::path part, std::FILE* file)
      : path_(std::move(path)), part_(std::move(part)), file_(file) {}

  std::filesystem::path path_;
  std::filesystem::path part_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// Writes a whole file, or nothing.
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

/// Reads a whole file of at most `kReadMax` bytes. kInput if it is missing, unreadable, a folder or
/// larger.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path);

inline constexpr std::size_t kReadMax = std::size_t{2} << 30;

}  // namespace slipstick
