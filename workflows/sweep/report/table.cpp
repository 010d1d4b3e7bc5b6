#include "workflows/sweep/report/table.hpp"

#include <fmt/format.h>

#include "report/text/wrap_text.hpp"
#include "workflows/sweep/report/method_columns.hpp"

namespace fpkcheck::sweep {

std::string table(const SweepResults& results, const report::TextFormat& format) {
  const Plan& plan = results.plan;
  std::string text = fmt::format("{} points of {}", results.points.size(), plan.base.name);
  for (const auto& axis : plan.axes) text += ", " + axis.text();
  text = report::wrap_text(text, format.width, 2) + '\n';
  text += report::table_rows_text(method_columns(results), format);
  return text + '\n' + report::wrap_text(method_columns_legend(), format.width);
}

}  // namespace fpkcheck::sweep
