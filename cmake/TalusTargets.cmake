# Every folder of core/ and ui/ is one static library that links only what it may include.
# The arrows are the arguments here; tests/unit/architecture holds the #include lines to them.

add_library(talus_options INTERFACE)
target_compile_options(talus_options INTERFACE -Wall -Wextra -Wshadow -Wpedantic)
# GCC 12 sees overlapping copies in std::string's operator+ that are not there (its bug 105651).
target_compile_options(talus_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(TALUS_WARNINGS_AS_ERRORS)
  target_compile_options(talus_options INTERFACE -Werror)
endif()
# Results must be the same bits wherever they are computed: no contraction into fused multiply-adds.
target_compile_options(talus_options INTERFACE -ffp-contract=off)
if(TALUS_SANITIZE)
  list(JOIN TALUS_SANITIZE "," sanitizers)
  target_compile_options(talus_options INTERFACE -fsanitize=${sanitizers} -fno-omit-frame-pointer
    -Wno-maybe-uninitialized)  # GCC 12 sees ghosts in std::function and std::regex once they are instrumented
  target_link_options(talus_options INTERFACE -fsanitize=${sanitizers})
endif()

# talus_library(FOLDER [PUBLIC dep...] [PRIVATE dep...])
function(talus_library folder)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.hpp)
  if(NOT sources)  # headers only
    add_library(talus_${folder} INTERFACE)
    target_include_directories(talus_${folder} INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(talus_${folder} INTERFACE ${ARG_PUBLIC})
    return()
  endif()
  add_library(talus_${folder} STATIC ${sources} ${headers})
  target_include_directories(talus_${folder} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(talus_${folder} PUBLIC ${ARG_PUBLIC} PRIVATE talus_options ${ARG_PRIVATE})
endfunction()

# talus_test(NAME SOURCES file... LIBRARIES lib... [LABELS label...])  a GoogleTest program, each of its tests a ctest
function(talus_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE talus_options ${ARG_LIBRARIES} GTest::gmock_main)
  target_compile_definitions(${name} PRIVATE TALUS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES ENVIRONMENT "OPENBLAS_NUM_THREADS=1" LABELS "${ARG_LABELS}")
endfunction()
