#include "methods/external/external_labels.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "transform/solution_identity.hpp"

namespace fpkcheck::methods {
namespace {

Method guest(const std::string& label, std::optional<int> order) {
  Method method;
  method.identity.id = label;
  method.identity.method = transform::kExternalFile;
  method.identity.family = transform::kExternalFile;
  method.identity.order = order;
  return method;
}

std::vector<std::string> families_after(std::vector<Method> guests) {
  group_methods_into_families(guests);
  std::vector<std::string> found;
  for (const auto& one : guests) found.push_back(one.identity.family);
  return found;
}

using Names = std::vector<std::string>;

TEST(ExternalFamilies, HaveLabelsThatEndWithTheirOrders) {
  EXPECT_EQ(families_after({guest("chi-n2", 2), guest("lab", {}), guest("chi-n4", 4),
                            guest("chi_12", 12), guest("psi6", 6), guest("psi.8", 8)}),
            (Names{"chi", "file", "chi", "chi", "psi", "psi"}));
}

TEST(ExternalFamilies, HaveAtLeastTwoMembers) {
  EXPECT_EQ(families_after({guest("chi-n2", 2), guest("psi-n4", 4)}), (Names{"file", "file"}));
  EXPECT_EQ(families_after({guest("chi-n2", {}), guest("chi-n4", {})}), (Names{"file", "file"}));
  EXPECT_EQ(families_after({guest("chi-n2", 6), guest("chi-n4", 6)}), (Names{"file", "file"}));
  EXPECT_EQ(families_after({guest("chi12", 2), guest("chi14", 4)}), (Names{"file", "file"}));
  EXPECT_EQ(families_after({guest("2", 2), guest("-n4", 4)}), (Names{"file", "file"}));
}

TEST(ExternalFamilies, HaveOneColourAndDashesByOrder) {
  std::vector<Method> guests{guest("psi", {}), guest("chi-n2", 2), guest("chi-n4", 4),
                             guest("chi-n6", 6)};
  group_methods_into_families(guests);
  std::set<std::string> colours, dashes;
  for (std::size_t k = 1; k < guests.size(); ++k) {
    colours.insert(guests[k].identity.plot_style.colour);
    dashes.insert(guests[k].identity.plot_style.dash);
    EXPECT_TRUE(transform::differs_by_order_in_family(guests[k].identity));
  }
  EXPECT_EQ(colours.size(), 1u);
  EXPECT_EQ(dashes.size(), 3u);
  EXPECT_FALSE(transform::differs_by_order_in_family(guests[0].identity));
}

}  // namespace
}  // namespace fpkcheck::methods
