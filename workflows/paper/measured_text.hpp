#pragma once

#include <optional>
#include <string>

/// Numbers of a judgement as text for tables and sentences; absent numbers are empty.
namespace fpkcheck::paper {

std::string l1_text(const std::optional<double>& l1);
std::string tail_text(const std::optional<double>& tail);

}  // namespace fpkcheck::paper
