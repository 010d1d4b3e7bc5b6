#include "epc/options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/input_error.hpp"

namespace fpkcheck::epc {
namespace {

using namespace base;

Range order_range(Formulation formulation) {
  return even_between(2, greatest_order(formulation))
      .because("an odd one cannot fall in every direction, and rounding shows in higher ones");
}

void require_order(const Options& options) {
  const Range range = order_range(options.formulation);
  if (range.holds(options.order)) return;
  throw InputError(fmt::format("epc order = {} (must be {})", options.order, range.allowed));
}

void require_equation(const Options& options) {
  const Equation equation = equation_of(options);
  switch (options.formulation) {
    case Formulation::gaussian:
      if (equation != Equation::km4_pade) return;
      throw InputError(fmt::format(
          "epc equation = {} (the formulation gaussian has the series as it is cut, not the "
          "approximant) use white, km4 or kf",
          name(equation)));
    case Formulation::moment:
      if (equation == Equation::kf || equation == Equation::white) return;
      throw InputError(fmt::format(
          "epc equation = {} (the moment equations of the formulation moment are those of a "
          "process, and no process belongs to the series cut after the fourth derivative) use kf "
          "or white",
          name(equation)));
    case Formulation::polar:
      if (equation == Equation::kf) return;
      throw InputError(fmt::format(
          "epc equation = {} (the formulation polar follows the jumps of the process itself: its "
          "angles have no second derivative in the mean) use kf",
          name(equation)));
  }
}

// What stands between "epc-" and "-nN".
std::string variant(const Options& options) {
  std::string text(name(options.formulation));
  if (options.formulation == Formulation::moment && options.tail == Tail::cut) text += "-cut";
  const Equation equation = equation_of(options);
  if (equation != usual_equation(options.formulation)) {
    text += fmt::format("-{}", name(equation));
  }
  return text;
}

}  // namespace

const Description<Options>& description() {
  using O = Options;
  static const auto description =
      Description<O>("epc ")
          .add("order", &O::order,
               {"N", "degree n of the polynomial, even: 2 .. 12; of moment 2 .. 16"},
               order_range(Formulation::moment))
          .add("formulation", &O::formulation, {"F", "gaussian, moment or polar, see above"})
          .add("monomials", &O::monomials,
               {"SET",
                "of gaussian: point_symmetric (default): even total degrees, all that survive; "
                "general: every degree"})
          .add("equation", &O::equation,
               {"E",
                "km4: the paper's series cut after the fourth derivative (gaussian's default); kf: "
                "the full jump integral (default of moment and polar); white: white noise"})
          .with_choices({"white", "km4", "kf"})
          .add("tail", &O::tail,
               {"T",
                "of moment: confined (default): a steep fixed term holds the exponent down where "
                "Q_n cannot be trusted; cut: Q_n alone, zero beyond"})
          .add("tolerance", &O::tolerance, {"TOL", "on the size of the residual"},
               positive().because("no iteration ends otherwise"))
          .without_flag()
          .add(
              "accuracy", &O::accuracy,
              {"L1",
               "largest stated error of p(y) and of p(y') that is ok, in L1 (in a run: 0.02 of closures, "
               "0.01 of fd)"},
              positive().because("no closure is exact"))
          .with_fallback({})
          .add("max_seconds", &O::max_seconds,
               {"S", "of moment and polar: after so long no further way to a root is begun"},
               positive())
          .with_fallback(Options{}.max_seconds)
          .add("max_iterations", &O::max_iterations, {"N", "most steps of Newton's method"},
               positive().because("no step would be taken otherwise"))
          .without_flag();
  return description;
}

void validate(const Options& options) {
  require_order(options);
  description().validate(options);
  require_equation(options);
  if (options.formulation != Formulation::moment && options.tail != Tail::confined) {
    throw InputError(fmt::format("epc tail = {} (the formulation {} has no choice) leave it out",
                                 name(options.tail), name(options.formulation)));
  }
  if (options.formulation != Formulation::gaussian &&
      options.monomials != MonomialSet::point_symmetric) {
    throw InputError(
        fmt::format("epc monomials = {} (the formulation {} takes all of them) leave it out",
                    name(options.monomials), name(options.formulation)));
  }
}

int greatest_order(Formulation formulation) { return formulation == Formulation::moment ? 16 : 12; }

Equation usual_equation(Formulation formulation) {
  return formulation == Formulation::gaussian ? Equation::km4 : Equation::kf;
}

Equation equation_of(const Options& options) {
  return options.equation.value_or(usual_equation(options.formulation));
}

std::string id(const Options& options) {
  return fmt::format("epc-{}-n{}", variant(options), options.order);
}

std::optional<Options> options_of(std::string_view id) {
  constexpr std::string_view kOrder = "-n";
  const auto mark = id.rfind(kOrder);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view stem = id.substr(0, mark), digits = id.substr(mark + kOrder.size());
  int order = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), order);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  for (const auto& formulation : kFormulationNames) {
    for (const auto& tail : kTailNames) {
      for (const auto& equation : problem::kEquationNames) {
        Options options{.order = order, .formulation = formulation.value, .tail = tail.value};
        if (equation.value != usual_equation(formulation.value)) options.equation = equation.value;
        if (stem == "epc-" + variant(options)) return options;
      }
    }
  }
  return std::nullopt;
}

transform::Identity identity(const Options& options) {
  return {.id = id(options),
          .method = "epc",
          .formulation = variant(options),
          .order = options.order,
          .equation = equation_of(options),
          .impact = options.formulation == Formulation::gaussian ? Impact::delta : Impact::map,
          .role = transform::Role::closure};
}

}  // namespace fpkcheck::epc
