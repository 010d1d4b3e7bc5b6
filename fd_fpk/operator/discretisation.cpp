#include "fd_fpk/operator/discretisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fd_fpk/axis/growth_rate.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/features.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Half-widths of the box and cell widths, in standard deviations of equivalent linearisation. A
// hardening spring shortens the tail of p(y), and the impulses lengthen the tail of p(y'). The
// steep tail of p(y) requires the narrower cells.
constexpr double kX1BoxDeviations = 6;
constexpr double kX2BoxDeviations = 7;
// Minimum half-width of the box in velocity, in standard deviations of a single impulse.
constexpr double kImpulseBoxDeviations = 6.5;
// Factor of the cell widths far from the origin on a graded grid. The wider cells there compensate
// the narrow cells near the origin in the total number of cells.
constexpr double kGradedWidth = 1.6;
// Distance, in lengths sqrt(b), at which the kernel of the Pade approximant falls below 1e-12 of
// its peak.
constexpr double kPadeReach = 28;
constexpr double kX1Step = 0.15;
constexpr double kX2Step = 0.16;

// Distances from the origin, in standard deviations, at which the cells of a graded axis have half
// of their full width: for an x1 axis that is graded to a singularity, and for all other axes.
constexpr double kLongReach = 2;
constexpr double kReach = 0.75;

// Whether the cells of x1 may be graded as the cube of the cells of x2. On such uneven cells,
// schemes of even orders and of order 7 oscillate.
bool can_grade_cubically(const Options& options) {
  return transport_order(options) == 3 || transport_order(options) == 5;
}

// Whether single impulses are so small that the density at a wall has the singularity of white
// noise down to lengths that cells resolve. Cells graded as under white noise are better if the
// impulses are below an eighth of the standard deviation of velocity. This threshold was measured
// by the estimated error and the limit of the finest grids for case 1 with r = 0.3 .. 0.7, rates 30
// .. 1e6, gaussian and exponential (build/release/benchmarks/fpkcheck_rates --restitutions
// 0.3,0.5,0.7 --rates 30,100,1e3,1e4,1e6).
bool are_impulses_small(const problem::Problem& problem) {
  constexpr double kShort = 1.0 / 8;
  if (!problem.impulses.is_present()) return false;
  return std::sqrt(problem.impulses.law().moment(2)) <
         kShort * problem::scales(problem).velocity_deviation;
}

// Whether the excitation acts as white noise down to lengths that cells resolve: because the
// equation replaces the impulses by white noise, or because the impulses are small.
bool is_effectively_white_noise(const problem::Problem& problem, Equation equation) {
  return equation == Equation::white || are_impulses_small(problem);
}

// Whether the density at the wall is proportional to u^-beta (exact::wall_exponent) and cells may
// be graded to this singularity.
bool can_resolve_wall_singularity(const problem::Problem& problem, const Options& options) {
  const double r = problem.system.restitution();
  return options.impact == Impact::map && r < 1 && can_grade_cubically(options) &&
         is_effectively_white_noise(problem, options.equation);
}

// Grading with which cells at the origin are narrower than cells far from the origin, by this
// factor.
Grading grading(double factor, double deviation) {
  if (factor == 1) return {};
  return {.reach = kReach * deviation, .core = kReach * deviation / (factor - 1)};
}

// Grading of x1, for the given refinement factor of x2. Under white noise with losses the density
// near the origin is v^-beta times a function of D2 y / v^3 (Cornell, Swift, Bray 1998). If cells
// resolve x2 down to the length `core`, cells must resolve x1 down to core^3 / D2. If x1 is graded
// like x2, the computed density at the wall is flat, and the impact rate is too small (by 1 % at r
// = 0.6). Separate impulses cause only a step of the density at the origin. If the widths of
// neighbouring cells differ by more than a quarter, a grid-scale ripple is amplified, up to 4 % of
// p(y). The long reach keeps the differences below a quarter, also on grids twice as coarse, as for
// an error estimate.
Grading x1_grading(const problem::Problem& problem, const Options& options, double factor,
                   const Grading& of_x2, double deviation) {
  if (factor == 1 || !can_resolve_wall_singularity(problem, options))
    return grading(factor, deviation);
  const double d2 = problem.impulses.intensity() / 2;
  return {.reach = kLongReach * deviation, .core = std::pow(of_x2.core, 3) / d2};
}

Excitation impulse_excitation(const problem::ImpulseTrain& impulses, const Options& options,
                              const Axis& axis, double regularisation_length) {
  if (!impulses.is_present()) return {};  // without impulses all equations coincide
  switch (options.equation) {
    case Equation::white:
      return white_noise_excitation(impulses);
    case Equation::km4:
      return kramers_moyal_excitation(impulses, axis, regularisation_length);
    case Equation::km4_pade:
      return kramers_moyal_pade_excitation(impulses, axis,
                                           centred_stencil_size(transport_order(options)));
    case Equation::kf:
      return jump_excitation(impulses, axis);
  }
  return {};
}

// White noise adds D p'' to every equation.
Excitation excitation(const problem::Problem& problem, const Options& options, const Axis& axis,
                      double regularisation_length) {
  Excitation terms = impulse_excitation(problem.impulses, options, axis, regularisation_length);
  terms.diffusion += problem.noise.diffusion();
  return terms;
}

// Regularisation length l of km4 on these cells. The option value 0 selects the literal scheme.
double regularisation_length(const problem::Problem& problem, const Options& options,
                             const Axis& axis) {
  if (options.equation != Equation::km4 || !problem.impulses.is_present()) return 0;
  if (!options.regularisation_length) {
    return default_regularisation_length(problem.impulses, axis,
                                         centred_stencil_size(transport_order(options)));
  }
  const double length = *options.regularisation_length;
  return length > 0 ? length : axis.smallest_cell_width();
}

// Number of cells of an axis, as a double, since a box may need more cells than an int can
// represent. The minimum number of cells is proportional to the refinement, so that the grids of an
// error estimate differ. One-sided stencils require kFewest cells.
double cell_count(double length, double step, const Grading& grading, double refinement) {
  constexpr double kAutomatic = 16, kFewest = 8;
  const double fewest = std::max(kFewest, std::ceil(kAutomatic * refinement - 1e-9));
  return std::max(fewest, std::ceil(graded_cell_count(length, step, grading) - 1e-9));
}

Discretisation failed_discretisation(const Box& box, std::string failure, double cells) {
  return {.grid = make_grid(1, 2, box.x1_max, box.x2_max),
          .excitation = {},
          .regularisation_length = 0,
          .failure = std::move(failure),
          .cells = cells};
}

// The reason why there is no usable grid; empty if there is a usable grid.
std::string grid_failure_reason(const problem::Problem& problem, const Options& options,
                                const Box& box, double nx, double nv) {
  if (options.impact == Impact::map) {
    std::string collapse = problem::inelastic_collapse_reason(problem, options.equation);
    if (!collapse.empty()) return collapse;
  }
  if (!(nx * nv <= kMaxCells)) {
    return fmt::format(
        "the grid needs {:.9g} x {:.9g} cells, more than {}: use fewer cells (nx, nv) or a smaller "
        "box",
        nx, nv, kMaxCells);
  }
  if (!problem.impulses.is_present()) return "";
  if (options.equation == Equation::km4_pade && pade_length_squared(problem.impulses) <= 0) {
    return "the Pade approximant of the truncated series does not exist: the law is too skew, "
           "E[Y^4] E[Y^2] <= 4/3 E[Y^3]^2; use km4 or kf";
  }
  if (const double length = options.regularisation_length.value_or(
          default_regularisation_length(problem.impulses.law()));
      options.equation == Equation::km4 && length > box.x2_max / 2) {
    return fmt::format(
        "the fourth difference of km4 has step {:.3g} in a box |y'| <= {:.3g}: the step must be at "
        "most half of the box; use a shorter regularisation length or a larger box",
        length, box.x2_max);
  }
  return "";
}

// The gradings of the axes x1 and x2.
struct Gradings {
  Grading of_x1, of_x2;
};
Gradings gradings(const problem::Problem& problem, const Options& options) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double at_origin = origin_refinement(problem, options);
  const Grading of_x2 = grading(at_origin, linear.velocity_deviation);
  return {.of_x1 = x1_grading(problem, options, at_origin, of_x2, linear.displacement_deviation),
          .of_x2 = of_x2};
}

// The upper end of an axis with `more` additional cells; without these the axis has `cells` cells
// and ends at `length`.
double extended_axis_end(int more, int cells, double length, const Grading& grading) {
  const double wanted = graded_cell_count(length, 1, grading) * (cells + more) / cells;
  double end = length;
  for (int n = 0; n < 20; ++n) {  // Newton's method: the function is convex and nearly linear
    end -=
        (graded_cell_count(end, 1, grading) - wanted) / (1 + grading.reach / (grading.core + end));
  }
  return end;
}
int additional_cells(int cells, double length, double factor, const Grading& grading) {
  const double quotient =
      graded_cell_count(factor * length, 1, grading) / graded_cell_count(length, 1, grading);
  return static_cast<int>(std::lround((quotient - 1) * cells));
}

// The diffusion coefficient: the coefficient of p'' in the terms that act on the shortest lengths.
double diffusion_coefficient(const problem::Problem& problem, Equation equation) {
  const bool local = equation == Equation::km4 || is_effectively_white_noise(problem, equation);
  return problem.noise.diffusion() + (local ? problem.impulses.rate_times_moment(2) / 2 : 0);
}

// Gradings for problems outside the paper's class: at walls with losses and at x2 = 0. Whatever the
// force, noise dominates slow motion at the wall; under noise the cells of x1 are graded as the
// cube of those of x2 (x1_grading). The long reach in both directions limits the relative
// difference of neighbouring cell widths to a fifth.
struct WallGradings {
  Grading x1, x2;
};
WallGradings wall_gradings(const problem::Problem& problem, const Options& options, double factor,
                           const LengthScales& lengths) {
  if (factor == 1) return {};
  const auto of = [&](double length) {
    return Grading{.reach = kLongReach * length, .core = kLongReach * length / (factor - 1)};
  };
  WallGradings gradings{.x1 = of(lengths.x1), .x2 = of(lengths.x2)};
  const double diffusion = diffusion_coefficient(problem, options.equation);
  if (diffusion > 0 && can_grade_cubically(options)) {
    gradings.x1.core = std::min(gradings.x1.core, std::pow(gradings.x2.core, 3) / diffusion);
  }
  return gradings;
}

// The automatic value of origin_refinement() outside the paper's class.
double automatic_refinement_at_walls(const problem::Problem& problem, const Options& options) {
  if (!has_dissipative_impacts(problem.system.left_wall()) &&
      !has_dissipative_impacts(problem.system.right_wall()))
    return 1;
  const bool singular = diffusion_coefficient(problem, options.equation) > 0;
  return singular ? kOriginRefinementUnderWhiteNoise : kOriginRefinement;
}

// Faces of an axis between the walls or the ends of the box. If `cells` is given, the axis has this
// number of cells.
std::vector<double> faces_between_walls(const problem::System& system, const Box& box, double step,
                                        const Grading& grading, std::optional<int> cells) {
  std::vector<RefinementPoint> refinement_points;
  if (grading.reach > 0 && has_dissipative_impacts(system.left_wall()))
    refinement_points.push_back({box.x1_min, grading});
  if (grading.reach > 0 && has_dissipative_impacts(system.right_wall()))
    refinement_points.push_back({box.x1_max, grading});
  if (cells) {
    double all = box.x1_max - box.x1_min;
    for (std::size_t n = 0; n < refinement_points.size(); ++n) {
      all += graded_cell_count(box.x1_max - box.x1_min, 1, grading) - (box.x1_max - box.x1_min);
    }
    step = all / *cells * (1 + 1e-12);
  }
  return faces_graded_to_points(box.x1_min, box.x1_max, step, refinement_points);
}

Discretisation discretise_general(const problem::Problem& problem, const Options& options,
                                  const Box& box) {
  const problem::System& system = problem.system;
  const double at_walls = origin_refinement(problem, options);
  const WallGradings gradings = wall_gradings(problem, options, at_walls, box.lengths);
  double width = (at_walls == 1 ? 1 : kGradedWidth) / options.refinement;
  if (transport_order(options) == kHighOrder) width *= kHighOrderWidthFactor;
  const double total_length = box.x1_max - box.x1_min;
  const double about = options.nx ? *options.nx
                                  : cell_count(total_length, width * kX1Step * box.lengths.x1, {},
                                               options.refinement);
  const double step = total_length / about;
  const double nv = options.nv ? *options.nv
                               : 2 * cell_count(box.x2_max, width * kX2Step * box.lengths.x2,
                                                gradings.x2, options.refinement);
  std::string failure = grid_failure_reason(problem, options, box, about, nv);
  std::vector<double> faces;
  if (failure.empty()) {
    faces = faces_between_walls(system, box, step, gradings.x1, options.nx);
    failure = grid_failure_reason(problem, options, box, static_cast<double>(faces.size() - 1), nv);
  }
  if (!failure.empty()) return failed_discretisation(box, std::move(failure), about * nv);
  Grid grid = symmetric_grid(std::move(faces),
                             graded_faces(box.x2_max, static_cast<int>(nv) / 2, gradings.x2),
                             system.left_wall() ? EndCondition::boundary : EndCondition::vacuum,
                             system.right_wall() ? EndCondition::boundary : EndCondition::vacuum);
  const double length = regularisation_length(problem, options, grid.x2);
  Excitation terms = excitation(problem, options, grid.x2, length);
  const double cells = grid.size();
  return {.grid = std::move(grid),
          .excitation = std::move(terms),
          .regularisation_length = length,
          .failure = "",
          .cells = cells};
}

}  // namespace

bool has_dissipative_impacts(const std::optional<problem::Wall>& wall) {
  constexpr double kSmallJump = 0.1;
  return wall && 1 / (wall->restitution * wall->restitution) - 1 > kSmallJump;
}

LengthScales fisher_length_scales(const Grid& grid, const Eigen::VectorXd& averages,
                                  const problem::MotionScales& scales) {
  // fraction of the peak, below which densities may be numerical errors
  constexpr double kFaint = 1e-3;
  constexpr double kShortest = 0.25;  // minimum length scale, in standard deviations
  // maximum number of length scales along the axis, since a long tail is smooth
  constexpr double kMost = 25;
  const Eigen::Index nx = grid.nx(), nv = grid.nv();
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
        of_x1 += area * slope(p, averages((i + 1) * nv + j),
                              grid.x1.cell_centre(x1 + 1) - grid.x1.cell_centre(x1));
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

Box initial_box(const problem::Problem& problem, const Options& options) {
  return initial_box(problem, problem::scales(problem), options);
}

Box initial_box(const problem::Problem& problem, const problem::MotionScales& scales,
                const Options& options) {
  const auto& law = problem.impulses.law();
  if (!problem::is_paper_oscillator(problem)) {
    const problem::System& system = problem.system;
    Box box{
        .x1_max = options.x1_max.value_or(scales.y_high),
        .x2_max = options.x2_max.value_or(std::max(
            scales.v_high, problem.impulses.is_present()
                               ? std::abs(law.moment(1)) + kImpulseBoxDeviations * law.deviation()
                               : 0)),
        .x1_min = options.x1_max ? -*options.x1_max : scales.y_low,
        .lengths = {scales.displacement_deviation, scales.velocity_deviation}};
    if (system.left_wall()) box.x1_min = system.left_wall()->position;
    if (system.right_wall()) box.x1_max = system.right_wall()->position;
    return box;
  }
  return {options.x1_max.value_or(scales.centre + kX1BoxDeviations * scales.displacement_deviation),
          options.x2_max.value_or(
              std::max(kX2BoxDeviations * scales.velocity_deviation,
                       std::abs(law.moment(1)) + kImpulseBoxDeviations * law.deviation()))};
}

bool is_unbounded_at_origin(const problem::Problem& problem) {
  if (!problem::is_paper_oscillator(problem)) return false;
  return problem::impulses_per_decay_time(problem) <= 2;
}

bool has_rare_impacts_by_mean_impulse(const problem::Problem& problem) {
  constexpr double kDeviations = 4;
  return problem::static_deflection(problem) >
         kDeviations * problem::equivalent_linearisation(problem).displacement_deviation;
}

int automatic_order(const problem::Problem& problem) {
  const bool smooth = !has_dissipative_impacts(problem.system.left_wall()) &&
                      !has_dissipative_impacts(problem.system.right_wall());
  return smooth && !problem::is_paper_oscillator(problem) ? kHighOrder : kDefaultOrder;
}

double origin_refinement(const problem::Problem& problem, const Options& options) {
  if (!problem::is_paper_oscillator(problem)) {
    return options.origin_refinement.value_or(automatic_refinement_at_walls(problem, options));
  }
  constexpr double kSmallJump = 0.1;
  const double r = problem.system.restitution();
  const bool jumps = 1 / (r * r) - 1 > kSmallJump;
  // Schemes of high order oscillate on narrow cells at the spike that rare impulses cause; a wide
  // cell represents the spike as a mass. Under white noise the density has no spike.
  const bool singular = can_resolve_wall_singularity(problem, options);
  const bool narrow = jumps && !has_rare_impacts_by_mean_impulse(problem) &&
                      (singular || !is_unbounded_at_origin(problem));
  return options.origin_refinement.value_or(!narrow    ? 1
                                            : singular ? kOriginRefinementUnderWhiteNoise
                                                       : kOriginRefinement);
}

BoxExtension extend_box(const problem::Problem& problem, const Options& options, const Grid& grid,
                        double factor_x1, double factor_x2) {
  const auto [of_x1, of_x2] = gradings(problem, options);
  const int nx = grid.nx(), half = grid.nv() / 2;
  const int more_x1 = additional_cells(nx, grid.x1_max(), factor_x1, of_x1);
  const int more_x2 = additional_cells(half, grid.x2_max(), factor_x2, of_x2);
  return {.box = {.x1_max = extended_axis_end(more_x1, nx, grid.x1_max(), of_x1),
                  .x2_max = extended_axis_end(more_x2, half, grid.x2_max(), of_x2)},
          .nx = nx + more_x1,
          .nv = 2 * (half + more_x2)};
}

Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box) {
  if (!problem::is_paper_oscillator(problem)) return discretise_general(problem, options, box);
  const auto linear = problem::equivalent_linearisation(problem);
  const auto [of_x1, of_x2] = gradings(problem, options);
  const double width =
      (origin_refinement(problem, options) == 1 ? 1 : kGradedWidth) / options.refinement;
  // value_or() would convert the double to int
  const double nx = options.nx
                        ? *options.nx
                        : cell_count(box.x1_max, width * kX1Step * linear.displacement_deviation,
                                     of_x1, options.refinement);
  const double nv = options.nv
                        ? *options.nv
                        : 2 * cell_count(box.x2_max, width * kX2Step * linear.velocity_deviation,
                                         of_x2, options.refinement);
  std::string failure = grid_failure_reason(problem, options, box, nx, nv);
  if (!failure.empty()) return failed_discretisation(box, std::move(failure), nx * nv);
  Grid grid =
      make_grid(static_cast<int>(nx), static_cast<int>(nv), box.x1_max, box.x2_max, of_x1, of_x2);
  const double length = regularisation_length(problem, options, grid.x2);
  Excitation terms = excitation(problem, options, grid.x2, length);
  const double cells = grid.size();
  return {.grid = std::move(grid),
          .excitation = std::move(terms),
          .regularisation_length = length,
          .failure = "",
          .cells = cells};
}

FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem, const Options& options,
                                            const Discretisation& on) {
  return fokker_planck_operator(problem.system, on.excitation, options.impact, on.grid,
                                transport_order(options));
}

ExcitationWithoutWalls excitation_without_walls(const problem::Problem& problem,
                                                const Options& options, double cell_width) {
  const int points = centred_stencil_size(transport_order(options));
  const double length =
      regularisation_length(problem, options, Axis::with_uniform_cells(0, cell_width, 1));
  int reach = stencil_half_width(length, cell_width, points);
  if (options.equation == Equation::km4_pade) {
    // The kernel of the inverse in the Pade approximant decays as exp(-|x2| / sqrt(b)).
    reach += static_cast<int>(
        std::ceil(kPadeReach * std::sqrt(pade_length_squared(problem.impulses)) / cell_width));
  }
  Axis axis = Axis::with_uniform_cells(0, cell_width, 2 * reach + 1);
  Excitation terms = excitation(problem, options, axis, length);
  return {std::move(axis), std::move(terms)};
}

}  // namespace fpkcheck::fd_fpk
