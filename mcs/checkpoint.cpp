#include "mcs/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "problem/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::string_view kFirstLine = "fpkcheck mcs checkpoint 1\n";

/// FNV-1a.
std::uint64_t checksum(std::string_view text) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return sum;
}

}  // namespace

std::string fingerprint(const problem::Problem& problem, const Plan& plan,
                        const Splitting* splitting) {
  const auto& s = problem.system;
  const Excitation& e = plan.excitation;
  std::string text = fmt::format(
      "system {:a} {:a} {:a} {:a}; excitation {} {:a} {} {:a} {:a}; seed {}; streams {}; step {:a}; "
      "burn-in {:a}; sampling {:a} {}; y {:a}; v {:a}",
      s.damping(), s.stiffness(), s.cubic(), s.restitution(), static_cast<int>(e.arrivals),
      e.interval, static_cast<int>(e.law), e.mean, e.width, plan.seed, plan.streams, plan.step,
      plan.burn_in, plan.sampling_interval, plan.samples_per_round,
      fmt::join(plan.y_bins.edges(), " "), fmt::join(plan.v_bins.edges(), " "));
  if (splitting) text += fmt::format("; thresholds {:a}", fmt::join(splitting->thresholds(), " "));
  return text;
}

void write_checkpoint(const std::string& path, const std::string& fingerprint,
                      const Simulation& simulation) {
  std::ostringstream contents;
  contents << kFirstLine << fingerprint << '\n';
  simulation.save(contents);
  const std::string text = std::move(contents).str();
  const std::uint64_t sum = checksum(text);
  const std::string beside = path + ".part";
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.write(reinterpret_cast<const char*>(&sum), sizeof sum);
    out.flush();
    if (!out) {
      throw InputError(
          fmt::format("cannot write the checkpoint {} (is there such a directory, "
                      "writable and with space?)",
                      beside));
    }
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error) {
    throw InputError(fmt::format("cannot write the checkpoint {} ({})", path, error.message()));
  }
}

void read_checkpoint(const std::string& path, const std::string& fingerprint,
                     Simulation& simulation) {
  std::ifstream file(path, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(path)) {
    throw InputError(
        fmt::format("cannot read the checkpoint {} (there is no such file) name one that "
                    "--checkpoint has written",
                    path));
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!text.starts_with(kFirstLine)) {
    throw InputError(fmt::format("{} is no checkpoint of this version of fpkcheck mcs", path));
  }
  std::uint64_t sum = 0;
  const std::size_t size = text.size() - sizeof sum;
  if (text.size() > kFirstLine.size() + sizeof sum) std::memcpy(&sum, &text[size], sizeof sum);
  const std::string_view contents(text.data(), size);
  if (sum != checksum(contents)) {
    throw InputError(fmt::format(
        "the checkpoint {} is damaged (its checksum is wrong): start again without --resume",
        path));
  }
  const std::string_view rest = contents.substr(kFirstLine.size());
  const std::size_t end = rest.find('\n');
  if (rest.substr(0, end) != fingerprint) {
    throw InputError(
        fmt::format("the checkpoint {} belongs to another simulation (give the case, "
                    "seed and options that it was made with)",
                    path));
  }
  std::istringstream in{std::string(rest.substr(end + 1))};
  try {
    simulation.load(in);
  } catch (const InputError& error) {
    throw InputError(fmt::format("the checkpoint {} is damaged: {}", path, error.what()));
  }
}

}  // namespace fpkcheck::mcs
