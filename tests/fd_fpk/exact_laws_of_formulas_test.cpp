// Exact joint densities of oscillators whose force, noise factor or restitution is a formula. The
// L1 error of both marginals must be below 1e-5 and below twice the stated error.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "fd_fpk/solve.hpp"
#include "general_oscillators.hpp"
#include "problem/case_file.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::StateVariable;
using transform::Status;

problem::Problem read(const std::string& text) {
  std::istringstream ini(text);
  return problem::read_case(ini, "test", "test.ini", {}, problem::CaseNamingRule::with_overrides);
}

std::string without_wall(const std::string& force, const std::string& excitation) {
  return "[system]\nforce = " + force + "\n[wall]\nnone = true\n" + excitation;
}

std::string noise(const std::string& factor, const std::string& interpretation = "") {
  return "[noise]\nintensity = 0.2\nfactor = " + factor +
         (interpretation.empty() ? "" : "\ninterpretation = " + interpretation);
}

using JointDensity = std::function<double(double y, double v)>;

// Probabilities of the cells of one variable: the integrals of a joint density over the other.
std::vector<double> cell_probabilities(const std::vector<double>& cells,
                                       const std::vector<double>& others,
                                       const JointDensity& density) {
  using Gauss = boost::math::quadrature::gauss<double, 5>;
  std::vector<double> probabilities;
  double mass = 0;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    const auto line = [&](double x) {
      double sum = 0;
      for (std::size_t j = 0; j + 1 < others.size(); ++j) {
        sum += Gauss::integrate([&](double z) { return density(x, z); }, others[j], others[j + 1]);
      }
      return sum;
    };
    probabilities.push_back(Gauss::integrate(line, cells[i], cells[i + 1]));
    mass += probabilities.back();
  }
  for (double& one : probabilities) one /= mass;
  return probabilities;
}

void expect_law(const problem::Problem& problem, const JointDensity& exact) {
  const problem::Problem seen = tests::in_wall_coordinates(problem);
  const auto [in_frame, summary] = solve_stationary_density(seen, {});
  const auto solution = transform::to_physical_coordinates(seen.frame, in_frame);
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  ASSERT_TRUE(summary.error);
  const auto& grid = std::get<transform::GridDensity>(*solution.density);
  const auto distance = [&](StateVariable variable, const std::vector<double>& edges,
                            const std::vector<double>& probabilities) {
    const auto found = marginal(solution, variable, edges);
    double sum = 0;
    for (std::size_t b = 0; b < found.size(); ++b) {
      sum += std::abs(found.density[b] * found.bin_width(b) - probabilities[b]);
    }
    return sum;
  };
  const double of_y = distance(StateVariable::y, grid.y_edges,
                               cell_probabilities(grid.y_edges, grid.v_edges, exact));
  const double of_v = distance(StateVariable::ydot, grid.v_edges,
                               cell_probabilities(grid.v_edges, grid.y_edges,
                                                  [&](double v, double y) { return exact(y, v); }));
  EXPECT_LT(of_y, 1e-5);
  EXPECT_LT(of_v, 1e-5);
  EXPECT_LT(of_y, 2 * summary.error->y_l1);
  EXPECT_LT(of_v, 2 * summary.error->ydot_l1);
}

// Damping d(H) and noise factor G(H), D = 0.1: p = C/G exp(-int d/(D G) dH) in Ito's sense, and
// C/sqrt(G) in place of C/G in Stratonovich's (Caughey, Ma 1982). Here d = 0.1 + 0.1 H and
// G = 1 + H/2.
const std::string kForceOfEnergy = "0.1*v + 0.05*v*(y^2+v^2) + y";
const std::string kFactorOfEnergy = "sqrt(1+0.25*(y^2+v^2))";

TEST(ExactLawsOfFormulas, OfMultiplicativeNoiseInItoSense) {
  expect_law(read(without_wall(kForceOfEnergy, noise(kFactorOfEnergy, "ito"))),
             [](double y, double v) {
               const double h = (y * y + v * v) / 2;
               return (1 + h / 2) * std::exp(-2 * h);
             });
}

TEST(ExactLawsOfFormulas, OfMultiplicativeNoiseInStratonovichSense) {
  expect_law(read(without_wall(kForceOfEnergy, noise(kFactorOfEnergy, "stratonovich"))),
             [](double y, double v) {
               const double h = (y * y + v * v) / 2;
               return std::pow(1 + h / 2, 1.5) * std::exp(-2 * h);
             });
}

// The same oscillator by coefficients: System makes the formula of the force.
TEST(ExactLawsOfFormulas, OfMultiplicativeNoiseWithCoefficients) {
  expect_law(read("[system]\ndamping = 0.1\nvan_der_pol = 0.05\nrayleigh = 0.05\nstiffness = 1\n"
                  "[wall]\nnone = true\n" +
                  noise(kFactorOfEnergy, "stratonovich")),
             [](double y, double v) {
               const double h = (y * y + v * v) / 2;
               return std::pow(1 + h / 2, 1.5) * std::exp(-2 * h);
             });
}

// g = g(y) and f = c v g^2 + V': p = C exp(-c H / D).
TEST(ExactLawsOfFormulas, OfNoiseWithAFactorOfTheDisplacement) {
  expect_law(read(without_wall("0.2*v*(1+y^2) + y + 0.1*y^3", noise("sqrt(1+y^2)"))),
             [](double y, double v) {
               return std::exp(-2 * (v * v / 2 + y * y / 2 + 0.1 * std::pow(y, 4) / 4));
             });
}

// Dimentberg 1982: y'' + 2a y'(1 + eta) + b y'(y^2 + y'^2/W^2) + W^2 y (1 + xi) = zeta, where eta,
// xi and zeta together are one noise of diffusion coefficient D G = D_zeta + s H. Here a = 0.5, b =
// 0.1, W^2 = 2, D_eta = 0.02, D_zeta = 0.1, D_xi W^2 = 4 a^2 D_eta.
TEST(ExactLawsOfFormulas, OfNoiseInDampingAndStiffness) {
  expect_law(read(without_wall("v + 0.1*v*(y^2 + v^2/2) + 2*y",
                               noise("sqrt(1 + 0.2*v^2 + 0.4*y^2)", "stratonovich"))),
             [](double y, double v) {
               constexpr double kS = 0.04, kA = 1.02, kB = 0.1, kZeta = 0.1;
               const double h = (v * v + 2 * y * y) / 2;
               return std::pow(kZeta + kS * h, -kA / kS + kB * kZeta / (kS * kS)) *
                      std::exp(-kB * h / kS);
             });
}

// Gaussian impulses of rate lambda and deviation s, and the damping for which p = C exp(-k H) with
// any spring between elastic walls (Vasta 1995): lambda sqrt(pi/2k) e^(k v^2/2) times the
// difference of erfc(v sqrt(k/2) / sqrt(1 + k s^2)) and erfc(v sqrt(k/2)). Here lambda = k = 1.
TEST(ExactLawsOfFormulas, OfADampingForWhichImpulsesHaveAGaussianVelocity) {
  const std::string force =
      "sqrt(pi/2)*exp(v^2/2)*(erfc(v/sqrt(3)) - erfc(v/sqrt(2))) + y + 0.2*y^3";
  const std::string impulses = "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.5\n";
  const auto density = [](double y, double v) {
    return std::exp(-(v * v / 2 + y * y / 2 + 0.2 * std::pow(y, 4) / 4));
  };
  expect_law(read(without_wall(force, impulses)), density);
  expect_law(
      read("[system]\nforce = " + force +
           "\n[wall]\nleft = -0.5\nleft_restitution = 1\nright = 1\nright_restitution = 1\n" +
           impulses),
      density);
}

// The term 0*v hides the constant from the parser.
TEST(ExactLawsOfFormulas, AreThoseOfANumberForAConstantRestitution) {
  const auto solution_of = [](const std::string& restitution) {
    return solve_stationary_density(
               tests::in_wall_coordinates(
                   read("[system]\nforce = 0.2*v + y\n[wall]\nleft = 0.1\nleft_restitution = " +
                        restitution + "\n[noise]\nintensity = 0.2\n")),
               {.refinement = 0.7, .error_estimate = false})
        .solution;
  };
  const auto number = solution_of("0.8"), formula = solution_of("0.8 + 0*v");
  EXPECT_NEAR(number.moments.y2, formula.moments.y2, 1e-9);
  EXPECT_NEAR(number.moments.v4, formula.moments.v4, 1e-9);
  EXPECT_NEAR(number.energy_residual, formula.energy_residual, 1e-9);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
