#include "fd_fpk/kramers_moyal_regularisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/input_error.hpp"
#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Largest number of cells for which the whole matrix of the operator is factored. The dense matrix
// of the velocity jumps fills the LU factors, and KLU takes minutes for a larger number of cells.
constexpr int kMostCellsFactored = 5000;
// An operator counts as unstable if the real part of its rightmost eigenvalue, in units of
// sqrt(k_eq), exceeds this threshold.
constexpr double kUnstableRate = 1e-7;

struct KramersMoyalRegularisation {
  const char* name;
  DensityEquation equation;
  std::function<double(double step)> length;
};

std::vector<KramersMoyalRegularisation> regularisation_schemes(double default_length,
                                                               double shortest_length) {
  return {{"literal", DensityEquation::km4, [](double step) { return step; }},
          {"0.9 l*", DensityEquation::km4, [=](double) { return 0.9 * shortest_length; }},
          {"1.1 l*", DensityEquation::km4, [=](double) { return 1.1 * shortest_length; }},
          {"regularised", DensityEquation::km4, [=](double) { return default_length; }},
          {"pade", DensityEquation::km4_pade, [](double) { return 0.0; }}};
}

double linearised_frequency(const problem::Problem& problem) {
  return std::sqrt(problem::equivalent_linearisation(problem).stiffness);
}

// Returns the options for a grid with the given velocity step, in the computational box of the
// solver. The velocity range of the grid is a whole number of velocity steps.
FiniteVolumeOptions options_for_step(const problem::Problem& problem, double step, int nx) {
  FiniteVolumeOptions options;
  const PhasePlaneBox box = initial_box(problem, options);
  const int half = std::max(8, static_cast<int>(std::ceil(box.x2_max / step - 1e-9)));
  options.origin_refinement = 1;  // a uniform grid: all velocity cells have the width `step`
  options.nx = nx;
  options.nv = 2 * half;
  options.x1_max = box.x1_max;
  options.x2_max = half * step;
  return options;
}

PhasePlaneBox box_of_options(const FiniteVolumeOptions& options) {
  return {*options.x1_max, *options.x2_max};
}

void append_remark(std::string& remark, const std::string& more) {
  remark += (remark.empty() ? "" : "; ") + more;
}

NullVectorResult null_vector_from_gaussian(const problem::Problem& problem,
                                           const FiniteVolumeOptions& options,
                                           const PlaneDiscretisation& discretisation,
                                           const FokkerPlanckOperator& op) {
  Preconditioner preconditioner(problem, discretisation.excitation, options.impact,
                                discretisation.grid);
  return find_null_vector(op, preconditioner,
                          initial_gaussian(discretisation.grid, problem::motion_scales(problem)));
}

NullVectorResult kf_reference_density(const problem::Problem& problem,
                                      FiniteVolumeOptions options) {
  options.equation = DensityEquation::kf;
  const PlaneDiscretisation discretisation =
      discretise_density_equation(problem, options, box_of_options(options));
  if (!discretisation.failure.empty()) return {std::nullopt, 0, discretisation.failure};
  const auto op = fokker_planck_operator(problem, options, discretisation);
  return null_vector_from_gaussian(problem, options, discretisation, op);
}

void add_eigenvalues(const problem::Problem& problem, const FokkerPlanckOperator& op,
                     bool symbol_grows, KramersMoyalRegularisationResult& row) {
  if (op.areas.size() > kMostCellsFactored) {
    append_remark(row.remark, fmt::format("no eigenvalue: not computed for more than {} cells",
                                          kMostCellsFactored));
    return;
  }
  auto [values, vector, residual, factorisations, solves, failure] = find_rightmost_eigenvalues(
      op, symbol_grows ? row.symbol->rate : 0, linearised_frequency(problem), symbol_grows ? 1 : 2);
  if (values.empty()) return append_remark(row.remark, failure);
  row.rightmost = values[0];
  if (values.size() > 1) row.next = values[1];
}

void compare_null_vector_with_kf(const problem::Problem& problem,
                                 const FiniteVolumeOptions& options,
                                 const PlaneDiscretisation& discretisation,
                                 const FokkerPlanckOperator& op, bool symbol_grows,
                                 const NullVectorResult& kf,
                                 KramersMoyalRegularisationResult& row) {
  // The preconditioner of GMRES approximates only operators without growing modes sufficiently.
  const NullVectorResult found =
      symbol_grows ? find_null_vector_by_inverse_iteration(
                         op, initial_gaussian(discretisation.grid, problem::motion_scales(problem)),
                         linearised_frequency(problem))
                   : null_vector_from_gaussian(problem, options, discretisation, op);
  if (!found.averages) return append_remark(row.remark, "no null vector: " + found.failure);
  row.min_density = found.averages->minCoeff() / found.averages->cwiseAbs().maxCoeff();
  if (!kf.averages) return append_remark(row.remark, "no reference density of kf: " + kf.failure);
  const MarginalCellAverages mine = marginals(discretisation.grid, *found.averages);
  const MarginalCellAverages of_kf = marginals(discretisation.grid, *kf.averages);
  row.l1_y = discretisation.grid.x1.cell_widths().dot((mine.y - of_kf.y).cwiseAbs());
  row.l1_ydot = discretisation.grid.x2.cell_widths().dot((mine.ydot - of_kf.ydot).cwiseAbs());
}

KramersMoyalRegularisationResult study_scheme(const problem::Problem& problem,
                                              const KramersMoyalRegularisation& scheme, double step,
                                              FiniteVolumeOptions options,
                                              const NullVectorResult& kf) {
  KramersMoyalRegularisationResult row{
      .scheme = scheme.name, .step = step, .length = scheme.length(step)};
  options.equation = scheme.equation;
  if (options.equation == DensityEquation::km4) options.regularisation_length = row.length;
  row.nx = *options.nx;
  row.nv = *options.nv;
  const PlaneDiscretisation discretisation =
      discretise_density_equation(problem, options, box_of_options(options));
  row.remark = discretisation.failure;
  if (!discretisation.failure.empty()) return row;
  row.symbol = fastest_growing_wave(problem, options, step);
  const bool symbol_grows = is_growing_wave(*row.symbol, problem.impulses);
  const auto op = fokker_planck_operator(problem, options, discretisation);
  add_eigenvalues(problem, op, symbol_grows, row);
  compare_null_vector_with_kf(problem, options, discretisation, op, symbol_grows, kf, row);
  return row;
}

}  // namespace

std::optional<double> KramersMoyalRegularisationResult::growth_rate(
    const problem::Problem& problem) const {
  if (rightmost) {
    return rightmost->real() > kUnstableRate * linearised_frequency(problem)
               ? std::optional(rightmost->real())
               : std::nullopt;
  }
  return symbol && is_growing_wave(*symbol, problem.impulses) ? std::optional(symbol->rate)
                                                              : std::nullopt;
}

KramersMoyalRegularisationStudy study_kramers_moyal_regularisation(
    const problem::Problem& problem, const KramersMoyalRegularisationOptions& options,
    const std::function<void(int, int)>& progress) {
  if (!problem::has_equivalent_linearisation(problem)) {
    throw InputError(
        "study of the regularisation: requires one wall at the equilibrium, constant damping and "
        "impulses without noise; choose a case of that class");
  }
  const auto& law = problem.impulses.amplitude_law();
  KramersMoyalRegularisationStudy study{
      .default_length = default_regularisation_length(law),
      .shortest_length = shortest_stable_regularisation_length(law),
      .rows = {}};
  const auto all = regularisation_schemes(study.default_length, study.shortest_length);
  const int rows = static_cast<int>(all.size() * options.divisions.size());
  std::vector<KramersMoyalRegularisationResult> by_step;
  for (const int division : options.divisions) {
    const double step = study.default_length / division;
    const FiniteVolumeOptions on_step = options_for_step(problem, step, options.nx);
    if (progress) progress(static_cast<int>(by_step.size()), rows);
    const NullVectorResult kf = kf_reference_density(problem, on_step);
    for (const KramersMoyalRegularisation& scheme : all) {
      if (progress) progress(static_cast<int>(by_step.size()), rows);
      by_step.push_back(study_scheme(problem, scheme, step, on_step, kf));
    }
  }
  for (std::size_t scheme = 0; scheme < all.size(); ++scheme) {
    for (std::size_t k = scheme; k < by_step.size(); k += all.size()) {
      study.rows.push_back(by_step[k]);
    }
  }
  return study;
}

}  // namespace fpkcheck::fd_fpk
