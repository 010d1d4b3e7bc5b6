#include "mcs/impulses/impulse_block_simd.hpp"
#include "mcs/motion/advance_trajectories_simd.hpp"

namespace fpkcheck::mcs::avx2 {

ImpulseBlock make_impulse_block(const ImpulseProcess& excitation,
                                const UniformRandomNumbers& uniforms) {
  return draw_impulse_block(excitation, uniforms);
}

void advance_trajectory_streams(const StreamMotionParameters& motion,
                                TrajectoryStream* const* streams, int stream_count) {
  advance_lane_group<4>(motion, streams, stream_count);
}

}  // namespace fpkcheck::mcs::avx2
