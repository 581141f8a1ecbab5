# What Talus is built on, from Debian 12's packages (docs/dependencies.md says why each).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(OpenMP REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(CGAL REQUIRED)
find_package(GDAL REQUIRED)
find_package(GTest REQUIRED)

# Debian's SuiteSparse, gmsh and valijson ship no CMake package.
find_path(SUITESPARSE_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
foreach(part cholmod umfpack)
  find_library(${part}_LIBRARY ${part} REQUIRED)
  add_library(SuiteSparse::${part} INTERFACE IMPORTED)
  target_include_directories(SuiteSparse::${part} INTERFACE ${SUITESPARSE_INCLUDE_DIR})
  target_link_libraries(SuiteSparse::${part} INTERFACE ${${part}_LIBRARY})
endforeach()

find_path(GMSH_INCLUDE_DIR gmsh.h REQUIRED)
find_library(GMSH_LIBRARY gmsh REQUIRED)
add_library(gmsh::gmsh INTERFACE IMPORTED)
target_include_directories(gmsh::gmsh INTERFACE ${GMSH_INCLUDE_DIR})
target_link_libraries(gmsh::gmsh INTERFACE ${GMSH_LIBRARY})

find_path(VALIJSON_INCLUDE_DIR valijson/schema.hpp REQUIRED)
add_library(valijson::valijson INTERFACE IMPORTED)
target_include_directories(valijson::valijson SYSTEM INTERFACE ${VALIJSON_INCLUDE_DIR})

# Serial by name: plain "hdf5" is whichever variant Debian's alternatives prefer, with VTK installed the MPI one.
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(OPENBLAS REQUIRED IMPORTED_TARGET openblas)
