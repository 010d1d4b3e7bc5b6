#pragma once

#include <memory>
#include <optional>
#include <string>

namespace fpkcheck::base {

/// The MPI processes of this run. Only the thread that called join() may use the object. Rank 0
/// writes; the other ranks compute.
class Communicator {
 public:
  /// A message from another rank.
  struct Message {
    int from;
    std::string text;
  };

  /// Whether mpirun, srun --mpi or a similar launcher started several processes, judged by
  /// environment variables.
  static bool launched_by_mpi();
  /// Initialises MPI.
  /// @throws InputError where the program was built without MPI
  static std::unique_ptr<Communicator> join();

  virtual ~Communicator() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  bool is_first() const { return rank() == 0; }

  virtual void send(int to, const std::string& text) = 0;
  /// The next message that has arrived; nothing when there is none. Does not block.
  virtual std::optional<Message> receive() = 0;
  /// Ends all processes. Called when this process fails, since the others would wait for its
  /// messages.
  [[noreturn]] virtual void abort(int exit_code) = 0;
};

}  // namespace fpkcheck::base
