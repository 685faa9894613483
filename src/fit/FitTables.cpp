// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitTables.hpp"

#include <algorithm>

#include "stroma/base/Log.hpp"
#include "stroma/output/files/HistoryTable.hpp"

namespace stroma {
namespace {

using base::format;
using output::csv_field;
using output::csv_number;

/// "520.8 to 530.2", or what stands for it.
std::string interval(const NumberEstimate& one) {
  if (!one.standard_deviation) return "not determined";
  return format("%.6g to %.6g", one.low, one.high);
}

}  // namespace

std::string runs_table(const FitPlan& plan, const std::vector<FitRun>& runs) {
  std::string table = "run,folder,status";
  for (const auto& named : plan.parameters.parameters.all) table += "," + csv_field(named.first);
  table += ",chi2\n";
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const FitRun& run = runs[n];
    const bool is_done = run.failure.empty();
    table += std::to_string(n + 1) + "," + csv_field(run.folder) + (is_done ? ",done" : ",failed");
    for (const double value : run.values) table += "," + csv_number(value);
    table += "," + (is_done ? csv_number(run.chi2) : "") + "\n";
  }
  return table;
}

std::string estimates_table(const FitPlan& plan, const std::vector<FittedNumber>& numbers,
                            const Estimate& estimate) {
  std::string table = "parameter,path,value,standard_deviation,low,high";
  for (const FittedNumber& number : numbers)
    table += "," + csv_field("correlation with " + number.name);
  table += "\n";
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const NumberEstimate& one = estimate.numbers[j];
    table += csv_field(numbers[j].name) + "," +
             csv_field(plan.parameters.parameters.all[j].second.path) + "," +
             csv_number(numbers[j].value);
    table += one.standard_deviation ? "," + csv_number(*one.standard_deviation) + "," +
                                          csv_number(one.low) + "," + csv_number(one.high)
                                    : ",,,";
    for (const auto& correlation : one.correlation)
      table += "," + (correlation ? csv_number(*correlation) : "");
    table += "\n";
  }
  return table;
}

std::string fitted_table(const FitPlan& plan, const FitRun& first, const FitRun& best) {
  std::string table = "measurement,load,strain_or_time,measured,error,fitted,start,against\n";
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const FitPoint& point = plan.points[i];
    const auto& [name, measurement] = plan.parameters.measurements.all[point.measurement];
    const auto row = static_cast<Eigen::Index>(i);
    table += csv_field(name) + "," + csv_number(point.load) + "," +
             csv_number(point.measured.abscissa) + "," + csv_number(point.measured.force) + "," +
             csv_number(point.measured.error) + "," + csv_number(best.forces[row]) + "," +
             csv_number(first.forces[row]) + "," +
             (measurement.against == Against::strain ? "strain" : "time") + "\n";
  }
  return table;
}

std::vector<std::string> fit_summary(const FitPlan& plan, const std::vector<FittedNumber>& numbers,
                                     const Estimate& estimate, const FitRun& best) {
  std::size_t width = 9;
  for (const FittedNumber& number : numbers) width = std::max(width, number.name.size());
  const int w = static_cast<int>(width);
  std::vector<std::string> lines{
      format("%-*s  %14s  %12s  %s", w, "parameter", "value", "std. dev.", "95 % interval")};
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const NumberEstimate& one = estimate.numbers[j];
    const std::string deviation =
        one.standard_deviation ? format("%.4g", *one.standard_deviation) : "-";
    lines.push_back(format("%-*s  %14.8g  %12s  %s", w, numbers[j].name.c_str(), numbers[j].value,
                           deviation.c_str(), interval(one).c_str()));
  }
  lines.push_back(format("chi^2 %.6g of %zu forces", best.chi2, plan.points.size()));
  if (!estimate.singular_values.empty()) {
    std::string values = "singular values of the relative sensitivity:";
    for (const double value : estimate.singular_values) values += format(" %.4g", value);
    lines.push_back(values);
  }
  for (const std::string& statement : estimate.statements) lines.push_back("note: " + statement);
  return lines;
}

}  // namespace stroma
