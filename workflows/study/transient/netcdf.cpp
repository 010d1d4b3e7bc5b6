#include "workflows/study/transient/report.hpp"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "base/files/pending_files.hpp"
#include "results/netcdf/problem_attributes.hpp"
#include "results/netcdf/writer.hpp"
#include "results/run.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::study {
namespace {

namespace fs = std::filesystem;
using fd_fpk::Snapshot;

template <class Of>
std::vector<double> values_over_time(const TransientRun& run, Of of) {
  std::vector<double> values;
  for (const Snapshot& s : run.result.snapshots) values.push_back(std::invoke(of, s));
  return values;
}

// The values of a marginal density p(time, x), row by row.
std::vector<double> rows(const TransientRun& run, std::vector<double> Snapshot::*marginal) {
  std::vector<double> values;
  for (const Snapshot& s : run.result.snapshots) {
    values.insert(values.end(), (s.*marginal).begin(), (s.*marginal).end());
  }
  return values;
}

/// Writes the cell centres of a coordinate, the cell edges, and the marginal density over this
/// coordinate.
void write_marginal(results::NetCdfWriter& file, const TransientRun& run, const std::string& name,
                    const std::string& meaning, int time, int bounds,
                    const std::vector<double>& edges, std::vector<double> Snapshot::*marginal) {
  const int dimension = file.write_cell_coordinate(name, meaning, bounds, edges);
  const int density = file.write_variable("p_" + name, {time, dimension},
                                          fmt::format("probability density of the {}", meaning),
                                          rows(run, marginal));
  file.write_attribute("cell_methods", name + ": mean", density);
}

void write_series(results::NetCdfWriter& file, const TransientRun& run, int time) {
  const auto series = [&](const char* name, const std::string& long_name, auto of) {
    file.write_variable(name, {time}, long_name, values_over_time(run, of));
  };
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    series(name, symbol, [of = moment](const Snapshot& s) { return s.moments.*of; });
  }
  series("yv", "E[y y']", &Snapshot::yv);
  series("energy", "mean energy E[y'^2]/2 + E[U(y)], U the potential of the spring",
         &Snapshot::energy);
  series("power", "power of the excitation less that lost by damping and impacts",
         &Snapshot::power);
  series("power_residual",
         "power less the rate of the mean energy, relative to D + lambda E[Y^2]/2",
         &Snapshot::power_residual);
  series("impact_rate", "impacts per unit time", &Snapshot::impact_rate);
  series("mass", "integral of the density", &Snapshot::mass);
  series("min_density", "smallest value of the joint density relative to its largest",
         &Snapshot::min_density);
}

void write_attributes(results::NetCdfWriter& file, const TransientRun& run) {
  file.write_attribute("Conventions", "CF-1.8");
  file.write_attribute("title", "marginal densities over time of a randomly excited oscillator");
  const auto program = results::this_program(run.command);
  file.write_attribute("source", fmt::format("{} {}", program.name, program.version));
  file.write_attribute("command", program.command);
  file.write_attribute("case", run.problem.name);
  results::write_problem_attributes(file, run.problem);
  file.write_attribute("equation", std::string(problem::name(run.options.equation)));
  file.write_attribute("impact", std::string(problem::name(run.options.impact)));
  file.write_attribute("order", fd_fpk::transport_order(run.options));
  file.write_attribute("start_displacement_deviation", run.result.start_displacement);
  file.write_attribute("start_velocity_deviation", run.result.start_velocity);
  file.write_attribute("start_mean_displacement", run.result.start_mean_displacement);
  file.write_attribute("start_mean_velocity", run.result.start_mean_velocity);
  file.write_attribute("time_tolerance", run.transient.relative_tolerance);
  file.write_attribute("status", std::string(transform::name(run.result.status)));
  file.write_attribute("reason", run.result.reason);
}

}  // namespace

void write_transient_netcdf(const fs::path& path, const TransientRun& run) {
  results::NetCdfWriter file;
  write_attributes(file, run);
  const int time = file.define_dimension("time", run.result.snapshots.size());
  const int bounds = file.define_dimension("bounds", 2);
  file.write_variable("time", {time}, "time", values_over_time(run, &Snapshot::time));
  write_marginal(file, run, "y", "displacement y", time, bounds, run.result.y_edges, &Snapshot::y);
  write_marginal(file, run, "ydot", "velocity y'", time, bounds, run.result.v_edges, &Snapshot::v);
  write_series(file, run, time);
  base::write_file(path, file.close_and_take_bytes());
}

}  // namespace fpkcheck::study
