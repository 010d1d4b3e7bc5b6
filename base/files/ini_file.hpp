#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace fpkcheck::base {

/// A line `key = value` of an ini file, below its `[section]`.
struct IniSetting {
  std::string section;  ///< empty before the first
  std::string key, text;
  std::string where;  ///< for messages: "case mine.ini:7"

  /// "system.damping"
  std::string path() const { return section.empty() ? key : section + '.' + key; }
};

/// The settings of an ini file in their order. Comments begin with '#' or ';', and a byte-order mark
/// may stand before the first line.
/// @param where how messages name the file
/// @throws InputError WHERE:LINE: what is neither a section nor a setting
std::vector<IniSetting> ini_settings(std::istream& ini, const std::string& where);

}  // namespace fpkcheck::base
