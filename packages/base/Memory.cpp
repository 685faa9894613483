// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/base/Machine.hpp"

namespace stroma::base {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A limit that a control group's file states; infinite where it is absent or says "max".
double limit_in(const std::string& path) {
  std::ifstream file(path);
  double bytes = 0.0;
  return file >> bytes && bytes > 0.0 ? bytes : infinity;
}

/// The least limit of the control groups that hold this process, of either version.
double control_group_limit() {
  std::ifstream groups("/proc/self/cgroup");
  double least = infinity;
  for (std::string line; std::getline(groups, line);) {  // "0::/path" or "4:memory:/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_memory = ("," + controllers + ",").find(",memory,") != std::string::npos;
    if (!controllers.empty() && !is_memory) continue;
    const std::string root = controllers.empty() ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    const std::string name = controllers.empty() ? "/memory.max" : "/memory.limit_in_bytes";
    std::string path = line.substr(second + 1);
    while (true) {  // a limit of a group holds for the groups within it
      least = std::min(least, limit_in(root + path + name));
      const std::size_t slash = path.rfind('/');
      if (path.empty() || slash == std::string::npos) break;
      path.resize(slash);
    }
  }
  return least;
}

/// The address space that this process has mapped [bytes].
double mapped() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

MemoryLimit machine_memory() {
  const double physical =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double group = control_group_limit();
  if (group < physical) return {group, "the memory of this control group"};
  return {physical, "physical memory"};
}

MemoryLimit process_memory() {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return {infinity, ""};
  return {std::max(0.0, static_cast<double>(limit.rlim_cur) - mapped()),
          "what is left of the address space (ulimit -v)"};
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::string shortage(const Communicator& communicator, double bytes) {
  const int ranks = Machine(communicator).ranks().size();
  const MemoryLimit machine = machine_memory(), process = process_memory();
  std::string text;
  if (static_cast<double>(ranks) * (program_memory + bytes) > machine.bytes)
    text = format("%s is %s", machine.set_by.c_str(), readable_bytes(machine.bytes).c_str()) +
           (ranks > 1 ? format(" on a machine with %d of them", ranks) : "");
  else if (bytes > process.bytes)
    text = format("%s is %s", process.set_by.c_str(), readable_bytes(process.bytes).c_str());
  const int first = communicator.min(text.empty() ? communicator.size() : communicator.rank());
  if (first == communicator.size()) return "";
  communicator.broadcast(text, first);
  return (communicator.size() > 1 ? format("each of %d ranks needs", communicator.size())
                                  : std::string("the run needs")) +
         " about " + readable_bytes(bytes) + ", and " + text;
}

std::string readable_bytes(double bytes) {
  constexpr double mib = 1024.0 * 1024.0;
  return bytes < 1024.0 * mib ? format("%.0f MiB", bytes / mib)
                              : format("%.3g GiB", bytes / (1024.0 * mib));
}

bool is_out_of_memory(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         std::strstr(error.what(), "failed to allocate memory") != nullptr;  // Kokkos
}

}  // namespace stroma::base
