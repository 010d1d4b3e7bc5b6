#include "results/saved_run.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <boost/crc.hpp>
#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/files/file_transaction.hpp"
#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "results/joint_netcdf.hpp"
#include "results/marginals_csv.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;
using base::in_quotes;
using base::to_printable_text;

// Largest accepted size of a text file of a saved run, which suffices for hundreds of cases.
constexpr std::size_t kMaxTextBytes = 64 << 20;

std::istringstream open_saved_file(const fs::path& file) {
  auto text = base::read_input_file(file, kMaxTextBytes);
  if (!text) {
    if (!file.has_parent_path()) {
      throw InputError(
          fmt::format("{} is not a readable file; give the summary.json of a run, or its directory",
                      to_printable_text(file.string())));
    }
    throw InputError(fmt::format(
        "no run in {}: {} is not a readable file; give the --out directory of a run",
        in_quotes(file.parent_path().string()), to_printable_text(file.filename().string())));
  }
  return std::istringstream(*std::move(text));
}

[[noreturn]] void refuse_other_run(const fs::path& file) {
  throw InputError(fmt::format(
      "{} and {} in {} are not of the same run, or were changed; run again", kSummaryFile,
      to_printable_text(file.filename().string()), in_quotes(file.parent_path().string())));
}

CaseResult* find_case(Run& run, const std::string& name) {
  const auto found = std::ranges::find(run.cases, name, &CaseResult::name);
  return found == run.cases.end() ? nullptr : &*found;
}

// Throws InputError if the checksum of a file differs from the checksum in the summary of the run.
// Runs of older program versions have no checksums.
void require_same_run(const fs::path& file, std::string_view contents, const Run& run) {
  const auto recorded = std::ranges::find(run.files, file.filename().string(), &FileChecksum::file);
  if (recorded != run.files.end() && recorded->crc32 != crc32_hex(contents)) refuse_other_run(file);
}

void read_curves(const fs::path& file, Run& run, std::vector<DensityCurve> CaseResult::*curves) {
  auto csv = open_saved_file(file);
  require_same_run(file, csv.view(), run);
  // Simulated trajectories may overflow. A simulation with an overflow has the status `failed`, and
  // its density may be infinite or NaN. The density of a solution with the status `ok` is finite.
  const auto allows_non_finite = [&run](const std::string& case_name, const std::string& solution) {
    const CaseResult* case_result = find_case(run, case_name);
    const auto* found = case_result == nullptr ? nullptr : case_result->find(solution);
    return found != nullptr && !found->has_status_ok();
  };
  for (auto& [case_name, curve] : read_marginals_csv(csv, file.string(), allows_non_finite)) {
    CaseResult* case_result = find_case(run, case_name);
    if (case_result == nullptr || case_result->find(curve.solution) == nullptr)
      refuse_other_run(file);
    (case_result->*curves).push_back(std::move(curve));
  }
}

// Returns whether exactly the solutions with a density have marginal density curves.
bool has_matching_curves(const CaseResult& case_result) {
  std::set<std::string> with_curves, with_density;
  for (const auto& curve : case_result.curves) with_curves.insert(curve.solution);
  for (const auto& solution : case_result.solutions) {
    if (solution.has_density()) with_density.insert(solution.id());
  }
  return with_curves == with_density;
}

template <class Element>
bool has_any_element(const Run& run, std::vector<Element> CaseResult::*list) {
  return std::ranges::any_of(
      run.cases, [&](const CaseResult& case_result) { return !(case_result.*list).empty(); });
}

class ChecksummedFiles {
 public:
  ChecksummedFiles(base::FileTransaction& files, const fs::path& directory)
      : files_(files), directory_(directory) {}

  void add(const char* name, const std::string& bytes) {
    files_.add(directory_ / name, bytes);
    checksums_.push_back({name, crc32_hex(bytes)});
  }
  void remove(const char* name) { files_.remove(directory_ / name); }
  void add_summary(const Run& run) {
    files_.add(directory_ / kSummaryFile, run_summary_text(run, checksums_) + '\n');
  }

 private:
  base::FileTransaction& files_;
  const fs::path& directory_;
  std::vector<FileChecksum> checksums_;
};

void add_curve_files(ChecksummedFiles& saved, const Run& run) {
  std::ostringstream csv, smooth;
  write_marginals_csv(csv, run.cases);
  saved.add(kMarginalsFile, csv.str());
  if (has_any_element(run, &CaseResult::smooth)) {
    write_marginals_csv(smooth, run.cases, &CaseResult::smooth);
    saved.add(kSmoothMarginalsFile, smooth.str());
  } else {
    saved.remove(kSmoothMarginalsFile);
  }
}

void load_joint_densities(const fs::path& file, Run& run) {
  const auto owner = [&](const std::string& case_name, const std::string& solution) -> CaseResult& {
    CaseResult* case_result = find_case(run, case_name);
    const auto* found = case_result == nullptr ? nullptr : case_result->find(solution);
    if (found == nullptr || !found->has_density()) refuse_other_run(file);
    return *case_result;
  };
  auto [joints, sources] =
      read_joint_netcdf(file, [&](std::string_view bytes) { require_same_run(file, bytes, run); });
  for (auto& [case_name, joint] : joints) {
    CaseResult& case_result = owner(case_name, joint.solution);
    case_result.joints.push_back(std::move(joint));
  }
  for (auto& [case_name, source] : sources) {
    CaseResult& case_result = owner(case_name, source.solution);
    const auto& cells = source.density;
    if (case_result.joints.empty() || case_result.joints.front().density.y_edges != cells.y_edges ||
        case_result.joints.front().density.v_edges != cells.v_edges) {
      refuse_other_run(file);
    }
    case_result.error_sources.push_back(std::move(source));
  }
}

}  // namespace

void add_summary_and_curves(base::FileTransaction& files, const fs::path& directory,
                            const Run& run) {
  ChecksummedFiles saved(files, directory);
  add_curve_files(saved, run);
  saved.add_summary(run);
}

void add_run_files(base::FileTransaction& files, const fs::path& directory, const Run& run) {
  ChecksummedFiles saved(files, directory);
  add_curve_files(saved, run);
  if (has_any_element(run, &CaseResult::joints)) {
    saved.add(kJointFile, joint_netcdf_bytes(run));
  } else {
    saved.remove(kJointFile);
  }
  saved.add_summary(run);
}

Run load_run_summary(const fs::path& file) {
  base::recover_interrupted_commit(file.parent_path());
  auto in = open_saved_file(file);
  return read_run_summary(in, to_printable_text(file.string()));
}

void load_marginal_curves(const fs::path& file, Run& run) {
  read_curves(file, run, &CaseResult::curves);
  if (!std::ranges::all_of(run.cases, has_matching_curves)) refuse_other_run(file);
}

Run load_run(const fs::path& directory) {
  Run run = load_run_summary(directory / kSummaryFile);
  load_marginal_curves(directory / kMarginalsFile, run);
  if (const auto smooth = directory / kSmoothMarginalsFile; fs::exists(smooth)) {
    read_curves(smooth, run, &CaseResult::smooth);  // a solution may lack curves over smooth bins
  }
  if (fs::exists(directory / kJointFile)) load_joint_densities(directory / kJointFile, run);
  return run;
}

std::string crc32_hex(std::string_view bytes) {
  boost::crc_32_type crc;
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, bytes.find('\r'));
    crc.process_bytes(part.data(), part.size());
    bytes.remove_prefix(std::min(part.size() + 1, bytes.size()));
  }
  return fmt::format("{:08x}", crc.checksum());
}

std::vector<std::pair<std::string, std::string>> library_versions() {
  // An example of the version text of netCDF is "4.9.0 of Oct 15 2022 22:59:31 $".
  const std::string netcdf = nc_inq_libvers();
  return {{"netCDF", netcdf.substr(0, netcdf.find(' '))},
          {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                        NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

}  // namespace fpkcheck::results
