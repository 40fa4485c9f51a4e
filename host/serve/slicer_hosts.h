#pragma once

#include "host/serve/routes.h"

namespace slipstick {

/// \file
/// What slicers ask of hosts other than OctoPrint before they upload, and how they do that: just
/// enough that any of these types of host may be chosen for this daemon.

// prusalink.cpp: PrusaSlicer's type PrusaLink (OctoPrint.cpp of 2.9).
[[nodiscard]] HttpResponse link_storage(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse link_put_file(const HttpRequest& request, Services& services);

// moonraker.cpp: the type Moonraker of PrusaSlicer and OrcaSlicer (Moonraker.cpp of 2.9, 2.3).
[[nodiscard]] HttpResponse moon_info(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse moon_roots(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse moon_upload(const HttpRequest& request, Services& services);

// repetier.cpp: the type Repetier of PrusaSlicer and SuperSlicer (Repetier.cpp of 2.9, 2.5).
[[nodiscard]] HttpResponse repetier_info(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse repetier_list(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse repetier_ask(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse repetier_upload(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse repetier_print(const HttpRequest& request, Services& services);

}  // namespace slipstick
