#include "workflows/study/functionals/functionals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "fd_fpk/functionals/spectrum.hpp"
#include "mcs/spectrum.hpp"
#include "problem/motion_scales.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"

namespace fpkcheck::study {
namespace {

using transform::SpectralDensity;
using transform::StateVariable;

constexpr int kAutomaticIntervals = 200, kMostIntervals = 10000;

std::vector<double> evenly_spaced_values(double from, double to, int intervals) {
  std::vector<double> values;
  for (int k = 0; k <= intervals; ++k) values.push_back(from + (to - from) * k / intervals);
  return values;
}

std::vector<double> parse_frequencies(const problem::Problem& problem,
                                      const SpectrumOptions& options) {
  const auto scales = problem::motion_scales(
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem));
  const double mean_frequency = scales.velocity_deviation / scales.displacement_deviation;
  if (!options.frequencies) {
    const double last = 4 * mean_frequency;
    const double unit = std::pow(10, std::floor(std::log10(last)) - 1);
    return evenly_spaced_values(0, std::ceil(last / unit) * unit, kAutomaticIntervals);
  }
  const std::string& text = *options.frequencies;
  const auto refuse = [&](const std::string& requirement) {
    throw InputError(fmt::format("--frequencies {} ({})", base::in_quotes(text), requirement));
  };
  const auto first = text.find(':'), second = text.find(':', first + 1);
  std::optional<double> given_from, given_to, given_intervals;
  if (first != std::string::npos && second != std::string::npos) {
    given_from = parse_finite_number(text.substr(0, first));
    given_to = parse_finite_number(text.substr(first + 1, second - first - 1));
    given_intervals = parse_finite_number(text.substr(second + 1));
  }
  if (!given_from || !given_to || !given_intervals) refuse("must be FROM:TO:N, as 0:4:200");
  const double from = *given_from, to = *given_to, intervals = *given_intervals;
  const bool valid = 0 <= from && from < to && 1 <= intervals && intervals <= kMostIntervals &&
                     intervals == std::floor(intervals);
  if (!valid) {
    refuse(fmt::format("must satisfy 0 <= FROM < TO and 1 <= N <= {}", kMostIntervals));
  }
  constexpr double kMostFrequencies = 1000;
  if (to > kMostFrequencies * mean_frequency) {
    refuse(fmt::format("TO must be at most {:g}, {:g} times the mean frequency",
                       kMostFrequencies * mean_frequency, kMostFrequencies));
  }
  return evenly_spaced_values(from, to, static_cast<int>(intervals));
}

// Returns the times of the autocovariance, up to two decay times of the slowest mode of energy
// averaging.
std::vector<double> autocovariance_lags(const problem::Problem& problem) {
  constexpr double kDecayTimes = 2;
  constexpr int kIntervals = 200;
  const auto scales = problem::motion_scales(
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem));
  const double last = kDecayTimes / scales.slowest_decay_rate;
  const double unit = std::pow(10, std::floor(std::log10(last)) - 1);
  return evenly_spaced_values(0, std::ceil(last / unit) * unit, kIntervals);
}

// Distances between two spectral densities over all frequencies.
struct SpectrumDistance {
  double largest_in_errors;  // largest |difference| / combined error
  double root_mean_square;   // root mean square of |difference| / combined error
};
SpectrumDistance spectrum_distance(const SpectralDensity& a, const SpectralDensity& b) {
  SpectrumDistance result{0, 0};
  for (std::size_t k = 0; k < a.density.size(); ++k) {
    const double error = std::hypot(a.error[k], b.error[k]);
    const double ratio = error > 0 ? std::abs(a.density[k] - b.density[k]) / error : 0;
    result.largest_in_errors = std::max(result.largest_in_errors, ratio);
    result.root_mean_square += ratio * ratio;
  }
  result.root_mean_square =
      std::sqrt(result.root_mean_square / static_cast<double>(a.density.size()));
  return result;
}

bool has_spectral_density(const SpectralDensity& spectrum) { return !spectrum.density.empty(); }

std::string variable_symbol(StateVariable variable) {
  return variable == StateVariable::y ? "y" : "y'";
}

}  // namespace

const base::OptionsDescription<SpectrumOptions>& spectrum_option_descriptions() {
  static const auto description = with_functional_options(
      base::OptionsDescription<SpectrumOptions>("spectrum ")
          .add("of", &SpectrumOptions::variable, {"V", "y (displacement) or ydot (velocity)"})
          .add("frequencies", &SpectrumOptions::frequencies,
               {"FROM:TO:N",
                "angular frequencies FROM .. TO in N intervals (default: 0 to four mean "
                "frequencies in 200 intervals)"}),
      "largest error of the finite volumes, relative to the largest density, for status ok",
      "simulated time (default: standard errors of about 1.5 % of the density)");
  return description;
}

SpectrumStudy study_spectrum(const problem::Problem& problem, const SpectrumOptions& options,
                             const methods::ProgressListener& listener) {
  const std::vector<double> at = parse_frequencies(problem, options),
                            times = autocovariance_lags(problem);
  SpectrumStudy study{problem, options, {}};
  for_each_selected_method(problem, options, listener, [&](const SelectedFunctionalMethod& method) {
    study.spectra.push_back(
        method.fd ? fd_fpk::solve_spectrum(problem, *method.fd, options.variable, at, times)
                  : mcs::estimate_spectrum(problem, *method.mcs, options.variable, at, times));
  });
  return study;
}

bool has_converged(const SpectrumStudy& study) { return have_converged_results(study.spectra); }

std::string study_json_text(const SpectrumStudy& study, const std::string& command) {
  using results::Json;
  Json spectra = Json::array();
  for (const SpectralDensity& s : study.spectra) {
    Json one{{"solution", s.id},
             {"of", name(s.variable)},
             {"status", name(s.status)},
             {"reason", s.reason},
             {"seconds", s.seconds},
             {"frequency", has_spectral_density(s) ? Json(s.frequencies) : Json::array()},
             {"density", s.density},
             {"error", s.error},
             {"error_is", error_kind_text(s.has_standard_errors, s.has_kick_interval_errors)},
             {"variance", s.variance},
             {"variance_error", s.variance_error},
             {"autocovariance",
              {{"lag", s.lags}, {"value", s.autocovariance}, {"error", s.autocovariance_error}}},
             {"peak", nullptr}};
    if (s.peak) {
      one["peak"] = {{"frequency", s.peak->frequency},
                     {"density", s.peak->density},
                     {"half_width", results::number_or_null_json(s.peak->half_width)}};
    }
    one["modes"] = Json::array();
    for (const auto& mode : s.modes) {
      one["modes"].push_back({{"decay_rate", mode.decay_rate},
                              {"frequency", mode.frequency},
                              {"decay_rate_error", mode.decay_rate_error},
                              {"frequency_error", mode.frequency_error},
                              {"share", mode.share}});
    }
    spectra.push_back(std::move(one));
  }
  return functional_json(study.problem, "spectra", spectra, command);
}

std::string study_csv_text(const SpectrumStudy& study) {
  std::vector<StudyRecord> rows;
  for (const SpectralDensity& s : study.spectra) {
    const auto add = [&](const char* abscissa, const std::vector<double>& x, const char* quantity,
                         const std::vector<double>& values, const std::vector<double>& errors) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        rows.push_back({{"case", study.problem.name},
                        {"solution", s.id},
                        {"variable", std::string(name(s.variable))},
                        {abscissa, x[k]},
                        {quantity, values[k]},
                        {"error", errors[k]}});
      }
    };
    add("frequency", s.frequencies, "density", s.density, s.error);
    add("lag", s.lags, "autocovariance", s.autocovariance, s.autocovariance_error);
  }
  return records_csv_text(rows,
                          "case solution variable frequency density error lag autocovariance");
}

std::string study_table_text(const SpectrumStudy& study, const report::TerminalTextFormat& format) {
  constexpr std::size_t kRows = 16;
  std::string text = report::wrap_text(report::case_title(study.problem), format.width);
  text += report::wrap_text(
      fmt::format("one-sided spectral density of {}; its integral over w >= 0 is the variance",
                  variable_symbol(study.options.variable)),
      format.width);
  std::vector<StudyTableColumn> columns{{"", "w", "w", "{:.4g}"}};
  std::vector<StudyRecord> rows;
  const SpectralDensity* first = nullptr;
  for (const SpectralDensity& s : study.spectra) {
    if (!has_spectral_density(s)) continue;
    if (first == nullptr) first = &s;
    append_value_columns(s.id, "density", s.has_standard_errors && !s.has_kick_interval_errors,
                         columns);
    const std::size_t last = s.density.size() - 1, step = (last + kRows - 1) / kRows;
    for (std::size_t k = 0, row = 0; k <= last; k += step, ++row) {
      if (row == rows.size()) rows.push_back({{"w", s.frequencies[k]}});
      rows[row].push_back({s.id, s.density[k]});
      rows[row].push_back({s.id + "-error", s.error[k]});
    }
  }
  if (first != nullptr) text += records_table_text(rows, columns, format);
  for (const SpectralDensity& s : study.spectra) {
    std::string line = solution_status_line(s.id, s.status, s.reason);
    if (has_spectral_density(s)) {
      line += fmt::format("variance {:.6g} +- {:.1e}", s.variance, s.variance_error);
      if (s.peak) {
        line += fmt::format(", peak {:.5g} at w = {:.5g}", s.peak->density, s.peak->frequency);
        if (s.peak->half_width) line += fmt::format(" of half-width {:.3g}", *s.peak->half_width);
      }
      for (const auto& mode : s.modes) {
        constexpr double kSmallestShare = 0.01;
        if (mode.share < kSmallestShare) continue;
        line += fmt::format("; {:.0f} % of the variance decays with the rate {:.5g} +- {:.1e}",
                            100 * mode.share, mode.decay_rate, mode.decay_rate_error);
        if (mode.frequency > 0) line += fmt::format(" at the frequency {:.5g}", mode.frequency);
      }
      line += fmt::format("; {}", s.details);
      if (&s != first) {
        const auto [largest, mean] = spectrum_distance(*first, s);
        line += fmt::format(
            "; differs from {} by {:.1f} combined errors at most, {:.1f} in root "
            "mean square",
            first->id, largest, mean);
      }
      line += fmt::format(" ({:.1f} s)", s.seconds);
    }
    text += report::wrap_text(line, format.width, 2);
  }
  return text;
}

namespace {

// Returns one series for each solution. The series of a simulation has marks at about 50 points,
// with intervals of two standard errors.
std::vector<report::FigureSeries> series_of_solutions(
    const SpectrumStudy& study, std::vector<double> SpectralDensity::*abscissas,
    std::vector<double> SpectralDensity::*values, std::vector<double> SpectralDensity::*errors) {
  std::vector<report::FigureSeries> series;
  for (const auto& method : methods_selected_by_list(study.options)) {
    const auto found = std::ranges::find(study.spectra, method.identity.id, &SpectralDensity::id);
    if (found == study.spectra.end() || ((*found).*values).empty()) continue;
    const SpectralDensity& s = *found;
    report::FigureSeries one = report::make_empty_figure_series(s.id, method.identity.plot_style);
    const std::vector<double>&x = s.*abscissas, &y = s.*values, &error = s.*errors;
    const std::size_t step = s.has_standard_errors ? std::max<std::size_t>(y.size() / 50, 1) : 1;
    one.mark_step = s.has_standard_errors ? 1 : std::max<std::size_t>(y.size() / 25, 1);
    for (std::size_t k = 0; k < y.size(); k += step) {
      one.points.push_back(
          figure_point_with_error_interval(x[k], y[k], error[k], s.has_standard_errors));
    }
    series.push_back(std::move(one));
  }
  return series;
}

}  // namespace

report::Figure study_figure(const SpectrumStudy& study) {
  const std::string of = variable_symbol(study.options.variable);
  const auto densities = series_of_solutions(study, &SpectralDensity::frequencies,
                                             &SpectralDensity::density, &SpectralDensity::error);
  if (densities.empty()) return {};
  const SpectralDensity& first = *std::ranges::find_if(study.spectra, has_spectral_density);
  std::vector<report::FigurePanel> panels{
      {.title = fmt::format("one-sided spectral density of {}", of),
       .x = {"{/:Italic w}", first.frequencies.front(), first.frequencies.back()},
       .y = report::logarithmic_axis("{/:Italic G}({/:Italic w})", densities,
                                     &report::FigurePoint::y),
       .series = densities}};
  const auto covariances =
      series_of_solutions(study, &SpectralDensity::lags, &SpectralDensity::autocovariance,
                          &SpectralDensity::autocovariance_error);
  if (!covariances.empty()) {
    panels.push_back({.title = fmt::format("autocovariance of {}", of),
                      .x = {"{/:Italic t}", 0, first.lags.back()},
                      .y = report::linear_axis("{/:Italic R}({/:Italic t})", covariances,
                                               &report::FigurePoint::y),
                      .series = covariances});
  }
  return {.title = report::problem_title_parts(study.problem), .panels = panels, .columns = 1};
}

}  // namespace fpkcheck::study
