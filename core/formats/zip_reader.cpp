#include "core/formats/zip_reader.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <vector>

namespace slipstick {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr std::size_t kExpansionFree = std::size_t{1} << 20;

std::string text_of(zip_error_t& error) {
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

tl::unexpected<Error> no_zip(zip_error_t& error) {
  return fail(
      ErrorCode::kInput,
      fmt::format("is not a zip file, as every 3MF is ({}); export it again", text_of(error)));
}

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

std::size_t limit_of(const zip_stat_t& part, std::size_t limit) {
  const std::uint64_t packed = std::min<std::uint64_t>(part.comp_size, limit);
  return std::min<std::size_t>(limit, kExpansionFree + packed * kZipExpansionMax);
}

}  // namespace

void ZipReader::Discard::operator()(zip* archive) const {
  zip_discard(archive);
}

Result<ZipReader> ZipReader::open(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  if (bytes.empty()) {  // to libzip, an archive without parts
    zip_error_set(&error, ZIP_ER_NOZIP, 0);
    return no_zip(error);
  }
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) return no_zip(error);
  zip* archive = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    zip_source_free(source);
    return no_zip(error);
  }
  zip_error_fini(&error);
  return ZipReader(archive);
}

bool ZipReader::has(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE) >= 0;
}

Result<std::size_t> ZipReader::read(const std::string& name, std::size_t limit,
                                    const Sink& sink) const {
  const auto damaged = [&](std::string_view why) {
    return fail(ErrorCode::kInput,
                fmt::format("its part {} cannot be read ({}); export it again", name, why));
  };
  zip_stat_t part;
  if (zip_stat(archive_.get(), name.c_str(), ZIP_FL_NOCASE, &part) != 0) {
    return fail(ErrorCode::kInput, fmt::format("has no part {}; export it again", name));
  }
  const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive_.get(), part.index, 0));
  if (!file) return damaged(zip_strerror(archive_.get()));

  const std::size_t most = limit_of(part, limit);
  std::vector<char> piece(kPiece);
  std::size_t total = 0;
  while (true) {
    const zip_int64_t got = zip_fread(file.get(), piece.data(), piece.size());
    if (got < 0) return damaged(zip_file_strerror(file.get()));
    if (got == 0) return total;
    const auto size = static_cast<std::size_t>(got);
    if (size > most - total) {
      return fail(ErrorCode::kInput,
                  fmt::format("its part {} unpacks to more than {} bytes, from {}; simplify the "
                              "mesh",
                              name, most, part.comp_size));
    }
    total += size;
    if (const auto taken = sink({piece.data(), size}); !taken) return fail(taken.error());
  }
}

}  // namespace slipstick
