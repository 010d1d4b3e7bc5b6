#include "methods/plot_style.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "methods/builtin_solvers.hpp"

namespace fpkcheck::methods {
namespace {

using Rgb = std::array<double, 3>;
using transform::PlotStyle;

// Linear RGB values of "#RRGGBB".
Rgb linear_rgb(const std::string& colour) {
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
Rgb in_deuteranopia(const Rgb& light) {
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

double colour_difference(const Rgb& a, const Rgb& b) {
  const Rgb x = lab(a), y = lab(b);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

/// A style that may appear with others in the figure of a case or a sweep.
struct NamedStyle {
  std::string id, family;
  PlotStyle plot_style;
};
std::vector<NamedStyle> all_styles() {
  std::vector<NamedStyle> all;
  const SolverRegistry registry = builtin_registry();
  for (const auto* family : registry.method_families_by_trust()) {
    for (const auto& id : family->default_ids) {
      const auto method = registry.find_method_by_id(id);
      all.push_back({id, family->name, method->identity.plot_style});
    }
  }
  for (std::size_t rank = 0; rank < 3; ++rank) {
    all.push_back({"file-" + std::to_string(rank), "file", external_density_style(rank)});
  }
  return all;
}

// Whether two styles agree in marker, line and dashes. Markers distinguish lines as well.
bool same_without_colour(const PlotStyle& a, const PlotStyle& b) {
  constexpr double kWidthRatio = 2;  // ratio of widths that distinguishes two lines
  return a.as_points == b.as_points && a.symbol == b.symbol && a.dash == b.dash &&
         a.width < kWidthRatio * b.width && b.width < kWidthRatio * a.width;
}

TEST(PlotStyle, FamiliesHaveDistinctMarkers) {
  std::set<std::string> families, marks;
  for (const auto& [id, family, plot_style] : all_styles()) {
    const bool is_new = families.insert(family).second;
    EXPECT_EQ(marks.insert(plot_style.symbol).second, is_new) << id << " " << plot_style.symbol;
  }
  EXPECT_EQ(families.size(), 10u);
}

TEST(PlotStyle, PairsAreDistinguishableInGreyAndInDeuteranopia) {
  constexpr double kMinDifference = 15;  // L* difference, of 100 between black and white
  const auto all = all_styles();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_without_colour(all[i].plot_style, all[j].plot_style)) continue;
      const Rgb a = linear_rgb(all[i].plot_style.colour), b = linear_rgb(all[j].plot_style.colour);
      EXPECT_GT(colour_difference(in_grey(a), in_grey(b)), kMinDifference)
          << all[i].id << " " << all[j].id;
      EXPECT_GT(colour_difference(in_deuteranopia(a), in_deuteranopia(b)), kMinDifference)
          << all[i].id << " " << all[j].id;
    }
  }
}

// The schemes of a grid study also differ in their dashes.
TEST(PlotStyle, SchemesHaveTheMarkerOfEquations) {
  std::set<std::string> dashes;
  for (std::size_t rank = 0; rank < 4; ++rank) {
    EXPECT_EQ(finite_volume_scheme_style(rank).symbol, density_equation_style({}).symbol);
    EXPECT_TRUE(dashes.insert(finite_volume_scheme_style(rank).dash).second) << rank;
  }
}

TEST(PlotStyle, IsVisibleOnWhite) {
  for (const auto& [id, family, plot_style] : all_styles()) {
    constexpr double kMinContrast = 20;
    EXPECT_GT(colour_difference(in_grey(linear_rgb(plot_style.colour)), in_grey({1, 1, 1})),
              kMinContrast)
        << id;
  }
}

}  // namespace
}  // namespace fpkcheck::methods
