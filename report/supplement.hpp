#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"

namespace fpkcheck::report {

/// A file that a command adds to the files of a run.
struct ExtraFile {
  std::string name, text;
};

/// A gnuplot script, with the file name (without extension) that the script and its pictures share.
struct PictureScript {
  std::string stem, script;
};

/// A section that a command adds to the page of a run.
struct PageSection {
  std::string anchor;   ///< id of the HTML element of the section, for links
  std::string heading;  ///< plain text
  std::string html;     ///< content below the heading, includes plots_html() of all plots
  /// Groups of plots: the legend of a group hides or shows curves in all plots of this group and in
  /// no other plot.
  std::vector<std::vector<Plot>> groups;
};

/// The texts, files, pictures and page sections that a command adds to the report of a run.
struct Supplement {
  /// The result of the command in sentences, printed before the tables; the page also begins with
  /// the first sentence.
  std::vector<std::string> summary;
  std::string text;  ///< printed after the tables
  std::vector<PageSection> sections;
  std::vector<ExtraFile> files;
  std::vector<PictureScript> pictures;  ///< drawn into figures/
};

}  // namespace fpkcheck::report
