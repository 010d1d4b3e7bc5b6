#include <complex>

#include "workflows/study/regularisation.hpp"

namespace fpkcheck::study {

using base::Value;
using fd_fpk::FastestGrowingWave;
using transform::value_from_count;
using transform::value_from_optional;

namespace {

void add_eigenvalue(const std::string& name, const std::optional<std::complex<double>>& value,
                    Record& record) {
  if (!value) {
    record.push_back({name, {}});
    return;
  }
  record.push_back({name + ".re", value->real()});
  record.push_back({name + ".im", value->imag()});
}

}  // namespace

Record make_record(const RegularisationRow& row) {
  Record record{{"scheme", row.scheme},
                {"step", row.step},
                {"length", row.length > 0 ? Value(row.length) : Value()},  // none for pade
                {"nx", value_from_count(row.nx)},
                {"nv", value_from_count(row.nv)},
                {"symbol_rate", value(row.symbol, &FastestGrowingWave::rate)},
                {"symbol_wavenumber", value(row.symbol, &FastestGrowingWave::wavenumber)},
                {"symbol_grows", row.symbol ? Value(row.symbol_grows) : Value()},
                {"growth_rate", value_from_optional(row.growth_rate)},
                {"l1_y", value_from_optional(row.l1_y)},
                {"l1_ydot", value_from_optional(row.l1_ydot)},
                {"min_density", value_from_optional(row.min_density)},
                {"remark", row.remark}};
  add_eigenvalue("rightmost", row.rightmost, record);
  add_eigenvalue("next", row.next, record);
  return record;
}

std::string json(const RegularisationStudy& study, const std::string& command) {
  return study_json(
      RegularisationStudy::kName, study.problem, command,
      {{"default_length", study.default_length}, {"shortest_length", study.shortest_length}},
      {{"rows", records(study.rows)}});
}

std::string csv(const RegularisationStudy& study) {
  return csv_text(
      records(study.rows),
      "scheme step length nx nv symbol_rate symbol_wavenumber rightmost_re=rightmost.re rightmost_im=rightmost.im next_re=next.re next_im=next.im growth_rate l1_y l1_ydot min_density");
}

}  // namespace fpkcheck::study
