// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/ProgramFacts.hpp"

#include <Trilinos_version.h>
#include <exodusII.h>
#include <hdf5.h>
#include <mpi.h>

#include <Kokkos_Core.hpp>
#include <algorithm>

#include "StromaBuild.hpp"
#include "StromaCommit.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {
namespace {

std::string kokkos_version() {
  std::string text = base::format("%d.%d.%d, ", KOKKOS_VERSION / 10000, KOKKOS_VERSION / 100 % 100,
                                  KOKKOS_VERSION % 100);
  text += Kokkos::DefaultExecutionSpace::name();
  const std::string host = Kokkos::DefaultHostExecutionSpace::name();
  return host == Kokkos::DefaultExecutionSpace::name() ? text : text + " and " + host;
}

std::string mpi_version() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string version(text, static_cast<std::size_t>(length));
  return version.substr(0, version.find_first_of(",\n"));  // what follows tells of its build
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return base::format("%u.%u.%u", major, minor, release);
}

}  // namespace

Facts program_facts() {
  return {{"Stroma", STROMA_VERSION},
          {"commit", STROMA_COMMIT},
          {"compiler", STROMA_COMPILER},
          {"build", STROMA_BUILD},
          {"options", STROMA_BUILD_OPTIONS},
          {"Trilinos", TRILINOS_VERSION_STRING},
          {"Kokkos", kokkos_version()},
          {"MPI", mpi_version()},
          {"HDF5", hdf5_version()},
          {"Exodus", base::format("%.2f", static_cast<double>(EX_API_VERS))}};
}

std::string program_version() { return STROMA_VERSION " (" STROMA_COMMIT ")"; }

std::string aligned(const Facts& facts, const std::string& indent) {
  std::size_t longest = 0;
  for (const auto& [name, fact] : facts) longest = std::max(longest, name.size());
  std::string text;
  for (const auto& [name, fact] : facts)
    text += name.empty()
                ? "\n"
                : indent + name + ": " + std::string(longest - name.size(), ' ') + fact + "\n";
  return text;
}

}  // namespace stroma::output
