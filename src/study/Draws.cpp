// SPDX-License-Identifier: BSD-3-Clause

#include "study/Draws.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

#include "stroma/base/Log.hpp"
#include "study/Bands.hpp"

namespace stroma {
namespace {

/// z(u) of the standard normal distribution, by bisection of its integral.
double standard_normal(double u) {
  double low = -40.0, high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < u ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void check_distribution(const InputParameters& p, deck::Findings& findings) {
  const auto want = [&](const char* name, bool is_given, Distribution of, const char* word) {
    if (is_given != (p.distribution == of))
      findings.add(name, is_given ? std::string("belongs to another Distribution, ") + word
                                  : std::string("missing; Distribution is ") + word);
  };
  want("Range", p.range.has_value(), Distribution::uniform, "Uniform");
  want("Mean", p.mean.has_value(), Distribution::normal, "Normal");
  want("Standard Deviation", p.standard_deviation.has_value(), Distribution::normal, "Normal");
  want("Median", p.median.has_value(), Distribution::log_normal, "Log-normal");
  want("Relative Deviation", p.relative_deviation.has_value(), Distribution::log_normal,
       "Log-normal");
  if (p.range && !((*p.range)[0] < (*p.range)[1]))
    findings.add("Range", "admissible: two numbers that ascend");
}

void refuse_twins(const UncertaintyParameters& p, deck::Findings& findings) {
  for (std::size_t i = 0; i < p.inputs.all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (p.inputs.all[i].second.path == p.inputs.all[j].second.path)
        findings.add("Inputs|" + p.inputs.all[i].first + "|Path",
                     "\"" + p.inputs.all[j].first + "\" is the same parameter; admissible: once");
}

}  // namespace

deck::Section<UncertaintyParameters> uncertainty_section() {
  deck::Section<InputParameters> input(
      "NAME", "A parameter that is not known for certain; NAME is the user's.");
  input.required("Path", &InputParameters::path, deck::not_empty(),
                 "The parameter of the base deck, such as Image|Segmentation|Threshold.");
  input.choice("Distribution", &InputParameters::distribution,
               {{"Uniform", Distribution::uniform},
                {"Normal", Distribution::normal},
                {"Log-normal", Distribution::log_normal}},
               "How it is distributed.");
  input.optional("Range", &InputParameters::range, deck::any(), "Of Uniform: from, to.");
  input.optional("Mean", &InputParameters::mean, deck::any(), "Of Normal.");
  input.optional("Standard Deviation", &InputParameters::standard_deviation, deck::positive(),
                 "Of Normal.");
  input.optional("Median", &InputParameters::median, deck::positive(), "Of Log-normal.");
  input.optional("Relative Deviation", &InputParameters::relative_deviation, deck::positive(),
                 "Of Log-normal: the standard deviation of its logarithm.");
  input.check(check_distribution);
  deck::Section<InputList> inputs("Inputs", "What is drawn, one sublist each.");
  inputs.named_sections(input, &InputList::all);

  deck::Section<UncertaintyParameters> section(
      "Uncertainty",
      "Runs with parameters drawn from distributions, in place of Cases and Vary: bands of force "
      "and stress, and which parameter they come from.");
  section.optional("Draws", &UncertaintyParameters::draws, deck::between(5, 900),
                   "Runs, each with a draw of all inputs; a Latin hypercube.");
  section.optional("Seed", &UncertaintyParameters::seed, deck::not_negative(),
                   "Another seed, other draws.");
  section.required_section(inputs, &UncertaintyParameters::inputs);
  section.optional("Finer Element Size [um]", &UncertaintyParameters::finer, deck::positive(),
                   "A run with all inputs at their medians is made on these elements too, to set "
                   "the error of discretisation beside the bands.");
  section.optional(
      "Stress Bands", &UncertaintyParameters::stress_bands, deck::any(),
      "Write von_mises_05.tif, von_mises_50.tif and von_mises_95.tif: of each voxel the von "
      "Mises stress at full load that 5, 50 and 95 % of the draws stay below.");
  section.check(refuse_twins);
  return section;
}

double quantile(const InputParameters& input, double u) {
  switch (input.distribution) {
    case Distribution::normal:
      return *input.mean + standard_normal(u) * *input.standard_deviation;
    case Distribution::log_normal:
      return *input.median * std::exp(standard_normal(u) * *input.relative_deviation);
    case Distribution::uniform:
      break;
  }
  return (*input.range)[0] + u * ((*input.range)[1] - (*input.range)[0]);
}

std::vector<std::vector<double>> latin_hypercube(const UncertaintyParameters& uncertainty) {
  const auto n = static_cast<std::size_t>(uncertainty.draws);
  // The engine's numbers are the same everywhere; the standard's distributions are not.
  std::mt19937_64 random(static_cast<std::uint64_t>(uncertainty.seed));
  const auto fraction = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<std::vector<double>> draws(n);
  for (const auto& named : uncertainty.inputs.all) {
    std::vector<std::size_t> stratum(n);
    std::iota(stratum.begin(), stratum.end(), std::size_t{0});
    for (std::size_t i = n - 1; i > 0; --i)
      std::swap(stratum[i], stratum[static_cast<std::size_t>(random() % (i + 1))]);
    for (std::size_t i = 0; i < n; ++i) {
      const double inside = 0.5 * 0x1p-53 + fraction();  // never at an end
      draws[i].push_back(quantile(
          named.second, (static_cast<double>(stratum[i]) + inside) / static_cast<double>(n)));
    }
  }
  return draws;
}

std::vector<std::string> draw_notes(const UncertaintyParameters& uncertainty) {
  constexpr double noticeable = 0.3;
  const auto& inputs = uncertainty.inputs.all;
  std::vector<std::vector<double>> columns(inputs.size());
  for (const std::vector<double>& draw : latin_hypercube(uncertainty))
    for (std::size_t i = 0; i < inputs.size(); ++i) columns[i].push_back(draw[i]);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    for (std::size_t j = i + 1; j < inputs.size(); ++j) {
      const double by_chance = rank_correlation(columns[i], columns[j]).value_or(0.0);
      if (std::abs(by_chance) > noticeable)
        notes.push_back(base::format(
            "the draws of \"%s\" and \"%s\" have a rank correlation of %.2f by chance, so that the "
            "effect of one shows in the correlation of the other; more Draws, or another Seed, "
            "would part them",
            inputs[i].first.c_str(), inputs[j].first.c_str(), by_chance));
    }
  return notes;
}

}  // namespace stroma
