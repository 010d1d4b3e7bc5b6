#include <algorithm>
#include <string>

#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/report_of_one_case.hpp"
#include "workflows/study/functionals/functionals.hpp"
#include "workflows/study/transient/comparison_over_time.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kSpectrumUsage = R"(usage: fpkcheck spectrum CASE [options]

One-sided spectral density G(w) of the stationary y or y': its integral over the angular frequencies
w >= 0 is the variance. Finite volumes solve (i w - L) x = (y - E[y]) p with the generator L for all
frequencies at once, in a Krylov space, on three or more grids, whose differences give the error.
The simulation averages periodograms (Welch's method) and states standard errors.
Exit code 0 when the estimated errors by finite volumes are below --accuracy times the largest
density.

examples:
  fpkcheck spectrum case1
  fpkcheck spectrum bistable --frequencies 0:1:200 --out results
  fpkcheck spectrum case4 --of ydot --methods fd-kf,fd-white,mcs
)";

constexpr const char* kSensitivityUsage = R"(usage: fpkcheck sensitivity CASE [options]

Derivatives of the stationary moments and densities with respect to each parameter of the case, with
all other parameters fixed; impulse.rate changes at a fixed intensity. Finite volumes differentiate
the equation L p = 0 on three or more grids, whose differences give the error. Finite volumes also
give the derivatives dp/dtheta of the densities p(y) and p(y') with respect to each parameter theta;
--out writes these derivatives. The simulation uses common random numbers for the changed problems
and states standard errors. Closures, such as epc-polar-n6, are solved for the changed problems;
their errors are the differences from order n-2. Exit code 0 when the estimated errors by finite
volumes are below --accuracy: errors of elasticities, and L1 errors of theta dp/dtheta.

examples:
  fpkcheck sensitivity case1
  fpkcheck sensitivity case1 --parameters system.restitution --methods fd-kf
  fpkcheck sensitivity case1 --methods fd,epc-polar-n6,epc-moment-n6
  fpkcheck sensitivity coulomb --out results
)";

constexpr const char* kPassageUsage =
    R"(usage: fpkcheck passage CASE --displacement B | --displacement A,B | --energy H [options]

First passage of the displacement y above a barrier B, first exit of y from an interval (A, B), or
first passage of the energy y'^2/2 + U(y) above a level H, with the potential U of the force, U(0) =
0: probability of survival over time, mean time from rest (or from --start) and from the stationary
law below the barrier, hazard (rate of passages in the limit of long times). For an interval also
the probability that y leaves at B. Finite volumes or finite differences (fd) solve the backward
equation below the barrier on three or more grids, whose differences give the error. The method
characteristics, for displacements without noise, computes the same quantities to more digits, along
the motion between impulses. The simulation measures the stays below the barrier, or splits
trajectories if passages are rare, and states standard errors. The column rice is the usual
approximation by independent upward crossings of a displacement at Rice's rate.
Exit code 0 when the estimated errors are below --accuracy: relative errors, and absolute errors of
survival probabilities.

examples:
  fpkcheck passage case1 --displacement 1.5
  fpkcheck passage case1 --displacement 2 --times 100,1000,10000 --methods fd-kf,fd-white
  fpkcheck passage case1 --displacement 1.5 --start 0.5,-1
  fpkcheck passage bistable --displacement -1.5,0
  fpkcheck passage case1 --energy 1
  fpkcheck passage case1 --displacement 2 --methods fd,characteristics,mcs --accuracy 1e-3
  fpkcheck passage bistable --displacement 1 --out results
)";

constexpr const char* kOverTimeUsage = R"(usage: fpkcheck run CASE --until T [options]

Densities p(y, t) and p(y', t) over time, from a Gaussian density at t = 0, by finite volumes,
closures and simulation. The table has second moments, and L1 distances to the finite volumes. Without
finite volumes the L1 distances refer to the simulation.
  fd    finite volumes on two grids with two tolerances of the time steps, whose difference gives
        the error
  epc   epc-moment and epc-polar, any order: exact moment equations with the moments as state;
        epc-gaussian: the paper's projections under Gaussian weights. The difference from order n-2
        gives the error
  mcs   independent paths, with sampling errors
The case may have a section [time] with formulas: factors of the rate of impulses and of the noise
intensity, and a force F(t). With --periodic the densities are those of the periodic state, which
repeats after the period T of the formulas; the means over a period are printed.
The status of finite volumes and closures is ok if their error is at most --accuracy. Exit code 0
when every finite-volume solution and simulation of the list has status ok or does not support the
problem, and at least one has status ok. The status of closures does not change the exit code.

examples:
  fpkcheck run case1 --until 30
  fpkcheck run case1 --until 30 --snapshots 60 --methods fd,epc-polar-n8,mcs --out results
  fpkcheck run bistable --until 20 --start-mean-y 1
  fpkcheck run case1 --set 'time.rate=1+0.8*cos(1.2*t)' --until 20
  fpkcheck run case1 --set 'time.force=0.3*cos(t)' --until 6.283185307179586 --periodic
)";

// Returns the error message of the cases of a command; empty if the cases are valid.
std::string case_error(const CommonCommandArguments& common) {
  try {
    load_cases(common);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// Changes the arguments of a command before the case is loaded; most commands change nothing.
template <class Options>
void complete_arguments(const Options& /*options*/, CommonCommandArguments& /*common*/) {}

// Adds walls beyond the barriers if the oscillator has a stationary density only with these walls.
void complete_arguments(const study::PassageOptions& options, CommonCommandArguments& common) {
  CommonCommandArguments with_walls = common;
  for (const std::string& setting : study::walls_beyond_barriers(options)) {
    with_walls.overrides.push_back(setting);
  }
  if (with_walls.overrides.size() == common.overrides.size()) return;
  const bool has_density = case_error(common).find("no stationary density") == std::string::npos;
  if (!has_density && case_error(with_walls).empty()) common = with_walls;
}

/// Runs the command of a functional of the generator.
/// @param study function that computes the functional of one problem with the options
template <class Options, class Study>
int run_functional(
    const CommandInvocation& call, const char* usage,
    const base::OptionsDescription<Options>& description, const char* out_help, const Study& study,
    problem::CaseFileTimeSectionPolicy time_section = problem::CaseFileTimeSectionPolicy::refused) {
  OneCaseReportCommand report(call);
  report.common.time_section = time_section;
  base::Values values = description.values(Options{});
  auto own = make_command_line_options(description, values);
  own.add(make_figure_options(report.common.figures));
  if (!report.parse_command_arguments(usage, own, out_help)) return kSuccess;
  const Options options = description.read(values, "options");
  complete_arguments(options, report.common);
  return report.compute_and_write_report([&](const problem::Problem& problem, const auto& show) {
    return study(problem, options, show);
  });
}

}  // namespace

int spectrum_command(const CommandInvocation& call) {
  return run_functional(call, kSpectrumUsage, study::spectrum_option_descriptions(),
                        "write spectrum.json, .csv and a figure to DIR (default: no files)",
                        study::study_spectrum);
}

int sensitivity_command(const CommandInvocation& call) {
  return run_functional(call, kSensitivityUsage, study::sensitivity_option_descriptions(),
                        "write sensitivity.json, .csv and a figure to DIR (default: no files)",
                        study::study_sensitivity);
}

bool requests_density_over_time(const CommandInvocation& call) {
  return std::ranges::any_of(call.arguments, [](const std::string& argument) {
    return argument == "--until" || argument.starts_with("--until=");
  });
}

int density_over_time_command(const CommandInvocation& call) {
  return run_functional(
      call, kOverTimeUsage, study::transient_comparison_option_descriptions(),
      "write over_time.html, .json, .csv, .nc and a figure to DIR (default: no files)",
      study::compare_over_time, problem::CaseFileTimeSectionPolicy::allowed);
}

int passage_command(const CommandInvocation& call) {
  return run_functional(call, kPassageUsage, study::passage_option_descriptions(),
                        "write passage.json, .csv and a figure to DIR (default: no files)",
                        study::study_passage);
}

}  // namespace fpkcheck::cli
