#include "workflows/study/regularisation.hpp"

namespace fpkcheck::study {

RegularisationStudy study_regularisation(const problem::Problem& problem,
                                         const methods::ProgressListener& listener) {
  const auto progress = [&](int row, int rows) {
    if (!listener) return;
    listener({.done = static_cast<std::size_t>(row),
              .total = static_cast<std::size_t>(rows),
              .case_name = problem.name,
              .method = "regularisation",
              .fraction = 0});
  };
  return add_growth_rates(problem, fd_fpk::study_regularisation(problem, {}, progress));
}

RegularisationStudy add_growth_rates(const problem::Problem& problem,
                                     const fd_fpk::RegularisationStudy& fd_study) {
  RegularisationStudy study{problem, fd_study.default_length, fd_study.shortest_length, {}};
  for (const auto& row : fd_study.rows) {
    const bool symbol_grows = row.symbol && is_unstable(*row.symbol, problem.impulses);
    study.rows.push_back({row, symbol_grows, row.growth_rate(problem)});
  }
  return study;
}

bool has_converged(const RegularisationStudy& study) {
  const RegularisationRow* finest = nullptr;
  for (const auto& row : study.rows) {
    if (row.scheme == "regularised") finest = &row;
  }
  return finest != nullptr && !finest->growth_rate && finest->l1_y;
}

}  // namespace fpkcheck::study
