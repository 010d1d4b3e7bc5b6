#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::problem {

/// A tabulated law of impulse amplitudes: either probabilities of discrete amplitudes, or values of
/// a density that is linear between neighbouring amplitudes and 0 outside the table. The amplitudes
/// of the table increase; the probabilities have the sum 1, or the density has the integral 1.
struct AmplitudeTable {
  enum class WeightType { probability, density };

  WeightType kind = WeightType::probability;
  std::vector<double> amplitude, weight;

  double amplitude_mean() const;
  double amplitude_variance() const;
  /// Returns the amplitude table of the law of -Y, where the amplitude Y has the present table.
  AmplitudeTable with_negated_amplitudes() const;
};

inline constexpr std::size_t kMaxTableRows = 1000;
/// Largest accepted deviation from 1 of the sum of the probabilities, or of the integral of the
/// density, of an amplitude table. A table with an accepted deviation is normalised to the sum or
/// integral 1.
inline constexpr double kTableSumTolerance = 1e-3;

/// Parses a table of amplitudes from CSV text with the columns amplitude,probability or
/// amplitude,density.
/// @param file_name name of the CSV file in error messages
/// @throws InputError "FILE_NAME:LINE: .." that states the error and the allowed contents
AmplitudeTable parse_amplitude_csv(std::string_view csv, const std::string& file_name);

/// Returns the table literal of an amplitude table, that is, the text of the table as one word of a
/// case file: "probability(-1:0.25,3:0.75)".
std::string amplitude_table_literal(const AmplitudeTable& table);
/// Returns whether a text begins like a table literal, with "probability(" or "density(".
bool is_amplitude_table_literal(std::string_view text);
/// Returns the amplitude table of a table literal.
/// @throws InputError "impulse.table = .." if the text is not a table literal or the table is
/// invalid
AmplitudeTable parse_amplitude_table_literal(std::string_view text);

/// Returns a short description of a table literal for reports, such as "37 probabilities from -1 to
/// 3".
std::string amplitude_table_summary(std::string_view table_text);

/// Converts the value of `impulse.table` in a case file, a table literal or the name of a CSV file,
/// to a table literal. With a table literal instead of the CSV file, the problem does not depend on
/// the CSV file.
/// @param folder directory to which relative file names refer; an empty path is the working
/// directory
/// @throws InputError with a one-line message if the file cannot be read, is too large or has an
/// invalid line
std::string table_literal_from_setting(const std::string& setting,
                                       const std::filesystem::path& folder);

}  // namespace fpkcheck::problem
