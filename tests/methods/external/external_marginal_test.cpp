#include "methods/external/external_marginal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "refusal.hpp"
#include "saved_run.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::methods {
namespace {

using tests::contains;
using transform::StateVariable;

const problem::Walls kPaper{.left = problem::Wall{0, 1}, .right = {}};

ExternalMarginal read(const std::string& text, const problem::Walls& walls = kPaper) {
  std::istringstream in(text);
  return {read_number_table(in, "mine.csv"), walls};
}

std::string refusal(const std::string& text, const problem::Walls& walls = kPaper) {
  return tests::refusal([&] { read(text, walls); });
}

double bell(double v) { return std::exp(-v * v / 2) / std::sqrt(2 * M_PI); }
double bell_below(double v) { return 0.5 * std::erfc(-v / std::sqrt(2.0)); }

using tests::uniform_edges;

// L1 distance from the normal density (from twice that density on y >= 0).
double l1_to_bell(const transform::Marginal& m, double factor = 1) {
  double sum = 0;
  for (std::size_t b = 0; b < m.size(); ++b) {
    const double exact = factor * (bell_below(m.edges[b + 1]) - bell_below(m.edges[b]));
    sum += std::abs(m.density[b] * m.bin_width(b) - exact);
  }
  return sum;
}

std::string points(double scale, const std::string& header, const char* row, double from = -5) {
  std::string text = header;
  for (int k = 0; k <= 100; ++k) {
    const double x = from + 0.1 * k;
    text += fmt::format(fmt::runtime(row), x, scale * bell(x));
  }
  return text;
}

std::string histogram(double scale, const std::string& header, bool counts) {
  std::string text = header;
  for (int k = 0; k < 50; ++k) {
    const double a = -5 + 0.2 * k, b = a + 0.2;
    const double mass = scale * (bell_below(b) - bell_below(a));
    text += counts ? fmt::format("{:.9g},{:.9g},{:.0f}\n", a, b, mass)
                   : fmt::format("{:.9g},{:.9g},{}\n", a, b, mass / 0.2);
  }
  return text;
}

TEST(ExternalMarginal, IsReadInAllFormats) {
  const auto edges = uniform_edges(-6, 6, 77);
  for (const std::string& text :
       {points(1, "", "{},{}\n"), points(1, "v,p(v)\n", "{},{}\r\n"),
        points(1, "\xEF\xBB\xBFVelocity;Density\n", "{};{}\n"),
        points(1, "# run 7\n\n# y' p\n", "  {}   {} \n"), points(1, "\"v\"\t\"p\"\n", "{}\t{}\n"),
        points(1, "", "{},+{},0.01\n")}) {
    const ExternalMarginal marginal = read(text);
    EXPECT_EQ(marginal.variable(), StateVariable::ydot) << text.substr(0, 40);
    EXPECT_EQ(marginal.file().form, "points");
    EXPECT_LT(l1_to_bell(marginal.average_over_bins(edges)), 2e-4) << text.substr(0, 40);
    EXPECT_NEAR(marginal.moment(2), 1, 2e-3);
    EXPECT_FALSE(marginal.file().divided_by);
  }
  for (const std::string& text :
       {histogram(1, "", false), histogram(1, "lower,upper,density\n", false),
        histogram(1e8, "", true), histogram(1e8, "from,to,count\n", true)}) {
    const ExternalMarginal marginal = read(text);
    EXPECT_EQ(marginal.file().form, "histogram");
    EXPECT_LT(l1_to_bell(marginal.average_over_bins(edges)), 2e-3) << text.substr(0, 40);
    EXPECT_LT(l1_to_bell(marginal.average_over_bins(uniform_edges(-5, 5, 25))), 1e-6)
        << "where edges coincide";
  }
}

TEST(ExternalMarginal, ConvergesWithTheNumberOfPoints) {
  const auto error = [](int n, bool bins) {
    std::string text;
    for (int k = 0; k <= n - bins; ++k) {
      const double x = -6 + 12.0 * k / n, next = x + 12.0 / n;
      text += bins ? fmt::format("{:.12g} {:.12g} {}\n", x, next,
                                 (bell_below(next) - bell_below(x)) / (next - x))
                   : fmt::format("{} {}\n", x, bell(x));
    }
    return l1_to_bell(read(text).average_over_bins(uniform_edges(-6, 6, 131)));
  };
  const double points_order = std::log2(error(40, false) / error(80, false));
  EXPECT_GT(points_order, 2) << error(40, false) << " " << error(80, false);
  EXPECT_LT(points_order, 4.5);
  const double bins_order = std::log2(error(40, true) / error(80, true));
  EXPECT_GT(bins_order, 1.5) << error(40, true) << " " << error(80, true);
  EXPECT_LT(bins_order, 3.5);
}

TEST(ExternalMarginal, DetectsItsVariableByNamesOrSigns) {
  const std::string rows = "0 1\n1 1\n2 1\n3 1\n";
  EXPECT_EQ(read(rows).variable(), StateVariable::y);
  EXPECT_EQ(read("ydot p\n" + rows).variable(), StateVariable::ydot);
  EXPECT_EQ(read("x p(y')\n" + rows).variable(),
            StateVariable::y);  // contradictory names: by signs
  EXPECT_EQ(read("-1 1\n" + rows).variable(), StateVariable::ydot);
  EXPECT_TRUE(contains(refusal("y p\n-1 1\n" + rows),
                       "mine.csv:2: y = -1 under the names 'y,p' (must be y >= 0; name"));
  EXPECT_TRUE(contains(refusal("x p\n-1 1\n" + rows), "name the abscissa 'v' for"));
}

TEST(ExternalMarginal, IgnoresUnitsInNames) {
  const std::string rows = "0,1\n1,1\n2,1\n3,1\n";
  for (const char* header : {"velocity [m/s],density [s/m]\n", "Velocity (m/s),p (s/m)\n",
                             "y'[m/s],p\n", "bin,p(y') [s/m]\n", "# dy/dt [m/s] p [s/m]\n"}) {
    EXPECT_EQ(read(header + rows).variable(), StateVariable::ydot) << header;
  }
  const std::string negative = "-1,1\n" + rows;
  // Files often name any ordinate y.
  EXPECT_EQ(read("x,y\n" + negative).variable(), StateVariable::ydot);
  EXPECT_EQ(read("x,y\n" + rows).variable(), StateVariable::y);
  EXPECT_EQ(read("v,y\n" + rows).variable(), StateVariable::ydot);
  EXPECT_TRUE(contains(refusal("y,y\n" + negative), "under the names 'y,y'"));
  EXPECT_TRUE(contains(refusal("x [mm],p [1/mm]\n" + negative), "under the names 'x,p'"));
}

TEST(ExternalMarginal, IsNormalisedOnlyIfItsMassIsFarFromOne) {
  const auto edges = uniform_edges(-6, 6, 77);
  const ExternalMarginal tripled = read(points(3, "", "{} {}\n"));
  EXPECT_NEAR(tripled.file().divided_by.value(), 3, 1e-3);
  EXPECT_LT(l1_to_bell(tripled.average_over_bins(edges)), 2e-4);
  EXPECT_NEAR(tripled.moment(0), 1, 1e-12);
  const ExternalMarginal nearly = read(points(0.95, "", "{} {}\n"));
  EXPECT_FALSE(nearly.file().divided_by);
  EXPECT_NEAR(l1_to_bell(nearly.average_over_bins(edges)), 0.05, 1e-3);
}

TEST(ExternalMarginal, CountsOfUnequalBinsAreNotDensities) {
  const std::string rows = "0,1,10\n1,2,10\n2,4,10\n4,8,10\n";
  const auto first_bin = [](const std::string& text) {
    return read(text).average_over_bins(std::vector<double>{0, 1, 2, 4, 8, 9}).density[0];
  };
  EXPECT_NEAR(first_bin("lower,upper,count\n" + rows), 1.0 / 4, 1e-12);
  EXPECT_NEAR(first_bin(rows), 1.0 / 4, 1e-12);
  EXPECT_NEAR(first_bin("0,1,0.5\n" + rows.substr(7)), 0.5 / 70.5, 1e-12);  // not integers
  const auto whole = read("0,0.25,2\n0.25,0.75,1\n0.75,1,0\n1,2,0\n");      // integral 1
  EXPECT_NEAR(whole.average_over_bins(std::vector<double>{0, 0.25}).density[0], 2, 1e-12);
  const auto on = read(rows).average_over_bins(std::vector<double>{2, 4, 8, 9});
  EXPECT_NEAR(on.density[0], 0.125, 1e-12);
  EXPECT_NEAR(on.density[1], 0.0625, 1e-12);
  EXPECT_EQ(on.density[2], 0);
}

TEST(ExternalMarginal, DistinguishesProbabilitiesCountsAndDensities) {
  const auto first_bin = [](const std::string& text) {
    return read(text).average_over_bins(std::vector<double>{0, 0.5, 1, 2, 4}).density[0];
  };
  const auto values = [](const std::string& text) { return read(text).file().values; };
  const auto note = [](const std::string& text) { return read(text).file().notes.front(); };
  const std::string shares = "0,0.5,0.4\n0.5,1,0.3\n1,2,0.2\n2,4,0.1\n";
  EXPECT_EQ(values(shares), "probability");
  EXPECT_NEAR(first_bin(shares), 0.8, 1e-12);
  EXPECT_TRUE(contains(note(shares), "the probabilities per bin were divided by the bin widths"));
  EXPECT_FALSE(read(shares).file().divided_by);
  EXPECT_NEAR(first_bin("lower,upper,density\n" + shares), 0.4 / 0.75, 1e-12);  // normalised

  const std::string percent = "0,0.5,40\n0.5,1,30.5\n1,2,19.5\n2,4,10\n";
  EXPECT_EQ(values("from,to,probability [%]\n" + percent), "probability");
  EXPECT_NEAR(first_bin("from,to,probability [%]\n" + percent), 0.8, 1e-12);
  EXPECT_EQ(values(percent), "density");

  const std::string few = "0,0.5,2\n0.5,1,1\n1,1.02,1\n1.02,1.04,1\n";  // integral 1.54
  EXPECT_EQ(values(few), "count");
  EXPECT_NEAR(first_bin(few), 2 / 5.0 / 0.5, 1e-12);
  EXPECT_TRUE(contains(note(few), "the counts were divided by their sum, 5"));
  for (const char* header : {"a,b,samples\n", "a,b,frequency\n", "a,b,n\n", "a,b,Counts [-]\n"}) {
    EXPECT_EQ(values(header + few), "count") << header;
    EXPECT_EQ(values(header + shares), "probability") << header;
  }
  EXPECT_EQ(values("0,0.25,2\n0.25,0.75,1\n0.75,1,0\n1,2,0\n"), "density");  // integral 1
}

TEST(ExternalMarginal, DoesNotMistakeBinsWithGapsForPoints) {
  const std::string gaps = "0,0.032,1\n0.033,0.066,9\n0.067,0.1,9\n0.101,0.133,3\n";
  EXPECT_TRUE(
      contains(refusal(gaps), "mine.csv:2: a bin from 0.033 after a bin to 0.032 (bins must"));
  EXPECT_TRUE(contains(refusal("0 9 5\n10 19 7\n20 29 3\n30 39 1\n"), "bins must adjoin"));
  EXPECT_TRUE(contains(refusal("x,p,samples\n0,3,5\n1,2,7\n2,1,3\n3,0,1\n"), "bins must adjoin"));
  const auto points =
      read("0 0.9 0.1\n1 1.2 0.1\n2 2.1 0.1\n3 0.1 0.1\n");  // the last row is no bin
  EXPECT_EQ(points.file().form, "points");
}

TEST(ExternalMarginal, NotesACutOff) {
  const ExternalMarginal cut = read(points(1, "v p\n", "{} {}\n", -1));  // from -1 to 9
  const auto on = cut.average_over_bins(uniform_edges(-3, 3, 6));
  EXPECT_EQ(on.density[0], 0);
  EXPECT_EQ(on.density[1], 0);
  EXPECT_NEAR(on.density[2], (bell_below(0) - bell_below(-1)) / 1 / bell_below(1), 1e-3);
  ASSERT_EQ(cut.file().notes.size(), 2u);  // normalisation; cut-off at -1 only
  EXPECT_TRUE(contains(cut.file().notes[1], "p(y') is cut off at -1, at 0.6"));
  EXPECT_EQ(cut.file().from, -1);
  EXPECT_TRUE(read(points(1, "", "{} {}\n")).file().notes.empty());
}

TEST(ExternalMarginal, IsExtrapolatedToTheWall) {
  std::string centres, far;
  for (int k = 0; k < 60; ++k) {
    const double y = 0.05 + 0.1 * k;
    centres += fmt::format("{} {}\n", y, 2 * bell(y));
    if (k >= 3) far += fmt::format("{} {}\n", y, 2 * bell(y));
  }
  const auto edges = uniform_edges(0, 6, 60);
  EXPECT_LT(l1_to_bell(read(centres).average_over_bins(edges), 2), 1e-3);
  EXPECT_EQ(read(far).average_over_bins(edges).density[0], 0);
  std::string steep;
  for (int k = 0; k < 60; ++k)
    steep += fmt::format("{} {}\n", 0.1 + 0.2 * k, std::exp(-0.1 - 0.2 * k));
  EXPECT_NEAR(read(steep).average_over_bins(std::vector<double>{0, 0.1}).density[0],
              (1 - std::exp(-0.1)) / 0.1, 6e-3);
  EXPECT_TRUE(contains(read(far).file().notes.back(), "is cut off at 0.35"));
}

TEST(ExternalMarginal, HasIntervalsIfItHasStandardErrors) {
  const ExternalMarginal marginal = read(points(1, "v p error\n", "{} {} 0.01\n"));
  const auto on = marginal.average_over_bins(uniform_edges(-6, 6, 60));
  ASSERT_EQ(on.lower.size(), 60u);
  // The bins are two intervals wide: the trapezoidal rule has the weights 1/4, 1/2, 1/4.
  const double half = 1.959964 * 0.01 * std::sqrt(6.0) / 4;
  EXPECT_NEAR(on.upper[30] - on.density[30], half, 1e-6);
  EXPECT_NEAR(on.density[30] - on.lower[30], half, 1e-6);
  EXPECT_EQ(on.upper[0], 0);  // outside the file's range
  EXPECT_GE(on.lower[8], 0);
  EXPECT_TRUE(
      read(points(1, "", "{} {}\n")).average_over_bins(uniform_edges(0, 1, 2)).lower.empty());
}

// L1 distances from the exact density for many files of the density 1 on 0..1 with noise at its
// points.
void expect_sampling_error(int points, int bins, bool centres) {
  constexpr int kFiles = 400;
  constexpr double kError = 0.05;
  const auto edges = uniform_edges(0, 1, bins);
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  double sum = 0, squares = 0;
  int above = 0;
  L1SamplingError announced;
  for (int file = 0; file < kFiles; ++file) {
    std::string text = "y p error\n";
    for (int k = 0; k < points; ++k) {
      const double y = centres ? (k + 0.5) / points : k / (points - 1.0);
      text += fmt::format("{:.9g} {} {}\n", y, 1 + kError * normal(engine), kError);
    }
    if (centres) text += "1 1 0\n";
    const ExternalMarginal marginal = read(text);
    if (file == 0) announced = marginal.l1_sampling_error(edges);
    double distance = 0;
    const auto on = marginal.average_over_bins(edges);
    for (std::size_t b = 0; b < on.size(); ++b) distance += std::abs(on.density[b] - 1) / bins;
    sum += distance;
    squares += distance * distance;
    above += distance > announced.quantile_99;
  }
  const double mean = sum / kFiles;
  const double chance = std::sqrt((squares / kFiles - mean * mean) / kFiles);
  // Linear interpolation between sparse points varies up to 8 % less than Akima's interpolant.
  EXPECT_NEAR(mean, announced.expected, 4 * chance + 0.08 * mean) << points << " " << bins;
  EXPECT_GE(mean, announced.expected - 4 * chance) << points << " " << bins;
  EXPECT_LE(above, 0.04 * kFiles) << points << " " << bins;
  EXPECT_LT(announced.quantile_99,
            announced.expected * (1 + 4 / std::sqrt(std::min(points, bins))));
}

TEST(ExternalMarginal, EstimatesItsSamplingError) {
  expect_sampling_error(200, 20, false);  // 10 points per bin
  expect_sampling_error(41, 40, false);
  expect_sampling_error(11, 100, false);  // 10 bins between points
  expect_sampling_error(10, 20, true);    // linear extrapolation to the wall
}

TEST(ExternalMarginal, HasTheErrorsOfBinAverages) {
  const auto errors = [](const std::string& text, const std::vector<double>& edges) {
    std::vector<double> result;
    const auto on = read("y p error\n" + text).average_over_bins(edges);
    for (std::size_t b = 0; b < on.size(); ++b) {
      result.push_back((on.upper[b] - on.density[b]) / 1.959964);
    }
    return result;
  };
  const std::string equal = "0 0.32 0.01\n1 0.32 0.01\n2 0.32 0.01\n3 0.32 0.02\n";
  const auto on = errors(equal, {0, 0.5, 2, 2.5, 3.5, 4, 5});
  EXPECT_NEAR(on[0], 0.01 * std::hypot(0.75, 0.25), 1e-9);
  EXPECT_NEAR(on[1], 0.01 / 1.5 * std::hypot(0.125, 0.875, 0.5), 1e-9);
  EXPECT_NEAR(on[2], std::hypot(0.01 * 0.75, 0.02 * 0.25), 1e-9);
  EXPECT_NEAR(on[3], 0.5 * std::hypot(0.01 * 0.25, 0.02 * 0.75),
              1e-9);  // half of the bin is outside
  EXPECT_EQ(on[4], 0);
  // The average over 0..0.5 is the extrapolated value at 0.25, p1 - (p2 - p1) / 4.
  const auto wall = errors("0.5 0.3 0.01\n1.5 0.3 0.03\n2.5 0.3 0.01\n3.5 0.3 0.01\n", {0, 0.5});
  EXPECT_NEAR(wall[0], std::hypot(1.25 * 0.01, 0.25 * 0.03), 1e-9);
}

TEST(ExternalMarginal, ComputesTheMassOutsideARange) {
  const ExternalMarginal marginal = read(points(3, "v p\n", "{} {}\n"));
  EXPECT_NEAR(marginal.mass_fraction_outside(-6, 6), 0, 1e-12);
  EXPECT_NEAR(marginal.mass_fraction_outside(-1, 2), bell_below(-1) + bell_below(-2), 1e-4);
  EXPECT_NEAR(marginal.mass_fraction_outside(7, 8), 1, 1e-12);
}

TEST(ExternalMarginal, RefusesInvalidFiles) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"", "no numbers (must be two or three columns"},
      {"y p\n", "no numbers"},
      {"1\n2\n", "mine.csv:1: 1 column (must be two or three)"},
      {"1 2 3 4\n", "mine.csv:1: 4 columns (must be two or three)"},
      {"0 1\n1 1 1\n", "mine.csv:2: 3 columns after rows of 2"},
      {"y p\n0 1\n1 one\n", "mine.csv:3: 'one' is not a number"},
      {"0 half\n1 1\n", "mine.csv:1: 'half' is not a number"},
      {"0,0;0,5\n1;0,5\n", "mine.csv:2: '0,5' is not a number"},
      {"0;1\n1;0,5\n", "mine.csv:2: '0,5' is not a number; use a decimal point"},
      {"0 1\n1 nan\n", "mine.csv:2: nan (numbers must be finite)"},
      {"0 1\n1 inf\n", "mine.csv:2: inf (numbers must be finite)"},
      {"0 1\n1 1\n\n# more\n2 1\n", "mine.csv:5: 3 rows (must be at least 4)"},
      {"0 1\n2 1\n1 1\n3 1\n", "mine.csv:3: 1 after 2 (must increase)"},
      {"0 1\n1 1\n1 1\n3 1\n", "mine.csv:3: 1 after 1 (must increase)"},
      {"0 1\n1 -0.5\n2 1\n3 1\n", "mine.csv:2: density -0.5 (must not be negative)"},
      {"0 1 1\n1 1 -1\n2 1 1\n3 1 1\n", "mine.csv:2: standard error -1 (must not be negative)"},
      {"0 1 1\n1 2 -1\n2 3 1\n3 4 1\n", "mine.csv:2: density or count -1 (must not"},
      {"lower upper p\n0 1 1\n1 2 1\n2.5 3 1\n3 4 1\n",
       "mine.csv:4: a bin from 2.5 after a bin to 2 (bins must adjoin)"},
      {"0 0\n1 0\n2 0\n3 0\n", "0 everywhere"},
      {"0 1e308\n1 1e308\n2 1e308\n3 1e308\n", "the integral overflows"},
      {"y p q\n0 1\n1 1\n2 1\n3 1\n", "mine.csv:2: 2 columns under 3 names"},
  };
  for (const auto& [text, expected] : bad) {
    const std::string message = refusal(text);
    EXPECT_TRUE(contains(message, expected)) << expected << " not in: " << message;
    EXPECT_TRUE(message.starts_with("mine.csv")) << message;
    EXPECT_FALSE(contains(message, "\n")) << message;
  }
}

TEST(ExternalMarginal, RequiresOneSeparator) {
  EXPECT_TRUE(contains(refusal("0,1\n1,2\n2;3\n3,1\n"),
                       "mine.csv:3: fields separated by semicolons after rows with commas"));
  EXPECT_TRUE(contains(refusal("0 1\n1\t2\n2 3\n3 1\n"),
                       "mine.csv:2: fields separated by tabs after rows with blanks"));
}

TEST(ExternalMarginal, PrintsAllDigitsOfAbscissae) {
  EXPECT_TRUE(contains(refusal("0 1\n0.30000000000000004 2\n0.3 3\n3 1\n"),
                       "mine.csv:3: 0.3 after 0.30000000000000004 (must increase)"));
}

TEST(ExternalMarginal, RefusesCountsThatOverflow) {
  EXPECT_TRUE(contains(refusal("lower,upper,count\n0,1,1e308\n1,2,1e308\n2,3,1e308\n3,4,1\n"),
                       "the integral overflows"));
  // The sum is finite, but the density in narrow bins overflows.
  const std::string narrow =
      refusal("lower,upper,count\n0,1e-9,1e308\n1e-9,2e-9,5e307\n2e-9,3e-9,1\n3e-9,4e-9,1\n");
  EXPECT_TRUE(contains(narrow, "; choose other units")) << narrow;
}

TEST(ExternalMarginal, RefusesBinsWithinABin) {
  // The gap to the inner bin is small relative to the width of the outer bin.
  EXPECT_TRUE(contains(refusal("lower,upper,count\n-1e9,2,0\n-9,2,1\n2,3,1\n3,4,1\n"),
                       "mine.csv:3: a bin from -9 after a bin to 2 (bins must adjoin)"));
  EXPECT_TRUE(contains(refusal("lower,upper,count\n-1e9,2,0\n-9,3,1\n3,4,1\n4,5,1\n"),
                       "mine.csv:3: a bin from -9 after a bin to 2 (bins must adjoin)"));
  // Widths that overflow.
  const std::string widest = "-1.7e308,1.7e308,0\n-1.2e307,1.7e308,1\n";
  EXPECT_TRUE(
      contains(refusal("lower,upper,count\n" + widest + "2,3,1\n3,4,1\n"),
               "mine.csv:3: a bin from -1.2e+307 after a bin to 1.7e+308 (bins must adjoin)"));
  EXPECT_TRUE(contains(refusal("lower,upper,count\n0,1,1\n1,1,1\n2,3,1\n3,4,1\n"),
                       "mine.csv:3: a bin from 1 to 1 (edges must increase)"));
}

TEST(ExternalMarginal, RefusesTooManyRowsAndTooLongLines) {
  std::string rows;
  for (int k = 0; k <= 100000; ++k) rows += fmt::format("{} 1\n", k);
  EXPECT_TRUE(contains(refusal(rows), "mine.csv:100001: more than 100000 rows"));
  EXPECT_TRUE(contains(refusal(std::string(20000, '1') + " 2\n"), "mine.csv:1: a line of"));
}

}  // namespace
}  // namespace fpkcheck::methods
