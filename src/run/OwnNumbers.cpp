// SPDX-License-Identifier: BSD-3-Clause

#include "run/OwnNumbers.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>
#include <optional>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/material/VaryingMaterial.hpp"
#include "stroma/particles/Fields.hpp"

namespace stroma {
namespace {

using base::format;
using material::AnyLaw;
using material::MaterialParameters;
using material::NamedMaterials;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is found out about a field while its particles are visited, by volume.
struct Range {
  double least = infinity, greatest = -infinity, sum = 0.0, volume = 0.0, clipped = 0.0;

  void add(double value, double particle_volume, bool is_clipped) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += particle_volume * value;
    volume += particle_volume;
    if (is_clipped) clipped += particle_volume;
  }
  void over_all_ranks(const base::Communicator& communicator) {
    least = communicator.min(least);
    greatest = communicator.max(greatest);
    sum = communicator.sum(sum);
    volume = communicator.sum(volume);
    clipped = communicator.sum(clipped);
  }
  std::string line(const std::string& name) const {
    return volume > 0.0 ? format("field       %s: %.4g to %.4g, mean %.4g", name.c_str(), least,
                                 greatest, sum / volume)
                        : format("field       %s: no particles", name.c_str());
  }
  /// What a user should look at again.
  std::optional<std::string> oddity(const std::string& name) const {
    if (!(volume > 0.0)) return std::nullopt;
    if (greatest == least) return format("%s is the same everywhere, %.4g", name.c_str(), least);
    if (clipped > 0.5 * volume)
      return format(
          "%s: in %.0f %% of the material the intensity lies beyond the Intensities, where the "
          "number is constant",
          name.c_str(), 100.0 * clipped / volume);
    return std::nullopt;
  }
};

/// One material's particles, one after the other, with the law of each.
class Walk {
 public:
  Walk(FieldImages& images, const std::string& name, const MaterialParameters& material,
       const particles::HostParticles& particles, int index)
      : name_(name), material_(material), varying_(material), particles_(particles) {
    for (int p = 0; p < particles.count(); ++p)
      if (particles.material(p) == index) mine_.push_back(p);
    const std::string where = "Materials|" + name + "|";
    if (material.fields)
      for (const auto& [field, parameters] : material.fields->fields) {
        const std::vector<double>& of_all =
            images.intensities(where + "Fields|" + field, parameters, parameters.smoothing);
        std::vector<double>& of_mine = intensity_.emplace_back();
        for (const int p : mine_) of_mine.push_back(of_all[static_cast<std::size_t>(p)]);
      }
    if (!material.fibers) return;
    std::vector<bool> counts(static_cast<std::size_t>(particles.count()));
    for (const int p : mine_) counts[static_cast<std::size_t>(p)] = true;
    for (std::size_t f = 0; f < material.fibers->families.size(); ++f) {
      const auto& [family, fibers] = material.fibers->families[f];
      if (!fibers.direction_from) continue;
      Directions& directions = directions_.emplace_back();
      directions.family = f;
      const auto of_all = images.directions(where + "Fibers|" + family, fibers, counts);
      for (const int p : mine_) directions.of.push_back(of_all[static_cast<std::size_t>(p)]);
    }
  }

  /// visit(particle, law).
  template <class Visit>
  void for_each(const Visit& visit) {
    for (std::size_t n = 0; n < mine_.size(); ++n) {
      for (std::size_t f = 0; f < intensity_.size(); ++f)
        varying_.set(f, field(f).at(intensity_[f][n]));
      for (const Directions& directions : directions_) {
        const image::Orientation& found = directions.of[n];
        varying_.point(directions.family, found.direction,
                       source(directions).weigh_by_coherence ? found.coherence : 1.0);
      }
      visit(mine_[n], varying_.law());
    }
  }

  /// Lines and notes of its fields. Collective.
  void describe(const base::Communicator& communicator, OwnNumbers& own) const {
    const auto say = [&](const std::string& what, Range range) {
      range.over_all_ranks(communicator);
      own.ranges.push_back(range.line(what));
      if (const auto odd = range.oddity(what)) own.notes.push_back(*odd);
    };
    for (std::size_t f = 0; f < intensity_.size(); ++f) {
      Range range;
      for (std::size_t n = 0; n < mine_.size(); ++n) {
        const double intensity = intensity_[f][n];
        range.add(field(f).at(intensity), particles_.volume(mine_[n]),
                  field(f).is_clipped(intensity));
      }
      say(name_ + "|" + material_.fields->fields[f].first + ", " + field(f).parameter, range);
    }
    for (const Directions& directions : directions_) {
      const std::string family = name_ + "|" + material_.fibers->families[directions.family].first;
      // the mean of N (x) N: 1/3 each of directions that are everywhere alike
      Range along[3], coherence;
      for (std::size_t n = 0; n < mine_.size(); ++n) {
        const double volume = particles_.volume(mine_[n]);
        for (std::size_t d = 0; d < 3; ++d) {
          const double component = directions.of[n].direction[d];
          along[d].add(component * component, volume, false);
        }
        coherence.add(directions.of[n].coherence, volume, false);
      }
      for (Range& range : along) range.over_all_ranks(communicator);
      const double volume = along[0].volume;
      if (volume > 0.0)
        own.ranges.push_back(format("directions  %s: mean squares along x, y, z %.3f, %.3f, %.3f",
                                    family.c_str(), along[0].sum / volume, along[1].sum / volume,
                                    along[2].sum / volume));
      if (source(directions).direction_from ==
          material::DirectionsFromImage::Kind::structure_tensor) {
        coherence.over_all_ranks(communicator);
        own.ranges.push_back(coherence.line(family + ", coherence"));
      }
    }
  }

 private:
  struct Directions {
    std::size_t family = 0;
    std::vector<image::Orientation> of;  // each of mine_
  };
  const material::FieldParameters& field(std::size_t f) const {
    return material_.fields->fields[f].second;
  }
  const material::DirectionsFromImage& source(const Directions& directions) const {
    return material_.fibers->families[directions.family].second;
  }

  std::string name_;
  const MaterialParameters& material_;
  material::VaryingMaterial varying_;
  const particles::HostParticles& particles_;
  std::vector<int> mine_;
  std::vector<std::vector<double>> intensity_;  // (field) of each of mine_
  std::vector<Directions> directions_;
};

/// Numbers that differ from the material's own at some particle of any rank. Collective.
std::vector<int> which_vary(const base::Communicator& communicator, const AnyLaw& at_rest,
                            Walk& walk) {
  const std::vector<double> own = material::numbers_of(at_rest);
  std::vector<double> differs(own.size(), 0.0);
  walk.for_each([&](int, const AnyLaw& law) {
    const std::vector<double> numbers = material::numbers_of(law);
    for (std::size_t n = 0; n < own.size(); ++n)
      if (numbers[n] != own[n]) differs[n] = 1.0;
  });
  communicator.sum_all(differs.data(), differs.size());
  std::vector<int> which;
  for (std::size_t n = 0; n < differs.size(); ++n)
    if (differs[n] > 0.0) which.push_back(static_cast<int>(n));
  return which;
}

/// "shear_modulus" of "Shear Modulus [Pa]".
std::string variable_name(const material::NumberName& number, const MaterialParameters& material) {
  const auto words = [](const std::string& text) {
    std::string name;
    for (const char c : text) {
      const auto letter = static_cast<unsigned char>(c);
      if (std::isalnum(letter) != 0)
        name += static_cast<char>(std::tolower(letter));
      else if (!name.empty() && name.back() != '_')
        name += '_';
    }
    while (!name.empty() && name.back() == '_') name.pop_back();
    return name;
  };
  const std::string deck_name = number.name;
  std::string name = words(deck_name.substr(0, deck_name.find(" [")));
  const bool is_axis = name.find("direction") != std::string::npos;
  if (number.family != material::NumberName::none)
    name = words(material.fibers->families[static_cast<std::size_t>(number.family)].first) + "_" +
           name;
  if (number.entry != material::NumberName::none)
    name +=
        is_axis ? std::string("_") + "xyz"[number.entry] : "_" + std::to_string(number.entry + 1);
  return name;
}

std::string unit_of(const std::string& deck_name) {
  const std::size_t open = deck_name.find('[');
  return open == std::string::npos ? "-"
                                   : deck_name.substr(open + 1, deck_name.find(']') - open - 1);
}

}  // namespace

OwnNumbers give_own_numbers(const base::Communicator& communicator, FieldImages& images,
                            const NamedMaterials& materials,
                            particles::Particles<grid::Device>& particles) {
  OwnNumbers own;
  const particles::HostParticles host = particles::on_host(particles);
  std::vector<std::optional<Walk>> walks(materials.size());
  std::size_t columns = 0;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto& [name, material] = materials[m];
    own.which.emplace_back();
    const AnyLaw at_rest = material::law_at_rest(material);
    own.extremes.insert(own.extremes.end(), 2, at_rest.small_strain());
    if (!material::varies(material)) continue;
    Walk& walk = walks[m].emplace(images, name, material, host, static_cast<int>(m));
    walk.describe(communicator, own);
    own.which[m] = which_vary(communicator, at_rest, walk);
    if (own.which[m].size() > AnyLaw::most_own)
      throw base::InputError(
          format("Materials|%s: %zu numbers of its law vary; admissible: at most "
                 "%d",
                 name.c_str(), own.which[m].size(), AnyLaw::most_own));
    columns = std::max(columns, own.which[m].size());
  }
  if (columns == 0) return own;
  particles::allocate(particles.own_numbers, "own_numbers",
                      static_cast<std::size_t>(particles.count()), columns);
  const auto values = Kokkos::create_mirror_view(particles.own_numbers);
  Kokkos::deep_copy(values, 0.0);
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (!walks[m]) continue;
    material::SmallStrainModuli softest{infinity, infinity}, stiffest{0.0, 0.0};
    walks[m]->for_each([&](int p, const AnyLaw& law) {
      const std::vector<double> numbers = material::numbers_of(law);
      for (std::size_t c = 0; c < own.which[m].size(); ++c)
        values(p, static_cast<int>(c)) = numbers[static_cast<std::size_t>(own.which[m][c])];
      const material::SmallStrainModuli moduli = law.small_strain();
      softest = {std::min(softest.shear, moduli.shear), std::min(softest.bulk, moduli.bulk)};
      stiffest = {std::max(stiffest.shear, moduli.shear), std::max(stiffest.bulk, moduli.bulk)};
    });
    softest = {communicator.min(softest.shear), communicator.min(softest.bulk)};
    stiffest = {communicator.max(stiffest.shear), communicator.max(stiffest.bulk)};
    if (!(softest.shear <= stiffest.shear)) continue;  // no particles
    if (!(softest.shear > 0.0 && softest.bulk > 0.0))
      throw base::InputError(format(
          "Materials|%s|Fields: in small strain a particle's shear modulus is %g Pa, or its bulk "
          "modulus %g Pa; admissible: fields that make both > 0 everywhere",
          materials[m].first.c_str(), softest.shear, softest.bulk));
    own.extremes[2 * m] = softest;
    own.extremes[2 * m + 1] = stiffest;
  }
  Kokkos::deep_copy(particles.own_numbers, values);
  return own;
}

std::vector<ShownNumber> shown_numbers(const NamedMaterials& materials,
                                       const std::vector<std::vector<int>>& which) {
  std::vector<ShownNumber> shown;
  const auto for_each_name = [&](std::size_t m, const auto& visit) {
    AnyLaw law = material::law_at_rest(materials[m].second);
    int place = 0;
    law.for_each_number([&](const material::NumberName& number, double&) {
      visit(place++, variable_name(number, materials[m].second), unit_of(number.name));
    });
  };
  for (std::size_t m = 0; m < which.size(); ++m)
    for_each_name(m, [&](int place, const std::string& name, const std::string& unit) {
      const bool is_known = std::any_of(shown.begin(), shown.end(),
                                        [&](const ShownNumber& s) { return s.name == name; });
      if (!is_known && std::binary_search(which[m].begin(), which[m].end(), place))
        shown.push_back({name, unit, std::vector<int>(materials.size(), -1)});
    });
  for (std::size_t m = 0; m < which.size(); ++m)
    for_each_name(m, [&](int place, const std::string& name, const std::string&) {
      for (ShownNumber& number : shown)
        if (number.name == name) number.place[m] = place;
    });
  return shown;
}

}  // namespace stroma
