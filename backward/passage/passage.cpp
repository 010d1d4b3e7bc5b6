#include "backward/passage/passage.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "backward/passage/reduced_passage_model.hpp"
#include "backward/passage/renewal_equation.hpp"
#include "backward/passage/stationary_crossings.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/effective_potential.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

using transform::FirstPassageResult;
using transform::Status;
using transform::ValueWithError;

// The problem below the barrier, in wall coordinates.
struct FirstPassageProblem {
  const problem::Problem& problem;
  double frequency;  // of the motion (problem::MotionScales)
  ChebyshevGrid::Domain domain;
  PhaseState state;  // initial state; without an initial state, a state at half of the barrier
};

// Values on one grid: the quantities of PassageValueIndex, then the survival probabilities from the
// initial state at all times
using PassageValues = Eigen::VectorXd;
enum PassageValueIndex { kHazard, kMeanFromPoint, kPassageValueCount };

std::string passage_unsupported_reason(const problem::Problem& problem, double barrier) {
  if (problem.noise.is_acting()) {
    return "noise acts between impulses, and the motion is not deterministic; use fd or mcs";
  }
  if (problem.impulse_factor) {
    return "the renewal equation needs impulses without a factor; use fd or mcs";
  }
  if (!problem.impulses.amplitude_law().amplitude_atoms().empty()) {
    return "means over an impulse are smooth functions only for a law with a density; use fd or mcs";
  }
  if (!problem.system.has_polynomial_force()) {
    return "the Taylor series of the motion need a polynomial force; use fd or mcs";
  }
  if (!problem.system.left_wall() && barrier <= problem::motion_scales(problem).y_low) {
    return "the stationary probability below the barrier is negligible";
  }
  return problem::barrier_unsupported_reason(problem, barrier);
}

// Returns the problem with a domain that contains the motion before the barrier and from the
// initial state. The largest impulse widens the range of velocities.
FirstPassageProblem make_passage_problem(const problem::Problem& problem, double barrier,
                                         const std::optional<transform::PassageStartState>& start) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const problem::EffectivePotential potential(problem.system);
  const auto& wall = problem.system.left_wall();
  double y_low = wall ? wall->position : scales.y_low;
  double lowest = potential(barrier), highest = lowest;
  const auto include = [&](double y) {
    lowest = std::min(lowest, potential(y));
    highest = std::max(highest, potential(y));
  };
  for (const double y : potential.extremum_positions()) {
    if (y < barrier) include(y);
  }
  if (wall) include(wall->position);
  if (start) {
    include(start->y);
    highest = std::max(highest, start->ydot * start->ydot / 2 + potential(start->y));
  }
  // Without a wall the potential rises on the left.
  constexpr double kStep = 0.1;
  while (!wall && potential(y_low) < highest) y_low -= kStep * scales.displacement_deviation;
  double speed = std::sqrt(2 * (highest - lowest));
  const auto [most_negative, most_positive] =
      effective_amplitude_range(problem.impulses.amplitude_law());
  const UnforcedMotionSolver motion(problem.system, barrier, barrier - y_low,
                                    std::max(speed, scales.v_high), 1);
  if (motion.acceleration({barrier, 0}) < 0) {
    // Traced backward in time, the trajectory that grazes the barrier reaches the barrier within
    // about one period.
    constexpr double kPeriods = 3, kMaxSpeedRatio = 10;
    const double max_speed = kMaxSpeedRatio * std::max(scales.v_high, speed);
    speed = std::max(
        speed,
        std::min(max_speed,
                 motion.find_largest_backward_speed(
                     {barrier, 0}, kPeriods * 2 * std::numbers::pi / scales.frequency, max_speed)));
  }
  return {
      .problem = problem,
      .frequency = scales.frequency,
      .domain = {y_low, barrier, speed + std::max(-most_negative, most_positive)},
      .state = start ? PhaseState{start->y, start->ydot} : PhaseState{(y_low + barrier) / 2, 0}};
}

// Returns the numbers of nodes in y and in v for a number of nodes in v per standard deviation of
// the amplitude. The number of nodes in y is the number in v for the speed of a motion through the
// domain, plus kMinDeviations standard deviations for the cusp of h at rest on the wall. The mean
// time from rest of case 1 (barrier 1.5, 114.27394) differs from the mean time with kMinDeviations
// = 10 by 6e-6 with kMinDeviations = 2, and by 1e-6 with 4.
std::array<double, 2> choose_node_counts(const FirstPassageProblem& passage,
                                         const ChebyshevGrid::Domain& domain,
                                         double nodes_per_deviation) {
  constexpr double kMinDeviations = 4;
  const double deviation = passage.problem.impulses.amplitude_law().amplitude_standard_deviation();
  const double speed = passage.frequency * (domain.y_high - domain.y_low);
  return {std::ceil(nodes_per_deviation * (kMinDeviations + speed / deviation)),
          std::ceil(nodes_per_deviation * 2 * domain.v_max / deviation)};
}

// Stationary laws on two grids, whose difference is the error of the law
struct StationaryCrossingsOnTwoGrids {
  StationaryCrossings finer, coarser;
};

// Indices of two functions in the basis of the reduced model
constexpr std::size_t kMeanFunction = 1, kHalfMeanSquareFunction = 2;

// The error of a value is this factor times the difference of the values on consecutive grids,
// which have 1.25 times as many nodes in each direction. The factor is that of convergence of first
// order, as under laws whose density jumps.
constexpr double kNodeRatio = 1.25, kErrorFactor = 1 / (kNodeRatio - 1);
// Refinement of the panels for one node per standard deviation. Twice as many panels change the
// mean time of case 1 by a relative 1e-8.
constexpr double kPanelRefinement = 0.3;
// The dense matrices for this number of nodes take about 1 GB.
constexpr double kMaxNodes = 5000;

// Returns the errors of values from their changes by the last two grids. With the ratio q of the
// changes, the changes by all further grids have the sum q / (1 - q) times the last change. The
// factor is at least 1, since the ratio may increase, and at most that of first order. A change of
// sign makes a single change small by chance; the last change counts as at least a thirtieth of the
// change before, less than the ratio of any value in the table of docs/functionals.md.
Eigen::VectorXd errors_from_changes(const Eigen::VectorXd& change,
                                    const Eigen::VectorXd& previous_change) {
  Eigen::VectorXd errors(change.size());
  for (Eigen::Index k = 0; k < errors.size(); ++k) {
    constexpr double kLeastRatio = 1.0 / 30;
    const double previous = previous_change(k), last = std::max(change(k), kLeastRatio * previous);
    const double factor = previous > last ? last / (previous - last) : kErrorFactor;
    errors(k) = last * std::clamp(factor, 1.0, kErrorFactor);
  }
  return errors;
}

ValueWithError estimate_from_grids(double finer, double coarser) {
  return {finer, kErrorFactor * std::abs(finer - coarser)};
}

// Computes the crossings of the barrier in the stationary process until the relative errors of
// their rate and of the probability below the barrier are below `tolerance`. The result is empty if
// the error is larger when the deadline passes, or with the largest number of nodes.
std::optional<StationaryCrossingsOnTwoGrids> solve_stationary_laws(
    const FirstPassageProblem& passage, double tolerance, const base::Deadline& deadline) {
  if (passage.problem.system.right_wall()) return std::nullopt;
  // Nodes per standard deviation of the amplitude on the first grid. In case 1 (barrier 2) the
  // errors of the rates on the grids with 0.95 and 1.19 nodes exceed the default tolerance, and
  // those on the grids with 1 and 1.25 nodes do not.
  constexpr double kFirstNodes = 1;
  // The nodes cover this fraction of the intervals of y and v in which the stationary density
  // exceeds exp(-7^2/2) times its peak. Outside the nodes, interpolated functions are constant.
  constexpr double kFraction = 0.85, kMinDeviationsBeyond = 2;
  const problem::MotionScales scales = problem::motion_scales(passage.problem);
  const double barrier = passage.domain.y_high;
  const ChebyshevGrid::Domain domain{
      .y_low = std::min(passage.domain.y_low, scales.y_low),
      .y_high = std::max(std::lerp(scales.centre, scales.y_high, kFraction),
                         barrier + kMinDeviationsBeyond * scales.displacement_deviation),
      .v_max = std::max(passage.domain.v_max, kFraction * scales.v_high),
      .ends_at_barrier = false};
  // The computing time of a grid increases with about the fourth power of the number of nodes in
  // each direction. In case 1 the error of the crossings decreases by the factor kErrorRatio or
  // more from grid to grid.
  const double growth = std::pow(kNodeRatio, 4);
  constexpr double kErrorRatio = 8;
  std::optional<StationaryCrossings> last;
  double seconds_to_tolerance = 0;
  for (double nodes = kFirstNodes;; nodes *= kNodeRatio) {
    const auto [n_y, n_v] = choose_node_counts(passage, domain, nodes);
    if (n_y * n_v > kMaxNodes || !deadline.has_time_for(seconds_to_tolerance)) return std::nullopt;
    const base::Stopwatch stopwatch;
    const ChebyshevGrid grid(domain, static_cast<int>(n_y), static_cast<int>(n_v));
    auto crossings = compute_stationary_crossings(passage.problem, grid, barrier,
                                                  kPanelRefinement * nodes, deadline);
    if (!crossings || !crossings->rates.allFinite()) return std::nullopt;
    double grids_to_tolerance = 1;
    if (last) {
      const auto relative_error = [](double finer, double coarser) {
        return estimate_from_grids(finer, coarser).error / std::abs(finer);
      };
      const double error =
          std::max(relative_error(crossings->rates.sum(), last->rates.sum()),
                   relative_error(crossings->probability_below, last->probability_below));
      if (error <= tolerance) return StationaryCrossingsOnTwoGrids{*crossings, *last};
      grids_to_tolerance = std::ceil(std::log(error / tolerance) / std::log(kErrorRatio));
    }
    seconds_to_tolerance = stopwatch.seconds() * std::pow(growth, grids_to_tolerance);
    last = std::move(crossings);
  }
}

// Solver of the renewal equation on one grid
class PassageSolverOnGrid {
 public:
  PassageSolverOnGrid(const FirstPassageProblem& passage, const ChebyshevGrid& grid,
                      double panel_refinement, double hazard)
      : state_(passage.state),
        barrier_(passage.domain.y_high),
        slowest_decay_rate_(problem::motion_scales(passage.problem).slowest_decay_rate),
        rate_(passage.problem.impulses.arrival_rate()),
        hazard_(hazard),
        node_count_(grid.node_count()),
        equation_(passage.problem, grid, rate_ - hazard, panel_refinement),
        model_(grid.node_count(), 1) {}

  // Computes hazard, mean time and survival probabilities from the initial state. The result is
  // empty if the deadline passes.
  // @param[in,out] times times of the survival probabilities; if empty, automatic times
  // @param tolerance error of the survival probabilities due to the reduced model
  std::optional<PassageValues> solve(std::vector<double>& times, double tolerance,
                                     const base::Deadline& deadline);

  // Errors of the reduced model, which do not follow from the values on two grids
  const PassageValues& model_errors() const { return model_errors_; }

  // Computes the mean time from the stationary start, then its survival probabilities.
  // @param omitted_count number of the last functions that the reduced model omits
  // @pre solve() has returned values
  Eigen::VectorXd solve_from_stationary(const StationaryCrossings& law,
                                        const std::vector<double>& times,
                                        std::size_t omitted_count = 0) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factorise(Eigen::MatrixXd& matrix) const {
    matrix *= -rate_;
    matrix.diagonal().array() += 1;
    return Eigen::PartialPivLU<Eigen::MatrixXd>(matrix);
  }
  // Returns the value at a state of the basis function with the given index.
  double evaluate_basis_function(std::size_t index, const PhaseState& state) const;
  // Adds a function to the basis of the reduced model. Returns the value of the function at the
  // initial state.
  double add_to_model(ReducedOrderPassageModel::BasisFunction function);
  PassageValues survival_probabilities(const std::vector<double>& times) const;

  PhaseState state_;  // initial state
  double barrier_, slowest_decay_rate_, rate_, hazard_;
  Eigen::Index node_count_;
  RenewalEquation equation_;
  ReducedOrderPassageModel model_;  // its functional is the value at the initial state
  // The slowest mode, the mean time, half of the mean square time, and further Laplace transforms
  std::vector<ReducedOrderPassageModel::BasisFunction> basis_;
  PassageValues model_errors_;
};

// Functions of the basis except half of the mean square T2 are solutions u of L u = shift u -
// source. The mean h2 of T2 over an impulse satisfies h2 = B (1 + lambda h) + lambda A h2, where B
// has the weight t exp(-lambda t).
double PassageSolverOnGrid::evaluate_basis_function(std::size_t index,
                                                    const PhaseState& state) const {
  const ReducedOrderPassageModel::BasisFunction& function = basis_[index];
  const auto once = equation_.integrate_from_state(state, {rate_ + function.shift});
  const double value =
      function.source * once.integral_of_one + rate_ * once.node_weights.dot(function.node_values);
  if (!function.has_previous) return value;
  const auto twice = equation_.integrate_from_state(state, {rate_, 1});
  return value + twice.integral_of_one +
         rate_ * twice.node_weights.dot(basis_[index - 1].node_values);
}

double PassageSolverOnGrid::add_to_model(ReducedOrderPassageModel::BasisFunction function) {
  basis_.push_back(std::move(function));
  basis_.back().functionals =
      Eigen::VectorXd::Constant(1, evaluate_basis_function(basis_.size() - 1, state_));
  model_.add_basis_function(basis_.back());
  return basis_.back().functionals(0);
}

PassageValues PassageSolverOnGrid::survival_probabilities(const std::vector<double>& times) const {
  const ReducedOrderPassageModel::Modes modes = model_.compute_modes();
  PassageValues values(static_cast<Eigen::Index>(times.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const double t = times[static_cast<std::size_t>(k)];
    const Eigen::VectorXcd decayed = (t * modes.rates).array().exp();
    const double sum = (modes.coefficients * decayed)(0).real();
    values(k) = t == 0 ? 1 : std::clamp(sum, 0.0, 1.0);
  }
  return values;
}

// A stay below the barrier has the length l. With the rate nu of downcrossings the stationary start
// has the survival probability E(l - t)^+ / E l, which is the integral of nu P(l > t) from t to
// infinity, divided by its value for t = 0.
Eigen::VectorXd PassageSolverOnGrid::solve_from_stationary(const StationaryCrossings& law,
                                                           const std::vector<double>& times,
                                                           std::size_t omitted_count) const {
  // The functional is the mean over the downcrossings, in units of their rate.
  ReducedOrderPassageModel model(node_count_, 1);
  std::vector<double> functionals;
  for (std::size_t k = 0; k + omitted_count < basis_.size(); ++k) {
    double sum = 0;
    for (std::size_t m = 0; m < law.velocities.size(); ++m) {
      sum += law.rates(static_cast<Eigen::Index>(m)) *
             evaluate_basis_function(k, {barrier_, law.velocities[m]});
    }
    functionals.push_back(sum);
    ReducedOrderPassageModel::BasisFunction function = basis_[k];
    function.functionals = Eigen::VectorXd::Constant(1, sum);
    model.add_basis_function(function);
  }
  const ReducedOrderPassageModel::Modes modes = model.compute_modes();
  const Eigen::VectorXcd coefficients =
      (modes.coefficients.row(0).array() / -modes.rates.transpose().array());
  Eigen::VectorXd values(static_cast<Eigen::Index>(times.size()) + 1);
  // E[tau] = E[l^2] / (2 E[l])
  values(0) = functionals[kHalfMeanSquareFunction] / functionals[kMeanFunction];
  for (Eigen::Index k = 1; k < values.size(); ++k) {
    const Eigen::VectorXcd decayed =
        (times[static_cast<std::size_t>(k - 1)] * modes.rates).array().exp();
    values(k) = coefficients.cwiseProduct(decayed).sum().real() / coefficients.sum().real();
  }
  return values;
}

std::optional<PassageValues> PassageSolverOnGrid::solve(std::vector<double>& times,
                                                        double tolerance,
                                                        const base::Deadline& deadline) {
  auto operators = equation_.compute_operators(
      {{rate_}, {rate_, 1}, {rate_ - hazard_}, {rate_ - hazard_, 1}}, deadline);
  if (operators.empty()) return std::nullopt;
  const auto lu_of_mean = factorise(operators[0].matrix);
  const Eigen::VectorXd h = lu_of_mean.solve(operators[0].values_of_one);
  // Inverse iteration for the eigenvalue of lambda A that is nearest to 1, and for its right and
  // left eigenvectors
  const auto lu = factorise(operators[2].matrix);
  constexpr int kIterations = 8;
  Eigen::VectorXd right = h, left = Eigen::VectorXd::Ones(node_count_);
  double distance = 0;  // distance of the eigenvalue from 1
  for (int n = 0; n < kIterations; ++n) {
    const Eigen::VectorXd next = lu.solve(right);
    distance = left.dot(right) / left.dot(next);
    right = next.normalized();
    left = lu.transpose().solve(left).normalized();
  }
  const double slope = rate_ * left.dot(operators[3].matrix * right) / left.dot(right);
  PassageValues values = PassageValues::Zero(kPassageValueCount);
  values(kHazard) = hazard_ + distance / slope;
  add_to_model({.node_values = right, .functionals = {}, .shift = -values(kHazard), .source = 0});
  values(kMeanFromPoint) = add_to_model({.node_values = h, .functionals = {}});
  // The derivative of the Laplace transform at 0 is -T2, where L T2 = -T and E tau^2 = 2 T2.
  const Eigen::VectorXd h2 =
      lu_of_mean.solve(operators[1].values_of_one + rate_ * (operators[1].matrix * h));
  add_to_model({.node_values = h2, .functionals = {}, .source = 0, .has_previous = true});
  if (times.empty()) times = transform::automatic_survival_times(values(kMeanFromPoint));

  // Shifts of further Laplace transforms, in units of the slowest decay rate. From a stationary
  // start, and after a few times the longest relaxation time from any start, few shifts suffice. At
  // short times the inversion of Laplace transforms at real shifts is inaccurate.
  // One pass along all trajectories computes the operators of several shifts.
  const std::array<std::vector<double>, 2> kShifts{{{2, 8, 0.5}, {32, 128, 4, 16}}};
  operators.clear();  // limits the memory
  PassageValues survival = survival_probabilities(times);
  PassageValues last_change = PassageValues::Constant(survival.size(), HUGE_VAL),
                change = last_change;
  const auto is_converged = [&] { return change.cwiseMax(last_change).maxCoeff() <= tolerance; };
  for (const std::vector<double>& factors : kShifts) {
    if (is_converged()) break;
    std::vector<TimeSinceImpulseWeight> weights;
    for (const double factor : factors) weights.push_back({rate_ + factor * slowest_decay_rate_});
    auto shifted = equation_.compute_operators(weights, deadline);
    if (shifted.empty()) return std::nullopt;
    for (std::size_t k = 0; k < shifted.size() && !is_converged(); ++k) {
      add_to_model({.node_values = factorise(shifted[k].matrix).solve(shifted[k].values_of_one),
                    .functionals = {},
                    .shift = weights[k].decay_rate - rate_});
      const PassageValues next = survival_probabilities(times);
      last_change = change;
      change = (next - survival).cwiseAbs();
      survival = next;
    }
  }
  values.conservativeResize(kPassageValueCount + survival.size());
  values.tail(survival.size()) = survival;
  model_errors_ = PassageValues::Zero(values.size());
  model_errors_.tail(survival.size()) = kErrorFactor * change.cwiseMax(last_change);
  return values;
}

// Values of the stationary start: the mean time, then the survival probabilities
struct StationaryStartValues {
  StationaryCrossingsOnTwoGrids laws;
  Eigen::VectorXd values, errors;
};

// Computes the values of the stationary start with the solvers on the last two grids. The result is
// empty if there is no accurate stationary law before the deadline.
std::optional<StationaryStartValues> solve_stationary_start(const FirstPassageProblem& passage,
                                                            const PassageSolverOnGrid& finer,
                                                            const PassageSolverOnGrid& coarser,
                                                            const std::vector<double>& times,
                                                            double tolerance,
                                                            const base::Deadline& deadline) {
  auto laws = solve_stationary_laws(passage, tolerance, deadline);
  if (!laws) return std::nullopt;
  const Eigen::VectorXd values = finer.solve_from_stationary(laws->finer, times);
  const auto distance_from = [&](const Eigen::VectorXd& other) -> Eigen::VectorXd {
    return (values - other).cwiseAbs();
  };
  Eigen::VectorXd errors =
      kErrorFactor * (distance_from(coarser.solve_from_stationary(laws->finer, times)) +
                      distance_from(finer.solve_from_stationary(laws->coarser, times)));
  // The reduced model: its changes by the last function and by the last two functions
  errors += distance_from(finer.solve_from_stationary(laws->finer, times, 1))
                .cwiseMax(distance_from(finer.solve_from_stationary(laws->finer, times, 2)));
  return StationaryStartValues{std::move(*laws), values, errors};
}

}  // namespace

FirstPassageResult solve_passage(const problem::Problem& problem, PassageCollocationOptions options,
                                 double barrier, std::vector<double> times,
                                 std::optional<transform::PassageStartState> start) {
  const base::Stopwatch stopwatch;
  const base::Deadline deadline(options.max_seconds);
  FirstPassageResult passage{.id = "characteristics"};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const double wall_barrier = transformed.frame.wall_coordinate(barrier);
  passage.reason = passage_unsupported_reason(transformed, wall_barrier);
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  start = transform::passage_start_state(transformed, wall_barrier, start);
  const FirstPassageProblem below = make_passage_problem(transformed, wall_barrier, start);

  // Nodes per standard deviation of the amplitude on the first grid
  constexpr double kFirstNodes = 0.96;
  // The grids are refined until the error is a fraction of the required accuracy, since the errors
  // decrease quickly, but for at most half of the time limit once the required accuracy is reached.
  // The other half is for the stationary law, whose errors decrease more slowly.
  constexpr double kTargetFraction = 0.01, kTargetFractionOfLaw = 0.5, kTimeFraction = 0.5;
  std::optional<PassageValues> last;
  PassageValues change, errors, model_errors;
  std::unique_ptr<PassageSolverOnGrid> last_solver, previous_solver;
  std::string limit;
  double seconds_of_last_grid = 0;
  const double rate = transformed.impulses.arrival_rate();
  double hazard = 0;
  // Errors are relative, and absolute for survival probabilities. More nodes do not reduce an error
  // of a survival probability that is due to the reduced model.
  const double target = kTargetFraction * options.accuracy;
  const auto largest_error = [&](const PassageValues& of, double max_model_error) {
    double largest = 0;
    for (Eigen::Index k = 0; k < of.size(); ++k) {
      const bool is_relative = k < kPassageValueCount;
      const double magnitude =
          is_relative ? std::max(std::abs((*last)(k)), std::numeric_limits<double>::min()) : 1;
      if (is_relative || model_errors(k) <= max_model_error) {
        largest = std::max(largest, of(k) / magnitude);
      }
    }
    return largest;
  };
  options.omits_inaccurate_times |= times.empty();
  for (double nodes = kFirstNodes; errors.size() == 0 || largest_error(errors, target) > target;
       nodes *= kNodeRatio) {
    const auto [n_y, n_v] = choose_node_counts(below, below.domain, nodes);
    if (n_y * n_v > kMaxNodes) {
      limit = fmt::format("more than {} nodes are needed", kMaxNodes);
      break;
    }
    const ChebyshevGrid grid(below.domain, static_cast<int>(n_y), static_cast<int>(n_v));
    // The number of nodes grows by the factor kNodeRatio^2, and the computing time of the integrals
    // along all trajectories by kNodeRatio^5.
    const double growth = std::pow(kNodeRatio, 5);
    const base::Stopwatch grid_stopwatch;
    if (errors.size() != 0 && largest_error(errors, target) <= options.accuracy &&
        stopwatch.seconds() + growth * seconds_of_last_grid > kTimeFraction * options.max_seconds) {
      break;
    }
    auto solver =
        std::make_unique<PassageSolverOnGrid>(below, grid, kPanelRefinement * nodes, hazard);
    std::optional<PassageValues> values;
    if (deadline.has_time_for(growth * seconds_of_last_grid)) {
      values = solver->solve(times, target, deadline);
    }
    if (!values) {
      limit = fmt::format("the time limit of {:g} s is reached; raise --max-seconds",
                          options.max_seconds);
      break;
    }
    if (!values->allFinite()) {
      limit = "the renewal equation has no finite solution; use mcs";
      break;
    }
    seconds_of_last_grid = grid_stopwatch.seconds();
    if (last) {
      const PassageValues next_change = (*values - *last).cwiseAbs();
      errors = change.size() == 0 ? PassageValues(kErrorFactor * next_change)
                                  : PassageValues(errors_from_changes(next_change, change));
      change = next_change;
    }
    last = values;
    model_errors = solver->model_errors();
    previous_solver = std::exchange(last_solver, std::move(solver));
    // The next grid continues Newton's method for the hazard. The limit (hazard + rate) / 2
    // shortens a step that would exceed the rate of the impulses.
    hazard = std::clamp((*values)(kHazard), 0.0, (hazard + rate) / 2);
    passage.details = fmt::format("{} x {} nodes", grid.y_node_count(), grid.v_node_count());
  }
  passage.seconds = stopwatch.seconds();
  if (errors.size() == 0) {
    passage.reason = limit;
    return passage;
  }
  const double found = (*last)(kHazard);
  if (!(found > 0 && found < rate)) {
    passage.reason = fmt::format(
        "the hazard {:.3g} is not between 0 and the rate {:g} of impulses: the nodes are too few, or "
        "the motion passes the barrier without an impulse; use fd or mcs",
        found, rate);
    return passage;
  }
  const PassageValues total_errors = errors + model_errors;
  const auto value_at = [&](Eigen::Index k) { return ValueWithError{(*last)(k), total_errors(k)}; };
  passage.hazard = value_at(kHazard);
  if (start) passage.mean_from_point = value_at(kMeanFromPoint);
  double error = largest_error(total_errors.head(kPassageValueCount), HUGE_VAL);
  const auto stationary = solve_stationary_start(below, *last_solver, *previous_solver, times,
                                                 kTargetFractionOfLaw * options.accuracy, deadline);
  const auto stationary_value_at = [&](Eigen::Index k) {
    return ValueWithError{stationary->values(k), stationary->errors(k)};
  };
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto n = static_cast<Eigen::Index>(k);
    std::optional<ValueWithError> from_point, from_stationary;
    if (start) from_point = value_at(kPassageValueCount + n);
    if (stationary) from_stationary = stationary_value_at(n + 1);
    const double error_at_time =
        std::max(from_point ? from_point->error : 0, from_stationary ? from_stationary->error : 0);
    if (options.omits_inaccurate_times && error_at_time > options.accuracy) continue;
    error = std::max(error, error_at_time);
    passage.times.push_back(times[k]);
    if (from_point) passage.survival_from_point.push_back(*from_point);
    if (from_stationary) passage.survival_from_stationary.push_back(*from_stationary);
  }
  if (stationary) {
    const auto& [finer, coarser] = stationary->laws;
    passage.mean_from_stationary = stationary_value_at(0);
    error =
        std::max(error, passage.mean_from_stationary->error / passage.mean_from_stationary->value);
    passage.rice_rate = estimate_from_grids(finer.rates.sum(), coarser.rates.sum());
    passage.probability_below =
        estimate_from_grids(finer.probability_below, coarser.probability_below);
  } else {
    passage.details += transformed.system.right_wall()
                           ? ", no stationary law with a wall beyond the barrier"
                           : ", no accurate stationary law within the time limit";
  }
  passage.seconds = stopwatch.seconds();
  passage.status = Status::ok;
  if (!(error <= options.accuracy)) {
    passage.status = Status::inaccurate;
    passage.reason = fmt::format(
        "estimated relative error {:.2g}, above the accuracy {:g}; {}", error, options.accuracy,
        limit.empty() ? "raise --max-seconds, or use fd or mcs for short times" : limit);
  }
  return passage;
}

}  // namespace fpkcheck::backward
