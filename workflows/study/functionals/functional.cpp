#include "workflows/study/functionals/functional.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "methods/plot_style.hpp"
#include "results/run.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::study {

using transform::Status;

std::vector<SelectedFunctionalMethod> methods_selected_by_list(
    const FunctionalCommandOptions& options, SelectableFunctionalMethods selectable) {
  const bool has_closures = selectable == SelectableFunctionalMethods::with_closures;
  const bool has_characteristics = selectable == SelectableFunctionalMethods::with_characteristics;
  std::vector<SelectedFunctionalMethod> methods;
  for (const std::string& item : split_at_commas(options.methods)) {
    const std::string id = item == "fd" ? "fd-kf" : item;
    SelectedFunctionalMethod method;
    method.fd = fd_fpk::options_of(id);
    method.mcs = mcs::options_of(id);
    if (has_closures) method.epc = epc::options_of(id);
    if (method.fd) {
      method.identity = fd_fpk::solution_identity(*method.fd);
      method.identity.plot_style = methods::density_equation_style(method.identity);
      method.fd->accuracy = options.accuracy;
      method.fd->max_seconds = options.max_seconds;
    } else if (method.mcs) {
      method.identity = mcs::solution_identity(*method.mcs);
      method.identity.plot_style = methods::simulation_style(method.identity);
      method.mcs->time = options.time;
      method.mcs->seed = options.seed;
      method.mcs->threads = options.threads;
    } else if (method.epc) {
      epc::validate(*method.epc);
      method.identity = epc::solution_identity(*method.epc);
      method.identity.plot_style = methods::closure_style(method.identity);
      method.epc->max_seconds = options.max_seconds;
    } else if (has_characteristics && id == "characteristics") {
      method.identity.id = id;
      method.identity.plot_style = methods::density_equation_style(method.identity);
      method.characteristics = {.accuracy = options.accuracy, .max_seconds = options.max_seconds};
    } else if (has_characteristics && id == "bounds") {
      method.identity.id = id;
      method.identity.plot_style = methods::density_equation_style(method.identity);
      method.bounds = {.accuracy = options.accuracy, .max_seconds = options.max_seconds};
    } else {
      const char* others = has_closures          ? "epc-polar-n6, epc-moment-n6, "
                           : has_characteristics ? "characteristics, bounds, "
                                                 : "";
      throw InputError(fmt::format(
          "--methods: {} is no method of this command; use fd-kf, fd-white, fd-km4, {}mcs or "
          "mcs-white",
          base::in_quotes(item), others));
    }
    if (find_method(methods, method.identity.id) == methods.end())
      methods.push_back(std::move(method));
  }
  if (methods.empty()) throw InputError("--methods: empty list; use e.g. fd-kf,mcs");
  return methods;
}

std::vector<SelectedFunctionalMethod>::const_iterator find_method(
    const std::vector<SelectedFunctionalMethod>& methods, const std::string& id) {
  return std::ranges::find(
      methods, id, [](const SelectedFunctionalMethod& method) { return method.identity.id; });
}

void for_each_selected_method(const problem::Problem& problem,
                              const FunctionalCommandOptions& options,
                              const methods::ProgressListener& listener,
                              const std::function<void(const SelectedFunctionalMethod&)>& compute,
                              SelectableFunctionalMethods selectable) {
  auto selected = methods_selected_by_list(options, selectable);
  for (std::size_t k = 0; k < selected.size(); ++k) {
    const auto progress = [&](double fraction) {
      if (!listener) return;
      listener({.done = k,
                .total = selected.size(),
                .case_name = problem.name,
                .method = selected[k].identity.id,
                .fraction = fraction});
    };
    if (selected[k].mcs) {
      selected[k].mcs->progress = [&](const mcs::SimulationProgress& now) {
        progress(now.fraction);
      };
    }
    progress(0);
    compute(selected[k]);
  }
}

std::string functional_json(const problem::Problem& problem, const std::string& key,
                            const results::Json& list, const std::string& command) {
  results::Json of_case = results::problem_to_json(problem);
  of_case[key] = list;
  const results::Json json{{"schema", results::kSummarySchema},
                           {"program", results::program_to_json(results::current_program(command))},
                           {"cases", results::Json::array({of_case})}};
  return results::serialise_json(results::replace_non_finite_by_null(json));
}

std::string solution_status_line(const std::string& id, Status status, const std::string& reason) {
  return status == Status::ok ? fmt::format("{}: ", id)
                              : fmt::format("{}: {}: {}; ", id, transform::name(status), reason);
}

std::string error_kind_text(bool has_standard_errors, bool has_kick_interval_errors) {
  if (has_kick_interval_errors) return "standard error plus error of the kick interval";
  return has_standard_errors ? "standard error" : "discretisation error";
}

void append_value_columns(const std::string& id, const std::string& header,
                          bool has_standard_errors, std::vector<StudyTableColumn>& columns,
                          const char* format) {
  columns.push_back({id, header, id, format});
  columns.push_back({id, has_standard_errors ? "std err" : "error", id + "-error", "{:.1e}"});
}

report::FigurePoint figure_point_with_error_interval(double x, double y, double error,
                                                     bool is_standard_error) {
  report::FigurePoint point{.x = x, .y = y};
  if (is_standard_error) {
    point.lower = y - 2 * error;
    point.upper = y + 2 * error;
  }
  return point;
}

std::vector<std::string> split_at_commas(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream items(list);
  for (std::string item; std::getline(items, item, ',');) parts.push_back(item);
  return parts;
}

std::optional<double> parse_finite_number(const std::string& text) {
  const auto value = base::Parameter{.name = "number", .help = {}}.parse(text);
  const double* number = value ? std::get_if<double>(&*value) : nullptr;
  return number != nullptr && std::isfinite(*number) ? std::optional(*number) : std::nullopt;
}

}  // namespace fpkcheck::study
