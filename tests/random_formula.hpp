#pragma once

#include <fmt/format.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "base/input_error.hpp"
#include "problem/case_file.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::tests {

/// The case file of a random oscillator whose force is a formula, in units of the frequency and the
/// deviation:
///
///     force        c v + k y, plus one to three terms a y^i v^j h(b y + d v), i + j <= 3, where h is
///                  1, tanh, the absolute value to a power, max(.., e) or min(.., e)
///     walls        none, one on either side, or two; r is a number or decreases with the speed
///     excitation   impulses (rate .3 to 30, any law), white noise, or both
///     noise        half of the white noise has a factor g, in the sense of Ito or Stratonovich
///
/// Many of these oscillators have no stationary density.
class RandomFormulaCase {
 public:
  explicit RandomFormulaCase(std::uint64_t seed) : engine_(seed) {}

  std::string next() {
    const double c = log_between(0.03, 1);
    std::string text = fmt::format("[system]\nforce = {:.4g}*v", c);
    if (unit() < 0.9) text += fmt::format(" + {:.4g}*y", log_between(0.3, 3));
    for (int terms = 1 + pick(3); terms > 0; --terms) text += term(c);
    text += "\n[wall]\n" + walls();
    const double intensity = 2 * c * log_between(0.05, 2);
    const int excitation = pick(3);
    if (excitation != 1) {
      const char* const laws[] = {"gaussian", "laplace", "two_point", "uniform"};
      text += fmt::format("[impulse]\nrate = {:.4g}\nlaw = {}\nintensity = {:.4g}\n",
                          log_between(0.3, 30), laws[pick(4)], intensity);
    }
    if (excitation != 0) text += noise(intensity);
    return text;
  }

 private:
  double unit() { return unit_(engine_); }
  double between(double from, double to) { return from + (to - from) * unit(); }
  double log_between(double from, double to) {
    return std::exp(between(std::log(from), std::log(to)));
  }
  int pick(int count) { return static_cast<int>(count * unit()); }

  std::string term(double c) {
    const int i = pick(3), j = pick(i == 0 ? 3 : 2);
    // Terms with v are damping, of the size of the linear damping.
    const double size = (unit() < 0.7 ? 1 : -1) * log_between(0.1, 2) * (j > 0 ? c : 1);
    std::string text = fmt::format(" + ({:.4g})", size);
    if (i > 0) text += fmt::format("*y^{}", i);
    if (j > 0) text += fmt::format("*v^{}", j);
    const std::string argument =
        j > 0 || unit() < 0.7
            ? fmt::format("{:.3g}*y + {:.3g}*v", between(-2, 2), unit() < 0.5 ? 0 : between(-2, 2))
            : fmt::format("y - {:.3g}", between(-1, 1));
    switch (pick(5)) {
      case 0:
        return i + j > 0 ? text : text + "*sin(y)";
      case 1:
        return text + fmt::format("*tanh({:.3g}*({}))", log_between(0.5, 10), argument);
      case 2:
        return text + fmt::format("*abs({})^{:.2g}", argument, between(0.5, 3));
      case 3:
        return text + fmt::format("*max({}, {:.2g})", argument, between(-1, 1));
      default:
        return text + fmt::format("*min({}, {:.2g})", argument, between(-1, 1));
    }
  }

  std::string restitution() {
    switch (pick(3)) {
      case 0:
        return fmt::format("{:.3g}", unit() < 0.2 ? 1 : between(0.3, 1));
      case 1:
        return fmt::format("1 - {:.2g}*min(1, v)^0.2", between(0.1, 0.5));
      default:
        return fmt::format("{:.2g} + {:.2g}*exp(-v)", between(0.4, 0.7), between(0.05, 0.3));
    }
  }

  std::string walls() {
    const int where = pick(4);
    std::string text = where == 0 ? "none = true\n" : "";
    if (where == 1 || where == 3)
      text += fmt::format("left = {:.3g}\nleft_restitution = {}\n",
                          where == 3 ? -between(0.3, 2) : between(-2, 0.3), restitution());
    if (where == 2 || where == 3)
      text += fmt::format("right = {:.3g}\nright_restitution = {}\n",
                          where == 3 ? between(0.3, 2) : between(-0.3, 2), restitution());
    return text;
  }

  std::string noise(double intensity) {
    std::string text =
        fmt::format("[noise]\nintensity = {:.4g}\n", intensity * log_between(0.1, 1));
    if (unit() < 0.5) return text;
    const double a = log_between(0.05, 1);
    switch (pick(4)) {
      case 0:
        text += fmt::format("factor = sqrt(1 + {:.3g}*y^2)\n", a);
        break;
      case 1:
        text += fmt::format("factor = 1 + {:.3g}*tanh(y + v)\n", 0.8 * a);
        break;
      case 2:
        text += fmt::format("factor = sqrt(1 + {:.3g}*(y^2 + v^2))\n", 0.5 * a);
        break;
      default:
        text += fmt::format("factor = 1 + {:.3g}*abs(v)/(1 + abs(v))\n", a);
    }
    return text + fmt::format("interpretation = {}\n", pick(2) == 0 ? "ito" : "stratonovich");
  }

  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> unit_;
};

/// The random oscillator of formulas with this number that has a stationary density.
inline problem::Problem random_formula(std::uint64_t number) {
  RandomFormulaCase cases(number);
  for (;;) {
    const std::string name = fmt::format("formula{}", number);
    std::istringstream file(cases.next());
    try {
      problem::Problem problem = problem::read_case(file, name, name + ".ini");
      problem::require_stationary_density(problem);
      return problem;
    } catch (const InputError&) {  // no stationary density: draw another problem
    }
  }
}

}  // namespace fpkcheck::tests
