#include "base/files/ini_file.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/trim.hpp>
#include <istream>

#include "base/input_error.hpp"
#include "base/text/shown.hpp"

namespace fpkcheck::base {
namespace {

std::string without_comment(std::string line, int line_number) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line_number == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  return boost::algorithm::trim_copy(line.substr(0, line.find_first_of("#;")));
}

}  // namespace

std::vector<IniSetting> ini_settings(std::istream& ini, const std::string& where) {
  std::vector<IniSetting> settings;
  std::string section;
  int line_number = 0;
  for (std::string line; std::getline(ini, line);) {
    ++line_number;
    const std::string said = without_comment(line, line_number);
    if (said.empty()) continue;
    const std::string at = fmt::format("{}:{}", where, line_number);
    if (said.front() == '[' && said.back() == ']') {
      section = boost::algorithm::trim_copy(said.substr(1, said.size() - 2));
      continue;
    }
    const auto equals = said.find('=');
    if (equals == std::string::npos) {
      throw InputError(fmt::format("{}: {} is not a setting; write [section] or key = value", at,
                                   in_quotes(said)));
    }
    settings.push_back({section, boost::algorithm::trim_copy(said.substr(0, equals)),
                        boost::algorithm::trim_copy(said.substr(equals + 1)), at});
  }
  return settings;
}

}  // namespace fpkcheck::base
