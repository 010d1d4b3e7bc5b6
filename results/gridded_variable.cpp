#include "results/gridded_variable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "results/netcdf/reader.hpp"

namespace fpkcheck::results {
namespace {

bool has_coordinates(const NetCdfReader& file, const std::vector<std::string>& names,
                     const std::string& variable) {
  const auto axes = file.dimension_names(variable);
  return axes.size() == 2 && std::ranges::all_of(axes, [&](const std::string& axis) {
           return std::ranges::find(names, axis) != names.end() &&
                  file.dimension_names(axis) == std::vector{axis};
         });
}

}  // namespace

GriddedVariable read_gridded_variable(std::string bytes, const std::string& where) {
  try {
    NetCdfReader file(std::move(bytes));
    const auto names = file.variable_names();
    GriddedVariable variable;
    for (const auto& name : names) {
      if (!has_coordinates(file, names, name)) continue;
      if (!variable.name.empty()) {
        throw std::runtime_error(
            fmt::format("{} and {} both have two coordinates", variable.name, name));
      }
      variable.name = name;
    }
    if (variable.name.empty()) throw std::runtime_error("no variable has two coordinates");
    const auto axes = file.dimension_names(variable.name);
    variable.first_name = axes[0];
    variable.second_name = axes[1];
    variable.first = file.read_values(axes[0]);
    variable.second = file.read_values(axes[1]);
    variable.values = file.read_values(variable.name);
    if (variable.values.size() != variable.first.size() * variable.second.size()) {
      throw std::runtime_error(
          fmt::format("{}: the shape differs from that of the axes", variable.name));
    }
    return variable;
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format(
        "{}: {} (must be netCDF-4 with p(y, v) and its coordinates y and v, or a joint.nc)", where,
        base::sanitise(error.what())));
  }
}

}  // namespace fpkcheck::results
