// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The deck section "Output": its defaults, its words, and when a step is written.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Document.hpp"
#include "stroma/sections/OutputSection.hpp"

namespace stroma {
namespace {

/// The section as a deck of its own, with one parameter.
output::OutputParameters read(const std::string& parameter) {
  const auto document = deck::parse(
      "<ParameterList name=\"Output\">" + parameter + "</ParameterList>", deck::Format::xml);
  return deck::read(document, sections::output_section());
}

TEST(OutputSection, HasTheDefaultsOfTheContract) {
  const output::OutputParameters defaults = read("");
  EXPECT_EQ(defaults.particles_every, 1);
  EXPECT_EQ(defaults.grid_every, 1);
  EXPECT_EQ(defaults.checkpoint_every, 0);
  EXPECT_EQ(defaults.checkpoint_minutes, 10.0);
  EXPECT_EQ(defaults.precision, output::Precision::Double);
  EXPECT_TRUE(defaults.pictures);
  EXPECT_EQ(defaults.origin, output::Origin::Top);
}

TEST(OutputSection, ReadsTheOriginOfPictures) {
  EXPECT_EQ(read("<Parameter name=\"Origin\" type=\"string\" value=\"Bottom\"/>").origin,
            output::Origin::Bottom);
  EXPECT_THROW(read("<Parameter name=\"Origin\" type=\"string\" value=\"Left\"/>"),
               base::InputError);
}

TEST(OutputSection, ReadsPrecisionAndRefusesWhatIsNone) {
  EXPECT_EQ(read("<Parameter name=\"Precision\" type=\"string\" value=\"Single\"/>").precision,
            output::Precision::Single);
  EXPECT_THROW(read("<Parameter name=\"Precision\" type=\"string\" value=\"Half\"/>"),
               base::InputError);
  EXPECT_THROW(read("<Parameter name=\"Grid Every\" type=\"int\" value=\"-1\"/>"),
               base::InputError);
  EXPECT_EQ(read("<Parameter name=\"Particles Every\" type=\"int\" value=\"0\"/>").particles_every,
            0);
}

TEST(OutputSection, IsDueEveryNthStepAndAtTheEnd) {
  EXPECT_TRUE(output::is_due(0, 1, false));
  EXPECT_TRUE(output::is_due(4, 2, false));
  EXPECT_FALSE(output::is_due(5, 2, false));
  EXPECT_TRUE(output::is_due(5, 2, true));
  EXPECT_FALSE(output::is_due(4, 0, false));
  EXPECT_FALSE(output::is_due(0, 0, false));
  EXPECT_TRUE(output::is_due(7, 0, true));
}

}  // namespace
}  // namespace stroma
