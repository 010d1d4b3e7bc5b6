// Fuzzer of checkpoints of the simulation: the bytes as a file, and as the state in a file with a
// valid header and checksum.
#include "mcs/simulation/checkpoint.hpp"

#include "fuzz_helpers.hpp"
#include "problem/case_file.hpp"

namespace {

using namespace fpkcheck;

struct SmallSimulation {
  problem::Problem problem = problem::load_case("case1");
  mcs::SimulationPlan plan = mcs::make_simulation_plan(
      problem, {.time = 100, .streams = 8, .y_edges = {0, 1, 2}, .v_edges = {-1, 0, 1}});
  std::string fingerprint = mcs::simulation_fingerprint(problem, plan, nullptr);
};

std::string make_checkpoint(const std::string& fingerprint, std::string_view state) {
  std::string text = std::string(mcs::kCheckpointFormatLine) + fingerprint + '\n';
  text += state;
  std::uint64_t sum = 14695981039346656037u;  // FNV-1a
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const SmallSimulation small;
  const std::string_view bytes = fuzz::as_text(data, size);
  for (const std::string& contents :
       {std::string(bytes), make_checkpoint(small.fingerprint, bytes)}) {
    fuzz::catch_input_errors([&] {
      mcs::Simulation simulation(small.problem, small.plan);
      mcs::read_checkpoint(fuzz::write_file("state", contents), small.fingerprint, simulation);
    });
  }
  return 0;
}
