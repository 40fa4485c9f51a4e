#include "host/atomic_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace slipstick {
namespace {

Error cannot(std::string_view what, const std::filesystem::path& path, int error) {
  return {ErrorCode::kUnavailable, fmt::format("cannot {} {}: {}", what, path.string(),
                                               std::generic_category().message(error))};
}

}  // namespace

Result<AtomicFile> AtomicFile::create(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return fail(cannot("write", path, EISDIR));
  std::filesystem::path part = path;
  part += fmt::format(".part{}", ::getpid());
  std::FILE* file = std::fopen(part.c_str(), "wbxe");
  if (file == nullptr) return fail(cannot("write", path, errno));
  return AtomicFile(path, std::move(part), file);
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

Result<void> AtomicFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    return fail(cannot("write", path_, errno));
  }
  return {};
}

Result<void> AtomicFile::commit() {
  if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) {
    return fail(cannot("write", path_, errno));
  }
  if (std::rename(part_.c_str(), path_.c_str()) != 0) return fail(cannot("write", path_, errno));
  file_.reset();
  return {};
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  auto file = AtomicFile::create(path);
  if (!file) return fail(file.error());
  if (auto ok = file->write(bytes); !ok) return ok;
  return file->commit();
}

Result<std::string> read_file(const std::filesystem::path& path) {
  const auto refuse = [&](int error) {
    return fail(ErrorCode::kInput, fmt::format("cannot read {}: {}", path.string(),
                                               std::generic_category().message(error)));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return refuse(EISDIR);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"),
                                                             &std::fclose);
  if (file == nullptr) return refuse(errno);
  std::string bytes;
  std::string chunk(1 << 20, '\0');
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    if (bytes.size() + got > kReadMax) return refuse(EFBIG);
    bytes.append(chunk, 0, got);
  }
  if (std::ferror(file.get()) != 0) return refuse(errno);
  return bytes;
}

}  // namespace slipstick
