#pragma once

#include <boost/program_options.hpp>

#include "report/figure/options.hpp"

namespace fpkcheck::cli {

/// --figures and --figure-width.
/// @param figures gets what is given; kept by reference
/// @throws InputError from parsing: the option, the text and what is allowed
boost::program_options::options_description figure_options(report::FigureOptions& figures);

/// The same, and --curves of the pictures of cases.
boost::program_options::options_description case_figure_options(report::FigureOptions& figures);

}  // namespace fpkcheck::cli
