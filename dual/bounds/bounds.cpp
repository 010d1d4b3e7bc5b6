#include "dual/bounds/bounds.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "dual/bounds/one_grid.hpp"
#include "parameters/input_error.hpp"

namespace fpkcheck::dual {
namespace {

constexpr int kWeightPower = 12;

void validate_all(const Options& options) {
  for (const Functional& f : options.functionals) validate(f);
  if (!(options.half_width >= 0) || !(options.relative_half_width >= 0)) {
    throw InputError("a half-width that is asked for must be >= 0");
  }
  if (options.threads < 1) throw InputError("bounds need at least one thread");
}

bool narrow_enough(const Bounds& bounds, const Options& options) {
  if (options.half_width == 0 && options.relative_half_width == 0) return false;
  for (const Bound& b : bounds.each) {
    const double wanted =
        std::max(options.half_width, options.relative_half_width * std::abs(b.value.middle()));
    if (!(b.value.half_width() <= wanted)) return false;
  }
  return true;
}

}  // namespace

Bounds bounds(const problem::Problem& problem, const Options& options) {
  using Clock = std::chrono::steady_clock;
  validate_all(options);
  Bounds result;
  result.reason = weight_refused(problem);
  if (!result.reason.empty()) {
    result.status = BoundsStatus::not_offered;
    return result;
  }
  const Weight tau = weight(problem, kWeightPower);
  for (const Functional& f : options.functionals) result.each.push_back({f, {-HUGE_VAL, HUGE_VAL}});

  const auto begun = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  double before = 0;
  for (int level = 0; level < kLevels; ++level) {
    const Grid grid = grid_of_level(level);
    // The cost grows from grid to grid by less than this.
    if (level > 0 && elapsed() + kCostRatio * before > options.seconds) break;
    const double start = elapsed();
    OneGridReport report;
    GridRecord record{grid, 0, 0, {}};
    record.values =
        bounds_on_grid(problem, tau, grid, options.functionals, options.threads, &report);
    before = elapsed() - start;
    record.unknowns = report.unknowns;
    record.seconds = before;
    for (std::size_t i = 0; i < result.each.size(); ++i) {
      result.each[i].value = result.each[i].value.intersected(record.values[i]);
    }
    result.grids.push_back(std::move(record));
    if (narrow_enough(result, options)) return result;
  }
  if (options.half_width > 0 || options.relative_half_width > 0) {
    result.status = BoundsStatus::width_not_met;
    result.reason = fmt::format("guaranteed, but wider than asked for: {:.3g} s were not enough",
                                options.seconds);
  }
  return result;
}

}  // namespace fpkcheck::dual
