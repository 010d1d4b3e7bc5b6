#include "mcs/simulation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <istream>
#include <mutex>
#include <ostream>
#include <span>
#include <thread>

#include "problem/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::size_t kGroup = 8;  // streams that a thread takes at a time

template <class Number>
void put(std::ostream& out, const Number& number) {
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class Number>
void get(std::istream& in, Number& number) {
  in.read(reinterpret_cast<char*>(&number), sizeof number);
}

// Most cells are empty: runs of zeros are stored as their length.
void put(std::ostream& out, const std::vector<double>& numbers) {
  put(out, std::uint64_t{numbers.size()});
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t zeros = k;
    while (zeros < numbers.size() && numbers[zeros] == 0) ++zeros;
    std::size_t end = zeros;
    while (end < numbers.size() && numbers[end] != 0) ++end;
    put(out, std::uint64_t{zeros - k});
    put(out, std::uint64_t{end - zeros});
    for (std::size_t i = zeros; i < end; ++i) put(out, numbers[i]);
    k = end;
  }
}

void get(std::istream& in, std::vector<double>& numbers, std::uint64_t most) {
  const auto require = [&](bool holds) {
    if (!holds) throw InputError("its numbers do not fit together");
  };
  std::uint64_t size = 0;
  get(in, size);
  require(in && size <= most);
  numbers.assign(size, 0.0);
  for (std::uint64_t k = 0; k < size;) {
    std::uint64_t zeros = 0, others = 0;
    get(in, zeros);
    get(in, others);
    require(in && zeros <= size - k && others <= size - k - zeros && zeros + others > 0);
    k += zeros;
    for (const std::uint64_t end = k + others; k < end; ++k) get(in, numbers[k]);
  }
  require(static_cast<bool>(in));
}

}  // namespace

Simulation::Simulation(const problem::Problem& problem, const Plan& plan,
                       const Splitting* splitting)
    : plan_(&plan),
      motion_{.system = problem.system,
              .step = plan.step,
              .sampling_interval = plan.sampling_interval,
              .y_bins = &plan.y_bins,
              .v_bins = &plan.v_bins,
              .splitting = splitting,
              .shift = plan.excitation.shift} {
  for (int s = 0; s < plan.streams; ++s) {
    ImpulseSource source(plan.excitation, plan.seed, static_cast<std::uint32_t>(s));
    const auto normals = source.standard_normals();
    const double z = plan.displacement_deviation * normals[0];
    const double z_dot = plan.velocity_deviation * normals[1];
    const Impulse first = source.next();
    streams_.push_back({.branch = {.y = std::abs(z),
                                   .v = std::copysign(1.0, z) * z_dot,
                                   .until_impulse = first.waiting,
                                   .amplitude = first.amplitude,
                                   .until_sample = plan.sampling_interval / 2,
                                   .remaining = 0},
                        .source = source,
                        .record = StreamRecord(plan.y_bins, plan.v_bins)});
  }
}

void Simulation::burn_in() {
  Motion unseen = motion_;
  unseen.records = false;
  unseen.splitting = nullptr;
  move(unseen, plan_->burn_in);
}

void Simulation::round() {
  move(motion_, plan_->round_time());
  ++rounds_;
}

void Simulation::move(const Motion& motion, double time) {
  static const LaneSet lanes = available_lanes().back();
  const std::size_t groups = (streams_.size() + kGroup - 1) / kGroup;
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // guards the failure
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t g = next++; g < groups; g = next++) {
      try {
        std::vector<Stream*> group;
        for (std::size_t s = g * kGroup; s < std::min((g + 1) * kGroup, streams_.size()); ++s) {
          group.push_back(&streams_[s]);
        }
        advance(motion, group, time, lanes);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = groups;  // nobody begins another group
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int t = 1; t < plan_->threads; ++t) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

void Simulation::save(std::ostream& out) const {
  put(out, rounds_);
  for (const Stream& stream : streams_) {
    const StreamRecord& r = stream.record;
    put(out, stream.branch);
    put(out, stream.source.number());
    put(out, r.powers);
    for (const double sum : {r.samples, r.impacts, r.impact_energy, r.work}) put(out, sum);
    for (const std::uint64_t count : {r.impulses, r.flights}) put(out, count);
    for (const auto* sums : {&r.histogram.weights(), &r.peaks, &r.troughs, &r.energies}) {
      put(out, *sums);
    }
  }
}

void Simulation::load(std::istream& in) {
  get(in, rounds_);
  for (Stream& stream : streams_) {
    StreamRecord& r = stream.record;
    std::uint64_t number = 0;
    get(in, stream.branch);
    get(in, number);
    stream.source.continue_from(number);
    get(in, r.powers);
    for (double* sum : {&r.samples, &r.impacts, &r.impact_energy, &r.work}) get(in, *sum);
    for (std::uint64_t* count : {&r.impulses, &r.flights}) get(in, *count);
    for (auto* sums : {&r.histogram.weights(), &r.peaks, &r.troughs}) {
      const std::size_t size = sums->size();
      get(in, *sums, size);
      if (sums->size() != size) throw InputError("it has other bins");
    }
    constexpr std::uint64_t kMostEnergyBins = 100000;
    get(in, r.energies, kMostEnergyBins);
  }
}

}  // namespace fpkcheck::mcs
