#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/input_file.hpp"
#include "base/options/parameter.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Rule for the name of a case that has overrides.
enum class CaseNaming {
  /// The name is that of the file, for callers that state or vary the overrides themselves
  /// (sweeps).
  from_file,
  with_overrides,  ///< name of the file and changed parameters: "case1, r = 0.9"
};

/// Loads a case by its name ("case1" .. "case4") or by the path of an ini file.
/// @param overrides "key=value" pairs that replace settings of the file, e.g. "system.cubic=1.0"
/// @throws InputError with a one-line message that states the key, the value, the file and the
/// allowed values; also if the name of the file, which becomes the name of the case, cannot be
/// printed
Problem load_case(const std::string& name_or_path, const std::vector<std::string>& overrides = {},
                  CaseNaming naming = CaseNaming::from_file);

/// Reads a case as load_case() does, but from a stream.
/// @param source name of the stream in messages
Problem read_case(std::istream& ini, const std::string& name, std::string_view source,
                  const std::vector<std::string>& overrides = {},
                  CaseNaming naming = CaseNaming::from_file);

/// Builds the problem of a case as load_case() does, but from settings that were already read.
/// @param where beginning of those messages that refer to no line: "case mine.ini"
/// @param folder directory to which file names in settings refer; file names in overrides refer to
/// the working directory
Problem case_from_settings(const std::vector<base::IniSetting>& lines, const std::string& name,
                           const std::string& where, const std::vector<std::string>& overrides = {},
                           CaseNaming naming = CaseNaming::from_file,
                           const std::filesystem::path& folder = {});

/// The parameter that a key of a case file sets, e.g. "system.damping".
/// @param where beginning of the error message
/// @throws InputError "WHERE: unknown key .." with a list of the known keys
const base::Parameter& case_parameter(std::string_view key, const std::string& where);

/// A case file that is compiled into the program.
struct BuiltInCase {
  std::string name;
  std::string text;  ///< the contents of cases/NAME.ini
};

/// The four cases of Table 1 of the paper, in the order of the table.
const std::vector<BuiltInCase>& paper_cases();

/// Example oscillators. Each example is the simplest oscillator of its type in docs/systems.md.
const std::vector<BuiltInCase>& example_systems();

/// The case with this name that is compiled into the program; null if there is none.
const BuiltInCase* find_built_in_case(std::string_view name);

}  // namespace fpkcheck::problem
