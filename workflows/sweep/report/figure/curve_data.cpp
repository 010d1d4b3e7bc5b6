#include "workflows/sweep/report/figure/curve_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::sweep {
namespace {

using transform::Variable;

double value_of(const MarginalL1Pair& pair, Variable variable) {
  return variable == Variable::y ? pair.y : pair.ydot;
}

std::vector<report::SeriesStyle> plot_styles_of(const Plan& plan) {
  std::vector<transform::SolutionIdentity> identities;
  for (const auto& method : plan.methods) identities.push_back(method.identity);
  return report::series_styles(identities);
}

}  // namespace

std::string data_cell(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? fmt::format("{:.6g}", *number) : "NaN";
}

CurveData::CurveData(const SweepView& view, const CurvesLayout& layout)
    : view_(view), layout_(layout), looks_(plot_styles_of(view.plan())) {}

double CurveData::mark_size() const {
  std::size_t most = 0;
  for (const auto& slice : layout_.slices) most = std::max(most, slice.points.size());
  return most <= 30 ? 1.1 : most <= 80 ? 0.7 : 0.4;
}

void CurveData::for_each(const std::function<void(std::size_t, std::size_t)>& call) const {
  for (const auto& slice : layout_.slices) {
    for (const std::size_t point : slice.points) {
      for (std::size_t m = 0; m < method_count(); ++m) call(point, m);
    }
  }
}

std::optional<double> CurveData::l1(std::size_t point, std::size_t m, Variable variable) const {
  const auto* one = view_.method_result(point, m);
  if (one == nullptr || !one->l1 || view_.is_reference(point, m)) return std::nullopt;
  return value_of(*one->l1, variable);
}

std::optional<double> CurveData::method_error_estimate(std::size_t point, std::size_t m,
                                                       Variable variable) const {
  const auto* one = view_.method_result(point, m);
  if (one == nullptr || !one->error || !l1(point, m, variable)) return std::nullopt;
  return value_of(*one->error, variable);
}

std::optional<double> CurveData::reference_error(std::size_t point, Variable variable) const {
  const auto error = view_.reference_error(point);
  if (!error) return std::nullopt;
  return value_of(*error, variable);
}

bool CurveData::has_no_density(std::size_t point, std::size_t m) const {
  const auto* one = view_.method_result(point, m);
  return one != nullptr && !one->l1 && !view_.is_reference(point, m) &&
         one->status != transform::Status::ok && !view_.point_result(point)->reference.empty();
}

double CurveData::abscissa_of(std::size_t point) const {
  return layout_.along.coordinate(view_.plan().points[point][layout_.place]);
}

double CurveData::abscissa_of(std::size_t point, std::size_t m) const {
  constexpr double kRoom = 0.7;  // width over which the methods are spread, 1 being a word's
  const auto count = static_cast<double>(method_count());
  const double beside = (static_cast<double>(m) - (count - 1) / 2) * kRoom / count;
  return abscissa_of(point) + (has_words() ? beside : 0);
}

std::string CurveData::blocks() const {
  std::string text;
  for (std::size_t s = 0; s < layout_.slices.size(); ++s) {
    for (std::size_t m = 0; m < method_count(); ++m) {
      std::string rows;
      for (const std::size_t point : layout_.slices[s].points) {
        const auto* one = view_.method_result(point, m);
        const bool is_ok = one != nullptr && one->status == transform::Status::ok;
        std::optional<double> y2, v2;
        if (one != nullptr && one->moments) {
          y2 = one->moments->y2;
          v2 = one->moments->v2;
        }
        rows += fmt::format("{:.6g} {} {} {} {} {} {} {}\n", abscissa_of(point, m),
                            data_cell(l1(point, m, Variable::y)),
                            data_cell(l1(point, m, Variable::ydot)),
                            is_ok ? marks(m).filled : marks(m).open,
                            data_cell(method_error_estimate(point, m, Variable::y)),
                            data_cell(method_error_estimate(point, m, Variable::ydot)),
                            data_cell(y2), data_cell(v2));
      }
      text += report::data_block(fmt::format("curve_{}_{}", s, m), rows);
    }
  }
  return text;
}

std::string CurveData::reference_error_blocks() const {
  std::string text;
  for (std::size_t s = 0; s < layout_.slices.size(); ++s) {
    std::string rows;
    for (const std::size_t point : layout_.slices[s].points) {
      const auto y = reference_error(point, Variable::y),
                 ydot = reference_error(point, Variable::ydot);
      const auto row = [&](double x) {
        return y ? fmt::format("{:.6g} {:.6g} {:.6g}\n", x, *y, *ydot) : "\n";
      };
      constexpr double kHalf = 0.48;  // half-width: a word's bar nearly touches the next bar
      const double x = abscissa_of(point);
      rows += has_words() ? row(x - kHalf) + row(x + kHalf) + '\n' : row(x);
    }
    text += report::data_block(fmt::format("floor_{}", s), rows);
  }
  return text;
}

}  // namespace fpkcheck::sweep
