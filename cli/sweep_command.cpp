#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/input_error.hpp"
#include "base/mpi/communicator.hpp"
#include "base/options/enum_names.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "base/process/stopwatch.hpp"
#include "base/text/printable_text.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"
#include "workflows/sweep/execution/solve_time_forecast.hpp"
#include "workflows/sweep/execution/sweep_shards.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/report/sweep_files.hpp"
#include "workflows/sweep/report/sweep_tables.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kSweepUsage = R"(usage: fpkcheck sweep CASE --vary KEY=VALUES [...] [options]
       fpkcheck sweep PLAN.ini [options]
       fpkcheck sweep --merge DIR [DIR ...] --out DIR

Solves a case by several methods at all points of a plan, which varies keys of the case. Reports the
status, the distance to the most accurate solution of each point, and the time of each method:
sweep.csv (a row for each point and method), sweep.nc, and report.html with the figures of figures/:
curves over one varied key, maps over two. VALUES are
  FROM:TO:N        N values, evenly spaced
  log:FROM:TO:N    N positive values, evenly spaced in their logarithms
  A,B,..           a list of numbers or words
A PLAN.ini is a case file with two additional sections: [sweep] (case, methods, design, points) and
[vary] (KEY = VALUES); see cases/sweeps/.
A point that cannot be solved is a row with its status and reason. Each solved point is stored in
DIR/journal: after an interruption the same command continues. Each thread solves one point at a
time; --shard divides a plan for batch systems, and the ranks of mpirun share a plan.
Exit code 0 when all points were processed, whatever the status of their solutions.

examples:
  fpkcheck sweep case1 --vary system.restitution=0.8:1:11 --methods epc,fd-kf
  fpkcheck sweep case1 --vary impulse.rate=log:0.2:20:9 --set system.cubic=0
  fpkcheck sweep case1 --vary impulse.law=gaussian,laplace
  fpkcheck sweep cases/sweeps/rate-law.ini --out map
  fpkcheck sweep mine.ini --dry-run --ranks 16,64
  fpkcheck sweep mine.ini --shard 3/16 --out map
  fpkcheck sweep --merge map --out map             (after all shards)
)";
constexpr const char* kDefaultSweepDirectory = "fpkcheck-sweep";
constexpr const char* kDefaultMethods = "epc,fd";

struct SweepArguments {
  CommonCommandArguments common;
  std::vector<std::string> vary;
  std::optional<std::string> design, methods, shard, closure_errors;
  std::optional<std::size_t> points;
  std::vector<int> ranks;
  bool marginals = false, slopes = false, dry_run = false, merge = false;
  base::Values given;  // method options that the command line sets
};

boost::program_options::options_description sweep_options(SweepArguments& arguments,
                                                          const methods::SolverRegistry& registry) {
  namespace po = boost::program_options;
  po::options_description own;
  own.add_options()  //
      ("vary", po::value(&arguments.vary)->value_name("KEY=VALUES")->composing(),
       "vary KEY of the case over VALUES (see above); may be repeated")  //
      ("design", make_optional_option(arguments.design, "NAME"),
       "product (default): all combinations of the values; list: the k-th values of all keys form "
       "point k; sobol: a Sobol sequence in the box of the ranges FROM:TO or log:FROM:TO")  //
      ("points", make_optional_option(arguments.points, "N"),
       "number of points of the design sobol, 1 .. 1000000")  //
      ("methods", make_optional_option(arguments.methods, "LIST"),
       "solvers, families or ids of methods, separated by commas (default: epc,fd); fd uses the "
       "stepper direct")  //
      ("closure-errors", make_optional_option(arguments.closure_errors, "HOW"),
       "error estimate of closures. reference (default): distance to the most accurate solution of "
       "the point; residuals: by the backward equation, as in run, which takes longer and is used "
       "at all points without a reference")  //
      ("marginals", po::bool_switch(&arguments.marginals),
       "store p(y) and p(y') of every point in DIR/marginals/NUMBER.csv")  //
      ("slopes", po::bool_switch(&arguments.slopes),
       "derivatives of E[y^2] and E[y'^2] with respect to the varied keys, by the methods "
       "fd-..")  //
      ("shard", make_optional_option(arguments.shard, "i/N"),
       "solve every N-th point from point i on, 1 <= i <= N; --merge combines the shards")  //
      ("merge", po::bool_switch(&arguments.merge),
       "combine the shards in the directories DIR ... into one set of tables")  //
      ("dry-run", po::bool_switch(&arguments.dry_run),
       "estimate the time and memory of the plan from a sample of points, including those in "
       "DIR/journal; write no files")  //
      ("ranks",
       po::value<std::string>()->value_name("LIST")->notifier(
           [&](const std::string& list) { arguments.ranks = parse_integers("--ranks", list); }),
       "for --dry-run: also estimate the time for these numbers of processes with one thread each, "
       "e.g. 2,64,1024");
  // The option --threads is the number of points that are solved in parallel, since each method has
  // one thread.
  own.add(make_figure_options(arguments.common.figures));
  own.add(make_solver_run_options(registry, arguments.given));
  return own;
}

sweep::SweepAxis parse_varied_key(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) {
    throw InputError(
        fmt::format("--vary {}: not KEY=VALUES; write e.g. --vary "
                    "system.restitution=0.5:1:11",
                    base::to_printable_text(text)));
  }
  return sweep::parse_sweep_axis(text.substr(0, equals), text.substr(equals + 1), "--vary");
}

// Adds the method options in the plan file of a sweep to `given`, unless the command line sets the
// same options.
void add_plan_options(const std::vector<base::IniSetting>& lines,
                      const methods::SolverRegistry& registry, base::Values& given) {
  std::vector<std::string> known{"case", "methods", "design", "points", "closure_errors"};
  std::vector<const base::Parameter*> options;
  for (const auto& solver : registry.solvers()) {
    for (const auto& name : solver.run_options) {
      if (name == "threads") continue;
      known.push_back(name);
      options.push_back(solver.option_descriptions->find(name));
    }
  }
  for (const auto& line : lines) {
    const auto option = std::ranges::find(options, line.key, &base::Parameter::name);
    if (option == options.end()) {
      throw InputError(fmt::format("{}: unknown key {}; known keys of [sweep]: {}", line.where,
                                   base::in_quotes(line.ini_section_and_key()),
                                   fmt::join(known, ", ")));
    }
    if (contains(given, line.key)) continue;
    given.push_back({line.key, base::parse_value(**option, line.text,
                                                 fmt::format("{}: {} =", line.where, line.key))});
  }
}

// Options of `fpkcheck sweep` on the command line take precedence over the plan file.
sweep::SweepPlan make_sweep_plan(const SweepArguments& arguments,
                                 const methods::SolverRegistry& registry) {
  if (arguments.common.cases.size() != 1) {
    throw InputError("a sweep takes one case or plan; name it");
  }
  const auto text =
      sweep::read_sweep_plan(arguments.common.cases.front(), arguments.common.overrides);
  sweep::SweepPlan plan{.base = text.base, .axes = text.axes};
  for (const auto& one : arguments.vary) {
    auto axis = parse_varied_key(one);
    const auto same = std::ranges::find(plan.axes, axis.key, &sweep::SweepAxis::key);
    if (same != plan.axes.end() &&
        same - plan.axes.begin() < static_cast<std::ptrdiff_t>(text.axes.size())) {
      *same = std::move(axis);
    } else {
      plan.axes.push_back(std::move(axis));
    }
  }
  plan.design = text.design.value_or(sweep::SweepPlanDesign::product);
  if (arguments.design)
    plan.design = base::parse_enum<sweep::SweepPlanDesign>("--design", *arguments.design);
  plan.closure_errors = text.closure_errors.value_or(sweep::ClosureErrorSource::reference);
  if (arguments.closure_errors) {
    plan.closure_errors =
        base::parse_enum<sweep::ClosureErrorSource>("--closure-errors", *arguments.closure_errors);
  }
  plan.sobol_points = arguments.points.value_or(text.points.value_or(0));
  plan.marginals = arguments.marginals;
  plan.slopes = arguments.slopes;
  sweep::require_known_constants(plan.base, plan.axes);
  plan.points = sweep::make_sweep_plan_points(plan.axes, plan.design, plan.sobol_points);

  base::Values given = arguments.given;
  add_plan_options(text.options, registry, given);
  given.push_back({"threads", std::int64_t{1}});
  given.push_back({"stepper", std::string("direct")});
  plan.methods = registry.methods_selected_by_list(
      arguments.methods.value_or(text.methods.value_or(kDefaultMethods)), given);
  return plan;
}

void write_sweep_results(const SweepArguments& arguments, const sweep::SweepResults& results,
                         const CommandInvocation& call, double seconds) {
  const std::filesystem::path directory = *arguments.common.out;
  const base::ProcessExitBlocker in_hand;
  sweep::write_sweep_tables(directory, results, call.command_line);
  set_exit_message("sweep.csv and sweep.nc were written, but not report.html");
  if (arguments.common.json) {
    print_output(sweep::sweep_json_text(results, call.command_line) + '\n');
  } else if (!arguments.common.quiet) {
    print_output(sweep::sweep_table_text(results, terminal_format()));
  }
  for (const auto& warning :
       sweep::write_report(directory, results, call.command_line, arguments.common.figures)) {
    print_message(warning);
  }
  if (base::stop_requested()) return;  // the caller sets the exit code of the signal
  set_exit_message("all files were written");
  if (arguments.common.json || arguments.common.quiet) return;
  print_output(fmt::format("\nWrote sweep.csv, sweep.nc and report.html to {} in {:.1f} s.\n",
                           *arguments.common.out, seconds));
}

int merge_shards(const SweepArguments& arguments, const CommandInvocation& call,
                 const base::Stopwatch& stopwatch) {
  if (arguments.common.cases.empty()) {
    throw InputError("--merge without a directory; name the directories of the shards");
  }
  std::vector<std::filesystem::path> directories(arguments.common.cases.begin(),
                                                 arguments.common.cases.end());
  auto merged = sweep::merge_sweep_journals(directories, call.registry);
  const OutputDirectory directory(arguments.common.out);
  for (const auto& remark : merged.remarks) print_message(remark);
  write_sweep_results(arguments, merged.results, call, stopwatch.seconds());
  return merged.results.is_complete() ? kSuccess : kFailure;
}

// The forecast of solve times uses the times of points in the journal of an earlier sweep with the
// same plan.
std::vector<sweep::SweepPointResult> load_solved_points(const sweep::SweepPlan& plan,
                                                        const std::filesystem::path& journal) {
  std::error_code ignored;
  if (!std::filesystem::exists(journal, ignored)) return {};
  return sweep::read_sweep_journal(journal, plan).points;
}

int print_forecast(const SweepArguments& arguments, const sweep::SweepPlan& plan, int threads) {
  for (const int ranks : arguments.ranks) {
    if (ranks < 1) throw InputError(fmt::format("--ranks {} (must be 1 or more)", ranks));
  }
  const auto found = sweep::forecast_solve_times(
      plan, load_solved_points(plan, std::filesystem::path(*arguments.common.out) / "journal"),
      threads);
  throw_if_interrupted();
  print_output(sweep::solve_time_forecast_text(plan, found, static_cast<std::size_t>(threads),
                                               arguments.ranks, terminal_format()));
  return kSuccess;
}

// Runs a sweep. Only the process that writes the journal (under MPI the first rank) shows progress
// and writes results.
int run_sweep(const SweepArguments& arguments, const sweep::SweepPlan& plan,
              const sweep::SweepShard& shard, int threads, base::Communicator* ranks,
              const CommandInvocation& call, const base::Stopwatch& stopwatch) {
  const CommonCommandArguments& common = arguments.common;
  ProgressLine line(common.quiet);
  const int workers = threads * (ranks == nullptr ? 1 : ranks->process_count());
  const auto report_progress = [&](const sweep::SweepPointQueue::State& at) {
    set_exit_message(fmt::format("{} of {} points are in {}/{} (the same command continues)",
                                 at.done, at.total, *common.out, shard.shard_journal_name()));
    line.show_progress(
        {.done = at.done,
         .total = at.total,
         .case_name = plan.base.name,
         .method = "points",
         .fraction = 0,
         .note = at.remaining_seconds
                     ? sweep::duration_text(*at.remaining_seconds / workers) + " left"
                     : ""});
  };
  std::optional<OutputDirectory> directory;
  std::optional<sweep::JournaledPointQueue> progress;
  const auto open_queue = [&]() -> sweep::JournaledPointQueue& {
    directory.emplace(common.out);
    progress.emplace(plan, *common.out, shard, report_progress);
    report_progress(progress->point_queue_state());
    if (const auto resumed = progress->sweep_resumption_text(); !resumed.empty() && !common.quiet) {
      print_message(resumed);
    }
    return *progress;
  };
  if (ranks != nullptr && !ranks->is_first_rank()) {
    set_exit_message("the finished points are in the journal of rank 0");
  }
  sweep::solve_sweep_plan(plan, *common.out, ranks, threads, open_queue);
  if (!progress) return kSuccess;
  line.erase_line();
  if (base::stop_requested()) return kFailure;  // the caller sets the exit code of the signal

  if (shard.of > 1) {
    if (!common.quiet) {
      print_output(fmt::format(
          "Shard {} of {}: {} points in {}/{}, {:.1f} s. After all shards: fpkcheck sweep --merge "
          "{} --out {}\n",
          shard.number, shard.of, progress->point_queue_state().done, *common.out,
          shard.shard_journal_name(), stopwatch.seconds(), *common.out, *common.out));
    }
    return kSuccess;
  }
  write_sweep_results(arguments, sweep::make_sweep_results(plan, progress->solved_points()), call,
                      stopwatch.seconds());
  return kSuccess;
}

}  // namespace

int sweep_command(const CommandInvocation& call) {
  const base::Stopwatch stopwatch;
  SweepArguments arguments;
  CommonCommandArguments& common = arguments.common;
  const auto own = sweep_options(arguments, call.registry);
  if (!parse_case_arguments(call.arguments, kSweepUsage, own, common,
                            "write journal, tables and report.html to DIR (default: "
                            "fpkcheck-sweep)")) {
    return kSuccess;
  }
  if (!common.out) common.out = kDefaultSweepDirectory;
  if (arguments.merge) return merge_shards(arguments, call, stopwatch);
  const int threads = base::resolve_thread_count(requested_thread_count(arguments.given));
  std::erase_if(arguments.given, [](const auto& option) { return option.name == "threads"; });
  const auto shard = arguments.shard ? sweep::parse_shard(*arguments.shard) : sweep::SweepShard{};
  const auto plan = make_sweep_plan(arguments, call.registry);
  if (arguments.dry_run) return print_forecast(arguments, plan, threads);

  const auto ranks = base::Communicator::launched_by_mpi() ? base::Communicator::initialise_mpi()
                                                           : std::unique_ptr<base::Communicator>();
  return run_sweep(arguments, plan, shard, threads, ranks.get(), call, stopwatch);
}

}  // namespace fpkcheck::cli
