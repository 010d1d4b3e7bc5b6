#include "workflows/paper/claims_supplement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "results/json_conversions.hpp"
#include "results/marginals_csv.hpp"
#include "results/run_json.hpp"
#include "workflows/paper/claim_criteria.hpp"
#include "workflows/paper/claims_table.hpp"

namespace fpkcheck::paper {
namespace {

using results::Json;

std::vector<std::string> variable_names(const PaperClaim& claim) {
  std::vector<std::string> names;
  for (const auto variable : claim.variables) names.emplace_back(transform::name(variable));
  return names;
}

std::string csv_number_text(const std::optional<double>& number) {
  return number ? fmt::format("{:.6g}", *number) : "";
}

std::string csv_limit_text(const PaperClaimMeasurement& of) {
  return of.limit ? fmt::format("{} {:.6g}", of.above ? ">" : "<=", *of.limit) : "";
}

Json measured_number_json(const PaperClaimMeasurement& of) {
  Json json{{"value", results::number_or_null_json(of.value)}};
  json["wanted"] = of.limit ? Json{{of.above ? "above" : "at_most", *of.limit}} : Json();
  return json;
}

Json claim_judgement_json(const PaperClaimJudgement& judgement) {
  const PaperClaim& claim = judgement.claim;
  Json figures = Json::array();
  for (const int number : claim.cases) {
    if (!claim.panels.empty()) figures.push_back(PaperClaim::figure_number(number));
  }
  return {{"cases", claim.cases},
          {"figures", figures},
          {"panels", claim.panels},
          {"claim", claim_text(claim)},
          {"quote", claim.quote},
          {"solution", paper_closure_id(claim.order)},
          {"variables", variable_names(claim)},
          {"relation", name(claim.relation)},
          {"rival", claim.rival == 0 ? Json() : Json(paper_closure_id(claim.rival))},
          {"l1", measured_number_json(judgement.l1)},
          {"tail", measured_number_json(judgement.tail)},
          {"status", judgement.status ? Json(name(*judgement.status)) : Json()},
          {"reason", judgement.reason},
          {"outcome", name(judgement.outcome)},
          {"note", judgement.note}};
}

void add_claims(std::span<const PaperClaimJudgement> judgements, Json& json) {
  json["criteria"] = {{"agreement_l1", kMaxL1OfClaimedAgreement},
                      {"agreement_in_tail", kMaxTailDistanceOfClaimedAgreement},
                      {"same_gaussian_l1", kMaxL1BetweenEqualGaussians}};
  Json& all = json["claims"] = Json::array();
  for (const auto& judgement : judgements) all.push_back(claim_judgement_json(judgement));
}

}  // namespace

std::string claims_csv(std::span<const PaperClaimJudgement> judgements) {
  std::string text =
      "case,figure,claim,n,density,relation,rival,l1,l1_wanted,tail,tail_wanted,status,outcome,note,"
      "quote\n";
  for (const auto& judgement : judgements) {
    const PaperClaim& claim = judgement.claim;
    const std::string fields[] = {claim_cases_text(claim),
                                  claim_figure_text(claim),
                                  claim_text(claim),
                                  fmt::format("{}", claim.order),
                                  fmt::format("{}", fmt::join(variable_names(claim), " ")),
                                  std::string(name(claim.relation)),
                                  claim.rival == 0 ? "" : fmt::format("{}", claim.rival),
                                  csv_number_text(judgement.l1.value),
                                  csv_limit_text(judgement.l1),
                                  csv_number_text(judgement.tail.value),
                                  csv_limit_text(judgement.tail),
                                  judgement.status ? std::string(name(*judgement.status)) : "",
                                  std::string(name(judgement.outcome)),
                                  judgement.note,
                                  claim.quote};
    std::vector<std::string> quoted;
    for (const auto& field : fields) quoted.push_back(results::quote_csv_field(field));
    text += fmt::format("{}\n", fmt::join(quoted, ","));
  }
  return text;
}

std::string claims_json(std::span<const PaperClaimJudgement> judgements,
                        const results::ProgramInfo& program) {
  Json json{{"schema", results::kSummarySchema}, {"program", results::program_to_json(program)}};
  add_claims(judgements, json);
  return results::serialise_json(results::replace_non_finite_by_null(json));
}

std::string summary_json_with_claims(std::span<const PaperClaimJudgement> judgements,
                                     const results::Run& run) {
  Json json = Json::parse(results::run_summary_text(run));
  add_claims(judgements, json);
  return results::serialise_json(results::replace_non_finite_by_null(json));
}

}  // namespace fpkcheck::paper
