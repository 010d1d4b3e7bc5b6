#pragma once

#include <filesystem>
#include <string>

namespace fpkcheck::problem {

/// Converts the value of `impulse.table` in a case file to the word that contains the whole table
/// (problem/amplitude_table.hpp), so that a problem needs no file once it is read. Such a word is
/// returned unchanged; any other value is the name of a CSV file.
/// @param folder directory of relative names; the working directory where it is empty
/// @throws InputError with a one-line message when the file cannot be read, is too large or has an invalid line
std::string resolve_table_setting(const std::string& setting, const std::filesystem::path& folder);

}  // namespace fpkcheck::problem
