#include <cstdio>
#include <fpkcheck/problem/case_file.hpp>

int main() {
  const auto problem = fpkcheck::problem::load_case("case1");
  std::printf("r = %g\n", problem.system.restitution());
  return problem.system.restitution() == 0.98 ? 0 : 1;
}
