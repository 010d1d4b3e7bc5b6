#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::problem {

/// A law of impulse amplitudes as a table: probabilities of discrete amplitudes, or a density that
/// is linear between the amplitudes and 0 outside. Amplitudes increase; probabilities sum to 1,
/// densities integrate to 1.
struct AmplitudeTable {
  enum class Kind { probability, density };

  Kind kind = Kind::probability;
  std::vector<double> amplitude, weight;

  double mean() const;
  /// E[(Y - E[Y])^2].
  double variance() const;
  /// The law of -Y.
  AmplitudeTable mirrored() const;
};

inline constexpr std::size_t kMaxTableRows = 1000;
/// Largest deviation of a table's sum (or integral) from 1; the table is then divided by the sum.
inline constexpr double kTableSumTolerance = 1e-3;

/// Parses a CSV text with the columns amplitude,probability or amplitude,density.
/// @param where name of the file in messages
/// @throws InputError "WHERE:LINE: .." on one line: the error and what is allowed
AmplitudeTable parse_amplitude_csv(std::string_view csv, const std::string& where);

/// The table as one word of a case file, "probability(-1:0.25,3:0.75)"; complete and exact.
std::string table_literal(const AmplitudeTable& table);
/// Whether a text begins like such a word.
bool is_table_literal(std::string_view text);
/// Parses such a word.
/// @throws InputError "impulse.table = .."
AmplitudeTable parse_table_literal(std::string_view text);

/// A short description for people: "37 probabilities from -1 to 3".
std::string table_summary(std::string_view table_text);

}  // namespace fpkcheck::problem
