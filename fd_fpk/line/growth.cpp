#include "fd_fpk/line/growth.hpp"

#include <cmath>
#include <numbers>

#include "fd_fpk/line/excitation.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::fd_fpk {

Growth largest_growth(const Line& line, const Excitation& excitation, int points) {
  const int middle = line.cells() / 2;
  Eigen::RowVectorXd row = local_excitation(line, excitation, points).row(middle);
  if (excitation.exchange.size() > 0) row += excitation.exchange.row(middle);

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

}  // namespace fpkcheck::fd_fpk
