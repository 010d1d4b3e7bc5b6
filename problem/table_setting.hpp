#pragma once

#include <filesystem>
#include <string>

namespace fpkcheck::problem {

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
