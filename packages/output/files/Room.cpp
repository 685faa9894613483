// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/Room.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "stroma/base/Error.hpp"

namespace stroma::output {

void require_room(const std::string& path, std::uint64_t bytes) {
  const auto fail = [&] {
    const int reason = errno;
    ::unlink(path.c_str());
    throw base::RunError("cannot write '" + path + "': " + std::strerror(reason));
  };
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0) fail();
  const int made = ::fallocate(file, 0, 0, static_cast<off_t>(bytes));
  const int reason = errno;
  ::close(file);
  errno = reason;
  if (made != 0 && reason != EOPNOTSUPP && reason != ENOSYS) fail();
  ::unlink(path.c_str());
}

}  // namespace stroma::output
