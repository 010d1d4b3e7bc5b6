#include "mcs/advance_lanes.hpp"
#include "mcs/impulse_lanes.hpp"
#include "mcs/instruction_set.hpp"

namespace fpkcheck::mcs::avx2 {

void move(const Motion& motion, Stream* const* streams, int width) {
  switch (width) {
    case 4:
      return move_lanes<4>(motion, streams);
  }
}

void make_impulses(const Excitation& excitation, const Uniforms& uniforms, double* waiting,
                   double* amplitude) {
  impulses_in_lanes(excitation, uniforms, waiting, amplitude);
}

}  // namespace fpkcheck::mcs::avx2
