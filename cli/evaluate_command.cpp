#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "epc/closed_form_density.hpp"
#include "methods/external/density_file.hpp"
#include "methods/external/number_table.hpp"
#include "problem/case_file.hpp"
#include "results/json_conversions.hpp"

namespace fpkcheck::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEvaluateUsage = R"(usage: fpkcheck evaluate FILE [SOLUTION] [options]

Evaluates the closed form of a density p(y, y') at points and prints CSV: y,v,p. FILE is the
summary.json of a run, or its directory, and SOLUTION the id of a closure in this run; or FILE is
a closed form as JSON (docs/external.md). Calls no solver: p = C exp(Q_n) from stored coefficients.

examples:
  fpkcheck evaluate results/summary.json epc-moment-n8
  fpkcheck evaluate results epc-gaussian-n6 --at points.csv
  echo "0.5 -0.2" | fpkcheck evaluate mine.json --at -
)";

struct PhasePoint {
  double y, v;
};

constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;

std::string read_text_file(const fs::path& file, const char* hint) {
  auto text = base::read_input_file(file, kMaxTextBytes);
  if (!text) {
    throw InputError(
        fmt::format("{} is not a readable file; give {}", base::in_quotes(file.string()), hint));
  }
  return *std::move(text);
}

std::vector<PhasePoint> read_points(std::istream& in, const std::string& name) {
  const auto table = methods::read_number_table(in, name);
  if (table.column_count() != 2) table.throw_row_error(0, "three columns: must be two, y and y'");
  std::vector<PhasePoint> points;
  for (const auto& row : table.rows) points.push_back({row[0], row[1]});
  return points;
}

std::vector<PhasePoint> load_points(const std::string& name) {
  if (name == "-") return read_points(std::cin, "standard input");
  std::istringstream in(read_text_file(name, "a file with the columns y and y'"));
  return read_points(in, name);
}

// Returns a regular grid of points over the bounding box of the support of a density.
std::vector<PhasePoint> make_grid_points(const transform::SmoothDensity& density,
                                         const std::string& file) {
  if (!std::isfinite(density.y_max) || !std::isfinite(density.v_max)) {
    throw InputError(fmt::format("{} has no bounded support; give points by --at", file));
  }
  constexpr int kCellsY = 40, kCellsV = 80;
  std::vector<PhasePoint> points;
  for (int i = 0; i <= kCellsY; ++i) {
    for (int j = 0; j <= kCellsV; ++j) {
      points.push_back({density.y_min + (density.y_max - density.y_min) * i / kCellsY,
                        density.v_max * (2.0 * j / kCellsV - 1)});
    }
  }
  return points;
}

methods::ClosedFormDensityFile read_closed_form(const std::string& text, const std::string& where,
                                                const std::optional<std::string>& solution,
                                                const std::optional<std::string>& case_name) {
  if (results::is_run_summary(text, where)) {
    return methods::read_closed_form_file(text, where,
                                          {.solution = solution, .case_name = case_name});
  }
  auto file = methods::read_closed_form_file(text, where, {.solution = solution});
  if (case_name) file.problem = problem::load_case(*case_name, {});
  return file;
}

std::string densities_csv_text(const std::vector<PhasePoint>& points,
                               const std::vector<double>& values) {
  std::string text = "y,v,p\n";
  for (std::size_t k = 0; k < points.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", points[k].y, points[k].v, values[k]);
  }
  return text;
}

std::string densities_json_text(const std::vector<PhasePoint>& points,
                                const std::vector<double>& values, const std::string& file,
                                const methods::ClosedFormDensityFile& form) {
  nlohmann::ordered_json json{{"file", file}, {"case", nullptr}, {"solution", nullptr}};
  if (form.solution) {
    json["case"] = form.problem->name;
    json["solution"] = form.solution->id();
  }
  for (const char* name : {"y", "v", "p"}) json[name] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < points.size(); ++k) {
    json["y"].push_back(points[k].y);
    json["v"].push_back(points[k].v);
    json["p"].push_back(values[k]);
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace

int evaluate_command(const CommandInvocation& call) {
  namespace po = boost::program_options;
  std::vector<std::string> words;
  std::optional<std::string> at, case_name;
  bool json = false, quiet = false;
  po::options_description options("options", 96);
  options.add_options()(
      "at", make_optional_option(at, "FILE"),
      "file with the points in two columns, y and y', in the format of --against; - is standard "
      "input (default: a grid of 41 x 81 points over the support)")(
      "case", make_optional_option(case_name, "CASE"),
      "case of the solution, for a summary with several cases; for a closed form in amplitude or "
      "energy, the case that defines amplitude and energy")("json", po::bool_switch(&json),
                                                            "print JSON instead of CSV")(
      "quiet,q", po::bool_switch(&quiet), "do not warn of a solution without status ok")(
      "help,h", "print this text");
  if (!parse_arguments(call.arguments, kEvaluateUsage, options, words)) return kSuccess;
  if (words.empty() || words.size() > 2) {
    throw InputError(
        "evaluate takes a file and a solution in it; e.g. results/summary.json epc-moment-n8");
  }
  fs::path file = words[0];
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) file /= "summary.json";
  const std::string where = base::to_printable_text(file.string());
  const auto form =
      read_closed_form(read_text_file(file, "the summary.json of a run, or a closed form"), where,
                       words.size() == 2 ? std::optional(words[1]) : std::nullopt, case_name);
  if (!epc::can_be_normalised(form.form)) {
    throw InputError(fmt::format(
        "{} has neither \"C\" nor \"support\"; add \"support\" to normalise the form", where));
  }
  const auto density = [&] {
    try {
      return epc::density_of_closed_form(form.form, form.problem ? &*form.problem : nullptr);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", where, error.what()));
    }
  }();
  const auto points = at ? load_points(*at) : make_grid_points(density, where);
  std::vector<double> values;
  for (const auto& [y, v] : points) values.push_back(y < density.y_min ? 0 : density.value(y, v));
  print_output(json ? densities_json_text(points, values, file.string(), form)
                    : densities_csv_text(points, values));
  if (!quiet && form.solution && !form.solution->has_status_ok()) {
    print_message(fmt::format("{} is {}: {}", form.solution->id(), name(form.solution->status),
                              form.solution->reason));
  }
  return kSuccess;
}

}  // namespace fpkcheck::cli
