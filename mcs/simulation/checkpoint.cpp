#include "mcs/simulation/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/files/atomic_file.hpp"
#include "base/files/file_transaction.hpp"
#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/printable_text.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::string_view kFormatPrefix = "fpkcheck mcs checkpoint ";

std::uint64_t checksum_of_text(std::string_view text) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return sum;
}

std::string write_failure_message(const std::string& path, const std::string& why) {
  return fmt::format("cannot write the checkpoint {}: {}", base::to_printable_text(path), why);
}

constexpr const char* kUnwritableReason =
    "the directory is missing, write-protected or full; check it";

/// @return error message, or an empty string after success
std::string write_checkpoint(const std::string& path, const std::string& fingerprint,
                             const Simulation& simulation) {
  std::ostringstream contents;
  contents << kCheckpointFormatLine << fingerprint << '\n';
  simulation.save_state(contents);
  std::string text = std::move(contents).str();
  const std::uint64_t sum = checksum_of_text(text);
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  try {
    const base::ProcessExitBlocker in_hand;
    base::write_file_atomically(path, text);
    return "";
  } catch (const std::runtime_error&) {
    return write_failure_message(path, kUnwritableReason);
  }
}

bool is_checkpoint(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(kFormatPrefix.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kFormatPrefix;
}

}  // namespace

std::string simulation_fingerprint(const problem::Problem& problem, const SimulationPlan& plan,
                                   const ImportanceSplitting* splitting) {
  const SimulatedOscillator& o = plan.oscillator;
  const ImpulseProcess& e = plan.excitation;
  std::string force = fmt::format("force {:a}", fmt::join(o.force, " "));
  if (problem.system.has_polynomial_force()) {
    force += fmt::format("; damping {:a}",
                         fmt::join(problem.system.damping_polynomial().coefficients(), " "));
  } else {
    force += fmt::format(" + {}", problem.system.force_formula().formula_text());
  }
  for (const auto& [name, value] : problem.system.named_constants())
    force += fmt::format("; {} {:a}", name, value);
  std::string text = fmt::format(
      "{} {:a}; kicks {:a} {:a}; excitation {} {:a} {} {:a} {:a}; seed {}; "
      "streams {}; step {:a}; burn-in {:a}; sampling {:a} {}; y {:a}; v {:a}",
      force, o.rayleigh, plan.kicks.diffusion, plan.kicks.longest_interval,
      static_cast<int>(e.arrivals), e.interval, e.law, e.mean, e.width, plan.seed, plan.streams,
      plan.step, plan.burn_in, plan.sampling_interval, plan.samples_per_round,
      fmt::join(plan.y_bins.edges(), " "), fmt::join(plan.v_bins.edges(), " "));
  if (problem.noise_factor) {
    text += fmt::format("; factor {}", problem.noise_factor->formula_text());
    if (problem.noise.interpretation) {
      text += fmt::format(" {}", base::name_of(*problem.noise.interpretation));
    }
  }
  if (problem.impulse_factor) {
    text += fmt::format("; impulse factor {}", problem.impulse_factor->formula().formula_text());
  }
  for (const SimulatedWall& w : {o.left, o.right}) {
    text += fmt::format("; wall {} {:a} {:a}", w.exists, w.position, w.restitution);
    if (w.formula != nullptr) text += " " + w.formula->restitution_formula->formula_text();
  }
  if (e.pieces) text += fmt::format("; pieces {:x}", e.pieces->checksum());
  if (plan.deposit) {
    const SampleDepositionGrid& g = plan.deposit->grid;
    text += fmt::format("; deposit {:a}; {:a}; {:a} {:a} {}; {:a} {:a} {}; {:a} {:a} {}",
                        fmt::join(g.y_knots, " "), fmt::join(g.v_knots, " "), g.lattice_begin,
                        g.lattice_spacing, g.lattice_points, g.y_bins.first, g.y_bins.spacing,
                        g.y_bins.count, g.v_bins.first, g.v_bins.spacing, g.v_bins.count);
    for (const auto& [velocity_change, probability] : g.velocity_jumps)
      text += fmt::format(" {:a} {:a}", velocity_change, probability);
  }
  if (splitting) text += fmt::format("; thresholds {:a}", fmt::join(splitting->thresholds(), " "));
  return text;
}

CheckpointWriter::CheckpointWriter(std::string path, std::function<void(const std::string&)> warn)
    : path_(std::move(path)), warn_(std::move(warn)) {
  if (path_.empty()) return;
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto there = fs::status(path_, ignored);
  if (fs::is_directory(there))
    throw InputError(write_failure_message(path_, "it is a directory; name a file"));
  // A checkpoint must not overwrite a device, or a case file whose name was given by mistake.
  if (fs::exists(there) && !(fs::is_regular_file(there) && is_checkpoint(path_))) {
    throw InputError(write_failure_message(
        path_, "the file is no checkpoint and would be lost; name another file"));
  }
  try {
    const base::ProcessExitBlocker in_hand;
    const fs::path probe = base::partial_file_path(path_);
    base::write_new_file(probe, kCheckpointFormatLine);
    fs::remove(probe);
  } catch (const std::system_error&) {
    throw InputError(write_failure_message(path_, kUnwritableReason));
  }
}

void CheckpointWriter::try_write_checkpoint(const std::string& fingerprint,
                                            const Simulation& simulation) {
  written_ = Clock::now();
  failure_ = write_checkpoint(path_, fingerprint, simulation);
}

void CheckpointWriter::write_checkpoint_now(const std::string& fingerprint,
                                            const Simulation& simulation) {
  if (path_.empty()) return;
  const bool failed_before = !failure_.empty();
  try_write_checkpoint(fingerprint, simulation);
  if (!failure_.empty() && !failed_before) {
    warn_(failure_ + ". The simulation continues and retries every half minute");
  }
}

void CheckpointWriter::write_checkpoint_when_due(const std::string& fingerprint,
                                                 const Simulation& simulation) {
  constexpr std::chrono::seconds kBetweenCheckpoints(30);
  if (Clock::now() - written_ > kBetweenCheckpoints) write_checkpoint_now(fingerprint, simulation);
}

void CheckpointWriter::write_final_checkpoint(const std::string& fingerprint,
                                              const Simulation& simulation) {
  if (path_.empty()) return;
  try_write_checkpoint(fingerprint, simulation);
  if (!failure_.empty()) {
    warn_(failure_ + ". The result is valid, but no run can resume from its end");
  }
}

void read_checkpoint(const std::string& path, const std::string& fingerprint,
                     Simulation& simulation) {
  // Upper limit of the size of a checkpoint file, sufficient for the largest number of streams, the
  // finest deposit grids and the finest bins.
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  const auto read = base::read_input_file(path, kMostBytes);
  const std::string name = base::to_printable_text(path);
  if (!read) {
    throw InputError(
        fmt::format("cannot read the checkpoint {}: no such file; name a file that --checkpoint "
                    "wrote",
                    name));
  }
  const std::string& text = *read;
  if (!text.starts_with(kCheckpointFormatLine)) {
    throw InputError(fmt::format(
        "{} is no checkpoint of this version of fpkcheck mcs: its first line differs; start "
        "without --resume",
        name));
  }
  std::uint64_t sum = 0;
  const std::size_t size = text.size() - sizeof sum;
  if (text.size() > kCheckpointFormatLine.size() + sizeof sum)
    std::memcpy(&sum, &text[size], sizeof sum);
  const std::string_view contents(text.data(), size);
  if (sum != checksum_of_text(contents)) {
    throw InputError(
        fmt::format("the checkpoint {} is damaged: wrong checksum; start without --resume", name));
  }
  const std::string_view rest = contents.substr(kCheckpointFormatLine.size());
  const std::size_t end = rest.find('\n');
  if (rest.substr(0, end) != fingerprint) {
    throw InputError(
        fmt::format("the checkpoint {} belongs to another simulation: case, seed or options "
                    "differ; use those of the checkpoint",
                    name));
  }
  std::istringstream in{std::string(rest.substr(end + 1))};
  try {
    simulation.load_state(in);
  } catch (const InputError& error) {
    throw InputError(fmt::format("the checkpoint {} is damaged: {}; start without --resume", name,
                                 error.what()));
  }
}

}  // namespace fpkcheck::mcs
