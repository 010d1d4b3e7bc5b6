#include "compare/check/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>

#include "compare/check/figures.hpp"
#include "compare/summary.hpp"
#include "compare/summary_view.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A solution from a file cannot be solved again: it goes, with its distances and curves.
void leave_out(SavedRun& run, Json& one_case, const std::string& id) {
  const auto erase = [](Json& list, const auto& unwanted) {
    Json kept = Json::array();
    for (const Json& element : list) {
      if (!unwanted(element)) kept.push_back(element);
    }
    list = std::move(kept);
  };
  erase(one_case.at("solutions"), [&](const Json& s) { return s.at("id") == id; });
  erase(one_case.at("comparisons"),
        [&](const Json& pair) { return pair.at("a") == id || pair.at("b") == id; });
  std::erase_if(run.marginals, [&](const MarginalCurve& curve) {
    return one_case.at("name") == curve.case_name && curve.solution == id;
  });
}

// A simulation is judged by its own errors: without them, or cut short, it is no baseline.
void require_whole_simulation(const Json& solution) {
  if (solution.value("interrupted", false)) {
    throw InputError("the simulation was interrupted (run again, to its end)");
  }
  if (solution.at("moments").is_null()) return;
  const auto require_positive = [](const Json& value, const std::string& name) {
    if (value.is_number() && value.get<double>() > 0) return;
    throw InputError(fmt::format("{} = {} (must be a positive number: run again, and longer)", name,
                                 value.dump()));
  };
  for (const char* list : {"standard_errors", "sampling_l1"}) {
    for (const auto& [key, value] : solution.at(list).items()) {
      require_positive(value, fmt::format("{}.{}", list, key));
    }
  }
  for (const char* key : {"effective_samples", "effective_samples_y2"}) {
    require_positive(solution.at(key), key);
  }
}

// The methods of a case, and the solutions that have none.
std::pair<CaseAgain, std::vector<std::string>> plan(const Json& one_case, int threads) {
  const auto name = one_case.at("name").get<std::string>();
  std::pair<CaseAgain, std::vector<std::string>> result{{problem_from_json(one_case), {}}, {}};
  std::set<std::string> ids;
  for (const Json& solution : one_case.at("solutions")) {
    const auto id = solution.at("id").get<std::string>();
    if (!ids.insert(id).second) throw InputError(id + " is there twice (run again)");
    try {
      if (auto method = saved_method(solution, threads)) {
        if (is_simulation(solution)) require_whole_simulation(solution);
        result.first.methods.push_back(std::move(*method));
      } else {
        result.second.push_back(id);
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", id, error.what()));
    }
  }
  return result;
}

void plan_all(Baseline& baseline, int threads) {
  std::set<std::string> names;
  for (Json& one_case : baseline.run.summary.at("cases")) {
    const auto name = one_case.at("name").get<std::string>();
    if (!names.insert(name).second) throw InputError(name + " is there twice (run again)");
    try {
      auto [again, not_ours] = plan(one_case, threads);
      for (const auto& id : not_ours) {
        leave_out(baseline.run, one_case, id);
        baseline.notes.push_back(fmt::format(
            "{} {} was read from a file: it is not solved again and not compared.", name, id));
      }
      baseline.cases.push_back(std::move(again));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", name, error.what()));
    }
  }
}

}  // namespace

Baseline load_baseline(const fs::path& place, int threads) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(place, ignored) ? place / kSummaryFile : place;
  Baseline baseline{{load_summary(file), {}}, false, {}, {}};
  const fs::path curves = file.parent_path() / kMarginalsFile;
  if (std::ifstream csv(curves); csv.is_open()) {
    baseline.run.marginals = read_marginals_csv(csv, curves.string());
    baseline.has_marginals = true;
  } else {
    baseline.notes.push_back(fmt::format(
        "There is no {} beside the baseline: the curves are not compared.", kMarginalsFile));
  }
  try {
    if (baseline.has_marginals && !marginals_belong(baseline.run)) {
      throw InputError(fmt::format("{} beside it is of another run (run again, or take it away)",
                                   kMarginalsFile));
    }
    plan_all(baseline, threads);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{} is not a whole summary ({}; run again)", file.string(), said_by(error)));
  }
  if (std::ranges::all_of(baseline.cases, [](const auto& one) { return one.methods.empty(); })) {
    throw InputError(fmt::format("{} has no solution that can be solved again", file.string()));
  }
  return baseline;
}

SavedRun run_again(const Baseline& baseline, const std::string& command, int threads,
                   const ProgressListener& listener) {
  std::size_t total = 0, before = 0;
  for (const auto& one : baseline.cases) total += one.methods.size();
  std::vector<CaseReport> reports;
  // Case by case, since each may have been solved by other methods.
  for (const auto& [problem, methods] : baseline.cases) {
    auto report = run_cases({problem}, methods, threads, [&](RunProgress at) {
      at.done += before;
      at.total = total;
      if (listener) listener(at);
    });
    reports.push_back(std::move(report.front()));
    before += methods.size();
  }
  return make_run(command, reports);
}

}  // namespace fpkcheck::compare
