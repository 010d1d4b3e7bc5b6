#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace fpkcheck::base {

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
