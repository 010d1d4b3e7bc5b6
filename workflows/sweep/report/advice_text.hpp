#pragma once

#include <functional>
#include <string>

#include "methods/registry.hpp"
#include "report/text/format.hpp"
#include "workflows/sweep/map/advice.hpp"

namespace fpkcheck::sweep {

/// What an advice is given besides what it says: who is advised, and what to type.
struct AdviceSetting {
  std::string name;                                           ///< of the problem
  std::function<std::string(const std::string& id)> command;  ///< that solves it by a method
  /// What to type where nothing is promised: methods that tell their own errors.
  std::vector<std::string> otherwise;
  const methods::Registry& registry;
};

/// The advice for people: what to type, what the best gave nearby, what misleads there.
std::string advice_text(const Advice& advice, const AdviceSetting& setting,
                        const report::TextFormat& format);

/// For --json.
std::string advice_json(const Advice& advice, const AdviceSetting& setting,
                        const std::string& command_line);

}  // namespace fpkcheck::sweep
