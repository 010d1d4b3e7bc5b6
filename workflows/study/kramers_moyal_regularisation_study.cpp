#include "workflows/study/kramers_moyal_regularisation_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"

namespace fpkcheck::study {

KramersMoyalRegularisationStudy study_kramers_moyal_regularisation(
    const problem::Problem& problem, const methods::ProgressListener& listener) {
  const auto progress = [&](int row, int rows) {
    if (!listener) return;
    listener({.done = static_cast<std::size_t>(row),
              .total = static_cast<std::size_t>(rows),
              .case_name = problem.name,
              .method = "regularisation",
              .fraction = 0});
  };
  return add_density_growth_rates(
      problem, fd_fpk::study_kramers_moyal_regularisation(problem, {}, progress));
}

KramersMoyalRegularisationStudy add_density_growth_rates(
    const problem::Problem& problem, const fd_fpk::KramersMoyalRegularisationStudy& fd_study) {
  KramersMoyalRegularisationStudy study{
      problem, fd_study.default_length, fd_study.shortest_length, {}};
  for (const auto& row : fd_study.rows) {
    const bool symbol_grows = row.symbol && is_growing_wave(*row.symbol, problem.impulses);
    study.rows.push_back({row, symbol_grows, row.growth_rate(problem)});
  }
  return study;
}

bool has_converged(const KramersMoyalRegularisationStudy& study) {
  const KramersMoyalRegularisationResult* finest = nullptr;
  for (const auto& row : study.rows) {
    if (row.scheme == "regularised") finest = &row;
  }
  return finest != nullptr && !finest->growth_rate && finest->l1_y;
}

using base::Value;
using fd_fpk::FastestGrowingWave;
using transform::value_from_count;
using transform::value_from_optional;

namespace {

using report::wrap_text;

void add_eigenvalue(const std::string& name, const std::optional<std::complex<double>>& value,
                    StudyRecord& record) {
  if (!value) {
    record.push_back({name, {}});
    return;
  }
  record.push_back({name + ".re", value->real()});
  record.push_back({name + ".im", value->imag()});
}

// If no Fourier wave of the density grows, the largest growth rate is 0, the limit for long waves.
std::string fastest_wave_text(const KramersMoyalRegularisationResult& row,
                              double fd_fpk::FastestGrowingWave::*of) {
  if (row.symbol_grows) return number_text((*row.symbol).*of, "{:.4g}");
  return row.symbol && of == &fd_fpk::FastestGrowingWave::rate ? "0" : "";
}

std::string eigenvalue_text(const std::optional<std::complex<double>>& value) {
  if (!value) return "";
  const double re = value->real(), im = value->imag();
  const std::string real =
      std::abs(re) < 1e-7 ? fmt::format("{:.0e}", re) : fmt::format("{:.4g}", re);
  return std::abs(im) > 1e-7 ? fmt::format("{}+-{:.3g}i", real, im) : real;
}

std::string time_behaviour_text(const KramersMoyalRegularisationResult& row) {
  if (row.growth_rate) return fmt::format("x10 in {:.2g}", std::numbers::ln10 / *row.growth_rate);
  if (row.rightmost) return "settles";
  return row.symbol ? "no growth" : "";
}

std::string l1_distance_text(const std::optional<double>& l1) {
  return number_text(l1, l1.value_or(0) < 10 ? "{:.5f}" : "{:.1e}");
}

std::string velocity_step_text(const KramersMoyalRegularisationResult& row) {
  return fmt::format("{:.3g}", row.step);
}

std::string scheme_table_text(const KramersMoyalRegularisationStudy& study,
                              const report::TerminalTextFormat& format) {
  std::vector<StudyRecord> rows;
  for (const auto& row : study.rows) {
    rows.push_back({{"scheme", row.scheme},
                    {"h", row.step},
                    {"l", row.length > 0 ? base::Value(row.length) : base::Value()},
                    {"cells", fmt::format("{}x{}", row.nx, row.nv)},
                    {"rate", fastest_wave_text(row, &fd_fpk::FastestGrowingWave::rate)},
                    {"q", fastest_wave_text(row, &fd_fpk::FastestGrowingWave::wavenumber)},
                    {"rightmost", eigenvalue_text(row.rightmost)},
                    {"next", eigenvalue_text(row.next)},
                    {"in time", time_behaviour_text(row)},
                    {"l1_y", l1_distance_text(row.l1_y)},
                    {"l1_ydot", l1_distance_text(row.l1_ydot)},
                    {"least", transform::value_from_optional(row.min_density)}});
  }
  constexpr int kAlways = report::kAlwaysShown;
  return records_table_text(rows,
                            {{"", "scheme", "scheme", "", kAlways, true},
                             {"", "h", "h", "{:.3g}"},
                             {"", "l", "l", "{:.3g}", 4},
                             {"", "cells", "cells", "", 1},
                             {"symbol", "rate", "rate", ""},
                             {"symbol", "q", "q", ""},
                             {"matrix", "rightmost", "rightmost", ""},
                             {"matrix", "next", "next", "", 2},
                             {"", "in time", "in time", "", kAlways, true},
                             {"null vector", "L1 p(y)", "l1_y", "", 3},
                             {"null vector", "L1 p(y')", "l1_ydot", ""},
                             {"null vector", "least", "least", "{:.0e}"}},
                            format);
}

// Returns the text of a list of velocity steps, e.g. "h = 0.158, 0.0791 and 0.0395".
std::string velocity_step_list(const std::vector<KramersMoyalRegularisationResult>& rows) {
  std::vector<std::string> steps;
  for (const auto& row : rows) steps.push_back(velocity_step_text(row));
  return "h = " + join_with_and(steps);
}

std::vector<KramersMoyalRegularisationResult> rows_of_scheme(
    const KramersMoyalRegularisationStudy& study, const std::string& scheme, bool growing) {
  std::vector<KramersMoyalRegularisationResult> chosen;
  for (const auto& row : study.rows) {
    const bool known = row.symbol.has_value();
    if (row.scheme == scheme && known && row.growth_rate.has_value() == growing) {
      chosen.push_back(row);
    }
  }
  return chosen;
}

// The exponent a in growth rate ~ h^a is computed from the two smallest velocity steps h on which a
// wave grows.
std::string unregularised_scheme_sentence(const KramersMoyalRegularisationStudy& study) {
  const auto growing = rows_of_scheme(study, "literal", true);
  if (growing.empty()) return "The literal scheme grows on none of these steps.";
  std::string text =
      fmt::format("The literal scheme, l = h, grows at {}", velocity_step_list(growing));
  if (growing.size() > 1) {
    const auto &fine = growing.back(), &coarse = growing[growing.size() - 2];
    const double exponent =
        std::log(*fine.growth_rate / *coarse.growth_rate) / std::log(fine.step / coarse.step);
    text += fmt::format(", in the end as h^{:.2f} (h^-4 in the limit)", exponent);
  }
  double farthest = 0;
  std::optional<double> lowest;
  for (const auto& row : growing) {
    farthest = std::max(farthest, row.l1_ydot.value_or(0));
    if (const auto least = row.min_density) lowest = std::min(lowest.value_or(*least), *least);
  }
  text += ": no refinement can converge.";
  if (lowest) {
    text += fmt::format(
        " Its null vector is then up to L1 {:.2g} from kf and falls to {:.2g} of its peak.",
        farthest, *lowest);
  }
  return text;
}

std::string regularised_scheme_sentence(const KramersMoyalRegularisationStudy& study) {
  const auto growing = rows_of_scheme(study, "regularised", true);
  const auto settled = rows_of_scheme(study, "regularised", false);
  std::string text =
      fmt::format("The fourth difference over the default length l = {:.3g}", study.default_length);
  if (settled.empty()) return text + " grows on every step.";
  text += growing.empty() ? " grows on no step"
                          : fmt::format(" grows at {} and not at {}", velocity_step_list(growing),
                                        velocity_step_list(settled));
  const KramersMoyalRegularisationResult& finest = settled.back();
  if (finest.l1_y && finest.l1_ydot) {
    text += fmt::format(
        "; on the finest of these steps its density is L1 {:.2g} in p(y) and {:.2g} in p(y') "
        "from kf",
        *finest.l1_y, *finest.l1_ydot);
  }
  return text + '.';
}

std::string threshold_sentence(const KramersMoyalRegularisationStudy& study) {
  const auto below = rows_of_scheme(study, "0.9 l*", true),
             above = rows_of_scheme(study, "1.1 l*", true);
  std::string text = fmt::format("The threshold is l* = {:.3g}: ", study.shortest_length);
  text += below.empty()
              ? "10 % below it no matrix grows"
              : fmt::format("10 % below it the matrices of {} grow", velocity_step_list(below));
  if (below.size() > 1) {
    text += fmt::format(", at a rate that is independent of the step ({:.3g} by the symbol)",
                        below.back().symbol->rate);
  }
  text += above.empty()
              ? "; 10 % above it no matrix grows."
              : fmt::format("; 10 % above it the matrices of {} grow.", velocity_step_list(above));
  return text;
}

// Each remark of the study is printed once, with the table rows to which the remark applies.
std::string remarks_text(const KramersMoyalRegularisationStudy& study, std::size_t width) {
  std::map<std::string, std::vector<std::string>> rows_with;
  std::vector<std::string> order;
  for (const auto& row : study.rows) {
    if (row.remark.empty()) continue;
    if (!rows_with.contains(row.remark)) order.push_back(row.remark);
    rows_with[row.remark].push_back(
        fmt::format("{} at h = {}", row.scheme, velocity_step_text(row)));
  }
  std::string text;
  for (const auto& remark : order) {
    text += wrap_text(fmt::format("  {}: {}", join_with_and(rows_with[remark]), remark), width, 4);
  }
  return text;
}

constexpr const char* kRegularisationLegend =
    "h: velocity step; l: step of the fourth difference (pade has none). symbol: largest growth "
    "rate of a wave exp(i q y') under the excitation alone. matrix: eigenvalues of the whole "
    "operator with the largest real parts; the stationary density has the eigenvalue 0, the next "
    "is the slowest decay. in time: growth or decay of a disturbance. null vector: its distance to "
    "the density of the jump equation kf on the same grid, and its least value relative to the "
    "peak.";

}  // namespace

StudyRecord make_study_record(const KramersMoyalRegularisationResult& row) {
  StudyRecord record{
      {"scheme", row.scheme},
      {"step", row.step},
      // The Pade scheme has no fourth difference, and therefore no regularisation length of a
      // fourth difference.
      {"length", row.length > 0 ? Value(row.length) : Value()},
      {"nx", value_from_count(row.nx)},
      {"nv", value_from_count(row.nv)},
      {"symbol_rate", optional_member_value(row.symbol, &FastestGrowingWave::rate)},
      {"symbol_wavenumber", optional_member_value(row.symbol, &FastestGrowingWave::wavenumber)},
      {"symbol_grows", row.symbol ? Value(row.symbol_grows) : Value()},
      {"growth_rate", value_from_optional(row.growth_rate)},
      {"l1_y", value_from_optional(row.l1_y)},
      {"l1_ydot", value_from_optional(row.l1_ydot)},
      {"min_density", value_from_optional(row.min_density)},
      {"remark", row.remark}};
  add_eigenvalue("rightmost", row.rightmost, record);
  add_eigenvalue("next", row.next, record);
  return record;
}

std::string study_json_text(const KramersMoyalRegularisationStudy& study,
                            const std::string& command) {
  return study_records_to_json(
      KramersMoyalRegularisationStudy::kName, study.problem, command,
      {{"default_length", study.default_length}, {"shortest_length", study.shortest_length}},
      {{"rows", make_study_records(study.rows)}});
}

std::string study_csv_text(const KramersMoyalRegularisationStudy& study) {
  return records_csv_text(
      make_study_records(study.rows),
      "scheme step length nx nv symbol_rate symbol_wavenumber rightmost_re=rightmost.re rightmost_im=rightmost.im next_re=next.re next_im=next.im growth_rate l1_y l1_ydot min_density");
}

std::string study_table_text(const KramersMoyalRegularisationStudy& study,
                             const report::TerminalTextFormat& format) {
  std::string text = wrap_text(report::case_title(study.problem), format.width, 2) +
                     scheme_table_text(study, format) + remarks_text(study, format.width);
  for (const auto& sentence : {unregularised_scheme_sentence(study),
                               regularised_scheme_sentence(study), threshold_sentence(study)}) {
    text += wrap_text("  " + sentence, format.width, 2);
  }
  return text + '\n' + wrap_text(kRegularisationLegend, format.width);
}

}  // namespace fpkcheck::study
