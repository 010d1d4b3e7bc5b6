#include "compare/study/regularisation.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compare/summary.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json eigenvalue_of(const std::optional<std::complex<double>>& value) {
  return value ? Json{{"re", value->real()}, {"im", value->imag()}} : Json();
}

Json row_of(const problem::Problem& problem, const fd_fpk::RegularisationRow& row) {
  return {{"scheme", row.scheme},
          {"step", row.step},
          {"length", row.length > 0 ? Json(row.length) : Json()},
          {"nx", row.nx},
          {"nv", row.nv},
          {"symbol_rate", row.symbol ? Json(row.symbol->rate) : Json()},
          {"symbol_wavenumber", row.symbol ? Json(row.symbol->wavenumber) : Json()},
          {"symbol_grows", row.symbol ? Json(grows(*row.symbol, problem.impulses)) : Json()},
          {"rightmost", eigenvalue_of(row.rightmost)},
          {"next", eigenvalue_of(row.next)},
          {"growth_rate", or_null(row.growth(problem))},
          {"l1_y", or_null(row.l1_y)},
          {"l1_ydot", or_null(row.l1_ydot)},
          {"min_density", or_null(row.min_density)},
          {"remark", row.remark}};
}

}  // namespace

Json regularisation_report(const std::string& command, const problem::Problem& problem,
                           const fd_fpk::RegularisationStudy& study) {
  const std::array cases{CaseReport{problem, {}, {}, {}, {}}};
  const Json common = summary(command, cases);
  const Json& of_case = common.at("cases").at(0);
  Json rows = Json::array();
  for (const auto& row : study.rows) rows.push_back(row_of(problem, row));
  return {{"schema", kSummarySchema},
          {"program", common.at("program")},
          {"study", "regularisation"},
          {"name", of_case.at("name")},
          {"system", of_case.at("system")},
          {"impulse", of_case.at("impulse")},
          {"default_length", study.default_length},
          {"shortest_length", study.shortest_length},
          {"rows", rows}};
}

std::string regularisation_csv(const Json& report) {
  std::string text =
      "scheme,step,length,nx,nv,symbol_rate,symbol_wavenumber,rightmost_re,rightmost_im,next_re,"
      "next_im,growth_rate,l1_y,l1_ydot,min_density\n";
  const auto field = [](const Json& value) { return value.is_null() ? "" : value.dump(); };
  const auto part = [&](const Json& value, const char* key) {
    return value.is_null() ? std::string() : field(value.at(key));
  };
  for (const auto& row : report.at("rows")) {
    text += row.at("scheme").get<std::string>();
    for (const char* key : {"step", "length", "nx", "nv", "symbol_rate", "symbol_wavenumber"}) {
      text += ',' + field(row.at(key));
    }
    for (const char* key : {"rightmost", "next"}) {
      text += ',' + part(row.at(key), "re") + ',' + part(row.at(key), "im");
    }
    for (const char* key : {"growth_rate", "l1_y", "l1_ydot", "min_density"}) {
      text += ',' + field(row.at(key));
    }
    text += '\n';
  }
  return text;
}

}  // namespace fpkcheck::compare
