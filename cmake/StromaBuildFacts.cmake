# SPDX-License-Identifier: BSD-3-Clause

# stroma_build_facts(TARGET): gives a library the headers StromaCommit.hpp, which is right at each build, and
# StromaBuild.hpp: the compiler and the options of Stroma's own code, warnings left out.
function(stroma_build_facts target)
  set(folder ${PROJECT_BINARY_DIR}/facts)
  target_include_directories(${target} PRIVATE ${folder})

  find_package(Git QUIET)
  set(find_commit
      ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D GIT=${GIT_EXECUTABLE} -D HEADER=${folder}/StromaCommit.hpp
      -P ${PROJECT_SOURCE_DIR}/cmake/commit.cmake)
  execute_process(COMMAND ${find_commit})  # clang-tidy looks at what was not built yet
  add_custom_target(
    ${target}_commit COMMAND ${find_commit} BYPRODUCTS ${folder}/StromaCommit.hpp COMMENT "Asking git for the commit" VERBATIM)
  add_dependencies(${target} ${target}_commit)

  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_target_property(own stroma_options INTERFACE_COMPILE_OPTIONS)
  separate_arguments(options UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  list(APPEND options ${own})
  list(FILTER options EXCLUDE REGEX "^-W[a-z]")
  list(JOIN options " " options)
  set(native "for any processor of its kind")
  if(STROMA_NATIVE)
    set(native "for the processor it was built on (STROMA_NATIVE)")
  endif()
  file(CONFIGURE OUTPUT ${folder}/StromaBuild.hpp @ONLY CONTENT [[
#pragma once
#define STROMA_COMPILER R"(@CMAKE_CXX_COMPILER_ID@ @CMAKE_CXX_COMPILER_VERSION@)"
#define STROMA_BUILD R"(@CMAKE_BUILD_TYPE@, @native@)"
#define STROMA_BUILD_OPTIONS R"(@options@)"
]])
endfunction()
