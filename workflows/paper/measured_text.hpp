#pragma once

#include <optional>
#include <string>

/// Numbers of a judgement as tables and sentences show them; empty for what is not there.
namespace fpkcheck::paper {

std::string l1_text(const std::optional<double>& l1);
std::string tail_text(const std::optional<double>& tail);

}  // namespace fpkcheck::paper
