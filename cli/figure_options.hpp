#pragma once

#include <boost/program_options.hpp>

#include "report/figure/options.hpp"

namespace fpkcheck::cli {

/// --figures and --figure-width.
/// @param figures receives the parsed values; kept by reference
/// @throws InputError while parsing: with the option, its text and the allowed values
boost::program_options::options_description figure_options(report::FigureOptions& figures);

/// --figures, --figure-width, and --curves for the figures of a case.
boost::program_options::options_description case_figure_options(report::FigureOptions& figures);

}  // namespace fpkcheck::cli
