#pragma once

#include <filesystem>
#include <string>

namespace fpkcheck::problem {

/// What `impulse.table` of a case file says, as the word that holds the whole table
/// (problem/amplitude_table.hpp): so that a problem needs no file once it was read. Such a word
/// stays as it is; all else is the name of a CSV file.
/// @param folder which relative names start from; the working directory where it is empty
/// @throws InputError on one line: the file cannot be read, is too large, or WHERE it is wrong
std::string table_setting(const std::string& said, const std::filesystem::path& folder);

}  // namespace fpkcheck::problem
