#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace fpkcheck::base {

/// Reads the contents of an input file; returns nullopt if the file is not a readable regular file.
/// Pipes and devices are refused, since reading a pipe or a device could block forever.
/// @throws InputError with a one-line message if the file has more than `max_bytes` bytes
std::optional<std::string> read_input_file(const std::filesystem::path& file,
                                           std::size_t max_bytes);

/// A setting `key = value` of an ini file, with the name of its `[section]`.
struct IniSetting {
  std::string section;  ///< name of the section; empty for a line before the first section
  std::string key, text;
  std::string where;  ///< file and line of the setting, for messages: "case mine.ini:7"

  /// Returns the name of the section and the key joined by a dot, such as "system.damping".
  std::string ini_section_and_key() const { return section.empty() ? key : section + '.' + key; }
};

/// Reads all settings of an ini file, in which text after '#' or ';' is a comment, in order.
/// @param where name of the ini file in error messages
/// @throws InputError "WHERE:LINE: .." for a line that is neither a `[section]` nor a setting `key
/// = value`
std::vector<IniSetting> read_ini_settings(std::istream& ini, const std::string& where);

}  // namespace fpkcheck::base
