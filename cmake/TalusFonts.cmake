# talus_add_fonts(TARGET) embeds Talus Sans as :/fonts/TalusSans-*.otf: Debian's Inter with tabular figures, made by
# tools/make_fonts.py. Where python3-fonttools or fonts-inter is missing the window takes DejaVu Sans instead.
function(talus_add_fonts target)
  set(inter /usr/share/fonts/opentype/inter)
  execute_process(COMMAND /usr/bin/python3 -c "import fontTools" RESULT_VARIABLE no_fonttools OUTPUT_QUIET ERROR_QUIET)
  if(no_fonttools OR NOT EXISTS ${inter}/Inter-Regular.otf)
    message(STATUS "python3-fonttools or fonts-inter is missing: the window uses DejaVu Sans")
    return()
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/fonts)
  file(MAKE_DIRECTORY ${folder})
  foreach(weight Regular Medium SemiBold)
    list(APPEND fonts ${folder}/TalusSans-${weight}.otf)
  endforeach()
  add_custom_command(OUTPUT ${fonts}
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/tools/make_fonts.py ${inter} ${folder}
    DEPENDS ${PROJECT_SOURCE_DIR}/tools/make_fonts.py
    COMMENT "Freezing tabular figures into Talus Sans")
  qt_add_resources(${target} fonts PREFIX / BASE ${CMAKE_CURRENT_BINARY_DIR} FILES ${fonts})
endfunction()
