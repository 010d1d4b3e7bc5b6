#include "epc/options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/input_error.hpp"

namespace fpkcheck::epc {
namespace {

using namespace base;

AdmissibleRange allowed_orders(Formulation formulation) {
  return even_integers_between(2, max_closure_order(formulation))
      .with_reason_in_message(
          "a polynomial of odd degree rises in some direction; rounding limits the order");
}

void require_order(const ClosureOptions& options) {
  const AdmissibleRange range = allowed_orders(options.formulation);
  if (range.contains(options.order)) return;
  throw InputError(fmt::format("epc order = {} (must be {})", options.order, range.requirement));
}

void require_equation(const ClosureOptions& options) {
  const DensityEquation equation = closure_density_equation(options);
  switch (options.formulation) {
    case Formulation::gaussian:
      if (equation != DensityEquation::km4_pade) return;
      throw InputError(fmt::format(
          "epc equation = {}: the formulation gaussian solves the truncated series, not its "
          "approximant; use white, km4 or kf",
          name(equation)));
    case Formulation::moment:
      if (equation == DensityEquation::kf || equation == DensityEquation::white) return;
      throw InputError(fmt::format(
          "epc equation = {}: the formulation moment needs a stochastic process, and the truncated "
          "series has none; use kf or white",
          name(equation)));
    case Formulation::polar:
      if (equation == DensityEquation::kf) return;
      throw InputError(fmt::format(
          "epc equation = {}: the second derivative of the phase has no mean at the origin; use "
          "kf for the formulation polar",
          name(equation)));
  }
}

std::string formulation_and_variant(const ClosureOptions& options) {
  std::string text(name(options.formulation));
  if (options.formulation == Formulation::moment && options.tail == DensityTailTreatment::cut)
    text += "-cut";
  const DensityEquation equation = closure_density_equation(options);
  if (equation != default_equation(options.formulation)) {
    text += fmt::format("-{}", name(equation));
  }
  return text;
}

}  // namespace

const OptionsDescription<ClosureOptions>& solver_option_descriptions() {
  using O = ClosureOptions;
  static const auto description =
      OptionsDescription<O>("epc ")
          .add("order", &O::order,
               {"N", "order n of the closure, even: 2 .. 12; for moment 2 .. 16"},
               allowed_orders(Formulation::moment))
          .add("formulation", &O::formulation, {"F", "gaussian, moment or polar, see above"})
          .add("monomials", &O::monomials,
               {"SET",
                "for gaussian: point_symmetric (default): even total degrees, complete under the "
                "symmetry; general: every degree"})
          .add("equation", &O::equation,
               {"E",
                "km4: the paper's series truncated after the fourth derivative (gaussian's "
                "default); kf: the full jump integral (default of moment and polar); white: white "
                "noise"})
          .with_choices({"white", "km4", "kf"})
          .add("tail", &O::tail,
               {"T",
                "for moment: confined (default): a steep fixed term makes the exponent fall beyond "
                "the confinement level; cut: Q_n alone, zero beyond the level"})
          .add("tolerance", &O::tolerance, {"TOL", "tolerance on the norm of the residual"},
               positive_numbers().with_reason_in_message("otherwise the iteration does not end"))
          .without_flag()
          .add("accuracy", &O::accuracy,
               {"L1",
                "largest L1 error estimate of p(y) and of p(y') with status ok (in a run: 0.02 for "
                "closures, 0.01 for fd)"},
               positive_numbers().with_reason_in_message("no closure is exact"))
          .with_default({})
          .add("max_seconds", &O::max_seconds,
               {"S", "for moment and polar: deadline after which no new attempt at a root begins"},
               positive_numbers())
          .with_default(ClosureOptions{}.max_seconds)
          .add("max_iterations", &O::max_iterations, {"N", "largest number of Newton steps"},
               positive_numbers().with_reason_in_message("Newton's method takes at least one step"))
          .without_flag();
  return description;
}

void validate(const ClosureOptions& options) {
  require_order(options);
  solver_option_descriptions().validate(options);
  require_equation(options);
  if (options.formulation != Formulation::moment &&
      options.tail != DensityTailTreatment::confined) {
    throw InputError(fmt::format("epc tail = {}: the formulation {} has no such option; omit it",
                                 name(options.tail), name(options.formulation)));
  }
  if (options.formulation != Formulation::gaussian &&
      options.monomials != MonomialSet::point_symmetric) {
    throw InputError(
        fmt::format("epc monomials = {}: the formulation {} uses all monomials; omit it",
                    name(options.monomials), name(options.formulation)));
  }
}

int max_closure_order(Formulation formulation) {
  return formulation == Formulation::moment ? 16 : 12;
}

DensityEquation default_equation(Formulation formulation) {
  return formulation == Formulation::gaussian ? DensityEquation::km4 : DensityEquation::kf;
}

DensityEquation closure_density_equation(const ClosureOptions& options) {
  return options.equation.value_or(default_equation(options.formulation));
}

std::string solution_id(const ClosureOptions& options) {
  return fmt::format("epc-{}-n{}", formulation_and_variant(options), options.order);
}

std::optional<ClosureOptions> options_of(std::string_view id) {
  constexpr std::string_view kOrder = "-n";
  const auto mark = id.rfind(kOrder);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view stem = id.substr(0, mark), digits = id.substr(mark + kOrder.size());
  int order = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), order);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  for (const auto& formulation : kFormulationNames) {
    for (const auto& tail : kTailTreatmentNames) {
      for (const auto& equation : problem::kEquationNames) {
        ClosureOptions options{
            .order = order, .formulation = formulation.value, .tail = tail.value};
        if (equation.value != default_equation(formulation.value))
          options.equation = equation.value;
        if (stem == "epc-" + formulation_and_variant(options)) return options;
      }
    }
  }
  return std::nullopt;
}

transform::SolutionIdentity solution_identity(const ClosureOptions& options) {
  return {.id = solution_id(options),
          .method = "epc",
          .formulation = formulation_and_variant(options),
          .order = options.order,
          .equation = closure_density_equation(options),
          .impact = options.formulation == Formulation::gaussian ? ImpactCondition::delta
                                                                 : ImpactCondition::map,
          .role = transform::SolutionRole::closure};
}

}  // namespace fpkcheck::epc
