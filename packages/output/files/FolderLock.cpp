// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/FolderLock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"

namespace stroma::output {
namespace {

/// Who holds a lock.
struct Holder {
  std::string host;
  long process = 0;
  std::string start;  ///< of the process, in ticks since the machine began; "?" where not known
};

std::string this_host() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name[0] == '\0' ? "?" : name;
}

/// When a process began: a number may have gone to another process since. "gone" if it has ended.
std::string start_of(long process) {
  if (kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) return "gone";
  const std::string text = base::file_content("/proc/" + std::to_string(process) + "/stat");
  const std::size_t name_end = text.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos) return "?";
  std::istringstream fields(text.substr(name_end + 1));
  std::string state, field;
  fields >> state;
  if (state == "Z" || state == "X") return "gone";  // ended, and not yet asked for its status
  for (int n = 4; n <= 22; ++n) fields >> field;
  return field.empty() ? "?" : field;
}

std::string content_of_own_lock() {
  return this_host() + " " + std::to_string(getpid()) + " " + start_of(getpid()) + "\n";
}

bool is_gone(const Holder& holder) {
  const std::string start = start_of(holder.process);
  return start == "gone" || (start != "?" && holder.start != "?" && start != holder.start);
}

bool write_new(const std::string& path, const std::string& content) {
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0) return false;
  const bool written =
      write(file, content.data(), content.size()) == static_cast<ssize_t>(content.size());
  return (close(file) == 0) && written;
}

}  // namespace

FolderLock::FolderLock(std::string folder)
    : folder_(std::move(folder)), path_(folder_ + "/.stroma_lock") {
  for (int tries = 0; !make(); ++tries) {
    if (tries == 100)
      throw base::InputError("cannot lock the output folder '" + folder_ +
                             "': other runs make and remove '" + path_ + "' all the time");
    judge();
  }
}

FolderLock::~FolderLock() {
  if (base::file_content(path_) == content_of_own_lock()) unlink(path_.c_str());
}

/// A file with its content appears at once where a file can be given a second name. \return false
/// when there is a lock already
bool FolderLock::make() const {
  const std::string content = content_of_own_lock();
  const std::string draft = path_ + "." + this_host() + "." + std::to_string(getpid());
  unlink(draft.c_str());
  if (!write_new(draft, content)) {
    const int reason = errno;
    unlink(draft.c_str());
    throw base::InputError("cannot write into the output folder '" + folder_ +
                           "': " + std::strerror(reason));
  }
  const bool linked = link(draft.c_str(), path_.c_str()) == 0;
  const int reason = errno;
  unlink(draft.c_str());
  if (linked) return true;
  if (reason == EEXIST) return false;
  if (write_new(path_, content)) return true;  // a file system without second names
  if (errno == EEXIST) return false;
  throw base::InputError("cannot lock the output folder '" + folder_ +
                         "': " + std::strerror(errno));
}

/// Removes a lock whose process is gone. \throws base::InputError when it may still be there
void FolderLock::judge() {
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;  // it has just gone
  struct Close {
    int file;
    ~Close() { close(file); }
  } const close_it{file};
  flock(file, LOCK_EX);  // one at a time judges, and the next one sees that the name has gone
  struct stat opened {};
  struct stat named {};
  if (fstat(file, &opened) != 0 || stat(path_.c_str(), &named) != 0 ||
      opened.st_ino != named.st_ino)
    return;
  Holder holder;
  std::istringstream(base::file_content(path_)) >> holder.host >> holder.process >> holder.start;
  const std::string who =
      "process " + std::to_string(holder.process) + " on " +
      (holder.host == this_host() ? "this machine" : "the machine '" + holder.host + "'");
  if (holder.process <= 0)
    throw base::InputError("the output folder '" + folder_ + "' is locked, and '" + path_ +
                           "' does not say by whom; if no run writes into it, remove that file");
  if (holder.host != this_host())
    throw base::InputError("the output folder '" + folder_ + "' is locked by " + who +
                           "; if that run is gone, remove '" + path_ +
                           "', else choose another folder (-o)");
  if (!is_gone(holder))
    throw base::InputError("another run, " + who + ", writes into the output folder '" + folder_ +
                           "'; wait for its end, or choose another folder (-o)");
  unlink(path_.c_str());
  note_ = "the lock of an earlier run that did not come to its end (" + who + ") was taken over";
}

}  // namespace stroma::output
