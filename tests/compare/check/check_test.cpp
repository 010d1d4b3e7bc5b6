#include "compare/check/check.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>

#include "compare/check/baseline.hpp"
#include "compare/check/figures.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

/// The paper's first case as the repository holds it; nothing is solved here.
const SavedRun& paper_baseline() {
  static const SavedRun run = load_baseline(FPKCHECK_BASELINES "/case1", 0).run;
  return run;
}

Json& solution(SavedRun& run, const std::string& id) {
  for (Json& one : run.summary["cases"][0]["solutions"]) {
    if (one["id"] == id) return one;
  }
  throw std::logic_error("no " + id);
}

/// What moves when a run differs from the baseline by a change alone.
std::vector<Figure> moved_by(const std::function<void(SavedRun&)>& change,
                             const Tolerances& tolerances = {}) {
  SavedRun changed = paper_baseline();
  change(changed);
  // Which of the two changed must not matter.
  const auto forth = check(paper_baseline(), changed, tolerances).moved();
  EXPECT_EQ(check(changed, paper_baseline(), tolerances).moved().size(), forth.size());
  return forth;
}

void scale(Json& number, double relative) { number = number.get<double>() * (1 + relative); }

TEST(Check, ARunAgreesWithItself) {
  const auto same = check(paper_baseline(), paper_baseline(), {});
  EXPECT_TRUE(same.agrees());
  EXPECT_GT(same.figures.size(), 600u);
  EXPECT_EQ(same.solutions, paper_baseline().summary["cases"][0]["solutions"].size());
}

TEST(Check, FindsEveryCoefficientThatMovesByAMillionth) {
  std::size_t tried = 0;
  for (const auto& one : paper_baseline().summary["cases"][0]["solutions"]) {
    if (!one.contains("coefficients")) continue;
    for (std::size_t k = 0; k < one["coefficients"].size(); ++k, ++tried) {
      for (const double relative : {1e-6, -1e-6}) {
        const auto moved = moved_by([&](SavedRun& run) {
          scale(solution(run, one["id"])["coefficients"][k]["a"], relative);
        });
        ASSERT_EQ(moved.size(), 1u) << one["id"] << " " << one["coefficients"][k];
        EXPECT_EQ(moved[0].solution, one["id"]);
        EXPECT_EQ(moved[0].kind, FigureKind::coefficient);
        EXPECT_NEAR(moved[0].change, 1e-6, 1e-11);
      }
    }
  }
  EXPECT_GT(tried, 80u);
}

TEST(Check, FindsEveryMomentThatMovesByAMillionth) {
  for (const auto& one : paper_baseline().summary["cases"][0]["solutions"]) {
    if (one["method"] == "mcs") continue;
    const double deviation = std::sqrt(one["moments"]["v2"].get<double>());
    for (const auto& [key, value] : one["moments"].items()) {
      const auto moved = moved_by([&, key = key](SavedRun& run) {
        Json& moment = solution(run, one["id"])["moments"][key];
        // E[y'] is 0 but for errors: a millionth of a deviation.
        moment = key == "v1" ? moment.get<double>() + 1e-6 * deviation
                             : moment.get<double>() * (1 + 1e-6);
      });
      ASSERT_EQ(moved.size(), 1u) << one["id"] << " " << key;
      EXPECT_EQ(moved[0].kind, FigureKind::moment);
    }
  }
}

TEST(Check, FindsStatusMassBalanceAndDistances) {
  const auto kinds = [](const std::vector<Figure>& figures) {
    std::vector<FigureKind> result;
    for (const auto& figure : figures) result.push_back(figure.kind);
    return result;
  };
  using enum FigureKind;
  using Kinds = std::vector<FigureKind>;
  EXPECT_EQ(kinds(moved_by([](SavedRun& run) { solution(run, "fd-kf")["status"] = "ill_posed"; })),
            Kinds{status});
  EXPECT_EQ(kinds(moved_by([](SavedRun& run) { scale(solution(run, "fd-kf")["mass"], 1e-6); })),
            Kinds{mass});
  EXPECT_EQ(kinds(moved_by([](SavedRun& run) {
              Json& residual = solution(run, "fd-kf")["energy_residual"];
              residual = residual.get<double>() - 1e-6;
            })),
            Kinds{energy});
  for (const char* key : {"l1", "l2", "sup", "hellinger", "kl"}) {
    const auto moved = moved_by([&](SavedRun& run) {
      Json& distance = run.summary["cases"][0]["comparisons"][0][key];
      distance = distance.get<double>() + 1e-7;
    });
    EXPECT_EQ(kinds(moved), Kinds{distance}) << key;
  }
  EXPECT_EQ(kinds(moved_by([](SavedRun& run) {
              Json& decade = run.summary["cases"][0]["comparisons"][0]["log10_tail"][2]["mean_abs"];
              decade = decade.get<double>() + 3e-6;
            })),
            Kinds{tail});
}

TEST(Check, FindsEveryBinOfACurve) {
  const auto& curve = paper_baseline().marginals.front();
  const double peak = std::ranges::max(curve.density);
  for (std::size_t k = 0; k < curve.density.size(); ++k) {
    for (const double sign : {-1.0, 1.0}) {
      const auto moved =
          moved_by([&](SavedRun& run) { run.marginals.front().density[k] += sign * 1e-7 * peak; });
      ASSERT_EQ(moved.size(), 1u) << k;
      EXPECT_EQ(moved[0].kind, FigureKind::marginal);
      EXPECT_NEAR(moved[0].change, 1e-7, 1e-13);
      EXPECT_NE(moved[0].name.find(fmt::format("{:.4g}", curve.abscissa[k])), std::string::npos);
    }
  }
}

TEST(Check, FindsWhatOnlyOneOfTheRunsHas) {
  const auto without_solution =
      moved_by([](SavedRun& run) { run.summary["cases"][0]["solutions"].erase(1); });
  EXPECT_EQ(without_solution.at(0).name, "solution");
  EXPECT_EQ(moved_by([](SavedRun& run) { run.summary["cases"][0]["comparisons"].erase(3); }).size(),
            1u);
  EXPECT_EQ(moved_by([](SavedRun& run) { run.marginals.erase(run.marginals.begin()); }).size(), 1u);
  EXPECT_EQ(moved_by([](SavedRun& run) {
              solution(run, "epc-gaussian-n6")["coefficients"].erase(4);
            }).size(),
            1u);
  const auto no_density = moved_by([](SavedRun& run) {
    Json& lost = solution(run, "fd-kf");
    lost["status"] = "not_converged";
    lost["moments"] = lost["mass"] = lost["energy_residual"] = nullptr;
  });
  ASSERT_EQ(no_density.size(), 2u);
  EXPECT_EQ(no_density[1].name, "density");
  const auto other_bins = moved_by([](SavedRun& run) {
    for (double& x : run.marginals.front().abscissa) x *= 1.001;
  });
  ASSERT_EQ(other_bins.size(), 1u);
  EXPECT_TRUE(std::isinf(other_bins[0].change));
  EXPECT_EQ(
      moved_by([](SavedRun& run) { solution(run, "fd-kf")["moments"]["y2"] = nullptr; }).size(),
      1u);
}

// Every number of the structure by its own random amount.
void disturb(Json& value, double relative, std::mt19937_64& random) {
  std::uniform_real_distribution<double> factor(-relative, relative);
  if (value.is_number_float()) scale(value, factor(random));
  if (value.is_structured()) {
    for (Json& element : value) disturb(element, relative, random);
  }
}

TEST(Check, DoesNotMindRounding) {
  std::mt19937_64 random(1);
  const auto moved = moved_by([&](SavedRun& run) {
    disturb(run.summary["cases"][0]["solutions"], 1e-12, random);
    disturb(run.summary["cases"][0]["comparisons"], 1e-12, random);
    disturb(run.summary["cases"][0]["budget"], 1e-12, random);
    for (auto& curve : run.marginals) {
      for (double& density : curve.density) density *= 1 + 1e-12;
    }
  });
  EXPECT_TRUE(moved.empty()) << moved.front().solution << " " << moved.front().name;
}

// A number anywhere in the first case, by its JSON pointer without "/cases/0".
Json& at(SavedRun& run, const std::string& pointer) {
  return run.summary.at(Json::json_pointer("/cases/0" + pointer));
}

std::string place_of(const std::string& id) {
  const auto& solutions = paper_baseline().summary["cases"][0]["solutions"];
  for (std::size_t k = 0; k < solutions.size(); ++k) {
    if (solutions[k]["id"] == id) return fmt::format("/solutions/{}", k);
  }
  throw std::logic_error("no " + id);
}

TEST(Check, FindsWhatOnlyTheMethodKnows) {
  const std::string fd = place_of("fd-kf"), epc = place_of("epc-moment-n8"), mcs = place_of("mcs");
  for (const std::string& number : {fd + "/impact_rate",
                                    fd + "/min_density",
                                    fd + "/wall_density/y",
                                    fd + "/x1_max",
                                    fd + "/nx",
                                    fd + "/error/y_l1",
                                    fd + "/error/moments/y2",
                                    fd + "/error/observed_order",
                                    fd + "/error/extrapolated/v4",
                                    epc + "/support/y_max",
                                    epc + "/support/least_radius",
                                    epc + "/support/cut_off",
                                    epc + "/distance_to_previous",
                                    epc + "/tail/level",
                                    mcs + "/impact_rate",
                                    mcs + "/joint_moments/5/mean",
                                    mcs + "/quantiles/y/4/value",
                                    mcs + "/quantiles/ydot/9/value",
                                    mcs + "/upcrossings/1/rate",
                                    mcs + "/peaks/2/rate",
                                    mcs + "/upcrossings/1/level",
                                    mcs + "/quantiles/y/4/probability",
                                    mcs + "/sampling_interval"}) {
    for (const double relative : {0.5, -0.2}) {
      EXPECT_EQ(moved_by([&](SavedRun& run) { scale(at(run, number), relative); }).size(), 1u)
          << number;
    }
  }
  for (const std::string& word :
       {fd + "/equation", fd + "/impact", epc + "/leading_form", epc + "/tail/kind"}) {
    EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, word) = "another"; }).size(), 1u) << word;
  }
  for (const std::string& part : {fd + "/error", epc + "/support", mcs + "/quantiles/y"}) {
    EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, part) = nullptr; }).size(), 1u) << part;
  }
  for (const std::string& list : {mcs + "/peaks", mcs + "/joint_moments", mcs + "/upcrossings"}) {
    EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, list).erase(0); }).size(), 1u) << list;
  }
  EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, fd).erase("impact_rate"); }).size(), 1u);
  EXPECT_GE(moved_by([&](SavedRun& run) {
              for (Json& level : at(run, mcs + "/upcrossings")) scale(level["rate"], 1);
            }).size(),
            8u);
}

TEST(Check, ARelativeMillionthOfADetailIsFound) {
  for (const std::string& number :
       {place_of("fd-kf") + "/impact_rate", place_of("fd-kf") + "/error/extrapolated/y4",
        place_of("epc-polar-n6") + "/support/v_max"}) {
    EXPECT_EQ(moved_by([&](SavedRun& run) { scale(at(run, number), 1e-6); }).size(), 1u) << number;
  }
}

TEST(Check, FindsTheTailThatALogarithmOfIsNotThere) {
  EXPECT_GT(moved_by([](SavedRun& run) {
              for (Json& pair : run.summary["cases"][0]["comparisons"]) {
                pair["log10_tail"] = Json::array();
              }
            }).size(),
            50u);
  EXPECT_EQ(moved_by([](SavedRun& run) {
              Json& bins = at(run, "/comparisons/0/log10_tail/1/bins");
              bins = bins.get<int>() + 1;
            }).size(),
            1u);
}

TEST(Check, FindsAnotherBudget) {
  const std::string row = "/budget/0";
  for (const std::string& number :
       {row + "/total", row + "/total_tail", row + "/tail/bins", row + "/parts/0/l1",
        row + "/parts/0/tail", row + "/parts/0/uncertainty", row + "/parts/4/l1",
        row + "/parts/4/expected", row + "/parts/4/in_99"}) {
    // In step with the size: also where the number is 3e-5.
    EXPECT_EQ(moved_by([&](SavedRun& run) { scale(at(run, number), 0.01); }).size(), 1u) << number;
  }
  EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, row + "/parts").erase(1); }).size(), 1u);
  EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, row + "/parts/1/name") = "?"; }).size(), 1u);
  EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, row + "/reference") = "fd-kf"; }).size(), 1u);
  EXPECT_EQ(moved_by([&](SavedRun& run) { at(run, "").erase("budget"); }).size(),
            paper_baseline().summary["cases"][0]["budget"].size());
}

TEST(Check, ABudgetToAnotherSimulationIsJudgedByItsSampling) {
  const auto by = [](const char* number, double relative) {
    const auto moved = moved_by([&](SavedRun& run) {
      scale(at(run, place_of("mcs") + "/moments/y2"), 1e-6);  // another simulation
      scale(at(run, std::string("/budget/0/parts/") + number), relative);
    });
    return moved.size();
  };
  EXPECT_EQ(by("4/l1", 0.5), 0u);
  EXPECT_EQ(by("4/l1", 5), 1u);
  EXPECT_EQ(by("4/expected", 0.05), 0u);
  EXPECT_EQ(by("4/expected", 3), 1u);
  EXPECT_EQ(by("0/tail", 1), 0u);
  EXPECT_EQ(by("0/tail", 9), 1u);
  EXPECT_EQ(by("0/l1", 1e-5), 1u);  // chance has no part in it
}

TEST(Check, WhatASimulationSaysOfItsErrorsIsComparedToo) {
  const std::string mcs = place_of("mcs");
  for (const std::string& error :
       {mcs + "/standard_errors/y2", mcs + "/standard_errors/energy_residual",
        mcs + "/sampling_l1/y", mcs + "/sampling_l1/ydot_99", mcs + "/impact_rate_error",
        mcs + "/joint_moments/3/standard_error", mcs + "/peaks/1/standard_error"}) {
    for (const double factor : {2.0, 0.5, 100.0, 0.01}) {
      EXPECT_EQ(moved_by([&](SavedRun& run) { scale(at(run, error), factor - 1); }).size(), 1u)
          << error << factor;
    }
    EXPECT_TRUE(moved_by([&](SavedRun& run) { scale(at(run, error), 0.3); }).empty()) << error;
    EXPECT_GE(moved_by([&](SavedRun& run) { at(run, error) = nullptr; }).size(), 1u) << error;
  }
  EXPECT_EQ(moved_by([&](SavedRun& run) { scale(at(run, mcs + "/effective_samples"), 3); }).size(),
            1u);
  // Wide errors do not hide what they would hide.
  EXPECT_GE(moved_by([&](SavedRun& run) {
              for (Json& error : at(run, mcs + "/standard_errors")) scale(error, 99);
              scale(at(run, mcs + "/moments/y2"), 0.02);
            }).size(),
            7u);
}

TEST(Check, ACoefficientThatIsZeroButForRoundingMayBeAnyZero) {
  const auto changed = [](double was, double is) {
    SavedRun baseline = paper_baseline(), now = paper_baseline();
    solution(baseline, "epc-gaussian-n6")["coefficients"][1]["a"] = was;
    solution(now, "epc-gaussian-n6")["coefficients"][1]["a"] = is;
    return !check(baseline, now, {}).agrees();
  };
  EXPECT_FALSE(changed(1e-16, -3e-16));
  EXPECT_FALSE(changed(0, 2e-16));
  EXPECT_TRUE(changed(0, 1e-9));
}

TEST(Check, AnInfiniteDivergenceOnOneSideIsRounding) {
  EXPECT_TRUE(moved_by([](SavedRun& run) {
                run.summary["cases"][0]["comparisons"][0]["kl"] = nullptr;
              }).empty());
}

TEST(Check, TimesAndCountsAreNotCompared) {
  EXPECT_TRUE(moved_by([](SavedRun& run) {
                for (Json& one : run.summary["cases"][0]["solutions"]) one["seconds"] = 1e3;
                solution(run, "fd-kf")["steps"] = 7;
                solution(run, "epc-gaussian-n6")["iterations"] = 70;
                solution(run, "mcs")["threads"] = 96;
                solution(run, "fd-kf")["residual"] = 1e-9;
                solution(run, "epc-gaussian-n6")["condition"] = nullptr;
                solution(run, "mcs")["reason"] = "in other words";
              }).empty());
}

TEST(Check, ToleranceIsWhatIsAskedFor) {
  const auto shift = [](SavedRun& run) { scale(solution(run, "fd-kf")["moments"]["y4"], 3e-7); };
  EXPECT_EQ(moved_by(shift).size(), 1u);
  EXPECT_EQ(moved_by(shift, {.deterministic = 1e-6}).size(), 0u);
  EXPECT_THROW(validate(Tolerances{.deterministic = 0}), InputError);
  EXPECT_THROW(validate(Tolerances{.standard_errors = NAN}), InputError);
}

TEST(Check, AMomentOfASimulationIsJudgedByBothStandardErrors) {
  const auto by = [](double errors_of_one_run) {
    return moved_by([&](SavedRun& run) {
      Json& mcs = solution(run, "mcs");
      mcs["moments"]["y2"] = mcs["moments"]["y2"].get<double>() +
                             errors_of_one_run * mcs["standard_errors"]["y2"].get<double>();
    });
  };
  EXPECT_EQ(by(5.5).size(), 0u);  // 4 standard errors of the difference are 5.66 of one run
  ASSERT_EQ(by(6).size(), 1u);
  EXPECT_EQ(by(6)[0].kind, FigureKind::simulated);
  EXPECT_NEAR(by(-6)[0].change, 6 / std::sqrt(2.0), 1e-6);
}

MarginalCurve& simulated_curve(SavedRun& run) {
  return *std::ranges::find_if(run.marginals, [](auto& curve) { return curve.solution == "mcs"; });
}

TEST(Check, ABinOfASimulationIsJudgedByItsIntervalAndTheNumberOfBins) {
  const auto by = [](double errors) {
    return moved_by([&](SavedRun& run) {
      MarginalCurve& curve = simulated_curve(run);
      const double error = (curve.upper[20] - curve.density[20]) / 1.96;
      for (auto* values : {&curve.density, &curve.lower, &curve.upper}) {
        (*values)[20] += errors * std::sqrt(2.0) * error;
      }
    });
  };
  EXPECT_EQ(by(4.5).size(), 0u);  // one of so many may
  ASSERT_EQ(by(5.2).size(), 1u);
  EXPECT_EQ(by(5.2)[0].kind, FigureKind::simulated_bin);
  EXPECT_GT(by(5.2)[0].allowed, 4.7);
  EXPECT_LT(by(5.2)[0].allowed, 5.1);
}

TEST(Check, ASimulationWithAnotherShapeIsFoundByL1) {
  const auto moved = moved_by([](SavedRun& run) {
    MarginalCurve& curve = simulated_curve(run);  // too little near the wall, too much beyond
    for (std::size_t k = 0; k < curve.density.size(); ++k) {
      const double tilt = 0.05 * (curve.abscissa[k] - 0.5);
      for (auto* values : {&curve.density, &curve.lower, &curve.upper}) (*values)[k] *= 1 + tilt;
    }
  });
  EXPECT_TRUE(std::ranges::any_of(
      moved, [](const Figure& figure) { return figure.kind == FigureKind::simulated_l1; }));
}

TEST(Check, DistancesToASimulationMoveWithItsSamplingError) {
  const auto by = [](double l1) {
    return moved_by([&](SavedRun& run) {
      for (Json& pair : run.summary["cases"][0]["comparisons"]) {
        if (pair["b"] != "mcs" || pair["variable"] != "y" || pair["a"] != "fd-kf") continue;
        pair["l1"] = pair["l1"].get<double>() + l1;
        pair["kl"] = pair["kl"].get<double>() + l1;  // not judged: noise
      }
    });
  };
  SavedRun run = paper_baseline();
  const Json& mcs = solution(run, "mcs");
  const double allowed = allowed_l1(mcs, mcs, "y", 4);
  const Json& sampling = mcs["sampling_l1"];
  EXPECT_GT(allowed, std::sqrt(2.0) * sampling["y_99"].get<double>());
  EXPECT_LT(allowed, 3 * sampling["y_99"].get<double>());
  EXPECT_EQ(by(0.98 * allowed).size(), 0u);
  ASSERT_EQ(by(1.02 * allowed).size(), 1u);
  EXPECT_EQ(by(1.02 * allowed)[0].kind, FigureKind::simulated_l1);
}

TEST(Check, TheTextNamesWhatMovedAndEndsInASentence) {
  SavedRun changed = paper_baseline();
  scale(solution(changed, "epc-moment-n8")["moments"]["y2"], 1e-6);
  solution(changed, "fd-kf")["status"] = "failed";
  const auto two = check(paper_baseline(), changed, {});
  for (const std::size_t width : {80u, 100u}) {
    const std::string text = check_table(two, width);
    for (const char* part : {"epc-moment-n8", "E[y^2]", "0.39453765", "1e-06", "failed"}) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " not in:\n" << text;
    }
    EXPECT_NE(text.find(fmt::format("2 of {} figures of", two.figures.size())), std::string::npos);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), width) << line;
  }
  const Json json = check_json(two, "fpkcheck check b", "b");
  EXPECT_EQ(json["agrees"], false);
  ASSERT_EQ(json["moved"].size(), 2u);
  EXPECT_EQ(json["moved"][0]["case"], "case1");
  EXPECT_NE(check_table(check(changed, changed, {}), 100).find("agree."), std::string::npos);
}

TEST(Check, AllMovedIsCutToTheClearest) {
  SavedRun changed = paper_baseline();
  std::mt19937_64 random(1);
  disturb(changed.summary["cases"][0]["comparisons"], 0.5, random);
  solution(changed, "fd-kf")["status"] = "failed";
  const auto all = check(paper_baseline(), changed, {});
  const std::string text = check_table(all, 100);
  EXPECT_LT(std::ranges::count(text, '\n'), 65);
  EXPECT_NE(text.find("failed"), std::string::npos);
  EXPECT_NE(text.find(fmt::format("and {} more", all.moved().size() - 40)), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::compare
