#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::problem {

/// A law of impulse amplitudes as a table. The table contains either probabilities of discrete
/// amplitudes, or values of a density that is linear between neighbouring amplitudes and 0 outside
/// the table. The amplitudes increase. The probabilities have the sum 1, or the density has the
/// integral 1.
struct AmplitudeTable {
  enum class WeightType { probability, density };

  WeightType kind = WeightType::probability;
  std::vector<double> amplitude, weight;

  double mean() const;
  /// The variance E[(Y - E[Y])^2].
  double variance() const;
  /// The table of the law of -Y.
  AmplitudeTable mirror_image() const;
};

inline constexpr std::size_t kMaxTableRows = 1000;
/// Largest accepted deviation from 1 of the sum of the probabilities (or of the integral of the
/// density). Within this tolerance the table is divided by its sum or integral.
inline constexpr double kTableSumTolerance = 1e-3;

/// Parses a table of amplitudes from CSV text with the columns amplitude,probability or
/// amplitude,density.
/// @param where name of the file in messages
/// @throws InputError "WHERE:LINE: ..", one line that states the error and the allowed contents
AmplitudeTable parse_amplitude_csv(std::string_view csv, const std::string& where);

/// The table literal: the whole table, with all digits, as one word of a case file. Example:
/// "probability(-1:0.25,3:0.75)".
std::string amplitude_table_literal(const AmplitudeTable& table);
/// Whether a text begins like a table literal, with "probability(" or "density(".
bool is_amplitude_table_literal(std::string_view text);
/// Parses a table literal.
/// @throws InputError "impulse.table = .." if the text is not a table literal or the table is
/// invalid
AmplitudeTable parse_amplitude_table_literal(std::string_view text);

/// A short description of a table literal for reports: "37 probabilities from -1 to 3".
std::string amplitude_table_summary(std::string_view table_text);

/// Converts the value of `impulse.table` in a case file to a table literal, which contains the
/// whole table (problem/amplitude_table.hpp). A problem that was read therefore needs no further
/// file. A value that is a table literal is returned unchanged; any other value is the name of a
/// CSV file.
/// @param folder directory to which relative file names refer; if empty, the working directory
/// @throws InputError with a one-line message if the file cannot be read, is too large or has an
/// invalid line
std::string table_literal_from_setting(const std::string& setting,
                                       const std::filesystem::path& folder);

}  // namespace fpkcheck::problem
