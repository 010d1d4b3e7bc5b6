#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input_error.hpp"
#include "paper_cases.hpp"
#include "problem/case_file.hpp"
#include "workflows/study/functionals/functionals.hpp"

namespace fpkcheck::study {
namespace {

using Json = nlohmann::json;
using transform::FirstPassageResult;
using transform::Status;

SpectrumStudy spectrum_study() {
  SpectrumStudy study{tests::paper_case(1), {}, {}};
  study.spectra = {{.id = "fd-kf",
                    .status = Status::ok,
                    .frequencies = {0, 1, 2},
                    .density = {1, 3, 2},
                    .error = {0.1, 0.2, 0.3},
                    .variance = 5,
                    .peak = transform::SpectralPeak{.frequency = 1.2, .density = 3.1},
                    .lags = {0, 0.5},
                    .autocovariance = {5, 4},
                    .autocovariance_error = {0.02, 0.01}},
                   {.id = "mcs", .status = Status::not_offered, .reason = "none"}};
  return study;
}

TEST(SpectrumReport, HasTheKeysOfTheContract) {
  const Json found = Json::parse(study::study_json_text(spectrum_study(), "fpkcheck spectrum"));
  const Json& spectra = found.at("cases").at(0).at("spectra");
  ASSERT_EQ(spectra.size(), 2u);
  EXPECT_EQ(spectra[0].at("solution"), "fd-kf");
  EXPECT_EQ(spectra[0].at("of"), "y");
  EXPECT_EQ(spectra[0].at("density"), Json({1.0, 3.0, 2.0}));
  EXPECT_EQ(spectra[0].at("error").at(2), 0.3);
  EXPECT_EQ(spectra[0].at("autocovariance").at("lag"), Json({0.0, 0.5}));
  EXPECT_EQ(spectra[0].at("autocovariance").at("value"), Json({5.0, 4.0}));
  EXPECT_EQ(spectra[0].at("autocovariance").at("error").at(1), 0.01);
  EXPECT_EQ(spectra[0].at("peak").at("frequency"), 1.2);
  EXPECT_TRUE(spectra[0].at("peak").at("half_width").is_null());
  EXPECT_EQ(spectra[1].at("status"), "not_offered");
  EXPECT_TRUE(spectra[1].at("frequency").empty());
  EXPECT_EQ(found.at("cases").at(0).at("system").at("damping"), 0.1);
}

TEST(SpectrumReport, HasARowOfTheCsvForEachFrequencyAndEachLag) {
  const std::string text = study_csv_text(spectrum_study());
  EXPECT_EQ(std::ranges::count(text, '\n'), 6);
  EXPECT_NE(text.find("test,fd-kf,y,2,2,0.3,,"), std::string::npos) << text;
  EXPECT_NE(text.find("test,fd-kf,y,,,0.01,0.5,4"), std::string::npos) << text;
}

TEST(SpectrumOptions, RefuseInvalidFrequenciesAndMethods) {
  for (const char* text : {"1", "1:2", "a:2:3", "2:1:3", "0:1:0", "-1:1:3", "0:1:1.5", "0:1:1e9"}) {
    SpectrumOptions options;
    options.frequencies = text;
    EXPECT_THROW(study_spectrum(tests::paper_case(1), options, {}), InputError) << text;
  }
  SpectrumOptions options;
  options.methods = "epc";
  EXPECT_THROW(study_spectrum(tests::paper_case(1), options, {}), InputError);
}

TEST(Convergence, NeedsAMethodAndNoFailure) {
  EXPECT_TRUE(has_converged(spectrum_study()));
  SpectrumStudy study = spectrum_study();
  study.spectra[1].status = Status::failed;
  EXPECT_FALSE(has_converged(study));
  study.spectra[0].status = study.spectra[1].status = Status::not_offered;
  EXPECT_FALSE(has_converged(study));
}

TEST(SensitivityReport, HasDerivativesElasticitiesAndErrorsByParameter) {
  SensitivityStudy study{tests::paper_case(1), {}, {}};
  study.solutions = {
      {.id = "fd-kf",
       .status = Status::ok,
       .parameters = {"system.damping"},
       .parameter_values = {0.1},
       .expectations = {
           {.expectation = "E[y^2]", .value = 0.5, .derivatives = {-2}, .errors = {0.01}}}}};
  const Json found = Json::parse(study::study_json_text(study, "fpkcheck sensitivity"));
  const Json& one = found.at("cases").at(0).at("sensitivities").at(0);
  EXPECT_EQ(one.at("of"), "E[y^2]");
  EXPECT_EQ(one.at("derivatives").at("system.damping"), -2);
  EXPECT_DOUBLE_EQ(one.at("elasticities").at("system.damping"), -0.4);
  EXPECT_EQ(one.at("error").at("system.damping"), 0.01);
}

TEST(SensitivityReport, HasDerivativesOfMarginalDensities) {
  SensitivityStudy study{tests::paper_case(1), {}, {}};
  const auto moment = [](const char* symbol) {
    return transform::ExpectationDerivatives{
        .expectation = symbol, .value = 0.5, .derivatives = {-2, 1}, .errors = {0.01, 0.02}};
  };
  study.solutions = {{.id = "fd-kf",
                      .status = Status::ok,
                      .parameters = {"system.damping", "impulse.rate"},
                      .parameter_values = {0.1, 2},
                      .expectations = {moment("E[y^2]"), moment("E[y'^2]")},
                      .marginals = {{.variable = transform::StateVariable::ydot,
                                     .edges = {-1, 0, 2},
                                     .derivatives = {{0.5, -0.25}, {-3, 1.5}},
                                     .errors = {{0.01, 0.02}, {0.03, 0.04}}}}}};
  const Json found = Json::parse(study::study_json_text(study, "fpkcheck sensitivity"));
  const Json& list = found.at("cases").at(0).at("sensitivities");
  ASSERT_EQ(list.size(), 3u);
  const Json& one = list.at(2);
  EXPECT_EQ(one.at("of"), "p(y')");
  EXPECT_DOUBLE_EQ(one.at("l1_norm").at("system.damping"), 1);
  EXPECT_DOUBLE_EQ(one.at("l1_norm").at("impulse.rate"), 6);
  EXPECT_DOUBLE_EQ(one.at("error").at("impulse.rate"), 0.11);
  const std::string csv = study_csv_text(study);
  EXPECT_NE(csv.find("fd-kf,p(y'),system.damping,0.5,,0.01,-0.5\n"), csv.npos) << csv;
  EXPECT_NE(csv.find("fd-kf,p(y'),impulse.rate,1.5,,0.04,1\n"), csv.npos) << csv;
  const report::Figure figure = study_figure(study);
  ASSERT_EQ(figure.panels.size(), 3u);
  ASSERT_EQ(figure.panels.back().series.size(), 2u);
  const report::FigureSeries& rate = figure.panels.back().series.back();
  EXPECT_EQ(rate.name, "impulse.rate");
  EXPECT_DOUBLE_EQ(rate.points.at(1).x, 1);
  EXPECT_DOUBLE_EQ(rate.points.at(1).y, 3);
}

TEST(PassageReport, HasTheKeysOfTheContract) {
  PassageStudy study{tests::paper_case(1), {}, {}};
  study.options.displacement = "1.5";
  study.passages = {{.id = "mcs",
                     .status = Status::ok,
                     .hazard = transform::ValueWithError{0.1, 0.01},
                     .times = {1, 2},
                     .survival_from_stationary = {{0.9, 0.01}, {0.8, 0.02}}}};
  const Json found = Json::parse(study::study_json_text(study, "fpkcheck passage"));
  const Json& passage = found.at("cases").at(0).at("passage");
  EXPECT_EQ(passage.at("barrier").at("displacement"), 1.5);
  const Json& one = passage.at("solutions").at(0);
  EXPECT_EQ(one.at("hazard"), 0.1);
  EXPECT_TRUE(one.at("mean_from_rest").is_null());
  EXPECT_EQ(one.at("error").at("hazard"), 0.01);
  EXPECT_EQ(one.at("survival").at(1).at("from_stationary"), 0.8);
  EXPECT_TRUE(one.at("survival").at(1).at("from_rest").is_null());
}

TEST(PassageReport, NamesErrorsThatContainTheErrorOfTheKickInterval) {
  PassageStudy study{tests::paper_case(1), {}, {}};
  study.options.displacement = "1.5";
  study.passages = {
      {.id = "mcs", .status = Status::ok, .hazard = transform::ValueWithError{0.1, 0.01}}};
  const auto error_is = [&] {
    return Json::parse(study::study_json_text(study, ""))
        .at("cases")
        .at(0)
        .at("passage")
        .at("solutions")
        .at(0)
        .at("error_is");
  };
  const auto has_standard_errors = [&] {
    return study_table_text(study, {}).find("std err") != std::string::npos;
  };
  study.passages[0].has_standard_errors = true;
  EXPECT_EQ(error_is(), "standard error");
  EXPECT_TRUE(has_standard_errors());
  study.passages[0].has_kick_interval_errors = true;
  EXPECT_EQ(error_is(), "standard error plus error of the kick interval");
  EXPECT_FALSE(has_standard_errors());
}

// The cells of the map are of unequal size, and their values differ in y and in y'.
TEST(PassageFigure, HasAMapOfTheMeanTimes) {
  PassageStudy study{tests::paper_case(1), {}, {}};
  study.options.displacement = "1.5";
  study.passages = {{.id = "fd-kf",
                     .status = Status::ok,
                     .times = {1, 2},
                     .survival_from_stationary = {{0.9, 0.01}, {0.8, 0.02}},
                     .mean_passage_times_by_start =
                         transform::MeanPassageTimeMap{.y_edges = {0, 0.5, 1.5},
                                                       .v_edges = {-2, 1, 1.5, 2},
                                                       .averages = {1, 2, 3, 4, 5, -0.1}}}};
  const report::Figure figure = study::study_figure(study);
  ASSERT_EQ(figure.panels.size(), 2u);
  const report::FigureHeatMap& map = figure.panels[1].map.value();
  const auto value_at = [&](double y, double v) {
    const std::size_t rows = map.values.size() / map.columns;
    const auto part = [](double x, const std::array<double, 2>& range, std::size_t count) {
      return static_cast<std::size_t>((x - range[0]) / (range[1] - range[0]) *
                                      static_cast<double>(count));
    };
    return map.values.at(part(v, map.y_range, rows) * map.columns +
                         part(y, map.x_range, map.columns));
  };
  EXPECT_EQ(value_at(0.4, 0.9), 1);
  EXPECT_EQ(value_at(0.4, 1.1), 2);
  EXPECT_EQ(value_at(0.4, 1.9), 3);
  EXPECT_EQ(value_at(0.6, -1), 4);
  EXPECT_EQ(value_at(1.4, 1.4), 5);
  EXPECT_EQ(value_at(1.4, 1.6), 0);  // not negative
  EXPECT_EQ(map.colour_axis.to, 5);
  // A point with one end of an interval would have a wrong error bar, and no line.
  const auto& points = figure.panels[0].series.at(0).points;
  EXPECT_TRUE(std::ranges::all_of(
      points, [](const report::FigurePoint& point) { return std::isnan(point.lower); }));
}

TEST(SensitivityStudy, JudgesClosuresByTheirErrorsWithoutEffectOnTheExitCode) {
  SensitivityOptions options;
  options.parameters = "system.damping";
  options.methods = "epc-moment-n2";
  const SensitivityStudy alone = study_sensitivity(tests::paper_case(1), options, {});
  EXPECT_EQ(alone.solutions.at(0).status, Status::inaccurate);
  EXPECT_FALSE(has_converged(alone));
  options.methods = "epc-polar-n6,epc-moment-n2";
  SensitivityStudy both = study_sensitivity(tests::paper_case(1), options, {});
  EXPECT_EQ(both.solutions.at(0).status, Status::ok) << both.solutions.at(0).reason;
  both.solutions.push_back({.id = "fd-kf", .status = Status::ok});
  EXPECT_TRUE(has_converged(both));
}

TEST(PassageOptions, NeedABarrierAndValidTimes) {
  EXPECT_THROW(study_passage(tests::paper_case(1), {}, {}), InputError);
  PassageOptions options;
  options.displacement = "1";
  options.times = "1,-2";
  EXPECT_THROW(study_passage(tests::paper_case(1), options, {}), InputError);
}

TEST(PassageOptions, RefuseInvalidStarts) {
  PassageOptions options;
  options.displacement = "1";
  for (const char* start : {"", "0.5", "0.5,1,2", "a,1", "1,0", "1.2,0", "-0.1,0", "0.5,inf"}) {
    options.start = start;
    EXPECT_THROW(study_passage(tests::paper_case(1), options, {}), InputError) << start;
  }
}

// Motion towards the wall returns with 0.7 of the speed. A wrong sign of the velocity would
// increase the probability of a passage before t = 3 from 0.3 to 0.6.
TEST(PassageFromAPoint, AgreesWithTheSimulation) {
  const auto problem = tests::make_problem({.damping = 0.3, .restitution = 0.7, .intensity = 0.3});
  PassageOptions options;
  options.displacement = "1";
  options.start = "0.3,-1.2";
  options.methods = "fd-kf,mcs,characteristics";
  options.times = "3,10";
  options.time = 1e5;
  options.accuracy = 0.05;
  options.max_seconds = 60;
  const PassageStudy study = study_passage(problem, options, {});
  const auto &fd = study.passages.at(0), &simulated = study.passages.at(1);
  ASSERT_EQ(fd.status, Status::ok) << fd.reason;
  ASSERT_EQ(simulated.status, Status::ok) << simulated.reason;
  const auto expect_agreement = [](const transform::ValueWithError& a,
                                   const transform::ValueWithError& b) {
    constexpr double kStandardErrors = 4;
    EXPECT_NEAR(a.value, b.value, std::hypot(a.error, kStandardErrors * b.error));
  };
  expect_agreement(*fd.mean_from_point, *simulated.mean_from_point);
  const auto& collocation = study.passages.at(2);
  ASSERT_EQ(collocation.status, Status::ok) << collocation.reason;
  expect_agreement(*collocation.mean_from_point, *simulated.mean_from_point);
  EXPECT_NEAR(collocation.mean_from_point->value, fd.mean_from_point->value,
              fd.mean_from_point->error);
  EXPECT_NEAR(collocation.hazard->value, fd.hazard->value, fd.hazard->error);
  for (std::size_t k = 0; k < 2; ++k) {
    expect_agreement(fd.survival_from_point.at(k), simulated.survival_from_point.at(k));
    expect_agreement(collocation.survival_from_point.at(k), simulated.survival_from_point.at(k));
  }
  const Json found = Json::parse(study::study_json_text(study, "fpkcheck passage"));
  const Json& passage = found.at("cases").at(0).at("passage");
  EXPECT_EQ(passage.at("start").at("ydot"), -1.2);
  EXPECT_EQ(passage.at("solutions").at(0).at("mean_from_start"), fd.mean_from_point->value);
  const Json& third = passage.at("solutions").at(2);
  EXPECT_EQ(third.at("solution"), "characteristics");
  EXPECT_EQ(third.at("hazard"), collocation.hazard->value);
  EXPECT_EQ(third.at("survival").at(1).at("from_start"),
            collocation.survival_from_point.at(1).value);
  EXPECT_TRUE(passage.at("solutions").at(0).at("survival").at(0).contains("from_start"));
}

// The energy refers to the potential of physical coordinates, with the wall at y = -0.5.
TEST(PassageOfTheEnergy, AgreesWithTheSimulationAtAWallBesideTheEquilibrium) {
  std::istringstream ini(R"([system]
damping = 0.1
stiffness = 1
[wall]
left = -0.5
left_restitution = 0.9
[impulse]
rate = 1
law = gaussian
intensity = 0.1
)");
  const problem::Problem problem = problem::read_case(ini, "test", "test.ini");
  PassageOptions options;
  options.energy = 1;
  options.start = "0.8,-0.4";
  options.methods = "fd-kf,mcs,characteristics";
  options.times = "10,50";
  options.time = 4e5;
  options.accuracy = 0.02;
  options.max_seconds = 60;
  const PassageStudy study = study_passage(problem, options, {});
  ASSERT_EQ(study.passages.size(), 4u);
  const auto &fd = study.passages[0], &simulated = study.passages[1];
  ASSERT_EQ(fd.status, Status::ok) << fd.reason;
  ASSERT_EQ(simulated.status, Status::ok) << simulated.reason;
  EXPECT_EQ(study.passages[2].status, Status::not_offered);
  EXPECT_EQ(study.passages[3].status, Status::not_offered);
  EXPECT_TRUE(has_converged(study));
  const auto expect_agreement = [](const transform::ValueWithError& a,
                                   const transform::ValueWithError& b) {
    EXPECT_NEAR(a.value, b.value, 3.5 * b.error + a.error);
    EXPECT_LT(3.5 * b.error + a.error, 0.1 * a.value);
  };
  for (const auto quantity :
       {&transform::FirstPassageResult::hazard, &transform::FirstPassageResult::mean_from_point,
        &transform::FirstPassageResult::mean_from_stationary,
        &transform::FirstPassageResult::probability_below}) {
    expect_agreement(*(fd.*quantity), *(simulated.*quantity));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    expect_agreement(fd.survival_from_point.at(k), simulated.survival_from_point.at(k));
    expect_agreement(fd.survival_from_stationary.at(k), simulated.survival_from_stationary.at(k));
  }
  const Json found = Json::parse(study::study_json_text(study, "fpkcheck passage"));
  const Json& passage = found.at("cases").at(0).at("passage");
  EXPECT_EQ(passage.at("barrier"), Json({{"energy", 1.0}}));
  EXPECT_TRUE(passage.at("solutions").at(0).at("rice_rate").is_null());
}

TEST(PassageOfTheEnergy, RefusesAStartAboveTheBarrierAndASecondBarrier) {
  PassageOptions options;
  options.energy = 1;
  for (const char* start : {"0.5,1.5", "1.4,0", "-0.1,0"}) {
    options.start = start;
    EXPECT_THROW(study_passage(tests::paper_case(1), options, {}), InputError) << start;
  }
  options.start = {};
  options.displacement = "1";
  EXPECT_THROW(study_passage(tests::paper_case(1), options, {}), InputError);
}

// A negative factor of skewed impulses, and a restitution coefficient that decreases with the
// speed: the mean time from rest would change with a wrong sign, factor or speed of the first
// impulse.
TEST(PassageFromRest, AgreesWithTheSimulationUnderParametricImpulses) {
  std::istringstream ini(R"([system]
damping = 0.3
stiffness = 1
[wall]
left = 0
left_restitution = 1 - 0.3*min(1,abs(v))^0.5
[impulse]
rate = 1
law = gamma
skewness = 1
intensity = 0.2
factor = -1.5
)");
  const problem::Problem problem = problem::read_case(ini, "test", "test.ini");
  PassageOptions options;
  options.displacement = "1";
  options.times = "10";
  options.time = 3e5;
  options.accuracy = 0.05;
  options.max_seconds = 60;
  const PassageStudy study = study_passage(problem, options, {});
  ASSERT_EQ(study.passages.size(), 3u);
  const auto &fd = study.passages[0], &simulated = study.passages[1];
  ASSERT_EQ(fd.status, Status::ok) << fd.reason;
  ASSERT_EQ(simulated.status, Status::ok) << simulated.reason;
  for (const auto mean : {&transform::FirstPassageResult::mean_from_point,
                          &transform::FirstPassageResult::mean_from_stationary}) {
    const auto &a = *(fd.*mean), &b = *(simulated.*mean);
    EXPECT_NEAR(a.value, b.value, 3.5 * b.error + 2 * a.error);
    EXPECT_LT(3.5 * b.error + 2 * a.error, 0.1 * a.value);
  }
}

// The mean time in which x'' = xi, of intensity 2D = 1, leaves (-1, 1) from rest at x (J.
// Masoliver, J. M. Porra, Phys. Rev. Lett. 75, 189 (1995)):
//   (L^2/D)^(1/3) (4/3)^(1/6) / Gamma(7/3) [X(1-X)]^(1/6) (F(X) + F(1-X)),
//   F(X) = 2F1(1, -1/3; 7/6; X),  X = 1/2 + x/2,  L = 2,
// where the values of F + F were computed with 50 digits. An elastic wall at y = 0 gives y = |x|.
// The motion beyond the barrier, up to a second wall, has no effect.
TEST(PassageExactly, IsTheExitOfTheRandomAccelerationProcess) {
  std::istringstream ini(R"([system]
damping = 0
stiffness = 0
[noise]
intensity = 1
[wall]
left = 0
left_restitution = 1
right = 2
right_restitution = 0.5
)");
  const problem::Problem problem = problem::read_case(ini, "test", "test.ini");
  PassageOptions options;
  options.displacement = "1";
  options.times = "10";
  options.methods = "fd-white,mcs-white";
  options.time = 3e5;
  options.max_seconds = 60;
  constexpr double kHalf = 2.311956, kQuarter = 2.156103;  // X = 1/2, and X = 1/4 or 3/4
  options.start = "0.5,0";
  const PassageStudy study = study_passage(problem, options, {});
  const auto &fd = study.passages.at(0), &simulated = study.passages.at(1);
  ASSERT_EQ(fd.status, Status::ok) << fd.reason;
  EXPECT_NEAR(fd.mean_from_point->value, kQuarter, 1e-3 * kQuarter);
  // Under noise the stated error is at least 2.7 standard errors.
  EXPECT_NEAR(simulated.mean_from_point->value, kQuarter, 1.3 * simulated.mean_from_point->error);
  options.start = {};
  const PassageStudy at_rest = study_passage(problem, options, {});
  ASSERT_EQ(at_rest.passages.at(0).status, Status::ok) << at_rest.passages.at(0).reason;
  EXPECT_NEAR(at_rest.passages.at(0).mean_from_point->value, kHalf, 1e-4 * kHalf);
  const auto& mean = *at_rest.passages.at(1).mean_from_point;
  EXPECT_NEAR(mean.value, kHalf, 1.3 * mean.error);
  EXPECT_LT(mean.error, 0.03 * kHalf);
}

// An interval that is not symmetric to the equilibrium or to the wall, under white noise and under
// impulses: the exits at the two barriers have different probabilities.
TEST(PassageOfTwoBarriers, AgreesWithTheSimulation) {
  for (const std::string excitation :
       {"[noise]\nintensity = 0.1\n",
        "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.1\nmean = 0.05\n"}) {
    std::istringstream ini(
        "[system]\ndamping = 0.1\nstiffness = 1\n[wall]\nleft = -1.5\nleft_restitution = 0.8\n" +
        excitation);
    const problem::Problem problem = problem::read_case(ini, "test", "test.ini");
    const bool is_noise = problem.noise.is_acting();
    PassageOptions options;
    options.displacement = "-1,1.3";
    if (is_noise) options.start = "0.4,-0.5";
    options.methods =
        (is_noise ? std::string("fd-white,mcs-white") : "fd-kf,mcs") + ",characteristics,bounds";
    options.times = "10,50";
    options.time = 3e5;
    options.accuracy = 0.02;
    options.max_seconds = 200;
    const PassageStudy study = study_passage(problem, options, {});
    const auto &fd = study.passages.at(0), &simulated = study.passages.at(1);
    ASSERT_EQ(fd.status, Status::ok) << fd.reason;
    ASSERT_EQ(simulated.status, Status::ok) << simulated.reason;
    EXPECT_EQ(study.passages.at(2).status, Status::not_offered);
    EXPECT_EQ(study.passages.at(3).status, Status::not_offered);
    EXPECT_EQ(study.passages.at(4).id, "rice");
    EXPECT_TRUE(has_converged(study));
    // Under noise the stated error is at least 2.7 standard errors.
    const double limit = is_noise ? 1.3 : 3.5;
    const auto expect_agreement = [limit](const transform::ValueWithError& a,
                                          const transform::ValueWithError& b) {
      EXPECT_NEAR(a.value, b.value, limit * b.error + a.error);
    };
    for (const auto quantity :
         {&FirstPassageResult::hazard, &FirstPassageResult::mean_from_point,
          &FirstPassageResult::mean_from_stationary, &FirstPassageResult::rice_rate,
          &FirstPassageResult::probability_below, &FirstPassageResult::upper_exit_from_point,
          &FirstPassageResult::upper_exit_from_stationary}) {
      ASSERT_TRUE(fd.*quantity && simulated.*quantity);
      expect_agreement(*(fd.*quantity), *(simulated.*quantity));
    }
    for (std::size_t k = 0; k < 2; ++k) {
      expect_agreement(fd.survival_from_point.at(k), simulated.survival_from_point.at(k));
      expect_agreement(fd.survival_from_stationary.at(k), simulated.survival_from_stationary.at(k));
    }
    EXPECT_LT(simulated.upper_exit_from_stationary->error, 0.02);
    const Json found = Json::parse(study::study_json_text(study, "fpkcheck passage"));
    const Json& passage = found.at("cases").at(0).at("passage");
    EXPECT_EQ(passage.at("barrier"), Json({{"displacement", 1.3}, {"lower_displacement", -1.0}}));
    const Json& one = passage.at("solutions").at(0);
    const std::string key =
        std::string("upper_exit_probability_from_") + (is_noise ? "start" : "rest");
    EXPECT_EQ(one.at(key), fd.upper_exit_from_point->value);
    EXPECT_EQ(one.at("error").at(key), fd.upper_exit_from_point->error);
    EXPECT_EQ(one.at("upper_exit_probability_from_stationary"),
              fd.upper_exit_from_stationary->value);
    EXPECT_EQ(one.at("probability_between"), fd.probability_below->value);
  }
}

TEST(PassageOptions, RefuseInvalidIntervals) {
  PassageOptions options;
  for (const char* barriers : {"1,0.5", "1,1", "1,2,3", "a", ",1"}) {
    options.displacement = barriers;
    EXPECT_THROW(study_passage(tests::paper_case(1), options, {}), InputError) << barriers;
  }
  options.displacement = "0.5,1";
  for (const char* start : {"0.5,0", "0.5,-1", "1,0", "1,1", "1.2,0", "0.2,0"}) {
    options.start = start;
    EXPECT_THROW(study_passage(tests::paper_case(1), options, {}), InputError) << start;
  }
}

// Problems of several kinds: rest in contact with the wall, a barrier in the other of two wells, a
// law with a skewness and a mean in a system without a wall, and a hazard near the rate of
// impulses.
TEST(PassageByCharacteristics, AgreesWithTheSimulation) {
  const std::string impulses = "[impulse]\nrate = 1\nlaw = gaussian\nintensity = ";
  const std::vector<std::pair<std::string, double>> problems{
      {"[system]\ndamping = 0.3\nconstant = 0.3\nstiffness = 1\nrestitution = 0.6\n" + impulses +
           "0.4\n",
       0.9},
      {"[system]\ndamping = 0.4\nstiffness = -1\ncubic = 1\n[wall]\nnone = true\n" + impulses +
           "0.3\n",
       0.5},
      {"[system]\ndamping = 0.4\nstiffness = 1\nquadratic = 0.2\ncubic = 0.3\n[wall]\nnone = true\n"
       "[impulse]\nrate = 1\nlaw = gamma\nskewness = 1\nmean = 0.1\nintensity = 0.4\n",
       1},
      {"[system]\ndamping = 0.3\nstiffness = 1\nrestitution = 0.8\n" + impulses + "4\n", 0.5}};
  for (const auto& [ini, barrier] : problems) {
    std::istringstream text(ini);
    PassageOptions options;
    options.methods = "characteristics,mcs";
    options.displacement = fmt::format("{}", barrier);
    options.time = 3e5;
    options.max_seconds = 120;
    const PassageStudy study =
        study_passage(problem::read_case(text, "test", "test.ini"), options, {});
    const auto &found = study.passages.at(0), &simulated = study.passages.at(1);
    ASSERT_EQ(found.status, Status::ok) << ini << found.reason;
    ASSERT_EQ(simulated.status, Status::ok) << ini << simulated.reason;
    const auto expect_agreement = [&ini_text = ini](const transform::ValueWithError& a,
                                                    const transform::ValueWithError& b) {
      EXPECT_NEAR(a.value, b.value, 3.5 * b.error + a.error) << ini_text;
    };
    expect_agreement(*found.mean_from_point, *simulated.mean_from_point);
    if (found.mean_from_stationary) {  // absent if the time does not suffice
      expect_agreement(*found.mean_from_stationary, *simulated.mean_from_stationary);
      expect_agreement(*found.rice_rate, *simulated.rice_rate);
      expect_agreement(*found.probability_below, *simulated.probability_below);
    }
    for (std::size_t k = 0; k < found.times.size(); ++k) {
      expect_agreement(found.survival_from_point.at(k), simulated.survival_from_point.at(k));
    }
    EXPECT_LT(simulated.mean_from_point->error, 0.02 * simulated.mean_from_point->value) << ini;
  }
}

}  // namespace
}  // namespace fpkcheck::study
