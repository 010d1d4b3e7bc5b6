#include "problem/case_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <boost/program_options.hpp>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "problem/input_error.hpp"
#include "problem/named_cases.hpp"

namespace fpkcheck::problem {
namespace {

namespace po = boost::program_options;

const std::vector<std::string> kKeys{"system.damping",     "system.stiffness", "system.cubic",
                                     "system.restitution", "impulse.rate",     "impulse.law",
                                     "impulse.intensity",  "impulse.mean"};
// The only key with a default: the paper's impulses have zero mean.
constexpr const char* kDefaultMean = "0";

void require_known(const std::string& key, const std::string& where) {
  if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
    throw InputError(
        fmt::format("{}: unknown key '{}' (known keys: {})", where, key, fmt::join(kKeys, ", ")));
  }
}

// Boost.Program_options knows '#' comments; ini files also use ';', and may begin with a byte-order
// mark.
std::string without_semicolon_comments(std::istream& ini) {
  std::string text;
  for (std::string line; std::getline(ini, line);) {
    text += line.substr(0, line.find(';')) + '\n';
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

using Values = std::map<std::string, std::string>;

Values parse_file(std::istream& ini, const std::string& where) {
  po::options_description keys;
  for (const auto& key : kKeys) keys.add_options()(key.c_str(), po::value<std::string>());
  std::istringstream text(without_semicolon_comments(ini));
  Values values;
  try {
    const auto parsed = po::parse_config_file(text, keys, /*allow_unregistered=*/true);
    for (const auto& option : parsed.options) {
      require_known(option.string_key, where);
      const std::string value = option.value.empty() ? "" : option.value.front();
      if (!values.emplace(option.string_key, value).second) {
        throw InputError(
            fmt::format("{}: key '{}' is given twice (keep one)", where, option.string_key));
      }
    }
  } catch (const po::error& error) {
    throw InputError(fmt::format("{}: {} (a case file has [sections] and key = value lines)", where,
                                 error.what()));
  }
  return values;
}

void apply(const std::vector<std::string>& overrides, Values& values) {
  for (const auto& pair : overrides) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos) {
      throw InputError(
          fmt::format("--set {} (not key=value; write e.g. --set system.cubic=1.0)", pair));
    }
    const std::string key = pair.substr(0, equals);
    require_known(key, "--set");
    values[key] = boost::algorithm::trim_copy(pair.substr(equals + 1));
  }
}

double number(const Values& values, const std::string& key) {
  const std::string& text = values.at(key);
  double value = 0;
  const char* const end = text.data() + text.size();
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range) {
    throw InputError(fmt::format("{} = '{}' (out of the range of double precision)", key, text));
  }
  if (error != std::errc{} || stop != end) {
    throw InputError(fmt::format("{} = '{}' (not a number)", key, text));
  }
  return value;
}

// A case's name goes into tables, file names, JSON, netCDF names and pictures.
void require_presentable(const std::string& name) {
  constexpr std::size_t kLongest = 100;
  const bool plain =
      std::ranges::none_of(name, [](unsigned char c) { return std::iscntrl(c) != 0; });
  bool utf8 = true;
  try {
    std::ignore = nlohmann::json(name).dump();
  } catch (const nlohmann::json::exception&) {
    utf8 = false;
  }
  if (plain && utf8 && !name.empty() && name.size() <= kLongest) return;
  throw InputError(fmt::format(
      "the case's name, that of its file, {} (rename the file: 1 .. {} bytes of UTF-8 without "
      "control characters)",
      !utf8    ? "is not UTF-8"
      : !plain ? "holds control characters"
               : fmt::format("has {} bytes", name.size()),
      kLongest));
}

}  // namespace

Problem read_case(std::istream& ini, const std::string& name, std::string_view source,
                  const std::vector<std::string>& overrides) {
  const std::string where = fmt::format("case {}", source);
  Values values = parse_file(ini, where);
  apply(overrides, values);
  values.emplace("impulse.mean", kDefaultMean);
  for (const auto& key : kKeys) {
    if (!values.contains(key)) {
      throw InputError(
          fmt::format("{}: key '{}' is missing (add it, or give --set {}=VALUE)", where, key, key));
    }
  }
  try {
    return {name,
            System({.damping = number(values, "system.damping"),
                    .stiffness = number(values, "system.stiffness"),
                    .cubic = number(values, "system.cubic"),
                    .restitution = number(values, "system.restitution")}),
            ImpulseTrain({.arrival_rate = number(values, "impulse.rate"),
                          .law = values.at("impulse.law"),
                          .intensity = number(values, "impulse.intensity"),
                          .mean = number(values, "impulse.mean")})};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", where, error.what()));
  }
}

Problem load_case(const std::string& name_or_path, const std::vector<std::string>& overrides) {
  std::vector<std::string> names;
  for (const auto& [name, text] : named_cases()) {
    if (name == name_or_path) {
      std::istringstream ini(text);
      return read_case(ini, name, name, overrides);
    }
    names.push_back(name);
  }
  std::error_code ignored;
  std::ifstream ini;
  if (std::filesystem::is_regular_file(name_or_path, ignored)) ini.open(name_or_path);
  if (!ini.is_open()) {
    throw InputError(fmt::format("no case '{}' (neither a readable file nor one of {})",
                                 name_or_path, fmt::join(names, ", ")));
  }
  const std::string name = std::filesystem::path(name_or_path).stem().string();
  require_presentable(name);
  return read_case(ini, name, name_or_path, overrides);
}

}  // namespace fpkcheck::problem
