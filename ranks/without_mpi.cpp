#include "parameters/input_error.hpp"
#include "ranks/ranks.hpp"

namespace fpkcheck::ranks {

std::unique_ptr<Ranks> Ranks::join() {
  throw InputError(
      "started by mpirun, but built without MPI (build with libopenmpi-dev installed, or start "
      "each process with --shard i/N)");
}

}  // namespace fpkcheck::ranks
