#pragma once

#include <optional>
#include <vector>

#include "results/run.hpp"

/// The verdict on a run: what is known, who reproduces it, and whom to trust.
namespace fpkcheck::report {

/// Above this L1 distance of either marginal nobody is called close: the accuracy that closures are
/// held to unless told otherwise.
inline constexpr double kCloseL1 = 0.02;

/// How a solution stands to the reference of its case.
enum class Standing {
  absent,             ///< the case has no such solution
  no_density,         ///< nothing that could be called one: not found, or not admissible
  unjudged,           ///< a density, but nothing to measure it by
  reference,          ///< what the others are measured by
  indistinguishable,  ///< nearer to the reference than that knows itself
  close,              ///< both marginals within kCloseL1
  off                 ///< farther away
};

struct Stand {
  Standing standing = Standing::absent;
  const transform::Solution* solution = nullptr;  ///< null where it is absent
  std::optional<double> y{}, ydot{};              ///< L1 distances to the reference, where known

  /// The larger distance of those that are known.
  std::optional<double> farthest() const;
  /// Whether the solution is as good as the reference or within kCloseL1 of it.
  bool reproduces() const;
};

/// How the solution `id` stands in a case. A guest of one marginal is judged by that one.
Stand stand_in(const results::Case& one, std::string_view id);

/// A solution over the cases of a run, as a row of the matrix.
struct Record {
  const transform::Identity* identity;  ///< of the first case that has it
  std::vector<Stand> stands;            ///< in the order of the cases

  /// Of the cases that have it: how many there are, and in how many it reproduces the reference.
  int present() const;
  int reproduced() const;
  int count(Standing standing) const;
  /// Largest distances of any case, where there are any of a density.
  std::optional<double> largest(std::optional<double> Stand::*marginal) const;
  /// The larger of both.
  std::optional<double> farthest() const;
  /// Longest time of any case.
  double seconds() const;
};

/// All solutions of a run, each once: by increasing trust, as they stand in the cases.
std::vector<Record> records(const results::Run& run);

}  // namespace fpkcheck::report
