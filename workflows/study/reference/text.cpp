#include <fmt/format.h>

#include <cmath>

#include "workflows/study/reference/reference.hpp"

namespace fpkcheck::study {
namespace {

constexpr int kMomentDigits = 7;
constexpr int kDensityDigits = 5;

// The text of a number with the given number of significant digits, including trailing zeros.
std::string digits(double x, int significant) {
  if (x == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
  return exponent < -3 ? fmt::format("{:.{}e}", x, significant - 1)
                       : fmt::format("{:.{}f}", x, std::max(0, significant - 1 - exponent));
}

void add_moments(const Reference& r, std::string& text) {
  text +=
      "| | value | difference of the orders | simulation | deviation in standard errors |\n"
      "|---|---|---|---|---|\n";
  for (const auto& [name, symbol, value, simulated, error] : r.moments) {
    text += fmt::format("| `{}` | {} | {:.0e} | {:.6g} +- {:.1g} | {:+.1f} |\n", symbol,
                        digits(value.seventh, value.agreed_digits(kMomentDigits)),
                        std::abs(value.seventh - value.fifth), simulated, error,
                        (simulated - value.seventh) / error);
  }
}

void add_points(const Reference& r, std::string& text) {
  text += "| y | p(y) | y' | p(y') |\n|---|---|---|---|\n";
  for (std::size_t k = 0; k < r.y.size(); ++k) {
    const auto& [y, p] = r.y[k];
    const auto& [v, q] = r.ydot[k];
    text += fmt::format("| {:.6g} | {} | {:.6g} | {} |\n", y,
                        digits(p.seventh, p.agreed_digits(kDensityDigits)), v,
                        digits(q.seventh, q.agreed_digits(kDensityDigits)));
  }
}

}  // namespace

std::string reference_markdown(const std::vector<Reference>& references,
                               const std::string& command) {
  std::string text = fmt::format(R"(# Reference values

Stationary moments and marginal densities of the vibro-impact Duffing oscillator under Poisson
impulses: the Kolmogorov-Feller equation (`kf`) with the exact impact (`map`). This file and
`reference.csv` are the output of

    {}

Finite volumes of the orders seven and five on grids graded to the origin (`theory.md`, section 4)
give two values of each quantity. Values of moments are Richardson limits of three grids; values of
densities are from the finest grid. The tables have the digits that agree between the two orders.
The last two columns of each table of moments compare the values with an independent simulation.

)",
                                 command);
  for (const auto& r : references) {
    text += fmt::format("## {}\n\n{}\n\n", r.problem.name, problem::parameters_text(r.problem));
    if (!r.failure.empty()) {
      text += fmt::format("No reference: {}.\n\n", r.failure);
      continue;
    }
    add_moments(r, text);
    text += '\n';
    add_points(r, text);
    text += fmt::format(
        "\nEnergy residual {:.0e}. Simulated time {:.2g}; the 95 % intervals of its histogram "
        "contain the reference in {:.1f} % of the bins of p(y) and {:.1f} % of the bins of "
        "p(y').\n\n",
        r.energy_residual, r.simulated_time, 100 * r.y_coverage, 100 * r.ydot_coverage);
  }
  return text;
}

std::string reference_csv(const std::vector<Reference>& references) {
  std::string text = "case,quantity,abscissa,value,uncertainty\n";
  for (const auto& r : references) {
    const auto add = [&](const std::string& quantity, const std::string& abscissa,
                         const ReferenceValue& value) {
      text += fmt::format("{},{},{},{:.10g},{:.1e}\n", r.problem.name, quantity, abscissa,
                          value.seventh, std::abs(value.seventh - value.fifth));
    };
    for (const auto& moment : r.moments) add(moment.name, "", moment.value);
    for (const auto& [x, p] : r.y) add("p_y", fmt::format("{:.10g}", x), p);
    for (const auto& [x, p] : r.ydot) add("p_ydot", fmt::format("{:.10g}", x), p);
  }
  return text;
}

}  // namespace fpkcheck::study
