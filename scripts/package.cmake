# What is installed, and the Debian package: program, configs, the unit of systemd. It has no maintainer scripts: the unit
# brings its own user and folder, and runs once somebody has said which printer there is.
install(TARGETS slipstick RUNTIME DESTINATION bin)
install(DIRECTORY configs/ DESTINATION share/slipstick/configs PATTERN *.service EXCLUDE)
install(FILES configs/slipstick.service configs/slipstick@.service DESTINATION lib/systemd/system)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/slipstick)
install(FILES host/serve/README.md DESTINATION share/doc/slipstick RENAME DAEMON.md)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME slipstick)
set(CPACK_PACKAGE_CONTACT "the authors of slipstick <slipstick@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "prints implicit solids on FDM printers, without a slicer")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Samples an implicit solid layer by layer, makes toolpaths whose contours
never cross and streams them to a Marlin board while the next ones are
being made. The daemon has a queue, a web page and an HTTP API.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION misc)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
