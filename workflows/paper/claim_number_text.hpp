#pragma once

#include <optional>
#include <string>

/// Texts of the L1 distances and tail ratios with which the claims of the paper are judged; the
/// text of an absent number is empty.
namespace fpkcheck::paper {

std::string l1_distance_text(const std::optional<double>& l1);
std::string tail_text(const std::optional<double>& tail);

}  // namespace fpkcheck::paper
