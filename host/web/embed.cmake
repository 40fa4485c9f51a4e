# Writes the files of this folder that browsers get into one C++ source, so that the program is all
# there is to install. Configured anew when one of them changes.
set(web_files index.html login.html setup.html style.css main.js account.js api.js page.js canvas.js dashboard.js live.js
  camera.js files.js pictures.js preview.js stack.js heat.js control.js apps.js changes.js pauses.js jobs.js login.js setup.js terminal.js)
set(entries "")
foreach(name ${web_files})
  set(path ${CMAKE_CURRENT_LIST_DIR}/${name})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} text)
  string(APPEND entries "    {\"${name}\", R\"__web__(${text})__web__\"},\n")
endforeach()
set(source "#include \"host/serve/web_assets.h\"

#include <array>

namespace slipstick {
namespace {

constexpr std::array kAssets = std::to_array<WebAsset>({
${entries}});

}  // namespace

std::span<const WebAsset> web_assets() {
  return kAssets;
}

}  // namespace slipstick
")
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/web_assets.cpp CONTENT "${source}")
