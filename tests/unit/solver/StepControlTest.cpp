// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The sequence of loads, with and without rejected steps.

#include <gtest/gtest.h>

#include <vector>

#include "AtTimes.hpp"
#include "stroma/solver/StepControl.hpp"

namespace stroma::solver {
namespace {

std::vector<double> loads_of(StepControl& control) {
  std::vector<double> loads;
  while (!control.finished()) {
    control.accept();
    loads.push_back(control.load());
  }
  return loads;
}

TEST(StepControl, EqualStepsEndAtExactlyOne) {
  for (const int steps : {1, 3, 7, 10, 49, 1000}) {
    StepControl control({steps, 1e-4});
    const auto loads = loads_of(control);
    ASSERT_EQ(static_cast<int>(loads.size()), steps);
    for (int n = 0; n < steps; ++n)
      EXPECT_NEAR(loads[static_cast<std::size_t>(n)], (n + 1.0) / steps, 1e-12);
    EXPECT_EQ(loads.back(), 1.0);
    EXPECT_EQ(control.accepted(), steps);
  }
}

TEST(StepControl, ARejectedStepIsHalvedAndGrowsBack) {
  StepControl control({4, 1e-4});
  EXPECT_DOUBLE_EQ(control.next(), 0.25);
  EXPECT_TRUE(control.reject());
  EXPECT_DOUBLE_EQ(control.next(), 0.125);
  EXPECT_TRUE(control.reject());
  EXPECT_DOUBLE_EQ(control.next(), 0.0625);
  control.accept();
  EXPECT_DOUBLE_EQ(control.next(), 0.1875);  // doubled: 0.125
  control.accept();
  EXPECT_DOUBLE_EQ(control.next(), 0.25);  // the multiple of 1/4 is met
  EXPECT_EQ(control.remaining(), 4);
  control.accept();
  EXPECT_DOUBLE_EQ(control.next(), 0.5);
}

TEST(StepControl, MultiplesOfTheStepAreAlwaysMet) {
  for (const int steps : {3, 10}) {
    StepControl control({steps, 1e-6});
    std::vector<double> loads;
    for (int tries = 0; !control.finished() && tries < 1000; ++tries) {
      if (tries % 3 != 2) {  // two of three tries fail, as long as the step is not tiny
        if (control.next() - control.load() > 0.01) {
          ASSERT_TRUE(control.reject());
          continue;
        }
      }
      const double before = control.load();
      control.accept();
      EXPECT_GT(control.load(), before);
      loads.push_back(control.load());
    }
    ASSERT_TRUE(control.finished());
    for (int n = 1; n <= steps; ++n) {
      bool met = false;
      for (const double load : loads)
        met = met || std::abs(load - static_cast<double>(n) / steps) < 1e-9;
      EXPECT_TRUE(met) << n << " of " << steps;
    }
  }
}

TEST(StepControl, GivesUpBelowTheSmallestStep) {
  StepControl control({2, 0.1});
  EXPECT_TRUE(control.reject());   // 0.25
  EXPECT_TRUE(control.reject());   // 0.125
  EXPECT_FALSE(control.reject());  // 0.0625
  EXPECT_DOUBLE_EQ(control.next(), 0.125);
  EXPECT_EQ(control.load(), 0.0);
  EXPECT_FALSE(control.finished());
}

TEST(StepControl, TimesAreTheEndsOfTheSteps) {
  StepControl control(at_times({0.1, 1.0, 6.0, 10.0}));
  const auto loads = loads_of(control);
  ASSERT_EQ(loads.size(), 4u);
  EXPECT_DOUBLE_EQ(loads[0], 0.01);
  EXPECT_DOUBLE_EQ(loads[1], 0.1);
  EXPECT_DOUBLE_EQ(loads[2], 0.6);
  EXPECT_EQ(loads[3], 1.0);
}

TEST(StepControl, TimesAreMetAfterRejectedSteps) {
  StepControl control(at_times({2.0, 10.0}));
  EXPECT_TRUE(control.reject());
  EXPECT_DOUBLE_EQ(control.next(), 0.1);
  control.accept();
  EXPECT_DOUBLE_EQ(control.next(), 0.2);
  control.accept();  // a whole step again, and the next one as a whole
  EXPECT_DOUBLE_EQ(control.next(), 1.0);
  EXPECT_TRUE(control.reject());
  EXPECT_TRUE(control.reject());
  EXPECT_DOUBLE_EQ(control.next(), 0.4);
  control.accept();
  EXPECT_DOUBLE_EQ(control.next(), 0.8);
  control.accept();
  EXPECT_EQ(control.next(), 1.0);
}

}  // namespace
}  // namespace stroma::solver
