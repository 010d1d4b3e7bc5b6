#include <fmt/format.h>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/solve_and_report.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck epc CASE ... [options]

Exponential-polynomial closure: a density C exp(Q_n), Q_n a polynomial of degree n, from weak
equations. Three formulations:
  gaussian   the paper's: p(z, z') on the whole plane, projections (23) under Gaussian weights;
             series cut after the fourth derivative, impact as a delta function. Where Newton's
             method finds no root, the branch of solutions from the exact density of white noise
             at r = 1 is followed past its folds (summary.json has it)
  moment     p(y, y') on y >= 0, exact moment equations of the impact process itself
  polar      the same with Q_n a polynomial of amplitude and phase, which carries the jump that an
             impact with losses leaves at the origin
The status says what the result is worth:
  ok             the equations are met by a density that has decayed on the whole edge of its
                 support (gaussian: and keeps the balance of power, and is near that of order n-2)
  inadmissible   the equations are met, but not by such a density (condition (19) of the paper),
                 or by a spurious one
  not_converged  the equations are not met (gaussian with kf: or depend on the disc on which the
                 jump integral is taken)

examples:
  fpkcheck epc case1 --order 6
  fpkcheck epc case1 case4 --formulation moment --order 8
  fpkcheck epc case2 --order 8 --json
  fpkcheck epc case2 --order 8 --equation kf
)";

epc::MonomialSet monomial_set(const std::string& name) {
  if (name == "point_symmetric") return epc::MonomialSet::point_symmetric;
  if (name == "general") return epc::MonomialSet::general;
  throw InputError(fmt::format("--monomials {} (use point_symmetric or general)", name));
}

epc::Formulation formulation(const std::string& name) {
  if (name == "gaussian") return epc::Formulation::gaussian;
  if (name == "moment") return epc::Formulation::moment;
  if (name == "polar") return epc::Formulation::polar;
  throw InputError(fmt::format("--formulation {} (use gaussian, moment or polar)", name));
}

epc::Equation equation(const std::string& name) {
  for (const auto equation : {epc::Equation::white, epc::Equation::km4, epc::Equation::kf}) {
    if (name == epc::name(equation)) return equation;
  }
  throw InputError(fmt::format("--equation {} (use white, km4 or kf)", name));
}

epc::moment::Tail tail(const std::string& name) {
  if (name == "confined") return epc::moment::Tail::confined;
  if (name == "cut") return epc::moment::Tail::cut;
  throw InputError(fmt::format("--tail {} (use confined or cut)", name));
}

}  // namespace

int epc_command(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  CommonArguments common;
  epc::Options options;
  std::string formulation_name, equation_name, set_name, tail_name;
  po::options_description own;
  own.add_options()  //
      ("order", po::value(&options.order)->value_name("N")->default_value(options.order),
       "degree n of the polynomial, even: 2 .. 12; of moment 2 .. 16")(
          "formulation", po::value(&formulation_name)->value_name("F")->default_value("gaussian"),
          "gaussian, moment or polar, see above")(
          "equation", po::value(&equation_name)->value_name("E"),
          "km4: the paper's series cut after the fourth derivative (gaussian's default); kf: the "
          "full jump integral (default of moment and polar); white: white noise")(
          "monomials", po::value(&set_name)->value_name("SET"),
          "of gaussian: point_symmetric (default): even total degrees, all that survive; general: "
          "every degree")(
          "tail", po::value(&tail_name)->value_name("T"),
          "of moment: confined (default): a steep fixed term holds the exponent down where Q_n cannot be "
          "trusted; cut: Q_n alone, zero beyond");
  if (!parse(arguments, kUsage, with_common_options(own, common), common.cases)) return 0;
  options.formulation = formulation(formulation_name);
  const bool gaussian = options.formulation == epc::Formulation::gaussian;
  if (equation_name.empty()) equation_name = gaussian ? "km4" : "kf";
  options.equation = equation(equation_name);
  if (!tail_name.empty()) {
    if (options.formulation != epc::Formulation::moment) {
      throw InputError(fmt::format("--tail with --formulation {} (it has no choice) leave it out",
                                   formulation_name));
    }
    options.tail = tail(tail_name);
  }
  if (!set_name.empty()) {
    if (options.formulation != epc::Formulation::gaussian) {
      throw InputError(
          fmt::format("--monomials with --formulation {} (it takes all of them) leave "
                      "it out",
                      formulation_name));
    }
    options.monomials = monomial_set(set_name);
  }
  return solve_and_report(common, {compare::epc_method(options)}, 0, Required::all, command_line);
}

}  // namespace fpkcheck::cli
