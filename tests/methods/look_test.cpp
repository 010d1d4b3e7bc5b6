#include "methods/look.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "methods/builtin.hpp"

namespace fpkcheck::methods {
namespace {

using Rgb = std::array<double, 3>;
using transform::PlotStyle;

// Linear RGB values of "#RRGGBB".
Rgb light_of(const std::string& colour) {
  Rgb light{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double coded = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
    light[k] = coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
  }
  return light;
}

Rgb product(const std::array<Rgb, 3>& matrix, const Rgb& x) {
  Rgb y{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) y[i] += matrix[i][j] * x[j];
  }
  return y;
}

// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A physiologically-based model for simulation
// of color vision deficiency", IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291-1298, severity 1.
Rgb to_a_deuteranope(const Rgb& light) {
  return product({{{0.367322, 0.860646, -0.227968},
                   {0.280085, 0.672501, 0.047413},
                   {-0.011820, 0.042940, 0.968881}}},
                 light);
}

Rgb in_grey(const Rgb& light) {
  const double y = 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
  return {y, y, y};
}

// CIE 1976 L*a*b* under the white of sRGB.
Rgb lab(const Rgb& light) {
  const Rgb xyz = product(
      {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}}, light);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double apart(const Rgb& a, const Rgb& b) {
  const Rgb x = lab(a), y = lab(b);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

/// A style that may appear with others in the figure of a case or a sweep.
struct Shown {
  std::string id, family;
  PlotStyle plot_style;
};
std::vector<Shown> all_looks() {
  std::vector<Shown> all;
  const Registry registry = builtin();
  for (const auto* family : registry.families()) {
    for (const auto& id : family->usual) {
      const auto method = registry.by_id(id);
      all.push_back({id, family->name, method->identity.plot_style});
    }
  }
  for (std::size_t place = 0; place < 3; ++place) {
    all.push_back({"file-" + std::to_string(place), "file", given_look(place)});
  }
  return all;
}

// Whether two styles agree in marker, line and dashes. Markers distinguish lines as well.
bool same_without_colour(const PlotStyle& a, const PlotStyle& b) {
  constexpr double kBroad = 2;  // ratio of widths that distinguishes two lines
  return a.as_points == b.as_points && a.symbol == b.symbol && a.dash == b.dash &&
         a.width < kBroad * b.width && b.width < kBroad * a.width;
}

TEST(PlotStyle, OfEveryFamilyHasAMarkOfItsOwn) {
  std::set<std::string> families, marks;
  for (const auto& [id, family, plot_style] : all_looks()) {
    const bool is_new = families.insert(family).second;
    EXPECT_EQ(marks.insert(plot_style.symbol).second, is_new) << id << " " << plot_style.symbol;
  }
  EXPECT_EQ(families.size(), 6u);
}

TEST(PlotStyle, OfAnyTwoIsToldApartInGreyAndByADeuteranope) {
  constexpr double kApart = 15;  // L* difference, of 100 between black and white
  const auto all = all_looks();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_without_colour(all[i].plot_style, all[j].plot_style)) continue;
      const Rgb a = light_of(all[i].plot_style.colour), b = light_of(all[j].plot_style.colour);
      EXPECT_GT(apart(in_grey(a), in_grey(b)), kApart) << all[i].id << " " << all[j].id;
      EXPECT_GT(apart(to_a_deuteranope(a), to_a_deuteranope(b)), kApart)
          << all[i].id << " " << all[j].id;
    }
  }
}

// The schemes of a grid study also differ in their dashes.
TEST(PlotStyle, OfAnOrderOfTheSchemeIsOneOfFiniteDifferences) {
  std::set<std::string> dashes;
  for (std::size_t place = 0; place < 4; ++place) {
    EXPECT_EQ(scheme_look(place).symbol, equation_look({}).symbol);
    EXPECT_TRUE(dashes.insert(scheme_look(place).dash).second) << place;
  }
}

TEST(PlotStyle, IsSeenOnWhite) {
  for (const auto& [id, family, plot_style] : all_looks()) {
    constexpr double kSeen = 20;
    EXPECT_GT(apart(in_grey(light_of(plot_style.colour)), in_grey({1, 1, 1})), kSeen) << id;
  }
}

}  // namespace
}  // namespace fpkcheck::methods
