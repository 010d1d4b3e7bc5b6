#include "cli/parameter_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::cli {
namespace {

namespace po = boost::program_options;
using base::NamedParameterValue;
using base::Parameter;
using base::Type;
using base::Value;
using base::Values;

void set_value(Values& values, const std::string& name, const Value& value) {
  const auto own = std::ranges::find(values, name, &NamedParameterValue::name);
  if (own != values.end()) {
    own->value = value;
  } else {
    values.push_back({name, value});
  }
}

// Text of a default value for --help, without quotes.
std::string default_text(const Value& value) {
  const auto* word = std::get_if<std::string>(&value);
  return word != nullptr ? *word : base::text_of(value);
}

void add_option(const Parameter& parameter, const Value* usual, Values& values,
                po::options_description& options) {
  const std::string label = "--" + parameter.flag;
  if (parameter.type == Type::flag) {
    options.add_options()(parameter.flag.c_str(),
                          po::bool_switch()->notifier([&values, parameter](bool given) {
                            if (given) set_value(values, parameter.name, true);
                          }),
                          parameter.help.c_str());
    return;
  }
  auto* semantic = po::value<std::string>()->value_name(parameter.placeholder);
  if (usual != nullptr && !base::is_unset(*usual)) {
    semantic->default_value(default_text(*usual));
  }
  semantic->notifier([&values, parameter, label](const std::string& text) {
    const Value value = base::parse_value(parameter, text, label);
    if (!parameter.is_in_range(value)) {
      throw InputError(fmt::format("{} {} (must be {})", label, base::sanitise(text),
                                   parameter.requirement_text()));
    }
    set_value(values, parameter.name, value);
  });
  options.add_options()(parameter.flag.c_str(), semantic, parameter.help.c_str());
}

}  // namespace

po::options_description make_command_line_options(const base::DescriptionBase& description,
                                                  Values& values) {
  po::options_description options;
  for (const auto& parameter : description.parameters()) {
    if (parameter.flag.empty()) continue;
    const auto usual = std::ranges::find(values, parameter.name, &NamedParameterValue::name);
    add_option(parameter, usual == values.end() ? nullptr : &usual->value, values, options);
  }
  return options;
}

po::options_description make_command_line_options(const base::DescriptionBase& description,
                                                  const std::vector<std::string>& names,
                                                  Values& given) {
  po::options_description options;
  for (const auto& name : names) add_option(*description.find(name), nullptr, given, options);
  return options;
}

po::options_description make_run_options(const methods::Registry& registry, base::Values& given) {
  po::options_description shared;
  for (const auto& solver : registry.solvers()) {
    shared.add(make_command_line_options(*solver.option_descriptions, solver.run_options, given));
  }
  return shared;
}

int requested_thread_count(const Values& given) {
  const auto threads = std::ranges::find(given, "threads", &NamedParameterValue::name);
  return threads == given.end() ? 0 : static_cast<int>(std::get<std::int64_t>(threads->value));
}

}  // namespace fpkcheck::cli
