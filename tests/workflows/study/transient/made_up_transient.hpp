#pragma once

#include "paper_cases.hpp"
#include "workflows/study/transient/report_over_time.hpp"

namespace fpkcheck::tests {

/// Five times on a grid of 4 x 6 cells, with distinguishable numbers.
inline study::TransientRun made_up_transient(int last = 4) {
  study::TransientRun run{"fpkcheck fd it's --until 2", make_problem(), {}, {}, {}};
  run.problem.name = "it's a_{case}";
  run.transient.until = 2;
  run.transient.snapshots = last;
  auto& result = run.result;
  result.status = transform::Status::ok;
  result.start_displacement = 0.5;
  result.start_velocity = 0.25;
  result.y_edges = {0, 0.5, 1, 2, 3};
  result.v_edges = {-3, -2, -1, 0, 1, 2, 3};
  for (int n = 0; n <= last; ++n) {
    fd_fpk::DensitySnapshot s{.time = 2.0 * n / last, .mass = 1};
    s.moments.y2 = 10 + n;
    for (int b = 0; b < 4; ++b) s.y.push_back(1.0 / (1 + b + n));
    for (int b = 0; b < 6; ++b) s.v.push_back(0.1 * b + 0.01 * n);
    result.snapshots.push_back(s);
  }
  return run;
}

}  // namespace fpkcheck::tests
