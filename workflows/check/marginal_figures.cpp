#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "workflows/check/chance.hpp"
#include "workflows/check/claims.hpp"

namespace fpkcheck::check {
namespace {

using results::Curve;
using transform::Solution;

constexpr double kNormal95 = 1.96;  // half-width of a 95 % interval in standard errors
// A bin with a wider interval (relative to its density) holds a handful of events: only the L1
// distance covers it.
constexpr double kWidestInterval = 0.5;

// True where both curves have the same bins up to rounding.
bool on_the_same_bins(const Curve& one, const Curve& other) {
  constexpr double kSame = 1e-9;
  if (one.abscissa.size() != other.abscissa.size() || one.abscissa.empty()) return false;
  const double extent = std::abs(one.abscissa.back());
  return std::ranges::equal(one.abscissa, other.abscissa,
                            [&](double x, double y) { return std::abs(x - y) <= kSame * extent; });
}

base::Value bins_text(const Curve* curve) {
  if (curve == nullptr) return "missing";
  return fmt::format("{} bins to {:.6g}", curve->abscissa.size(),
                     curve->abscissa.empty() ? 0 : curve->abscissa.back());
}

bool is_known(const Curve& curve, std::size_t k) {
  return curve.density[k] > 0 &&
         curve.upper[k] - curve.density[k] <= kWidestInterval * curve.density[k];
}

double standard_error(const Curve& curve, std::size_t k) {
  return (curve.upper[k] - curve.density[k]) / kNormal95;
}

// The bin with the largest change. For simulations the change is in standard errors, over the bins
// that both runs resolve.
Figure largest_change(Figure figure, const Curve& was, const Curve& is, bool by_chance,
                      const Tolerances& tolerances) {
  const double peak = std::ranges::max(was.density);
  std::size_t compared = 0;
  figure.change = -1;
  for (std::size_t k = 0; k < was.density.size(); ++k) {
    if (by_chance && !(is_known(was, k) && is_known(is, k))) continue;
    const double difference = std::abs(is.density[k] - was.density[k]);
    const double scale =
        by_chance ? std::hypot(standard_error(was, k), standard_error(is, k)) : peak;
    const double change = difference == 0 ? 0 : difference / scale;
    ++compared;
    if (change <= figure.change) continue;
    figure.name = fmt::format("{} at {:.4g}", density_name(was.variable), was.abscissa[k]);
    figure.baseline = was.density[k];
    figure.now = is.density[k];
    figure.change = std::isnan(change) ? kInfinity : change;
  }
  figure.change = std::max(figure.change, 0.0);
  figure.kind = by_chance ? FigureKind::simulated_bin : FigureKind::marginal;
  figure.allowed = by_chance ? tolerances.of_the_largest(compared) : tolerances.deterministic;
  return figure;
}

double l1(const Curve& was, const Curve& is) {
  const auto widths = results::bin_widths(was);
  double sum = 0;
  for (std::size_t k = 0; k < was.density.size(); ++k) {
    sum += std::abs(is.density[k] - was.density[k]) * widths[k];
  }
  return sum;
}

// The L1 distance between a simulation and the baseline, as a quantity of the simulation.
Claims l1_claim(const Solution& simulation, const Curve& curve, double l1,
                const Tolerances& tolerances) {
  Claims claims;
  Claim& claim = Part{claims, curve.solution, kWhole}.number(
      fmt::format("L1 {} to baseline", density_name(curve.variable)), FigureKind::simulated_l1, l1,
      0);
  move_by_sampling(claim, simulation.sampling, curve.variable, tolerances);
  return claims;
}

}  // namespace

std::vector<Figure> marginal_figures(const results::Case& baseline, const results::Case& now,
                                     const Tolerances& tolerances) {
  std::vector<Figure> figures;
  const auto figure_of = [&](const Curve& curve) {
    return Figure{.case_name = baseline.name(),
                  .solution = curve.solution,
                  .name = density_name(curve.variable),
                  .kind = FigureKind::marginal,
                  .baseline = bins_text(baseline.curve(curve.solution, curve.variable)),
                  .now = bins_text(now.curve(curve.solution, curve.variable)),
                  .change = kInfinity,
                  .allowed = 0};
  };
  for (const Curve& was : baseline.curves) {
    const Solution *one = baseline.find(was.solution), *other = now.find(was.solution);
    const Curve* is = now.curve(was.solution, was.variable);
    if (is == nullptr || !on_the_same_bins(was, *is)) {
      figures.push_back(figure_of(was));
    } else if (one != nullptr && other != nullptr) {  // else reported with the solution
      const bool by_chance = one->standard_errors && !was.upper.empty() && !is->upper.empty();
      figures.push_back(largest_change(figure_of(was), was, *is, by_chance, tolerances));
      if (by_chance) {
        const auto compared = held_against(baseline.name(), l1_claim(*one, was, 0, tolerances),
                                           l1_claim(*other, *is, l1(was, *is), tolerances));
        figures.push_back(compared.front());
      }
    }
  }
  for (const Curve& is : now.curves) {
    if (baseline.curve(is.solution, is.variable) == nullptr) figures.push_back(figure_of(is));
  }
  return figures;
}

}  // namespace fpkcheck::check
