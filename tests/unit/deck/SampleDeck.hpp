// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A small deck with one parameter of every type, and the same content in XML and in YAML.

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Section.hpp"

namespace stroma::deck::sample {

enum class Shape { linear, gimp };

struct Material {
  int label = -1;
  double shear_modulus = 0.0;
  std::optional<double> poisson_ratio;
  std::optional<double> bulk_modulus;
};

struct Materials {
  std::vector<std::pair<std::string, Material>> all;
};

struct Grid {
  std::array<double, 3> element_size{};
  bool reset = false;
  Shape shape = Shape::linear;
  std::optional<Shape> fallback;
};

struct Phantom {
  std::array<int, 3> size{4, 4, 4};
  std::vector<double> radii{1.5, 0.1};
  std::vector<std::string> tags;
};

struct Solver {
  double tolerance = 1e-8;
  std::int64_t seed = 5'000'000'000;
  Teuchos::RCP<Teuchos::ParameterList> belos;
};

struct Sample {
  std::string title = "untitled";
  Materials materials;
  Grid grid;
  std::optional<Phantom> phantom;
  Solver solver;
};

inline Section<Sample> declaration() {
  Section<Material> material("Material", "What the body is made of.");
  material.required("Label", &Material::label, at_least(0), "Label of the voxels.")
      .required("Shear Modulus [Pa]", &Material::shear_modulus, positive(), "Stiffness in shear.")
      .optional("Poisson Ratio", &Material::poisson_ratio, strictly_between(-1, 0.5),
                "Or the bulk modulus.")
      .optional("Bulk Modulus [Pa]", &Material::bulk_modulus, positive(), "Or Poisson's ratio.")
      .check([](const Material& m, Findings& findings) {
        if (m.poisson_ratio.has_value() == m.bulk_modulus.has_value()) {
          findings.add(m.poisson_ratio ? "Bulk Modulus [Pa]" : "",
                       "give either Poisson Ratio or Bulk Modulus [Pa]");
        }
      });
  Section<Materials> materials("Materials", "One sublist for each material.");
  materials.named_sections(material, &Materials::all);

  Section<Grid> grid("Grid", "The background grid.");
  grid.required("Element Size [um]", &Grid::element_size, positive(), "Sides of an element.")
      .optional("Reset", &Grid::reset, any(), "Back to the Cartesian grid after a step.")
      .choice("Shape Functions", &Grid::shape, {{"Linear", Shape::linear}, {"GIMP", Shape::gimp}},
              "Which.")
      .choice("Fallback", &Grid::fallback, {{"Linear", Shape::linear}, {"GIMP", Shape::gimp}},
              "Else.");

  Section<Phantom> phantom("Phantom", "A specimen without a file.");
  phantom.optional("Size", &Phantom::size, positive(), "Voxels.")
      .optional("Radii [um]", &Phantom::radii, not_negative(), "Of the tubes.")
      .optional("Tags", &Phantom::tags, any(), "Free words.");

  Section<Solver> solver("Solver", "How it is solved.");
  solver.optional("Newton Tolerance", &Solver::tolerance, between(1e-14, 0.1), "When to stop.")
      .optional("Seed", &Solver::seed, any(), "Of the random numbers.")
      .free_list("Belos", &Solver::belos, "Passed on to Belos.");

  Section<Sample> root("Stroma", "A simulation.");
  root.optional("Title", &Sample::title, not_empty(), "Printed first.")
      .required_section(materials, &Sample::materials)
      .section(grid, &Sample::grid)
      .section(phantom, &Sample::phantom)
      .section(solver, &Sample::solver);
  return root;
}

/// Every kind of parameter; each begins on a line of its own.
inline const char* const xml = R"deck(<?xml version="1.0" encoding="UTF-8"?>
<!-- a comment -->
<ParameterList name="Stroma">
  <Parameter name="Title" type="string" value="gel &amp; vessels, 10 %"/>
  <ParameterList name="Materials">
    <ParameterList name="collagen">
      <Parameter name="Label" type="int" value="0"/>
      <Parameter name="Shear Modulus [Pa]" type="double" value="520.8"/>
      <Parameter name="Poisson Ratio" type="double" value="0.4"/>
    </ParameterList>
    <ParameterList name="a vessel">
      <Parameter name="Label" type="int" value="1"/>
      <Parameter name="Shear Modulus [Pa]" type="int" value="1041"/>
      <Parameter name="Bulk Modulus [Pa]" type="double" value="+4.5e3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Grid">
    <Parameter name="Element Size [um]" type="Array(double)" value="{2.1, 2.1, 2}"/>
    <Parameter name="Reset" type="bool" value="true"/>
    <Parameter name="Shape Functions" type="string" value="GIMP"/>
  </ParameterList>
  <ParameterList name="Phantom">
    <Parameter name="Size" type="Array(int)" value="{8,8,4}"/>
    <Parameter name="Radii [um]" type="Array(double)" value="{}"/>
    <Parameter name="Tags" type="Array(string)" value="{one, number 2}"/>
  </ParameterList>
  <ParameterList name="Solver">
    <Parameter name="Seed" type="long long" value="9000000000"/>
    <ParameterList name="Belos">
      <Parameter name="Convergence Tolerance" type="double" value="1e-7"/>
      <Parameter name="Maximum Iterations" type="int" value="500"/>
      <ParameterList name="Deeper">
        <Parameter name="Name" type="string" value="3"/>
        <Parameter name="Sizes" type="Array(int)" value="{1, 2}"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
</ParameterList>
)deck";

inline const char* const yaml = R"deck(# a comment
Stroma:
  Title: "gel & vessels, 10 %"
  Materials:
    collagen:
      Label: 0
      Shear Modulus [Pa]: 520.8
      Poisson Ratio: 0.4
    a vessel:
      Label: 1
      Shear Modulus [Pa]: 1041
      Bulk Modulus [Pa]: +4.5e3
  Grid:
    Element Size [um]: [2.1, 2.1, 2]
    Reset: true
    Shape Functions: GIMP
  Phantom:
    Size:
      - 8
      - 8
      - 4
    Radii [um]: []
    Tags: [one, number 2]
  Solver:
    Seed: 9000000000
    Belos:
      Convergence Tolerance: 1e-7
      Maximum Iterations: 500
      Deeper: {Name: '3', Sizes: [1, 2]}
)deck";

/// A smallest deck that reads, with something put into its first line after the root's tag.
inline std::string small_xml(const std::string& extra = "") {
  return "<ParameterList name=\"Stroma\">" + extra + R"deck(
  <ParameterList name="Materials">
    <ParameterList name="gel">
      <Parameter name="Label" type="int" value="0"/>
      <Parameter name="Shear Modulus [Pa]" type="double" value="500"/>
      <Parameter name="Poisson Ratio" type="double" value="0.4"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Grid">
    <Parameter name="Element Size [um]" type="Array(double)" value="{2, 2, 2}"/>
  </ParameterList>
</ParameterList>)deck";
}

inline Sample read_text(const std::string& text, Format format = Format::xml,
                        const std::vector<std::string>& overrides = {}) {
  return read(parse(text, format, "gel.xml", overrides), declaration());
}

/// What the user is told about a deck; empty if nothing is wrong.
inline std::string complaint(const std::string& text, Format format = Format::xml,
                             const std::vector<std::string>& overrides = {}) {
  try {
    read_text(text, format, overrides);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

/// The one mistake of a deck, without the headline.
inline std::string only_complaint(const std::string& text, Format format = Format::xml,
                                  const std::vector<std::string>& overrides = {}) {
  const std::string all = complaint(text, format, overrides);
  const std::string headline = "1 mistake in gel.xml\n";
  return all.rfind(headline, 0) == 0 ? all.substr(headline.size()) : "not one mistake: " + all;
}

/// A text with its first occurrence of `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the sample deck has no '" + from + "'");
  return text.replace(at, from.size(), to);
}

template <class E>
std::vector<E> entries(const Teuchos::ParameterList& list, const std::string& name) {
  return list.get<Teuchos::Array<E>>(name).toVector();
}

inline void expect_sample_values(const Sample& deck) {
  EXPECT_EQ(deck.title, "gel & vessels, 10 %");
  ASSERT_EQ(deck.materials.all.size(), 2u);
  const auto& [first_name, first] = deck.materials.all[0];
  const auto& [second_name, second] = deck.materials.all[1];
  EXPECT_EQ(first_name, "collagen");
  EXPECT_EQ(first.label, 0);
  EXPECT_EQ(first.shear_modulus, 520.8);
  EXPECT_EQ(first.poisson_ratio, 0.4);
  EXPECT_FALSE(first.bulk_modulus.has_value());
  EXPECT_EQ(second_name, "a vessel");
  EXPECT_EQ(second.label, 1);
  EXPECT_EQ(second.shear_modulus, 1041.0);
  EXPECT_FALSE(second.poisson_ratio.has_value());
  EXPECT_EQ(second.bulk_modulus, 4500.0);
  EXPECT_EQ(deck.grid.element_size, (std::array<double, 3>{2.1, 2.1, 2.0}));
  EXPECT_TRUE(deck.grid.reset);
  EXPECT_EQ(deck.grid.shape, Shape::gimp);
  EXPECT_FALSE(deck.grid.fallback.has_value());
  ASSERT_TRUE(deck.phantom.has_value());
  EXPECT_EQ(deck.phantom->size, (std::array<int, 3>{8, 8, 4}));
  EXPECT_TRUE(deck.phantom->radii.empty());
  EXPECT_EQ(deck.phantom->tags, (std::vector<std::string>{"one", "number 2"}));
  EXPECT_EQ(deck.solver.tolerance, 1e-8);
  EXPECT_EQ(deck.solver.seed, 9'000'000'000);
  ASSERT_TRUE(Teuchos::nonnull(deck.solver.belos));
  const Teuchos::ParameterList& belos = *deck.solver.belos;
  EXPECT_EQ(belos.numParams(), 3);
  EXPECT_EQ(belos.get<double>("Convergence Tolerance"), 1e-7);
  EXPECT_EQ(belos.get<int>("Maximum Iterations"), 500);
  EXPECT_EQ(belos.sublist("Deeper").get<std::string>("Name"), "3");
  EXPECT_EQ(entries<int>(belos.sublist("Deeper"), "Sizes"), (std::vector<int>{1, 2}));
}

}  // namespace stroma::deck::sample
