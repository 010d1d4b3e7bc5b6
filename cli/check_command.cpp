#include <fmt/format.h>

#include <chrono>

#include "base/files/pending_files.hpp"
#include "base/input_error.hpp"
#include "base/process/write_guard.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/ending.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "results/saved_run.hpp"
#include "workflows/check/baseline.hpp"
#include "workflows/check/check.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kCheckUsage = R"(usage: fpkcheck check BASELINE.json [options]

Solves again what a summary.json describes and compares: statuses, moments, mass, balance of power,
coefficients of closures, distances, and the curves of the marginals.csv beside it. Any run's
directory is a baseline: keep the one whose results you trust.
Deterministic methods are held to --tolerance, the simulation to its standard errors, though the
same seed normally gives the same numbers. Prints what moved and by how much, and how near the rest
came to what is allowed.
Exit code 0 when everything agrees, 1 when something moved, 2 for a baseline that cannot be used.

examples:
  fpkcheck run mine.ini --out baseline                      make one
  fpkcheck check baseline/summary.json                      use it
  fpkcheck check baseline/summary.json --out changed        and keep the new run beside it
)";

struct CheckArguments {
  CommonArguments common;
  check::Tolerances tolerances;
  int threads = 0;
};

boost::program_options::options_description options_of(CheckArguments& arguments) {
  namespace po = boost::program_options;
  auto& common = arguments.common;
  auto& tolerances = arguments.tolerances;
  po::options_description options("options", 96);
  options.add_options()  //
      ("tolerance",
       po::value(&tolerances.deterministic)
           ->value_name("T")
           ->default_value(tolerances.deterministic, "1e-08"),
       "of moments, densities and distances of deterministic methods; coefficients are allowed 50 "
       "times it, distances in tails 100 times")("standard-errors",
                                                 po::value(&tolerances.standard_errors)
                                                     ->value_name("N")
                                                     ->default_value(tolerances.standard_errors),
                                                 "of simulations: of the difference of both runs")(
          "threads", po::value(&arguments.threads)->value_name("N"),
          "threads to use (default: one per processor)")(
          "out",
          po::value<std::string>()->value_name("DIR")->notifier(
              [&common](const std::string& value) { common.out = value; }),
          "write check.json there, and summary.json and marginals.csv of the new run")(
          "quiet,q", po::bool_switch(&common.quiet), "no table and no progress")(
          "json", po::bool_switch(&common.json),
          "print check.json on standard output, and nothing else there")("help,h", "this text");
  return options;
}

void write(const std::filesystem::path& directory, const results::Run& run,
           const std::string& json) {
  const base::WriteGuard in_hand;
  base::PendingFiles files;
  results::add_summary_and_curves(files, directory, run);
  files.add(directory / "check.json", json + '\n');
  files.commit();
  note_kept("all was written");
}

}  // namespace

int check_command(const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  CheckArguments given;
  std::vector<std::string> places;
  if (!parse(call.arguments, kCheckUsage, options_of(given), places)) return kDone;
  const auto& [common, tolerances, threads] = given;
  if (places.size() != 1) {
    throw InputError("check takes one baseline (the summary.json of a run, or its directory)");
  }
  check::validate(tolerances);
  if (threads < 0) throw InputError(fmt::format("--threads {} (must not be negative)", threads));
  using base::Value;
  const auto baseline =
      check::load_baseline(places.front(), call.registry,
                           {{"threads", threads > 0 ? Value(std::int64_t{threads}) : Value()}});
  const OutputDirectory directory(common.out);

  ProgressLine progress(common.quiet);
  const auto run = check::repeat_run(baseline, call.command_line, threads,
                                     [&](const methods::RunProgress& at) { progress.show(at); });
  throw_if_interrupted();
  progress.clear();

  auto result = check::check(baseline.run, run, tolerances, baseline.has_marginals);
  result.notes = baseline.notes;
  const auto json = check::check_json(result, call.command_line, places.front());
  if (common.json) {
    put_out(json + '\n');
  } else if (!common.quiet) {
    put_out(check::check_table(result, terminal_format()));
  }
  if (common.out) write(*common.out, run, json);
  if (!common.quiet && !common.json) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    put_out(fmt::format(
        "{}{:.1f} s.\n",
        common.out
            ? fmt::format("Wrote check.json, summary.json and marginals.csv to {} in ", *common.out)
            : "Done in ",
        elapsed.count()));
  }
  if (common.quiet && !result.agrees()) {
    complain(fmt::format("{} of {} figures moved", result.moved().size(), result.changes.size()));
  }
  return result.agrees() ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
