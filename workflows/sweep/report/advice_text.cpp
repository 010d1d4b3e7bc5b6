#include "workflows/sweep/report/advice_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/text/columns.hpp"
#include "report/text/wrapped.hpp"

namespace fpkcheck::sweep {
namespace {

using report::Column;

constexpr std::size_t kShownMethods = 3;
constexpr double kFarOff = 0.05;

std::string place_sentence(const Advice& advice, const std::string& name) {
  const Place& place = advice.place;
  std::string text = fmt::format(
      "{}: {:.2g} impulses per decay time, damping ratio {:.2g}, {:.0f} % of the stiffness cubic, "
      "r = {:.4g}, {} impulses",
      name, place.groups.impulses_per_decay_time, place.groups.damping_ratio,
      100 * place.groups.cubic_share, place.restitution, place.law);
  if (place.mean_share != 0)
    text += fmt::format(", mean {:.2g} times the root mean square", place.mean_share);
  return text + '.';
}

std::string nearest_sentence(const Advice& advice) {
  if (std::isinf(advice.nearest)) {
    return advice.place.mean_share != 0
               ? "Outside the map: none of its points has impulses with a mean."
               : fmt::format("Outside the map: none of its points has {} impulses.",
                             advice.place.law);
  }
  if (advice.outside()) {
    return fmt::format("Outside the map: the nearest point has distance {:.2g} (limit 1).",
                       advice.nearest);
  }
  return fmt::format("Nearest point of the map: distance {:.2g}; {} points within 1.",
                     advice.nearest, advice.near);
}

// Results at the nearby points of the methods that are shown.
std::string nearby_table(const std::vector<MethodNearby>& methods,
                         const report::TextFormat& format) {
  Column id{"", "method", true, report::kAlwaysShown},
      points{"at the points nearby", "points", false, 1},
      ok{"at the points nearby", "ok", false, 2},
      worst{"at the points nearby", "worst L1", false, report::kAlwaysShown},
      seconds{"at the points nearby", "seconds", false, 3};
  for (const auto& one : methods) {
    id.cells.push_back(one.id);
    points.cells.push_back(std::to_string(one.points));
    ok.cells.push_back(std::to_string(one.ok));
    worst.cells.push_back(one.worst_l1 ? fmt::format("{:.2g}", *one.worst_l1) : report::kAbsent);
    seconds.cells.push_back(fmt::format("{:.2g}", one.seconds));
  }
  return report::rows({id, points, ok, worst, seconds}, format);
}

// "fd-white (solves white/map, error up to 0.11 at 31 of 31 points), ..". The status `ok` refers to
// the equation and impact that the method solves: the sentence states them.
std::string misstated_sentence(const Advice& advice, const methods::Registry& registry) {
  std::vector<std::string> who;
  for (const auto& one : advice.methods) {
    if (one.misstated == 0) continue;
    const auto method = registry.by_id(one.id);
    who.push_back(fmt::format("{} ({}error up to {:.2g} at {} of {} points)", one.id,
                              method ? "solves " + solves_text(method->identity) + ", " : "",
                              one.worst_l1.value_or(0), one.misstated, one.points));
  }
  if (who.empty()) return {};
  return fmt::format("Status ok there, but error above twice the stated error: {}.",
                     fmt::join(who, "; "));
}

std::string far_off_sentence(const Advice& advice) {
  std::vector<std::string> who;
  for (const auto& one : advice.methods) {
    if (one.misstated > 0 || one.worst_l1.value_or(0) <= kFarOff) continue;
    who.push_back(fmt::format("{} ({:.2g})", one.id, *one.worst_l1));
  }
  if (who.empty()) return {};
  return fmt::format("Error above {:g} % at some of these points, as stated: {}.", 100 * kFarOff,
                     fmt::join(who, ", "));
}

std::string without_density_sentence(const Advice& advice) {
  std::vector<std::string> who;
  for (const auto& one : advice.methods) {
    if (!one.worst_l1) who.push_back(one.id);
  }
  if (who.empty()) return {};
  return fmt::format("No probability density at any of these points: {}.", fmt::join(who, ", "));
}

}  // namespace

std::string advice_text(const Advice& advice, const AdviceSetting& setting,
                        const report::TextFormat& format) {
  const auto paragraph = [&](const std::string& text) {
    return text.empty() ? text : report::wrapped(text, format.width);
  };
  std::string text =
      paragraph(place_sentence(advice, setting.name) + ' ' + nearest_sentence(advice));
  auto promised = advice.promised();
  if (promised.empty()) {
    text += '\n' + paragraph(fmt::format(
                       "No method met L1 {:g} at all nearby points. These methods estimate "
                       "their own errors:",
                       advice.accuracy));
    for (const auto& command : setting.otherwise) text += "  " + command + '\n';
  } else {
    text += fmt::format(
        "\nRecommended for L1 {:g} of p(y) and p(y'), met at all nearby points:\n"
        "  {}\n",
        advice.accuracy, setting.command(promised.front().id));
    promised.resize(std::min(promised.size(), kShownMethods));
    text += '\n' + nearby_table(promised, format);
    for (std::size_t k = 1; k < promised.size(); ++k) {
      text += (k == 1 ? "\nOr:\n  " : "  ") + setting.command(promised[k].id) + '\n';
    }
  }
  const std::string own_word =
      "Status and stated error of a solution refer to this problem itself.";
  if (advice.outside()) return text + '\n' + paragraph(own_word);
  const std::string warnings = paragraph(misstated_sentence(advice, setting.registry)) +
                               paragraph(far_off_sentence(advice)) +
                               paragraph(without_density_sentence(advice));
  if (!warnings.empty()) text += '\n' + warnings;
  return text + '\n' +
         paragraph("No guarantee: the map has no data between its points (docs/validity.md). " +
                   own_word);
}

}  // namespace fpkcheck::sweep
