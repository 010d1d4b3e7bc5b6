#include "workflows/paper/claims.hpp"

#include <fmt/format.h>

namespace fpkcheck::paper {
namespace {

using transform::StateVariable;

const std::vector<StateVariable> kY{StateVariable::y}, kYdot{StateVariable::ydot},
    kBoth{kY[0], kYdot[0]};
const std::vector<int> kAll{1, 2, 3, 4}, kCase1{1}, kCase2{2}, kCase3{3}, kCase4{4};

constexpr const char* kOrderEightQuote =
    "the conventional Newton-Raphson method solving Eq. (23) becomes non-convergent for EPC "
    "(n = 8) in the four examined cases";
constexpr const char* kLessGaussianQuote =
    "It is expected that the PDF solutions of the response become more non-Gaussian when these "
    "parameters increase in their magnitudes.";
constexpr const char* kConclusionQuote =
    "the PDFs obtained with the proposed solution procedure agree well with the simulated results "
    "when the polynomial order equals six. The tail region of the PDF is also approximated well "
    "for both displacement and velocity.";

std::string marginal_density_names(const PaperClaim& claim) {
  if (claim.variables.size() > 1) return "both densities";
  return claim.variables.front() == StateVariable::y ? "p(y)" : "p(y')";
}

}  // namespace

// Each table row of the paper's claims has the cases, panels, variables, closure order n, relation,
// order of the rival closure, and quotation of a claim.
const std::vector<PaperClaim>& paper_claims() {
  using enum PaperClaimRelation;
  static const std::vector<PaperClaim> all{
      // Claims in section 3.1 of the paper
      {kAll, "abcd", kBoth, 2, is_linearisation, 0,
       "EPC (n = 2) is the same as that given by equivalent linearization method in the case of "
       "Gaussian white noise."},
      {kCase1, "ab", kY, 2, agrees, 0,
       "Both EPC (n = 2) and EPC (n = 6) are close to MCS showing that the PDF distribution of "
       "displacement is almost Gaussian."},
      {kCase1, "ab", kY, 6, agrees, 0, "Both EPC (n = 2) and EPC (n = 6) are close to MCS"},
      {kCase1, "b", kY, 4, differs_in_tail, 0,
       "EPC (n = 4) differs a lot from the simulation in the tail as shown in Fig. 2b."},
      {kCase1, "cd", kYdot, 6, agrees, 0,
       "in the case of velocity as shown in Fig. 2c, d, EPC (n = 6) agrees well with MCS"},
      {kCase1, "cd", kYdot, 2, differs, 0,
       "they [n = 6 and MCS] differ significantly from EPC (n = 2) (denoting a Gaussian PDF)"},
      {kCase1, "cd", kYdot, 4, differs, 0,
       "EPC (n = 4) differs from the simulation result unlike EPC (n = 2) and EPC (n = 6)."},
      {kCase1, "", {}, 8, not_found, 0, kOrderEightQuote},
      // Claims in section 3.2 of the paper
      {kCase2, "ab", kY, 2, differs, 0,
       "EPC (n = 2) differs significantly from the simulated result showing that the PDF of "
       "displacement becomes non-Gaussian due to the increase in excitation intensity."},
      {kCase2, "ab", kY, 4, closer, 2,
       "Compared with EPC (n = 2), EPC (n = 4) provides an improved result for the PDF of "
       "displacement"},
      {kCase2, "b", kY, 4, differs_in_tail, 0,
       "but it [n = 4] still differs a lot from the simulation result as shown in Fig. 3b"},
      {kCase2, "ab", kY, 6, agrees, 0, "EPC (n = 6) coincides well with the simulated result"},
      {kCase2, "b", kY, 6, agrees_in_tail, 0, "especially in the tail region as shown in Fig. 3b"},
      {kCase2, "cd", kYdot, 2, differs, 0, "EPC (n = 2) and EPC (n = 4) are different from MCS"},
      {kCase2, "cd", kYdot, 4, differs, 0, "EPC (n = 2) and EPC (n = 4) are different from MCS"},
      {kCase2, "cd", kYdot, 6, agrees, 0,
       "whereas EPC (n = 6) agrees well with the simulated result"},
      {kCase2, "", kY, 2, further_than_in_case_1, 0, kLessGaussianQuote},
      {kCase2, "", kYdot, 2, further_than_in_case_1, 0, kLessGaussianQuote},
      {kCase2, "", {}, 8, not_found, 0, kOrderEightQuote},
      // Claims in section 3.3 of the paper
      {kCase3, "ab", kY, 2, differs, 0,
       "Compared with Case 1, EPC (n = 2) departs from the simulated result due to the increase in "
       "the nonlinearity coefficient."},
      {kCase3, "ab", kY, 4, closer, 2,
       "Similar to Case 2, EPC (n = 4) gave a better result compared to EPC (n = 2)."},
      {kCase3, "ab", kY, 6, agrees, 0, "EPC (n = 6) agrees well with the simulated result."},
      {kCase3, "cd", kYdot, 2, differs, 0,
       "the PDF distribution of velocity is non-Gaussian because EPC (n = 2) differs from the "
       "simulated result"},
      {kCase3, "cd", kYdot, 6, agrees, 0,
       "EPC (n = 6) is in good agreement with the simulated result"},
      {kCase3, "cd", kYdot, 6, closer, 2, "which is better than EPC (n = 2) and EPC (n = 4)"},
      {kCase3, "cd", kYdot, 6, closer, 4, "which is better than EPC (n = 2) and EPC (n = 4)"},
      {kCase3, "", kY, 2, further_than_in_case_1, 0, kLessGaussianQuote},
      {kCase3, "", kYdot, 2, further_than_in_case_1, 0, kLessGaussianQuote},
      {kCase3, "", {}, 8, not_found, 0, kOrderEightQuote},
      // Claims in section 3.4 of the paper
      {kCase4, "ab", kY, 2, differs, 0,
       "the simulated result differs a lot from EPC (n = 2) (i.e., a Gaussian PDF) in the case of "
       "displacement"},
      {kCase4, "ab", kY, 4, agrees, 0,
       "both EPC (n = 4) and EPC (n = 6) can present a satisfactory PDF solution compared with the "
       "simulated result"},
      {kCase4, "ab", kY, 6, agrees, 0,
       "both EPC (n = 4) and EPC (n = 6) can present a satisfactory PDF solution compared with the "
       "simulated result"},
      {kCase4, "b", kY, 4, agrees_in_tail, 0, "[n = 4 and n = 6] especially in the tail region"},
      {kCase4, "b", kY, 6, agrees_in_tail, 0, "[n = 4 and n = 6] especially in the tail region"},
      {kCase4, "cd", kYdot, 2, differs, 0, "EPC (n = 2) differs from MCS"},
      {kCase4, "cd", kYdot, 4, agrees, 0,
       "EPC (n = 4) and EPC (n = 6) agree well with the simulated result"},
      {kCase4, "cd", kYdot, 6, agrees, 0,
       "EPC (n = 4) and EPC (n = 6) agree well with the simulated result"},
      {kCase4, "a", kY, 6, closer_in_l1, 4,
       "EPC (n = 6) is more accurate than EPC (n = 4) as shown in Fig. 5a, d"},
      {kCase4, "d", kYdot, 6, closer_in_tail, 4,
       "EPC (n = 6) is more accurate than EPC (n = 4) as shown in Fig. 5a, d"},
      {kCase4, "", kY, 2, further_than_in_case_1, 0, kLessGaussianQuote},
      {kCase4, "", kYdot, 2, further_than_in_case_1, 0, kLessGaussianQuote},
      {kCase4, "", {}, 8, not_found, 0, kOrderEightQuote},
      // Claims in section 4 of the paper
      {kAll, "ab", kY, 6, agrees, 0, kConclusionQuote},
      {kAll, "cd", kYdot, 6, agrees, 0, kConclusionQuote},
  };
  return all;
}

std::string claim_text(const PaperClaim& claim) {
  return fmt::format(fmt::runtime(base::meaning_of(claim.relation)), fmt::arg("n", claim.order),
                     fmt::arg("rival", claim.rival),
                     fmt::arg("p", claim.variables.empty() ? "" : marginal_density_names(claim)));
}

std::string paper_closure_id(int order) { return fmt::format("epc-gaussian-n{}", order); }

std::string paper_case_name(int case_number) { return fmt::format("case{}", case_number); }

}  // namespace fpkcheck::paper
