#include "workflows/sweep/result/sweep_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "base/input_error.hpp"
#include "results/marginals_csv.hpp"
#include "results/netcdf/writer.hpp"
#include "results/run.hpp"
#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {
namespace {

/// A number in the result of a method, which is a column of sweep.csv and a variable of sweep.nc.
struct SweepResultColumn {
  std::string header;    ///< header of the column of sweep.csv
  std::string variable;  ///< name of the variable of sweep.nc
  std::string meaning;   ///< description of the variable of sweep.nc
  /// Function that returns the number from the result of a method; empty if the result has no such
  /// number.
  std::function<std::optional<double>(const SweepMethodResult&)> number;
};

std::vector<SweepResultColumn> moment_columns() {
  std::vector<SweepResultColumn> columns;
  for (const auto& moment : transform::kMoments) {
    columns.push_back({moment.name, moment.name, moment.symbol,
                       [member = moment.moment](const SweepMethodResult& one) {
                         return one.moments ? std::optional((*one.moments).*member) : std::nullopt;
                       }});
  }
  return columns;
}

// @param header, variable names of the column in sweep.csv and sweep.nc, in which "{}" stands for y
//        or ydot
std::vector<SweepResultColumn> marginal_columns(
    const std::string& header, const std::string& variable, const std::string& meaning,
    const std::function<std::optional<MarginalL1Values>(const SweepMethodResult&)>& pair) {
  const auto column = [&](const char* name, const char* symbol, double MarginalL1Values::*member) {
    return SweepResultColumn{
        fmt::format(fmt::runtime(header), name), fmt::format(fmt::runtime(variable), name),
        fmt::format("{} of {}", meaning, symbol), [pair, member](const SweepMethodResult& one) {
          const auto found = pair(one);
          return found ? std::optional((*found).*member) : std::nullopt;
        }};
  };
  return {column("y", "p(y)", &MarginalL1Values::y),
          column("ydot", "p(y')", &MarginalL1Values::ydot)};
}

std::vector<SweepResultColumn> distance_columns() {
  return marginal_columns("l1_{}", "l1_{}", "L1 distance to the reference",
                          [](const SweepMethodResult& one) { return one.l1; });
}

std::vector<SweepResultColumn> error_columns(const SweepResults& results) {
  auto columns = marginal_columns("error_{}", "error_{}", "L1 error estimate",
                                  [](const SweepMethodResult& one) { return one.error; });
  for (const auto& part : results.error_budget_part_names()) {
    // The part name "closure + impact" becomes "closure_and_impact" in sweep.csv and
    // "closure___impact" in sweep.nc.
    std::string header = part, variable = part;
    for (std::size_t at = header.find(" + "); at != header.npos; at = header.find(" + ")) {
      header.replace(at, 3, "_and_");
    }
    std::ranges::replace(header, ' ', '_');
    std::ranges::replace(variable, ' ', '_');
    std::ranges::replace(variable, '+', '_');
    std::ranges::move(
        marginal_columns("budget_{}_" + header, "budget_" + variable + "_{}",
                         fmt::format("contribution of \"{}\" to the L1 distance", part),
                         [part](const SweepMethodResult& one) -> std::optional<MarginalL1Values> {
                           const auto share =
                               std::ranges::find(one.budget, part, &ErrorBudgetContribution::part);
                           if (share == one.budget.end()) return std::nullopt;
                           return share->l1;
                         }),
        std::back_inserter(columns));
  }
  return columns;
}

// Returns the columns of the slopes with respect to each varied key for which a result has slopes.
std::vector<SweepResultColumn> slope_columns(const SweepResults& results) {
  std::vector<SweepResultColumn> columns;
  for (const SweepAxis& axis : results.plan.axes) {
    const bool any = std::ranges::any_of(results.points, [&](const SweepPointResult& point) {
      return std::ranges::any_of(point.methods, [&](const SweepMethodResult& one) {
        return one.find_slopes(axis.key) != nullptr;
      });
    });
    if (!any) continue;
    const auto add = [&](const char* prefix, const char* moment, const std::string& meaning,
                         double MomentSlopes::*member) {
      const std::string column = fmt::format("{}_{}_{}", prefix, moment, axis.key);
      columns.push_back({column, column, meaning + " with respect to " + axis.key,
                         [key = axis.key, member](const SweepMethodResult& one) {
                           const MomentSlopes* slopes = one.find_slopes(key);
                           return slopes != nullptr ? std::optional(slopes->*member) : std::nullopt;
                         }});
    };
    add("slope", "y2", "derivative of E[y^2]", &MomentSlopes::y2);
    add("slope", "v2", "derivative of E[y'^2]", &MomentSlopes::v2);
    add("slope_error", "y2", "error estimate of the derivative of E[y^2]", &MomentSlopes::y2_error);
    add("slope_error", "v2", "error estimate of the derivative of E[y'^2]",
        &MomentSlopes::v2_error);
  }
  return columns;
}

std::string csv_value_cell(const base::Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number)
                           : results::quote_csv_field(std::get<std::string>(value));
}

// The table cells of the dimensionless groups are empty if the parameter values of the point are
// inconsistent.
std::string dimensionless_groups_cells(const SweepPlan& plan, std::size_t point) {
  try {
    const DimensionlessGroups groups = dimensionless_groups(plan.problem_at_sweep_point(point));
    return fmt::format("{:.4g},{:.4g},{:.4g}", groups.impulses_per_decay_time, groups.damping_ratio,
                       groups.cubic_share);
  } catch (const InputError&) {
    return ",,";
  }
}

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

class SweepNetcdfFile {
 public:
  SweepNetcdfFile(results::NetCdfWriter& file, const SweepResults& results)
      : file_(file), results_(results) {
    const SweepPlan& plan = results.plan;
    if (plan.design == SweepPlanDesign::product) {
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

  /// @return id of the variable
  int write_variable(const SweepResultColumn& column, double missing_value = kMissing) {
    const std::size_t methods = results_.plan.methods.size();
    std::vector<double> values(results_.plan.points.size() * methods, missing_value);
    for (const auto& point : results_.points) {
      for (std::size_t m = 0; m < methods; ++m) {
        values[point.point * methods + m] = column.number(point.methods[m]).value_or(missing_value);
      }
    }
    auto dimensions = dimensions_;
    dimensions.push_back(solution_);
    return file_.write_compressed<double>(column.variable, dimensions, column.meaning, values);
  }
  void write_variables(const std::vector<SweepResultColumn>& columns) {
    for (const auto& column : columns) write_variable(column);
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
    file_.write_compressed<double>("reference", dimensions_,
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
  std::vector<int> dimensions_;  // netCDF dimensions of the points
  int solution_ = 0;
};

}  // namespace

const MomentSlopes* SweepMethodResult::find_slopes(const std::string& key) const {
  const auto found = std::ranges::find(slopes, key, &MomentSlopes::key);
  return found == slopes.end() ? nullptr : &*found;
}

SweepResults make_sweep_results(SweepPlan plan, std::vector<SweepPointResult> points) {
  std::ranges::sort(points, {}, &SweepPointResult::point);
  return {std::move(plan), std::move(points)};
}

std::vector<std::string> SweepResults::error_budget_part_names() const {
  std::vector<std::string> names;
  for (const auto& point : points) {
    for (const auto& method : point.methods) {
      for (const auto& share : method.budget) {
        if (std::ranges::find(names, share.part) == names.end()) names.push_back(share.part);
      }
    }
  }
  return names;
}

std::string sweep_csv_text(const SweepResults& results) {
  const SweepPlan& plan = results.plan;
  const auto moments = moment_columns(), distances = distance_columns();
  const auto errors = error_columns(results), slopes = slope_columns(results);
  std::vector<std::string> header;
  const auto add_headers = [&](const std::vector<SweepResultColumn>& columns) {
    for (const auto& column : columns) header.push_back(column.header);
  };
  for (const auto& axis : plan.axes) header.push_back(axis.key);
  header.insert(header.end(), {"solution", "status", "reason"});
  add_headers(moments);
  add_headers(distances);
  header.insert(header.end(), {"reference", "seconds"});
  add_headers(errors);
  header.insert(header.end(), {"impulses_per_decay_time", "damping_ratio", "cubic_share"});
  add_headers(slopes);
  std::string text = fmt::format("{}\n", fmt::join(header, ","));
  for (const auto& point : results.points) {
    std::string keys;
    for (const auto& value : plan.points[point.point]) keys += csv_value_cell(value) + ',';
    const std::string groups = dimensionless_groups_cells(plan, point.point);
    for (std::size_t m = 0; m < point.methods.size(); ++m) {
      const SweepMethodResult& method = point.methods[m];
      std::vector<std::string> cells{plan.methods[m].id(), std::string(name(method.status)),
                                     results::quote_csv_field(method.reason)};
      // Numbers in sweep.csv have ten digits, which exceed the accuracy of every solver and keep
      // the file small.
      const auto add_cells = [&](const std::vector<SweepResultColumn>& columns) {
        for (const auto& column : columns) {
          const auto number = column.number(method);
          cells.push_back(number && std::isfinite(*number) ? fmt::format("{:.10g}", *number) : "");
        }
      };
      add_cells(moments);
      add_cells(distances);
      cells.push_back(point.reference);
      cells.push_back(fmt::format("{:.3g}", method.seconds));
      add_cells(errors);
      cells.push_back(groups);
      add_cells(slopes);
      text += fmt::format("{}{}\n", keys, fmt::join(cells, ","));
    }
  }
  return text;
}

std::string sweep_netcdf_bytes(const SweepResults& results, const std::string& command) {
  results::NetCdfWriter file;
  const auto program = results::current_program(command);
  file.write_attribute("Conventions", "CF-1.8");
  file.write_attribute("title", "solutions over the parameters of an oscillator");
  file.write_attribute("source", fmt::format("{} {}", program.name, program.version));
  file.write_attribute("command", program.command);
  results::write_problem_attributes(file, results.plan.base);

  SweepNetcdfFile sweep(file, results);
  const SweepResultColumn statuses{
      {}, "status", "status of the solution", [](const SweepMethodResult& one) {
        return static_cast<double>(one.status);
      }};
  const int status = sweep.write_variable(statuses, -1);
  std::string values;
  for (const auto& entry : transform::kStatusNames) {
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ", static_cast<int>(entry.value),
                          entry.name);
  }
  file.write_attribute("flags", values + ", -1 not solved", status);
  sweep.write_variables(moment_columns());
  sweep.write_variables(distance_columns());
  sweep.write_variables(error_columns(results));
  sweep.write_variables(slope_columns(results));
  sweep.write_variable(
      {{}, "seconds", "wall-clock time", [](const SweepMethodResult& one) { return one.seconds; }});
  sweep.write_references();
  return file.close_and_take_bytes();
}

}  // namespace fpkcheck::sweep
