#include "problem/impulse_train.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"
#include "problem/amplitude_table.hpp"
#include "problem/magnitude.hpp"

namespace fpkcheck::problem {

using namespace base;

namespace {

ImpulseLaw law_of(const ImpulseParameters& parameters) {
  impulse_description().validate(parameters);
  require_magnitudes(impulse_description(), parameters);
  const auto& [rate, law, intensity, mean, skewness, table] = parameters;
  const double variance = intensity / rate - mean * mean;
  if (variance <= 0) {
    throw InputError(fmt::format(
        "impulse.mean = {}: its square must be below E[Y^2] = impulse.intensity / impulse.rate = "
        "{:.6g}",
        mean, intensity / rate));
  }
  return ImpulseLaw::named(law, mean, std::sqrt(variance),
                           {.skewness = skewness, .table = table.value_or("")});
}

}  // namespace

const Description<ImpulseParameters>& impulse_description() {
  using P = ImpulseParameters;
  static const Value nothing;
  static const auto description =
      Description<P>("impulse.")
          .add("rate", &P::arrival_rate, {"LAMBDA", "impulses per unit of time"}, positive())
          .with_symbol("lambda", "λ")
          .add("law", &P::law, {"LAW", "law of the amplitudes"})
          .with_choices(ImpulseLaw::known())
          .add("intensity", &P::intensity, {"I", "intensity"}, positive())
          .with_symbol("lambda E[Y^2]", "λ E[Y²]")
          .add("mean", &P::mean, {"M", "mean amplitude"}, any_number())
          .with_symbol("E[Y]", "E[Y]")
          .with_fallback(0.0)
          .add("skewness", &P::skewness,
               {"S", "skewness of a gamma law; 2 or -2 of an exponential law"}, any_number())
          .with_symbol("skewness", "γ₁")
          .without_naming(nothing)
          .add("table", &P::table,
               {"FILE", "CSV of a tabulated law: amplitude,probability or amplitude,density"})
          .with_symbol("table", "table")
          .shown_as([](const std::string& text) { return summary_of(text); })
          .without_naming(nothing);
  return description;
}

ImpulseTrain::ImpulseTrain(const ImpulseParameters& parameters)
    : parameters_(parameters), law_(law_of(parameters)) {}

ImpulseTrain::ImpulseTrain()
    : parameters_{.arrival_rate = 0, .law = "gaussian", .intensity = 0, .mean = 0},
      law_(GaussianLaw{0, 1}) {}

ImpulseTrain ImpulseTrain::mirrored() const {
  if (!present()) return *this;
  ImpulseParameters parameters = parameters_;
  parameters.mean = -parameters.mean;
  const ImpulseLaw law = law_.mirrored();
  if (parameters.table) {
    parameters.table = text_of(amplitude_table_of_text(*parameters.table).mirrored());
  } else if (!law.symmetric()) {
    parameters.skewness = law.skewness();
  }
  return ImpulseTrain(parameters, law);
}

}  // namespace fpkcheck::problem
