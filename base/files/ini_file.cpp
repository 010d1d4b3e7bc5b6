#include "base/files/ini_file.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/trim.hpp>
#include <istream>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::base {
namespace {

std::string without_comment(std::string line, int line_number) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line_number == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  return boost::algorithm::trim_copy(line.substr(0, line.find_first_of("#;")));
}

}  // namespace

std::vector<IniSetting> read_ini_settings(std::istream& ini, const std::string& where) {
  std::vector<IniSetting> settings;
  std::string section;
  int line_number = 0;
  for (std::string line; std::getline(ini, line);) {
    ++line_number;
    const std::string content = without_comment(line, line_number);
    if (content.empty()) continue;
    const std::string location = fmt::format("{}:{}", where, line_number);
    if (content.front() == '[' && content.back() == ']') {
      section = boost::algorithm::trim_copy(content.substr(1, content.size() - 2));
      continue;
    }
    const auto equals = content.find('=');
    if (equals == std::string::npos) {
      throw InputError(fmt::format("{}: {} is not a setting; write [section] or key = value",
                                   location, in_quotes(content)));
    }
    settings.push_back({section, boost::algorithm::trim_copy(content.substr(0, equals)),
                        boost::algorithm::trim_copy(content.substr(equals + 1)), location});
  }
  return settings;
}

}  // namespace fpkcheck::base
