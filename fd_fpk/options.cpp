#include "fd_fpk/options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "problem/input_error.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kSmallestTolerance = 1e-10;

// A line needs room for the one-sided stencils on either side of x2 = 0.
constexpr int kSmallestLine = 16;
constexpr int kLargestLine = 2000;
constexpr double kMostOriginRefinement = 1000;

void require(bool holds, const std::string& message) {
  if (!holds) throw InputError(message);
}

void require_positive(const std::optional<double>& value, std::string_view option) {
  require(!value || (std::isfinite(*value) && *value > 0),
          fmt::format("{} = {} (must be a positive number)", option, value.value_or(0)));
}

void require_cells(const std::optional<int>& cells, std::string_view option) {
  require(!cells || (*cells >= kSmallestLine && *cells <= kLargestLine),
          fmt::format("{} = {} (must be between {} and {} cells)", option, cells.value_or(0),
                      kSmallestLine, kLargestLine));
}

}  // namespace

std::string_view name(Stepper stepper) { return stepper == Stepper::cvode ? "cvode" : "direct"; }

std::string id(const Options& options) {
  const std::string equation = fmt::format("fd-{}", name(options.equation));
  return options.impact == problem::Impact::map
             ? equation
             : fmt::format("{}-{}", equation, problem::name(options.impact));
}

void validate(const Options& options) {
  require(options.order >= 2 && options.order <= 8,
          fmt::format("finite-difference order {} (must be 2 .. 8)", options.order));
  require(options.impact != problem::Impact::exact,
          "impact exact (only the simulation has it: use map or delta)");
  require(std::isfinite(options.refinement) && options.refinement > 0,
          fmt::format("refinement {} (must be a positive number)", options.refinement));
  const double at_origin = options.origin_refinement.value_or(1);
  require(at_origin >= 1 && at_origin <= kMostOriginRefinement,
          fmt::format("origin refinement {} (must be between 1 and {})", at_origin,
                      kMostOriginRefinement));
  require_cells(options.nx, "nx");
  require_cells(options.nv, "nv");
  require(
      !options.nv || *options.nv % 2 == 0,
      fmt::format("nv = {} (must be even: x2 = 0 lies between two cells)", options.nv.value_or(0)));
  require_positive(options.x1_max, "y-max");
  require_positive(options.x2_max, "v-max");
  require(!options.regularisation_length || options.equation == Equation::km4,
          fmt::format("regularisation length with equation {} (only km4 has one: leave it out)",
                      name(options.equation)));
  require(!options.regularisation_length || (std::isfinite(*options.regularisation_length) &&
                                             *options.regularisation_length >= 0),
          fmt::format("regularisation length {} (must be positive, or 0 for the literal scheme)",
                      options.regularisation_length.value_or(0)));
  require_positive(options.tolerance, "tolerance");
  require(!options.tolerance || *options.tolerance >= kSmallestTolerance,
          fmt::format("tolerance {} (rounding ends at about {})", options.tolerance.value_or(0),
                      kSmallestTolerance));
  require(!options.tolerance || (!options.nx && !options.nv),
          "tolerance with a given nx or nv (the tolerance picks the grid: leave them out)");
  require(options.wall_density > 0 && options.wall_density < 1,
          fmt::format("wall density {} (must be between 0 and 1)", options.wall_density));
  require(std::isfinite(options.residual_tolerance) && options.residual_tolerance > 0,
          fmt::format("residual tolerance {} (must be positive)", options.residual_tolerance));
}

}  // namespace fpkcheck::fd_fpk
