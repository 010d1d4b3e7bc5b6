#include "results/joint_netcdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "parameters/input_error.hpp"
#include "results/netcdf/problem_attributes.hpp"
#include "results/netcdf/reader.hpp"
#include "results/netcdf/writer.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

// Ids of all cases together, in the order in which they come first.
std::vector<std::string> solutions_of(const Run& run) {
  std::vector<std::string> ids;
  for (const auto& one : run.cases) {
    for (const auto& solution : one.solutions) {
      if (std::ranges::find(ids, solution.id()) == ids.end()) ids.push_back(solution.id());
    }
  }
  return ids;
}

void write_problem(NetCdfWriter& file, const problem::Problem& problem, int variable) {
  file.attribute("case", problem.name, variable);
  write_parameters(file, problem, variable);
}

void write_case(NetCdfWriter& file, const Case& one, const std::vector<std::string>& solutions,
                int solution, int bounds) {
  if (one.joints.empty()) return;
  const auto& cells = one.joints.front().density;
  std::vector<float> values(solutions.size() * cells.averages.size(),
                            std::numeric_limits<float>::quiet_NaN());
  for (const auto& joint : one.joints) {
    const auto place = std::ranges::find(solutions, joint.solution) - solutions.begin();
    std::ranges::transform(joint.density.averages,
                           values.begin() + place * std::ssize(cells.averages),
                           [](double average) { return static_cast<float>(average); });
  }
  const std::string name = file_stem(one.name());
  const int y = file.cells("y_" + name, "displacement y", bounds, cells.y_edges);
  const int ydot = file.cells("ydot_" + name, "velocity y'", bounds, cells.v_edges);
  const int density = file.compressed("p_" + name, {solution, y, ydot},
                                      "joint probability density of y and y'", values);
  file.attribute("cell_methods", fmt::format("y_{0}: ydot_{0}: mean", name), density);
  write_problem(file, one.problem, density);
}

void read_case(const NetCdfReader& file, const std::string& name,
               const std::vector<std::string>& solutions, std::vector<JointOfCase>& joints) {
  const auto axes = file.dimensions(name);
  if (axes.size() != 3) throw std::runtime_error(fmt::format("{}: not over three axes", name));
  const auto shape = file.shape(name);
  const auto y_edges = file.edges(axes[1]), v_edges = file.edges(axes[2]);
  if (shape[0] != solutions.size() || shape[1] + 1 != y_edges.size() ||
      shape[2] + 1 != v_edges.size()) {
    throw std::runtime_error(fmt::format("{}: its shape is not that of its axes", name));
  }
  const auto values = file.values(name);
  const std::size_t count = shape[1] * shape[2];
  for (std::size_t s = 0; s < solutions.size(); ++s) {
    const std::span<const double> averages(values.data() + s * count, count);
    if (std::ranges::all_of(averages, [](double p) { return std::isnan(p); })) continue;
    joints.push_back({file.text(name, "case"),
                      {solutions[s], {y_edges, v_edges, {averages.begin(), averages.end()}}}});
  }
}

}  // namespace

void add_joint_netcdf(PendingFiles& files, const fs::path& path, const Run& run) {
  files.add(path, [&](const fs::path& temporary) {
    try {
      NetCdfWriter file(temporary);
      file.attribute("Conventions", "CF-1.8");
      file.attribute("title",
                     "stationary joint densities of a vibro-impact Duffing oscillator under "
                     "Poisson impulses");
      file.attribute("source", fmt::format("{} {}", run.program.name, run.program.version));
      file.attribute("command", run.program.command);
      const auto solutions = solutions_of(run);
      const int solution = file.dimension("solution", solutions.size());
      const int bounds = file.dimension("bounds", 2);
      file.labels("solution", solution, solutions);
      for (const auto& one : run.cases) write_case(file, one, solutions, solution, bounds);
      file.close();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("cannot write {} ({})", path.string(), error.what()));
    }
  });
}

std::vector<JointOfCase> read_joint_netcdf(const fs::path& path) {
  try {
    const NetCdfReader file(path);
    const auto solutions = file.labels("solution");
    std::vector<JointOfCase> joints;
    for (const auto& name : file.variables()) {
      if (name.starts_with("p_")) read_case(file, name, solutions, joints);
    }
    return joints;
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{} is not a whole file of joint densities ({}; run again)",
                                 path.string(), error.what()));
  }
}

}  // namespace fpkcheck::results
