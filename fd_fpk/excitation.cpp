#include "fd_fpk/excitation.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {

std::string_view name(Equation equation) {
  switch (equation) {
    case Equation::white:
      return "white";
    case Equation::km4:
      return "km4";
    case Equation::kf:
      return "kf";
  }
  return "";
}

double default_regularisation_length(const problem::ImpulseLaw& law) {
  return std::sqrt(law.moment(6) / (5 * law.moment(4)));
}

double largest_jump_spacing(const problem::Problem& problem) {
  constexpr double kFrequent = 10;
  const auto& law = problem.impulses.law();
  const double deviation = std::sqrt(law.moment(2) - law.moment(1) * law.moment(1));
  const bool frequent = problem.impulses.arrival_rate() / problem.system.damping() >= kFrequent;
  return frequent ? deviation : deviation / 2;
}

Excitation white_noise(const problem::ImpulseTrain& impulses) {
  return {
      .drift = impulses.rate_moment(1), .diffusion = impulses.rate_moment(2) / 2, .lattice = {}};
}

Excitation kramers_moyal(const problem::ImpulseTrain& impulses, double step, int cells) {
  Excitation result = white_noise(impulses);
  const double l = cells * step;
  const double fourth = impulses.rate_moment(4) / 24 / (l * l * l * l);
  for (const auto& [shift, weight] : {LatticeTerm{-2, 1}, {-1, -4}, {0, 6}, {1, -4}, {2, 1}}) {
    result.lattice.push_back({shift * cells, weight * fourth});
  }
  // delta_l^3 p / l^3 = (p(v+2l) - 2 p(v+l) + 2 p(v-l) - p(v-2l)) / (2 l^3)
  const double third = -impulses.rate_moment(3) / 6 / (2 * l * l * l);
  if (third != 0) {
    for (const auto& [shift, weight] : {LatticeTerm{-2, 1}, {-1, -2}, {1, 2}, {2, -1}}) {
      result.lattice.push_back({shift * cells, weight * third});
    }
  }
  return result;
}

Excitation jumps(const problem::ImpulseTrain& impulses, double step, int cells) {
  const auto& law = impulses.law();
  const double spacing = cells * step;
  const double reach = std::abs(law.moment(1)) + 9 * std::sqrt(law.moment(2));
  const int largest = static_cast<int>(std::ceil(reach / spacing));
  std::vector<LatticeTerm> terms;
  double sum = 0;
  for (int k = -largest; k <= largest; ++k) {
    const double weight = spacing * law.density(k * spacing);
    if (weight < 1e-18) continue;
    terms.push_back({k * cells, weight});
    sum += weight;
  }
  for (auto& term : terms) term.weight *= impulses.arrival_rate() / sum;
  terms.push_back({0, -impulses.arrival_rate()});
  return {.drift = 0, .diffusion = 0, .lattice = std::move(terms)};
}

LineOperator excitation_operator(const UniformLine& line, const Excitation& excitation, int order) {
  const LineOperator flux = excitation.diffusion * face_derivatives(line, order) -
                            excitation.drift * face_values(line, order, Bias::left);
  LineOperator matrix = divergence(line) * flux;
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [shift, weight] : excitation.lattice) {
    if (shift == 0) continue;
    for (int from = 0; from < line.cells; ++from) {
      const int to = from + shift;
      if (to < 0 || to >= line.cells) continue;
      entries.emplace_back(to, from, weight);
      entries.emplace_back(from, from, -weight);
    }
  }
  LineOperator shifts(line.cells, line.cells);
  shifts.setFromTriplets(entries.begin(), entries.end());
  matrix += shifts;
  return matrix;
}

}  // namespace fpkcheck::fd_fpk
