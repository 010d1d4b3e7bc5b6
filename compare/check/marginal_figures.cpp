#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/check/figures.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The same bins up to rounding.
bool on_the_same_bins(const MarginalCurve& one, const MarginalCurve& other) {
  constexpr double kSame = 1e-9;
  if (one.abscissa.size() != other.abscissa.size() || one.abscissa.empty()) return false;
  const double extent = std::abs(one.abscissa.back());
  return std::ranges::equal(one.abscissa, other.abscissa,
                            [&](double x, double y) { return std::abs(x - y) <= kSame * extent; });
}

Figure figure(const MarginalCurve& curve, const std::string& name, FigureKind kind) {
  return {curve.case_name, curve.solution, name, kind, {}, {}, 0, 0};
}

std::string name_at(const MarginalCurve& curve, std::size_t bin) {
  return fmt::format("{} at {:.4g}", density_name(curve.variable), curve.abscissa[bin]);
}

Figure largest_change(const MarginalCurve& was, const MarginalCurve& is,
                      const Tolerances& tolerances) {
  const double peak = std::ranges::max(was.density);
  std::size_t worst = 0;
  const auto change = [&](std::size_t k) {
    return std::abs(is.density[k] - was.density[k]) / peak;
  };
  for (std::size_t k = 1; k < was.density.size(); ++k) {
    if (!(change(k) <= change(worst))) worst = k;
  }
  Figure result = figure(was, name_at(was, worst), FigureKind::marginal);
  result.baseline = was.density[worst];
  result.now = is.density[worst];
  result.change = change(worst);
  result.allowed = tolerances.deterministic;
  return result;
}

double standard_error(const MarginalCurve& curve, std::size_t k) {
  return (curve.upper[k] - curve.density[k]) / kNormal95;
}

// A bin that is known to worse is left to L1.
bool is_known(const MarginalCurve& curve, std::size_t k) {
  return curve.density[k] > 0 &&
         curve.upper[k] - curve.density[k] <= kWidestInterval * curve.density[k];
}

Figure largest_change_in_standard_errors(const MarginalCurve& was, const MarginalCurve& is,
                                         const Tolerances& tolerances) {
  Figure result = figure(was, density_name(was.variable), FigureKind::simulated_bin);
  std::size_t known = 0;
  for (std::size_t k = 0; k < was.density.size(); ++k) {
    if (!is_known(was, k) || !is_known(is, k)) continue;
    ++known;
    const double difference = std::abs(is.density[k] - was.density[k]);
    const double error = std::hypot(standard_error(was, k), standard_error(is, k));
    const double change = difference == 0 ? 0 : difference / error;
    if (change < result.change) continue;
    result.change = change;
    result.name = name_at(was, k);
    result.baseline = was.density[k];
    result.now = is.density[k];
  }
  result.allowed = tolerances.of_the_largest(known);
  return result;
}

Figure l1(const MarginalCurve& was, const MarginalCurve& is, double allowed) {
  Figure result = figure(was, fmt::format("L1 {} to baseline", density_name(was.variable)),
                         FigureKind::simulated_l1);
  const double width = was.abscissa.size() > 1 ? was.abscissa[1] - was.abscissa[0] : 0;  // uniform
  for (std::size_t k = 0; k < was.density.size(); ++k) {
    result.change += std::abs(is.density[k] - was.density[k]) * width;
  }
  result.baseline = 0.0;
  result.now = result.change;
  result.allowed = allowed;
  return result;
}

Figure cannot_be_compared(const MarginalCurve& curve, const std::string& was,
                          const std::string& is) {
  Figure result = figure(curve, density_name(curve.variable), FigureKind::marginal);
  result.baseline = was;
  result.now = is;
  result.change = kInfinity;
  return result;
}

std::string bins_text(const MarginalCurve& curve) {
  return fmt::format("{} bins to {:.6g}", curve.abscissa.size(),
                     curve.abscissa.empty() ? 0 : curve.abscissa.back());
}

}  // namespace

const MarginalCurve* CaseOfRun::curve(const std::string& solution,
                                      const std::string& variable) const {
  const auto found = std::ranges::find_if(marginals, [&](const MarginalCurve& curve) {
    return summary.at("name") == curve.case_name && curve.solution == solution &&
           curve.variable == variable;
  });
  return found == marginals.end() ? nullptr : &*found;
}

std::vector<Figure> marginal_figures(const CaseOfRun& baseline, const CaseOfRun& now,
                                     const Tolerances& tolerances) {
  std::vector<Figure> figures;
  const auto compare = [&](const MarginalCurve& was, const MarginalCurve& is) {
    if (!on_the_same_bins(was, is)) {
      figures.push_back(cannot_be_compared(was, bins_text(was), bins_text(is)));
      return;
    }
    const Json* one = find_solution(baseline.summary, was.solution);
    const Json* other = find_solution(now.summary, was.solution);
    if (one == nullptr || other == nullptr) return;  // said of the solution
    if (is_simulation(*one) && !was.upper.empty() && !is.upper.empty()) {
      figures.push_back(largest_change_in_standard_errors(was, is, tolerances));
      figures.push_back(
          l1(was, is, allowed_l1(*one, *other, was.variable, tolerances.standard_errors)));
    } else {
      figures.push_back(largest_change(was, is, tolerances));
    }
  };
  for (const auto& was : baseline.marginals) {
    if (baseline.summary.at("name") != was.case_name) continue;
    const MarginalCurve* is = now.curve(was.solution, was.variable);
    if (is == nullptr) {
      figures.push_back(cannot_be_compared(was, "there", "missing"));
    } else {
      compare(was, *is);
    }
  }
  for (const auto& is : now.marginals) {
    if (now.summary.at("name") == is.case_name &&
        baseline.curve(is.solution, is.variable) == nullptr) {
      figures.push_back(cannot_be_compared(is, "missing", "there"));
    }
  }
  return figures;
}

}  // namespace fpkcheck::compare
