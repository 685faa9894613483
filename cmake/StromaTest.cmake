# stroma_test(NAME LABEL unit|verification|regression SOURCES file... [USES package...] [RANKS n...])
#
# One GoogleTest executable, run once for each number of ranks (default: 1). Its tests find the project's
# folder in STROMA_SOURCE_DIR and the shared reference data, if there are any, in STROMA_SHARED_DIR.
find_package(GTest REQUIRED)

set(STROMA_TEST_ENVIRONMENT
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
    OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
    OMP_NUM_THREADS=1)

function(stroma_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;USES;RANKS;LIBRARIES" ${ARGN})
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  set(target test_${arg_LABEL}_${name})
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE stroma_test_main stroma_options ${arg_LIBRARIES})
  foreach(used IN LISTS arg_USES)
    target_link_libraries(${target} PRIVATE stroma_${used})
  endforeach()
  target_compile_definitions(
    ${target} PRIVATE STROMA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    STROMA_SHARED_DIR="${PROJECT_SOURCE_DIR}/../shared"
    STROMA_EXECUTABLE="${PROJECT_BINARY_DIR}/bin/stroma")
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  foreach(ranks IN LISTS arg_RANKS)
    set(test ${arg_LABEL}.${name}.np${ranks})
    add_test(NAME ${test} COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${target}>)
    set_tests_properties(
      ${test} PROPERTIES LABELS ${arg_LABEL} PROCESSORS ${ranks} TIMEOUT 600
      ENVIRONMENT "${STROMA_TEST_ENVIRONMENT}")
  endforeach()
endfunction()
