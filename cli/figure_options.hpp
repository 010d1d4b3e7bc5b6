#pragma once

#include <boost/program_options.hpp>

#include "report/figure/options.hpp"

namespace fpkcheck::cli {

/// Description of the options --figures and --figure-width.
/// @param figures receives the parsed values; stored by reference
/// @throws InputError during parsing; the message names the option, its text and the allowed values
boost::program_options::options_description make_figure_options(report::FigureOptions& figures);

/// Description of the options --figures, --figure-width and --curves, for the figures of a case.
boost::program_options::options_description make_case_figure_options(
    report::FigureOptions& figures);

}  // namespace fpkcheck::cli
