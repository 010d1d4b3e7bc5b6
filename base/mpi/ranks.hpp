#pragma once

#include <memory>
#include <optional>
#include <string>

namespace fpkcheck::base {

/// The processes that mpirun started together, this one among them. Only the thread that joined may
/// use it. Rank 0 is the one that writes; the others are its helpers.
class Ranks {
 public:
  /// A text from another rank.
  struct Message {
    int from;
    std::string text;
  };

  /// Whether this process was started together with others (by mpirun, srun --mpi or the like), as
  /// the environment tells.
  static bool started_together();
  /// Joins them.
  /// @throws InputError where the program was built without MPI
  static std::unique_ptr<Ranks> join();

  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  bool is_first() const { return rank() == 0; }

  virtual void send(int to, const std::string& text) = 0;
  /// A message that has arrived, if there is one.
  virtual std::optional<Message> receive() = 0;
  /// Ends all of them, for when this one cannot go on and the others would wait for it.
  [[noreturn]] virtual void abort(int exit_code) = 0;
};

}  // namespace fpkcheck::base
