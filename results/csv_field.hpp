#pragma once

#include <string>

namespace fpkcheck::results {

/// The field of a CSV file for a text. A text with separators, quotes or line breaks is quoted
/// (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace fpkcheck::results
