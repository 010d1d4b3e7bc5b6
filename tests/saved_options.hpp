#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "problem/input_error.hpp"

/// What holds of the options of every solver.
namespace fpkcheck::tests {

/// Options come back from JSON text as they were, each field by itself; a field that is missing,
/// unknown or of the wrong type is refused by name.
/// @param changed options in which every field differs from its default and from every other
/// @param read    options_from_json of the solver
template <class Options, class Read>
void expect_round_trip(const Options& changed, const Read& read) {
  using Json = nlohmann::ordered_json;
  const Json saved = to_json(changed), defaults = to_json(Options{});
  EXPECT_EQ(to_json(read(Json::parse(saved.dump()))), saved);
  EXPECT_EQ(to_json(read(Json::parse(defaults.dump()))), defaults);
  const auto refused = [&](const Json& json, const std::string& key) {
    try {
      read(json);
      ADD_FAILURE() << "accepted " << json.dump();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("options." + key), std::string::npos)
          << error.what();
    }
  };
  for (const auto& [key, value] : saved.items()) {
    EXPECT_NE(value, defaults.at(key)) << key << " is as by default: its way back is not tested";
    Json without = saved, wrong = saved;
    without.erase(key);
    refused(without, key);
    wrong[key] = Json::array();
    refused(wrong, key);
  }
  Json more = saved;
  more["colour"] = 1;
  refused(more, "colour");
}

}  // namespace fpkcheck::tests
