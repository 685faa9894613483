// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What is said of load curves that the planned steps do not meet. Claim V-TIME-6,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "AtTimes.hpp"
#include "stroma/solver/CurveNotes.hpp"

namespace stroma::solver {
namespace {

using mechanics::Beyond;
using mechanics::Interpolation;
using mechanics::LoadCurveParameters;

LoadingParameters in_steps(int steps, std::optional<double> duration) {
  LoadingParameters loading;
  loading.steps = steps;
  loading.duration = duration;
  return loading;
}

LoadCurveParameters linear(std::vector<double> times, std::vector<double> values,
                           Beyond beyond = Beyond::hold) {
  return {std::move(times), std::move(values), Interpolation::linear, beyond};
}

using Notes = std::vector<std::string>;

Notes notes(const LoadCurveParameters& curve, const LoadingParameters& loading) {
  return curve_notes("c", curve, loading);
}

const LoadCurveParameters peak = linear({0.0, 1.5, 2.0, 4.0}, {0.0, 1.0, 0.0, 0.0});
const LoadCurveParameters up_and_down = linear({0.0, 0.5, 1.0}, {0.0, 1.0, 0.0}, Beyond::repeat);

TEST(CurveNotes, APeakBetweenTwoStepsIsTold) {
  EXPECT_EQ(notes(peak, in_steps(4, 4.0)),
            Notes{"Load Curves|c is 1 at 1.5 s, its largest value in the run, but no step is "
                  "planned to end there: about it steps have 0.666667 at 1 s and 0 at 2 s; "
                  "Loading|Times [s] with that time in them, or more Steps, would meet it"});
  EXPECT_EQ(notes(peak, at_times({1.0, 4.0})),
            Notes{"Load Curves|c is 1 at 1.5 s, its largest value in the run, but no step is "
                  "planned to end there: about it steps have 0.666667 at 1 s and 0 at 4 s; "
                  "Loading|Times [s] with that time in them would meet it"});
  EXPECT_EQ(notes(linear({0.0, 0.5, 4.0}, {0.0, -1.0, 0.0}), in_steps(4, 4.0)).size(), 1u);
  EXPECT_NE(notes(linear({0.0, 0.5, 4.0}, {0.0, -1.0, 0.0}), in_steps(4, 4.0))[0].find("smallest"),
            std::string::npos);
}

// A run begins with a curve's start, which no step needs to end at.
TEST(CurveNotes, AnInnerPointOfARampIsNoExtreme) {
  EXPECT_EQ(notes(linear({0.0, 0.37, 1.0}, {0.0, 0.37, 1.0}), in_steps(2, 1.0)), Notes{});
  EXPECT_EQ(notes(linear({0.0, 0.37, 1.0}, {1.0, 0.63, 0.0}), in_steps(2, 1.0)), Notes{});
}

TEST(CurveNotes, ACurveThatIsZeroAtAllStepsIsTold) {
  EXPECT_EQ(notes(up_and_down, in_steps(4, 4.0)),
            Notes{"Load Curves|c is 0 at all planned steps, so that it loads nothing: it is 1 at "
                  "0.5 s, where no step ends; Loading|Times [s] with that time in them, or more "
                  "Steps, would meet it"});
  EXPECT_EQ(notes(linear({10.0, 20.0}, {0.0, 1.0}), in_steps(4, 4.0)),
            Notes{"Load Curves|c is 0 at all planned steps, so that it loads nothing: it is "
                  "something else after the end of the run, 4 s, only; Loading|Duration [s] sets "
                  "its end"});
  EXPECT_EQ(notes(linear({0.0, 1.0, 4.0}, {1.0, 0.0, 0.0}), in_steps(4, 4.0)),
            Notes{"Load Curves|c is 0 at all planned steps, so that it loads nothing: it is 1 at "
                  "the start only"});
}

TEST(CurveNotes, ACurveThatGoesOnAfterTheRunIsTold) {
  EXPECT_EQ(notes(linear({0.0, 100.0}, {0.0, 1.0}), in_steps(4, {})),
            Notes{"Load Curves|c goes on until 100 s, to 1, but the run ends at 1 s, where it is "
                  "0.01; without Loading|Duration [s] time is the load factor, which is 1 there"});
  EXPECT_EQ(notes(linear({0.0, 100.0}, {0.0, 1.0}), at_times({1.0, 50.0})),
            Notes{"Load Curves|c goes on until 100 s, to 1, but the run ends at 50 s, where it is "
                  "0.5; the last of Loading|Times [s] sets its end"});
}

TEST(CurveNotes, ASawtoothsJumpIsTold) {
  const auto sawtooth = linear({0.0, 2.0}, {0.0, 1.0}, Beyond::repeat);
  EXPECT_EQ(notes(sawtooth, in_steps(8, 4.0)),
            Notes{"Load Curves|c jumps from 1 to 0 at 2 s, where it begins again: a step that ends "
                  "there has 0"});
  EXPECT_TRUE(notes(sawtooth, in_steps(8, 1.0)).size() == 1 &&
              notes(sawtooth, in_steps(8, 1.0))[0].find("jumps") == std::string::npos);
}

TEST(CurveNotes, WhatStepsMeetIsNotTold) {
  EXPECT_EQ(notes(peak, in_steps(8, 4.0)), Notes{});
  EXPECT_EQ(notes(peak, at_times({0.7, 1.5, 4.0})), Notes{});
  EXPECT_EQ(notes(up_and_down, in_steps(8, 4.0)), Notes{});
  EXPECT_EQ(notes(linear({0.0, 0.1, 4.0}, {0.0, 1.0, 1.0}), in_steps(4, 4.0)), Notes{});
  EXPECT_EQ(notes(linear({0.0, 2.0, 9.0}, {0.0, 1.0, 1.0}), in_steps(4, 4.0)), Notes{});
  EXPECT_EQ(notes(linear({0.0}, {0.0}), in_steps(4, 4.0)), Notes{});
  EXPECT_EQ(notes(linear({0.0, 4.0}, {1.0, 0.0}), in_steps(4, 4.0)), Notes{});  // from its start on
  const LoadCurveParameters jump{{0.0, 1.1, 2.1}, {0.0, 1.0, 0.0}, Interpolation::step};
  EXPECT_EQ(notes(jump, in_steps(4, 4.0)), Notes{});
}

TEST(CurveNotes, MidpointsAreMet) {
  LoadingParameters moving = in_steps(4, 4.0);
  moving.inertia = true;
  EXPECT_EQ(notes(up_and_down, moving).size(), 1u);
  moving.scheme = TimeIntegration::generalised_alpha;
  moving.spectral_radius = 1.0;
  EXPECT_EQ(notes(up_and_down, moving), Notes{});
}

TEST(CurveNotes, AFirstStepUnderACurveThatBeginsHighIsAdvised) {
  EXPECT_EQ(advice_on_start("c", up_and_down), "");
  EXPECT_EQ(advice_on_start("c", linear({1.0, 2.0}, {0.5, 1.0})),
            "Load Curves|c is 0.5 from the start, however small the first step is: a first point "
            "of 0 at 0 s, from which it rises");
}

}  // namespace
}  // namespace stroma::solver
