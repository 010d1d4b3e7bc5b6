#pragma once

#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/process/stopwatch.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "workflows/study/study_report.hpp"

namespace fpkcheck::cli {

/// Arguments and output of a command of fpkcheck that solves one case. The output of the command is
/// a table or JSON on standard output, and with --out JSON, CSV and a figure as files.
class OneCaseReportCommand {
 public:
  explicit OneCaseReportCommand(const CommandInvocation& call) : call_(call) {}

  CommonCommandArguments common;

  /// Parses the arguments of the command into `common` and into the variables of the options.
  /// @param own options of the command in addition to the common options
  /// @return false if the help was printed because of --help
  bool parse_command_arguments(const char* usage,
                               const boost::program_options::options_description& own,
                               const char* out_help) {
    return parse_case_arguments(call_.arguments, usage, own, common, out_help);
  }

  /// Computes the result of one case and prints a table or JSON. With the option --out the files of
  /// the result are written.
  /// @param run function that returns the result for a problem and a progress listener
  /// @throws InputError unless there is exactly one case
  template <class Run>
  int compute_and_write_report(const Run& run) const {
    const auto problems = load_cases(common);
    if (problems.size() != 1) throw InputError("this command takes one case; name it, e.g. case1");
    const OutputDirectory directory(common.out);
    ProgressLine line(common.quiet);
    const auto result = run(problems.front(), [&](const methods::RunProgress& progress) {
      line.show_progress(progress);
    });
    throw_if_interrupted();
    line.erase_line();
    write_output_files(study::make_study_report(result, call_.command_line, terminal_format(),
                                                common.figures.width));
    if (has_converged(result)) return kSuccess;
    if (common.quiet) {
      print_message(
          "the result does not meet the criterion that --help states; see the table of the "
          "command");
    }
    return kFailure;
  }

 private:
  void write_output_files(const study::StudyReport& output) const;

  const CommandInvocation& call_;
  base::Stopwatch stopwatch_;
};

}  // namespace fpkcheck::cli
