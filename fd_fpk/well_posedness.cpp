#include "fd_fpk/well_posedness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace fpkcheck::fd_fpk {

Growth largest_growth(const Excitation& excitation, double step, int order) {
  int reach = order;
  for (const auto& term : excitation.lattice) reach = std::max(reach, std::abs(term.shift));
  const int middle = reach + order;
  const UniformLine line{0.0, step, 2 * middle + 1};
  const LineOperator matrix = excitation_operator(line, excitation, order);

  constexpr int kWaves = 2000;
  Growth growth{-HUGE_VAL, 0};
  for (int wave = 1; wave <= kWaves; ++wave) {
    const double phase = std::numbers::pi * wave / kWaves;  // q step
    double rate = 0;
    for (LineOperator::InnerIterator entry(matrix, middle); entry; ++entry) {
      rate += entry.value() * std::cos(phase * static_cast<double>(entry.col() - middle));
    }
    if (rate > growth.rate) growth = {rate, phase / step};
  }
  return growth;
}

double shortest_regularisation_length(const problem::ImpulseLaw& law) {
  constexpr double kLargestSine =
      0.5250616;  // max of sin^4 t / t^2, where tan t = 2 t: t = 1.16556
  return std::sqrt(4 * kLargestSine * (law.moment(4) / 24) / (law.moment(2) / 2));
}

}  // namespace fpkcheck::fd_fpk
