#include <fmt/format.h>

#include "cli/choice.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/transient_and_report.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck fd CASE ... [options]

Finite differences for the stationary density on the half-plane y >= 0, of fifth order and
conservative, stepped to stationarity by CVODE with KLU and checked against the null vector of
the same operator. The excitation term of the equation:
  white     Gaussian white noise of the same intensity
  km4       the series cut after the fourth derivative, with a fixed step l of the fourth
            difference: with l = grid step it is ill-posed, and the solver says so
  km4-pade  the Pade approximant of that series: well-posed without a length
  kf        the full jump integral (Kolmogorov-Feller equation), for every law of the impulses

examples:
  fpkcheck fd case1
  fpkcheck fd case1 --equation km4 --impact delta                (the equation of the closure)
  fpkcheck fd case1 --equation km4 --regularisation-length 0     (ill-posed, and says so)
  fpkcheck fd case4 --stepper direct --order 7 --refinement 1.5
  fpkcheck fd case1 --until 20 --snapshots 80 --out transient    (the density over time)
)";

// Boost.Program_options fills std::optional only through a notifier.
template <class T>
auto optional_value(std::optional<T>& target, const char* name) {
  return boost::program_options::value<T>()->value_name(name)->notifier(
      [&target](const T& value) { target = value; });
}

namespace po = boost::program_options;

/// --until and what belongs to it.
struct OverTime {
  std::optional<double> until{};
  std::optional<int> snapshots{};
  std::optional<double> start_y{}, start_v{}, tolerance{};

  po::options_description description() {
    const fd_fpk::TransientOptions defaults;
    po::options_description options;
    options.add_options()  //
        ("until", optional_value(until, "T"),
         "the density over time, 0 .. T, from a Gaussian start, instead of the stationary one")(
            "snapshots", optional_value(snapshots, "N"),
            fmt::format("with --until: T/N apart (default {})", defaults.snapshots).c_str())(
            "start-y", optional_value(start_y, "S"),
            "with --until: deviation of y = |z| in the start (default: half the stationary one "
            "of equivalent linearisation)")(
            "start-v", optional_value(start_v, "S"),
            "with --until: deviation of y' in the start (default: likewise)")(
            "time-tolerance", optional_value(tolerance, "R"),
            fmt::format("with --until: local error of a time step relative to the largest density "
                        "(default {:g})",
                        defaults.relative_tolerance)
                .c_str());
    return options;
  }

  /// The options of the transient; nothing when the stationary density is asked for.
  std::optional<fd_fpk::TransientOptions> asked_for() const {
    if (!until) {
      if (snapshots || start_y || start_v || tolerance) {
        throw InputError(
            "--snapshots, --start-y, --start-v or --time-tolerance without --until (they belong to "
            "a density over time: give --until T)");
      }
      return std::nullopt;
    }
    fd_fpk::TransientOptions options{.until = *until};
    if (snapshots) options.snapshots = *snapshots;
    if (tolerance) options.relative_tolerance = *tolerance;
    options.start_displacement = start_y;
    options.start_velocity = start_v;
    return options;
  }
};

}  // namespace

int fd_command(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  CommonArguments common;
  fd_fpk::Options options;
  std::string equation, stepper, impact;
  OverTime over_time;
  po::options_description own;
  own.add_options()  //
      ("equation", po::value(&equation)->value_name("E")->default_value("kf"),
       "white, km4, km4-pade or kf")(
          "impact", po::value(&impact)->value_name("I")->default_value("map"),
          "map: the exact impact, p(0+, w) = p(0-, w/r)/r^2; delta: the paper's, first order in 1-r")(
          "stepper", po::value(&stepper)->value_name("S")->default_value("cvode"),
          "cvode, or direct: the null vector alone")(
          "order", po::value(&options.order)->value_name("P")->default_value(options.order),
          "order of the transport terms, 2 .. 8; odd ones are upwind-biased")(
          "refinement",
          po::value(&options.refinement)->value_name("F")->default_value(options.refinement),
          "automatic cells are F times narrower")(
          "origin-refinement", optional_value(options.origin_refinement, "F"),
          "cells at the origin are F times narrower than far from it (default: 16 when r < 0.95 and the density is bounded there, else 1)")(
          "nx", optional_value(options.nx, "N"),
          "cells in y (default: from equivalent linearisation)")(
          "nv", optional_value(options.nv, "N"), "cells in y', even (default: likewise)")(
          "y-max", optional_value(options.x1_max, "Y"),
          "box 0 <= y <= Y (default: until it is empty there)")(
          "v-max", optional_value(options.x2_max, "V"), "box |y'| <= V (default: likewise)")(
          "regularisation-length", optional_value(options.regularisation_length, "L"),
          "step l of km4's fourth difference (default: l^2 = E[Y^6]/(5 E[Y^4])); 0: the literal "
          "scheme")("error", po::bool_switch(&options.error_estimate),
                    "estimate the discretisation error from two coarser grids")(
          "tolerance", optional_value(options.tolerance, "T"),
          "pick the grid whose error estimate, L1 of p(y) and p(y') and the second moments, is "
          "below T")("wall-density",
                     po::value(&options.wall_density)
                         ->value_name("D")
                         ->default_value(options.wall_density, "1e-06"),
                     "density on a wall, relative to the peak, beyond which the box is widened")(
          "residual",
          po::value(&options.residual_tolerance)
              ->value_name("R")
              ->default_value(options.residual_tolerance),
          "stationarity residual ||L p||_1 / ||p||_1 to reach");
  own.add(over_time.description());
  if (!parse(arguments, kUsage, with_common_options(own, common), common.cases)) return 0;
  options.equation = choice(equation, "--equation",
                            {fd_fpk::Equation::white, fd_fpk::Equation::km4,
                             fd_fpk::Equation::km4_pade, fd_fpk::Equation::kf});
  options.impact = choice(impact, "--impact", {problem::Impact::map, problem::Impact::delta});
  options.stepper = choice(stepper, "--stepper", {fd_fpk::Stepper::cvode, fd_fpk::Stepper::direct});
  if (const auto transient = over_time.asked_for()) {
    if (options.stepper == fd_fpk::Stepper::direct) {
      throw InputError(
          "--stepper direct with --until (a density over time is stepped: leave it out)");
    }
    return transient_and_report(common, options, *transient, command_line);
  }
  return solve_and_report(common, {compare::fd_method(options)}, 0, Required::all, command_line);
}

}  // namespace fpkcheck::cli
