#pragma once

#include <string>
#include <vector>

#include "report/figure/run_gnuplot.hpp"
#include "report/page/page_plots.hpp"

namespace fpkcheck::report {

struct ReportSupplementFile {
  std::string name, text;
};

/// A section that a command such as `paper` adds to the report page of a run.
struct ReportPageSection {
  std::string anchor;  ///< id of the HTML element of the section, for links
  std::string heading;
  /// HTML of the page section below its heading, including plots_html() of all plots.
  std::string html;
  /// Groups of plots. A click on a legend entry of a plot hides or shows its curves in all plots of
  /// the group.
  std::vector<std::vector<ReportPagePlot>> groups;
};

/// The texts, files, pictures and page sections that a command adds to the report of a run.
struct ReportSupplement {
  /// Result of the command in sentences, printed before the tables of the run. The first sentence
  /// of the summary begins the report page.
  std::vector<std::string> summary;
  std::string text;
  std::vector<ReportPageSection> sections;
  std::vector<ReportSupplementFile> files;
  std::vector<PictureGnuplotScript>
      pictures;  ///< scripts of pictures, drawn into the directory figures/
};

}  // namespace fpkcheck::report
