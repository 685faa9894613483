// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// main() of every test executable: starts MPI and Kokkos, runs the tests on all ranks, prints from
/// rank 0 (and from any rank that failed), and fails everywhere when a test failed anywhere.

#include <gtest/gtest.h>
#include <mpi.h>

#include <vector>

#include "stroma/base/Session.hpp"

int main(int argc, char** argv) {
  stroma::base::MpiSession mpi(&argc, &argv);
  std::vector<char*> words(argv, argv + argc);
  const stroma::base::KokkosSession kokkos(stroma::base::Communicator::world(),
                                           stroma::base::take_kokkos_words(words));
  ::testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) {
    class FailuresOnly : public ::testing::EmptyTestEventListener {
      void OnTestPartResult(const ::testing::TestPartResult& result) override {
        if (result.failed())
          fprintf(stderr, "%s:%d: %s\n", result.file_name(), result.line_number(),
                  result.message());
      }
    };
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailuresOnly);
  }
  int failed = RUN_ALL_TESTS();
  int failed_anywhere = 0;
  MPI_Allreduce(&failed, &failed_anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return failed_anywhere;
}
