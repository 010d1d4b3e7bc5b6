#pragma once

#include <string>
#include <vector>

#include "modified_case.hpp"
#include "page/made_up_page.hpp"

namespace fpkcheck::tests {

/// The whole case with copies of epc-gaussian-n6 as external densities from files: family "chi"
/// with these orders; the first copy is not ok.
inline results::CaseResult case_with_external_family(const std::vector<int>& orders) {
  const auto known = whole_case();
  auto problem = known.problem;
  const auto axes = compare::comparison_bins(problem);
  auto solutions = made_up_solutions(axes);
  for (auto& solution : solutions) {
    if (solution.id() == "fd-kf") solution.error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5, .moments = {}};
  }
  std::vector<transform::Solution> all;
  for (const int order : orders) {
    transform::Solution guest = solutions[0];
    guest.identity.id = "chi-n" + std::to_string(order);
    guest.identity.method = transform::kExternalFile;
    guest.identity.formulation.clear();
    guest.identity.order = order;
    guest.identity.family = "chi";
    guest.identity.plot_style.colour = "#DC050C";
    guest.identity.plot_style.symbol = "pentagon";
    if (all.empty()) {
      guest.status = transform::Status::inaccurate;
      guest.reason = "it is too far off";
    }
    all.push_back(std::move(guest));
  }
  all.insert(all.end(), solutions.begin(), solutions.end());
  return results::make_case_result(problem, axes, std::move(all));
}

}  // namespace fpkcheck::tests
