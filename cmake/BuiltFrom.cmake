# Writes OUTPUT, a C++ source that says what a program was built from: the commit of the clone SOURCE, "with changes"
# where files differ from it, and LIBRARIES. It runs with every build and writes only what is new, so that nothing is
# compiled where nothing has changed.
set(commit "")
if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git -C ${SOURCE} rev-parse --short=10 HEAD
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND git -C ${SOURCE} --no-optional-locks diff --quiet HEAD ERROR_QUIET RESULT_VARIABLE differs)
  if(commit AND differs)
    string(APPEND commit ", with changes")
  endif()
endif()
set(text "extern const char built_commit[], built_libraries[];\n")
string(APPEND text "const char built_commit[] = \"${commit}\";\nconst char built_libraries[] = \"${LIBRARIES}\";\n")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${text}" @ONLY)
