# Every folder of core/ and ui/, with the rooms in it, is one static library that links only what it may include.
# The arrows are the arguments here; tests/unit/architecture holds the #include lines to them.

include(CheckLinkerFlag)

add_library(talus_options INTERFACE)
target_compile_options(talus_options INTERFACE -Wall -Wextra -Wpedantic $<IF:$<BOOL:${TALUS_BY_ROOM}>,-Wshadow=local,-Wshadow>)
# GCC 12 sees overlapping copies in std::string's operator+ that are not there (its bug 105651).
target_compile_options(talus_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(TALUS_WARNINGS_AS_ERRORS)
  target_compile_options(talus_options INTERFACE -Werror)
endif()
# Results must be the same bits wherever they are computed: no contraction into fused multiply-adds.
target_compile_options(talus_options INTERFACE -ffp-contract=off)
# gold links the window's tests in 0.3 s, where GNU ld takes 1.8.
check_linker_flag(CXX -fuse-ld=gold can_link_by_gold)
if(can_link_by_gold)
  target_link_options(talus_options INTERFACE -fuse-ld=gold)
endif()
if(TALUS_SANITIZE)
  list(JOIN TALUS_SANITIZE "," sanitizers)
  target_compile_options(talus_options INTERFACE -fsanitize=${sanitizers} -fno-omit-frame-pointer
    # GCC 12 sees ghosts in std::function and std::regex once they are instrumented. To ask of every access whether its
    # pointer is null or askew takes it three times as long as all other questions, and null is the address sanitizer's.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -fno-sanitize=null,alignment,object-size,vptr>)
  target_link_options(talus_options INTERFACE -fsanitize=${sanitizers})
endif()

# talus_collect_no_garbage(TARGET)  GCC's garbage collection took 7 of 42 s of a unit with CGAL's surfaces, 1 of 24 of
# core/effects: there is none below 1.5 GB.
function(talus_collect_no_garbage target)
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1500000>")
endfunction()

# talus_compile_by_room(TARGET [QUICK] [AS_ONE] [APART room...] [TOGETHER "room..."...])  The files of one room are
# compiled together: what they all include, Eigen above all, is read and instantiated once a room (docs/developing.md has
# the figures). TOGETHER: so are those of all rooms in one such list. AS_ONE: of all rooms. APART: rooms of files that each
# have constants of their own. QUICK: what does not compute is optimized less, which gives the same bits. `-Wshadow` in
# full is the dev preset's, which compiles file by file.
function(talus_compile_by_room target)
  cmake_parse_arguments(ARG "QUICK;AS_ONE" "" "APART;TOGETHER" ${ARGN})
  if(ARG_QUICK)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(NOT TALUS_BY_ROOM)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^/.*[.]cpp$")
  foreach(source ${sources})
    set(folder ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(IS_PREFIX CMAKE_CURRENT_BINARY_DIR ${source} is_generated)
    if(is_generated)
      set(folder ${CMAKE_CURRENT_BINARY_DIR})
    endif()
    cmake_path(GET source PARENT_PATH room)
    cmake_path(RELATIVE_PATH room BASE_DIRECTORY ${folder})
    cmake_path(GET room FILENAME name)
    if(ARG_AS_ONE OR room STREQUAL ".")
      set(room ${target})
    elseif(name IN_LIST ARG_APART)
      continue()
    endif()
    foreach(rooms ${ARG_TOGETHER})
      if(" ${rooms} " MATCHES " ${name} ")
        string(REPLACE " " "_" room "${rooms}")
      endif()
    endforeach()
    string(REPLACE "/" "_" room ${room})
    set_property(SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP ${room})
  endforeach()
endfunction()

# talus_add_meta_objects(TARGET)  What Qt's moc makes of the headers of a library of ui/: a source for each room, in a
# folder of the room's name below the build folder, so that it is compiled with the room.
function(talus_add_meta_objects target)
  set(script ${PROJECT_SOURCE_DIR}/cmake/MetaObjects.cmake)
  get_target_property(headers ${target} SOURCES)
  list(FILTER headers INCLUDE REGEX "[.]hpp$")
  string(REPLACE "${CMAKE_CURRENT_SOURCE_DIR}/" "" headers "${headers}")
  list(TRANSFORM headers REPLACE "/[^/]*$" "" OUTPUT_VARIABLE rooms)
  list(REMOVE_DUPLICATES rooms)
  foreach(room ${rooms})
    set(of_room ${headers})
    list(FILTER of_room INCLUDE REGEX "^${room}/[^/]*$")
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${room}/meta_objects.cpp)
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DMOC=$<TARGET_FILE:Qt6::moc> -DROOT=${CMAKE_CURRENT_SOURCE_DIR} -DOUTPUT=${source}
              "-DHEADERS=${of_room}" -P ${script}
      DEPENDS ${of_room} ${script} VERBATIM)
    target_sources(${target} PRIVATE ${source})
  endforeach()
endfunction()

# talus_compile_quickly(TARGET)  Tests are compiled with no optimization at all, a fifth of their compiler's time. Of an
# inline function the linker takes the copy that it meets first: those of what is tested, which is optimized, come first.
function(talus_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  set(found)
  set(rest ${target})
  while(rest)
    list(POP_FRONT rest library)
    get_target_property(linked ${library} LINK_LIBRARIES)
    list(FILTER linked INCLUDE REGEX "^talus_")
    foreach(name ${linked})
      get_target_property(type ${name} TYPE)
      if(type STREQUAL STATIC_LIBRARY AND NOT name IN_LIST found)
        list(APPEND found ${name})
        list(APPEND rest ${name})
      endif()
    endforeach()
  endwhile()
  if(found)
    list(TRANSFORM found REPLACE "(.+)" "$<TARGET_FILE:\\1>")
    target_link_options(${target} PRIVATE LINKER:--whole-archive ${found} LINKER:--no-whole-archive)
  endif()
endfunction()

# talus_share_test_headers(TARGET)  What tests include most, GoogleMock and Eigen above all, is read once for all test
# programs (docs/developing.md has the figures). The JSON reader is not among it: its own inline functions have its
# parser instantiated in each unit that knows it, 0.35 s. All are position-independent code, as Qt's must be.
function(talus_share_test_headers target)
  if(NOT TALUS_BY_ROOM)
    return()
  endif()
  set(for_all -fPIC)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # ccache keeps what uses the header; GCC collects no garbage below 1.5 GB
    list(APPEND for_all -fpch-preprocess "SHELL:--param ggc-min-heapsize=1500000")
  endif()
  if(NOT TARGET talus_test_headers)
    file(WRITE ${CMAKE_BINARY_DIR}/talus_test_headers.cpp "")
    add_library(talus_test_headers OBJECT ${CMAKE_BINARY_DIR}/talus_test_headers.cpp)
    target_link_libraries(talus_test_headers PRIVATE talus_options Eigen3::Eigen GTest::gmock)
    target_compile_options(talus_test_headers PRIVATE $<$<CONFIG:Release>:-O0> ${for_all})
    target_precompile_headers(talus_test_headers PRIVATE <gmock/gmock.h> <Eigen/Dense>
      <algorithm> <cmath> <filesystem> <fstream> <functional> <map> <memory> <numbers> <optional> <string> <vector>)
  endif()
  target_link_libraries(${target} PRIVATE GTest::gmock)
  target_compile_options(${target} PRIVATE ${for_all})
  target_precompile_headers(${target} REUSE_FROM talus_test_headers)
endfunction()

# talus_library(FOLDER [QUICK] [META_OBJECTS] [EXCEPT subfolder-or-file] [APART room...] [TOGETHER "room..."...] [PUBLIC dep...]
# [PRIVATE dep...])  the folder with all rooms below it; META_OBJECTS: its headers ask for Qt's.
function(talus_library folder)
  cmake_parse_arguments(ARG "QUICK;META_OBJECTS" "EXCEPT" "PUBLIC;PRIVATE;APART;TOGETHER" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.hpp)
  if(ARG_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${ARG_EXCEPT}[/.]")
    list(FILTER headers EXCLUDE REGEX "/${folder}/${ARG_EXCEPT}[/.]")
  endif()
  if(NOT sources)  # headers only
    add_library(talus_${folder} INTERFACE)
    target_include_directories(talus_${folder} INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(talus_${folder} INTERFACE ${ARG_PUBLIC})
    return()
  endif()
  add_library(talus_${folder} STATIC ${sources} ${headers})
  target_include_directories(talus_${folder} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(talus_${folder} PUBLIC ${ARG_PUBLIC} PRIVATE talus_options ${ARG_PRIVATE})
  set(quick)
  if(ARG_QUICK)
    set(quick QUICK)
  endif()
  talus_collect_no_garbage(talus_${folder})
  if(ARG_META_OBJECTS)
    talus_add_meta_objects(talus_${folder})
  endif()
  talus_compile_by_room(talus_${folder} ${quick} APART ${ARG_APART} TOGETHER ${ARG_TOGETHER})
endfunction()

# talus_test(NAME SOURCES file... LIBRARIES lib... [LABELS label...] [SHARES count] [LONG pattern] [BLAS_KERNELS name] [COMPUTES])
# a GoogleTest program, each of its suites a ctest, or each of so many SHARES of its tests; those that fit GoogleTest's
# pattern LONG have the label `long` alone, and where there are SHARES a ctest each. BLAS_KERNELS: OpenBLAS takes these, where the processor has them, so that figures are those of the
# tables in docs (its choice differs from processor to processor, and with it the last bits). COMPUTES: the tests
# themselves, not only what they test, compute for long and are optimized (the shared header is not made for these).
file(STRINGS /proc/cpuinfo processor_has_avx2 REGEX "avx2" LIMIT_COUNT 1)
function(talus_test name)
  cmake_parse_arguments(ARG "COMPUTES" "BLAS_KERNELS;LONG;SHARES" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if(ARG_BLAS_KERNELS AND processor_has_avx2)
    set(kernels ENVIRONMENT_MODIFICATION OPENBLAS_CORETYPE=set:${ARG_BLAS_KERNELS})
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE talus_options ${ARG_LIBRARIES} GTest::gmock_main)
  target_compile_definitions(${name} PRIVATE TALUS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(ARG_COMPUTES)
    talus_compile_by_room(${name} QUICK AS_ONE)
    talus_collect_no_garbage(${name})
  else()
    talus_compile_by_room(${name} AS_ONE)
    talus_compile_quickly(${name})
    talus_share_test_headers(${name})
  endif()
  set(properties ENVIRONMENT OPENBLAS_NUM_THREADS=1 ${kernels})
  if(ARG_LABELS)
    set(labels LABELS ${ARG_LABELS})
  endif()
  set(as SUITES)
  set(long_as SUITES)
  if(ARG_SHARES)
    set(as ${ARG_SHARES})
    set(long_as EACH_TEST)
  endif()
  if(ARG_LONG)
    talus_add_suites(${name} "${ARG_LONG}" ${long_as} ${properties} LABELS long)
    talus_add_suites(${name} "-${ARG_LONG}" ${as} ${properties} ${labels})
  else()
    talus_add_suites(${name} "*" ${as} ${properties} ${labels})
  endif()
endfunction()

# talus_add_suites(NAME PATTERN AS property value...)  What fits GoogleTest's pattern, listed when ctest starts: AS SUITES,
# EACH_TEST or a number of shares (TalusTestSuites.cmake).
function(talus_add_suites name pattern as)
  string(MD5 key "${pattern}")
  set(listing ${CMAKE_CURRENT_BINARY_DIR}/${name}_${key}.cmake)
  list(JOIN ARGN "]==] [==[" properties)
  file(GENERATE OUTPUT ${listing} CONTENT "include([==[${PROJECT_SOURCE_DIR}/cmake/TalusTestSuites.cmake]==])
add_suites([==[$<TARGET_FILE:${name}>]==] [==[${pattern}]==] [==[${as}]==] [==[${properties}]==])\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${listing})
endfunction()
