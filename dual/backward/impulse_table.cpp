#include "dual/backward/impulse_table.hpp"

#include <algorithm>

namespace fpkcheck::dual {
namespace {

using problem::GaussianLaw;
using problem::LaplaceLaw;
using problem::TwoPointLaw;
using problem::UniformLaw;

// Offsets y where the law's density or its derivative jumps, or its atoms.
std::vector<double> kinks_of(const GaussianLaw&) { return {}; }
std::vector<double> kinks_of(const LaplaceLaw& law) {
  return law.mean == 0 ? std::vector<double>{} : std::vector{law.mean};
}
std::vector<double> kinks_of(const TwoPointLaw& law) {
  return {law.mean - law.deviation, law.mean + law.deviation};
}
std::vector<double> kinks_of(const UniformLaw& law) {
  return {law.mean - law.half_width, law.mean + law.half_width};
}

// Pieces are short against the length over which the law's kernel varies.
double longest_piece(const GaussianLaw& law) { return 0.8 * law.deviation; }
double longest_piece(const LaplaceLaw& law) { return 0.6 * law.scale; }
double longest_piece(const TwoPointLaw& law) { return 2 * law.deviation; }
double longest_piece(const UniformLaw& law) { return law.half_width; }

// E[(Y - mean)^n], n even.
Interval central_moment(const GaussianLaw& law, int n) {
  Interval m = power(Interval(law.deviation), n);
  for (int i = n - 1; i > 1; i -= 2) m *= static_cast<double>(i);
  return m;
}
Interval central_moment(const LaplaceLaw& law, int n) {
  Interval m = power(Interval(law.scale), n);
  for (int i = 2; i <= n; ++i) m *= static_cast<double>(i);
  return m;
}
Interval central_moment(const TwoPointLaw& law, int n) { return power(Interval(law.deviation), n); }
Interval central_moment(const UniformLaw& law, int n) {
  return power(Interval(law.half_width), n) / static_cast<double>(n + 1);
}

}  // namespace

ImpulseKinks impulse_kinks(const ImpactBasis& basis, const problem::ImpulseLaw& law) {
  ImpulseKinks kinks;
  const auto offsets = std::visit(
      [&](const auto& kind) {
        kinks.longest = longest_piece(kind);
        return kinks_of(kind);
      },
      law.kind());
  for (const double offset : offsets) {
    for (const double v : velocity_breaks(basis)) kinks.cuts.push_back(v - offset);
  }
  std::sort(kinks.cuts.begin(), kinks.cuts.end());
  return kinks;
}

ImpulseTable impulse_table(const ImpactBasis& basis, const std::vector<VelocityPiece>& pieces,
                           const problem::ImpulseLaw& law) {
  return std::visit([&](const auto& kind) { return table_of(kind, basis, pieces); }, law.kind());
}

Interval moment_enclosure(const problem::ImpulseLaw& law, int n) {
  return std::visit(
      [n](const auto& kind) {
        Interval sum = 0;
        for (int i = 0; i <= n; i += 2) {
          sum += binomial(n, i) * power(Interval(kind.mean), n - i) * central_moment(kind, i);
        }
        return sum;
      },
      law.kind());
}

ImpulseTable empty_table(const ImpactBasis& basis, const std::vector<VelocityPiece>& pieces,
                         int order) {
  ImpulseTable table{basis.size(), order, {}, 0};
  table.coefficients.assign(pieces.size() * static_cast<std::size_t>(basis.size() * order),
                            Interval(0));
  return table;
}

}  // namespace fpkcheck::dual
