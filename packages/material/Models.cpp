// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Models.hpp"

#include <algorithm>

namespace stroma::material {
namespace {

/// A number of one model may be a list of another, and is then a list of one.
double number_of(const MaterialParameters& given, const std::string& name) {
  const auto found = given.numbers.find(name);
  return found != given.numbers.end() ? found->second : given.lists.at(name).front();
}
double number_of(const FiberParameters& given, const std::string& name) {
  return given.numbers.at(name);
}

/// What L::declare() says, as a model of the deck.
template <class Law, class ModelOfLaw>
class Describing {
 public:
  explicit Describing(ModelOfLaw& model) : model_(model) {}

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
  template <int n>
  void directions(double (Law::*)[n][3], int Law::*) {
    model_.takes_directions = true;
  }
  void volumetric_energy(VolumetricEnergy Law::*) { model_.has_volumetric_energy = true; }

 private:
  ModelOfLaw& model_;
};

/// L::declare() with the numbers of a material, or of a family of fibres.
template <class Law, class Given>
class Filling {
 public:
  explicit Filling(const Given& given) : given_(given) {}
  const Law& law() const { return law_; }

  void number(const char* name, double Law::*member, Range, const char*) {
    law_.*member = number_of(given_, name);
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
  template <int n>
  void directions(double (Law::*member)[n][3], int Law::*count) {
    static_assert(n == AnyLaw::most_families, "as many as a deck may have");
    law_.*count = 0;
    for (const auto& family : given_.fibers->families) {
      if (!direction_in(family.second)) continue;  // refused elsewhere
      const auto direction = normalised(*direction_in(family.second));
      std::copy(direction.begin(), direction.end(), (law_.*member)[(law_.*count)++]);
    }
  }
  void volumetric_energy(VolumetricEnergy Law::*member) { law_.*member = given_.volumetric_energy; }

 private:
  const Given& given_;
  Law law_{};
};

template <class Law, class Given>
Law filled(const Given& given) {
  Filling<Law, Given> filling(given);
  Law::declare(filling);
  return filling.law();
}

template <class Law, class ModelOfLaw>
ModelOfLaw described() {
  ModelOfLaw model;
  model.name = Law::name();
  model.meaning = Law::meaning();
  Describing<Law, ModelOfLaw> description(model);
  Law::declare(description);
  return model;
}

template <class Law>
Model model_of() {
  Model model = described<Law, Model>();
  model.is_isochoric = material::is_isochoric<Law>;
  model.law = [](const MaterialParameters& given) -> AnyMatrix { return filled<Law>(given); };
  return model;
}

template <class Law>
FiberModel fiber_model_of() {
  FiberModel model = described<Law, FiberModel>();
  model.law = [](const FiberParameters& given) -> AnyFiberLaw { return filled<Law>(given); };
  return model;
}

template <class... Laws>
std::vector<Model> models_of(const OneOf<Laws...>*) {
  return {model_of<Laws>()...};
}

template <class... Laws>
std::vector<FiberModel> models_of(const TaggedUnion<Laws...>*) {
  return {fiber_model_of<Laws>()...};
}

}  // namespace

bool NamedNumbers::takes_poisson_ratio() const {
  return std::any_of(numbers.begin(), numbers.end(),
                     [](const ModelNumber& number) { return number.or_poisson_ratio; });
}

bool NamedNumbers::takes(const std::string& number) const {
  return (number == poisson_ratio_name && takes_poisson_ratio()) ||
         std::any_of(numbers.begin(), numbers.end(),
                     [&](const ModelNumber& own) { return own.name == number; });
}

std::string NamedNumbers::listing() const {
  std::string text;
  for (const ModelNumber& number : numbers)
    text += (text.empty() ? "" : ", ") + number.name +
            (number.or_poisson_ratio ? std::string(" or ") + poisson_ratio_name : "");
  return text;
}

const std::vector<Model>& models() {
  static const std::vector<Model> all = models_of(static_cast<const AnyMatrix*>(nullptr));
  return all;
}

const std::vector<FiberModel>& fiber_models() {
  static const std::vector<FiberModel> all = models_of(static_cast<const AnyFiberLaw*>(nullptr));
  return all;
}

const Model& model_of(const MaterialParameters& material) {
  return models()[static_cast<std::size_t>(material.model)];
}

}  // namespace stroma::material
