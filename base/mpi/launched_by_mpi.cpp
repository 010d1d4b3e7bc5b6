#include <charconv>
#include <cstdlib>
#include <string_view>

#include "base/mpi/communicator.hpp"

namespace fpkcheck::base {

bool Communicator::launched_by_mpi() {
  // These variables are set by mpirun of Open MPI and by launchers that use PMI (MPICH, Intel MPI,
  // srun --mpi=pmi2).
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"}) {
    const char* const text = std::getenv(variable);
    if (text == nullptr) continue;
    const std::string_view number(text);
    int size = 0;
    std::from_chars(number.data(), number.data() + number.size(), size);
    if (size > 1) return true;
  }
  // srun --mpi=pmix sets the number of processes only in a variable of Slurm.
  const char* const tasks = std::getenv("SLURM_NTASKS");
  return std::getenv("PMIX_RANK") != nullptr && tasks != nullptr && std::string_view(tasks) != "1";
}

}  // namespace fpkcheck::base
