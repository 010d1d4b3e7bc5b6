#include "mcs/simulation/checkpoint.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

class Checkpoint : public testing::Test {
 protected:
  Checkpoint() { std::filesystem::create_directories(directory_); }
  ~Checkpoint() override { std::filesystem::remove_all(directory_); }

  SimulationOptions brief(bool tails) const {
    return {.time = tails ? 3e3 : 2e4, .accuracy = 0.1, .streams = 10, .tails = tails};
  }
  SimulationResult interrupted(SimulationOptions options) const {
    options.checkpoint = file_;
    int rounds = 0;
    options.stop = [&] { return ++rounds == 3; };
    return simulate_stationary_density(problem_, options);
  }
  void expect_refused(const SimulationOptions& options, const std::string& why) const {
    try {
      simulate_stationary_density(problem_, options);
      FAIL() << "went on from a checkpoint: " << why;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(why), std::string::npos) << message;
      EXPECT_NE(message.find(file_), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos);
    }
  }

  std::filesystem::path directory_ = std::filesystem::temp_directory_path() /
                                     testing::UnitTest::GetInstance()->current_test_info()->name();
  std::string file_ = directory_ / "state";
  problem::Problem problem_ = tests::make_problem({.restitution = 0.7});
};

// A shutdown waits until open files are complete; afterwards no thread may write a file.
TEST_F(Checkpoint, IsNotWrittenDuringShutdown) {
  const auto wait_in_vain = [&] {
    base::wait_for_exit_blockers();
    std::thread([&] {
      SimulationOptions options = brief(false);
      options.checkpoint = file_;
      simulate_stationary_density(problem_, options);
    }).detach();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    std::_Exit(std::filesystem::is_empty(directory_) ? 0 : 1);
  };
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(wait_in_vain(), testing::ExitedWithCode(0), "");
}

TEST_F(Checkpoint, ResumesWithTheSameBits) {
  for (const bool tails : {false, true}) {
    SCOPED_TRACE(tails);
    SimulationOptions options = brief(tails);
    const SimulationResult whole = simulate_stationary_density(problem_, options);
    EXPECT_EQ(interrupted(options).summary.rounds, 3u);
    options.resume = file_;
    options.threads = 3;
    const SimulationResult resumed = simulate_stationary_density(problem_, options);
    EXPECT_EQ(resumed.summary.rounds, whole.summary.rounds);
    EXPECT_EQ(std::get<transform::GridDensity>(*resumed.solution.density).averages,
              std::get<transform::GridDensity>(*whole.solution.density).averages);
    EXPECT_EQ(resumed.solution.moments.y4, whole.solution.moments.y4);
    EXPECT_EQ(resumed.solution.standard_errors->moments.v2,
              whole.solution.standard_errors->moments.v2);
    EXPECT_EQ(resumed.summary.flights, whole.summary.flights);
    // The temporary file of the writer is removed.
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory_), {}), 1);
  }
}

TEST_F(Checkpoint, OfAnotherSimulationIsRefused) {
  interrupted(brief(false));
  const auto refused = [&](auto change) {
    SimulationOptions options = brief(false);
    options.resume = file_;
    change(options);
    expect_refused(options, "another simulation");
  };
  refused([](auto& o) { o.seed = 2; });
  refused([](auto& o) { o.streams = 11; });
  refused([](auto& o) { o.step = 0.5; });
  refused([](auto& o) { o.tails = true; });
  refused([](auto& o) { o.equation = DensityEquation::white; });
  refused([](auto& o) { o.v_edges = {-1, 0, 1}; });
  problem_ = tests::make_problem({.restitution = 0.71});
  refused([](auto&) {});
}

// Impulses of the same rate, mean and intensity that differ in skewness only.
TEST_F(Checkpoint, OfAnotherSkewnessIsRefused) {
  const auto under = [](double skewness) {
    return problem::ImpulseTrain(
        {.arrival_rate = 1, .law = "gamma", .intensity = 0.1, .mean = 0, .skewness = skewness});
  };
  problem_.impulses = under(0.8);
  SimulationOptions options = brief(false);
  interrupted(options);
  options.resume = file_;
  problem_.impulses = under(0.9);
  expect_refused(options, "another simulation");
  problem_.impulses = under(0.8);
  EXPECT_EQ(simulate_stationary_density(problem_, options).solution.status, transform::Status::ok);
}

TEST_F(Checkpoint, ThatIsDamagedIsRefused) {
  interrupted(brief(false));
  SimulationOptions options = brief(false);
  options.resume = file_;
  const auto size = std::filesystem::file_size(file_);
  {
    std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(size / 2));
    file.put('\x55').put('\xaa').put('\x33');
  }
  expect_refused(options, "damaged");
  std::filesystem::resize_file(file_, size / 3);
  expect_refused(options, "damaged");
  std::filesystem::resize_file(file_, 5);
  expect_refused(options, "no checkpoint");
  std::filesystem::remove(file_);
  expect_refused(options, "cannot read");
}

TEST_F(Checkpoint, OfAnEarlierVersionIsRefused) {
  interrupted(brief(false));
  std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(kCheckpointFormatLine.find('7')));
  file.put('4').flush();
  SimulationOptions options = brief(false);
  options.resume = file_;
  expect_refused(options, "no checkpoint of this version of fpkcheck mcs: its first line differs");
}

// The test forges the checksum.
TEST_F(Checkpoint, OfImpossibleNumbersIsRefusedWhateverItsChecksum) {
  interrupted(brief(false));
  std::ifstream in(file_, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  const auto write_with_checksum = [&](std::string text) {
    std::uint64_t sum = 14695981039346656037u;
    for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
    text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    std::ofstream(file_, std::ios::binary) << text;
  };
  const std::string text = whole.substr(0, whole.size() - sizeof(std::uint64_t));
  // After the second line: number of rounds, y, y', time to the next impulse, ..
  const std::size_t numbers = text.find('\n', text.find('\n') + 1) + 1;
  SimulationOptions options = brief(false);
  options.resume = file_;
  const auto with = [&](std::size_t place, auto number) {
    std::string changed = text;
    std::memcpy(&changed[numbers + place * sizeof number], &number, sizeof number);
    return changed;
  };
  write_with_checksum(text);
  EXPECT_NO_THROW(simulate_stationary_density(problem_, options));
  write_with_checksum(with(0, ~std::uint64_t{0}));
  expect_refused(options, "impossible");
  for (const double number : {HUGE_VAL, -HUGE_VAL, std::nan(""), 1e300, -1e300}) {
    for (const std::size_t place : {1, 2, 3, 4, 5, 6}) {
      SCOPED_TRACE(std::to_string(place) + ": " + std::to_string(number));
      write_with_checksum(with(place, number));
      expect_refused(options, "impossible");
    }
  }
  // In the file the sums are stored after the branch and the numbers of impulses and normal
  // numbers.
  for (const double number : {HUGE_VAL, std::nan("")}) {
    write_with_checksum(with(1 + sizeof(TrajectoryBranch) / sizeof(double) + 2, number));
    expect_refused(options, "impossible");
  }
  write_with_checksum(text + "more");
  expect_refused(options, "impossible");
}

TEST_F(Checkpoint, ThatCanNeverBeWrittenIsRefusedBeforeAnythingIsSolved) {
  SimulationOptions options = brief(true);
  options.progress = [](const SimulationProgress&) { FAIL() << "solved something"; };
  const auto refused = [&](const std::string& path) {
    file_ = path;
    options.checkpoint = path;
    expect_refused(options, "cannot write the checkpoint");
  };
  refused(directory_ / "nowhere" / "state");
  refused(directory_);
  EXPECT_TRUE(std::filesystem::is_empty(directory_));
  refused("/dev/null");
  // The user names a case file instead of a checkpoint file.
  const std::string mine = directory_ / "mine.ini";
  std::ofstream(mine) << "[system]\n";
  refused(mine);
  EXPECT_EQ(std::filesystem::file_size(mine), 9u);
}

TEST_F(Checkpoint, WriteErrorsAreWarningsOnly) {
  SimulationOptions options = brief(false);
  const SimulationResult expected = simulate_stationary_density(problem_, options);
  std::vector<std::string> told;
  options.checkpoint = file_;
  options.progress = [&](const SimulationProgress&) { std::filesystem::remove_all(directory_); };
  options.warn = [&](const std::string& warning) { told.push_back(warning); };
  const SimulationResult result = simulate_stationary_density(problem_, options);
  EXPECT_EQ(result.solution.status, transform::Status::ok);
  EXPECT_EQ(result.solution.moments.y4, expected.solution.moments.y4);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("cannot write the checkpoint " + file_), std::string::npos) << told[0];
  EXPECT_EQ(told[0].find('\n'), std::string::npos);
  EXPECT_EQ(result.summary.warnings, told);
}

// A directory with the name of the checkpoint file makes writes fail until the directory is
// removed. Two consecutive write errors cause one warning.
TEST_F(Checkpoint, RetriesAfterAWriteError) {
  std::vector<std::string> told;
  CheckpointWriter writer(file_, [&](const std::string& warning) { told.push_back(warning); });
  const SimulationPlan plan = make_simulation_plan(problem_, brief(false));
  Simulation simulation(problem_, plan);
  std::filesystem::create_directory(file_);
  writer.write_checkpoint_now("same", simulation);
  writer.write_checkpoint_now("same", simulation);
  EXPECT_EQ(told.size(), 1u);
  std::filesystem::remove(file_);
  writer.write_final_checkpoint("same", simulation);
  EXPECT_EQ(told.size(), 1u);
  EXPECT_NO_THROW(read_checkpoint(file_, "same", simulation));
  EXPECT_THROW(read_checkpoint(file_, "another", simulation), InputError);
}

TEST_F(Checkpoint, ExistingFileIsKeptUntilTheFirstWrite) {
  interrupted(brief(false));
  const auto size = std::filesystem::file_size(file_);
  const CheckpointWriter writer(file_, {});
  EXPECT_EQ(std::filesystem::file_size(file_), size);
  EXPECT_FALSE(std::filesystem::exists(file_ + ".part"));
}

}  // namespace
}  // namespace fpkcheck::mcs
