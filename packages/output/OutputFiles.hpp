// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The names of the files that a run is asked for.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/output/OutputParameters.hpp"

namespace stroma::output {

/// The files of a run, as they go in its folder's list (Manifest::name_of).
std::vector<std::string> run_files(const OutputParameters& wanted);

/// The frames in which image stacks are wanted: whether each is deformed.
std::vector<bool> are_deformed(const ImageStacksParameters& wanted);

/// The name of an image stack; where there are several, it holds the number of the step.
std::string image_stack_file(const ImageStacksParameters& wanted, bool is_deformed,
                             std::int64_t step);

}  // namespace stroma::output
