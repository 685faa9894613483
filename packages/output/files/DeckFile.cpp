// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/DeckFile.hpp"

#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma::output {
namespace {

/// Two hyphens in a row would end an XML comment.
std::string for_comment(std::string text) {
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;)
    text.replace(at, 2, "- ");
  return text;
}

}  // namespace

void write_deck(const base::Communicator& communicator, const std::string& path,
                const Teuchos::ParameterList& deck, const Facts& of_the_run) {
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    Facts facts = program_facts();
    facts.emplace_back();
    facts.insert(facts.end(), of_the_run.begin(), of_the_run.end());
    const std::string text = "<!-- The deck as it was run, with all defaults.\n\n" +
                             for_comment(aligned(facts, "     ")) + "-->\n";
    std::ostringstream list;
    Teuchos::writeParameterListToXmlOStream(deck, list);
    write_file(path, text + list.str());
  });
}

}  // namespace stroma::output
