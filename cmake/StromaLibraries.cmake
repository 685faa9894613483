# The libraries beside Trilinos, each behind one target.

# HDF5 and Exodus must share one MPI build of HDF5: a second, serial HDF5 in the same process would
# answer the first one's calls.
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "Stroma needs an HDF5 built with MPI (Debian: libhdf5-openmpi-dev)")
endif()
add_library(stroma_hdf5 INTERFACE)
add_library(stroma::hdf5 ALIAS stroma_hdf5)
target_include_directories(stroma_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
target_link_libraries(stroma_hdf5 INTERFACE ${HDF5_C_LIBRARIES})

find_path(EXODUS_INCLUDE_DIR exodusII.h REQUIRED)
find_library(EXODUS_LIBRARY NAMES exodus exoIIv2c REQUIRED)
add_library(stroma_exodus INTERFACE)
add_library(stroma::exodus ALIAS stroma_exodus)
target_include_directories(stroma_exodus SYSTEM INTERFACE ${EXODUS_INCLUDE_DIR})
target_link_libraries(stroma_exodus INTERFACE ${EXODUS_LIBRARY})

find_package(CLI11 REQUIRED)
