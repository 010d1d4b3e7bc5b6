#include <mpi.h>

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

#include "base/mpi/communicator.hpp"

namespace fpkcheck::base {
namespace {

void check_mpi(int code, const char* what) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  throw std::runtime_error(fmt::format("MPI {}: {}", what, text.data()));
}

class MpiCommunicator : public Communicator {
 public:
  MpiCommunicator() {
    // MPI_THREAD_FUNNELED suffices, since the solver threads make no MPI calls.
    int provided = 0;
    check_mpi(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided),
              "cannot initialise");
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  MpiCommunicator(const MpiCommunicator&) = delete;
  MpiCommunicator& operator=(const MpiCommunicator&) = delete;
  ~MpiCommunicator() override { MPI_Finalize(); }

  int process_rank() const override { return rank_; }
  int process_count() const override { return size_; }

  void send(int to, const std::string& text) override {
    check_mpi(MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, 0, MPI_COMM_WORLD),
              "cannot send");
  }
  std::optional<Message> receive() override {
    int arrived = 0;
    MPI_Status status;
    check_mpi(MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &arrived, &status), "cannot probe");
    if (arrived == 0) return std::nullopt;
    int length = 0;
    MPI_Get_count(&status, MPI_CHAR, &length);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
    check_mpi(MPI_Recv(message.text.data(), length, MPI_CHAR, message.from, 0, MPI_COMM_WORLD,
                       MPI_STATUS_IGNORE),
              "cannot receive");
    return message;
  }
  [[noreturn]] void abort(int exit_code) override {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();  // unreachable, since MPI_Abort does not return
  }

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace

std::unique_ptr<Communicator> Communicator::initialise_mpi() {
  return std::make_unique<MpiCommunicator>();
}

}  // namespace fpkcheck::base
