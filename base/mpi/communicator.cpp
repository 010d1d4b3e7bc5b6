#include "base/mpi/communicator.hpp"

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <utility>

namespace fpkcheck::base {

bool Communicator::launched_by_mpi() {
  // Open MPI's mpirun and launchers with PMI (MPICH, Intel MPI, srun --mpi=pmi2) set
  // OMPI_COMM_WORLD_SIZE, PMI_SIZE or MPI_LOCALNRANKS to the number of processes.
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"}) {
    const char* const text = std::getenv(variable);
    if (text == nullptr) continue;
    const std::string_view number(text);
    int size = 0;
    std::from_chars(number.data(), number.data() + number.size(), size);
    if (size > 1) return true;
  }
  // The launcher srun --mpi=pmix sets the number of processes only in the Slurm variable
  // SLURM_NTASKS.
  const char* const tasks = std::getenv("SLURM_NTASKS");
  return std::getenv("PMIX_RANK") != nullptr && tasks != nullptr && std::string_view(tasks) != "1";
}

std::vector<std::string> Communicator::gather(const std::string& own,
                                              const std::function<void()>& poll) {
  if (!is_first_rank()) {
    send(0, own);
    return {};
  }
  std::vector<std::string> others;
  for (int rank = 1; rank < process_count(); ++rank) {
    auto& texts = gathered_[rank];
    while (texts.empty()) {
      poll();
      if (auto message = receive()) {
        gathered_[message->from].push_back(std::move(message->text));
      } else {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
    others.push_back(std::move(texts.front()));
    texts.pop_front();
  }
  return others;
}

}  // namespace fpkcheck::base
