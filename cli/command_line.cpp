#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "cli/help.hpp"
#include "problem/case_file.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::cli {

namespace po = boost::program_options;

po::options_description add_output_options(const po::options_description& command_options,
                                           CommonCommandArguments& common, const char* out_help) {
  constexpr unsigned kWidth = 96;
  po::options_description all("options", kWidth);
  // The options of a command are added one by one, since Boost would print a nested group after all
  // other options and in another text width.
  for (const auto& option : command_options.options()) all.add(option);
  all.add_options()  //
      ("out", make_optional_option(common.out, "DIR"), out_help)(
          "quiet,q", po::bool_switch(&common.quiet), "print no table and no progress")(
          "json", po::bool_switch(&common.json), "print JSON to standard output, and nothing else")(
          "help,h", "print this text");
  return all;
}

bool parse_arguments(const std::vector<std::string>& arguments, const std::string& usage,
                     const po::options_description& options, std::vector<std::string>& positional) {
  po::options_description all;
  all.add(options).add_options()("positional", po::value(&positional));
  po::positional_options_description rest;
  rest.add("positional", -1);
  try {
    po::variables_map values;
    const int style = po::command_line_style::unix_style ^ po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(all).positional(rest).style(style).run(),
              values);
    if (values.count("help") > 0) {
      print_or_capture_help(usage, options);
      return false;
    }
    po::notify(values);
  } catch (const po::error& error) {
    throw InputError(
        fmt::format("{}; --help lists the options", base::to_printable_text(error.what())));
  }
  return true;
}

bool parse_case_arguments(const std::vector<std::string>& arguments, const std::string& usage,
                          const po::options_description& command_options,
                          CommonCommandArguments& common, const char* out_help) {
  po::options_description with_cases;
  for (const auto& option : command_options.options()) with_cases.add(option);
  with_cases.add_options()(
      "set", po::value(&common.overrides)->value_name("KEY=VALUE")->composing(),
      "override a key of the case, e.g. --set system.restitution=0.9; may be repeated");
  return parse_arguments(arguments, usage, add_output_options(with_cases, common, out_help),
                         common.cases);
}

std::vector<problem::Problem> load_cases(const CommonCommandArguments& common) {
  std::vector<problem::Problem> problems;
  std::set<std::string> names;
  for (const auto& name : common.cases) {
    problems.push_back(problem::load_case(
        name, common.overrides, problem::CaseNamingRule::with_overrides, common.time_section));
    // Two cases with different names may have equal names of result files.
    if (std::ranges::count(common.cases, name) > 1) {
      throw InputError(
          fmt::format("{} is named twice; name it once", base::to_printable_text(name)));
    }
    if (!names.insert(results::case_file_stem(problems.back().name)).second) {
      throw InputError(fmt::format(
          "two cases are called {} or similarly: their files would have the same name; rename one",
          base::in_quotes(problems.back().name)));
    }
  }
  for (const auto& name : names) {
    // Suffixes after the case name in the names of figures and netCDF variables.
    for (const char* suffix : {"-budget", "-sources", "-order", "-tex", "_bounds"}) {
      if (!names.contains(name + suffix)) continue;
      throw InputError(
          fmt::format("cases {0} and {0}{1}: a file or variable of case {0} would have the name "
                      "of case {0}{1}; rename a case",
                      base::to_printable_text(name), suffix));
    }
  }
  if (problems.empty()) {
    throw InputError("no case; name one: case1 .. case4, or an ini file");
  }
  return problems;
}

}  // namespace fpkcheck::cli
