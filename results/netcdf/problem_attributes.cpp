#include "results/netcdf/problem_attributes.hpp"

#include <string>
#include <variant>

namespace fpkcheck::results {

void write_problem_attributes(NetCdfWriter& file, const problem::Problem& problem, int variable) {
  for (const auto& parameter : problem::displayed_parameters(problem)) {
    const std::string name =
        parameter.section == "system" ? parameter.name : parameter.section + '_' + parameter.name;
    if (const auto* word = std::get_if<std::string>(&parameter.value)) {
      file.write_attribute(name, *word, variable);
    } else if (const auto* number = std::get_if<double>(&parameter.value)) {
      file.write_attribute(name, *number, variable);
    }
  }
}

}  // namespace fpkcheck::results
