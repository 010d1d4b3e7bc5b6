#include "dual/bounds/bounds.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "dual/backward/normal_equations.hpp"
#include "dual/bounds/one_grid.hpp"
#include "parameters/input_error.hpp"
#include "problem/frame.hpp"
#include "process/processors.hpp"

namespace fpkcheck::dual {
namespace {

constexpr int kWeightPower = 12;

// One per processor where nobody says.
int threads_of(const Options& options) { return options.threads.value_or(process::processors()); }

bool narrow_enough(const Bound& bound, const Options& options) {
  const double wanted =
      std::max(options.half_width, options.relative_half_width * std::abs(bound.value.middle()));
  return wanted > 0 && bound.value.half_width() <= wanted;
}

// The functionals of a kind that are still too wide, by number.
std::vector<std::size_t> too_wide(const Bounds& bounds, const Options& options, Smoothness kind) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < bounds.each.size(); ++i) {
    const Smoothness own =
        breaks(bounds.each[i].functional).empty() ? Smoothness::smooth : Smoothness::piecewise;
    if (own == kind && !narrow_enough(bounds.each[i], options)) numbers.push_back(i);
  }
  return numbers;
}

// The same expectation in the mirrored problem, up to its sign.
Functional mirrored(const Functional& functional) {
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    SmoothBin other = *bin;
    for (std::size_t i = 0; i < bin->knots.size(); ++i) {
      other.knots[i] = -bin->knots[bin->knots.size() - 1 - i];
    }
    return other;
  }
  return functional;
}

bool changes_sign(const Functional& functional) {
  const PowerMean* const mean = std::get_if<PowerMean>(&functional);
  return mean != nullptr && mean->power % 2 == 1;
}

// A lone wall at the right is one at the left of the mirrored problem.
Bounds bounds_by_mirror(const problem::Problem& problem, const Options& options) {
  Options there = options;
  for (Functional& f : there.functionals) f = mirrored(f);
  Bounds result = bounds(problem::seen_from({.origin = 0, .mirrored = true}, problem), there);
  const auto turn = [](const Functional& f, Enclosure& value) {
    if (changes_sign(f)) value = {-value.upper, -value.lower};
  };
  for (Bound& bound : result.each) {
    turn(bound.functional, bound.value);
    bound.functional = mirrored(bound.functional);
  }
  for (GridRecord& record : result.grids) {
    for (std::size_t n = 0; n < record.each.size(); ++n) {
      turn(result.each[record.each[n]].functional, record.values[n]);
    }
  }
  return result;
}

// What follows from a mean: the momentum of impacts only where one wall has all of it.
std::vector<Functional> that_can_be_bounded(const problem::System& system,
                                            std::vector<Functional> functionals) {
  if (system.left().has_value() == system.right().has_value()) {
    std::erase_if(functionals,
                  [](const auto& f) { return std::holds_alternative<ImpactMomentum>(f); });
  }
  return functionals;
}

}  // namespace

Bounds bounds(const problem::Problem& problem, const Options& asked_for) {
  using Clock = std::chrono::steady_clock;
  validate(asked_for);
  Bounds result;
  result.reason = weight_refused(problem);
  if (!result.reason.empty()) {
    result.status = BoundsStatus::not_offered;
    return result;
  }
  Options options = asked_for;
  options.functionals = that_can_be_bounded(problem.system, asked_for.functionals);
  if (problem.system.right() && !problem.system.left()) return bounds_by_mirror(problem, options);
  const Weight tau = weight(problem, kWeightPower);
  for (const Functional& f : options.functionals) result.each.push_back({f, {-HUGE_VAL, HUGE_VAL}});

  const auto begun = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  double before[2] = {0, 0};  // time of the last grid of each kind
  for (int level = 0; level < kLevels; ++level) {
    for (const Smoothness kind : {Smoothness::smooth, Smoothness::piecewise}) {
      const std::vector<std::size_t> numbers = too_wide(result, options, kind);
      double& last = before[static_cast<int>(kind)];
      if (numbers.empty()) continue;
      if (level > 0 && elapsed() + kCostRatio * last > options.seconds) continue;
      std::vector<Functional> functionals;
      for (const std::size_t i : numbers) functionals.push_back(options.functionals[i]);
      const Grid grid = grid_of_level(level, kind);
      const double start = elapsed();
      OneGridReport report;
      GridRecord record{grid, 0, 0, numbers, {}};
      try {
        record.values =
            bounds_on_grid(problem, tau, grid, functionals, threads_of(options), &report);
      } catch (const FitBrokeDown& broken) {
        result.reason = broken.what();
        last = HUGE_VAL;  // no finer one either
        continue;
      }
      record.unknowns = report.unknowns;
      record.seconds = last = elapsed() - start;
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        Enclosure& value = result.each[numbers[n]].value;
        value = value.intersected(record.values[n]);
        // Both hold the same number: otherwise a theorem, or the processor, is not what it says.
        if (value.lower > value.upper) {
          throw std::logic_error("bounds of " + name(functionals[n]) + " contradict each other");
        }
      }
      result.grids.push_back(std::move(record));
    }
  }
  const bool asked = options.half_width > 0 || options.relative_half_width > 0;
  for (const Bound& b : result.each) {
    if (!std::isfinite(b.value.half_width())) {
      result.status = BoundsStatus::failed;
      if (result.reason.empty()) result.reason = "no finite bounds of " + name(b.functional);
      return result;
    }
  }
  result.reason.clear();
  for (const Bound& b : result.each) {
    if (!asked || narrow_enough(b, options)) continue;
    result.status = BoundsStatus::width_not_met;
    result.reason = fmt::format("guaranteed, but wider than asked for: {:.3g} s were not enough",
                                options.seconds);
  }
  return result;
}

}  // namespace fpkcheck::dual
