#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/names.hpp"
#include "transform/marginal.hpp"

/// The paper whose method this project checks (*Stochastic response of a vibro-impact Duffing system
/// under external Poisson impulses*): what its sections 3 and 4 state of its four cases, and what a
/// run says of each statement. It writes EPC (n = 2), (n = 4), (n = 6) for its closure, here
/// epc-gaussian-n2, -n4, -n6, and MCS for a simulation.
namespace fpkcheck::paper {

/// What is said to hold between a closure and the simulation.
enum class Relation {
  agrees,
  agrees_in_tail,
  differs,
  differs_in_tail,
  closer,
  closer_in_l1,
  closer_in_tail,
  further_than_in_case_1,
  is_linearisation,
  not_found
};
/// As written in files, and what must be measured for it to be established (workflows/paper/criteria.hpp).
inline constexpr base::Named<Relation> kRelationNames[] = {
    {Relation::agrees, "agrees", "L1 and tail are both within what counts as agreement"},
    {Relation::agrees_in_tail, "agrees_in_tail", "the tail is within what counts as agreement"},
    {Relation::differs, "differs", "L1 or tail is beyond what counts as agreement"},
    {Relation::differs_in_tail, "differs_in_tail", "the tail is beyond what counts as agreement"},
    {Relation::closer, "closer", "L1 and tail are both smaller than those of the rival"},
    {Relation::closer_in_l1, "closer_in_l1", "L1 is smaller than that of the rival"},
    {Relation::closer_in_tail, "closer_in_tail", "the tail is smaller than that of the rival"},
    {Relation::further_than_in_case_1, "further_than_in_case_1", "L1 is larger than in case 1"},
    {Relation::is_linearisation, "is_linearisation",
     "L1 to the Gaussian of equivalent linearisation is 0 but for rounding"},
    {Relation::not_found, "not_found",
     "plain Newton steps from equivalent linearisation find no root"}};
constexpr std::span<const base::Named<Relation>> names(Relation) { return kRelationNames; }
constexpr std::string_view name(Relation relation) { return base::name_of(relation); }

/// One statement of the paper that numbers can decide.
struct Claim {
  std::vector<int> cases;                      ///< of its Table 1; of several, all must comply
  std::string panels;                          ///< of the case's figure: "ab"; empty for the text
  std::vector<transform::Variable> variables;  ///< likewise, all of them
  int order;                                   ///< n of the closure
  Relation relation;
  int rival;          ///< n of the other closure, where the relation has one, else 0
  std::string quote;  ///< the paper's words; [..] is ours

  /// The figure that shows a case, 2 .. 5.
  static int figure(int number) { return number + 1; }
};

/// All of them, by cases, in the order of the paper's text.
const std::vector<Claim>& claims();

/// "n=6 agrees with MCS in p(y)".
std::string words(const Claim& claim);

/// The id of the paper's closure of this order.
std::string closure_id(int order);

/// What a run needs for all of them to be judged, as Registry::select reads it.
inline constexpr const char* kMethods =
    "epc-gaussian-n2,epc-gaussian-n4,epc-gaussian-n6,epc-gaussian-n8,fd-kf,mcs";
/// The paper's cases, as problem/named_cases.hpp has them.
std::string case_name(int number);

}  // namespace fpkcheck::paper
