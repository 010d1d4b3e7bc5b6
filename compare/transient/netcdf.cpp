#include "compare/transient/netcdf.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "compare/netcdf/writer.hpp"
#include "compare/run_directory.hpp"
#include "compare/summary.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using fd_fpk::Snapshot;

template <class Of>
std::vector<double> over_time(const TransientRun& run, Of of) {
  std::vector<double> values;
  for (const Snapshot& s : run.result.snapshots) values.push_back(of(s));
  return values;
}

// p(time, x), row by row.
std::vector<double> rows(const TransientRun& run, std::vector<double> Snapshot::*marginal) {
  std::vector<double> values;
  for (const Snapshot& s : run.result.snapshots) {
    values.insert(values.end(), (s.*marginal).begin(), (s.*marginal).end());
  }
  return values;
}

/// A coordinate of cells, with its bounds, and the marginal over it.
void write_marginal(NetCdfWriter& file, const TransientRun& run, const std::string& name,
                    const std::string& meaning, int time, int bounds,
                    const std::vector<double>& edges, std::vector<double> Snapshot::*marginal) {
  const int dimension = file.cells(name, meaning, bounds, edges);
  const int density =
      file.variable("p_" + name, {time, dimension},
                    fmt::format("probability density of the {}", meaning), rows(run, marginal));
  file.attribute("cell_methods", name + ": mean", density);
}

void write_moments(NetCdfWriter& file, const TransientRun& run, int time) {
  const auto series = [&](const char* name, const char* long_name, auto of) {
    file.variable(name, {time}, long_name, over_time(run, of));
  };
  series("y1", "E[y]", [](const Snapshot& s) { return s.moments.y1; });
  series("y2", "E[y^2]", [](const Snapshot& s) { return s.moments.y2; });
  series("y4", "E[y^4]", [](const Snapshot& s) { return s.moments.y4; });
  series("v1", "E[y']", [](const Snapshot& s) { return s.moments.v1; });
  series("v2", "E[y'^2]", [](const Snapshot& s) { return s.moments.v2; });
  series("v4", "E[y'^4]", [](const Snapshot& s) { return s.moments.v4; });
  series("energy", "mean energy E[y'^2]/2 + k E[y^2]/2 + mu E[y^4]/4",
         [](const Snapshot& s) { return s.energy; });
  series("power", "power of the impulses less that lost by damping and impacts",
         [](const Snapshot& s) { return s.power; });
  series("power_residual", "power less the rate of the mean energy, relative to lambda E[Y^2]/2",
         [](const Snapshot& s) { return s.power_residual; });
  series("impact_rate", "impacts per unit time", [](const Snapshot& s) { return s.impact_rate; });
  series("mass", "integral of the density", [](const Snapshot& s) { return s.mass; });
  series("min_density", "smallest value of the joint density relative to its largest",
         [](const Snapshot& s) { return s.min_density; });
}

void write_attributes(NetCdfWriter& file, const TransientRun& run) {
  const auto& system = run.problem.system;
  const auto& impulses = run.problem.impulses;
  file.attribute("Conventions", "CF-1.8");
  file.attribute("title",
                 "marginal densities over time of a vibro-impact Duffing oscillator under "
                 "Poisson impulses");
  file.attribute("source", fmt::format("fpkcheck {}", program_version()));
  file.attribute("command", run.command);
  file.attribute("case", run.problem.name);
  file.attribute("damping", system.damping());
  file.attribute("stiffness", system.stiffness());
  file.attribute("cubic", system.cubic());
  file.attribute("restitution", system.restitution());
  file.attribute("impulse_rate", impulses.arrival_rate());
  file.attribute("impulse_law", std::string(impulses.law().name()));
  file.attribute("impulse_intensity", impulses.intensity());
  file.attribute("impulse_mean", impulses.law().moment(1));
  file.attribute("equation", std::string(fd_fpk::name(run.options.equation)));
  file.attribute("impact", std::string(problem::name(run.options.impact)));
  file.attribute("order", run.options.order);
  file.attribute("start_displacement_deviation", run.result.start_displacement);
  file.attribute("start_velocity_deviation", run.result.start_velocity);
  file.attribute("time_tolerance", run.transient.relative_tolerance);
  file.attribute("status", std::string(transform::name(run.result.status)));
  file.attribute("reason", run.result.reason);
}

}  // namespace

void write_transient_netcdf(const fs::path& path, const TransientRun& run) {
  replace_file(path, [&](const fs::path& temporary) {
    try {
      NetCdfWriter file(temporary);
      write_attributes(file, run);
      const int time = file.dimension("time", run.result.snapshots.size());
      const int bounds = file.dimension("bounds", 2);
      file.variable("time", {time}, "time",
                    over_time(run, [](const Snapshot& s) { return s.time; }));
      write_marginal(file, run, "y", "displacement y", time, bounds, run.result.y_edges,
                     &Snapshot::y);
      write_marginal(file, run, "ydot", "velocity y'", time, bounds, run.result.v_edges,
                     &Snapshot::v);
      write_moments(file, run, time);
      file.close();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("cannot write {} ({})", path.string(), error.what()));
    }
  });
}

}  // namespace fpkcheck::compare
