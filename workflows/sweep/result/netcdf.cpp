#include <fmt/format.h>
#include <algorithm>

#include <functional>
#include <limits>
#include <optional>

#include "results/netcdf/problem_attributes.hpp"
#include "results/netcdf/writer.hpp"
#include "results/run.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// A writer of a netCDF file that has the dimensions of a plan.
class SweepNetcdfFile {
 public:
  SweepNetcdfFile(results::NetCdfWriter& file, const SweepResults& results)
      : file_(file), results_(results) {
    const Plan& plan = results.plan;
    if (plan.design == PlanDesign::product) {
      for (const auto& axis : plan.axes) {
        dimensions_.push_back(file_.define_dimension(axis.key, axis.values.size()));
        coordinate(axis.key, dimensions_.back(), axis.values);
      }
    } else {
      dimensions_.push_back(file_.define_dimension("point", plan.points.size()));
      for (std::size_t a = 0; a < plan.axes.size(); ++a) {
        std::vector<base::Value> values;
        for (const auto& point : plan.points) values.push_back(point[a]);
        coordinate(plan.axes[a].key, dimensions_.back(), values);
      }
    }
    std::vector<std::string> ids;
    for (const auto& method : plan.methods) ids.push_back(method.id());
    solution_ = file_.define_dimension("solution", ids.size());
    file_.write_labels("solution", solution_, ids);
  }

  /// @param number function that returns the value for a method's result; empty if the result has
  ///               no such value
  /// @return the variable's id
  int write_variable(const std::string& name, const std::string& meaning,
                     const std::function<std::optional<double>(const MethodResult&)>& number,
                     double missing_value = kMissing) {
    const std::size_t methods = results_.plan.methods.size();
    std::vector<double> values(results_.plan.points.size() * methods, missing_value);
    for (const auto& point : results_.points) {
      for (std::size_t m = 0; m < methods; ++m) {
        values[point.point * methods + m] = number(point.methods[m]).value_or(missing_value);
      }
    }
    auto dimensions = dimensions_;
    dimensions.push_back(solution_);
    return file_.write_compressed_doubles(name, dimensions, meaning, values);
  }

  void write_references() {
    std::vector<double> values(results_.plan.points.size(), -1);
    for (const auto& point : results_.points) {
      const auto& methods = results_.plan.methods;
      const auto found = std::ranges::find_if(
          methods, [&](const methods::Method& method) { return method.id() == point.reference; });
      if (found != methods.end()) {
        values[point.point] = static_cast<double>(found - methods.begin());
      }
    }
    file_.write_compressed_doubles("reference", dimensions_,
                                   "index of the reference solution, or -1", values);
  }

 private:
  void coordinate(const std::string& key, int dimension, const std::vector<base::Value>& values) {
    if (std::holds_alternative<std::string>(values.front())) {
      std::vector<std::string> words;
      for (const auto& value : values) words.push_back(std::get<std::string>(value));
      file_.write_labels(key, dimension, words);
      return;
    }
    std::vector<double> numbers;
    for (const auto& value : values) numbers.push_back(std::get<double>(value));
    file_.write_variable(key, {dimension}, key, numbers);
  }

  results::NetCdfWriter& file_;
  const SweepResults& results_;
  std::vector<int> dimensions_;  // dimensions of the points
  int solution_ = 0;
};

}  // namespace

std::string netcdf(const SweepResults& results, const std::string& command) {
  results::NetCdfWriter file;
  const auto program = results::this_program(command);
  file.write_attribute("Conventions", "CF-1.8");
  file.write_attribute("title", "solutions over the parameters of an oscillator");
  file.write_attribute("source", fmt::format("{} {}", program.name, program.version));
  file.write_attribute("command", program.command);
  file.write_attribute("case", results.plan.base.name);
  results::write_problem_attributes(file, results.plan.base);

  SweepNetcdfFile sweep(file, results);
  const int status = sweep.write_variable(
      "status", "status of the solution",
      [](const MethodResult& one) { return static_cast<double>(one.status); }, -1);
  std::vector<std::string> meanings;
  std::string values;
  for (const auto& entry : transform::kStatusNames) {
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ", static_cast<int>(entry.value),
                          entry.name);
  }
  file.write_attribute("flags", values + ", -1 not solved", status);
  for (const auto& moment : transform::kMoments) {
    sweep.write_variable(moment.name, moment.symbol, [&](const MethodResult& one) {
      return one.moments ? std::optional((*one.moments).*moment.moment) : std::nullopt;
    });
  }
  using Pair = std::optional<MarginalL1Pair>;
  const auto write_pair = [&](const std::string& name, const std::string& meaning,
                              const std::function<Pair(const MethodResult&)>& pair) {
    for (const auto& [suffix, symbol, member] :
         {std::tuple{"_y", "p(y)", &MarginalL1Pair::y},
          std::tuple{"_ydot", "p(y')", &MarginalL1Pair::ydot}}) {
      sweep.write_variable(
          name + suffix, fmt::format("{} of {}", meaning, symbol),
          [&pair, of = member](const MethodResult& one) {  // Clang 14 cannot capture bindings
            const Pair found = pair(one);
            return found ? std::optional((*found).*of) : std::nullopt;
          });
    }
  };
  write_pair("l1", "L1 distance to the reference", [](const MethodResult& one) { return one.l1; });
  write_pair("error", "L1 error estimate", [](const MethodResult& one) { return one.error; });
  for (const auto& part : results.budget_parts()) {
    std::string name = "budget_" + part;
    std::ranges::replace(name, ' ', '_');
    std::ranges::replace(name, '+', '_');
    write_pair(name, fmt::format("contribution of \"{}\" to the L1 distance", part),
               [&](const MethodResult& one) -> Pair {
                 const auto share = std::ranges::find(one.budget, part, &BudgetContribution::part);
                 return share == one.budget.end() ? Pair() : Pair(share->l1);
               });
  }
  sweep.write_variable("seconds", "wall-clock time",
                       [](const MethodResult& one) { return one.seconds; });
  sweep.write_references();
  return file.close_and_take_bytes();
}

}  // namespace fpkcheck::sweep
