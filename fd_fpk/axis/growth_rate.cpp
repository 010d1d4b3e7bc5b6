#include "fd_fpk/axis/growth_rate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fd_fpk/axis/excitation.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// The fastest growing wave of kramers_moyal on cells of this width.
Growth kramers_moyal_growth(const problem::ImpulseTrain& impulses, double width, int points,
                            double length) {
  const int reach = stencil_half_width(length, width, points);
  const Axis axis = Axis::uniform(0, width, 2 * reach + 1);
  return largest_growth(axis, kramers_moyal(impulses, axis, length), points);
}

}  // namespace

Growth largest_growth(const Axis& axis, const Excitation& excitation, int points) {
  const int middle = axis.cells() / 2;
  Eigen::RowVectorXd row = local_excitation(axis, excitation, points).row(middle);
  if (excitation.exchange.size() > 0) row += excitation.exchange.row(middle);

  constexpr int kWaves = 2000;
  const Eigen::ArrayXd phases =
      Eigen::ArrayXd::LinSpaced(kWaves, std::numbers::pi / kWaves, std::numbers::pi);  // q step
  // Sums row(middle + j) cos(j phase) over j, with the cosines by their three-term recurrence.
  const Eigen::ArrayXd twice = 2 * phases.cos();
  Eigen::ArrayXd rates = Eigen::ArrayXd::Constant(kWaves, row(middle));
  Eigen::ArrayXd before = Eigen::ArrayXd::Ones(kWaves), cosines = twice / 2;
  for (int j = 1; j <= middle; ++j) {
    const double after = middle + j < axis.cells() ? row(middle + j) : 0;
    rates += (row(middle - j) + after) * cosines;
    before = twice * cosines - before;
    before.swap(cosines);
  }
  Eigen::Index fastest = 0;
  const double rate = rates.maxCoeff(&fastest);
  return {rate, phases(fastest) / axis.width(middle)};
}

int stencil_half_width(double length, double width, int points) {
  return static_cast<int>(std::ceil(2 * length / width)) + 4 * points;
}

bool is_unstable(const Growth& growth, const problem::ImpulseTrain& impulses) {
  constexpr double kRounding = 1e-9;
  return growth.rate > kRounding * impulses.arrival_rate();
}

double shortest_regularisation_length(const problem::ImpulseLaw& law) {
  constexpr double kLargestSine =
      0.5250616;  // max of sin^4 t / t^2, where tan t = 2 t: t = 1.16556
  return std::sqrt(4 * kLargestSine * (law.moment(4) / 24) / (law.moment(2) / 2));
}

std::vector<double> critical_widths(const Axis& axis, const problem::ImpulseLaw& law,
                                    double length) {
  constexpr double kSame = 1.05, kNarrow = 0.5;
  const bool narrow_ones_decay = length >= default_regularisation_length(law);
  const Eigen::VectorXd all = axis.widths();
  std::vector<double> sorted(all.begin(), all.end()), critical;
  std::ranges::sort(sorted);
  for (const double width : sorted) {
    if (narrow_ones_decay && width <= kNarrow * length) continue;
    if (critical.empty() || width > kSame * critical.back()) critical.push_back(width);
  }
  return critical;
}

double shortest_regularisation_length(const problem::ImpulseTrain& impulses,
                                      std::span<const double> widths, int points, double from) {
  constexpr double kStep = 1.1, kClose = 1.001;
  const auto too_short = [&](double length) {
    return std::ranges::any_of(widths, [&](double width) {
      return is_unstable(kramers_moyal_growth(impulses, width, points, length), impulses);
    });
  };
  if (!too_short(from)) return from;
  // The loop terminates, because the fourth difference over a length of many cells is negligible
  // compared with the second difference.
  double shorter = from, longer = kStep * from;
  for (; too_short(longer); longer *= kStep) shorter = longer;
  while (longer > kClose * shorter) {
    const double middle = std::sqrt(shorter * longer);
    (too_short(middle) ? shorter : longer) = middle;
  }
  return longer;
}

double default_regularisation_length(const problem::ImpulseTrain& impulses, const Axis& axis,
                                     int points) {
  const double length = default_regularisation_length(impulses.law());
  return shortest_regularisation_length(impulses, critical_widths(axis, impulses.law(), length),
                                        points, length);
}

}  // namespace fpkcheck::fd_fpk
