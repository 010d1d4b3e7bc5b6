#include "problem/frame.hpp"

#include "problem/problem.hpp"

namespace fpkcheck::problem {

Frame frame_of(const System& system) {
  if (system.left()) return {.origin = system.left()->position, .mirrored = false};
  if (system.right()) return {.origin = system.right()->position, .mirrored = true};
  return {};
}

Problem seen_from(const Frame& frame, const Problem& problem) {
  if (frame.is_identity()) return problem;
  Problem seen = problem;
  seen.system = problem.system.seen_from(frame);
  seen.frame = frame;
  if (frame.mirrored) seen.impulses = problem.impulses.mirrored();
  return seen;
}

}  // namespace fpkcheck::problem
