#include "problem/time_dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "base/input_error.hpp"
#include "problem/case_file.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {
namespace {

const std::string kLinear = "[system]\ndamping = 0.1\nstiffness = 1\n[wall]\nnone = true\n";
const std::string kImpulses = "[impulse]\nrate = 2\nlaw = laplace\nintensity = 0.4\n";
const std::string kNoise = "[noise]\nintensity = 0.2\n";

Problem read(const std::string& text,
             CaseFileTimeSectionPolicy time = CaseFileTimeSectionPolicy::allowed) {
  std::istringstream file(text);
  return read_case(file, "a", "a.ini", {}, CaseNamingRule::from_file, time);
}

TEST(TimeDependence, IsReadFromACaseFile) {
  const Problem p = read(kLinear + kImpulses + kNoise +
                         "[parameters]\nw = 2\n"
                         "[time]\nrate = 1 + 0.5*sin(w*t)\nintensity = exp(-t)\n"
                         "force = 0.3*cos(w*t)\n");
  EXPECT_DOUBLE_EQ(p.time.rate_factor(0.7), 1 + 0.5 * std::sin(1.4));
  EXPECT_DOUBLE_EQ(p.time.intensity_factor(0.7), std::exp(-0.7));
  EXPECT_DOUBLE_EQ(p.time.external_force(0.7), 0.3 * std::cos(1.4));
  const Problem again =
      problem_from_sections("a", case_file_sections(p), CaseFileTimeSectionPolicy::allowed);
  EXPECT_DOUBLE_EQ(again.time.external_force(0.7), p.time.external_force(0.7));
}

TEST(TimeDependence, OfAConstantExcitationIsAbsent) {
  const Problem p = read(kLinear + kImpulses);
  EXPECT_FALSE(p.time.is_acting());
  EXPECT_EQ(p.time.rate_factor(3), 1);
  EXPECT_EQ(p.time.intensity_factor(3), 1);
  EXPECT_EQ(p.time.external_force(3), 0);
}

TEST(TimeDependence, HasNoStationaryDensity) {
  EXPECT_THROW(
      read(kLinear + kImpulses + "[time]\nforce = cos(t)\n", CaseFileTimeSectionPolicy::refused),
      InputError);
}

TEST(TimeDependence, RefusesFactorsOfAbsentExcitationsAndOtherVariables) {
  EXPECT_THROW(read(kLinear + kNoise + "[time]\nrate = 1\n"), InputError);
  EXPECT_THROW(read(kLinear + kImpulses + "[time]\nintensity = 1\n"), InputError);
  EXPECT_THROW(read(kLinear + kImpulses + "[time]\nforce = cos(y)\n"), InputError);
  EXPECT_THROW(read(kLinear + kImpulses + "[parameters]\nt = 1\n"), InputError);
}

// The largest values of the factors become the constant excitation, and the product is unchanged.
TEST(TimeDependence, IsRelativeToTheLargestExcitation) {
  const Problem p =
      read(kLinear + kImpulses + kNoise + "[time]\nrate = 1 + 0.5*sin(t)\nintensity = 3*exp(-t)\n");
  const Problem strongest = with_largest_excitation(p, {10});
  EXPECT_NEAR(strongest.impulses.arrival_rate(), 3, 1e-5);
  EXPECT_NEAR(strongest.impulses.intensity(), 0.6, 1e-6);
  EXPECT_DOUBLE_EQ(strongest.impulses.amplitude_law().moment(4),
                   p.impulses.amplitude_law().moment(4));
  EXPECT_DOUBLE_EQ(strongest.noise.intensity, 0.6);
  for (const double t : {0.0, 0.4, 5.0}) {
    EXPECT_NEAR(strongest.impulses.arrival_rate() * strongest.time.rate_factor(t),
                2 * (1 + 0.5 * std::sin(t)), 1e-12);
    const Problem then = with_excitation_at_time(strongest, t);
    EXPECT_NEAR(then.noise.intensity, 0.6 * std::exp(-t), 1e-12);
    EXPECT_NEAR(then.impulses.arrival_rate(), 2 * (1 + 0.5 * std::sin(t)), 1e-12);
  }
  const Problem twice = with_largest_excitation(strongest, {10});
  EXPECT_NEAR(twice.noise.intensity, strongest.noise.intensity, 1e-12);
}

TEST(TimeDependence, RefusesNegativeFactorsAndFunctionsWithoutValues) {
  const auto refused = [](const std::string& functions) {
    EXPECT_THROW(
        with_largest_excitation(read(kLinear + kImpulses + kNoise + "[time]\n" + functions), {4}),
        InputError)
        << functions;
  };
  refused("rate = 1 - t\n");
  refused("intensity = cos(t)\n");
  refused("force = 1/(t - 2)\n");
  refused("rate = 0*t\n");
}

TEST(TimeDependence, RefusesExcitationsOutOfRangeOrWithoutAStationaryDensity) {
  const auto largest = [](const std::string& functions) {
    return with_largest_excitation(read(kLinear + kImpulses + kNoise + "[time]\n" + functions),
                                   {4});
  };
  EXPECT_THROW(largest("intensity = 1e60\n"), InputError);
  EXPECT_THROW(largest("rate = 1e-200\n"), InputError);
  EXPECT_THROW(largest("force = 1e60\n"), InputError);
  // Multiplicative noise of 100 times the intensity supplies more power than the damping takes.
  const Problem growing = read(
      "[system]\nforce = 0.6*v + y\n[wall]\nnone = true\n"
      "[noise]\nintensity = 0.1\nfactor = sqrt(1 + y^2)\n[time]\nintensity = 100\n");
  EXPECT_THROW(with_largest_excitation(growing, {4}), InputError);
}

// The largest value between regular samples: time.rate has the period of the samples of 4096
// equidistant times.
TEST(TimeDependence, FindsTheLargestValueOfFastOscillations) {
  const Problem p = read(kLinear + kImpulses + "[time]\nrate = 1 - 0.9*cos(2*pi*t)\n");
  EXPECT_NEAR(with_largest_excitation(p, {4096}).impulses.arrival_rate(), 2 * 1.9, 1e-3);
}

TEST(TimeDependence, RequiresThePeriodOfAPeriodicExcitation) {
  const auto of_period = [](const std::string& functions, double period) {
    return with_largest_excitation(read(kLinear + kImpulses + functions), {period, true});
  };
  EXPECT_NO_THROW(of_period("[time]\nforce = 0.3*cos(2*pi*t)\n", 1));
  EXPECT_NO_THROW(of_period("[time]\nforce = 0.3*sign(sin(2*pi*t))\n", 1));
  EXPECT_NO_THROW(of_period("[time]\nforce = 0.3*cos(1.2*t)\n", 5.236));
  EXPECT_THROW(of_period("[time]\nforce = 0.3*cos(2*pi*t)\n", 1.1), InputError);
  EXPECT_THROW(of_period("", 1), InputError) << "a constant excitation";
}

TEST(TimeDependence, RefusesAnIntensityInTimeOfNoiseWhoseFactorDependsOnV) {
  EXPECT_THROW(
      read("[system]\nforce = 0.6*v + y\n[wall]\nnone = true\n[noise]\nintensity = 0.1\n"
           "factor = sqrt(1 + 0.1*v^2)\ninterpretation = ito\n[time]\nintensity = exp(-t)\n"),
      InputError);
}

TEST(TimeDependence, ForceHasTheOppositeSignInMirroredCoordinates) {
  const Problem p = read(
      "[system]\ndamping = 0.1\nstiffness = 1\n[wall]\nright = 0.5\nright_restitution = 0.9\n" +
      kNoise + "[time]\nforce = 2\n");
  EXPECT_EQ(to_wall_coordinates(wall_frame(p.system), p).time.external_force(1), -2);
}

// The response of a linear oscillator to F_0 cos(w t) below the resonance, from rest.
TEST(TimeDependence, ForcedMotionHasTheAmplitudeOfTheLinearResponse) {
  const Problem p = read(kLinear + kNoise + "[time]\nforce = 0.3*cos(0.2*t)\n");
  const MotionExtent extent = forced_motion_extent(p, {200});
  EXPECT_GT(extent.displacement, 0.3 / 0.96);
  EXPECT_LT(extent.displacement, 2 * 0.3 / 0.96);  // the initial free motion adds to it
  const double beyond_end =
      forced_motion_extent(read(kLinear + kNoise + "[time]\nforce = 0.3*sqrt(5 - t)\n"), {5})
          .displacement;
  EXPECT_GT(beyond_end, 0.3);
  // At the resonance the periodic motion reaches F_0 / (c w) after some decay times.
  const Problem resonant = read(kLinear + kNoise + "[time]\nforce = 0.03*cos(t)\n");
  EXPECT_NEAR(forced_motion_extent(resonant, {2 * M_PI, true}).displacement, 0.3, 0.05);
  EXPECT_NEAR(forced_motion_extent(resonant, {2 * M_PI, true}).amplitude, 0.3, 0.05);
  EXPECT_EQ(forced_motion_extent(read(kLinear + kNoise), {200}).displacement, 0);
}

}  // namespace
}  // namespace fpkcheck::problem
