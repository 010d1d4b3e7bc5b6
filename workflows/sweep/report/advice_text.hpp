#pragma once

#include <functional>
#include <string>

#include "methods/registry.hpp"
#include "report/text/format.hpp"
#include "workflows/sweep/map/advice.hpp"

namespace fpkcheck::sweep {

/// Context of an advice: the problem's name, and the commands to type.
struct AdviceContext {
  std::string name;                                           ///< of the problem
  std::function<std::string(const std::string& id)> command;  ///< command for a method's id
  /// Commands for methods with error estimates, shown where no method is recommended.
  std::vector<std::string> fallback_commands;
  const methods::Registry& registry;
};

/// Text for the terminal: the recommended command, results at nearby points, and warnings.
std::string advice_text(const Advice& advice, const AdviceContext& setting,
                        const report::TextFormat& format);

/// JSON for --json.
std::string advice_json(const Advice& advice, const AdviceContext& setting,
                        const std::string& command_line);

}  // namespace fpkcheck::sweep
