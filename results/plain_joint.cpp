#include "results/plain_joint.hpp"

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
  const auto axes = file.dimensions(variable);
  return axes.size() == 2 && std::ranges::all_of(axes, [&](const std::string& axis) {
           return std::ranges::find(names, axis) != names.end() &&
                  file.dimensions(axis) == std::vector{axis};
         });
}

}  // namespace

PlainJoint read_plain_joint(std::string bytes, const std::string& where) {
  try {
    NetCdfReader file(std::move(bytes));
    const auto names = file.variables();
    PlainJoint found;
    for (const auto& name : names) {
      if (!has_coordinates(file, names, name)) continue;
      if (!found.name.empty()) {
        throw std::runtime_error(
            fmt::format("{} and {} both have two coordinates", found.name, name));
      }
      found.name = name;
    }
    if (found.name.empty()) throw std::runtime_error("no variable has two coordinates");
    const auto axes = file.dimensions(found.name);
    found.first_name = axes[0];
    found.second_name = axes[1];
    found.first = file.values(axes[0]);
    found.second = file.values(axes[1]);
    found.values = file.values(found.name);
    if (found.values.size() != found.first.size() * found.second.size()) {
      throw std::runtime_error(
          fmt::format("{}: the shape differs from that of the axes", found.name));
    }
    return found;
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format(
        "{}: {} (must be netCDF-4 with p(y, v) and its coordinates y and v, or a joint.nc)", where,
        base::sanitise(error.what())));
  }
}

}  // namespace fpkcheck::results
