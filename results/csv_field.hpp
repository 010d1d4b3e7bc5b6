#pragma once

#include <string>

namespace fpkcheck::results {

/// A text as a field of a CSV file, quoted where it contains separators, quotes or line breaks
/// (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace fpkcheck::results
