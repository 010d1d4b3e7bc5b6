#include "compare/transient/report.hpp"

#include <fmt/format.h>

#include "compare/figure/drawing.hpp"
#include "compare/figure/pictures.hpp"
#include "compare/run_directory.hpp"
#include "compare/summary.hpp"
#include "compare/text/wrapped.hpp"
#include "compare/transient/figure.hpp"
#include "compare/transient/netcdf.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using fd_fpk::Snapshot;
using Json = nlohmann::ordered_json;

constexpr const char* kFile = "transient.nc";

Json snapshot_json(const Snapshot& s) {
  const auto& m = s.moments;
  return {{"time", s.time},
          {"moments",
           {{"y1", m.y1}, {"y2", m.y2}, {"y4", m.y4}, {"v1", m.v1}, {"v2", m.v2}, {"v4", m.v4}}},
          {"energy", s.energy},
          {"power", s.power},
          {"power_residual", s.power_residual},
          {"impact_rate", s.impact_rate},
          {"mass", s.mass},
          {"min_density", s.min_density},
          {"wall_density", {{"y", s.wall.x1}, {"ydot", s.wall.x2}}}};
}

std::string row(const Snapshot& s) {
  const auto& m = s.moments;
  return fmt::format("{:>8.4g} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.1e} {:>8.1e}\n",
                     s.time, m.y1, m.y2, m.v1, m.v2, s.energy, s.mass - 1, s.power_residual);
}

}  // namespace

Json transient_json(const TransientRun& run) {
  const auto& result = run.result;
  Json snapshots = Json::array();
  for (const auto& s : result.snapshots) snapshots.push_back(snapshot_json(s));
  Json options = fd_fpk::to_json(run.options);
  options.erase("stepper");  // of the stationary density only
  options.erase("residual_tolerance");
  options["until"] = run.transient.until;
  options["snapshots"] = run.transient.snapshots;
  options["relative_tolerance"] = run.transient.relative_tolerance;
  options["max_order"] = run.transient.max_order;
  return with_null_for_non_finite(
      {{"schema", kTransientSchema},
       {"program", program_json(run.command)},
       {"case", case_json(run.problem)},
       {"options", options},
       {"status", transform::name(result.status)},
       {"reason", result.reason},
       {"seconds", result.seconds},
       {"start", {{"y", result.start_displacement}, {"ydot", result.start_velocity}}},
       {"nx", result.y_edges.empty() ? 0 : result.y_edges.size() - 1},
       {"nv", result.v_edges.empty() ? 0 : result.v_edges.size() - 1},
       {"steps", result.steps},
       {"factorisations", result.factorisations},
       {"rhs_evaluations", result.rhs_evaluations},
       {"krylov_iterations", result.krylov_iterations},
       {"regularisation_length", result.regularisation_length},
       {"snapshots", snapshots}});
}

std::string transient_table(const TransientRun& run, std::size_t width) {
  constexpr std::size_t kMostRows = 24;
  const auto& [command, problem, options, transient, result] = run;
  const auto& system = problem.system;
  const auto& impulses = problem.impulses;
  std::string text = wrapped(
      fmt::format("{}: c = {:g}, k = {:g}, mu = {:g}, r = {:g}; {} impulses, lambda = {:g}, "
                  "lambda E[Y^2] = {:g}",
                  problem.name, system.damping(), system.stiffness(), system.cubic(),
                  system.restitution(), impulses.law().name(), impulses.arrival_rate(),
                  impulses.intensity()),
      width);
  text += wrapped(fmt::format("{}/{} from a Gaussian of deviations {:.4g} (y) and {:.4g} (y')",
                              fd_fpk::name(options.equation), problem::name(options.impact),
                              result.start_displacement, result.start_velocity),
                  width);
  const std::size_t last = result.snapshots.empty() ? 0 : result.snapshots.size() - 1;
  const std::size_t every = last / kMostRows + 1;
  if (!result.snapshots.empty()) {
    text += fmt::format("{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "t", "E[y]", "E[y^2]",
                        "E[y']", "E[y'^2]", "energy", "mass - 1", "power");
    for (std::size_t n = 0; n < last; n += every) text += row(result.snapshots[n]);
    text += row(result.snapshots[last]);
  }
  if (result.status != transform::Status::ok) {
    text +=
        wrapped(fmt::format("  {}: {}", transform::name(result.status), result.reason), width, 4);
  }
  if (!result.snapshots.empty()) {
    text += wrapped(
        fmt::format("power: residual of the balance of power, relative to lambda E[Y^2]/2. {} x {} "
                    "cells, {} steps, {} factorisations{}.",
                    result.y_edges.size() - 1, result.v_edges.size() - 1, result.steps,
                    result.factorisations,
                    every == 1 ? "" : fmt::format("; each {}. snapshot is shown", every)),
        width);
  }
  return text;
}

std::string transient_picture_stem(const std::string& case_name) {
  return "transient-" + picture_stem(case_name);
}

std::vector<std::string> write_transient(const fs::path& directory, const TransientRun& run,
                                         const std::string& gnuplot) {
  const fs::path figures = directory / "figures";
  const std::string stem = transient_picture_stem(run.problem.name);
  remove_pictures_of(figures, stem);
  if (run.result.snapshots.empty()) {
    std::error_code ignored;
    fs::remove(directory / kFile, ignored);
    return {fmt::format("no {}: there is no density at any time", kFile)};
  }
  write_transient_netcdf(directory / kFile, run);
  if (run.result.snapshots.size() < 2) return {"no picture: there is a density at t = 0 only"};
  return write_pictures(figures, stem, transient_figure(run, stem), gnuplot);
}

}  // namespace fpkcheck::compare
