#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace fpkcheck::base {

/// A line `key = value` of an ini file, with the `[section]` that contains it.
struct IniSetting {
  std::string section;  ///< empty before the first section
  std::string key, text;
  std::string where;  ///< location for messages: "case mine.ini:7"

  /// "system.damping"
  std::string path() const { return section.empty() ? key : section + '.' + key; }
};

/// Reads the settings of an ini file in their order. Comments begin with '#' or ';'. A byte-order
/// mark at the beginning is skipped.
/// @param where name of the file in messages
/// @throws InputError "WHERE:LINE: .." for a line that is neither a section nor a setting
std::vector<IniSetting> ini_settings(std::istream& ini, const std::string& where);

}  // namespace fpkcheck::base
