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
/// initialise_mpi() may use the object. Rank 0 writes the files; the other ranks compute.
class Communicator {
 public:
  /// A message from another MPI process, with the rank of the sender.
  struct Message {
    int from;
    std::string text;
  };

  /// Whether mpirun, srun --mpi or a similar launcher started several processes, according to the
  /// environment variables that launchers set.
  static bool launched_by_mpi();
  /// Initialises MPI and returns the communicator of all processes.
  /// @throws InputError if the program was built without MPI
  static std::unique_ptr<Communicator> initialise_mpi();

  virtual ~Communicator() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  bool is_first_rank() const { return rank() == 0; }

  virtual void send(int to, const std::string& text) = 0;
  /// Returns the next message that has arrived, or nothing if no message has arrived. Does not
  /// block.
  virtual std::optional<Message> receive() = 0;
  /// Collects the texts of all MPI processes on rank 0; every process must call this function.
  /// @param own text of this process
  /// @param poll function that rank 0 calls while it waits; an exception of `poll` ends the wait
  /// @return on rank 0 the texts of the other processes in the order of the ranks; else nothing
  std::vector<std::string> gather(const std::string& own, const std::function<void()>& poll);
  /// Ends all MPI processes of this run. Must be called when this process fails, since the other
  /// processes would wait forever for messages of this process.
  [[noreturn]] virtual void abort(int exit_code) = 0;

 private:
  /// Texts that gather() has received but not returned, by rank: a faster process may already send
  /// its text of the next call.
  std::map<int, std::deque<std::string>> gathered_;
};

}  // namespace fpkcheck::base
