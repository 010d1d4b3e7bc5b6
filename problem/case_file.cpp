#include "problem/case_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <boost/locale/utf.hpp>
#include <boost/program_options.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "parameters/input_error.hpp"
#include "problem/named_cases.hpp"

namespace fpkcheck::problem {
namespace {

namespace po = boost::program_options;

// "system.damping", ..
std::vector<std::string> known_keys() {
  std::vector<std::string> keys;
  const auto add = [&](const parameters::Descriptions& section) {
    for (const auto& parameter : section.all()) keys.push_back(section.prefix() + parameter.name);
  };
  add(system_description());
  add(impulse_description());
  return keys;
}

void require_known(const std::string& key, const std::string& where) {
  const auto keys = known_keys();
  if (std::ranges::find(keys, key) == keys.end()) {
    throw InputError(
        fmt::format("{}: unknown key '{}' (known keys: {})", where, key, fmt::join(keys, ", ")));
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

using Texts = std::map<std::string, std::string>;  // of keys

Texts parse_file(std::istream& ini, const std::string& where) {
  po::options_description keys;
  for (const auto& key : known_keys()) keys.add_options()(key.c_str(), po::value<std::string>());
  std::istringstream text(without_semicolon_comments(ini));
  Texts values;
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

void apply(const std::vector<std::string>& overrides, Texts& values) {
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

// The section's part of a case file, from the texts of its keys.
template <class Owner>
Owner section(const parameters::Description<Owner>& description, const Texts& texts) {
  Owner owner{};
  for (const auto& parameter : description.all()) {
    const std::string key = description.prefix() + parameter.name;
    const auto found = texts.find(key);
    if (found != texts.end()) {
      description.parse(owner, parameter, found->second, key + " =");
    } else if (parameter.fallback) {
      description.assign(owner, parameter, *parameter.fallback, key + " =");
    } else {
      throw InputError(
          fmt::format("key '{}' is missing (add it, or give --set {}=VALUE)", key, key));
    }
  }
  return owner;
}

bool is_utf8(const std::string& text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  for (auto at = text.begin(); at != text.end();) {
    if (!boost::locale::utf::is_valid_codepoint(Utf8::decode(at, text.end()))) return false;
  }
  return true;
}

// A case's name goes into tables, file names, JSON, netCDF names and pictures.
void require_presentable(const std::string& name) {
  constexpr std::size_t kLongest = 100;
  const bool plain =
      std::ranges::none_of(name, [](unsigned char c) { return std::iscntrl(c) != 0; });
  const bool utf8 = is_utf8(name);
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
  Texts texts = parse_file(ini, where);
  apply(overrides, texts);
  try {
    return {name, System(section(system_description(), texts)),
            ImpulseTrain(section(impulse_description(), texts))};
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
