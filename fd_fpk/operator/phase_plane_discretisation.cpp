#include "fd_fpk/operator/phase_plane_discretisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "numerics/roots/bracketed_root.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Distance of the upper end of the computational box in x1 from the static deflection, in standard
// deviations of equivalent linearisation. A hardening spring makes the tail of p(y) shorter than
// the Gaussian tail.
constexpr double kX1BoxDeviations = 6;
// Minimum half-width in velocity of the computational box, in standard deviations of an impulse.
constexpr double kImpulseBoxDeviations = 6.5;
// Distance, in units of the kernel length sqrt(b), at which the kernel of the Pade approximant
// falls below 1e-12 of its peak.
constexpr double kPadeReach = 28;

// Returns the excitation by parametric impulses, which change the velocity by b(y) Y. The returned
// excitation has no matrix of velocity jumps, since parametric_exchange_terms() computes the
// matrices. The preconditioner uses the diffusion coefficient for the factor b(y) = 1.
DiscretisedExcitation parametric_jump_excitation(const problem::Problem& problem) {
  const problem::ImpulseTrain& impulses = problem.impulses;
  return {.exchange = {},
          .preconditioner_exchange_diffusion = impulses.rate_times_moment(2) / 2,
          .preconditioner_exchange_decay_rate = impulses.arrival_rate(),
          .parametric = ParametricImpulses{impulses, *problem.impulse_factor}};
}

// Returns the excitation terms of the impulses, except the diffusion of white noise in place of
// parametric impulses (state_dependent_diffusion()).
DiscretisedExcitation impulse_excitation(const problem::Problem& problem,
                                         const FiniteVolumeOptions& options, const GridAxis& axis,
                                         double regularisation_length) {
  const problem::ImpulseTrain& impulses = problem.impulses;
  if (!impulses.is_acting()) return {};  // without impulses all equations coincide
  switch (options.equation) {
    case DensityEquation::white:
      return problem.impulse_factor ? DiscretisedExcitation{} : white_noise_excitation(impulses);
    case DensityEquation::km4:
      return kramers_moyal_excitation(impulses, axis, regularisation_length);
    case DensityEquation::km4_pade:
      return kramers_moyal_pade_excitation(impulses, axis,
                                           centred_stencil_size(transport_order(options)));
    case DensityEquation::kf:
      return problem.impulse_factor ? parametric_jump_excitation(problem)
                                    : jump_excitation(impulses, axis);
  }
  return {};
}

// Returns the diffusion coefficient of all terms with a factor of noise or impulses. White noise in
// place of parametric impulses has the diffusion coefficient lambda E[Y^2] b^2 / 2.
StateDependentDiffusion state_dependent_diffusion(const problem::Problem& problem,
                                                  bool with_impulses) {
  // The returned functions contain a copy of the problem, since the functions may be called after
  // the problem is destroyed.
  const double of_impulses = with_impulses ? problem.impulses.rate_times_moment(2) / 2 : 0;
  StateDependentDiffusion diffusion{.coefficient = [=](double x1, double x2) {
    return problem::noise_diffusion_coefficient(problem, x1, x2) +
           of_impulses * problem::squared_impulse_factor(problem, x1);
  }};
  if (problem.noise_factor && problem.noise_factor->depends_on_v()) {
    diffusion.slope_in_x2 = [=](double x1, double x2) {
      return problem.noise.diffusion() *
             problem.noise_factor->squared_noise_factor_slope_in_v(x1, x2);
    };
  }
  return diffusion;
}

// Returns all excitation terms of the density equation. White noise with the diffusion coefficient
// D adds the term (D p)'' to every equation.
DiscretisedExcitation make_excitation(const problem::Problem& problem,
                                      const FiniteVolumeOptions& options, const GridAxis& axis,
                                      double regularisation_length) {
  const bool has_impulse_diffusion =
      problem.impulse_factor && options.equation == DensityEquation::white;
  DiscretisedExcitation terms = impulse_excitation(problem, options, axis, regularisation_length);
  if (problem.noise_factor || has_impulse_diffusion) {
    terms.state_dependent_diffusion = state_dependent_diffusion(problem, has_impulse_diffusion);
  } else {
    terms.diffusion += problem.noise.diffusion();
  }
  return terms;
}

// Returns the regularisation length l of the truncated Kramers-Moyal equation `km4` on the cells of
// an axis; the option value 0 selects the literal scheme.
double regularisation_length(const problem::Problem& problem, const FiniteVolumeOptions& options,
                             const GridAxis& axis) {
  if (options.equation != DensityEquation::km4 || !problem.impulses.is_acting()) return 0;
  if (!options.regularisation_length) {
    return default_regularisation_length(problem.impulses, axis,
                                         centred_stencil_size(transport_order(options)));
  }
  const double length = *options.regularisation_length;
  return length > 0 ? length : axis.smallest_cell_width();
}

DensityLengthScales standard_deviation_scales(const problem::Problem& problem) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  return {scales.displacement_deviation, scales.velocity_deviation};
}

// Returns the number of cells of an axis as a double, since a computational box may need more cells
// than an int can represent.
double axis_cell_count(double refined_length, double cell_width, double min_count) {
  return std::max(min_count, std::ceil(refined_length / cell_width - 1e-9));
}

// Returns the minimum number of cells of an axis, proportional to the refinement, so that the grids
// of an error estimate differ. The constant kFewest is the number of cells of an axis that
// one-sided stencils require.
double min_axis_cell_count(const FiniteVolumeOptions& options) {
  constexpr double kAutomatic = 16, kFewest = 8;
  return std::max(kFewest, std::ceil(kAutomatic * options.refinement - 1e-9));
}

PlaneDiscretisation failed_discretisation(const PhasePlaneBox& box, std::string failure,
                                          double cells) {
  return {.grid = make_grid(1, 2, box.x1_max, box.x2_max),
          .excitation = {},
          .regularisation_length = 0,
          .failure = std::move(failure),
          .cells = cells};
}

// Returns the reason why the options permit no usable grid; empty if the grid is usable.
std::string grid_failure_reason(const problem::Problem& problem, const FiniteVolumeOptions& options,
                                const PhasePlaneBox& box, double nx, double nv) {
  if (options.impact == ImpactCondition::map) {
    std::string collapse = problem::inelastic_collapse_reason(problem, options.equation);
    if (!collapse.empty()) return collapse;
  }
  if (!(nx * nv <= kMaxCells)) {
    return fmt::format(
        "the grid needs {:.9g} x {:.9g} cells, more than {}: use fewer cells (nx, nv) or a smaller "
        "box",
        nx, nv, kMaxCells);
  }
  if (!problem.impulses.is_acting()) return "";
  if (options.equation == DensityEquation::km4_pade &&
      pade_kernel_length_squared(problem.impulses) <= 0) {
    return "the Pade approximant of the truncated series does not exist: the law is too skew, "
           "E[Y^4] E[Y^2] <= 4/3 E[Y^3]^2; use km4 or kf";
  }
  if (const double length = options.regularisation_length.value_or(
          default_regularisation_length(problem.impulses.amplitude_law()));
      options.equation == DensityEquation::km4 && length > box.x2_max / 2) {
    return fmt::format(
        "the fourth difference of km4 has step {:.3g} in a box |y'| <= {:.3g}: the step must be at "
        "most half of the box; use a shorter regularisation length or a larger box",
        length, box.x2_max);
  }
  return "";
}

// Returns the end of an axis with `cells` cells up to `length`, after `added_cells` cells are added
// beyond `length`.
double extended_axis_end(int added_cells, int cells, double length, const CellGrading& grading) {
  const double present = graded_cell_count(length, 1, grading),
               added = present * added_cells / cells;
  if (added_cells == 0) return length;
  // The bracket contains the root, since the number of cells increases at least in proportion to
  // the length of the axis.
  return numerics::bracketed_root(
      [&](double end) { return graded_cell_count(end, 1, grading) - present - added; }, length,
      length + 2 * added);
}
int additional_cells(int cells, double length, double length_factor, const CellGrading& grading) {
  const double quotient =
      graded_cell_count(length_factor * length, 1, grading) / graded_cell_count(length, 1, grading);
  return static_cast<int>(std::lround((quotient - 1) * cells));
}

// Coordinate s(x) in which the cells of x1 have equal widths, apart from the refinement points: the
// integral of l / l(x), with the local length scale l(x) of the density. Near an equilibrium of
// stiffness k the standard deviation of the displacement is the standard deviation of the velocity
// divided by sqrt(k). The local length scale is therefore l(x) = l_v / sqrt(f'(x)), at most the
// length scale l of the whole density, with the length scale l_v of the velocity and the stiffness
// f'(x). The slope of the local length scale l(x) is at most 1, so that the widths of neighbouring
// cells differ by at most a quarter. For a force without kinks s(x) = x, because only kinks
// separate springs of very different stiffness.
class StretchedCoordinate {
 public:
  StretchedCoordinate(const problem::System& system, const PhasePlaneBox& box,
                      const DensityLengthScales& lengths)
      : from_(box.x1_min), interval_((box.x1_max - box.x1_min) / kIntervals) {
    if (system.kinks_in_y(box.x1_min, box.x1_max).empty()) return;
    std::vector<double> length(kIntervals, lengths.x1);
    const auto restoring_force = [&](int node) { return system.force(position(node), 0); };
    for (int n = 0; n < kIntervals; ++n) {
      const double stiffness = (restoring_force(n + 1) - restoring_force(n)) / interval_;
      if (stiffness > 0) length[n] = std::min(length[n], lengths.x2 / std::sqrt(stiffness));
    }
    for (int n = 1; n < kIntervals; ++n) {
      length[n] = std::min(length[n], length[n - 1] + interval_);
    }
    for (int n = kIntervals - 1; n-- > 0;) {
      length[n] = std::min(length[n], length[n + 1] + interval_);
    }
    values_.push_back(0);
    for (const double l : length) values_.push_back(values_.back() + interval_ * lengths.x1 / l);
  }

  bool is_identity() const { return values_.empty(); }
  double operator()(double x) const {
    if (is_identity()) return x;
    const double node = (x - from_) / interval_;
    const int n = std::clamp(static_cast<int>(node), 0, kIntervals - 1);
    return values_[n] + (node - n) * (values_[n + 1] - values_[n]);
  }

 private:
  // Number of intervals of the table. The narrowest cell of the largest grids (300 x 300 cells,
  // kMaxCells) contains two intervals of the table.
  static constexpr int kIntervals = 2000;

  double position(int node) const { return from_ + node * interval_; }

  double from_, interval_;
  std::vector<double> values_;  // s at the ends of the intervals
};

// Requirements on the cells of the displacement axis x1, with faces at the refinement points
struct DisplacementCellRequirements {
  const PhasePlaneBox& box;
  const std::vector<RefinementPoint>& points;
  const StretchedCoordinate& stretched;

  // Returns the number of cells of the axis times the cell width far from the refinement points.
  double refined_length() const {
    const double length = box.x1_max - box.x1_min;
    double total = stretched(box.x1_max) - stretched(box.x1_min);
    for (const RefinementPoint& point : points) {
      total += graded_cell_count(length, 1, point.grading) - length;
    }
    return total;
  }
  std::vector<double> faces(int cells) const {
    // The factor 1 + 1e-12 prevents an additional cell due to rounding errors.
    const double step = refined_length() / cells * (1 + 1e-12);
    return cell_faces_graded_to_points(box.x1_min, box.x1_max, step, points, stretched);
  }
};

}  // namespace

DensityLengthScales fisher_length_scales(const problem::System& system, const PhasePlaneBox& box,
                                         const PhasePlaneGrid& grid,
                                         const Eigen::VectorXd& averages,
                                         const problem::MotionScales& scales) {
  const StretchedCoordinate stretched(system, box, box.lengths);
  // Density, as a fraction of the peak density, below which a computed density may be a numerical
  // error
  constexpr double kFaint = 1e-3;
  constexpr double kShortest = 0.25;  // minimum length scale, in standard deviations
  // Maximum number of length scales of the density along the axis, since a long tail is smooth
  constexpr double kMost = 25;
  const Eigen::Index nx = grid.nx(), nv = grid.v_cell_count();
  const double faint = kFaint * averages.maxCoeff();
  double of_x1 = 0, of_x2 = 0, mass = 0;
  const auto slope = [&](double p, double next, double distance) {
    return p > faint && next > faint ? std::pow((next - p) / distance, 2) * 2 / (p + next) : 0;
  };
  for (Eigen::Index i = 0; i < nx; ++i) {
    const int x1 = static_cast<int>(i);
    for (Eigen::Index j = 0; j < nv; ++j) {
      const int x2 = static_cast<int>(j);
      const double area = grid.x1.cell_width(x1) * grid.x2.cell_width(x2), p = averages(i * nv + j);
      mass += area * p;
      if (i + 1 < nx) {
        of_x1 += area *
                 slope(p, averages((i + 1) * nv + j),
                       stretched(grid.x1.cell_centre(x1 + 1)) - stretched(grid.x1.cell_centre(x1)));
      }
      if (j + 1 < nv) {
        of_x2 += area * slope(p, averages(i * nv + j + 1),
                              grid.x2.cell_centre(x2 + 1) - grid.x2.cell_centre(x2));
      }
    }
  }
  const auto length = [&](double information, double deviation, double total_length) {
    const double shortest = std::max(kShortest * deviation, total_length / kMost);
    return std::clamp(std::sqrt(mass / information), std::min(shortest, deviation), deviation);
  };
  return {length(of_x1, scales.displacement_deviation, grid.x1_max() - grid.x1_min()),
          length(of_x2, scales.velocity_deviation, 2 * grid.x2_max())};
}

PhasePlaneBox initial_box(const problem::Problem& problem, const FiniteVolumeOptions& options) {
  return initial_box(problem, problem::motion_scales(problem), options);
}

PhasePlaneBox initial_box(const problem::Problem& problem, const problem::MotionScales& scales,
                          const FiniteVolumeOptions& options) {
  const problem::System& system = problem.system;
  const auto& law = problem.impulses.amplitude_law();
  // For problems without has_linearised_scales(), problem::MotionScales contains the limits of the
  // computational box.
  const bool linearised = has_linearised_scales(problem);
  const double y_high =
      linearised ? scales.centre + kX1BoxDeviations * scales.displacement_deviation : scales.y_high;
  const double of_impulse =
      problem.impulses.is_acting()
          ? std::abs(law.moment(1)) + kImpulseBoxDeviations * law.amplitude_standard_deviation()
          : 0;
  PhasePlaneBox box{.x1_max = options.x1_max.value_or(y_high),
                    .x2_max = options.x2_max.value_or(std::max(scales.v_high, of_impulse)),
                    .x1_min = options.x1_max ? -*options.x1_max : scales.y_low,
                    .lengths = {scales.displacement_deviation, scales.velocity_deviation}};
  if (system.left_wall()) box.x1_min = system.left_wall()->position;
  if (system.right_wall()) box.x1_max = system.right_wall()->position;
  return box;
}

EnlargedBox enlarge_box(const problem::Problem& problem, const FiniteVolumeOptions& options,
                        const PhasePlaneGrid& grid, double factor_x1, double factor_x2) {
  const GridCellGradings graded =
      automatic_gradings(problem, options, standard_deviation_scales(problem));
  const CellGrading &of_x1 = graded.x1, &of_x2 = graded.x2;
  const int nx = grid.nx(), half = grid.v_cell_count() / 2;
  const int more_x1 = additional_cells(nx, grid.x1_max(), factor_x1, of_x1);
  const int more_x2 = additional_cells(half, grid.x2_max(), factor_x2, of_x2);
  return {.box = {.x1_max = extended_axis_end(more_x1, nx, grid.x1_max(), of_x1),
                  .x2_max = extended_axis_end(more_x2, half, grid.x2_max(), of_x2)},
          .nx = nx + more_x1,
          .nv = 2 * (half + more_x2)};
}

PlaneDiscretisation discretise_density_equation(const problem::Problem& problem,
                                                const FiniteVolumeOptions& options,
                                                const PhasePlaneBox& box) {
  const problem::System& system = problem.system;
  const DensityLengthScales lengths =
      box.lengths.x1 > 0 ? box.lengths : standard_deviation_scales(problem);
  const GridCellGradings graded = automatic_gradings(problem, options, lengths);
  const DensityLengthScales widths = automatic_cell_widths(problem, options, lengths);
  const double length = box.x1_max - box.x1_min;
  std::vector<RefinementPoint> points;
  if (graded.at_left_wall) points.push_back({box.x1_min, graded.x1});
  // Cell faces at the kinks of force and excitation factors preserve the order of cell averages.
  const std::vector<double> kinks =
      problem::coefficient_kinks_in_y(problem, box.x1_min, box.x1_max);
  // The axes of usual grids have about 100 cells. If the force has more kinks than kMostKinks, the
  // distances between kinks are below the cell width, and cell faces at the kinks would only
  // increase the number of cells.
  constexpr std::size_t kMostKinks = 100;
  if (kinks.size() <= kMostKinks) {
    for (const double kink : kinks) points.push_back({kink, {}});
  }
  if (graded.at_right_wall) points.push_back({box.x1_max, graded.x1});
  const StretchedCoordinate stretched(system, box, lengths);
  const DisplacementCellRequirements x1_cells{box, points, stretched};
  const double least = min_axis_cell_count(options);
  // value_or() is not used here, since value_or() would convert the automatic number to int.
  const double nx = options.nx ? *options.nx
                               : axis_cell_count(x1_cells.refined_length(),
                                                 std::min(widths.x1, length / least), least);
  const double nv = options.nv ? *options.nv
                               : 2 * axis_cell_count(graded_cell_count(box.x2_max, 1, graded.x2),
                                                     widths.x2, least);
  std::string failure = grid_failure_reason(problem, options, box, nx, nv);
  if (!failure.empty()) return failed_discretisation(box, std::move(failure), nx * nv);
  PhasePlaneGrid grid =
      symmetric_grid(x1_cells.faces(static_cast<int>(nx)),
                     graded_cell_faces(box.x2_max, static_cast<int>(nv) / 2, graded.x2),
                     system.left_wall() ? AxisEndCondition::boundary : AxisEndCondition::vacuum,
                     system.right_wall() ? AxisEndCondition::boundary : AxisEndCondition::vacuum);
  const double l = regularisation_length(problem, options, grid.x2);
  DiscretisedExcitation terms = make_excitation(problem, options, grid.x2, l);
  const double cells = grid.size();
  return {.grid = std::move(grid),
          .excitation = std::move(terms),
          .regularisation_length = l,
          .failure = "",
          .cells = cells};
}

PlaneDiscretisation discretise_excitation_on_same_grid(const problem::Problem& problem,
                                                       const FiniteVolumeOptions& options,
                                                       const PlaneDiscretisation& discretisation) {
  PlaneDiscretisation changed = discretisation;
  changed.excitation = make_excitation(problem, options, discretisation.grid.x2,
                                       discretisation.regularisation_length);
  return changed;
}

FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options,
                                            const PlaneDiscretisation& discretisation) {
  return fokker_planck_operator(problem.system, discretisation.excitation, options.impact,
                                discretisation.grid, transport_order(options));
}

ExcitationOnUnboundedAxis unbounded_axis_excitation(const problem::Problem& problem,
                                                    const FiniteVolumeOptions& options,
                                                    double cell_width) {
  const int points = centred_stencil_size(transport_order(options));
  const double length =
      regularisation_length(problem, options, GridAxis::with_uniform_cells(0, cell_width, 1));
  int reach = excitation_half_bandwidth(length, cell_width, points);
  if (options.equation == DensityEquation::km4_pade) {
    // The kernel of the inverse operator in the Pade approximant decays as exp(-|x2| / sqrt(b)),
    // with the kernel length sqrt(b).
    reach += static_cast<int>(std::ceil(
        kPadeReach * std::sqrt(pade_kernel_length_squared(problem.impulses)) / cell_width));
  }
  GridAxis axis = GridAxis::with_uniform_cells(0, cell_width, 2 * reach + 1);
  DiscretisedExcitation terms = make_excitation(problem, options, axis, length);
  return {std::move(axis), std::move(terms)};
}

}  // namespace fpkcheck::fd_fpk
