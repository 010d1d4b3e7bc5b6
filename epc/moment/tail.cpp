#include "epc/moment/tail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::moment {
namespace {

constexpr int kContourPoints = 48;

// Visits points (y, +-v) of a contour with dphi, where dA/dh = sum of dy/v over them and
// y = centre + reach sin(phi).
template <class Visit>
void along_contour(const EnergyDomain& domain, const Visit& visit) {
  const double centre = (domain.y_low() + domain.y_max()) / 2;
  const double reach = (domain.y_max() - domain.y_low()) / 2;
  for (int i = 0; i < kContourPoints; ++i) {
    const double phi = std::numbers::pi * ((i + 0.5) / kContourPoints - 0.5);
    const double y = centre + reach * std::sin(phi);
    const double v = domain.half_width(y);
    const double dy = std::numbers::pi / kContourPoints * reach * std::cos(phi);
    visit(y, v, dy);
    visit(y, -v, dy);
  }
}

}  // namespace

double largest_on_contour(const Polynomial& q, const problem::Problem& problem, double energy) {
  const EnergyDomain domain(problem, energy);
  double largest =
      std::max(q(domain.y_max(), 0), q(domain.y_low(), domain.half_width(domain.y_low())));
  largest = std::max(largest, q(domain.y_low(), -domain.half_width(domain.y_low())));
  along_contour(domain, [&](double y, double v, double) { largest = std::max(largest, q(y, v)); });
  return largest;
}

Fall fall_of(const Polynomial& q, const problem::Problem& problem, double from, double farthest,
             double depth) {
  constexpr int kContoursBefore = 40;
  constexpr double kGrowth = 1.05;
  Fall fall{-std::numeric_limits<double>::infinity(), std::nullopt};
  for (int i = 1; i <= kContoursBefore; ++i) {
    fall.peak = std::max(fall.peak, largest_on_contour(q, problem, from * i / kContoursBefore));
  }
  double before = std::numeric_limits<double>::infinity();
  for (double energy = from; energy <= farthest; energy *= kGrowth) {
    const double largest = largest_on_contour(q, problem, energy);
    if (largest > before) break;
    if (largest < fall.peak - depth) {
      fall.reached = energy;
      break;
    }
    before = largest;
  }
  return fall;
}

std::pair<double, double> radii(const EnergyDomain& domain, const Deviations& sigma) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  along_contour(domain, [&](double y, double v, double) {
    const double radius = std::hypot(y / sigma.x1, v / sigma.x2);
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
  });
  return {least, greatest};
}

double probability_beyond(const Polynomial& q, const problem::Problem& problem, double energy,
                          double temperature, double log_normalisation) {
  double density = 0;
  along_contour(EnergyDomain(problem, energy), [&](double y, double v, double dy) {
    density += std::exp(q(y, v) - log_normalisation) * dy / std::abs(v);
  });
  return temperature * density;
}

}  // namespace fpkcheck::epc::moment
