#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/ini_file.hpp"
#include "base/options/parameter.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// What a case is called of which overrides change something.
enum class Naming {
  of_file,     ///< as the file: for who says elsewhere what was changed, or varies it (sweeps)
  of_changes,  ///< "case1, r = 0.9": by the symbols of what is not as the file has it
};

/// Reads a case: a name ("case1" .. "case4") or the path of an ini file.
/// @param overrides "key=value" pairs that replace what the file says, e.g. "system.cubic=1.0"
/// @throws InputError on one line: the key, the value, the file and what is allowed; also for a
/// file whose name, which becomes the case's, cannot be shown
Problem load_case(const std::string& name_or_path, const std::vector<std::string>& overrides = {},
                  Naming naming = Naming::of_file);

/// As load_case, from a stream.
/// @param source how messages name the stream
Problem read_case(std::istream& ini, const std::string& name, std::string_view source,
                  const std::vector<std::string>& overrides = {}, Naming naming = Naming::of_file);

/// As load_case, from lines that were read already.
/// @param where how messages name what is set by no line: "case mine.ini"
/// @param folder where files that a line names are; those of overrides are in the working directory
Problem case_from(const std::vector<base::IniSetting>& lines, const std::string& name,
                  const std::string& where, const std::vector<std::string>& overrides = {},
                  Naming naming = Naming::of_file, const std::filesystem::path& folder = {});

/// What the key of a case file, "system.damping", sets.
/// @param where how the message begins
/// @throws InputError WHERE: unknown key, with those that are known
const base::Parameter& case_parameter(std::string_view key, const std::string& where);

}  // namespace fpkcheck::problem
