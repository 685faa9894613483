// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Exceptions of other people's libraries.

#include <functional>
#include <string>

#include "stroma/base/Communicator.hpp"

namespace stroma::base {

/// The last paragraph of a text, in one line, without what Trilinos puts before its words.
std::string last_words(const std::string& text);

/// What an exception of a library says, whatever its type, in one line: of the texts that Trilinos
/// composes, the last part, which is meant for people. Call it where it was caught (it takes
/// std::current_exception()).
std::string words_of_current_exception();

/// Runs work(), which calls libraries on all ranks. An exception that is none of Stroma's becomes a
/// RunError with its words, provided that all ranks have met one within a few seconds; where one
/// rank alone did, the others may wait for it forever, and it throws a std::runtime_error.
/// Collective.
void run_foreign(const Communicator& communicator, const std::function<void()>& work);

}  // namespace stroma::base
