#include "methods/external/density_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "results/json_conversions.hpp"
#include "results/netcdf/reader.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::methods {

DensityFileContent read_density_file(const std::filesystem::path& file) {
  constexpr std::size_t kMaxBytes = std::size_t{256} << 20, kMaxTextBytes = std::size_t{32} << 20;
  auto bytes = base::read_input_file(file, kMaxBytes);
  if (!bytes) {
    throw InputError(fmt::format("{} is not a readable file; give a file with a density",
                                 base::in_quotes(file.string())));
  }
  if (bytes->starts_with(results::kNetCdfMagic))
    return {DensityFileFormat::netcdf, *std::move(bytes)};
  const std::string name = base::to_printable_text(file.string());
  if (bytes->starts_with("CDF")) {
    throw InputError(fmt::format(
        "{} has the classic netCDF format; convert it to netCDF-4 by nccopy -k nc4", name));
  }
  if (bytes->find('\0') != std::string::npos) {
    throw InputError(fmt::format("{} is binary (must be columns of text, JSON or netCDF-4)", name));
  }
  if (bytes->size() > kMaxTextBytes) {
    throw InputError(
        fmt::format("{} has more than {} bytes; give a coarser density", name, kMaxTextBytes));
  }
  const auto first = bytes->find_first_not_of(" \t\r\n");
  const bool json =
      first != std::string::npos && (bytes->at(first) == '{' || bytes->at(first) == '[');
  return {json ? DensityFileFormat::json : DensityFileFormat::text, *std::move(bytes)};
}

namespace {

epc::ClosedFormDensity to_closed_form(const transform::Metrics& metrics,
                                      const std::string& file_name) {
  try {
    return epc::read_closed_form(metrics);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file_name, error.what()));
  }
}

ClosedFormDensityFile closed_form_of_run(const results::Run& run, const std::string& file_name,
                                         const SavedSolutionSelection& choice) {
  std::vector<std::string> cases;
  for (const auto& case_result : run.cases) cases.push_back(case_result.name());
  auto requested = choice.case_name;
  if (!requested && std::ranges::find(cases, choice.default_case) != cases.end()) {
    requested = choice.default_case;
  }
  const auto& case_result = run.cases[index_of_requested_name(cases, requested, "case", file_name)];

  std::vector<std::string> with_form;
  for (const auto& solution : case_result.solutions) {
    if (epc::has_closed_form(solution.metrics)) with_form.push_back(solution.id());
  }
  if (choice.solution && case_result.find(*choice.solution) != nullptr &&
      std::ranges::find(with_form, *choice.solution) == with_form.end()) {
    throw InputError(
        fmt::format("{}: {} has no closed form in {}{}", file_name,
                    base::in_quotes(*choice.solution), case_result.name(),
                    with_form.empty() ? "" : fmt::format("; use {}", fmt::join(with_form, ", "))));
  }
  const std::string of_case =
      fmt::format("{}, {}", file_name, base::to_printable_text(case_result.name()));
  const auto& solution = *case_result.find(
      with_form[index_of_requested_name(with_form, choice.solution, "solution", of_case)]);
  return {to_closed_form(solution.metrics, fmt::format("{}: {}", file_name, solution.id())),
          case_result.problem, solution};
}

}  // namespace

std::size_t index_of_requested_name(const std::vector<std::string>& names,
                                    const std::optional<std::string>& requested,
                                    const std::string& item_kind, const std::string& file_name) {
  if (names.empty()) {
    throw InputError(
        fmt::format("{} contains no {} with a density of this kind", file_name, item_kind));
  }
  std::vector<std::string> known;
  for (const auto& name : names) known.push_back(base::to_printable_text(name));
  if (!requested) {
    if (names.size() == 1) return 0;
    throw InputError(fmt::format("{} contains {} {}s; select one by {}=: {}", file_name,
                                 names.size(), item_kind, item_kind, fmt::join(known, ", ")));
  }
  const auto found = std::ranges::find(names, *requested);
  if (found == names.end()) {
    throw InputError(fmt::format("{} contains no {} {}; use {}", file_name, item_kind,
                                 base::in_quotes(*requested), fmt::join(known, ", ")));
  }
  return static_cast<std::size_t>(found - names.begin());
}

ClosedFormDensityFile read_closed_form_file(const std::string& text, const std::string& file_name,
                                            const SavedSolutionSelection& choice) {
  if (results::is_run_summary(text, file_name)) {
    std::istringstream in(text);
    return closed_form_of_run(results::read_run_summary(in, file_name), file_name, choice);
  }
  if (choice.solution || choice.case_name) {
    throw InputError(fmt::format("{} contains a single closed form; omit the key {}", file_name,
                                 choice.solution ? "solution" : "case"));
  }
  return {to_closed_form(results::metrics_from_external_json(text, file_name), file_name), {}, {}};
}

}  // namespace fpkcheck::methods
