# talus_version: the version, the commit and the libraries that `--version` tells (app/version).

# What the libraries are, as CMake found them; those of ui/ are known there.
get_directory_property(vtk DIRECTORY ${PROJECT_SOURCE_DIR}/ui DEFINITION VTK_VERSION)
get_directory_property(qt DIRECTORY ${PROJECT_SOURCE_DIR}/ui DEFINITION Qt6_VERSION)
get_directory_property(avcodec DIRECTORY ${PROJECT_SOURCE_DIR}/ui DEFINITION FFMPEG_libavcodec_VERSION)
file(STRINGS ${SUITESPARSE_INCLUDE_DIR}/SuiteSparse_config.h suitesparse REGEX "SUITESPARSE_[A-Z]*_VERSION +[0-9]+$")
list(TRANSFORM suitesparse REPLACE "^.* ([0-9]+)$" "\\1")
list(JOIN suitesparse "." suitesparse)
file(REAL_PATH ${GMSH_LIBRARY} gmsh)  # its header tells another version than its file does
string(REGEX REPLACE "^.*[.]so[.]" "" gmsh ${gmsh})

set(libraries "Eigen ${Eigen3_VERSION}" "SuiteSparse ${suitesparse}" "OpenBLAS ${OPENBLAS_VERSION}"
  "oneTBB ${TBB_VERSION}" "gmsh ${gmsh}" "CGAL ${CGAL_VERSION}" "GDAL ${GDAL_VERSION}" "HDF5 ${HDF5_VERSION}"
  "VTK ${vtk}" "libavcodec ${avcodec}")
if(TALUS_WINDOW)
  list(APPEND libraries "Qt ${qt}")
endif()
list(JOIN libraries ", " libraries)

set(built_from ${CMAKE_CURRENT_BINARY_DIR}/version/built_from.cpp)
add_custom_target(talus_built_from BYPRODUCTS ${built_from} VERBATIM
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${built_from} "-DLIBRARIES=${libraries}"
          -P ${PROJECT_SOURCE_DIR}/cmake/BuiltFrom.cmake)
add_library(talus_version STATIC ${CMAKE_CURRENT_SOURCE_DIR}/version/version.cpp ${built_from})
add_dependencies(talus_version talus_built_from)
target_include_directories(talus_version PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(talus_version PRIVATE TALUS_VERSION="${PROJECT_VERSION}")
target_link_libraries(talus_version PRIVATE talus_options)
