#include "host/serve/upload_body.h"

#include "host/serve/file_names.h"

namespace slipstick {

Result<UploadBody> UploadBody::create(const std::filesystem::path& path,
                                      const std::optional<std::string>& boundary) {
  auto file = UploadFile::create(path);
  if (!file) return fail(file.error());
  auto parts = std::make_unique<Parts>(std::move(*file));
  if (boundary) {
    Parts& to = *parts;
    parts->parser.emplace(
        *boundary,
        MultipartParser::Sink{[&to](std::string name, std::string value) {
                                to.fields.insert_or_assign(std::move(name), std::move(value));
                              },
                              [&to](std::string name) { return take_name(to, std::move(name)); },
                              [&to](std::string_view bytes) { return to.file.write(bytes); }});
  }
  return UploadBody(std::move(parts));
}

// Of a form without a file there is nothing to be said yet.
Result<void> UploadBody::take_name(Parts& parts, std::string name) {
  parts.name = std::move(name);
  if (parts.name.empty()) return {};
  const auto checked = FileName::from(last_segment(parts.name));
  if (checked) return {};
  parts.name_is_wrong = true;
  return fail(checked.error());
}

Result<void> UploadBody::write(std::string_view bytes) {
  return parts_->parser ? parts_->parser->feed(bytes) : parts_->file.write(bytes);
}

Result<HttpUpload> UploadBody::finish() {
  if (parts_->parser && !parts_->parser->complete()) {
    return fail(ErrorCode::kInput, "form: it breaks off");
  }
  if (const auto ok = parts_->file.sync(); !ok) return fail(ok.error());
  return HttpUpload{parts_->file.path().string(), parts_->name, parts_->fields,
                    parts_->file.size()};
}

}  // namespace slipstick
