// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/DeckFile.hpp"

#include <Trilinos_version.h>
#include <exodusII.h>
#include <hdf5.h>

#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma::output {
namespace {

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

/// Two hyphens in a row would end an XML comment.
std::string for_comment(std::string text) {
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;)
    text.replace(at, 2, "- ");
  return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> library_versions() {
  return {{"Stroma", STROMA_VERSION},
          {"Trilinos", TRILINOS_VERSION_STRING},
          {"MPI", mpi_version()},
          {"HDF5", hdf5_version()},
          {"Exodus", base::format("%.2f", static_cast<double>(EX_API_VERS))}};
}

void write_deck(const base::Communicator& communicator, const std::string& path,
                const Teuchos::ParameterList& deck) {
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::string text = "<!-- The deck as it was run, with all defaults.\n";
    for (const auto& [name, version] : library_versions()) {
      text += "     " + name + ": " + for_comment(version) + "\n";
    }
    text += "-->\n";
    std::ostringstream list;
    Teuchos::writeParameterListToXmlOStream(deck, list);
    write_file(path, text + list.str());
  });
}

}  // namespace stroma::output
