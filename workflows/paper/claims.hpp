#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "transform/marginal_density.hpp"

/// Claims of the paper *Stochastic response of a vibro-impact Duffing system under external Poisson
/// impulses*, whose method this project checks. The claims concern the four cases in sections 3 and
/// 4 of the paper. The paper's EPC (n = 2), (n = 4), (n = 6) are the closures epc-gaussian-n2, -n4,
/// -n6. The paper's MCS is a Monte Carlo simulation.
namespace fpkcheck::paper {

/// Relation between a closure and the Monte Carlo simulation that a claim of the paper states.
enum class PaperClaimRelation {
  agrees,                  ///< L1 and tail are both within the limits of agreement
  agrees_in_tail,          ///< the tail is within the limit of agreement
  differs,                 ///< L1 or tail exceeds the limit of agreement
  differs_in_tail,         ///< the tail exceeds the limit of agreement
  closer,                  ///< L1 and tail are both smaller than those of the rival
  closer_in_l1,            ///< L1 is smaller than that of the rival
  closer_in_tail,          ///< the tail is smaller than that of the rival
  further_than_in_case_1,  ///< L1 is larger than in case 1
  is_linearisation,        ///< L1 to the Gaussian of equivalent linearisation is 0 up to rounding
  not_found                ///< plain Newton steps from equivalent linearisation find no root
};
/// Name in files of each relation between a closure and the simulation, and the text of a claim
/// with this relation.
inline constexpr base::EnumEntry<PaperClaimRelation> kRelationNames[] = {
    {PaperClaimRelation::agrees, "agrees", "n={n} agrees with MCS in {p}"},
    {PaperClaimRelation::agrees_in_tail, "agrees_in_tail", "n={n} agrees in the tail of {p}"},
    {PaperClaimRelation::differs, "differs", "n={n} differs from MCS in {p}"},
    {PaperClaimRelation::differs_in_tail, "differs_in_tail", "n={n} differs in the tail of {p}"},
    {PaperClaimRelation::closer, "closer", "n={n} is better than n={rival} in {p}"},
    {PaperClaimRelation::closer_in_l1, "closer_in_l1", "n={n} is better than n={rival} in {p}, L1"},
    {PaperClaimRelation::closer_in_tail, "closer_in_tail",
     "n={n} is better than n={rival} in {p}, tail"},
    {PaperClaimRelation::further_than_in_case_1, "further_than_in_case_1",
     "{p} is less Gaussian than in case 1"},
    {PaperClaimRelation::is_linearisation, "is_linearisation", "n={n} is equivalent linearisation"},
    {PaperClaimRelation::not_found, "not_found", "n={n} is not found by Newton's method"}};
constexpr const auto& enumerator_names(PaperClaimRelation) { return kRelationNames; }
constexpr std::string_view name(PaperClaimRelation relation) { return base::name_of(relation); }

/// A statement of the paper that measured numbers can support or contradict.
struct PaperClaim {
  /// Numbers of the cases in the paper's Table 1 to which a claim refers; the claim must hold in
  /// every listed case.
  std::vector<int> cases;
  /// Panels of the paper's figure that show the claim, e.g. "ab"; empty if no figure shows the
  /// claim.
  std::string panels;
  /// Variables (displacement, velocity) for each of which the claim of the paper must hold.
  std::vector<transform::StateVariable> variables;
  int order;  ///< order n of the closure
  PaperClaimRelation relation;
  int rival;          ///< order n of a second closure with which the relation compares; 0 if none
  std::string quote;  ///< quotation from the paper, with additions in [..]

  /// Returns the number (2 .. 5) of the paper's figure that shows a case.
  static int figure_number(int case_number) { return case_number + 1; }
};

/// Returns all claims of the paper, sorted by case, then in the order of the paper's text.
const std::vector<PaperClaim>& paper_claims();

/// Returns the text of a claim, e.g. "n=6 agrees with MCS in p(y)".
std::string claim_text(const PaperClaim& claim);

std::string paper_closure_id(int order);

/// Methods that are required to judge all claims, in the syntax of
/// SolverRegistry::methods_selected_by_list.
inline constexpr const char* kRequiredMethods =
    "epc-gaussian-n2,epc-gaussian-n4,epc-gaussian-n6,epc-gaussian-n8,fd-kf,mcs";
/// Returns the name of a case of the paper: "case1" .. "case4".
std::string paper_case_name(int case_number);

}  // namespace fpkcheck::paper
