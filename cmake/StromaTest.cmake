# SPDX-License-Identifier: BSD-3-Clause
# stroma_test(NAME LABEL unit|verification|regression SOURCES file... [FILES_APART] [USES package...] [RANKS n...]
#             [THREADED_RANKS n...])
#
# One GoogleTest executable, run once for each number of ranks (default: 1). Its tests find the project's
# folder, with tests/data in it, and the program by tests/support/Places.hpp.
# FILES_APART: its files give different things the same short names, so they are not compiled several at a time.
# Where Trilinos has threads, those tests are run that name THREADED_RANKS: what they test runs kernels. They are run
# on each of these numbers of ranks, with 2 threads each. The targets unit_tests, verification_tests and regression_tests
# build all of a kind that is run.
# Ranks of one machine need no network: Open MPI 5 complains of those it cannot use, and 4 sleeps for a second when a
# run without tcp closes that of libfabric. Threads that wait leave the processor to other ranks.
# Symbols are bound at the start: a thread of Open MPI 4 that binds its first call while components are unloaded has ended
# one start of many thousands by a segmentation fault (in ld.so, called from event_base_loop of libopen-pal).
set(STROMA_TEST_ENVIRONMENT
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
    OMPI_MCA_btl=^tcp,ofi
    LD_BIND_NOW=1
    OMP_WAIT_POLICY=passive)

set(STROMA_TEST_TIMEOUT 600 CACHE STRING "Seconds that a test may take")

# More ranks than processors, bound to none of them: options, because the variables for it change their names with
# each Open MPI (4, 5 and 6), which have these options in common.
set(STROMA_MPIEXEC ${MPIEXEC_EXECUTABLE})
execute_process(COMMAND ${MPIEXEC_EXECUTABLE} --version OUTPUT_VARIABLE mpiexec_version ERROR_QUIET)
if(mpiexec_version MATCHES "Open MPI|OpenRTE")
  list(APPEND STROMA_MPIEXEC --oversubscribe --bind-to none)
endif()
list(APPEND STROMA_MPIEXEC ${MPIEXEC_NUMPROC_FLAG})

foreach(label unit verification regression)
  add_custom_target(${label}_tests)
endforeach()

function(stroma_add_test name label target ranks threads suffix)
  math(EXPR processors "${ranks} * ${threads}")
  set(test ${label}.${name}.np${ranks}${suffix})
  add_test(NAME ${test} COMMAND ${STROMA_MPIEXEC} ${ranks} $<TARGET_FILE:${target}>)
  set_tests_properties(
    ${test} PROPERTIES LABELS ${label} PROCESSORS ${processors} TIMEOUT ${STROMA_TEST_TIMEOUT}
    ENVIRONMENT "${STROMA_TEST_ENVIRONMENT};OMP_NUM_THREADS=${threads}")
endfunction()

function(stroma_test name)
  cmake_parse_arguments(arg "FILES_APART" "LABEL" "SOURCES;USES;RANKS;THREADED_RANKS;LIBRARIES" ${ARGN})
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  set(target test_${arg_LABEL}_${name})
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE stroma_test_main stroma_options ${arg_LIBRARIES})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)  # a third less to wait for; kernels are in the packages
  foreach(used IN LISTS arg_USES)
    target_link_libraries(${target} PRIVATE stroma_${used})
  endforeach()
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  if(arg_FILES_APART)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  endif()
  if(STROMA_NEEDS_OPENMP AND NOT arg_THREADED_RANKS)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  add_dependencies(${arg_LABEL}_tests ${target})
  if(STROMA_NEEDS_OPENMP)
    foreach(ranks IN LISTS arg_THREADED_RANKS)
      stroma_add_test(${name} ${arg_LABEL} ${target} ${ranks} 2 .threads2)
    endforeach()
  else()
    foreach(ranks IN LISTS arg_RANKS)
      stroma_add_test(${name} ${arg_LABEL} ${target} ${ranks} 1 "")
    endforeach()
  endif()
endfunction()
