#pragma once

#include <functional>
#include <string>

#include "methods/registry.hpp"
#include "report/text/text_layout.hpp"
#include "workflows/sweep/map/method_advice.hpp"

namespace fpkcheck::sweep {

struct RecommendationContext {
  std::string name;  ///< name of the problem
  /// Function that returns the command line for a method with the given id.
  std::function<std::string(const std::string& id)> command;
  /// Command lines that use methods with error estimates, shown if no method is recommended.
  std::vector<std::string> fallback_commands;
  const methods::SolverRegistry& registry;
};

/// Returns a text with the recommended command, the results at nearby points of the validity map,
/// and warnings.
std::string recommendation_text(const MethodRecommendation& advice,
                                const RecommendationContext& context,
                                const report::TerminalTextFormat& format);

/// Returns the recommendation of methods as JSON, the output of --json.
std::string recommendation_json(const MethodRecommendation& advice,
                                const RecommendationContext& context,
                                const std::string& command_line);

}  // namespace fpkcheck::sweep
