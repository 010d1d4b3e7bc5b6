#include "parameters/input_error.hpp"
#include "sweep/ranks/ranks.hpp"

namespace fpkcheck::sweep {

std::unique_ptr<Ranks> Ranks::join() {
  throw InputError(
      "started by mpirun, but built without MPI (build with libopenmpi-dev installed, or start "
      "each process with --shard i/N)");
}

}  // namespace fpkcheck::sweep
