// SPDX-License-Identifier: BSD-3-Clause

#include "study/MemberRun.hpp"

#include <Teuchos_TimeMonitor.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <filesystem>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/HistoryTable.hpp"

namespace stroma {
namespace fs = std::filesystem;

std::string xml(const Teuchos::ParameterList& list) {
  std::ostringstream text;
  Teuchos::writeParameterListToXmlOStream(list, text);
  return text.str();
}

bool is_finished(const std::string& folder, const Deck& deck) {
  const std::string text = base::file_content(folder + "/deck.xml"), end_of_comment = "-->\n";
  const std::size_t comment = text.find(end_of_comment);
  const Teuchos::RCP<Teuchos::ParameterList> list = as_run(deck);
  if (comment == std::string::npos || text.substr(comment + end_of_comment.size()) != xml(*list))
    return false;
  try {
    if (!output::HistoryTable(folder + "/history.csv").reached_full_load()) return false;
  } catch (const base::RunError&) {
    return false;
  }
  if (!deck.parameters.image.file) return true;
  std::error_code failure;
  const auto image = fs::last_write_time(list->sublist("Image").get<std::string>("File"), failure);
  return !failure && image <= fs::last_write_time(folder + "/history.csv", failure) && !failure;
}

std::string run_member(const base::Communicator& communicator, const std::string& name,
                       const Deck& deck, const RunOptions& options,
                       const base::StopRequests& signals) {
  Teuchos::TimeMonitor::zeroOutTimers();  // the member's log tells the times of the member
  base::Log log(communicator, true);
  try {
    run_simulation(communicator, deck, options, log);
    log.finish();
    const std::string signal = signals.asked(communicator);
    if (!signal.empty()) throw base::Interrupted("stopped by " + signal + "; it is finished");
    return "";
  } catch (const base::Interrupted& interrupted) {
    throw base::Interrupted(
        "member \"" + name + "\": " + interrupted.what() +
        "\nto go on: give the same command again; what is finished is not run again");
  } catch (const base::RunError& error) {
    log.line(std::string("stroma: ") + error.what());
    return error.what();
  } catch (const base::InputError& error) {
    log.line(std::string("stroma: ") + error.what());
    return located(deck, error).what();
  }
}

std::string in_terms_of(const std::string& family, std::string message) {
  static const std::string option = "\n--set, ";
  for (std::size_t at = 0; (at = message.find(option, at)) != std::string::npos;)
    message.replace(at, option.size(), "\nset by " + family + ", ");
  return message;
}

}  // namespace stroma
