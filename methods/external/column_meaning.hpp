#pragma once

#include <string_view>

#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// What the third column of a histogram holds.
enum class BinValue { density, probability, count };

/// Its name in summaries: "density", "probability", "count".
std::string_view name(BinValue value);

/// The variable that the names of the columns say; else y' where abscissae are negative.
transform::Variable variable_of(const NumberTable& table);

/// Of names that are those of y, of y' and of a density p of both, the first two in either order:
/// the place of that of y'; otherwise their number.
std::size_t velocity_column(const std::vector<std::string>& names);

/// Whether three columns are lower edge, upper edge and value: by their names, or because each bin
/// begins at the edge (or so near to it that rounding must have moved it) where another ended.
bool is_histogram(const NumberTable& table);

/// Whether a bin begins where the one before it ended, to rounding of the last digits.
bool join(const std::vector<double>& bin, const std::vector<double>& next);

/// What a histogram holds, by the name of its values; else a density where it has mass 1,
/// probabilities where they have the sum 1, counts where all are whole, otherwise a density.
BinValue bin_value(const NumberTable& histogram);

}  // namespace fpkcheck::methods
