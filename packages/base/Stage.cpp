// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Stage.hpp"

#include <Teuchos_TimeMonitor.hpp>
#include <algorithm>

namespace stroma::base {
namespace {

std::vector<Teuchos::RCP<Teuchos::Time>>& stages() {
  static std::vector<Teuchos::RCP<Teuchos::Time>>
      list;  // in order of first use, as Teuchos' is not
  return list;
}

Teuchos::RCP<Teuchos::Time> timer_of(const std::string& name) {
  auto timer = Teuchos::TimeMonitor::lookupCounter("stroma: " + name);
  if (timer == Teuchos::null) {
    timer = Teuchos::TimeMonitor::getNewCounter("stroma: " + name);
    stages().push_back(timer);
  }
  return timer;
}

}  // namespace

Stage::Stage(const std::string& name)
    : monitor_(Teuchos::rcp(new Teuchos::TimeMonitor(*timer_of(name)))) {}

Stage::~Stage() = default;

std::vector<std::pair<std::string, double>> stage_seconds(const Communicator& communicator) {
  std::vector<std::pair<std::string, double>> seconds;
  for (const auto& timer : stages())
    seconds.emplace_back(timer->name().substr(8), communicator.max(timer->totalElapsedTime()));
  return seconds;
}

}  // namespace stroma::base
