#include "problem/problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "problem/energy_averaging.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_scales.hpp"
#include "problem/parameter_ranges.hpp"

namespace fpkcheck::problem {
namespace {

const CaseFileSection* find_section(const std::vector<CaseFileSection>& sections,
                                    const std::string& name) {
  const auto found = std::ranges::find(sections, name, &CaseFileSection::name);
  return found == sections.end() ? nullptr : &*found;
}

template <class Owner>
Owner read_section(const std::vector<CaseFileSection>& sections, const std::string& name,
                   const base::OptionsDescription<Owner>& description) {
  const CaseFileSection* section = find_section(sections, name);
  return section == nullptr ? Owner{} : description.read(section->values, name);
}

constexpr const char *kSystem = "system", *kParameters = "parameters", *kForce = "force";

// Reads the section [system], in which a force formula replaces all coefficients.
SystemCoefficients read_system_coefficients(base::Values values) {
  if (base::contains(values, kForce)) {
    for (const auto& parameter : system_parameter_description().parameters()) {
      const bool is_coefficient = parameter.name != kForce && parameter.name != "restitution";
      if (!is_coefficient) continue;
      if (base::contains(values, parameter.name)) {
        throw InputError(
            fmt::format("system.{} and system.force are both given; keep one", parameter.name));
      }
      values.push_back({parameter.name, 0.0});
    }
  }
  return system_parameter_description().read(values, kSystem);
}

NamedConstants read_named_constants(const std::vector<CaseFileSection>& sections) {
  NamedConstants constants;
  if (const CaseFileSection* section = find_section(sections, kParameters)) {
    for (const auto& [name, value] : section->values) {
      const auto number = named_constant_parameter(name).convert_to_parameter_type(value);
      if (!number) {
        throw InputError(
            fmt::format("parameters.{} = {} (must be a number)", name, base::value_as_text(value)));
      }
      constants.emplace(name, std::get<double>(*number));
    }
  }
  return constants;
}

// Sets the factor of multiplicative noise, and the force of the equation in Ito's sense.
void set_noise_factor(Problem& problem) {
  const WhiteNoise& noise = problem.noise;
  if (noise.interpretation && !noise.factor) {
    throw InputError("noise.interpretation is given without noise.factor; remove it");
  }
  if (!noise.factor) return;
  if (!noise.is_acting()) {
    throw InputError("noise.factor is given, but noise.intensity is 0; give the intensity 2D");
  }
  NoiseFactor factor(*noise.factor, problem.system.named_constants());
  if (factor.depends_on_v()) {
    if (!noise.interpretation) {
      throw InputError(
          "noise.interpretation is missing: the factor depends on v, so that the senses of Ito and "
          "Stratonovich differ; give noise.interpretation = ito or stratonovich");
    }
    if (*noise.interpretation == NoiseInterpretation::stratonovich) {
      problem.system = problem.system.equivalent_ito_system(factor, noise.diffusion());
    }
  }
  problem.noise_factor = std::move(factor);
}

// Sets the factor of parametric impulses, a formula of y alone.
void set_impulse_factor(Problem& problem) {
  const auto& formula = problem.impulses.impulse_parameters().factor;
  if (!formula) return;
  problem.impulse_factor.emplace(
      Expression::parse(*formula, problem.system.named_constants(), "impulse.factor", "y"));
}

// Sets the time dependence of the excitation from the section [time].
void set_time_dependence(const std::vector<CaseFileSection>& sections, Problem& problem) {
  const auto formulas = read_section(sections, "time", time_parameter_description());
  problem.time = ExcitationTimeDependence(formulas, problem.system.named_constants());
  if (problem.time.has_rate_factor() && !problem.impulses.is_acting()) {
    throw InputError("time.rate is given without [impulse]; remove it, or add impulses");
  }
  if (problem.time.has_intensity_factor() && !problem.noise.is_acting()) {
    throw InputError("time.intensity is given without [noise]; remove it, or add noise");
  }
  // The equations in Ito's sense and in Stratonovich's sense differ by the drift D G_v / 2, which
  // would change in time under a time-dependent noise intensity D.
  if (problem.time.has_intensity_factor() && problem.noise_factor &&
      problem.noise_factor->depends_on_v()) {
    throw InputError(
        "time.intensity with a noise.factor that depends on v is not supported; choose a factor of "
        "y alone");
  }
}

std::string value_text(const base::Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{:g}", *number) : std::get<std::string>(value);
}

}  // namespace

Problem without_impulses(Problem problem) {
  problem.impulses = ImpulseTrain();
  problem.impulse_factor.reset();
  return problem;
}

Problem without_noise(Problem problem) {
  problem.noise = {};
  problem.noise_factor.reset();
  return problem;
}

double noise_diffusion_coefficient(const Problem& problem, double y, double v) {
  return problem.noise.diffusion() *
         (problem.noise_factor ? problem.noise_factor->squared_noise_factor(y, v) : 1);
}

double squared_impulse_factor(const Problem& problem, double y) {
  if (!problem.impulse_factor) return 1;
  const double b = (*problem.impulse_factor)(y, 0);
  return b * b;
}

namespace {

std::vector<double> sorted_union(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::sort(a);
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

}  // namespace

std::vector<double> coefficient_kinks_in_y(const Problem& problem, double y_low, double y_high) {
  std::vector<double> kinks = problem.system.kinks_in_y(y_low, y_high);
  if (const auto& g = problem.noise_factor) {
    kinks = sorted_union(std::move(kinks), g->kinks_in_y(y_low, y_high));
  }
  if (const auto& b = problem.impulse_factor) {
    kinks = sorted_union(std::move(kinks), b->kinks_in_x(y_low, y_high));
  }
  return kinks;
}

std::vector<double> coefficient_kinks_in_v(const Problem& problem, double v_low, double v_high) {
  std::vector<double> kinks = problem.system.kinks_in_v(v_low, v_high);
  const auto& g = problem.noise_factor;
  return g ? sorted_union(std::move(kinks), g->kinks_in_v(v_low, v_high)) : kinks;
}

double total_excitation_intensity(const Problem& problem) {
  return problem.impulses.rate_times_moment(2) + problem.noise.intensity;
}

const std::vector<const base::OptionsDescriptionBase*>& case_section_descriptions() {
  static const std::vector<const base::OptionsDescriptionBase*> all{
      &system_parameter_description(), &wall_parameter_description(),
      &impulse_parameter_description(), &noise_parameter_description(),
      &time_parameter_description()};
  return all;
}

const base::Parameter& named_constant_parameter(std::string_view name) {
  static const base::Parameter parameter{.name = "NAME",
                                         .help = "named constant of the formulas",
                                         .type = base::ParameterType::number,
                                         .range = base::finite_numbers()};
  if (!is_valid_constant_name(name)) {
    throw InputError(fmt::format(
        "parameters.{} is not a name of a constant; use letters, digits and '_', but not y, v, t, "
        "pi or the name of a function",
        base::to_printable_text(name)));
  }
  return parameter;
}

std::vector<CaseFileSection> case_file_sections(const Problem& problem) {
  const System& system = problem.system;
  base::Values values = system_parameter_description().stored_values(system.coefficients());
  if (system.coefficients().force) {
    std::erase_if(values, [](const base::NamedParameterValue& one) {
      return one.name != kForce && one.name != "restitution";
    });
  }
  std::vector<CaseFileSection> all{{kSystem, std::move(values)}};
  if (!system.named_constants().empty()) {
    CaseFileSection constants{kParameters, {}};
    for (const auto& [name, value] : system.named_constants()) {
      constants.values.push_back({name, value});
    }
    all.push_back(std::move(constants));
  }
  const WallParameters& walls = problem.system.wall_parameters();
  if (!walls.is_section_absent())
    all.push_back({"wall", wall_parameter_description().stored_values(walls)});
  if (problem.impulses.is_acting()) {
    all.push_back({"impulse", impulse_parameter_description().stored_values(
                                  problem.impulses.impulse_parameters())});
  }
  if (problem.noise.is_acting()) {
    all.push_back({"noise", noise_parameter_description().stored_values(problem.noise)});
  }
  if (problem.time.is_acting()) {
    all.push_back(
        {"time", time_parameter_description().stored_values(problem.time.time_formulas())});
  }
  return all;
}

Problem problem_from_sections(const std::string& name, const std::vector<CaseFileSection>& sections,
                              CaseFileTimeSectionPolicy time_section) {
  const CaseFileSection* system = find_section(sections, kSystem);
  if (system == nullptr) {
    throw InputError(
        "system is missing: the file may be from another version of the program; run again");
  }
  const auto noise = read_section(sections, "noise", noise_parameter_description());
  noise_parameter_description().validate(noise);
  require_magnitudes_in_range(noise_parameter_description(), noise);
  Problem problem{.name = name,
                  .system = System(read_system_coefficients(system->values),
                                   read_section(sections, "wall", wall_parameter_description()),
                                   read_named_constants(sections)),
                  .impulses = {},
                  .noise = noise};
  if (const CaseFileSection* impulse = find_section(sections, "impulse")) {
    problem.impulses =
        ImpulseTrain(impulse_parameter_description().read(impulse->values, "impulse"));
  }
  set_noise_factor(problem);
  set_impulse_factor(problem);
  set_time_dependence(sections, problem);
  if (problem.time.is_acting() && time_section == CaseFileTimeSectionPolicy::refused) {
    throw InputError(
        "the section [time] changes the excitation in time, so that there is no stationary "
        "density; compute densities over time: fpkcheck run CASE --until T");
  }
  require_stationary_density(problem);
  return problem;
}

base::Value reported_parameter_value(const base::Parameter& parameter, const base::Value& value) {
  const auto* word = std::get_if<std::string>(&value);
  return word != nullptr && parameter.display_text ? base::Value(parameter.display_text(*word))
                                                   : value;
}

std::vector<ReportedParameter> parameters_for_reports(const Problem& problem) {
  std::vector<ReportedParameter> displayed;
  for (const CaseFileSection& section : case_file_sections(problem)) {
    if (section.name == kParameters) {
      for (const auto& [name, value] : section.values) {
        displayed.push_back(
            {section.name, name, name, name, named_constant_parameter(name).help, value, false});
      }
      continue;
    }
    const auto description = std::ranges::find(case_section_descriptions(), section.name + '.',
                                               &base::OptionsDescriptionBase::prefix);
    for (const auto& [name, value] : section.values) {
      const auto& parameter = *(*description)->find(name);
      displayed.push_back({section.name, name, parameter.symbol, parameter.typeset, parameter.help,
                           reported_parameter_value(parameter, value),
                           parameter.default_value == value});
    }
  }
  return displayed;
}

std::string non_default_parameters_text(const Problem& problem, bool typeset) {
  std::vector<std::string> of_system, of_excitation;
  for (const auto& p : parameters_for_reports(problem)) {
    if (p.is_default) continue;
    const bool moves = p.section == kSystem || p.section == kParameters || p.section == "wall";
    auto& part = moves ? of_system : of_excitation;
    const auto& symbol = typeset ? p.typeset : p.symbol;
    if (std::holds_alternative<bool>(p.value)) {
      part.push_back("no wall");
    } else if (symbol.empty()) {
      part.insert(part.begin(), fmt::format("{} impulses", value_text(p.value)));
    } else {
      std::string number = value_text(p.value);
      if (typeset && number.starts_with('-')) number.replace(0, 1, "\u2212");
      part.push_back(fmt::format("{} = {}", symbol, number));
    }
  }
  return fmt::format("{}; {}", fmt::join(of_system, ", "), fmt::join(of_excitation, ", "));
}

namespace {

// Requires that the force and the factors of noise and impulses are finite, the noise factor is
// positive, and the restitution coefficients are valid, on a grid of the states that the motion
// reaches.
void require_valid_formulas(const Problem& problem, const EnergyAveraging& averaging) {
  const System& system = problem.system;
  if (system.has_polynomial_force() && !problem.noise_factor && !problem.impulse_factor &&
      system.has_constant_restitution()) {
    return;
  }
  constexpr int kPoints = 41;
  const MotionScales reached = scales_from_energy_averaging(problem, averaging);
  require_valid_restitution(system.walls(), reached.v_high);
  for (int i = 0; i < kPoints; ++i) {
    const double y = reached.y_low + (reached.y_high - reached.y_low) * i / (kPoints - 1);
    if (const double square = squared_impulse_factor(problem, y); !std::isfinite(square)) {
      throw InputError(
          fmt::format("impulse.factor is not finite at y = {:.3g}, which the motion "
                      "reaches; choose a factor that is finite there",
                      y));
    }
    for (int j = 0; j < kPoints; ++j) {
      const double v = reached.v_high * (2.0 * j / (kPoints - 1) - 1);
      const double force = system.force(y, v);
      const double g = problem.noise_factor ? (*problem.noise_factor)(y, v) : 1;
      if (!std::isfinite(force)) {
        throw InputError(fmt::format(
            "system.force = {:.3g} at y = {:.3g}, v = {:.3g}, which the motion reaches; choose a "
            "force that is finite there",
            force, y, v));
      }
      if (!(g > 0 && std::isfinite(g))) {
        throw InputError(fmt::format(
            "noise.factor = {:.3g} at y = {:.3g}, v = {:.3g} (must be positive and finite)", g, y,
            v));
      }
    }
  }
}

// Requires that the restoring force between the walls is a number at displacements of magnitude
// 1e-6 to 1e6, since an undefined force makes the potential undefined. require_valid_formulas()
// checks the damping at the speeds that the motion reaches.
void require_defined_restoring_force(const System& system) {
  if (system.has_polynomial_force()) return;
  constexpr int kDecades = 6, kPointsPerDecade = 8;
  const auto require_number = [&](double y) {
    const bool is_inside = (!system.left_wall() || y > system.left_wall()->position) &&
                           (!system.right_wall() || y < system.right_wall()->position);
    if (!is_inside || !std::isnan(system.force(y, 0))) return;
    throw InputError(fmt::format(
        "system.force is undefined at y = {:.3g}, v = 0: a root, logarithm or power has no value "
        "there; write max(.., 0) or abs(..) as its argument, or exclude this y by a wall",
        y));
  };
  for (int n = -kDecades * kPointsPerDecade; n <= kDecades * kPointsPerDecade; ++n) {
    const double distance = std::pow(10, static_cast<double>(n) / kPointsPerDecade);
    require_number(distance);
    require_number(-distance);
    if (system.left_wall()) require_number(system.left_wall()->position + distance);
    if (system.right_wall()) require_number(system.right_wall()->position - distance);
  }
}

}  // namespace

void require_stationary_density(const Problem& problem) {
  if (!problem.impulses.is_acting() && !problem.noise.is_acting()) {
    throw InputError(
        "nothing excites the oscillator: add [impulse] with rate, law and intensity, or [noise] "
        "with intensity");
  }
  require_defined_restoring_force(problem.system);
  const bool has_formula = problem.system.coefficients().force.has_value();
  const UndampedOrbits orbits(problem);
  for (const auto& [is_confined, side] : {std::pair{orbits.is_confining_on_left(), "left"},
                                          std::pair{orbits.is_confining_on_right(), "right"}}) {
    if (is_confined) continue;
    throw InputError(fmt::format(
        "there is no stationary density: the restoring force does not confine the mass on the {0}; "
        "{1}, or add wall.{0}",
        side,
        !has_formula ? "change the sign of its highest power"
        : std::string_view(side) == "left"
            ? "choose a system.force that is negative where y is large and negative"
            : "choose a system.force that is positive where y is large"));
  }
  // The paper's oscillator always has a stationary density, since only the impulses supply energy
  // and the damping dissipates energy.
  if (has_equivalent_linearisation(problem)) return;
  const EnergyAveraging averaging(problem);
  if (const auto& why = averaging.reason_for_unconfined_motion()) {
    throw InputError(fmt::format(
        "there is no stationary density: {}; {}, or give a wall a restitution below 1", *why,
        has_formula ? "add damping to system.force, such as 0.1*v"
                    : "raise system.damping, system.van_der_pol or system.rayleigh"));
  }
  require_valid_formulas(problem, averaging);
}

}  // namespace fpkcheck::problem
