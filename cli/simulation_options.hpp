#pragma once

#include <boost/program_options.hpp>
#include <cstdint>

#include "mcs/simulate.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {

/// --time, --seed and --threads, shared by `run` and `mcs`.
inline boost::program_options::options_description simulation_options(mcs::Options& options) {
  namespace po = boost::program_options;
  po::options_description description;
  description.add_options()  //
      ("time", po::value(&options.time)->value_name("T"),
       "simulated time over all streams (default: enough for the table to mean something)")(
          "seed",
          po::value<std::int64_t>()->value_name("S")->default_value(1)->notifier(
              [&options](std::int64_t seed) {
                if (seed < 0) throw InputError("--seed must not be negative");
                options.seed = static_cast<std::uint64_t>(seed);
              }),
          "seed of the simulation; the same seed gives the same result for any number of threads")(
          "threads", po::value(&options.threads)->value_name("N"),
          "threads to use (default: one per processor)");
  return description;
}

}  // namespace fpkcheck::cli
