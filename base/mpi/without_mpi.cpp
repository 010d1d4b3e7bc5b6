#include "base/input_error.hpp"
#include "base/mpi/communicator.hpp"

namespace fpkcheck::base {

std::unique_ptr<Communicator> Communicator::initialise_mpi() {
  throw InputError(
      "started by mpirun, but built without MPI: install libopenmpi-dev and build again, or start "
      "each process with --shard i/N");
}

}  // namespace fpkcheck::base
