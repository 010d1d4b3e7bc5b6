#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace fpkcheck::base {

/// Reads a file that a user named. Returns nothing if the file is not a readable regular file:
/// reading a pipe or a device could block the program or never end.
/// @param max_bytes largest accepted number of bytes
/// @throws InputError with a one-line message if the file has more than `max_bytes` bytes
std::optional<std::string> read_input_file(const std::filesystem::path& file,
                                           std::size_t max_bytes);

/// A line `key = value` of an ini file, together with the name of the `[section]` that contains the
/// line.
struct IniSetting {
  std::string section;  ///< name of the section; empty for a line before the first section
  std::string key, text;
  std::string where;  ///< location of the line, for messages: "case mine.ini:7"

  /// Section and key, joined by a dot: "system.damping".
  std::string path() const { return section.empty() ? key : section + '.' + key; }
};

/// Reads all settings of an ini file, in the order of their lines. Comments begin with '#' or ';'.
/// A byte-order mark at the beginning of the file is skipped.
/// @param where name of the file in messages
/// @throws InputError "WHERE:LINE: .." for a line that is neither a `[section]` nor a setting `key
/// = value`
std::vector<IniSetting> read_ini_settings(std::istream& ini, const std::string& where);

}  // namespace fpkcheck::base
