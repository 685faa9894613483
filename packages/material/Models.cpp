// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Models.hpp"

#include <algorithm>

namespace stroma::material {
namespace {

/// What L::declare() says, as a model of the deck.
template <class Law>
class Describing {
 public:
  explicit Describing(Model& model) : model_(model) {}

  void number(const char* name, double Law::*, Range admissible, const char* meaning) {
    model_.numbers.push_back({name, meaning, admissible, false});
  }
  template <int n>
  void numbers(const char* name, double (Law::*)[n], int Law::*, Range admissible,
               const char* meaning) {
    model_.numbers.push_back({name, meaning, admissible, false, n});
  }
  template <class Convert>
  void number_or_poisson_ratio(const char* name, double Law::*, Range admissible, const Convert&,
                               const char* meaning) {
    model_.numbers.push_back({name, meaning, admissible, true});
  }
  void volumetric_energy(VolumetricEnergy Law::*) { model_.has_volumetric_energy = true; }

 private:
  Model& model_;
};

/// L::declare() with the numbers of a material.
template <class Law>
class Filling {
 public:
  explicit Filling(const MaterialParameters& given) : given_(given) {}
  const Law& law() const { return law_; }

  void number(const char* name, double Law::*member, Range, const char*) {
    law_.*member = given_.numbers.at(name);
  }
  template <int n>
  void numbers(const char* name, double (Law::*member)[n], int Law::*count, Range, const char*) {
    const std::vector<double>& list = given_.lists.at(name);
    std::copy(list.begin(), list.end(), law_.*member);
    law_.*count = static_cast<int>(list.size());
  }
  template <class Convert>
  void number_or_poisson_ratio(const char* name, double Law::*member, Range,
                               const Convert& from_shear_modulus_and_poisson_ratio, const char*) {
    const auto found = given_.numbers.find(name);
    law_.*member = found != given_.numbers.end()
                       ? found->second
                       : from_shear_modulus_and_poisson_ratio(
                             law_.small_strain().shear, given_.numbers.at(poisson_ratio_name));
  }
  void volumetric_energy(VolumetricEnergy Law::*member) { law_.*member = given_.volumetric_energy; }

 private:
  const MaterialParameters& given_;
  Law law_{};
};

template <class Law>
Model model_of() {
  Model model;
  model.name = Law::name();
  model.meaning = Law::meaning();
  model.may_vary_in_stiffness = material::may_vary_in_stiffness<Law>;
  Describing<Law> description(model);
  Law::declare(description);
  model.law = [](const MaterialParameters& given) -> AnyLaw {
    Filling<Law> filling(given);
    Law::declare(filling);
    return filling.law();
  };
  return model;
}

template <class... Laws>
std::vector<Model> models_of(const OneOf<Laws...>*) {
  return {model_of<Laws>()...};
}

}  // namespace

bool Model::takes_poisson_ratio() const {
  return std::any_of(numbers.begin(), numbers.end(),
                     [](const ModelNumber& number) { return number.or_poisson_ratio; });
}

bool Model::takes(const std::string& number) const {
  return (number == poisson_ratio_name && takes_poisson_ratio()) ||
         std::any_of(numbers.begin(), numbers.end(),
                     [&](const ModelNumber& own) { return own.name == number; });
}

std::string Model::listing() const {
  std::string text;
  for (const ModelNumber& number : numbers)
    text += (text.empty() ? "" : ", ") + number.name +
            (number.or_poisson_ratio ? std::string(" or ") + poisson_ratio_name : "");
  return text;
}

const std::vector<Model>& models() {
  static const std::vector<Model> all = models_of(static_cast<const AnyLaw*>(nullptr));
  return all;
}

const Model& model_of(const MaterialParameters& material) {
  return models()[static_cast<std::size_t>(material.model)];
}

}  // namespace stroma::material
