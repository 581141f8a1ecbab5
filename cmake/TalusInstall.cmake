# What `cmake --install` puts where. Programs find their parts by places relative to bin (base/installed.hpp), so that
# the whole may be moved; hence these places are fixed. `cmake --build … --target programs` builds all of it, and no test.

set(share_talus share/talus)
set(programs talus-cli)
if(TALUS_WINDOW)
  list(APPEND programs talus)
endif()
install(TARGETS ${programs} RUNTIME DESTINATION bin)
install(TARGETS talus-mesher talus-height-grid talus-mp4 RUNTIME DESTINATION libexec/talus LIBRARY DESTINATION libexec/talus)
add_custom_target(programs DEPENDS ${programs} talus-mesher)

# Samples without what was computed beside them.
install(DIRECTORY samples DESTINATION ${share_talus} PATTERN "*.results" EXCLUDE PATTERN "*.accuracy" EXCLUDE)
install(FILES resources/schema/project.schema.json DESTINATION ${share_talus}/schema)

# The typeface of pictures (ui/render/paint/fonts); that of the window is inside it.
set(inter /usr/share/fonts/opentype/inter)
if(EXISTS ${inter}/Inter-Regular.otf)
  install(FILES ${inter}/Inter-Regular.otf ${inter}/Inter-SemiBold.otf DESTINATION ${share_talus}/fonts)
  install(FILES /usr/share/doc/fonts-inter/copyright DESTINATION ${share_talus}/fonts RENAME LICENCE.txt)
endif()

file(GLOB pages CONFIGURE_DEPENDS docs/*.md)
install(FILES ${pages} CHANGELOG.md LICENSE resources/desktop/copyright DESTINATION share/doc/talus)
install(FILES resources/colour_maps/LICENCE.txt DESTINATION share/doc/talus RENAME colour_maps.txt)
install(FILES ${PROJECT_BINARY_DIR}/depends.txt DESTINATION share/doc/talus OPTIONAL)  # of archives: tools/package.sh
install(DIRECTORY docs/pictures DESTINATION share/doc/talus)

# Menu entry, type of .talus files, icons.
if(TALUS_WINDOW)
  install(FILES resources/desktop/talus.desktop DESTINATION share/applications)
  install(FILES resources/desktop/talus.xml DESTINATION share/mime/packages)
  install(FILES resources/desktop/talus.svg DESTINATION share/icons/hicolor/scalable/apps)
  install(FILES resources/desktop/application-x-talus.svg DESTINATION share/icons/hicolor/scalable/mimetypes)
endif()

# Completion of command lines, as talus-cli itself tells it; a shell finds it by the name of the file.
set(completions)
foreach(place bash:share/bash-completion/completions/talus-cli zsh:share/zsh/vendor-completions/_talus-cli
              fish:share/fish/vendor_completions.d/talus-cli.fish)
  string(REGEX MATCH "^([a-z]+):(.*)/([^/]+)$" matched ${place})
  set(completion ${CMAKE_BINARY_DIR}/completion/${CMAKE_MATCH_3})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/completion)
  add_custom_command(OUTPUT ${completion} COMMAND talus-cli completion ${CMAKE_MATCH_1} > ${completion} DEPENDS talus-cli)
  install(FILES ${completion} DESTINATION ${CMAKE_MATCH_2})
  list(APPEND completions ${completion})
endforeach()

# Man pages, made of what --help says; the words of both kinds are written whenever all is built.
find_package(Python3 COMPONENTS Interpreter)
set(man_pages)
if(Python3_FOUND)
  set(script ${PROJECT_SOURCE_DIR}/tools/make_man_page.py)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/man)
  foreach(program ${programs})
    set(page ${CMAKE_BINARY_DIR}/man/${program}.1.gz)
    add_custom_command(OUTPUT ${page} COMMAND ${Python3_EXECUTABLE} ${script} $<TARGET_FILE:${program}> ${page}
      DEPENDS ${program} ${script})
    list(APPEND man_pages ${page})
  endforeach()
  install(FILES ${man_pages} DESTINATION share/man/man1)
endif()
add_custom_target(talus_words ALL DEPENDS ${completions} ${man_pages})
add_dependencies(programs talus_words)
include(TalusPackage)
