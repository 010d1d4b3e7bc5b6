#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/program.hpp"
#include "cli/studies.hpp"
#include "parameters/input_error.hpp"
#include "parameters/shown.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kStudyUsage = R"(usage: fpkcheck study SUBJECT CASE [options]

subjects (fpkcheck study SUBJECT --help explains each):
  grid            finite differences over the grid: observed orders, limits, and the error of all
                  methods against their cost
  order           closures over the order of their polynomial: which converge, to what, at what cost
  regularisation  the series cut after the fourth derivative on finer and finer velocity steps
)";
constexpr const char* kSubjects = "grid, order or regularisation";

bool asks_for_help(const std::string& argument) { return argument == "--help" || argument == "-h"; }

}  // namespace

const std::vector<std::string>& study_subjects() {
  static const std::vector<std::string> subjects{"grid", "order", "regularisation"};
  return subjects;
}

int study_command(const Call& call) {
  const auto& arguments = call.arguments;
  if (!arguments.empty() && asks_for_help(arguments.front())) {
    answer_help(kStudyUsage, {});
    return kDone;
  }
  const auto subject =
      std::ranges::find_if(arguments, [](const auto& a) { return !a.starts_with('-'); });
  if (subject == arguments.end() || subject != arguments.begin()) {
    throw InputError(
        fmt::format("study of what? (the subject comes first: {}; --help explains)", kSubjects));
  }
  const Call rest{{subject + 1, arguments.end()}, call.command_line, call.registry};
  if (*subject == "grid") return study_grid(rest);
  if (*subject == "order") return study_order(rest);
  if (*subject == "regularisation") return study_regularisation(rest);
  throw InputError(fmt::format("{} is no subject of a study (use {}; --help explains)",
                               parameters::in_quotes(*subject), kSubjects));
}

}  // namespace fpkcheck::cli
