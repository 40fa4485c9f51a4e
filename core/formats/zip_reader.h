#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

struct zip;

namespace slipstick {

/// A part of a zip file may be this many times as large as its bytes in the file, and 1 MiB more;
/// deflate alone could make it a thousand times as large.
inline constexpr std::size_t kZipExpansionMax = 200;

/// The parts of a zip file in memory, by the library libzip. Never unpacks more than it is told.
/// Threads: one at a time.
class ZipReader {
 public:
  using Sink = std::function<Result<void>(std::string_view)>;

  /// `bytes` must outlive the reader. \return kInput if they are no zip file.
  [[nodiscard]] static Result<ZipReader> open(std::string_view bytes);

  /// Without regard to upper and lower case, as the parts of an OPC package are named.
  [[nodiscard]] bool has(const std::string& name) const;

  /// Unpacks a part, piece by piece, into `sink`, whose error ends it and is passed on.
  /// \return the bytes of the part; kInput if it is not there, is damaged or encrypted, or is
  /// larger than `limit` or than `kZipExpansionMax` allows.
  [[nodiscard]] Result<std::size_t> read(const std::string& name, std::size_t limit,
                                         const Sink& sink) const;

 private:
  struct Discard {
    void operator()(zip* archive) const;
  };

  explicit ZipReader(zip* archive) : archive_(archive) {}

  std::unique_ptr<zip, Discard> archive_;
};

}  // namespace slipstick
