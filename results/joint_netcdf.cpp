#include "results/joint_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "results/netcdf/reader.hpp"
#include "results/netcdf/writer.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

// Largest accepted netCDF file in bytes; the joint densities of hundreds of cases need less.
constexpr std::size_t kMaxBytes = std::size_t{256} << 20;

const std::string kSourcePrefix = "source_";

std::vector<std::string> solution_ids(const Run& run) {
  std::vector<std::string> ids;
  for (const auto& case_result : run.cases) {
    for (const auto& solution : case_result.solutions) {
      if (std::ranges::find(ids, solution.id()) == ids.end()) ids.push_back(solution.id());
    }
  }
  return ids;
}

/// Values of a netCDF variable, shape (solution, cells), with NaN for solutions without values.
class NetCdfSolutionVariable {
 public:
  NetCdfSolutionVariable(const std::vector<std::string>& solutions, std::size_t cells)
      : solutions_(solutions),
        cells_(cells),
        values_(solutions.size() * cells, std::numeric_limits<float>::quiet_NaN()) {}

  void set_solution_values(const std::string& solution, const std::vector<double>& averages) {
    const auto place = std::ranges::find(solutions_, solution) - solutions_.begin();
    std::ranges::transform(averages, values_.begin() + place * static_cast<std::ptrdiff_t>(cells_),
                           [](double average) { return static_cast<float>(average); });
  }
  const std::vector<float>& values() const { return values_; }

 private:
  const std::vector<std::string>& solutions_;
  std::size_t cells_;
  std::vector<float> values_;
};

// Returns the probabilities of rest in contact as text: "mcs: 0.0303 at y = -0.5, 0.0301 at y =
// 0.5". The text on the probabilities of rest is empty if all probabilities of rest are zero.
std::string atoms_text(const CaseResult& case_result) {
  std::vector<std::string> solutions;
  for (const auto& solution : case_result.solutions) {
    std::vector<std::string> atoms;
    for (const auto& atom : solution.atoms) {
      atoms.push_back(fmt::format("{:.6g} at y = {:g}", atom.probability, atom.y));
    }
    if (atoms.empty()) continue;
    solutions.push_back(fmt::format("{}: {}", solution.id(), fmt::join(atoms, ", ")));
  }
  return fmt::format("{}", fmt::join(solutions, "; "));
}

void write_joint_densities_of_case(NetCdfWriter& file, const CaseResult& case_result,
                                   const std::vector<std::string>& solutions, int solution,
                                   int bounds) {
  if (case_result.joints.empty()) return;
  const auto& cells = case_result.joints.front().density;
  const std::string name = case_file_stem(case_result.name());
  const int y = file.write_cell_coordinate("y_" + name, "displacement y", bounds, cells.y_edges);
  const int ydot = file.write_cell_coordinate("ydot_" + name, "velocity y'", bounds, cells.v_edges);
  const auto write = [&](const std::string& prefix, const std::string& meaning,
                         const NetCdfSolutionVariable& over) {
    const int variable = file.write_compressed<float>(prefix + '_' + name, {solution, y, ydot},
                                                      meaning, over.values());
    file.write_attribute("cell_methods", fmt::format("y_{0}: ydot_{0}: mean", name), variable);
    write_problem_attributes(file, case_result.problem, variable);
    return variable;
  };
  NetCdfSolutionVariable densities(solutions, cells.averages.size());
  for (const auto& [id, density] : case_result.joints)
    densities.set_solution_values(id, density.averages);
  const int p = write("p", "joint probability density of y and y'", densities);
  if (const std::string atoms = atoms_text(case_result); !atoms.empty()) {
    file.write_attribute("rest_in_contact", atoms, p);
  }
  for (const auto& moment : transform::kMoments) {
    NetCdfSolutionVariable sources(solutions, cells.averages.size());
    bool any = false;
    for (const auto& [id, of, density] : case_result.error_sources) {
      if (of != moment.name) continue;
      sources.set_solution_values(id, density.averages);
      any = true;
    }
    if (!any) continue;
    write(kSourcePrefix + moment.name,
          fmt::format("contributions to the error of {}, per area", moment.symbol), sources);
  }
}

/// Calls use(case, solution, density) for each solution with values in a netCDF variable.
template <class Use>
void for_each_stored_density(NetCdfReader& file, const std::string& name,
                             const std::vector<std::string>& solutions, Use use) {
  const auto axes = file.dimension_names(name);
  if (axes.size() != 3) throw std::runtime_error(fmt::format("{}: not three dimensions", name));
  const auto shape = file.dimension_lengths(name);
  const auto y_edges = file.read_cell_edges(axes[1]), v_edges = file.read_cell_edges(axes[2]);
  if (shape[0] != solutions.size() || shape[1] + 1 != y_edges.size() ||
      shape[2] + 1 != v_edges.size()) {
    throw std::runtime_error(fmt::format("{}: the shape differs from that of the axes", name));
  }
  const auto values = file.read_values(name);
  const std::size_t count = shape[1] * shape[2];
  for (std::size_t s = 0; s < solutions.size(); ++s) {
    const std::span<const double> averages(values.data() + s * count, count);
    if (std::ranges::all_of(averages, [](double p) { return std::isnan(p); })) continue;
    use(file.read_text_attribute(name, "case"), solutions[s],
        transform::GridDensity{y_edges, v_edges, {averages.begin(), averages.end()}});
  }
}

bool has_coordinates(const NetCdfReader& file, const std::vector<std::string>& names,
                     const std::string& variable) {
  const auto axes = file.dimension_names(variable);
  return axes.size() == 2 && std::ranges::all_of(axes, [&](const std::string& axis) {
           return std::ranges::find(names, axis) != names.end() &&
                  file.dimension_names(axis) == std::vector{axis};
         });
}

std::vector<double> every_second_edge(const std::vector<double>& edges) {
  std::vector<double> result;
  for (std::size_t k = 0; k < edges.size(); k += 2) result.push_back(edges[k]);
  if (edges.size() % 2 == 0) result.push_back(edges.back());
  return result;
}

}  // namespace

std::string joint_netcdf_bytes(const Run& run) {
  NetCdfWriter file;
  file.write_attribute("Conventions", "CF-1.8");
  file.write_attribute("title",
                       "stationary joint densities of oscillators under random impulses or noise");
  file.write_attribute("source", fmt::format("{} {}", run.program.name, run.program.version));
  file.write_attribute("command", run.program.command);
  const auto solutions = solution_ids(run);
  const int solution = file.define_dimension("solution", solutions.size());
  const int bounds = file.define_dimension("bounds", 2);
  file.write_labels("solution", solution, solutions);
  for (const auto& case_result : run.cases)
    write_joint_densities_of_case(file, case_result, solutions, solution, bounds);
  return file.close_and_take_bytes();
}

bool is_joint_netcdf(const std::string& bytes) {
  try {
    const auto names = NetCdfReader(bytes).variable_names();
    return std::ranges::find(names, "solution") != names.end();
  } catch (const std::runtime_error&) {
    return false;
  }
}

JointDensityFileContent read_joint_netcdf(
    const fs::path& path, const std::function<void(std::string_view bytes)>& inspect) {
  try {
    auto bytes = base::read_input_file(path, kMaxBytes);
    if (!bytes) throw std::runtime_error("no readable file");
    if (inspect) inspect(*bytes);
    NetCdfReader file(*std::move(bytes));
    const auto solutions = file.read_labels("solution");
    JointDensityFileContent found;
    const auto names = file.variable_names();
    for (const auto& name : names) {
      if (!name.starts_with("p_")) continue;
      for_each_stored_density(file, name, solutions,
                              [&](auto&& case_result, auto& id, auto&& density) {
                                found.joints.push_back({case_result, {id, std::move(density)}});
                              });
    }
    for (const auto& moment : transform::kMoments) {
      for (const auto& name : names) {
        if (!name.starts_with(kSourcePrefix + moment.name + '_')) continue;
        for_each_stored_density(
            file, name, solutions, [&](auto&& case_result, auto& id, auto&& density) {
              found.sources.push_back({case_result, {id, moment.name, std::move(density)}});
            });
      }
    }
    return found;
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{} is not a complete file of joint densities: {}; run again",
                                 base::to_printable_text(path.string()),
                                 base::to_printable_text(error.what())));
  }
}

NetCdfJointDensityVariable read_external_joint_density_variable(std::string bytes,
                                                                const std::string& file_name) {
  try {
    NetCdfReader file(std::move(bytes));
    const auto names = file.variable_names();
    NetCdfJointDensityVariable variable;
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
        "{}: {} (must be netCDF-4 with p(y, v) and its coordinates y and v, or a joint.nc)",
        file_name, base::to_printable_text(error.what())));
  }
}

std::vector<JointDensity> joint_densities_on_comparison_cells(
    const compare::ComparisonBins& axes, std::span<const transform::Solution> solutions) {
  std::vector<JointDensity> joints;
  const auto even = compare::undivided_comparison_bins(axes);
  const auto y_edges = every_second_edge(even.y_edges);
  for (const auto& solution : solutions) {
    if (!solution.density) continue;
    auto density = std::visit(
        [&](const auto& form) {
          return transform::average_over_cells(form, y_edges, even.v_edges);
        },
        *solution.density);
    for (double& average : density.averages) average = static_cast<float>(average);
    joints.push_back({solution.id(), std::move(density)});
  }
  return joints;
}

}  // namespace fpkcheck::results
