#include "compare/transient/netcdf.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <stdexcept>
#include <vector>

#include "compare/run_directory.hpp"
#include "compare/summary.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using fd_fpk::Snapshot;

void check(int status, const std::string& what) {
  if (status != NC_NOERR) {
    throw std::runtime_error(fmt::format("netCDF: {} ({})", what, nc_strerror(status)));
  }
}

/// A netCDF file being written.
class NetCdfFile {
 public:
  explicit NetCdfFile(const fs::path& path) {
    check(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_), "cannot create the file");
  }
  NetCdfFile(const NetCdfFile&) = delete;
  NetCdfFile& operator=(const NetCdfFile&) = delete;
  ~NetCdfFile() {
    if (open_) nc_close(id_);
  }

  int dimension(const char* name, std::size_t length) {
    int dimension = 0;
    check(nc_def_dim(id_, name, length, &dimension), fmt::format("dimension {}", name));
    return dimension;
  }

  /// A variable of double precision with its values, row by row; its units are "1".
  /// @param long_name empty for the bounds of a coordinate, which have no attributes
  int variable(const char* name, const std::vector<int>& dimensions, const std::string& long_name,
               const std::vector<double>& values) {
    int variable = 0;
    check(nc_def_var(id_, name, NC_DOUBLE, static_cast<int>(dimensions.size()), dimensions.data(),
                     &variable),
          fmt::format("variable {}", name));
    if (!long_name.empty()) {
      attribute("long_name", long_name, variable);
      attribute("units", "1", variable);
    }
    check(nc_put_var_double(id_, variable, values.data()), fmt::format("values of {}", name));
    return variable;
  }

  void attribute(const char* name, const std::string& text, int variable = NC_GLOBAL) {
    check(nc_put_att_text(id_, variable, name, text.size(), text.c_str()),
          fmt::format("attribute {}", name));
  }
  void attribute(const char* name, double value) {
    check(nc_put_att_double(id_, NC_GLOBAL, name, NC_DOUBLE, 1, &value),
          fmt::format("attribute {}", name));
  }
  void attribute(const char* name, int value) {
    check(nc_put_att_int(id_, NC_GLOBAL, name, NC_INT, 1, &value),
          fmt::format("attribute {}", name));
  }

  /// A full disk may show only here.
  void close() {
    open_ = false;
    check(nc_close(id_), "cannot finish the file");
  }

 private:
  int id_ = 0;
  bool open_ = true;
};

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
void write_marginal(NetCdfFile& file, const TransientRun& run, const std::string& name,
                    const std::string& meaning, int time, int bounds,
                    const std::vector<double>& edges, std::vector<double> Snapshot::*marginal) {
  const std::size_t cells = edges.size() - 1;
  std::vector<double> centres, ends;
  for (std::size_t b = 0; b < cells; ++b) {
    centres.push_back((edges[b] + edges[b + 1]) / 2);
    ends.insert(ends.end(), {edges[b], edges[b + 1]});
  }
  const int dimension = file.dimension(name.c_str(), cells);
  const int coordinate = file.variable(name.c_str(), {dimension}, meaning, centres);
  const std::string bounds_name = name + "_bounds";
  file.attribute("bounds", bounds_name, coordinate);
  file.variable(bounds_name.c_str(), {dimension, bounds}, "", ends);
  const int density =
      file.variable(("p_" + name).c_str(), {time, dimension},
                    fmt::format("probability density of the {}", meaning), rows(run, marginal));
  file.attribute("cell_methods", name + ": mean", density);
}

void write_moments(NetCdfFile& file, const TransientRun& run, int time) {
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

void write_attributes(NetCdfFile& file, const TransientRun& run) {
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
      NetCdfFile file(temporary);
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
