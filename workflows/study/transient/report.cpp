#include "workflows/study/transient/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/figure/drawing.hpp"
#include "report/table.hpp"
#include "report/text/wrap_text.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::study {
namespace {

namespace fs = std::filesystem;
using fd_fpk::Snapshot;
using report::wrap_text;

constexpr const char* kFile = "transient.nc";

// Replaces a value that rounds to 0 in five digits by 0, so that the text is not "-0.00000".
double without_negative_zero(double value) {
  constexpr double kHalfADigit = 5e-6;
  return std::abs(value) < kHalfADigit ? 0 : value;
}

std::string row(const Snapshot& s) {
  const auto& m = s.moments;
  return fmt::format("{:>8.4g} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.5f} {:>8.1e} {:>8.1e}\n",
                     s.time, without_negative_zero(m.y1), m.y2, without_negative_zero(m.v1), m.v2,
                     without_negative_zero(s.energy), s.mass - 1, s.power_residual);
}

}  // namespace

std::string transient_table(const TransientRun& run, std::size_t width) {
  constexpr std::size_t kMaxRows = 24;
  const auto& result = run.result;
  std::string text = wrap_text(report::case_title(run.problem), width);
  text += wrap_text(
      fmt::format("{}/{} from a Gaussian about ({:.4g}, {:.4g}) of deviations {:.4g} (y) and "
                  "{:.4g} (y')",
                  problem::name(run.options.equation), problem::name(run.options.impact),
                  result.start_mean_displacement, result.start_mean_velocity,
                  result.start_displacement, result.start_velocity),
      width);
  const std::size_t last = result.snapshots.empty() ? 0 : result.snapshots.size() - 1;
  const std::size_t stride = last / kMaxRows + 1;
  if (!result.snapshots.empty()) {
    text += fmt::format("{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "t", "E[y]", "E[y^2]",
                        "E[y']", "E[y'^2]", "energy", "mass - 1", "power");
    for (std::size_t n = 0; n < last; n += stride) text += row(result.snapshots[n]);
    text += row(result.snapshots[last]);
  }
  if (result.status != transform::Status::ok) {
    text +=
        wrap_text(fmt::format("  {}: {}", transform::name(result.status), result.reason), width, 4);
  }
  if (!result.snapshots.empty()) {
    text += wrap_text(
        fmt::format(
            "power: residual of the balance of power, relative to D + lambda E[Y^2]/2. {} x {} "
            "cells, {} steps, {} factorisations{}.",
            result.y_edges.size() - 1, result.v_edges.size() - 1, result.steps,
            result.factorisations,
            stride == 1 ? "" : fmt::format("; one of {} snapshots is shown", stride)),
        width);
  }
  return text;
}

std::string transient_picture_stem(const std::string& case_name) {
  return "transient-" + results::file_stem(case_name);
}

std::vector<std::string> write_transient(const fs::path& directory, const TransientRun& run,
                                         const report::FigureOptions& options,
                                         const std::string& gnuplot) {
  const fs::path figures = directory / "figures";
  const std::string stem = transient_picture_stem(run.problem.name);
  report::remove_script_and_pictures(figures, stem);
  if (run.result.snapshots.empty()) {
    std::error_code ignored;
    fs::remove(directory / kFile, ignored);
    return {fmt::format("no {}: no time has a density", kFile)};
  }
  write_transient_netcdf(directory / kFile, run);
  if (run.result.snapshots.size() < 2) return {"no picture: only t = 0 has a density"};
  return report::write_pictures(figures, stem,
                                report::figure_script(transient_figure(run), stem, options.width),
                                options, gnuplot);
}

}  // namespace fpkcheck::study
