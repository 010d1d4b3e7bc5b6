#include "epc/solve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <string_view>

#include "epc/admissibility.hpp"
#include "epc/gaussian_search.hpp"
#include "epc/moment/solve.hpp"
#include "epc/polar/solve.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;

// What the formulation solves unless it is told otherwise needs no word in the id.
Equation usual_equation(Formulation formulation) {
  return formulation == Formulation::gaussian ? Equation::km4 : Equation::kf;
}

void label(const Options& options, Result& result) {
  result.solution.id = id(options);
  result.solution.method = "epc";
  result.solution.equation = name(options.equation);
  result.solution.impact =
      options.formulation == Formulation::gaussian ? problem::Impact::delta : problem::Impact::map;
  result.summary.order = options.order;
  result.summary.formulation = options.formulation;
}

Result solve_gaussian(const problem::Problem& problem, const Options& options) {
  const Search search = find_root(problem, options);
  Result result;
  result.summary.iterations = search.iterations;
  result.summary.residual = search.residual;
  result.summary.branch = search.branch;
  result.summary.disc_sensitivity = search.disc_sensitivity;
  if (search.root) {
    result.summary.condition = search.condition;
    judge(problem, *search.root, search.previous, result);
  } else {
    result.solution.status = Status::not_converged;
    result.solution.reason = search.failure;
  }
  return result;
}

Result solve_formulation(const problem::Problem& problem, const Options& options) {
  switch (options.formulation) {
    case Formulation::gaussian:
      return solve_gaussian(problem, options);
    case Formulation::moment:
      return moment::solve(problem, options);
    case Formulation::polar:
      return polar::solve(problem, options);
  }
  return {};
}

}  // namespace

std::string_view name(Formulation formulation) {
  switch (formulation) {
    case Formulation::gaussian:
      return "gaussian";
    case Formulation::moment:
      return "moment";
    case Formulation::polar:
      return "polar";
  }
  return "";
}

std::string_view name(Equation equation) {
  switch (equation) {
    case Equation::white:
      return "white";
    case Equation::km4:
      return "km4";
    case Equation::kf:
      return "kf";
  }
  return "";
}

int greatest_order(Formulation formulation) { return formulation == Formulation::moment ? 16 : 12; }

std::string id(const Options& options) {
  const bool moment = options.formulation == Formulation::moment;
  std::string text = fmt::format("epc-{}", name(options.formulation));
  if (moment && options.tail == moment::Tail::cut) text += "-cut";
  if (options.equation != usual_equation(options.formulation)) {
    text += fmt::format("-{}", name(options.equation));
  }
  return text + fmt::format("-n{}", options.order);
}

void validate(const Options& options) {
  const int greatest = greatest_order(options.formulation);
  if (options.order < 2 || options.order > greatest || options.order % 2 != 0) {
    throw InputError(
        fmt::format("epc order = {} (must be an even number from 2 to {}: an odd one cannot fall "
                    "in every direction, and rounding shows in higher ones)",
                    options.order, greatest));
  }
  if (options.formulation == Formulation::moment && options.equation == Equation::km4) {
    throw InputError(
        "epc equation = km4 (the moment equations of the formulation moment are those of a "
        "process, and no process belongs to the series cut after the fourth derivative) use kf or "
        "white");
  }
  if (options.formulation == Formulation::polar && options.equation != Equation::kf) {
    throw InputError(fmt::format(
        "epc equation = {} (the formulation polar follows the jumps of the process itself: its "
        "angles have no second derivative in the mean) use kf",
        name(options.equation)));
  }
  if (options.formulation == Formulation::polar && options.tail != moment::Tail::confined) {
    throw InputError("epc tail = cut (not known to the formulation polar) use confined");
  }
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw InputError(fmt::format("epc tolerance = {} (no iteration can end) use a positive number",
                                 options.tolerance));
  }
  if (options.max_iterations < 1) {
    throw InputError(fmt::format("epc max_iterations = {} (no step would be taken) use 1 or more",
                                 options.max_iterations));
  }
}

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const auto start = std::chrono::steady_clock::now();
  Result result = solve_formulation(problem, options);
  label(options, result);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.solution.seconds = elapsed.count();
  return result;
}

}  // namespace fpkcheck::epc
