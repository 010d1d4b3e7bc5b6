#include "problem/amplitude_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::problem {
namespace {

using WeightType = AmplitudeTable::WeightType;
using base::in_quotes;

constexpr std::string_view kProbability = "probability", kDensity = "density";
// Largest accepted magnitude of the numbers of an amplitude table, equal to kLargestMagnitude for
// case files; powers of accepted numbers are finite.
constexpr double kLargest = 1e30;

std::string_view weight_column_name(WeightType kind) {
  return kind == WeightType::probability ? kProbability : kDensity;
}

std::string_view trim_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<double> parse_table_number(std::string_view text) {
  text = trim_blanks(text);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::abs(number) <= kLargest ? std::optional(number) : std::nullopt;
}

/// Builds an amplitude table row by row and checks each row separately, so that an error message
/// names the line of the row.
class AmplitudeTableBuilder {
 public:
  explicit AmplitudeTableBuilder(WeightType kind) { table_.kind = kind; }

  /// Appends a row with an amplitude and its weight to the amplitude table.
  /// @param at beginning of the error message: the file and the line of the row
  /// @throws InputError "AT .." for an invalid row of the amplitude table
  void add_row(std::string_view row, char separator, const std::string& at) {
    const auto cut = row.find(separator);
    const auto amplitude = parse_table_number(row.substr(0, cut));
    const auto weight =
        cut == std::string_view::npos ? std::nullopt : parse_table_number(row.substr(cut + 1));
    if (!amplitude || !weight) {
      fail(at, fmt::format("{}: a row must be two finite numbers, amplitude{}{}", in_quotes(row),
                           separator, weight_column_name(table_.kind)));
    }
    if (!table_.amplitude.empty() && !(*amplitude > table_.amplitude.back())) {
      fail(at, fmt::format("amplitude {} after {} (amplitudes must increase)", *amplitude,
                           table_.amplitude.back()));
    }
    const bool positive = table_.kind == WeightType::density ? *weight >= 0 : *weight > 0;
    if (!positive) {
      fail(at, fmt::format("{} = {} (must be {})", weight_column_name(table_.kind), *weight,
                           table_.kind == WeightType::density ? "0 or above" : "above 0"));
    }
    if (table_.amplitude.size() == kMaxTableRows) {
      fail(at, fmt::format("more than {} rows, the limit of an amplitude table", kMaxTableRows));
    }
    table_.amplitude.push_back(*amplitude);
    table_.weight.push_back(*weight);
  }

  /// Returns the amplitude table of all added rows, normalised to the sum or integral 1.
  /// @throws InputError "AT .." for an invalid amplitude table
  AmplitudeTable finish_table(const std::string& at) && {
    if (table_.amplitude.size() < 2) fail(at, "fewer than two rows: Y must vary");
    double sum = 0;
    for (std::size_t k = 0; k < table_.weight.size(); ++k) {
      if (table_.kind == WeightType::probability) {
        sum += table_.weight[k];
      } else if (k > 0) {
        sum += (table_.amplitude[k] - table_.amplitude[k - 1]) *
               (table_.weight[k] + table_.weight[k - 1]) / 2;
      }
    }
    if (!(std::abs(sum - 1) <= kTableSumTolerance)) {
      fail(at, fmt::format("the table's {} {} {:.6g} (must be 1 within {})",
                           weight_column_name(table_.kind),
                           table_.kind == WeightType::probability ? "sums to" : "integrates to",
                           sum, kTableSumTolerance));
    }
    // The standard deviation of the amplitude table must exceed rounding errors, and powers of the
    // standardised amplitudes must be finite.
    constexpr double kLeastSpread = 1e-30, kLeastOfSize = 1e-9, kLeastShare = 1e-20;
    const double first = table_.amplitude.front(), last = table_.amplitude.back();
    const double spread = last - first, size = std::max(std::abs(first), std::abs(last));
    if (spread < std::max(kLeastSpread, kLeastOfSize * size) ||
        table_.amplitude_variance() < kLeastShare * spread * spread) {
      fail(at,
           fmt::format("the table's amplitudes, {} .. {}, have a negligible variance: Y must vary",
                       first, last));
    }
    // An amplitude table whose sum deviates from 1 by at most kRounding is not normalised, so that
    // writing and reading do not change an amplitude table.
    constexpr double kRounding = 1e-12;
    if (std::abs(sum - 1) > kRounding) {
      for (double& weight : table_.weight) weight /= sum;
    }
    return std::move(table_);
  }

 private:
  [[noreturn]] static void fail(const std::string& at, const std::string& what) {
    throw InputError(fmt::format("{} {}", at, what));
  }

  AmplitudeTable table_;
};

// Computes the moment E[(Y - about)^power] for power 1 or 2. Simpson's rule is exact for the
// moment, since the density is piecewise linear and the integrand at most cubic.
double moment_about(const AmplitudeTable& table, double about, int power) {
  const auto value = [&](double y) { return power == 1 ? y - about : (y - about) * (y - about); };
  double sum = 0;
  for (std::size_t k = 0; k < table.amplitude.size(); ++k) {
    if (table.kind == WeightType::probability) {
      sum += table.weight[k] * value(table.amplitude[k]);
    } else if (k > 0) {
      const double from = table.amplitude[k - 1], to = table.amplitude[k];
      const double f = table.weight[k - 1], g = table.weight[k];
      sum += (to - from) / 6 *
             (f * value(from) + 2 * (f + g) * value((from + to) / 2) + g * value(to));
    }
  }
  return sum;
}

}  // namespace

double AmplitudeTable::amplitude_mean() const {
  // A mean amplitude below kRounding times the range of the amplitudes is set to 0.
  constexpr double kRounding = 1e-15;
  const double first = amplitude.front(), last = amplitude.back(), middle = (first + last) / 2;
  const double mean = middle + moment_about(*this, middle, 1);
  return std::abs(mean) < kRounding * (last - first) ? 0 : mean;
}

double AmplitudeTable::amplitude_variance() const {
  return moment_about(*this, amplitude_mean(), 2);
}

AmplitudeTable AmplitudeTable::with_negated_amplitudes() const {
  AmplitudeTable table = *this;
  for (double& y : table.amplitude) y = 0 - y;  // the subtraction avoids -0
  std::ranges::reverse(table.amplitude);
  std::ranges::reverse(table.weight);
  return table;
}

AmplitudeTable parse_amplitude_csv(std::string_view csv, const std::string& file_name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (csv.starts_with(kByteOrderMark)) csv.remove_prefix(kByteOrderMark.size());
  std::optional<AmplitudeTableBuilder> rows;
  int number = 0;
  std::string at = fmt::format("{}:1:", file_name);
  while (!csv.empty()) {
    const auto end = csv.find('\n');
    const std::string_view line = trim_blanks(csv.substr(0, end));
    csv.remove_prefix(end == std::string_view::npos ? csv.size() : end + 1);
    ++number;
    if (line.empty() || line.front() == '#') continue;
    at = fmt::format("{}:{}:", file_name, number);
    if (rows) {
      rows->add_row(line, ',', at);
      continue;
    }
    const auto comma = line.find(',');
    const bool named =
        comma != std::string_view::npos && trim_blanks(line.substr(0, comma)) == "amplitude";
    const std::string_view of = named ? trim_blanks(line.substr(comma + 1)) : std::string_view();
    if (of != kProbability && of != kDensity) {
      throw InputError(
          fmt::format("{} {} (the first line must be amplitude,probability or amplitude,density)",
                      at, in_quotes(line)));
    }
    rows.emplace(of == kProbability ? WeightType::probability : WeightType::density);
  }
  if (!rows) {
    throw InputError(fmt::format(
        "{} the table is empty (the first line must be amplitude,probability or amplitude,density)",
        at));
  }
  return std::move(*rows).finish_table(at);
}

std::string amplitude_table_literal(const AmplitudeTable& table) {
  std::string text = fmt::format("{}(", weight_column_name(table.kind));
  for (std::size_t k = 0; k < table.amplitude.size(); ++k) {
    text += fmt::format("{}{}:{}", k == 0 ? "" : ",", table.amplitude[k], table.weight[k]);
  }
  return text + ')';
}

bool is_amplitude_table_literal(std::string_view text) {
  return text.starts_with("probability(") || text.starts_with("density(");
}

AmplitudeTable parse_amplitude_table_literal(std::string_view text) {
  const std::string at = fmt::format("impulse.table = {}:", in_quotes(text));
  if (!is_amplitude_table_literal(text) || text.back() != ')') {
    throw InputError(
        fmt::format("{} not a table; name a CSV file, or write probability(-1:0.5,1:0.5)", at));
  }
  AmplitudeTableBuilder rows(text.front() == 'p' ? WeightType::probability : WeightType::density);
  const auto open = text.find('(');
  std::string_view list = text.substr(open + 1, text.size() - open - 2);
  while (!list.empty()) {
    const auto comma = list.find(',');
    rows.add_row(list.substr(0, comma), ':', at);
    list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
  }
  return std::move(rows).finish_table(at);
}

std::string amplitude_table_summary(std::string_view text) {
  const AmplitudeTable table = parse_amplitude_table_literal(text);
  return fmt::format("{} {} from {:g} to {:g}", table.amplitude.size(),
                     table.kind == WeightType::probability ? "probabilities" : "densities",
                     table.amplitude.front(), table.amplitude.back());
}

std::string table_literal_from_setting(const std::string& setting,
                                       const std::filesystem::path& folder) {
  constexpr std::size_t kMostBytes = 1 << 17;
  if (is_amplitude_table_literal(setting))
    return amplitude_table_literal(parse_amplitude_table_literal(setting));
  const std::filesystem::path file = folder / setting;
  const auto csv = base::read_input_file(file, kMostBytes);
  if (!csv) {
    throw InputError(
        fmt::format("impulse.table = {}: the file cannot be read; name a CSV file with the columns "
                    "amplitude,probability or amplitude,density",
                    base::in_quotes(file.string())));
  }
  return amplitude_table_literal(parse_amplitude_csv(*csv, base::to_printable_text(file.string())));
}

}  // namespace fpkcheck::problem
