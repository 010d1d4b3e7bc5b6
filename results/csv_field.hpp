#pragma once

#include <string>

namespace fpkcheck::results {

/// A text as a field of a CSV file: between quotes where it holds what parts fields or lines
/// (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace fpkcheck::results
