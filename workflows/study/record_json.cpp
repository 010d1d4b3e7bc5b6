#include <nlohmann/json.hpp>
#include <utility>

#include "results/json.hpp"
#include "results/run_json.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {
namespace {

using results::Json;

void add(const Record& record, Json& object) {
  transform::MetricBuilder values;
  for (const auto& [path, value] : record) values.add_result(path, value);
  results::add_metrics(std::move(values).take_metrics(), object);
}

}  // namespace

std::string study_json(const std::string& study, const problem::Problem& problem,
                       const std::string& command, const Record& itself,
                       const std::vector<std::pair<std::string, std::vector<Record>>>& lists) {
  Json json{{"schema", results::kSummarySchema},
            {"program", results::program_json(results::this_program(command))},
            {"study", study}};
  json.update(results::problem_json(problem));
  add(itself, json);
  for (const auto& [name, rows] : lists) {
    json[name] = Json::array();
    for (const auto& row : rows) add(row, json[name].emplace_back(Json::object()));
  }
  return results::json_text(results::with_null_for_non_finite(json));
}

}  // namespace fpkcheck::study
