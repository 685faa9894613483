#include "base/ForeignError.hpp"

#include <unistd.h>

#include <new>
#include <stdexcept>

#include "base/Error.hpp"

namespace stroma::base {
namespace {

/// The last paragraph, its lines joined.
std::string last_paragraph(const std::string& text) {
  std::string last, current;
  bool line_is_empty = true;
  for (const char c : text + "\n\n") {
    if (c == '\n') {
      if (line_is_empty) {
        if (!current.empty()) last = current;
        current.clear();
      }
      line_is_empty = true;
    } else if (c != ' ' || !line_is_empty) {
      if (line_is_empty && !current.empty()) current += ' ';
      line_is_empty = false;
      current += c;
    }
  }
  return last;
}

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

std::string words_of_current_exception() {
  std::string words;
  try {
    throw;
  } catch (const std::bad_alloc&) {
    words = "out of memory";
  } catch (const std::exception& error) {
    words = last_paragraph(error.what());
  } catch (const std::string& text) {
    words = last_paragraph(text);
  } catch (const char* text) {
    words = last_paragraph(text);
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
