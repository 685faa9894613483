# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE=DIR -D GIT=PROGRAM -D HEADER=FILE -P commit.cmake
# Writes a header with the commit of the sources, and leaves it alone where it says so already: nothing is compiled again
# then. "unknown" without git, and where the sources are no clone of their own (a tarball, or a folder of another project).
set(commit "")
if(GIT)
  execute_process(
    COMMAND ${GIT} -C ${SOURCE} rev-parse --show-prefix
    OUTPUT_VARIABLE inside RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed AND inside STREQUAL "")
    execute_process(
      COMMAND ${GIT} --no-optional-locks -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude *
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
if(commit STREQUAL "")
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT [[
#pragma once
#define STROMA_COMMIT "@commit@"
]])
