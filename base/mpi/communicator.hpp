#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fpkcheck::base {

/// Communication between the MPI processes of this run. Only the thread that called
/// initialise_mpi() may use the MPI communicator.
class Communicator {
 public:
  struct Message {
    int from;
    std::string text;
  };

  /// Returns whether the environment variables of a launcher (mpirun, srun --mpi) show several MPI
  /// processes.
  static bool launched_by_mpi();
  /// @throws InputError if the program was built without MPI
  static std::unique_ptr<Communicator> initialise_mpi();

  virtual ~Communicator() = default;

  virtual int process_rank() const = 0;
  virtual int process_count() const = 0;
  bool is_first_rank() const { return process_rank() == 0; }

  virtual void send(int to, const std::string& text) = 0;
  /// Returns the next arrived message; nullopt, without waiting, if no message has arrived.
  virtual std::optional<Message> receive() = 0;
  /// Collects the texts of all MPI processes on rank 0; every MPI process must call gather().
  /// @param poll function that rank 0 calls while waiting; an exception of `poll` ends the wait
  /// @return on rank 0 the texts of the other MPI processes by rank; on other ranks an empty list
  std::vector<std::string> gather(const std::string& own, const std::function<void()>& poll);
  /// Ends all MPI processes of this run. An MPI process that fails must call abort(), since the
  /// other processes would otherwise wait forever for its messages.
  [[noreturn]] virtual void abort(int exit_code) = 0;

 private:
  /// Texts that MPI processes have sent for the next call of gather(), by rank of the sender.
  std::map<int, std::deque<std::string>> gathered_;
};

}  // namespace fpkcheck::base
