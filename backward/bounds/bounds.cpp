#include "backward/bounds/bounds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backward/bounds/one_grid.hpp"
#include "backward/generator/normal_equations.hpp"
#include "base/input_error.hpp"
#include "base/process/processors.hpp"
#include "problem/frame.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kWeightPower = 12;

// The requested number of threads, else one per processor.
int threads_of(const Options& options) { return options.threads.value_or(base::processors()); }

bool narrow_enough(const Bound& bound, const Options& options) {
  const double wanted =
      std::max(options.half_width, options.relative_half_width * std::abs(bound.value.middle()));
  return wanted > 0 && bound.value.half_width() <= wanted;
}

// Why the refinement for a functional stopped.
struct End {
  enum class Cause { none, time, grids, fit } cause = Cause::none;
  double seconds = 0;       ///< expected time at the end of the next grid
  std::string breakdown{};  ///< error message of the fit
};

struct Refined {
  Bounds bounds;
  std::vector<End> ends;  ///< for each functional
};

using Numbers = std::vector<std::size_t>;

// The functionals that share the next grid of their sequences.
struct OnGrid {
  Grid grid;
  Numbers numbers;
};

// Groups the functionals with too wide bounds by their grid of this level. Marks the functionals
// without a further grid.
std::vector<OnGrid> at_level(std::size_t level, const Options& options, Refined& refined) {
  std::vector<OnGrid> groups;
  for (std::size_t i = 0; i < refined.bounds.each.size(); ++i) {
    const Bound& bound = refined.bounds.each[i];
    End& end = refined.ends[i];
    if (end.cause != End::Cause::none || narrow_enough(bound, options)) continue;
    const auto grids = grids_for(width_limit(bound.functional));
    if (level >= grids.size()) {
      end.cause = End::Cause::grids;
      continue;
    }
    const auto same = std::ranges::find(groups, grids[level], &OnGrid::grid);
    if (same == groups.end()) {
      groups.push_back({grids[level], {i}});
    } else {
      same->numbers.push_back(i);
    }
  }
  return groups;
}

// Rounds up to two significant digits.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

// The expectation in the mirrored problem, up to the sign.
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

// The functionals without the impact momentum, unless the system has exactly one wall.
std::vector<Functional> that_can_be_bounded(const problem::System& system,
                                            std::vector<Functional> functionals) {
  if (system.left().has_value() == system.right().has_value()) {
    std::erase_if(functionals,
                  [](const auto& f) { return std::holds_alternative<ImpactMomentum>(f); });
  }
  return functionals;
}

Refined refined(const problem::Problem& problem, const Options& options) {
  using Clock = std::chrono::steady_clock;
  const Weight tau = weight(problem, kWeightPower);
  Refined result;
  for (const Functional& f : options.functionals) {
    result.bounds.each.push_back({f, {-HUGE_VAL, HUGE_VAL}});
  }
  result.ends.resize(options.functionals.size());

  const auto begun = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  std::vector<double> before(options.functionals.size());  // time of the functional's last grid
  for (std::size_t level = 0;; ++level) {
    const auto groups = at_level(level, options, result);
    if (groups.empty()) return result;
    for (const auto& [grid, numbers] : groups) {
      const double expected = elapsed() + kCostRatio * before[numbers.front()];
      const auto end_all = [&result, &ended = numbers](const End& end) {
        for (const std::size_t i : ended) result.ends[i] = end;
      };
      if (level > 0 && expected > options.seconds) {
        end_all({End::Cause::time, expected});
        continue;
      }
      std::vector<Functional> functionals;
      for (const std::size_t i : numbers) functionals.push_back(options.functionals[i]);
      const double start = elapsed();
      OneGridReport report;
      GridRecord record{grid, 0, 0, numbers, {}};
      try {
        record.values =
            bounds_on_grid(problem, tau, grid, functionals, threads_of(options), &report);
      } catch (const FitBrokeDown& broken) {
        end_all({End::Cause::fit, 0, broken.what()});  // finer grids would fail too
        continue;
      }
      record.unknowns = report.unknowns;
      record.seconds = elapsed() - start;
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        before[numbers[n]] = record.seconds;
        numerics::Enclosure& value = result.bounds.each[numbers[n]].value;
        value = value.intersected(record.values[n]);
        // Both enclosures contain the expectation. An empty intersection means an error in the
        // program or in the rounding of the processor.
        if (value.lower > value.upper) {
          throw std::logic_error("bounds of " + name(functionals[n]) +
                                 " from two grids are disjoint");
        }
      }
      result.bounds.grids.push_back(std::move(record));
    }
  }
}

// A single right wall becomes a left wall of the mirrored problem.
Refined refined_by_mirror(const problem::Problem& problem, const Options& options) {
  Options there = options;
  for (Functional& f : there.functionals) f = mirrored(f);
  Refined result = refined(problem::seen_from({.origin = 0, .mirrored = true}, problem), there);
  const auto turn = [](const Functional& f, numerics::Enclosure& value) {
    if (changes_sign(f)) value = {-value.upper, -value.lower};
  };
  for (Bound& bound : result.bounds.each) {
    turn(bound.functional, bound.value);
    bound.functional = mirrored(bound.functional);
  }
  for (GridRecord& record : result.bounds.grids) {
    for (std::size_t n = 0; n < record.each.size(); ++n) {
      turn(result.bounds.each[record.each[n]].functional, record.values[n]);
    }
  }
  return result;
}

// Names of the functionals that stopped for this cause.
std::vector<std::string> ended_by(End::Cause cause, const Refined& refined) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < refined.ends.size(); ++i) {
    if (refined.ends[i].cause == cause) names.push_back(name(refined.bounds.each[i].functional));
  }
  return names;
}

// Reason for bounds wider than requested; the first applicable option that the caller can change.
std::string limit_text(const Refined& refined, const Options& options) {
  const auto& ends = refined.ends;
  if (const auto names = ended_by(End::Cause::time, refined); !names.empty()) {
    double seconds = 0;
    for (const End& end : ends) seconds = std::max(seconds, end.seconds);
    return fmt::format(
        "guaranteed, but wider than requested: the next grid for {} would end after {:.2g} s; "
        "increase --seconds above {:g}",
        fmt::join(names, ", "), seconds, options.seconds);
  }
  if (const auto names = ended_by(End::Cause::grids, refined); !names.empty()) {
    double widest = 0, relative = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].cause != End::Cause::grids) continue;
      const numerics::Enclosure& value = refined.bounds.each[i].value;
      widest = std::max(widest, value.half_width());
      relative = std::max(relative, value.half_width() / std::abs(value.middle()));
    }
    return fmt::format(
        "guaranteed, but wider than requested: no finer grid exists for {}; request {}",
        fmt::join(names, ", "),
        options.relative_half_width > 0
            ? fmt::format("--width {:.2g}", rounded_up(relative))
            : fmt::format("--absolute-width {:.2g}", rounded_up(widest)));
  }
  const auto broken = std::ranges::find(ends, End::Cause::fit, &End::cause);
  return fmt::format("guaranteed, but wider than requested: {}",
                     broken == ends.end() ? "" : broken->breakdown);
}

}  // namespace

Bounds bounds(const problem::Problem& problem, const Options& asked_for) {
  validate(asked_for);
  Bounds refusal;
  refusal.reason = weight_refused(problem);
  if (!refusal.reason.empty()) {
    refusal.status = BoundsStatus::not_offered;
    return refusal;
  }
  Options options = asked_for;
  options.functionals = that_can_be_bounded(problem.system, asked_for.functionals);
  const bool by_mirror = problem.system.right() && !problem.system.left();
  Refined found = by_mirror ? refined_by_mirror(problem, options) : refined(problem, options);
  Bounds& result = found.bounds;
  for (std::size_t i = 0; i < result.each.size(); ++i) {
    const Bound& b = result.each[i];
    if (std::isfinite(b.value.half_width())) continue;
    result.status = BoundsStatus::failed;
    result.reason = found.ends[i].cause == End::Cause::fit
                        ? found.ends[i].breakdown
                        : "no finite bounds of " + name(b.functional);
    return result;
  }
  const bool asked = options.half_width > 0 || options.relative_half_width > 0;
  const bool met = std::ranges::all_of(
      result.each, [&](const Bound& bound) { return narrow_enough(bound, options); });
  if (asked && !met) {
    result.status = BoundsStatus::width_not_met;
    result.reason = limit_text(found, options);
  }
  return result;
}

}  // namespace fpkcheck::backward
