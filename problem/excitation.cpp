#include "problem/excitation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"
#include "problem/amplitude_table.hpp"
#include "problem/parameter_ranges.hpp"

namespace fpkcheck::problem {

using namespace base;

const OptionsDescription<WhiteNoise>& noise_parameter_description() {
  static const auto description =
      OptionsDescription<WhiteNoise>("noise.")
          .add("intensity", &WhiteNoise::intensity, {"I", "intensity of the Gaussian white noise"},
               non_negative_numbers())
          .with_symbol("2D", "2D")
          .with_default(0.0)
          .add("factor", &WhiteNoise::factor,
               {"G", "factor g(y, v) of multiplicative noise, as a formula"})
          .with_symbol("g", "g")
          .with_default_omitted_from_files(Value())
          .add("interpretation", &WhiteNoise::interpretation,
               {"SENSE", "interpretation of noise whose factor depends on v"})
          .with_symbol("interpretation", "interpretation")
          .with_default_omitted_from_files(Value());
  return description;
}

namespace {

ImpulseLaw make_law(const ImpulseParameters& parameters) {
  impulse_parameter_description().validate(parameters);
  require_magnitudes_in_range(impulse_parameter_description(), parameters);
  const auto& [rate, law, intensity, mean, skewness, table, factor] = parameters;
  if (factor && mean != 0) {
    throw InputError(fmt::format(
        "impulse.mean = {} beside impulse.factor (must be 0 for parametric impulses)", mean));
  }
  const double variance = intensity / rate - mean * mean;
  if (variance <= 0) {
    throw InputError(fmt::format(
        "impulse.mean = {}: its square must be below E[Y^2] = impulse.intensity / impulse.rate = "
        "{:.6g}",
        mean, intensity / rate));
  }
  return ImpulseLaw::from_name(law, mean, std::sqrt(variance),
                               {.skewness = skewness, .table = table.value_or("")});
}

}  // namespace

const OptionsDescription<ImpulseParameters>& impulse_parameter_description() {
  using P = ImpulseParameters;
  static const Value nothing;
  static const auto description =
      OptionsDescription<P>("impulse.")
          .add("rate", &P::arrival_rate, {"LAMBDA", "impulses per unit of time"},
               positive_numbers())
          .with_symbol("lambda", "λ")
          .add("law", &P::law, {"LAW", "law of the amplitudes"})
          .with_choices(ImpulseLaw::law_names())
          .add("intensity", &P::intensity, {"I", "intensity"}, positive_numbers())
          .with_symbol("lambda E[Y^2]", "λ E[Y²]")
          .add("mean", &P::mean, {"M", "mean amplitude"}, finite_numbers())
          .with_symbol("E[Y]", "E[Y]")
          .with_default(0.0)
          .add("skewness", &P::skewness,
               {"S", "skewness of a gamma law; 2 or -2 of an exponential law"}, finite_numbers())
          .with_symbol("skewness", "γ₁")
          .with_default_omitted_from_files(nothing)
          .add("table", &P::table,
               {"FILE", "CSV of a tabulated law: amplitude,probability or amplitude,density"})
          .with_symbol("table", "table")
          .with_display_text([](const std::string& text) { return amplitude_table_summary(text); })
          .with_default_omitted_from_files(nothing)
          .add("factor", &P::factor, {"B", "factor b(y) of parametric impulses, as a formula"})
          .with_symbol("b", "b")
          .with_default_omitted_from_files(nothing);
  return description;
}

ImpulseTrain::ImpulseTrain(const ImpulseParameters& parameters)
    : parameters_(parameters), law_(make_law(parameters)) {}

ImpulseTrain::ImpulseTrain()
    : parameters_{.arrival_rate = 0, .law = "gaussian", .intensity = 0, .mean = 0},
      law_(GaussianLaw{0, 1}) {}

ImpulseTrain ImpulseTrain::with_rate_multiplied_by(double factor) const {
  ImpulseParameters parameters = parameters_;
  parameters.arrival_rate *= factor;
  parameters.intensity *= factor;
  return ImpulseTrain(parameters, law_);
}

ImpulseTrain ImpulseTrain::with_negated_amplitudes() const {
  if (!is_acting()) return *this;
  ImpulseParameters parameters = parameters_;
  parameters.mean = -parameters.mean;
  const ImpulseLaw law = law_.with_negated_amplitudes();
  if (parameters.table) {
    parameters.table = amplitude_table_literal(
        parse_amplitude_table_literal(*parameters.table).with_negated_amplitudes());
  } else if (!law.is_symmetric()) {
    parameters.skewness = law.skewness();
  }
  return ImpulseTrain(parameters, law);
}

}  // namespace fpkcheck::problem
