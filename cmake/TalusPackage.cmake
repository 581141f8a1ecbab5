# `cpack` makes a Debian package and an archive of what TalusInstall.cmake installs: tools/package.sh.
set(TALUS_MAINTAINER "Talus maintainers <talus@localhost>" CACHE STRING "Who answers for the Debian package")
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_VENDOR "Talus")
set(CPACK_PACKAGE_CONTACT ${TALUS_MAINTAINER})
set(CPACK_PACKAGE_FILE_NAME talus-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES TRUE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)

# Libraries that programs and modules name are found by dpkg-shlibdeps. The first depends are what they open while they
# run: OpenGL in main memory, the renderer behind a display with no graphics card, an encoder of H.264 comes with FFmpeg.
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libosmesa6, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-translations-l10n, qt6-wayland, shared-mime-info, desktop-file-utils")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Talus cuts a rock mass along its joints into blocks, meshes each block with
tetrahedra, and follows the blocks as they deform, stick, slide, open, topple
and fall. A window shows the slide while it is computed; a command line does
the same on machines with no display.")
include(CPack)
