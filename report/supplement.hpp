#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"

namespace fpkcheck::report {

/// A file that a command adds to those of a run.
struct FileBeside {
  std::string name, text;
};

/// A gnuplot script, and the name without extension under which it and its pictures are filed.
struct Picture {
  std::string stem, script;
};

/// A section that a command adds to the page of a run.
struct PageSection {
  std::string anchor;   ///< id of the section's element, for links
  std::string heading;  ///< plain text
  std::string html;     ///< below the heading; with plots_html() of all plots
  /// The legends of one group switch curves in that group alone.
  std::vector<std::vector<Plot>> groups;
};

/// What a command adds to the report of a run.
struct Supplement {
  /// The command's answer in sentences: printed before the tables; the first one opens the page.
  std::vector<std::string> summary;
  std::string text;  ///< printed after the tables
  std::vector<PageSection> sections;
  std::vector<FileBeside> files;
  std::vector<Picture> pictures;  ///< drawn into figures/
};

}  // namespace fpkcheck::report
