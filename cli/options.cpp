#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/input_error.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::cli {

std::vector<std::string> parse_comma_separated_list(const std::string& option,
                                                    const std::string& list) {
  std::vector<std::string> result;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');) {
    if (std::ranges::find(result, item) == result.end()) result.push_back(item);
  }
  if (result.empty()) {
    throw InputError(fmt::format("{}: the list is empty; give items separated by commas", option));
  }
  return result;
}

std::vector<int> parse_integers(const std::string& option, const std::string& list) {
  std::vector<int> result;
  for (const auto& item : parse_comma_separated_list(option, list)) {
    const auto value = base::parse_number<int>(item);
    if (!value) {
      throw InputError(fmt::format("{} {}: {} is not a valid integer; use a list such as 2,4,6",
                                   option, base::to_printable_text(list), base::in_quotes(item)));
    }
    if (std::ranges::find(result, *value) == result.end()) result.push_back(*value);
  }
  return result;
}

namespace {

namespace po = boost::program_options;
using base::NamedParameterValue;
using base::Parameter;
using base::ParameterType;
using base::Value;
using base::Values;
using report::FigureFormat;
using report::FigureWidth;

void set_option_value(Values& values, const std::string& name, const Value& value) {
  const auto own = std::ranges::find(values, name, &NamedParameterValue::name);
  if (own != values.end()) {
    own->value = value;
  } else {
    values.push_back({name, value});
  }
}

std::string default_value_text(const Value& value) {
  const auto* word = std::get_if<std::string>(&value);
  return word != nullptr ? *word : base::value_as_text(value);
}

void add_option(const Parameter& parameter, const Value* default_value, Values& values,
                po::options_description& options) {
  const std::string label = "--" + parameter.flag;
  if (parameter.type == ParameterType::flag) {
    options.add_options()(parameter.flag.c_str(),
                          po::bool_switch()->notifier([&values, parameter](bool given) {
                            if (given) set_option_value(values, parameter.name, true);
                          }),
                          parameter.help.c_str());
    return;
  }
  auto* semantic = po::value<std::string>()->value_name(parameter.placeholder);
  if (default_value != nullptr && !base::is_unset(*default_value)) {
    semantic->default_value(default_value_text(*default_value));
  }
  semantic->notifier([&values, parameter, label](const std::string& text) {
    const Value value = base::parse_value(parameter, text, label);
    if (!parameter.is_in_range(value)) {
      throw InputError(fmt::format("{} {} (must be {})", label, base::to_printable_text(text),
                                   parameter.requirement_text()));
    }
    set_option_value(values, parameter.name, value);
  });
  options.add_options()(parameter.flag.c_str(), semantic, parameter.help.c_str());
}

std::vector<FigureFormat> parse_figure_formats(const std::string& list) {
  std::vector<FigureFormat> formats;
  for (const auto& item : parse_comma_separated_list("--figures", list)) {
    const auto format = base::enum_from_name<FigureFormat>(item);
    if (!format) {
      throw InputError(fmt::format("--figures {}: {} is not a format; use png, svg, pdf or tex",
                                   base::to_printable_text(list), base::in_quotes(item)));
    }
    formats.push_back(*format);
  }
  return formats;
}

FigureWidth parse_figure_width(const std::string& text) {
  const auto width = base::enum_from_name<FigureWidth>(text);
  if (!width || *width == FigureWidth::screen) {
    throw InputError(
        fmt::format("--figure-width {} (must be 85 or 170, in mm)", base::in_quotes(text)));
  }
  return *width;
}

}  // namespace

po::options_description make_command_line_options(const base::OptionsDescriptionBase& description,
                                                  Values& values) {
  po::options_description options;
  for (const auto& parameter : description.parameters()) {
    if (parameter.flag.empty()) continue;
    const auto default_value =
        std::ranges::find(values, parameter.name, &NamedParameterValue::name);
    add_option(parameter, default_value == values.end() ? nullptr : &default_value->value, values,
               options);
  }
  return options;
}

po::options_description make_command_line_options(const base::OptionsDescriptionBase& description,
                                                  const std::vector<std::string>& names,
                                                  Values& given) {
  po::options_description options;
  for (const auto& name : names) add_option(*description.find(name), nullptr, given, options);
  return options;
}

po::options_description make_solver_run_options(const methods::SolverRegistry& registry,
                                                base::Values& given) {
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

po::options_description make_figure_options(report::FigureOptions& figures) {
  po::options_description options;
  options.add_options()  //
      ("figures",
       po::value<std::string>()->value_name("LIST")->notifier(
           [&figures](const std::string& list) { figures.formats = parse_figure_formats(list); }),
       "formats of the figures, separated by commas: png (default), svg, pdf, tex (for LaTeX)")  //
      ("figure-width",
       po::value<std::string>()->value_name("MM")->notifier(
           [&figures](const std::string& text) { figures.width = parse_figure_width(text); }),
       "width of the figures in mm: 85 or 170, one or two columns of a printed page (default: size "
       "for a screen)");
  return options;
}

po::options_description make_case_figure_options(report::FigureOptions& figures) {
  po::options_description options = make_figure_options(figures);
  options.add_options()(
      "curves",
      po::value<std::string>()->value_name("LIST")->notifier([&figures](const std::string& list) {
        figures.curves = parse_comma_separated_list("--curves", list);
      }),
      "solutions in the figures of a case: ids, families or solvers separated by commas, or all "
      "(default: densities from files, and up to six curves: the reference, other solutions of the "
      "problem, and the closest closure of each formulation)");
  return options;
}

}  // namespace fpkcheck::cli
