#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "workflows/study/reference/reference.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kReferenceUsage = R"(usage: fpkcheck reference [CASE ...] [options]

Reference values for the full jump equation with the exact impact: moments to seven digits, p(y)
and p(y') at twenty points to five digits. Prints the digits on which two discretisations of
different order agree, and the results of a long simulation. Solves each CASE (default: the four
cases of the paper) in about a minute.

examples:
  fpkcheck reference --out docs                 (writes docs/reference.md and docs/reference.csv)
  fpkcheck reference case1 --set impulse.law=laplace
)";

}  // namespace

int reference_command(const CommandInvocation& call) {
  namespace po = boost::program_options;
  CommonCommandArguments common;
  study::ReferenceOptions options;
  po::options_description own;
  own.add_options()("time", make_optional_option(options.simulation_time, "T"),
                    "simulated time over all streams (default: 1e7 decay times)")(
      "seed",
      po::value<std::int64_t>()->value_name("S")->default_value(1)->notifier(
          [&](std::int64_t seed) {
            if (seed < 0)
              throw InputError(fmt::format("--seed {} (must be zero or positive)", seed));
            options.seed = static_cast<std::uint64_t>(seed);
          }),
      "seed of the simulation, 0 or greater");
  if (!parse_case_arguments(call.arguments, kReferenceUsage, own, common)) return kSuccess;
  if (common.json) {
    throw InputError("reference has no --json; use --out DIR, which writes reference.csv");
  }
  if (common.cases.empty()) common.cases = {"case1", "case2", "case3", "case4"};
  const auto problems = load_cases(common);
  if (options.simulation_time &&
      !(*options.simulation_time > 0 && std::isfinite(*options.simulation_time))) {
    throw InputError(
        fmt::format("--time {} (must be a positive number)", *options.simulation_time));
  }
  for (const auto& problem : problems) study::validate(problem, options);
  const OutputDirectory directory(common.out);
  std::vector<study::CaseReferenceValues> references;
  for (const auto& problem : problems) {
    if (!common.quiet) print_message(fmt::format("reference of {} ...", problem.name));
    references.push_back(study::compute_reference(problem, options));
    throw_if_interrupted();
    const auto& failure = references.back().failure;
    if (common.quiet && !failure.empty())
      print_message(fmt::format("{}: {}", problem.name, failure));
  }
  const std::string text = study::reference_markdown(references, call.command_line);
  if (common.out) {
    const base::ProcessExitBlocker in_hand;
    const std::filesystem::path place(*common.out);
    base::FileTransaction files;
    files.add(place / "reference.md", text);
    files.add(place / "reference.csv", study::reference_csv(references));
    files.commit();
    set_exit_message("all files were written");
    if (!common.quiet) {
      print_output(fmt::format("Wrote reference.md and reference.csv to {}.\n", *common.out));
    }
  } else {
    print_output(text);
  }
  return std::ranges::all_of(references, [](const auto& r) { return r.failure.empty(); })
             ? kSuccess
             : kFailure;
}

}  // namespace fpkcheck::cli
