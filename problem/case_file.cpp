#include "problem/case_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/trim.hpp>
#include <boost/locale/utf.hpp>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "problem/amplitude_table.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::problem {

using base::in_quotes;
using base::to_printable_text;

namespace {
constexpr std::string_view kConstantsPrefix = "parameters.";
constexpr const char *kForceKey = "system.force", *kRestitution = "system.restitution";
constexpr std::array kFormulas{kForceKey,
                               "noise.factor",
                               "impulse.factor",
                               "wall.left_restitution",
                               "wall.right_restitution",
                               "time.rate",
                               "time.intensity",
                               "time.force"};
}  // namespace

const base::Parameter& case_file_parameter(std::string_view key,
                                           const std::string& message_prefix) {
  if (key.starts_with(kConstantsPrefix)) {
    try {
      return named_constant_parameter(key.substr(kConstantsPrefix.size()));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", message_prefix, error.what()));
    }
  }
  std::vector<std::string> known;  // known keys, grouped by section: "wall.{left, right}"
  std::string known_in_section;    // known keys of the section that `key` names
  for (const base::OptionsDescriptionBase* section : case_section_descriptions()) {
    std::vector<std::string_view> names;
    for (const auto& parameter : section->parameters()) {
      if (section->prefix() + parameter.name == key) return parameter;
      names.emplace_back(parameter.name);
    }
    known.push_back(fmt::format("{}{{{}}}", section->prefix(), fmt::join(names, ", ")));
    if (key.starts_with(section->prefix())) known_in_section = known.back();
  }
  if (key.starts_with("param")) {
    throw InputError(fmt::format("{}: unknown key {}; write {}NAME for a named constant",
                                 message_prefix, in_quotes(key), kConstantsPrefix));
  }
  if (const std::string text = unsupported_feature_message(key); !text.empty()) {
    throw InputError(fmt::format("{}: key {}: {}", message_prefix, in_quotes(key), text));
  }
  if (!known_in_section.empty()) {
    throw InputError(fmt::format("{}: unknown key {}; known keys: {}; see docs/not_treated.md",
                                 message_prefix, in_quotes(key), known_in_section));
  }
  throw InputError(fmt::format("{}: unknown key {}; known keys: {}", message_prefix, in_quotes(key),
                               fmt::join(known, ", ")));
}

namespace {

// The text of a value, and the location of the value in the case file or in an override.
struct CaseFileSetting {
  std::string text, where;
};
using CaseFileSettings = std::map<std::string, CaseFileSetting>;  // settings by key

CaseFileSettings settings_by_key(const std::vector<base::IniSetting>& file_settings) {
  CaseFileSettings settings;
  for (const auto& line : file_settings) {
    case_file_parameter(line.ini_section_and_key(), line.where);
    if (!settings.emplace(line.ini_section_and_key(), CaseFileSetting{line.text, line.where})
             .second) {
      throw InputError(fmt::format("{}: key '{}' is given twice; keep one", line.where,
                                   line.ini_section_and_key()));
    }
  }
  return settings;
}

void apply_overrides(const std::vector<std::string>& overrides, const std::string& where,
                     CaseFileSettings& settings) {
  std::set<std::string> set;
  for (const auto& pair : overrides) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos) {
      throw InputError(fmt::format("--set {}: not key=value; write e.g. --set system.cubic=1.0",
                                   to_printable_text(pair)));
    }
    const std::string key = boost::algorithm::trim_copy(pair.substr(0, equals));
    case_file_parameter(key, "--set");
    if (!set.insert(key).second) {
      throw InputError(fmt::format("--set {} is given twice; keep one", key));
    }
    settings[key] = {boost::algorithm::trim_copy(pair.substr(equals + 1)), where};
  }
  // A force formula replaces the force coefficients of the case file.
  if (set.contains(kForceKey)) {
    std::erase_if(settings, [&](const auto& setting) {
      const std::string& key = setting.first;
      return key.starts_with("system.") && key != kRestitution && !set.contains(key);
    });
  }
}

bool formula_uses_name(std::string_view formula, std::string_view name) {
  const auto is_word = [&](std::size_t at) {
    return at < formula.size() &&
           (std::isalnum(static_cast<unsigned char>(formula[at])) != 0 || formula[at] == '_');
  };
  for (auto at = formula.find(name); at != formula.npos; at = formula.find(name, at + 1)) {
    if (!(at > 0 && is_word(at - 1)) && !is_word(at + name.size())) return true;
  }
  return false;
}

// Requires that a formula uses each constant that an override adds, since otherwise an override
// with a misspelt constant name would have no effect.
void require_used_constants(const CaseFileSettings& from_file, const CaseFileSettings& settings) {
  for (const auto& [key, setting] : settings) {
    if (!key.starts_with(kConstantsPrefix) || from_file.contains(key)) continue;
    const std::string name = key.substr(kConstantsPrefix.size());
    const bool is_used = std::ranges::any_of(kFormulas, [&](const char* formula) {
      const auto found = settings.find(formula);
      return found != settings.end() && formula_uses_name(found->second.text, name);
    });
    if (!is_used) {
      throw InputError(
          fmt::format("--set {}: no formula of the case uses {}; correct the name", key, name));
    }
  }
}

constexpr const char *kLaw = "impulse.law", *kTable = "impulse.table", *kMean = "impulse.mean",
                     *kIntensity = "impulse.intensity", *kRate = "impulse.rate";

// Replaces the file name in `impulse.table` by the table literal of the contents of the file.
void load_amplitude_table(CaseFileSettings& settings, const std::filesystem::path& folder) {
  const auto table = settings.find(kTable);
  if (table == settings.end()) return;
  try {
    table->second.text = table_literal_from_setting(table->second.text, folder);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", table->second.where, error.what()));
  }
}

// Adds impulse.mean and impulse.intensity, computed from the amplitude table, to settings without
// these keys.
void add_moments_of_table(CaseFileSettings& settings) {
  const auto number = [&](const char* key) -> std::optional<double> {
    const auto found = settings.find(key);
    if (found == settings.end()) return std::nullopt;
    const auto value = case_file_parameter(key, key).parse(found->second.text);
    const auto* as_number = value ? std::get_if<double>(&*value) : nullptr;
    return as_number != nullptr ? std::optional(*as_number) : std::nullopt;
  };
  const auto law = settings.find(kLaw), literal = settings.find(kTable);
  if (law == settings.end() || literal == settings.end() ||
      law->second.text != TabulatedLaw::kName) {
    return;
  }
  const AmplitudeTable table = parse_amplitude_table_literal(literal->second.text);
  const std::string where = literal->second.where;
  if (!settings.contains(kMean))
    settings[kMean] = {fmt::format("{}", table.amplitude_mean()), where};
  const auto rate = number(kRate), mean = number(kMean);
  if (settings.contains(kIntensity) || !rate || !mean) return;
  settings[kIntensity] = {fmt::format("{}", *rate * (table.amplitude_variance() + *mean * *mean)),
                          where};
}

// Parses the settings of one section; returns nullopt if an optional section has no settings.
std::optional<CaseFileSection> parse_section(const base::OptionsDescriptionBase& description,
                                             const CaseFileSettings& settings) {
  const std::string& prefix = description.prefix();
  const bool named = std::ranges::any_of(
      settings, [&](const auto& setting) { return setting.first.starts_with(prefix); });
  if (!named && &description != &system_parameter_description()) return std::nullopt;
  CaseFileSection section{prefix.substr(0, prefix.size() - 1), {}};
  const bool has_formula =
      &description == &system_parameter_description() && settings.contains(kForceKey);
  for (const auto& parameter : description.parameters()) {
    const std::string key = prefix + parameter.name;
    const auto found = settings.find(key);
    if (found != settings.end()) {
      if (key == kRestitution && !parameter.parse(found->second.text)) {
        throw InputError(fmt::format(
            "{} = {} is not a number; give a formula as wall.left_restitution, with wall.left = 0",
            key, in_quotes(found->second.text)));
      }
      section.values.push_back(
          {parameter.name, base::parse_value(parameter, found->second.text, key + " =")});
    } else if (!parameter.default_value && !has_formula) {
      throw InputError(
          fmt::format("key '{}' is missing; add it, or give --set {}=VALUE", key, key));
    }
  }
  return section;
}

// Parses the settings of [parameters]; returns nullopt without such settings.
std::optional<CaseFileSection> parse_named_constants(const CaseFileSettings& settings) {
  CaseFileSection section{std::string(kConstantsPrefix.substr(0, kConstantsPrefix.size() - 1)), {}};
  for (const auto& [key, setting] : settings) {
    if (!key.starts_with(kConstantsPrefix)) continue;
    section.values.push_back(
        {key.substr(kConstantsPrefix.size()),
         base::parse_value(case_file_parameter(key, key), setting.text, key + " =")});
  }
  if (section.values.empty()) return std::nullopt;
  return section;
}

// Returns the location of the setting whose key is the first word of an error message.
std::optional<std::string> setting_location(const std::string& message,
                                            const CaseFileSettings& settings) {
  for (const auto& [key, setting] : settings) {
    if (message.starts_with(key + ' ')) return setting.where;
  }
  return std::nullopt;
}

bool is_utf8(const std::string& text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  for (auto at = text.begin(); at != text.end();) {
    if (!boost::locale::utf::is_valid_codepoint(Utf8::decode(at, text.end()))) return false;
  }
  return true;
}

// Requires that the name of a case is printable, since the name appears in tables, file names,
// JSON, netCDF names and figures.
void require_valid_case_name(const std::string& name) {
  constexpr std::size_t kLongest = 100;
  const bool plain =
      std::ranges::none_of(name, [](unsigned char c) { return std::iscntrl(c) != 0; });
  const bool utf8 = is_utf8(name);
  if (plain && utf8 && !name.empty() && name.size() <= kLongest) return;
  throw InputError(fmt::format(
      "the name of the case, taken from its file, {}; rename the file (1 .. {} bytes of UTF-8 "
      "without control characters)",
      !utf8    ? "is not UTF-8"
      : !plain ? "contains control characters"
               : fmt::format("has {} bytes", name.size()),
      kLongest));
}

// Returns the text of the parameters that overrides change, such as ", r = 0.9, laplace impulses".
// The text of the overridden parameters is appended to Problem::name.
std::string overridden_parameters_text(const CaseFileSettings& from_file, const Problem& problem) {
  constexpr std::size_t kLongest = 100;
  std::string text;
  int count = 0;
  for (const auto& displayed : parameters_for_reports(problem)) {
    const std::string key = displayed.section + '.' + displayed.name;
    const auto& parameter = case_file_parameter(key, key);
    const auto before = from_file.find(key);
    auto value =
        before == from_file.end() ? parameter.default_value : parameter.parse(before->second.text);
    if (value) value = reported_parameter_value(parameter, *value);
    if (value == displayed.value) continue;
    ++count;
    // The numbers in a case name have all digits, so that different problems have different names.
    if (const auto* number = std::get_if<double>(&displayed.value)) {
      text += fmt::format(", {} = {}", displayed.symbol, *number);
    } else if (parameter.display_text) {
      text += fmt::format(", another {}", displayed.symbol);
    } else if (const auto* word = std::get_if<std::string>(&displayed.value)) {
      text += displayed.symbol.empty() ? fmt::format(", {} impulses", *word)
                                       : fmt::format(", {} = {}", displayed.symbol, *word);
    } else {
      text += std::holds_alternative<bool>(displayed.value)
                  ? std::string(", no wall")
                  : fmt::format(", without {}", displayed.symbol);
    }
  }
  return text.size() <= kLongest ? text : fmt::format(", {} keys changed", count);
}

}  // namespace

Problem read_case(std::istream& ini, const std::string& name, std::string_view source,
                  const std::vector<std::string>& overrides, CaseNamingRule naming,
                  CaseFileTimeSectionPolicy time_section) {
  const std::string message_prefix = fmt::format("case {}", to_printable_text(source));
  return problem_from_settings(base::read_ini_settings(ini, message_prefix), name, message_prefix,
                               overrides, naming, std::filesystem::path(source).parent_path(),
                               time_section);
}

Problem problem_from_settings(const std::vector<base::IniSetting>& file_settings,
                              const std::string& name, const std::string& message_prefix,
                              const std::vector<std::string>& overrides, CaseNamingRule naming,
                              const std::filesystem::path& folder,
                              CaseFileTimeSectionPolicy time_section) {
  require_valid_case_name(name);
  CaseFileSettings from_file = settings_by_key(file_settings);
  load_amplitude_table(from_file, folder);
  CaseFileSettings settings = from_file;
  apply_overrides(overrides, message_prefix, settings);
  require_used_constants(from_file, settings);
  load_amplitude_table(settings, {});
  add_moments_of_table(from_file);
  add_moments_of_table(settings);
  try {
    std::vector<CaseFileSection> sections;
    for (const base::OptionsDescriptionBase* description : case_section_descriptions()) {
      if (auto one = parse_section(*description, settings)) sections.push_back(std::move(*one));
    }
    if (auto one = parse_named_constants(settings)) sections.push_back(std::move(*one));
    Problem problem = problem_from_sections(name, sections, time_section);
    if (naming == CaseNamingRule::with_overrides)
      problem.name += overridden_parameters_text(from_file, problem);
    return problem;
  } catch (const InputError& error) {
    throw InputError(fmt::format(
        "{}: {}", setting_location(error.what(), settings).value_or(message_prefix), error.what()));
  }
}

Problem load_case(const std::string& name_or_path, const std::vector<std::string>& overrides,
                  CaseNamingRule naming, CaseFileTimeSectionPolicy time_section) {
  if (const BuiltInCase* named = find_built_in_case(name_or_path)) {
    std::istringstream ini(named->text);
    return read_case(ini, named->name, named->name, overrides, naming, time_section);
  }
  constexpr std::size_t kMostBytes = 1 << 20;
  const auto text = base::read_input_file(name_or_path, kMostBytes);
  if (!text) {
    std::vector<std::string_view> names;
    for (const auto* cases : {&paper_cases(), &example_oscillator_cases()}) {
      for (const auto& named : *cases) names.emplace_back(named.name);
    }
    throw InputError(fmt::format("no case {}: neither a readable file nor one of {}",
                                 in_quotes(name_or_path), fmt::join(names, ", ")));
  }
  const std::string name = std::filesystem::path(name_or_path).stem().string();
  std::istringstream ini(*text);
  return read_case(ini, name, name_or_path, overrides, naming, time_section);
}

}  // namespace fpkcheck::problem
