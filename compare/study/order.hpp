#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/run_cases.hpp"
#include "compare/text/format.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::compare {

/// What to study: every formulation at every order.
struct OrderStudyOptions {
  std::vector<std::string> formulations;  ///< ids without "epc-" and "-nN": gaussian, moment, ..
  std::vector<int> orders;
};

/// The solution that closures are measured by.
inline constexpr const char* kOrderStudyReference = "fd-kf";

/// Solves a problem by the closures asked for and by finite differences, one after the other so
/// that the times mean something, and returns the contents of study-order.json: program, name,
/// system and impulse of the case as in summary.json, the reference's id, status and reason, and a
/// row per formulation and order, null where there is no number:
///  - what summary.json has of the solution, but for its options and moments;
///  - l1_y, l1_ydot: L1 distances of the marginals to the reference;
///  - tail_y, tail_ydot: mean difference of log10 p over reference densities 1e-5 .. 1e-4.
/// @param command the command line of the run
/// @throws InputError naming what is no formulation or no order of one
nlohmann::ordered_json study_orders(const std::string& command, const problem::Problem& problem,
                                    const OrderStudyOptions& options,
                                    const ProgressListener& listener);

/// The rows as study-order.csv, under a header; empty where a row has no number.
std::string order_csv(const nlohmann::ordered_json& report);

/// The rows as a table, reasons, folds met, and what the numbers say, in sentences.
/// @param format the least important columns go where the rows do not fit
std::string order_table(const nlohmann::ordered_json& report, const TextFormat& format = {});

/// A gnuplot script: L1 distances over the order, and below them the branches that were followed.
std::string order_figure(const nlohmann::ordered_json& report, const std::string& file_stem);

}  // namespace fpkcheck::compare
