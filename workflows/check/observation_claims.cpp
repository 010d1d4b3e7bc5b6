#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "workflows/check/claims.hpp"

namespace fpkcheck::check {
namespace {

using base::Value;
using transform::Kind;
using transform::Observation;
using transform::Observations;

// Path of the part that contains a metric: "peaks[3]" for "peaks[3].rate", "peaks" for "peaks[3]",
// else the whole solution.
std::string part_of(const std::string& path) {
  const auto end = path.find_last_of(".[");
  return end == std::string::npos ? kWhole : path.substr(0, end);
}

// The path without indices of lists: "quantiles.y[].value".
std::string without_places(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == ']' || !result.ends_with('[')) result += c;
  }
  return result;
}

class ObservationClaims {
 public:
  ObservationClaims(const Observations& observations, const Tolerances& tolerances,
                    const Part& whole)
      : observations_(observations), tolerances_(tolerances), whole_(whole) {
    for (const auto& o : observations) {
      if (!o.error_at.empty()) errors_of_values_.insert(o.error_at);
      if (o.kind == Kind::coefficient) terms_.insert(part_of(o.path));
      const auto place = o.path.find_last_of('[');
      if (place == std::string::npos) continue;
      auto& entries = entries_[o.path.substr(0, place)];
      if (!o.path.ends_with("[]")) entries.insert(o.path.substr(0, o.path.find(']', place)));
    }
  }

  void add_all() {
    const std::size_t first = whole_.claims.size();
    for (const auto& o : observations_) {
      if (o.kind == Kind::coefficient) {
        const double a = number_in(o.value);
        whole_.number(coefficient_name(o), FigureKind::coefficient, a, tolerances_.coefficient(),
                      std::max(std::abs(a), o.least_scale));
      } else if (o.kind == Kind::result && !terms_.contains(part_of(o.path))) {
        add_result(o);
      } else if (o.kind == Kind::error && !errors_of_values_.contains(o.path)) {
        // Numbers of effective samples are proportional to 1 / error^2.
        whole_.number(o.path, FigureKind::simulated_error, number_in(o.value), 2);
      }
    }
    const auto own = std::span(whole_.claims).subspan(first);
    const auto values = std::ranges::count(own, FigureKind::simulated, &Claim::kind);
    for (Claim& claim : own) {
      if (claim.kind != FigureKind::simulated) continue;
      claim.allowed = tolerances_.of_the_largest(static_cast<std::size_t>(values));
    }
  }

 private:
  // The results with the same parent are the powers of its term: that of x1^4 x2^2 is "a(4,2)".
  std::string coefficient_name(const Observation& o) const {
    std::vector<double> powers;
    for (const auto& beside : observations_) {
      if (beside.kind == Kind::result && part_of(beside.path) == part_of(o.path)) {
        powers.push_back(number_in(beside.value));
      }
    }
    return fmt::format("{}({})", o.path.substr(part_of(o.path).size() + 1), fmt::join(powers, ","));
  }

  // The part of a group, a list or an entry of a list; opened at its first use.
  Part part(const std::string& name) {
    const Part result{whole_.claims, whole_.solution, name};
    if (name != kWhole && begun_.insert(name).second) {
      const Part outer = part(part_of(name));
      const auto list = entries_.find(name);
      const std::string length =
          list == entries_.end() ? "there" : fmt::format("{} entries", list->second.size());
      result.begin(FigureKind::detail, length, outer.name);
    }
    return result;
  }

  void add_result(const Observation& o) {
    const Part in = part(part_of(o.path));
    const double number = number_in(o.value);
    if (o.path.ends_with("[]")) return;
    if (!o.error_at.empty()) {
      add_estimate(o, in);
    } else if (std::holds_alternative<double>(o.value) ||
               std::holds_alternative<std::int64_t>(o.value)) {
      in.number(o.path, FigureKind::detail, number,
                o.delicate ? tolerances_.tail() : tolerances_.deterministic,
                std::max(std::abs(number), o.least_scale));
    } else {
      in.word(o.path, o.value);
    }
  }

  void add_estimate(const Observation& o, const Part& in) {
    const Observation* error = find(observations_, o.error_at);
    const double standard_error =
        error == nullptr ? std::numeric_limits<double>::quiet_NaN() : number_in(error->value);
    in.number(o.path, FigureKind::simulated, number_in(o.value), 0).error = standard_error;
    // The standard error of a delicate value comes from a handful of events, and is as uncertain.
    if (error == nullptr || o.delicate) return;
    in.number("error of " + o.path, FigureKind::simulated_error, standard_error, 1);
  }

  const Observations& observations_;
  const Tolerances& tolerances_;
  const Part& whole_;
  std::set<std::string> errors_of_values_, terms_, begun_;
  std::map<std::string, std::set<std::string>> entries_;  ///< of every list, by its path
};

}  // namespace

void add_observations(const Observations& observations, const Tolerances& tolerances,
                      const Part& whole) {
  ObservationClaims(observations, tolerances, whole).add_all();
}

Observations described(Observations baseline, const Observations& now) {
  std::set<std::string> passed_over;
  for (const auto& o : now) {
    if (o.kind == Kind::work || o.kind == Kind::text) passed_over.insert(without_places(o.path));
  }
  // At any index of a list, and in a list of work that is empty in the new run.
  const auto is_passed_over = [&](const std::string& path) {
    for (auto end = path.find("[]"); end != std::string::npos; end = path.find("[]", end + 1)) {
      if (passed_over.contains(path.substr(0, end + 2))) return true;
    }
    return passed_over.contains(path);
  };
  for (auto& o : baseline) {
    const Observation* same = find(now, o.path);
    Observation as_now = same != nullptr ? *same : Observation{.path = o.path, .value = {}};
    if (is_passed_over(without_places(o.path))) as_now.kind = Kind::work;
    as_now.value = std::move(o.value);
    o = std::move(as_now);
  }
  return baseline;
}

}  // namespace fpkcheck::check
