#include "cli/figure_options.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "cli/parse_list.hpp"

namespace fpkcheck::cli {
namespace {

namespace po = boost::program_options;
using report::FigureFormat;
using report::FigureWidth;

std::vector<FigureFormat> parse_formats(const std::string& list) {
  std::vector<FigureFormat> formats;
  for (const auto& item : parse_list("--figures", list)) {
    const auto format = base::enum_from_name<FigureFormat>(item);
    if (!format) {
      throw InputError(fmt::format("--figures {}: {} is not a format; use png, svg, pdf or tex",
                                   base::sanitise(list), base::in_quotes(item)));
    }
    formats.push_back(*format);
  }
  return formats;
}

FigureWidth parse_width(const std::string& text) {
  const auto width = base::enum_from_name<FigureWidth>(text);
  if (!width || *width == FigureWidth::screen) {
    throw InputError(
        fmt::format("--figure-width {} (must be 85 or 170, in mm)", base::in_quotes(text)));
  }
  return *width;
}

}  // namespace

po::options_description make_figure_options(report::FigureOptions& figures) {
  po::options_description options;
  options.add_options()  //
      ("figures",
       po::value<std::string>()->value_name("LIST")->notifier(
           [&figures](const std::string& list) { figures.formats = parse_formats(list); }),
       "formats of the figures, separated by commas: png (default), svg, pdf, tex (for LaTeX)")  //
      ("figure-width",
       po::value<std::string>()->value_name("MM")->notifier(
           [&figures](const std::string& text) { figures.width = parse_width(text); }),
       "width of the figures in mm: 85 or 170, one or two columns of a printed page (default: size "
       "for a screen)");
  return options;
}

po::options_description make_case_figure_options(report::FigureOptions& figures) {
  po::options_description options = make_figure_options(figures);
  options.add_options()(
      "curves",
      po::value<std::string>()->value_name("LIST")->notifier(
          [&figures](const std::string& list) { figures.curves = parse_list("--curves", list); }),
      "solutions in the figures of a case: ids, families or solvers separated by commas, or all "
      "(default: densities from files, and up to six curves: the reference, other solutions of the "
      "problem, and the closest closure of each formulation)");
  return options;
}

}  // namespace fpkcheck::cli
