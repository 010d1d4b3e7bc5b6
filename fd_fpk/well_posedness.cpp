#include "fd_fpk/well_posedness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace fpkcheck::fd_fpk {

Growth largest_growth(const Line& line, const Excitation& excitation, int order) {
  Eigen::MatrixXd matrix = local_excitation(line, excitation, order);
  if (excitation.exchange.size() > 0) matrix += excitation.exchange;
  const int middle = line.cells() / 2;
  const Eigen::RowVectorXd row = matrix.row(middle);

  constexpr int kWaves = 2000;
  const double step = line.width(middle);
  Growth growth{-HUGE_VAL, 0};
  for (int wave = 1; wave <= kWaves; ++wave) {
    const double phase = std::numbers::pi * wave / kWaves;  // q step
    double rate = 0;
    for (int j = 0; j < line.cells(); ++j) rate += row(j) * std::cos(phase * (j - middle));
    if (rate > growth.rate) growth = {rate, phase / step};
  }
  return growth;
}

bool grows(const Growth& growth, const problem::ImpulseTrain& impulses) {
  constexpr double kRounding = 1e-9;
  return growth.rate > kRounding * impulses.arrival_rate();
}

double shortest_regularisation_length(const problem::ImpulseLaw& law) {
  constexpr double kLargestSine =
      0.5250616;  // max of sin^4 t / t^2, where tan t = 2 t: t = 1.16556
  return std::sqrt(4 * kLargestSine * (law.moment(4) / 24) / (law.moment(2) / 2));
}

Posedness posedness(const problem::Problem& problem, const Options& options,
                    const Discretisation& discretisation) {
  if (options.equation != Equation::km4 && options.equation != Equation::km4_pade) return {};
  const auto& impulses = problem.impulses;
  const auto [line, excitation] =
      unbounded_excitation(problem, options, discretisation.grid.x2.smallest_width());
  Posedness result{.growth = largest_growth(line, excitation, options.order + options.order % 2),
                   .objection = {}};
  if (!grows(result.growth, impulses)) return result;
  result.objection = fmt::format(
      "the series cut after the fourth derivative grows at rate {:.3g} at wavenumber {:.3g} with "
      "the fourth difference over {:.3g} (use a regularisation length of at least {:.3g}; the "
      "default is {:.3g})",
      result.growth.rate, result.growth.wavenumber, discretisation.regularisation_length,
      shortest_regularisation_length(impulses.law()),
      default_regularisation_length(impulses.law()));
  return result;
}

}  // namespace fpkcheck::fd_fpk
