#include "workflows/study/transient/report_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/files/file_transaction.hpp"
#include "report/figure/run_gnuplot.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"
#include "results/netcdf/writer.hpp"
#include "results/output_directory.hpp"
#include "results/run.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::study {
namespace {

namespace fs = std::filesystem;
using fd_fpk::DensitySnapshot;
using report::wrap_text;

constexpr const char* kFile = "transient.nc";

// Replaces a value that rounds to 0 with five decimals by 0, to avoid the text "-0.00000".
double without_negative_zero(double value) {
  constexpr double kHalfADigit = 5e-6;
  return std::abs(value) < kHalfADigit ? 0 : value;
}

std::string snapshot_table_row(const DensitySnapshot& s) {
  const auto& m = s.moments;
  return fmt::format("{:>8.4g} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.1e} {:>8.1e}\n",
                     s.time, without_negative_zero(m.y1), m.y2, without_negative_zero(m.v1), m.v2,
                     without_negative_zero(s.energy), s.mass - 1, s.power_residual);
}

}  // namespace

std::string transient_table(const TransientRun& run, std::size_t width) {
  constexpr std::size_t kMaxRows = 24;
  const auto& result = run.result;
  std::string text = wrap_text(report::case_title(run.problem), width);
  const std::string solved =
      fmt::format("{}/{}", problem::name(run.options.equation), problem::name(run.options.impact));
  text += wrap_text(
      run.transient.periodic
          ? fmt::format("{} in the periodic state, after {} periods to an L1 change of {:.0e} per "
                        "period",
                        solved, result.periods, result.change_over_period)
          : fmt::format("{} from a Gaussian about ({:.4g}, {:.4g}) of deviations {:.4g} (y) and "
                        "{:.4g} (y')",
                        solved, result.start_mean_displacement, result.start_mean_velocity,
                        result.start_displacement, result.start_velocity),
      width);
  const std::size_t last = result.snapshots.empty() ? 0 : result.snapshots.size() - 1;
  const std::size_t stride = last / kMaxRows + 1;
  if (!result.snapshots.empty()) {
    text += fmt::format("{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "t", "E[y]", "E[y^2]",
                        "E[y']", "E[y'^2]", "energy", "mass - 1", "power");
    for (std::size_t n = 0; n < last; n += stride) text += snapshot_table_row(result.snapshots[n]);
    text += snapshot_table_row(result.snapshots[last]);
  }
  if (result.status != transform::Status::ok) {
    text +=
        wrap_text(fmt::format("  {}: {}", transform::name(result.status), result.reason), width, 4);
  }
  if (!result.snapshots.empty()) {
    text += wrap_text(
        fmt::format(
            "power: residual of the balance of power, relative to D + lambda E[Y^2]/2. {} x {} "
            "cells, {} steps, {} factorisations{}.",
            result.y_edges.size() - 1, result.v_edges.size() - 1, result.steps,
            result.factorisations,
            stride == 1 ? "" : fmt::format("; one of {} snapshots is shown", stride)),
        width);
  }
  return text;
}

std::vector<std::string> write_transient_files(const fs::path& directory, const TransientRun& run,
                                               const report::FigureOptions& options,
                                               const std::string& gnuplot) {
  const fs::path figures = directory / "figures";
  const std::string stem = "transient-" + results::case_file_stem(run.problem.name);
  report::remove_script_and_pictures(figures, stem);
  if (run.result.snapshots.empty()) {
    std::error_code ignored;
    fs::remove(directory / kFile, ignored);
    return {fmt::format("no {}: no time has a density", kFile)};
  }
  write_transient_netcdf(directory / kFile, run);
  if (run.result.snapshots.size() < 2) return {"no picture: only t = 0 has a density"};
  return report::write_script_and_draw(
      figures, stem, report::make_gnuplot_script(transient_figure(run), stem, options.width),
      options, gnuplot);
}

namespace {

using results::Json;

Json snapshot_json(const fd_fpk::DensitySnapshot& s) {
  return {{"time", s.time},
          {"moments", results::moments_to_json(s.moments)},
          {"yv", s.yv},
          {"energy", s.energy},
          {"power", s.power},
          {"power_residual", s.power_residual},
          {"impact_rate", s.impact_rate},
          {"mass", s.mass},
          {"min_density", s.min_density},
          {"wall_density", {{"y", std::max(s.wall.x1, s.wall.x1_low)}, {"ydot", s.wall.x2}}}};
}

Json options_json(const TransientRun& run) {
  Json json = results::values_to_json(fd_fpk::solver_option_descriptions().values(run.options));
  for (const char* of_stationarity : {"stepper", "residual_tolerance"}) json.erase(of_stationarity);
  json["until"] = run.transient.until;
  json["snapshots"] = run.transient.snapshots;
  json["relative_tolerance"] = run.transient.relative_tolerance;
  json["max_order"] = run.transient.max_order;
  json["periodic"] = run.transient.periodic;
  return json;
}

}  // namespace

std::string transient_json(const TransientRun& run) {
  const auto& result = run.result;
  Json snapshots = Json::array();
  for (const auto& s : result.snapshots) snapshots.push_back(snapshot_json(s));
  const Json json{
      {"schema", kTransientSchema},
      {"program", results::program_to_json(results::current_program(run.command))},
      {"case", results::problem_to_json(run.problem)},
      {"options", options_json(run)},
      {"status", transform::name(result.status)},
      {"reason", result.reason},
      {"seconds", result.seconds},
      {"start",
       {{"y", result.start_displacement},
        {"ydot", result.start_velocity},
        {"mean_y", result.start_mean_displacement},
        {"mean_ydot", result.start_mean_velocity}}},
      {"nx", result.y_edges.empty() ? 0 : result.y_edges.size() - 1},
      {"nv", result.v_edges.empty() ? 0 : result.v_edges.size() - 1},
      {"steps", result.steps},
      {"periods", result.periods},
      {"change_over_period", run.transient.periodic ? Json(result.change_over_period) : Json()},
      {"factorisations", result.factorisations},
      {"rhs_evaluations", result.rhs_evaluations},
      {"krylov_iterations", result.krylov_iterations},
      {"regularisation_length", result.regularisation_length},
      {"snapshots", snapshots}};
  return results::serialise_json(results::replace_non_finite_by_null(json));
}

namespace {

namespace fs = std::filesystem;
using fd_fpk::DensitySnapshot;

template <class Of>
std::vector<double> values_over_time(const TransientRun& run, Of of) {
  std::vector<double> values;
  for (const DensitySnapshot& s : run.result.snapshots) values.push_back(std::invoke(of, s));
  return values;
}

std::vector<double> marginal_values(const TransientRun& run,
                                    std::vector<double> DensitySnapshot::*marginal) {
  std::vector<double> values;
  for (const DensitySnapshot& s : run.result.snapshots) {
    values.insert(values.end(), (s.*marginal).begin(), (s.*marginal).end());
  }
  return values;
}

void write_marginal(results::NetCdfWriter& file, const TransientRun& run, const std::string& name,
                    const std::string& meaning, int time, int bounds,
                    const std::vector<double>& edges,
                    std::vector<double> DensitySnapshot::*marginal) {
  const int dimension = file.write_cell_coordinate(name, meaning, bounds, edges);
  const int density = file.write_variable("p_" + name, {time, dimension},
                                          fmt::format("probability density of the {}", meaning),
                                          marginal_values(run, marginal));
  file.write_attribute("cell_methods", name + ": mean", density);
}

void write_time_series(results::NetCdfWriter& file, const TransientRun& run, int time) {
  const auto series = [&](const char* name, const std::string& long_name, auto of) {
    file.write_variable(name, {time}, long_name, values_over_time(run, of));
  };
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    series(name, symbol, [of = moment](const DensitySnapshot& s) { return s.moments.*of; });
  }
  series("yv", "E[y y']", &DensitySnapshot::yv);
  series("energy", "mean energy E[y'^2]/2 + E[U(y)], U the potential of the spring",
         &DensitySnapshot::energy);
  series("power", "power of the excitation less that lost by damping and impacts",
         &DensitySnapshot::power);
  series("power_residual",
         "power less the rate of the mean energy, relative to D + lambda E[Y^2]/2",
         &DensitySnapshot::power_residual);
  series("impact_rate", "impacts per unit time", &DensitySnapshot::impact_rate);
  series("mass", "integral of the density", &DensitySnapshot::mass);
  series("min_density", "smallest value of the joint density relative to its largest",
         &DensitySnapshot::min_density);
}

void write_attributes(results::NetCdfWriter& file, const TransientRun& run) {
  file.write_attribute("Conventions", "CF-1.8");
  file.write_attribute("title", "marginal densities over time of a randomly excited oscillator");
  const auto program = results::current_program(run.command);
  file.write_attribute("source", fmt::format("{} {}", program.name, program.version));
  file.write_attribute("command", program.command);
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
  assert(!run.result.snapshots.empty());
  results::NetCdfWriter file;
  write_attributes(file, run);
  const int time = file.define_dimension("time", run.result.snapshots.size());
  const int bounds = file.define_dimension("bounds", 2);
  file.write_variable("time", {time}, "time", values_over_time(run, &DensitySnapshot::time));
  write_marginal(file, run, "y", "displacement y", time, bounds, run.result.y_edges,
                 &DensitySnapshot::y);
  write_marginal(file, run, "ydot", "velocity y'", time, bounds, run.result.v_edges,
                 &DensitySnapshot::v);
  write_time_series(file, run, time);
  base::write_file_atomically(path, file.close_and_take_bytes());
}

}  // namespace fpkcheck::study
