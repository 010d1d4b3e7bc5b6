#include <fmt/format.h>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/solve_and_report.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck epc CASE ... [options]

Exponential-polynomial closure: p(z, z') = C exp(Q_n(z, z')), the coefficients of Q_n from
the weak equations (23) of the paper. The status says what the result is worth:
  ok             the equations are met by a density that has decayed on the whole edge of its
                 support
  inadmissible   the equations are met, but not by such a density (condition (19) of the paper)
  not_converged  the equations are not met

examples:
  fpkcheck epc case1 --order 6
  fpkcheck epc case2 --order 8 --json
)";

epc::MonomialSet monomial_set(const std::string& name) {
  if (name == "point_symmetric") return epc::MonomialSet::point_symmetric;
  if (name == "general") return epc::MonomialSet::general;
  throw InputError(fmt::format("--monomials {} (use point_symmetric or general)", name));
}

epc::Formulation formulation(const std::string& name) {
  if (name == "gaussian") return epc::Formulation::gaussian;
  throw InputError(fmt::format("--formulation {} (use gaussian)", name));
}

epc::Equation equation(const std::string& name) {
  if (name == "km4") return epc::Equation::km4;
  if (name == "white") return epc::Equation::white;
  throw InputError(fmt::format("--equation {} (the closure solves km4 or white)", name));
}

}  // namespace

int epc_command(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  CommonArguments common;
  epc::Options options;
  std::string formulation_name, equation_name, set_name;
  po::options_description own;
  own.add_options()  //
      ("order", po::value(&options.order)->value_name("N")->default_value(options.order),
       "degree n of the polynomial, even")(
          "formulation", po::value(&formulation_name)->value_name("F")->default_value("gaussian"),
          "gaussian: the paper's, projections under Gaussian weights")(
          "equation", po::value(&equation_name)->value_name("E")->default_value("km4"),
          "km4: the paper's series cut after the fourth derivative; white: white noise")(
          "monomials", po::value(&set_name)->value_name("SET")->default_value("point_symmetric"),
          "point_symmetric: even total degrees, all that survive; general: every degree");
  if (!parse(arguments, kUsage, with_common_options(own, common), common.cases)) return 0;
  options.formulation = formulation(formulation_name);
  options.equation = equation(equation_name);
  options.monomials = monomial_set(set_name);
  return solve_and_report(common, {compare::epc_method(options)}, 0, Required::all, command_line);
}

}  // namespace fpkcheck::cli
