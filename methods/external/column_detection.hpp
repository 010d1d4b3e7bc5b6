#pragma once

#include <string_view>

#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// The quantity in the third column of a histogram.
enum class HistogramQuantity { density, probability, count };

std::string_view name(HistogramQuantity value);

/// Returns the variable (y or y') of a marginal density by the names of the columns. If the names
/// are unknown, the variable is y' if an abscissa is negative, otherwise y.
transform::StateVariable variable_from_column_names(const NumberTable& table);

/// Returns the index of the column of y' if the column names are y, y', p or y', y, p (a joint
/// density). For all other names the result is the number of names.
std::size_t velocity_column_index(const std::vector<std::string>& names);

/// Returns whether the columns are a histogram: lower edge, upper edge and value of each bin. A
/// table without column names is a histogram if each bin begins near the end of the previous bin.
bool is_histogram(const NumberTable& table);

/// Returns whether the bin `next` begins at the end of `bin`, within rounding errors.
bool are_bins_adjacent(const std::vector<double>& bin, const std::vector<double>& next);

/// Returns the quantity of a histogram by the name of the third column. If the name is unknown, the
/// values determine the quantity: densities have the integral 1, probabilities have the sum 1, and
/// counts are integers. All other values are densities.
HistogramQuantity detect_histogram_quantity(const NumberTable& histogram);

}  // namespace fpkcheck::methods
