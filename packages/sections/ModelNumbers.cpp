// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/ModelNumbers.hpp"

#include <algorithm>
#include <cstddef>

#include "stroma/base/Log.hpp"

namespace stroma::sections {

using namespace material;

std::vector<SharedNumber> shared_numbers(const std::vector<const NamedNumbers*>& models) {
  std::vector<SharedNumber> all;
  for (const NamedNumbers* model : models)
    for (const ModelNumber& number : model->numbers) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const SharedNumber& other) {
        return other.name == number.name;
      });
      if (same == all.end()) {
        all.push_back(
            {number.name, model->name, number.meaning, number.admissible, number.longest > 0});
        continue;
      }
      same->models += ", " + model->name;
      if (same->meaning.find(number.meaning) == std::string::npos)
        same->meaning += " " + model->name + ": " + number.meaning;
      if (!(same->admissible == number.admissible)) same->admissible = Range::any();
    }
  return all;
}

deck::Admissible admissible(const Range& range) {
  if (!range.has_zero) return deck::number_that("other than 0", [](double x) { return x != 0.0; });
  if (range.upper < Range::infinity)
    return range.is_closed ? deck::between(range.lower, range.upper)
                           : deck::strictly_between(range.lower, range.upper);
  if (range.lower > -Range::infinity)
    return range.is_closed ? deck::at_least(range.lower) : deck::greater_than(range.lower);
  return deck::any();
}

std::vector<std::pair<std::string, int>> choices_among(
    const std::vector<const NamedNumbers*>& models) {
  std::vector<std::pair<std::string, int>> names;
  for (const NamedNumbers* model : models)
    names.emplace_back(model->name, static_cast<int>(names.size()));
  return names;
}

std::string meanings_of(const std::vector<const NamedNumbers*>& models) {
  std::string meaning;
  for (const NamedNumbers* model : models)
    meaning += (meaning.empty() ? "" : ". ") + model->name + ": " + model->meaning;
  return meaning;
}

namespace {

/// The numbers given for a model, and where mistakes in them go.
class Check {
 public:
  Check(const NamedNumbers& model, const std::string& kind,
        const std::map<std::string, double>& numbers,
        const std::map<std::string, std::vector<double>>& lists, deck::Findings& findings)
      : model_(model), kind_(kind), numbers_(numbers), lists_(lists), findings_(findings) {}

  template <class Given>
  void refuse_foreign(const Given& given) const {
    for (const auto& [name, value] : given)
      if (!model_.takes(name))
        findings_.add(name, "is no parameter of " + kind_ + " = " + model_.name +
                                "; admissible: " + model_.listing());
  }

  /// \return whether the number is there
  bool number(const ModelNumber& number) const {
    const bool has_ratio = number.or_poisson_ratio && numbers_.count(poisson_ratio_name) > 0;
    const std::vector<double> given = values_of(number.name);
    if (given.size() > 1)
      findings_.add(number.name, base::format("found %zu numbers; admissible: one", given.size()));
    if (given.empty()) {
      if (has_ratio) return true;
      if (number.or_poisson_ratio)
        findings_.add(poisson_ratio_name, "missing; give it, or \"" + number.name + "\"");
      else
        add_missing(number);
      return false;
    }
    if (has_ratio)
      findings_.add(number.name, std::string("given beside \"") + poisson_ratio_name +
                                     "\"; give one of the two");
    check_range(number, given.front());
    return true;
  }

  /// A list, as long as the model's others. \return whether it is there
  bool list(const ModelNumber& number) {
    const auto given = lists_.find(number.name);
    if (given == lists_.end()) {
      add_missing(number);
      return false;
    }
    const std::vector<double>& list = given->second;
    for (const double value : list) check_range(number, value);
    if (list.empty() || list.size() > static_cast<std::size_t>(number.longest)) {
      findings_.add(number.name, base::format("found %zu numbers; admissible: 1 to %d of them",
                                              list.size(), number.longest));
      return false;
    }
    if (first_list_ == nullptr) first_list_ = &list;
    if (first_list_->size() == list.size()) return true;
    findings_.add(
        number.name,
        base::format("found %zu numbers; admissible: as many as the model's other list, %zu",
                     list.size(), first_list_->size()));
    return false;
  }

 private:
  /// A number of one model may be a list of another, and is then a list of one.
  std::vector<double> values_of(const std::string& name) const {
    const auto number = numbers_.find(name);
    if (number != numbers_.end()) return {number->second};
    const auto list = lists_.find(name);
    return list != lists_.end() ? list->second : std::vector<double>();
  }
  void add_missing(const ModelNumber& number) const {
    findings_.add(number.name,
                  "missing; " + kind_ + " = " + model_.name + " takes " + model_.listing());
  }
  void check_range(const ModelNumber& number, double value) const {
    const deck::Admissible rule = admissible(number.admissible);
    if (!rule.allows(value))
      findings_.add(number.name, base::format("found %g; admissible: ", value) +
                                     rule.describe(deck::detail::value_type<double>()));
  }

  const NamedNumbers& model_;
  const std::string& kind_;
  const std::map<std::string, double>& numbers_;
  const std::map<std::string, std::vector<double>>& lists_;
  deck::Findings& findings_;
  const std::vector<double>* first_list_ = nullptr;
};

}  // namespace

bool check_numbers(const NamedNumbers& model, const std::string& kind,
                   const std::map<std::string, double>& numbers,
                   const std::map<std::string, std::vector<double>>& lists,
                   deck::Findings& findings) {
  Check check(model, kind, numbers, lists, findings);
  check.refuse_foreign(numbers);
  check.refuse_foreign(lists);
  bool is_complete = true;
  for (const ModelNumber& number : model.numbers) {
    const bool is_there = number.longest > 0 ? check.list(number) : check.number(number);
    is_complete = is_complete && is_there;
  }
  return is_complete;
}

}  // namespace stroma::sections
