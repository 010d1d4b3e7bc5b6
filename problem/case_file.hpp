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

/// How to name a case that has overrides.
enum class CaseNaming {
  /// By the file alone, for callers that state or vary the overrides themselves (sweeps).
  from_file,
  with_overrides,  ///< "case1, r = 0.9": the file and the symbols of changed parameters
};

/// Loads a case by its name ("case1" .. "case4") or by the path of an ini file.
/// @param overrides "key=value" pairs that replace settings of the file, e.g. "system.cubic=1.0"
/// @throws InputError with a one-line message: the key, the value, the file and what is allowed; also for a
/// file whose name, which becomes the name of the case, cannot be printed
Problem load_case(const std::string& name_or_path, const std::vector<std::string>& overrides = {},
                  CaseNaming naming = CaseNaming::from_file);

/// As load_case, from a stream.
/// @param source name of the stream in messages
Problem read_case(std::istream& ini, const std::string& name, std::string_view source,
                  const std::vector<std::string>& overrides = {},
                  CaseNaming naming = CaseNaming::from_file);

/// As load_case, from settings that were read already.
/// @param where start of messages that concern no line: "case mine.ini"
/// @param folder directory of files that a setting names; overrides name files relative to the
/// working directory
Problem case_from_settings(const std::vector<base::IniSetting>& lines, const std::string& name,
                           const std::string& where, const std::vector<std::string>& overrides = {},
                           CaseNaming naming = CaseNaming::from_file,
                           const std::filesystem::path& folder = {});

/// The parameter that a key of a case file sets, e.g. "system.damping".
/// @param where start of the message
/// @throws InputError "WHERE: unknown key", with the known keys
const base::Parameter& case_parameter(std::string_view key, const std::string& where);

}  // namespace fpkcheck::problem
