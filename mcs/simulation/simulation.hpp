#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <vector>

#include "mcs/motion/advance.hpp"
#include "mcs/motion/general_motion.hpp"
#include "mcs/simulation/plan.hpp"

namespace fpkcheck::mcs {

/// The independent streams of a plan, going on in rounds. Threads take groups of whole streams and
/// a round ends for all of them, so that nothing depends on how many threads there are.
class Simulation {
 public:
  /// Streams from the Gaussian of equivalent linearisation folded to y >= 0, paper (5), or from
  /// GeneralStart, at the beginning of their burn-in.
  /// @param plan must outlive the simulation
  /// @param splitting none, or what must outlive it as well
  /// @throws InputError as Oscillator
  Simulation(const problem::Problem& problem, const Plan& plan,
             const Splitting* splitting = nullptr);

  /// From now on only every `parts`-th group of streams moves, from number `part` on; what others
  /// have simulated comes by load_part.
  void share(int part, int parts);

  /// From now on branches are split by other thresholds; energies are counted anew.
  /// @param splitting must outlive the simulation
  void split_by(const Splitting& splitting);

  void burn_in();
  void round();

  const Plan& plan() const { return *plan_; }
  std::uint64_t rounds() const { return rounds_; }
  /// Measured time of one stream.
  double stream_time() const { return static_cast<double>(rounds_) * plan_->round_time(); }
  /// Samples that a stream is expected to have: its weights sum up to it, exactly without
  /// splitting.
  double stream_samples() const {
    return static_cast<double>(rounds_) * static_cast<double>(plan_->samples_per_round);
  }
  const std::vector<Stream>& streams() const { return streams_; }

  /// All that the simulation is between two rounds.
  void save(std::ostream& out) const;
  /// @throws InputError when what is read is not the state of as many streams and bins
  void load(std::istream& in);

  /// The same of the streams that move here, or elsewhere in part number `part`.
  void save_part(std::ostream& out) const;
  void load_part(std::istream& in, int part);

 private:
  void begin_any(const problem::Problem& problem, const Splitting* splitting);
  /// @param move what moves some streams
  void move(const std::function<void(std::span<Stream* const>)>& move);
  void move(bool recorded, double time);
  bool is_of(int part, std::size_t stream) const;
  void save_stream(std::ostream& out, const Stream& stream) const;
  void load_stream(std::istream& in, Stream& stream) const;

  const Plan* plan_;
  std::optional<Motion> motion_;          // of the paper's oscillator
  std::optional<GeneralMotion> general_;  // of any other one
  std::uint64_t rounds_ = 0;
  int part_ = 0, parts_ = 1;
  std::vector<Stream> streams_;
};

/// One number of every stream, in their order.
template <class Of>
std::vector<double> each(const std::vector<Stream>& streams, Of of) {
  std::vector<double> values;
  for (const Stream& stream : streams) values.push_back(of(stream.record));
  return values;
}

}  // namespace fpkcheck::mcs
