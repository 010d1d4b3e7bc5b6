#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/input_file.hpp"
#include "base/options/parameter_value.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Rule that composes the name of a case with overrides.
enum class CaseNamingRule {
  /// The name of the case is the name of the case file. Sweeps use the rule `from_file`, since
  /// sweeps display the overridden parameters separately.
  from_file,
  with_overrides,  ///< name of the case file and changed parameters: "case1, r = 0.9"
};

/// Loads a case by its name ("case1" .. "case4") or by the path of an ini file.
/// @param overrides "key=value" pairs that replace settings of the file, e.g. "system.cubic=1.0"
/// @param time_section whether the case may contain the section [time]
/// @throws InputError with a one-line message that states the key, the value, the file and the
/// allowed values. A file name with unprintable characters is an error, since the file name becomes
/// the name of the case.
Problem load_case(const std::string& name_or_path, const std::vector<std::string>& overrides = {},
                  CaseNamingRule naming = CaseNamingRule::from_file,
                  CaseFileTimeSectionPolicy time_section = CaseFileTimeSectionPolicy::refused);

/// Reads a case from a stream with the contents of an ini file, by the rules of load_case().
/// @param source file name of the stream in messages; relative file names in the case refer to the
/// folder of `source`
Problem read_case(std::istream& ini, const std::string& name, std::string_view source,
                  const std::vector<std::string>& overrides = {},
                  CaseNamingRule naming = CaseNamingRule::from_file,
                  CaseFileTimeSectionPolicy time_section = CaseFileTimeSectionPolicy::refused);

/// Builds the problem of a case from the settings of an ini file by the rules of load_case().
/// @param message_prefix beginning of error messages without a line number, such as "case mine.ini"
/// @param folder directory to which file names in settings refer; file names in overrides refer to
/// the working directory
Problem problem_from_settings(
    const std::vector<base::IniSetting>& file_settings, const std::string& name,
    const std::string& message_prefix, const std::vector<std::string>& overrides = {},
    CaseNamingRule naming = CaseNamingRule::from_file, const std::filesystem::path& folder = {},
    CaseFileTimeSectionPolicy time_section = CaseFileTimeSectionPolicy::refused);

/// Returns the parameter that a key of a case file sets, e.g. "system.damping".
/// @param message_prefix beginning of the error message
/// @throws InputError "MESSAGE_PREFIX: unknown key .." with a list of the known keys
const base::Parameter& case_file_parameter(std::string_view key, const std::string& message_prefix);

struct BuiltInCase {
  std::string name;
  std::string text;  ///< the contents of cases/NAME.ini
};

/// Returns the four cases of Table 1 of the paper, in the order of Table 1.
const std::vector<BuiltInCase>& paper_cases();

/// Returns the example oscillators, each the simplest oscillator of its type in docs/systems.md.
const std::vector<BuiltInCase>& example_oscillator_cases();

/// Returns the case of the paper or the example with the given name; null for an unknown name.
const BuiltInCase* find_built_in_case(std::string_view name);

}  // namespace fpkcheck::problem
