#include "report/page/distance_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/reference.hpp"
#include "report/figure/text.hpp"
#include "report/page/html.hpp"
#include "report/page/number_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

// Lengths in units of the SVG, which the page scales to its width.
constexpr double kWidth = 560, kNames = 132, kRight = 14, kTop = 22, kRow = 22, kBottom = 42;
constexpr double kLeast = 1e-9;  // smaller distances are drawn here

class Strip {
 public:
  Strip(const results::Run& run, const std::vector<Record>& all) : run_(run), all_(all) {
    for (const auto& record : all) {
      for (const auto& stand : record.stands) {
        if (const auto l1 = stand.farthest()) widen(*l1);
      }
    }
    for (const auto& one : run.cases) {
      if (const Solution* reference = compare::reference(one.solutions)) {
        const double error = std::max(compare::own_error(*reference, transform::Variable::y),
                                      compare::own_error(*reference, transform::Variable::ydot));
        if (std::isfinite(error)) known_ = std::max(known_, error);
      }
    }
    if (known_ > 0) widen(known_);
    if (any_) widen(kCloseL1);
  }

  bool empty() const { return !any_; }

  std::string svg() const {
    return fmt::format(
        "<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"Distances of all solutions to the "
        "reference, on a logarithmic axis\">\n{}{}{}</svg>\n",
        kWidth, height(), what_is_known(), axis(), rows());
  }

 private:
  void widen(double l1) {
    const double decade = std::log10(std::max(l1, kLeast));
    from_ = any_ ? std::min(from_, std::floor(decade)) : std::floor(decade);
    to_ = any_ ? std::max(to_, std::ceil(decade)) : std::ceil(decade);
    any_ = true;
  }

  double bottom() const { return kTop + kRow * static_cast<double>(all_.size()); }
  double height() const { return bottom() + kBottom; }
  double x_of(double l1) const {
    const double share = (std::log10(std::max(l1, kLeast)) - from_) / std::max(1.0, to_ - from_);
    return kNames + share * (kWidth - kNames - kRight);
  }

  static std::string text(double x, double y, const char* anchor, std::string_view words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       anchor, escaped(words));
  }
  std::string upright(double x, const char* look) const {
    return fmt::format(
        "<line class=\"{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2}\" y2=\"{3}\"/>\n", look, x,
        kTop, bottom());
  }

  // The rectangle of distances within the error estimate of the references.
  std::string what_is_known() const {
    if (!(known_ > 0)) return "";
    const double end = x_of(known_);
    return fmt::format("<rect class=\"known\" x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>\n",
                       kNames, kTop, end - kNames, bottom() - kTop) +
           (end - kNames > 60 ? text((kNames + end) / 2, kTop - 7, "middle", "reference error")
                              : "");
  }

  std::string axis() const {
    std::string svg;
    for (double decade = from_; decade <= to_ + 0.5; ++decade) {
      const double x = x_of(std::pow(10, decade));
      svg += upright(x, "grid");
      svg += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">10<tspan dy=\"-5\" "
          "font-size=\"9\">{}</tspan></text>\n",
          x, bottom() + 16, with_minus(fmt::format("{:.0f}", decade)));
    }
    svg += upright(x_of(kCloseL1), "close") +
           text(x_of(kCloseL1), kTop - 7, "middle", fmt::format("close: {}", kCloseL1));
    return svg + text((kNames + kWidth - kRight) / 2, bottom() + 36, "middle",
                      "L1 distance to the reference, the larger of p(y) and p(y\u2032)");
  }

  std::string rows() const {
    std::string svg;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const Record& record = all_[k];
      const double y = kTop + kRow * (static_cast<double>(k) + 0.5);
      svg +=
          fmt::format("<line class=\"row\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n",
                      kNames, kWidth - kRight, y);
      svg += text(kNames - 6, y + 4, "end", record.identity->id);
      for (std::size_t c = 0; c < record.stands.size(); ++c) svg += mark(record, c, y);
      if (std::ranges::none_of(record.stands, [](const Stand& s) { return bool(s.farthest()); })) {
        svg += text(kNames + 6, y + 4, "start", words_without_distance(record));
      }
    }
    return svg;
  }

  static std::string words_without_distance(const Record& record) {
    for (const auto& stand : record.stands) {
      if (stand.standing == Standing::reference) return "the reference";
      if (stand.solution != nullptr && !stand.solution->is_ok()) {
        return std::string(name(stand.solution->status));
      }
    }
    return "";
  }

  // Filled circle: ok; open circle: another status; cross: no admissible density.
  std::string mark(const Record& record, std::size_t c, double y) const {
    const Stand& stand = record.stands[c];
    const auto l1 = stand.farthest();
    if (!l1) return "";
    const double x = x_of(*l1);
    const std::string title = fmt::format(
        "<title>{}, {}: {}{}</title>", escaped(record.identity->id), escaped(run_.cases[c].name()),
        number_text(l1, 2),
        stand.solution->is_ok() ? "" : fmt::format(" ({})", name(stand.solution->status)));
    if (stand.standing == Standing::no_density) {
      return fmt::format("<path class=\"cross\" d=\"M{0:.1f} {1:.1f}l8 8m0 -8l-8 8\">{2}</path>\n",
                         x - 4, y - 4, title);
    }
    return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\">{}</circle>\n",
                       stand.solution->is_ok() ? "full" : "hollow", x, y, title);
  }

  const results::Run& run_;
  const std::vector<Record>& all_;
  bool any_ = false;
  double from_ = 0, to_ = 0;  // decades
  double known_ = 0;          // largest error estimate of a reference
};

}  // namespace

std::string distance_strip(const results::Run& run, const std::vector<Record>& records) {
  const Strip strip(run, records);
  if (strip.empty()) return "";
  return "<figure class=\"strip\">\n" + strip.svg() +
         fmt::format(
             "<figcaption>{}: filled for status <b>ok</b>, open for another status, a cross "
             "without an admissible density.</figcaption>\n</figure>\n",
             run.cases.size() > 1 ? "A mark for each case" : "A mark for each method");
}

}  // namespace fpkcheck::report
