#include "compare/report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include "compare/figure/pictures.hpp"
#include "compare/joint_netcdf.hpp"
#include "compare/page/page.hpp"
#include "compare/run_directory.hpp"
#include "compare/summary.hpp"
#include "compare/summary_view.hpp"
#include "compare/table.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kJointFile = "joint.nc";
constexpr const char* kPageFile = "report.html";

std::ifstream open_saved(const fs::path& file) {
  std::error_code ignored;
  std::ifstream in;
  if (fs::is_regular_file(file, ignored)) in.open(file);
  if (!in.is_open()) {
    if (!file.has_parent_path()) {
      throw InputError(fmt::format(
          "{} is not a readable file (give the summary.json of a run, or its directory)",
          file.string()));
    }
    throw InputError(
        fmt::format("no run in '{}' ({} is not a readable file; give the --out of a run)",
                    file.parent_path().string(), file.filename().string()));
  }
  return in;
}

}  // namespace

Json load_summary(const fs::path& file) {
  auto in = open_saved(file);
  Json json;
  try {
    json = Json::parse(in);
  } catch (const Json::parse_error& error) {
    throw InputError(
        fmt::format("{} is not JSON (at byte {}; run again)", file.string(), error.byte));
  }
  if (!json.is_object() || !json.contains("schema")) {
    throw InputError(
        fmt::format("{} is not the summary of a run (it has no schema)", file.string()));
  }
  if (json["schema"] != kSummarySchema) {
    throw InputError(fmt::format("{} has schema {} (this program reads schema {}; run again)",
                                 file.string(), json["schema"].dump(), kSummarySchema));
  }
  return json;
}

namespace {

// The summary of the run that was saved there; nothing where there is none of ours: then the
// pictures are not ours either.
std::optional<Json> earlier_summary(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(directory / kSummaryFile, ignored)) return std::nullopt;
  try {
    return load_summary(directory / kSummaryFile);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void remove_pictures_of(const Json& earlier, const fs::path& directory) {
  try {
    remove_pictures(directory, earlier);
  } catch (const Json::exception&) {
    // Not a whole summary: the pictures it does not name stay.
  }
}

using CaseAndSolution = std::pair<std::string, std::string>;

std::set<CaseAndSolution> solutions_with_density(const Json& summary) {
  std::set<CaseAndSolution> found;
  for (const auto& one : summary.at("cases")) {
    for (const auto& solution : one.at("solutions")) {
      if (!solution.at("mass").is_null()) found.emplace(one.at("name"), solution.at("id"));
    }
  }
  return found;
}

// A simulation may have no joint density, and an older run has none.
void require_belonging(const SavedRun& run, const fs::path& directory) {
  if (!marginals_belong(run)) {
    throw InputError(fmt::format("{} and {} in '{}' are not of the same run (run again)",
                                 kSummaryFile, kMarginalsFile, directory.string()));
  }
  const auto in_summary = solutions_with_density(run.summary);
  for (const auto& joint : run.joints) {
    if (!in_summary.contains({joint.case_name, joint.solution})) {
      throw InputError(fmt::format("{} and {} in '{}' are not of the same run (run again)",
                                   kSummaryFile, kJointFile, directory.string()));
    }
  }
}

}  // namespace

bool marginals_belong(const SavedRun& run) {
  std::set<CaseAndSolution> with_curves;
  for (const auto& curve : run.marginals) with_curves.emplace(curve.case_name, curve.solution);
  return with_curves == solutions_with_density(run.summary);
}

SavedRun make_run(const std::string& command, std::span<const CaseReport> cases) {
  return {summary(command, cases), marginal_curves(cases), joint_densities(cases)};
}

std::string json_text(const Json& summary) {
  return summary.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::vector<std::string> write_report(const fs::path& directory, const SavedRun& run) {
  const auto earlier = earlier_summary(directory);
  PendingFiles files;
  std::ostringstream csv;
  write_marginals_csv(csv, run.marginals);
  files.add(directory / kMarginalsFile, csv.str());
  if (run.joints.empty()) {
    files.remove(directory / kJointFile);
  } else {
    add_joint_netcdf(files, directory / kJointFile, run.summary, run.joints);
  }
  files.add(directory / kSummaryFile, json_text(run.summary) + '\n');
  files.add(directory / kPageFile, report_page(run));
  files.commit();
  if (earlier) remove_pictures_of(*earlier, directory);
  return draw_pictures(directory, run.summary, run.marginals);
}

SavedRun load_run(const fs::path& directory) {
  SavedRun run{load_summary(directory / kSummaryFile), {}, {}};
  auto csv = open_saved(directory / kMarginalsFile);
  run.marginals = read_marginals_csv(csv, (directory / kMarginalsFile).string());
  const fs::path joint = directory / kJointFile;
  if (fs::exists(joint)) run.joints = read_joint_netcdf(joint);
  return run;
}

ReportAgain report_again(const fs::path& directory, const TextFormat& format) {
  const SavedRun run = load_run(directory);
  try {
    require_belonging(run, directory);
    // Both before anything is written: a summary that lacks something is found out by then.
    const std::string page = report_page(run);
    ReportAgain again{table(run.summary, format), {}};
    write_file(directory / kPageFile, page);
    again.warnings = draw_pictures(directory, run.summary, run.marginals);
    return again;
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{} is not a whole summary ({}; run again)",
                                 (directory / kSummaryFile).string(), said_by(error)));
  }
}

}  // namespace fpkcheck::compare
