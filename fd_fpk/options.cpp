#include "fd_fpk/options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using namespace base;

// Minimum number of cells of an axis, sufficient for one-sided stencils on both sides of x2 = 0.
constexpr int kFewestAxisCells = 16;
constexpr int kMostAxisCells = 2000;
constexpr double kMostOriginRefinement = 1000;
constexpr double kSmallestTolerance = 1e-10;

// Impact conditions of the density equations; only the simulation has ImpactCondition::exact.
constexpr ImpactCondition kImpacts[] = {ImpactCondition::map, ImpactCondition::delta};

std::vector<std::string> impact_names() {
  std::vector<std::string> list;
  for (const ImpactCondition impact : kImpacts) list.emplace_back(problem::name(impact));
  return list;
}

AdmissibleRange tolerance_range() {
  return {[](double x) { return std::isfinite(x) && x >= kSmallestTolerance; },
          fmt::format("at least {}, the level of rounding errors", kSmallestTolerance)};
}

void require(bool holds, const std::string& message) {
  if (!holds) throw InputError(message);
}

OptionsDescription<FiniteVolumeOptions> make_description() {
  using O = FiniteVolumeOptions;
  return OptionsDescription<O>("fd ")
      .add("equation", &O::equation, {"E", "white, km4, km4-pade or kf"})
      .add("impact", &O::impact,
           {"I",
            "map: the exact impact, p(0+, w) = p(0-, w/r)/r^2; delta: the impact of the paper, "
            "to first order in 1-r"})
      .with_choices(impact_names())
      .add("stepper", &O::stepper, {"S", "cvode, or direct: the null vector without time steps"})
      .add("transport", &O::transport,
           {"T",
            "upwind: finite volumes; characteristics: along the motion between impulses, for kf "
            "(default: characteristics for rare impulses, strong losses or mass at rest in "
            "contact)"})
      .with_default(std::string(name(TransportScheme::upwind)))
      .add("order", &O::order,
           {"P",
            "order of the transport terms, 2 .. 8; odd orders are upwind-biased (default: 5; 7 "
            "for oscillators other than the paper's where no wall dissipates energy)"},
           closed_interval(2, 8))
      .add("refinement", &O::refinement, {"F", "automatic cells are F times narrower"},
           positive_numbers())
      .add("origin_refinement", &O::origin_refinement,
           {"F",
            "cells at the origin are F times narrower than cells far from the origin (default: "
            "16 for r < 0.95 and a density bounded at the origin, else 1)"},
           closed_interval(1, kMostOriginRefinement))
      .add("nx", &O::nx, {"N", "number of cells in y (default: from equivalent linearisation)"},
           closed_interval(kFewestAxisCells, kMostAxisCells))
      .add("nv", &O::nv,
           {"N", "even number of cells in y' (default: from equivalent linearisation)"},
           even_integers_between(kFewestAxisCells, kMostAxisCells)
               .with_reason_in_message("y' = 0 lies between two cells"))
      .add("x1_max", &O::x1_max,
           {"Y", "box 0 <= y <= Y (default: wide enough for a negligible density at its end)"},
           positive_numbers())
      .with_flag("y-max")
      .add("x2_max", &O::x2_max,
           {"V", "box |y'| <= V (default: wide enough for a negligible density at its ends)"},
           positive_numbers())
      .with_flag("v-max")
      .add(
          "regularisation_length", &O::regularisation_length,
          {"L",
           "step l of the fourth difference of km4 (default: l^2 = E[Y^6]/(5 E[Y^4]), longer where "
           "cells are wider than l); 0: the literal scheme"},
          non_negative_numbers())
      .add("wall_density", &O::wall_density,
           {"D",
            "density at an end of the box, relative to the peak, above which the box is widened"},
           open_interval(0, 1))
      .add("refine_unresolved", &O::refine_unresolved,
           {"", "refine an automatic grid that does not resolve its density"})
      .without_flag()
      .add("error_estimate", &O::error_estimate,
           {"", "estimate the discretisation error from two coarser grids"})
      .without_flag()
      .add("accuracy", &O::accuracy,
           {"A", "largest estimated error of p(y) or p(y') in L1 for status ok"},
           positive_numbers())
      .with_default(FiniteVolumeOptions{}.accuracy)
      .add(
          "max_seconds", &O::max_seconds,
          {"S",
           "time limit in seconds: after the limit no finer grid is started or continued; the most "
           "accurate solution so far is returned (in a run 20)"},
          positive_numbers())
      .with_default(FiniteVolumeOptions{}.max_seconds)
      .add("tolerance", &O::tolerance,
           {"T",
            "choose the first grid with an error estimate below T (L1 errors of p(y) and p(y'), "
            "relative errors of the second moments)"},
           tolerance_range())
      .add("residual_tolerance", &O::residual_tolerance,
           {"R", "threshold of the stationarity residual ||L p||_1 / ||p||_1"}, positive_numbers())
      .with_flag("residual");
}

}  // namespace

const OptionsDescription<FiniteVolumeOptions>& solver_option_descriptions() {
  // A separate function constructs the description, because Clang 14 would destroy temporaries of
  // the initialiser at every call of solver_option_descriptions().
  static const auto description = make_description();
  return description;
}

void validate(const FiniteVolumeOptions& options) {
  solver_option_descriptions().validate(options);
  require(options.impact != ImpactCondition::exact,
          "impact exact: only the simulation has this impact; use map or delta");
  const bool along = options.transport == TransportScheme::characteristics;
  require(
      !along || (options.equation == DensityEquation::kf && options.impact == ImpactCondition::map),
      fmt::format("transport characteristics with equation {} and impact {}: requires kf and "
                  "map; use upwind",
                  problem::name(options.equation), problem::name(options.impact)));
  require(
      !along || (!options.nx && !options.nv),
      "nx or nv with transport characteristics: this transport chooses its cells; use refinement");
  require(
      !options.regularisation_length || options.equation == DensityEquation::km4,
      fmt::format(
          "regularisation length with equation {}: only km4 has this length; leave out the length",
          problem::name(options.equation)));
  require(!options.tolerance || (!options.nx && !options.nv),
          "tolerance with nx or nv: the tolerance selects the grid; leave out nx and nv");
}

std::string solution_id(const FiniteVolumeOptions& options) {
  const std::string equation = fmt::format("fd-{}", problem::name(options.equation));
  return options.impact == ImpactCondition::map
             ? equation
             : fmt::format("{}-{}", equation, problem::name(options.impact));
}

transform::SolutionIdentity solution_identity(const FiniteVolumeOptions& options) {
  return {.id = solution_id(options),
          .method = "fd",
          .equation = options.equation,
          .impact = options.impact,
          .role = transform::SolutionRole::equation};
}

std::optional<FiniteVolumeOptions> options_of(std::string_view wanted) {
  for (const auto& equation : enumerator_names(DensityEquation{})) {
    for (const ImpactCondition impact : kImpacts) {
      const FiniteVolumeOptions options{.equation = equation.value, .impact = impact};
      if (solution_id(options) == wanted) return options;
    }
  }
  return std::nullopt;
}

namespace {

using namespace base;

constexpr int kMostSnapshots = 10000;
constexpr int kHighestBdfOrder = 5;

// Upwind-biased operators of orders 3 and 5 have no growing modes. Centred operators, and operators
// of order 7 with one-sided stencils at the walls, have growing modes. Long implicit time steps to
// stationarity damp growing modes, whereas accurate time steps amplify growing modes.
void require_stable_order(int order) {
  if (order != 3 && order != 5) {
    throw InputError(fmt::format(
        "order {} of a density over time: the operator has growing modes; use order 3 or 5",
        order));
  }
}

OptionsDescription<TransientOptions> make_transient_description() {
  using T = TransientOptions;
  const T defaults;
  return OptionsDescription<T>("fd ")
      .add("until", &T::until,
           {"T",
            "density over time, 0 .. T, from an initial Gaussian, instead of the stationary "
            "density"},
           positive_numbers())
      .add("snapshots", &T::snapshots,
           {"N",
            fmt::format("with --until: number of intervals between stored densities (default {})",
                        defaults.snapshots)},
           closed_interval(1, kMostSnapshots))
      .add("periodic", &T::periodic,
           {"",
            "with --until: densities of the periodic state, with the period T of the excitation"})
      .add("start_y", &T::start_displacement,
           {"S",
            "with --until: standard deviation of y at t = 0 (default: about half of the stationary "
            "deviation)"},
           positive_numbers())
      .add(
          "start_v", &T::start_velocity,
          {"S",
           "with --until: standard deviation of y' at t = 0 (default: about half of the stationary "
           "deviation)"},
          positive_numbers())
      .add(
          "start_mean_y", &T::start_mean_displacement,
          {"M",
           "with --until: mean of y at t = 0, before truncation at the walls (default: about E[y]; "
           "the position of the wall, if there is only one wall, at the equilibrium)"},
          finite_numbers())
      .add("start_mean_v", &T::start_mean_velocity,
           {"M", "with --until: mean of y' at t = 0 (default: 0)"}, finite_numbers())
      .add("relative_tolerance", &T::relative_tolerance,
           {"R", fmt::format("with --until: local error of a time step relative to the largest "
                             "density (default {:g})",
                             defaults.relative_tolerance)},
           open_interval(0, 1))
      .with_flag("time-tolerance")
      .add("max_order", &T::max_order, {"N", "highest order of BDF"},
           closed_interval(1, kHighestBdfOrder))
      .without_flag();
}

}  // namespace

const OptionsDescription<TransientOptions>& transient_option_descriptions() {
  static const auto description = make_transient_description();
  return description;
}

void validate(const FiniteVolumeOptions& options, const TransientOptions& transient) {
  validate(options);
  require_stable_order(transport_order(options));
  if (options.tolerance || options.transport == TransportScheme::characteristics) {
    throw InputError(
        "tolerance or transport characteristics with a density over time: both apply to stationary "
        "densities; leave them out");
  }
  transient_option_descriptions().validate(transient);
}

}  // namespace fpkcheck::fd_fpk
