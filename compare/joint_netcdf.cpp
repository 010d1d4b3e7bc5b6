#include "compare/joint_netcdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/figure/pictures.hpp"
#include "compare/netcdf/reader.hpp"
#include "compare/netcdf/writer.hpp"
#include "compare/run_directory.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Ids of all cases together, in the order in which they come first.
std::vector<std::string> solutions_of(const Json& summary) {
  std::vector<std::string> ids;
  for (const auto& one : summary.at("cases")) {
    for (const auto& solution : one.at("solutions")) {
      const auto id = solution.at("id").get<std::string>();
      if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
    }
  }
  return ids;
}

void write_case_attributes(NetCdfWriter& file, const Json& one, int variable) {
  file.attribute("case", one.at("name").get<std::string>(), variable);
  for (const auto& [key, value] : one.at("system").items()) {
    file.attribute(key, value.get<double>(), variable);
  }
  const Json& impulse = one.at("impulse");
  file.attribute("impulse_law", impulse.at("law").get<std::string>(), variable);
  for (const char* key : {"rate", "intensity", "mean"}) {
    file.attribute(std::string("impulse_") + key, impulse.at(key).get<double>(), variable);
  }
}

void write_case(NetCdfWriter& file, const Json& one, const std::vector<std::string>& solutions,
                std::span<const JointDensity> joints, int solution, int bounds) {
  std::vector<const JointDensity*> own;
  for (const auto& joint : joints) {
    if (joint.case_name == one.at("name")) own.push_back(&joint);
  }
  if (own.empty()) return;
  const auto& cells = own.front()->density;
  std::vector<float> values(solutions.size() * cells.averages.size(),
                            std::numeric_limits<float>::quiet_NaN());
  for (const auto* joint : own) {
    const auto place = std::ranges::find(solutions, joint->solution) - solutions.begin();
    std::ranges::transform(joint->density.averages,
                           values.begin() + place * std::ssize(cells.averages),
                           [](double average) { return static_cast<float>(average); });
  }
  const std::string name = picture_stem(one.at("name").get<std::string>());
  const int y = file.cells("y_" + name, "displacement y", bounds, cells.y_edges);
  const int ydot = file.cells("ydot_" + name, "velocity y'", bounds, cells.v_edges);
  const int density = file.compressed("p_" + name, {solution, y, ydot},
                                      "joint probability density of y and y'", values);
  file.attribute("cell_methods", fmt::format("y_{0}: ydot_{0}: mean", name), density);
  write_case_attributes(file, one, density);
}

void read_case(const NetCdfReader& file, const std::string& name,
               const std::vector<std::string>& solutions, std::vector<JointDensity>& joints) {
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
                      solutions[s],
                      {y_edges, v_edges, {averages.begin(), averages.end()}}});
  }
}

}  // namespace

void add_joint_netcdf(PendingFiles& files, const fs::path& path, const Json& summary,
                      std::span<const JointDensity> joints) {
  files.add(path, [&](const fs::path& temporary) {
    try {
      NetCdfWriter file(temporary);
      file.attribute("Conventions", "CF-1.8");
      file.attribute("title",
                     "stationary joint densities of a vibro-impact Duffing oscillator under "
                     "Poisson impulses");
      const Json& program = summary.at("program");
      file.attribute("source", fmt::format("{} {}", program.at("name").get<std::string>(),
                                           program.at("version").get<std::string>()));
      file.attribute("command", program.at("command").get<std::string>());
      const auto solutions = solutions_of(summary);
      const int solution = file.dimension("solution", solutions.size());
      const int bounds = file.dimension("bounds", 2);
      file.labels("solution", solution, solutions);
      for (const auto& one : summary.at("cases")) {
        write_case(file, one, solutions, joints, solution, bounds);
      }
      file.close();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("cannot write {} ({})", path.string(), error.what()));
    }
  });
}

void write_joint_netcdf(const fs::path& path, const Json& summary,
                        std::span<const JointDensity> joints) {
  PendingFiles file;
  add_joint_netcdf(file, path, summary, joints);
  file.commit();
}

std::vector<JointDensity> read_joint_netcdf(const fs::path& path) {
  try {
    const NetCdfReader file(path);
    const auto solutions = file.labels("solution");
    std::vector<JointDensity> joints;
    for (const auto& name : file.variables()) {
      if (name.starts_with("p_")) read_case(file, name, solutions, joints);
    }
    return joints;
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{} is not a whole file of joint densities ({}; run again)",
                                 path.string(), error.what()));
  }
}

}  // namespace fpkcheck::compare
