# SPDX-License-Identifier: BSD-3-Clause
# stroma::trilinos is the one target through which Stroma sees Trilinos. It hides what differs between
# Trilinos 13 (lists in variables, one config file per package) and 14 to 16 (imported targets).

set(STROMA_TRILINOS_PACKAGES
    Teuchos Kokkos Tpetra Belos Ifpack2 Amesos2 MueLu Thyra ThyraTpetraAdapters NOX)
find_package(MPI REQUIRED COMPONENTS CXX)

# Preset `threads`: a Trilinos with OpenMP, which no distribution packages.
if(STROMA_THREADS AND NOT Trilinos_DIR)
  set(default /opt/trilinos-openmp)
  if(DEFINED ENV{STROMA_TRILINOS_OPENMP})
    set(default $ENV{STROMA_TRILINOS_OPENMP})
  endif()
  set(STROMA_TRILINOS_OPENMP ${default} CACHE PATH "Where the Trilinos with OpenMP was installed")
  if(NOT EXISTS ${STROMA_TRILINOS_OPENMP}/lib/cmake/Trilinos)
    message(FATAL_ERROR "No Trilinos with OpenMP in ${STROMA_TRILINOS_OPENMP}: run "
                        "cmake/unpack_threads_toolchain.sh or cmake/build_trilinos_openmp.sh, or give "
                        "-DSTROMA_TRILINOS_OPENMP= or -DTrilinos_DIR=")
  endif()
  set(Trilinos_DIR ${STROMA_TRILINOS_OPENMP}/lib/cmake/Trilinos CACHE PATH "Trilinos with OpenMP")
endif()

string(REPLACE ";" " " STROMA_TRILINOS_COMPONENTS "${STROMA_TRILINOS_PACKAGES}")
find_package(Trilinos REQUIRED COMPONENTS ${STROMA_TRILINOS_PACKAGES})
message(STATUS "Trilinos ${Trilinos_VERSION} in ${Trilinos_DIR}")

add_library(stroma_trilinos INTERFACE)
add_library(stroma::trilinos ALIAS stroma_trilinos)
if(TARGET Tpetra::all_libs)
  # Package by package: Trilinos::all_selected_libs is what the first to look for Trilinos has selected.
  foreach(package IN LISTS STROMA_TRILINOS_PACKAGES)
    if(TARGET ${package}::all_libs)
      target_link_libraries(stroma_trilinos INTERFACE ${package}::all_libs)
    endif()
  endforeach()
else()
  target_include_directories(
    stroma_trilinos SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS} ${Trilinos_TPL_INCLUDE_DIRS})
  target_link_directories(stroma_trilinos INTERFACE ${Trilinos_LIBRARY_DIRS})
  target_link_libraries(stroma_trilinos INTERFACE ${Trilinos_LIBRARIES} ${Trilinos_TPL_LIBRARIES})
  # Clang 19 looks into templates that nobody uses, and refuses KokkosSparse_spadd_handle.hpp of Trilinos 13.
  set(is_clang_19 $<AND:$<CXX_COMPILER_ID:Clang>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,19>>)
  target_compile_options(stroma_trilinos INTERFACE $<${is_clang_19}:-fdelayed-template-parsing>)
endif()
target_link_libraries(stroma_trilinos INTERFACE MPI::MPI_CXX)

# The compiler needs OpenMP's flag where Kokkos was built with it.
set(STROMA_NEEDS_OPENMP OFF)
string(TOUPPER "${Kokkos_DEVICES}" kokkos_devices)
if(OPENMP IN_LIST kokkos_devices)
  set(STROMA_NEEDS_OPENMP ON)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
  target_link_libraries(stroma_trilinos INTERFACE OpenMP::OpenMP_CXX)
endif()

if(STROMA_THREADS AND NOT STROMA_NEEDS_OPENMP)
  message(FATAL_ERROR "The Trilinos in ${Trilinos_DIR} was built without Kokkos' OpenMP back end")
endif()

# Kokkos alone, for the packages whose headers must compile without Tpetra.
add_library(stroma_kokkos INTERFACE)
add_library(stroma::kokkos ALIAS stroma_kokkos)
target_link_libraries(stroma_kokkos INTERFACE stroma_trilinos)
