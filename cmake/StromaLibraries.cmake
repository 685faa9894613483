# SPDX-License-Identifier: BSD-3-Clause
# The libraries beside Trilinos, each behind one target.

# HDF5 and Exodus must share one MPI build of HDF5: a second, serial HDF5 in the same process would
# answer the first one's calls. Found file by file: CMake's FindHDF5 takes the serial one where both are
# installed with config files, whose targets a consumer of Stroma would have to find again.
find_path(HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/openmpi hdf5/mpich REQUIRED)
find_library(HDF5_LIBRARY NAMES hdf5_openmpi hdf5_mpich hdf5 PATH_SUFFIXES hdf5/openmpi hdf5/mpich REQUIRED)
file(STRINGS "${HDF5_INCLUDE_DIR}/H5pubconf.h" hdf5_with_mpi REGEX "^#define H5_HAVE_PARALLEL")
if(NOT hdf5_with_mpi)
  message(FATAL_ERROR "Stroma needs an HDF5 built with MPI (Debian: libhdf5-openmpi-dev); the one in "
                      "${HDF5_INCLUDE_DIR} is not: give -DHDF5_INCLUDE_DIR= and -DHDF5_LIBRARY=")
endif()
add_library(stroma_hdf5 INTERFACE)
add_library(stroma::hdf5 ALIAS stroma_hdf5)
target_include_directories(stroma_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIR})
target_link_libraries(stroma_hdf5 INTERFACE ${HDF5_LIBRARY})

find_path(EXODUS_INCLUDE_DIR exodusII.h REQUIRED)
find_library(EXODUS_LIBRARY NAMES exodus exoIIv2c REQUIRED)
# The netCDF that Exodus was linked with: Debian has two, and their functions bear the same names.
execute_process(COMMAND ${CMAKE_READELF} -d ${EXODUS_LIBRARY} OUTPUT_VARIABLE exodus_needs ERROR_QUIET)
string(REGEX MATCH "libnetcdf[^]]*" netcdf_of_exodus "${exodus_needs}")
find_path(NETCDF_INCLUDE_DIR netcdf.h REQUIRED)
find_library(NETCDF_LIBRARY NAMES ${netcdf_of_exodus} netcdf REQUIRED)
add_library(stroma_exodus INTERFACE)
add_library(stroma::exodus ALIAS stroma_exodus)
target_include_directories(stroma_exodus SYSTEM INTERFACE ${EXODUS_INCLUDE_DIR} ${NETCDF_INCLUDE_DIR})
target_link_libraries(stroma_exodus INTERFACE ${EXODUS_LIBRARY} ${NETCDF_LIBRARY})

# Compressors of Zarr and TIFF; found file by file, for Blosc has no config files.
find_path(ZSTD_INCLUDE_DIR zstd.h REQUIRED)
find_library(ZSTD_LIBRARY zstd REQUIRED)
find_path(BLOSC_INCLUDE_DIR blosc.h REQUIRED)
find_library(BLOSC_LIBRARY blosc REQUIRED)
add_library(stroma_codecs INTERFACE)
add_library(stroma::codecs ALIAS stroma_codecs)
target_include_directories(stroma_codecs SYSTEM INTERFACE ${ZSTD_INCLUDE_DIR} ${BLOSC_INCLUDE_DIR})
target_link_libraries(stroma_codecs INTERFACE ${ZSTD_LIBRARY} ${BLOSC_LIBRARY})

find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)

# Chart.js, which is built into reports.
find_file(STROMA_CHARTS NAMES chart.min.js Chart.min.js chart.umd.js PATHS /usr/share/javascript PATH_SUFFIXES chart.js REQUIRED)
