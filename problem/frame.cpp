#include "problem/frame.hpp"

#include "problem/problem.hpp"

namespace fpkcheck::problem {

Frame wall_frame(const System& system) {
  if (system.left()) return {.origin = system.left()->position, .mirrored = false};
  if (system.right()) return {.origin = system.right()->position, .mirrored = true};
  return {};
}

Problem to_wall_coordinates(const Frame& frame, const Problem& problem) {
  if (frame.is_identity()) return problem;
  Problem transformed = problem;
  transformed.system = problem.system.to_wall_coordinates(frame);
  transformed.frame = frame;
  if (frame.mirrored) transformed.impulses = problem.impulses.mirrored();
  return transformed;
}

}  // namespace fpkcheck::problem
