// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/ForeignError.hpp"

#include <unistd.h>

#include <stdexcept>

#include "stroma/base/Error.hpp"
#include "stroma/base/Memory.hpp"

namespace stroma::base {
namespace {

/// A place for all ranks to meet, apart from their other messages.
class MeetingPoint {
 public:
  explicit MeetingPoint(const Communicator& communicator) {
    MPI_Comm_dup(communicator.raw(), &own_);
  }
  ~MeetingPoint() {
    if (!is_waited_for_) MPI_Comm_free(&own_);
  }
  MeetingPoint(const MeetingPoint&) = delete;
  MeetingPoint& operator=(const MeetingPoint&) = delete;

  /// Whether all ranks come here within some seconds.
  bool all_arrive(double seconds) {
    MPI_Request barrier;
    MPI_Ibarrier(own_, &barrier);
    is_waited_for_ = true;
    const double end = MPI_Wtime() + seconds;
    while (is_waited_for_ && MPI_Wtime() < end) {
      int done = 0;
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
      is_waited_for_ = done == 0;
      if (is_waited_for_) usleep(1000);
    }
    return !is_waited_for_;
  }

 private:
  MPI_Comm own_;
  bool is_waited_for_ = false;
};

}  // namespace

std::string last_words(const std::string& text) {
  std::string last, current, line;
  const auto end_paragraph = [&] {
    if (!current.empty() && current.rfind("Throw ", 0) != 0) last = current;
    current.clear();
  };
  for (const char c : text + "\n\n") {
    if (c != '\n') {
      line += c;
      continue;
    }
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) {
      end_paragraph();
    } else {
      current += (current.empty() ? "" : " ") + line.substr(begin);
    }
    line.clear();
  }
  return last;
}

std::string words_of_current_exception() {
  std::string words;
  try {
    throw;
  } catch (const std::exception& error) {
    words = is_out_of_memory(error) ? out_of_memory : last_words(error.what());
  } catch (const std::string& text) {
    words = last_words(text);
  } catch (const char* text) {
    words = last_words(text);
  } catch (...) {
  }
  return words.empty() ? "an error without words" : words;
}

void run_foreign(const Communicator& communicator, const std::function<void()>& work) {
  MeetingPoint meeting(communicator);
  try {
    work();
  } catch (const InputError&) {
    throw;
  } catch (const RunError&) {
    throw;
  } catch (const StepRejected&) {
    throw;
  } catch (...) {
    const std::string words = words_of_current_exception();
    if (!meeting.all_arrive(10.0)) throw std::runtime_error(words);
    throw RunError(words);
  }
}

}  // namespace stroma::base
