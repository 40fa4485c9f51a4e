#include "tests/support/zip_bytes.h"

#include <zip.h>

#include "core/base/check.h"

namespace slipstick {
namespace {

std::string bytes_of(zip_source_t* source) {
  zip_stat_t about;
  SLIPSTICK_CHECK(zip_source_stat(source, &about) == 0);
  std::string bytes(about.size, '\0');
  SLIPSTICK_CHECK(zip_source_open(source) == 0);
  SLIPSTICK_CHECK(zip_source_read(source, bytes.data(), bytes.size()) ==
                  static_cast<zip_int64_t>(bytes.size()));
  zip_source_close(source);
  return bytes;
}

}  // namespace

std::string zip_of(const std::vector<std::pair<std::string, std::string>>& parts) {
  zip_source_t* whole = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(whole);
  zip* archive = zip_open_from_source(whole, ZIP_TRUNCATE, nullptr);
  SLIPSTICK_CHECK(archive != nullptr);
  for (const auto& [name, content] : parts) {
    zip_source_t* part = zip_source_buffer(archive, content.data(), content.size(), 0);
    SLIPSTICK_CHECK(zip_file_add(archive, name.c_str(), part, ZIP_FL_ENC_UTF_8) >= 0);
  }
  SLIPSTICK_CHECK(zip_close(archive) == 0);
  std::string bytes = bytes_of(whole);
  zip_source_free(whole);
  return bytes;
}

std::string package_3mf(const std::string& model,
                        const std::vector<std::pair<std::string, std::string>>& others) {
  std::vector<std::pair<std::string, std::string>> parts{
      {"[Content_Types].xml",
       R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"/>)"},
      {"_rels/.rels",
       R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
       R"(<Relationship Id="r" Target="/3D/3dmodel.model" )"
       R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
      {"3D/3dmodel.model", model}};
  parts.insert(parts.end(), others.begin(), others.end());
  return zip_of(parts);
}

}  // namespace slipstick
