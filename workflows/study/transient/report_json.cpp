#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "results/json.hpp"
#include "results/run.hpp"
#include "workflows/study/transient/report.hpp"

namespace fpkcheck::study {
namespace {

using results::Json;

Json snapshot_json(const fd_fpk::Snapshot& s) {
  return {{"time", s.time},
          {"moments", results::moments_json(s.moments)},
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
  Json json = results::values_json(fd_fpk::description().values(run.options));
  for (const char* of_stationarity : {"stepper", "residual_tolerance"}) json.erase(of_stationarity);
  json["until"] = run.transient.until;
  json["snapshots"] = run.transient.snapshots;
  json["relative_tolerance"] = run.transient.relative_tolerance;
  json["max_order"] = run.transient.max_order;
  return json;
}

}  // namespace

std::string transient_json(const TransientRun& run) {
  const auto& result = run.result;
  Json snapshots = Json::array();
  for (const auto& s : result.snapshots) snapshots.push_back(snapshot_json(s));
  const Json json{{"schema", kTransientSchema},
                  {"program", results::program_json(results::this_program(run.command))},
                  {"case", results::problem_json(run.problem)},
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
                  {"factorisations", result.factorisations},
                  {"rhs_evaluations", result.rhs_evaluations},
                  {"krylov_iterations", result.krylov_iterations},
                  {"regularisation_length", result.regularisation_length},
                  {"snapshots", snapshots}};
  return results::json_text(results::with_null_for_non_finite(json));
}

}  // namespace fpkcheck::study
