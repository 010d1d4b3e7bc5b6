#include <fmt/format.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "cli/help.hpp"
#include "cli/program.hpp"
#include "report/text/wrap_text.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kStudyUsage = R"(usage: fpkcheck study SUBJECT CASE [options]

subjects (options: fpkcheck study SUBJECT --help):
)";

std::string study_usage() {
  constexpr std::size_t kWidth = 100, kColumn = 18;
  std::string text = kStudyUsage;
  for (const auto& [name, summary, run] : study_subjects()) {
    auto lines = report::wrap_text(std::string(kColumn, ' ') + summary, kWidth, kColumn);
    text += lines.replace(2, name.size(), name);
  }
  return text;
}

std::string study_subject_list_text() {
  std::string text;
  const auto& all = study_subjects();
  for (std::size_t k = 0; k < all.size(); ++k) {
    text += (k == 0 ? "" : k + 1 < all.size() ? ", " : " or ") + all[k].name;
  }
  return text;
}

bool is_help_flag(const std::string& argument) { return argument == "--help" || argument == "-h"; }

}  // namespace

const std::vector<StudySubject>& study_subjects() {
  static const std::vector<StudySubject> subjects{
      {"grid",
       "grid convergence of the finite volumes: observed orders, limits, and error against cost "
       "for all methods",
       study_grid_command},
      {"order", "convergence of the closures in the order of their polynomial: limit and cost",
       study_order_command},
      {"regularisation",
       "the series truncated after the fourth derivative, over the velocity step: growth rates",
       study_regularisation_command}};
  return subjects;
}

int study_command(const CommandCall& call) {
  const auto& arguments = call.arguments;
  if (!arguments.empty() && is_help_flag(arguments.front())) {
    print_or_capture_help(study_usage(), {});
    return kSuccess;
  }
  const auto subject_argument =
      std::ranges::find_if(arguments, [](const auto& a) { return !a.starts_with('-'); });
  if (subject_argument == arguments.end() || subject_argument != arguments.begin()) {
    throw InputError(
        fmt::format("study without a subject; use study SUBJECT CASE with {} (see --help)",
                    study_subject_list_text()));
  }
  const auto subject = std::ranges::find(study_subjects(), *subject_argument, &StudySubject::name);
  if (subject == study_subjects().end()) {
    throw InputError(fmt::format("{} is not a subject of study; use {} (see --help)",
                                 base::in_quotes(*subject_argument), study_subject_list_text()));
  }
  return subject->run({{subject_argument + 1, arguments.end()}, call.command_line, call.registry});
}

}  // namespace fpkcheck::cli
