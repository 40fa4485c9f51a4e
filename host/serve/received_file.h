#pragma once

#include "host/serve/routes.h"

namespace slipstick {

/// The file that a request brought, stored and told of; or the refusal.
struct ReceivedFile {
  StoredFile file;
  std::optional<HttpResponse> refusal;
};

/// \return 400 without bytes, 503 if it cannot be stored.
[[nodiscard]] ReceivedFile receive_file(const FileName& name, const HttpRequest& request,
                                        Services& services);

/// The file of a form of OctoPrint's kind, which is named by the form. \return also 415 for a name
/// that cannot be.
[[nodiscard]] ReceivedFile receive_form(const HttpRequest& request, Services& services);

/// A field of the form, or an empty text.
[[nodiscard]] std::string form_field(const HttpRequest& request, const std::string& name);

/// Prints it now, or as soon as what is being printed is over: whoever asks says that the bed is
/// clear. \return kUnavailable if it cannot be queued.
[[nodiscard]] Result<void> print_file(const StoredFile& file, Services& services);

}  // namespace slipstick
