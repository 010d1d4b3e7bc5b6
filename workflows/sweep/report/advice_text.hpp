#pragma once

#include <functional>
#include <string>

#include "methods/registry.hpp"
#include "report/text/format.hpp"
#include "workflows/sweep/map/advice.hpp"

namespace fpkcheck::sweep {

/// The context of a recommendation: the name of the problem, and the commands that the user can
/// type.
struct AdviceContext {
  std::string name;                                           ///< of the problem
  std::function<std::string(const std::string& id)> command;  ///< command for a method's id
  /// Commands for methods with error estimates, which are shown if no method is recommended.
  std::vector<std::string> fallback_commands;
  const methods::Registry& registry;
};

/// The recommendation as text for the terminal: the recommended command, the results at nearby
/// points of the validity map, and warnings.
std::string advice_text(const Advice& advice, const AdviceContext& context,
                        const report::TextFormat& format);

/// The recommendation in JSON, for --json.
std::string advice_json(const Advice& advice, const AdviceContext& context,
                        const std::string& command_line);

}  // namespace fpkcheck::sweep
