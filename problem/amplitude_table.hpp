#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::problem {

/// A law of amplitudes as a table: what each is worth, or a density that is linear from one to the
/// next and 0 beyond the ends. The amplitudes increase; probabilities sum to 1, densities integrate
/// to 1.
struct AmplitudeTable {
  enum class Kind { probability, density };

  Kind kind = Kind::probability;
  std::vector<double> amplitude, weight;

  double mean() const;
  /// E[(Y - E[Y])^2].
  double variance() const;
  /// Of -Y.
  AmplitudeTable mirrored() const;
};

inline constexpr std::size_t kMostTableRows = 1000;
/// By how much the sum of a table may differ from 1; it is divided by it.
inline constexpr double kTableTolerance = 1e-3;

/// Of a CSV with the columns amplitude,probability or amplitude,density.
/// @param where how messages name the file
/// @throws InputError WHERE:LINE: on one line what is wrong there, and what is allowed
AmplitudeTable amplitude_table_of_csv(std::string_view csv, const std::string& where);

/// As one word of a case file, "probability(-1:0.25,3:0.75)", that says all of it.
std::string text_of(const AmplitudeTable& table);
/// Whether it begins as such a word does.
bool is_amplitude_table(std::string_view text);
/// @throws InputError impulse.table = ..
AmplitudeTable amplitude_table_of_text(std::string_view text);

/// "37 probabilities from -1 to 3": for people.
std::string summary_of(std::string_view table_text);

}  // namespace fpkcheck::problem
