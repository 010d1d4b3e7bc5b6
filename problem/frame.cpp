#include "problem/frame.hpp"

#include "problem/problem.hpp"

namespace fpkcheck::problem {

Frame wall_frame(const System& system) {
  if (system.left_wall()) return {.origin = system.left_wall()->position, .mirrored = false};
  if (system.right_wall()) return {.origin = system.right_wall()->position, .mirrored = true};
  return {};
}

Problem to_wall_coordinates(const Frame& frame, const Problem& problem) {
  if (frame.is_identity()) return problem;
  Problem transformed = problem;
  transformed.system = problem.system.to_wall_coordinates(frame);
  transformed.frame = frame;
  if (frame.mirrored) transformed.impulses = problem.impulses.mirror_image();
  return transformed;
}

}  // namespace fpkcheck::problem
