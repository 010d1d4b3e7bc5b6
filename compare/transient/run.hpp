#pragma once

#include <string>

#include "fd_fpk/transient.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::compare {

/// A density over time with what it was asked for: files, pictures and tables are made from it.
struct TransientRun {
  std::string command;  ///< the command line
  problem::Problem problem;
  fd_fpk::Options options;
  fd_fpk::TransientOptions transient;
  fd_fpk::TransientResult result;
};

}  // namespace fpkcheck::compare
