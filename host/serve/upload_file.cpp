#include "host/serve/upload_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace slipstick {

Result<UploadFile> UploadFile::create(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "wbxe");
  UploadFile upload(path, file);
  if (file == nullptr) return fail(upload.error());
  return upload;
}

UploadFile::~UploadFile() {
  if (file_ == nullptr) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

Result<void> UploadFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) return fail(error());
  size_ += bytes.size();
  return {};
}

Result<void> UploadFile::sync() {
  if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) return fail(error());
  return {};
}

Error UploadFile::error() const {
  return {ErrorCode::kUnavailable, fmt::format("cannot write {}: {}", path_.string(),
                                               std::generic_category().message(errno))};
}

}  // namespace slipstick
