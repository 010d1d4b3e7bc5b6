// Fuzzer of external joint densities, on a grid or as a closed form, and their values.
#include <algorithm>
#include <sstream>

#include "epc/closed_form_density.hpp"
#include "fuzz_helpers.hpp"
#include "methods/external/density_file.hpp"
#include "methods/external/joint_table.hpp"
#include "methods/external/range_between_walls.hpp"
#include "problem/case_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  static const problem::Problem problem = problem::load_case("case1");
  static const methods::DensityQuadratureGrid points(compare::comparison_bins(problem),
                                                     problem.system.walls());
  return fuzz::catch_input_errors([&] {
    const std::string text(fuzz::as_text(data, size));
    if (text.starts_with('{')) {
      const auto file = methods::read_closed_form_file(text, "given.json", {});
      const auto density =
          epc::density_of_closed_form(file.form, file.problem ? &*file.problem : &problem);
      density.value(0.5, -0.1);
      return;
    }
    std::istringstream csv(text);
    const auto table = methods::read_number_table(csv, "given.csv");
    if (!methods::is_joint_density(table)) return;
    const auto values =
        methods::evaluate_at_quadrature_points(methods::make_joint_table(table), points);
    fuzz::require(values.size() == points.y_points().size() * points.v_points().size());
  });
}
