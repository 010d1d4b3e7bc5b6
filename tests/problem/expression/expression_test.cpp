#include "problem/expression/expression.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "refusal.hpp"

namespace fpkcheck::problem {
namespace {

const NamedConstants kConstants{{"mu", 0.1}, {"k", 2.0}};

Expression parse(const std::string& text) { return Expression::parse(text, kConstants, "f"); }

// The column, counted from 1, at which a formula is refused; 0 if it is accepted.
int refused_column(const std::string& text) {
  const std::string message = tests::refusal([&] { parse(text); }, "");
  const std::string word = "f column ";
  return message.starts_with(word) ? std::stoi(message.substr(word.size())) : 0;
}

TEST(Expression, InBatchesHasTheSameValuesUpToRounding) {
  for (const NamedFunction& f : kFunctions) {
    const std::string name(f.name);
    const Expression e = parse(name + (f.arguments == 1 ? "(3*y)" : "(3*y, v)") + " - v/k");
    const double ys[] = {0.3, -1.2, 1e-9, 0.019, 0.021, 0, -40, 300},
                 vs[] = {1, -2, 0, 0, 3, 0.5, 1, 2};
    double values[Expression::kBatchPoints], alone;
    e.evaluate_batch(Expression::kBatchPoints, ys, vs, values);
    for (int n = 0; n < Expression::kBatchPoints; ++n) {
      const double value = e(ys[n], vs[n]);
      if (std::isnan(value)) {
        EXPECT_TRUE(std::isnan(values[n])) << name << ys[n];
      } else if (std::isfinite(value)) {
        EXPECT_NEAR(values[n], value, 4e-15 * std::abs(value) + 1e-15 * std::abs(vs[n]))
            << name << ys[n];
      } else {
        EXPECT_EQ(values[n], value) << name << ys[n];
      }
      e.evaluate_batch(1, ys + n, vs + n, &alone);
      if (!std::isnan(value)) {
        EXPECT_EQ(alone, values[n]);
      }
    }
  }
  for (const char* text : {"y^1.5", "(y+v)^-2.5", "y^-3", "y^v", "y^0", "max(-y,0)^1.5"}) {
    const Expression e = parse(text);
    const double y = 0.7, v = 0.2;
    double value;
    e.evaluate_batch(1, &y, &v, &value);
    EXPECT_NEAR(value, e(y, v), 1e-14 * std::abs(e(y, v))) << text;
  }
}

TEST(Expression, InBatchesHasTheSameSlopes) {
  std::vector<std::string> texts{"y^1.5*v", "(y+v)^-2.5",    "v^-3",           "2^v",
                                 "v^y",     "max(-v,0)^1.5", "v*max(v,0)^0.5", "(v/y)/(1+v*v)"};
  for (const NamedFunction& f : kFunctions) {
    const std::string name(f.name);
    texts.push_back(name + (f.arguments == 1 ? "(3*v*y)" : "(3*v*y, v - y)") + " - v/k");
    texts.push_back(name + (f.arguments == 1 ? "(y)" : "(y, 2)") + "*v");
  }
  const double ys[] = {0.3, 1.2, 1e-9, 0.019, 0.021, 2, 40, 300},
               vs[] = {1, 2, 0, -0.3, 3, 0.5, -1, 2};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const Expression e = parse(text);
    double values[Expression::kBatchPoints], slopes[Expression::kBatchPoints],
        same[Expression::kBatchPoints];
    e.evaluate_batch_with_velocity_slopes(Expression::kBatchPoints, ys, vs, values, slopes);
    e.evaluate_batch(Expression::kBatchPoints, ys, vs, same);
    for (int n = 0; n < Expression::kBatchPoints; ++n) {
      if (std::isfinite(same[n])) {
        EXPECT_EQ(values[n], same[n]);
      }
      const double slope = e.derivative_in_v(ys[n], vs[n]);
      if (std::isfinite(slope)) {
        EXPECT_NEAR(slopes[n], slope, 1e-13 * (1 + std::abs(slope))) << n;
      } else {
        EXPECT_FALSE(std::isfinite(slopes[n])) << n;
      }
    }
  }
}

TEST(Expression, FollowsTheRulesOfPrecedence) {
  const double y = 0.7, v = -0.3;
  const std::pair<const char*, double> formulas[] = {
      {"1 + 2*3 - 4/8", 6.5},
      {"2 - 3 - 4", -5},
      {"8/4/2", 1},
      {"2^3^2", 512},
      {"-y^2", -0.49},
      {"(-y)^2", 0.49},
      {"2^-1", 0.5},
      {"- -y", 0.7},
      {"y^0", 1},
      {"y^-2", 1 / 0.49},
      {"2*y^2*v", -0.294},
      {"mu*y^3 + k*v", 0.1 * 0.343 - 0.6},
      {"pi", std::numbers::pi},
      {"1e-3 + .5", 0.501},
      {"max(y, v) - min(y, v)", 1},
      {"50*max(-y, 0)^1.5", 0},
      {"1 - 0.3*min(1, abs(v))^0.2", 1 - 0.3 * std::pow(0.3, 0.2)},
      {"sign(v)*sqrt(y)", -std::sqrt(0.7)}};
  for (const auto& [text, value] : formulas) EXPECT_NEAR(parse(text)(y, v), value, 1e-15) << text;
}

TEST(Expression, RefusesTextsOutsideTheGrammarAtTheirColumn) {
  const std::pair<std::string, int> formulas[] = {
      {"", 1},          {"y,v", 2},    {"y = 3", 3}, {"2y", 2},      {"2 y", 3},
      {"sin(y", 6},     {"foo(y)", 1}, {"y + z", 5}, {"max(y)", 6},  {"abs(y, v)", 6},
      {"y**2", 3},      {"1e400", 1},  {"y + ", 5},  {"1/0*y", 4},   {"y + \xc3\xbc", 5},
      {"y + sqrt", 5},  {"(y", 3},     {"y)", 2},    {"1.2.3*y", 4}, {"y + log(-1)", 12},
      {"y/(1 - 1)", 10}};
  for (const auto& [text, column] : formulas) EXPECT_EQ(refused_column(text), column) << text;
}

TEST(Expression, LimitsLengthNestingAndOperations) {
  std::string deep = "y", power = "y", sum = "y", allowed = "y";
  for (int n = 0; n < 101; ++n) deep = "(" + deep + ")";
  for (int n = 0; n < 60; ++n) power = "y + y*y^(" + power + ")";
  for (int n = 0; n < 1500; ++n) sum += "+y";
  for (int n = 0; n < 45; ++n) allowed = "(y + " + allowed + ")";
  EXPECT_GT(refused_column(deep), 0);
  EXPECT_GT(refused_column(power), 0);
  EXPECT_GT(refused_column(sum), 0);
  EXPECT_NE(tests::refusal([] { parse(std::string(5000, ' ') + "y"); }), "accepted");
  EXPECT_EQ(parse(allowed)(1.0, 0.0), 46);
}

// Every function of the grammar: slopes against differences, parity against values.
TEST(Expression, FunctionsHaveTheirSlopesAndParity) {
  constexpr double kStep = 1e-5;
  for (const NamedFunction& f : kFunctions) {
    for (const double a : {0.3, 0.8}) {
      const double b = 0.5;
      const double in_first = (f.value(a + kStep, b) - f.value(a - kStep, b)) / (2 * kStep);
      EXPECT_NEAR(f.slope(a, b), in_first, 1e-8) << f.name;
      if (f.arguments == 2) {
        const double in_second = (f.value(a, b + kStep) - f.value(a, b - kStep)) / (2 * kStep);
        EXPECT_NEAR(f.slope_in_second(a, b), in_second, 1e-8) << f.name;
      }
      if (f.parity != FunctionParity::none) {
        const double sign = f.parity == FunctionParity::even ? 1 : -1;
        EXPECT_EQ(f.value(-a, -b), sign * f.value(a, b)) << f.name;
      }
    }
  }
}

TEST(Expression, DerivativesAgreeWithDifferences) {
  constexpr double kStep = 1e-5, y = 0.7, v = -0.3;
  for (const char* text :
       {"0.2*v*abs(v) + y + 0.1*y^3", "y/(1 + y^2) - (2 + v)^-2", "y^1.5*exp(v*y)",
        "(1 + y^2)^(v + 2)", "max(y*v, y - 1) + tanh(20*v)", "-v^3/k"}) {
    const Expression f = parse(text);
    EXPECT_NEAR(f.derivative_in_y(y, v), (f(y + kStep, v) - f(y - kStep, v)) / (2 * kStep), 1e-7)
        << text;
    EXPECT_NEAR(f.derivative_in_v(y, v), (f(y, v + kStep) - f(y, v - kStep)) / (2 * kStep), 1e-7)
        << text;
  }
}

TEST(Expression, HasTheCoefficientsOfItsPolynomial) {
  const auto expect = [](const char* text, const BivariateCoefficients& coefficients) {
    EXPECT_EQ(parse(text).polynomial_coefficients(), coefficients) << text;
  };
  expect("3*(y^2 - 1)*v + y", {{{2, 1}, 3}, {{0, 1}, -3}, {{1, 0}, 1}});
  expect("(y + v)^3/2 - y^3/2", {{{2, 1}, 1.5}, {{1, 2}, 1.5}, {{0, 3}, 0.5}});
  expect("k*y - 2*y", {});
  expect("mu", {{{0, 0}, 0.1}});
  for (const char* text : {"abs(y)", "y^1.5", "y^-1", "1/y", "2^y", "tanh(v)", "y^13"}) {
    EXPECT_FALSE(parse(text).polynomial_coefficients()) << text;
  }
}

TEST(Expression, HasTheParityOfItsForm) {
  for (const char* text : {"0.1*v + 0.05*tanh(20*v) + y^3", "v*abs(v)", "y/(1 + v^2)", "-sin(y)"}) {
    EXPECT_EQ(parse(text).parity(), FunctionParity::odd) << text;
  }
  for (const char* text : {"3", "y*v", "cos(y) + v^2", "abs(y - v)", "sqrt(1 + y^2)^1.5"}) {
    EXPECT_EQ(parse(text).parity(), FunctionParity::even) << text;
  }
  for (const char* text : {"y + 1", "max(y, 0)", "exp(y)", "y^2 + y^3", "abs(y + 1)"}) {
    EXPECT_EQ(parse(text).parity(), FunctionParity::none) << text;
  }
}

TEST(Expression, FindsKinksOnLinesOfTheAxes) {
  const auto near = [](const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t n = 0; n < found.size(); ++n) EXPECT_NEAR(found[n], expected[n], 1e-12);
  };
  const Expression f = parse("4*max(y - 0.5, 0) + abs(y^2 - 2)*v + 0.2*sign(v + 1)");
  near(f.kinks_in_y(-3, 3), {-std::sqrt(2), 0.5, std::sqrt(2)});
  near(f.kinks_in_v(-3, 3), {-1});
  EXPECT_TRUE(f.has_jumps());
  EXPECT_TRUE(f.has_jumps_in_v());
  EXPECT_FALSE(parse("0.1*v + sign(y)").has_jumps_in_v());
  EXPECT_TRUE(f.has_jumps_at_nonzero_v(3));
  EXPECT_FALSE(f.has_jumps_at_nonzero_v(0.9));
  EXPECT_FALSE(parse("0.2*sign(v) + sign(y)").has_jumps_at_nonzero_v(3));
  EXPECT_TRUE(parse("sign(v - y)").has_jumps_at_nonzero_v(3));
  EXPECT_FALSE(f.has_kinks_along_other_curves());
  EXPECT_TRUE(parse("abs(y - v)").has_kinks_along_other_curves());
  EXPECT_FALSE(parse("tanh(y - v)").has_kinks_along_other_curves());
  near(parse("max(-y, 5 + y^1001)").kinks_in_y(-2.9, 4), {-1.001385522307552});
  // An argument of abs() that is zero for y > 0 adds no kink to that of min().
  near(parse("abs(min(y, 0))^1.5").kinks_in_y(-3, 4), {0});
  near(parse("abs(min(y, 0))^1.5").kinks_in_y(-3, 3), {0});
  near(parse("abs(y)").kinks_in_y(-3, 3), {0});
  near(parse("abs(abs(abs(y) - 2) - 1)").kinks_in_y(-3.5, 3.5), {-3, -2, -1, 0, 1, 2, 3});
}

TEST(Expression, MaximumAndMinimumOfNoNumberAreNoNumbers) {
  for (const char* text : {"max(sqrt(y), 0)", "max(0, sqrt(y))", "min(sqrt(y), 0)",
                           "min(0, sqrt(y))", "max(v, log(y))"}) {
    const Expression f = parse(text);
    const double y = -1, v = 2;
    double in_batch = 0;
    f.evaluate_batch(1, &y, &v, &in_batch);
    EXPECT_TRUE(std::isnan(f(y, v))) << text;
    EXPECT_TRUE(std::isnan(in_batch)) << text;
  }
}

double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The limits bound the time of a formula: at most a microsecond for each operation, and a search
// for kinks and coefficients whose time is linear in the number of operations.
TEST(Expression, TakesAtMostAMicrosecondPerOperation) {
  std::vector<std::string> terms{"(y+v)^64", "y^(v+.3)", "y/(v+7)"};
  for (const NamedFunction& f : kFunctions) {
    terms.push_back(std::string(f.name) + (f.arguments == 1 ? "(1e9*y)" : "(1e9*y, v)"));
  }
  for (const std::string& term : terms) {
    std::string text = term;
    int count = 1;
    for (; count < 250 && text.size() < 3900; ++count) text += "+" + term;
    const Expression f = parse(text);
    double fastest = 1, y = 0.37, sum = 0;  // of several tries, on a loaded computer
    for (int n = 0; n < 20; ++n) fastest = std::min(fastest, seconds([&] { sum += f(y, 0.2); }));
    EXPECT_LT(fastest, 1e-6 * 3 * count) << term;
    EXPECT_FALSE(std::isnan(sum)) << term;
  }
  // Nested kinks: the search evaluates all of them at once.
  std::string wide = "sin(9*y)";
  for (int n = 0; n < 300; ++n) wide += "+sin(y)";
  const auto seconds_of_search = [&](int depth) {
    std::string nested = wide;
    for (int n = 0; n < depth; ++n) nested = "abs(" + nested + "-.1)";
    const Expression f = parse(nested);
    double fastest = 10;
    for (int n = 0; n < 3; ++n) fastest = std::min(fastest, seconds([&] { f.kinks_in_y(2, 3); }));
    return fastest;
  };
  EXPECT_LT(seconds_of_search(45), 4 * seconds_of_search(3));
  std::string expanded = "(1+y+v)^12";
  for (int n = 0; n < 250; ++n) expanded += "+(1+y+v)^12";
  EXPECT_LT(seconds([&] { parse(expanded).polynomial_coefficients(); }), 2);
}

}  // namespace
}  // namespace fpkcheck::problem
