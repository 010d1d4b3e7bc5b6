#include "report/page/page_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figure/script_text.hpp"
#include "report/page/html_elements.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

// Lengths in SVG units; the SVG picture is scaled to the width of the report page.
constexpr double kWidth = 560, kNames = 132, kRight = 14, kTop = 22, kRow = 22, kBottom = 42;
constexpr double kLeast = 1e-9;  // Position on the distance axis of all smaller distances.

class ReferenceDistancePlot {
 public:
  ReferenceDistancePlot(const results::Run& run, const std::vector<SolutionAgreementOverCases>& all)
      : run_(run), all_(all) {
    for (const auto& row : all) {
      for (const auto& entry : row.entries) {
        if (const auto l1 = entry.largest_l1_distance()) include(*l1);
      }
    }
    for (const auto& case_result : run.cases) {
      const double error = case_result.assessment.largest_reference_l1_error();
      if (std::isfinite(error)) reference_error_ = std::max(reference_error_, error);
    }
    if (reference_error_ > 0) include(reference_error_);
    if (any_) include(compare::kCloseL1);
  }

  bool empty() const { return !any_; }

  std::string svg() const {
    return fmt::format(
        "<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"Distances of all solutions to the "
        "reference, on a logarithmic axis\">\n{}{}{}</svg>\n",
        kWidth, svg_height(), reference_error_rectangle(), axis_elements(), row_elements());
  }

 private:
  void include(double l1) {
    const double decade = std::log10(std::max(l1, kLeast));
    from_ = any_ ? std::min(from_, std::floor(decade)) : std::floor(decade);
    to_ = any_ ? std::max(to_, std::ceil(decade)) : std::ceil(decade);
    any_ = true;
  }

  double bottom_of_rows() const { return kTop + kRow * static_cast<double>(all_.size()); }
  double svg_height() const { return bottom_of_rows() + kBottom; }
  double x_position(double l1) const {
    const double share = (std::log10(std::max(l1, kLeast)) - from_) / std::max(1.0, to_ - from_);
    return kNames + share * (kWidth - kNames - kRight);
  }

  static std::string text_element(double x, double y, const char* anchor, std::string_view words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       anchor, escape_html(words));
  }
  std::string vertical_line_element(double x, const char* css_class) const {
    return fmt::format(
        "<line class=\"{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2}\" y2=\"{3}\"/>\n", css_class, x,
        kTop, bottom_of_rows());
  }

  // Draws the rectangle of the L1 distances that are below the error estimate of the reference
  // solutions.
  std::string reference_error_rectangle() const {
    if (!(reference_error_ > 0)) return "";
    const double end = x_position(reference_error_);
    return fmt::format("<rect class=\"known\" x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>\n",
                       kNames, kTop, end - kNames, bottom_of_rows() - kTop) +
           (end - kNames > 60
                ? text_element((kNames + end) / 2, kTop - 7, "middle", "reference error")
                : "");
  }

  std::string axis_elements() const {
    std::string svg;
    for (double decade = from_; decade <= to_ + 0.5; ++decade) {
      const double x = x_position(std::pow(10, decade));
      svg += vertical_line_element(x, "grid");
      svg += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">10<tspan dy=\"-5\" "
          "font-size=\"9\">{}</tspan></text>\n",
          x, bottom_of_rows() + 16, replace_hyphens_by_minus_signs(fmt::format("{:.0f}", decade)));
    }
    svg += vertical_line_element(x_position(compare::kCloseL1), "close") +
           text_element(x_position(compare::kCloseL1), kTop - 7, "middle",
                        fmt::format("close: {}", compare::kCloseL1));
    return svg + text_element((kNames + kWidth - kRight) / 2, bottom_of_rows() + 36, "middle",
                              "L1 distance to the reference, the larger of p(y) and p(y\u2032)");
  }

  std::string row_elements() const {
    std::string svg;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const SolutionAgreementOverCases& row = all_[k];
      const double y = kTop + kRow * (static_cast<double>(k) + 0.5);
      svg +=
          fmt::format("<line class=\"row\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n",
                      kNames, kWidth - kRight, y);
      svg += text_element(kNames - 6, y + 4, "end", row.identity->id);
      for (std::size_t c = 0; c < row.entries.size(); ++c) svg += mark_element(row, c, y);
      if (std::ranges::none_of(row.entries, [](const SolutionAgreementInCase& s) {
            return bool(s.largest_l1_distance());
          })) {
        svg += text_element(kNames + 6, y + 4, "start", text_without_distance(row));
      }
    }
    return svg;
  }

  static std::string text_without_distance(const SolutionAgreementOverCases& row) {
    for (const auto& entry : row.entries) {
      if (entry.agreement == AgreementWithReference::reference) return "the reference";
      if (entry.solution != nullptr && !entry.solution->has_status_ok()) {
        return std::string(name(entry.solution->status));
      }
    }
    return "";
  }

  // A filled circle marks the status ok, an open circle another status with a density, and a cross
  // a solution without an admissible density.
  std::string mark_element(const SolutionAgreementOverCases& row, std::size_t c, double y) const {
    const SolutionAgreementInCase& entry = row.entries[c];
    const auto l1 = entry.largest_l1_distance();
    if (!l1) return "";
    const double x = x_position(*l1);
    const std::string title = fmt::format(
        "<title>{}, {}: {}{}</title>", escape_html(row.identity->id),
        escape_html(run_.cases[c].name()), number_text(l1, 2),
        entry.solution->has_status_ok() ? "" : fmt::format(" ({})", name(entry.solution->status)));
    if (entry.agreement == AgreementWithReference::no_density) {
      return fmt::format("<path class=\"cross\" d=\"M{0:.1f} {1:.1f}l8 8m0 -8l-8 8\">{2}</path>\n",
                         x - 4, y - 4, title);
    }
    return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\">{}</circle>\n",
                       entry.solution->has_status_ok() ? "full" : "hollow", x, y, title);
  }

  const results::Run& run_;
  const std::vector<SolutionAgreementOverCases>& all_;
  bool any_ = false;
  double from_ = 0, to_ = 0;    // ends of the axis in decades
  double reference_error_ = 0;  // largest error estimate of a reference
};

}  // namespace

std::string reference_distance_plot_svg(
    const results::Run& run, const std::vector<SolutionAgreementOverCases>& agreement_rows) {
  const ReferenceDistancePlot plot(run, agreement_rows);
  if (plot.empty()) return "";
  return "<figure class=\"strip\">\n" + plot.svg() +
         fmt::format(
             "<figcaption>{}: filled for status <b>ok</b>, open for another status, a cross "
             "without an admissible density.</figcaption>\n</figure>\n",
             run.cases.size() > 1 ? "A mark for each case" : "A mark for each method");
}

}  // namespace fpkcheck::report
