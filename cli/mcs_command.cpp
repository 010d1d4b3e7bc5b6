#include <csignal>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/simulation_options.hpp"
#include "cli/solve_and_report.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck mcs CASE ... [options]

Simulates the impact system itself: impulses at their exact times, impacts located by root
finding, independent streams whose differences give the standard errors and 95 % intervals.
The same seed gives the same result, bit for bit, for any number of threads.

Ends after --time, or as soon as --samples and --target-error are reached. Ctrl-C ends it within
a second or so with what has been reached as the result; a second one ends the program.

--tails splits the trajectories that reach high energies: densities down to 1e-8 of their peak
and beyond, with intervals, in the time of a common run.

examples:
  fpkcheck mcs case1 --seed 7
  fpkcheck mcs case1 --target-error 3e-4 --json
  fpkcheck mcs case1 --samples 1e7
  fpkcheck mcs case1 --tails --out tails
  fpkcheck mcs case1 --equation white
  fpkcheck mcs case1 --time 1e9 --checkpoint state        then, after an interruption:
  fpkcheck mcs case1 --time 1e9 --checkpoint state --resume state
)";

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interruption(int) { interrupted = 1; }

/// The first Ctrl-C is noted while this lives; the next one does what it always does.
class InterruptionGuard {
 public:
  InterruptionGuard() {
    struct sigaction action = {};
    action.sa_handler = note_interruption;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &before_);
  }
  ~InterruptionGuard() { sigaction(SIGINT, &before_, nullptr); }
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

 private:
  struct sigaction before_ = {};
};

boost::program_options::options_description own_options(mcs::Options& options) {
  namespace po = boost::program_options;
  po::options_description own;
  own.add_options()  //
      ("equation",
       po::value<std::string>()->value_name("E")->default_value("kf")->notifier(
           [&options](const std::string& name) {
             if (name != "kf" && name != "white") {
               throw InputError("--equation " + name +
                                " (the simulation has kf, the impulses, and white, Gaussian white "
                                "noise in their place)");
             }
             options.equation = name == "white" ? mcs::Equation::white : mcs::Equation::kf;
           }),
       "kf: the impulses; white: Gaussian white noise of the same intensity")(
          "samples", po::value(&options.samples)->value_name("N"),
          "go on until E[y'^2] is known as well as from N independent samples")(
          "target-error", po::value(&options.target_error)->value_name("E"),
          "go on until the relative standard errors of E[y^2] and E[y'^2] and the expected L1 "
          "errors of the densities are below E")("tails", po::bool_switch(&options.tails),
                                                 "importance splitting: resolve the far tails")(
          "streams", po::value(&options.streams)->value_name("N")->default_value(options.streams),
          "independent streams")(
          "step", po::value(&options.step)->value_name("RAD"),
          "longest Taylor step in radians of the fastest motion (default 0.9)")(
          "white-step", po::value(&options.white_step)->value_name("RAD"),
          "time between the kicks that make up white noise, in radians (default 0.05)")(
          "checkpoint", po::value(&options.checkpoint)->value_name("FILE"),
          "write the state there every half minute and in the end")(
          "resume", po::value(&options.resume)->value_name("FILE"),
          "go on from a checkpoint: the result is that of a run without interruption");
  return own;
}

}  // namespace

int mcs_command(const std::vector<std::string>& arguments, const std::string& command_line) {
  CommonArguments common;
  mcs::Options options;
  auto own = own_options(options);
  own.add(simulation_options(options));
  if (!parse(arguments, kUsage, with_common_options(own, common), common.cases)) return 0;
  if (common.cases.size() > 1 && !(options.checkpoint.empty() && options.resume.empty())) {
    throw InputError(
        "--checkpoint and --resume with several cases (a file holds one: name one case)");
  }
  const InterruptionGuard guard;
  options.stop = [] { return interrupted != 0; };
  return solve_and_report(common, {compare::mcs_method(options)}, options.threads, Required::all,
                          command_line);
}

}  // namespace fpkcheck::cli
