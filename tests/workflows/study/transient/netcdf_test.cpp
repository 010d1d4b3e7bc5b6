#include <gtest/gtest.h>

#include "made_up_transient.hpp"
#include "results/opened_netcdf.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::study {
namespace {

TEST(TransientNetCdf, HasTheMarginalsWithNamedAxes) {
  const tests::TemporaryDirectory directory;
  const TransientRun run = tests::made_up_transient();
  write_transient_netcdf(directory.path() / "transient.nc", run);
  const tests::OpenedNetCdf file(directory.path() / "transient.nc");

  EXPECT_EQ(file.dimensions("p_y"), (std::vector<std::string>{"time", "y"}));
  EXPECT_EQ(file.dimensions("p_ydot"), (std::vector<std::string>{"time", "ydot"}));
  EXPECT_EQ(file.dimensions("y_bounds"), (std::vector<std::string>{"y", "bounds"}));
  EXPECT_EQ(file.values("time", 5), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(file.values("y", 4), (std::vector<double>{0.25, 0.75, 1.5, 2.5}));
  EXPECT_EQ(file.values("y_bounds", 8), (std::vector<double>{0, 0.5, 0.5, 1, 1, 2, 2, 3}));
  EXPECT_EQ(file.values("ydot", 6).front(), -2.5);
  EXPECT_EQ(file.values("p_y", 20)[4 * 3 + 2], 1.0 / 6);                // n = 3, b = 2
  EXPECT_EQ(file.values("p_ydot", 30)[6 * 4 + 5], 0.1 * 5 + 0.01 * 4);  // n = 4, b = 5
  EXPECT_EQ(file.values("y2", 5), (std::vector<double>{10, 11, 12, 13, 14}));

  for (const char* variable : {"time", "y", "ydot", "p_y", "p_ydot", "y2", "energy"}) {
    EXPECT_EQ(file.text(variable, "units"), "1");
    EXPECT_FALSE(file.text(variable, "long_name").empty());
  }
  EXPECT_EQ(file.text("ydot", "bounds"), "ydot_bounds");
  EXPECT_EQ(file.text(nullptr, "Conventions"), "CF-1.8");
  EXPECT_EQ(file.text(nullptr, "command"), "fpkcheck fd it's --until 2");
  EXPECT_EQ(file.text(nullptr, "impulse_law"), "gaussian");
  EXPECT_EQ(file.number("restitution"), 0.98);
}

}  // namespace
}  // namespace fpkcheck::study
