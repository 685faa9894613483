// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A term without force that counts how often it is asked for it.

#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::test {

class CountingTerm : public mechanics::Term {
 public:
  explicit CountingTerm(int& count, bool changes_with_load = false)
      : count_(count), changes_with_load_(changes_with_load) {}
  bool changes_with_load() const override { return changes_with_load_; }
  mechanics::TermForce force(const mechanics::TrialState&, grid::Vector& force) const override {
    ++count_;
    force.putScalar(0.0);
    return {};
  }

 private:
  int& count_;
  bool changes_with_load_;
};

}  // namespace stroma::test
