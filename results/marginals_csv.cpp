#include "results/marginals_csv.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>
#include <istream>
#include <ostream>

#include "base/input_error.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::results {
namespace {

constexpr std::string_view kHeader = "case,solution,variable,abscissa,density,lower,upper";
constexpr std::size_t kFields = 7;
constexpr std::size_t kMaxLineLength = 1000;

std::vector<std::string> split_csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool inside_quotes = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') {
      const bool doubled = inside_quotes && k + 1 < line.size() && line[k + 1] == '"';
      if (doubled) {
        fields.back() += '"';
        ++k;
      } else {
        inside_quotes = !inside_quotes;
      }
    } else if (line[k] == ',' && !inside_quotes) {
      fields.emplace_back();
    } else {
      fields.back() += line[k];
    }
  }
  return fields;
}

std::string interval_end_text(const std::vector<double>& ends, std::size_t k) {
  return ends.empty() ? "" : fmt::format("{}", ends[k]);
}

// Reads a line without its line end, LF or CRLF, since version control may change line ends.
bool read_line(std::istream& in, std::string& line) {
  if (!std::getline(in, line)) return false;
  if (line.ends_with('\r')) line.pop_back();
  return true;
}

class DensityCurveCsvReader {
 public:
  DensityCurveCsvReader(std::string_view source, const NonFinitePredicate& allows_non_finite)
      : source_(source), allows_non_finite_(allows_non_finite) {}

  void read(const std::string& line, int line_number, std::vector<CaseDensityCurve>& curves) {
    line_number_ = line_number;
    if (line.size() > kMaxLineLength) {
      fail(fmt::format("a line of {} bytes (must be at most {})", line.size(), kMaxLineLength));
    }
    const auto fields = split_csv_fields(line);
    if (fields.size() != kFields) {
      fail(fmt::format("{} fields (must be {})", fields.size(), kFields));
    }
    const auto variable = base::enum_from_name<transform::StateVariable>(fields[2]);
    if (!variable) fail(fmt::format("variable {} (must be y or ydot)", base::in_quotes(fields[2])));
    const bool continues = !curves.empty() && curves.back().case_name == fields[0] &&
                           curves.back().curve.solution == fields[1] &&
                           curves.back().curve.variable == *variable;
    if (!continues) {
      curves.push_back({fields[0], {fields[1], *variable, {}, {}, {}, {}}});
      requires_finite_ = !(allows_non_finite_ && allows_non_finite_(fields[0], fields[1]));
    }
    DensityCurve& curve = curves.back().curve;
    curve.abscissa.push_back(parse_csv_number(fields[3], true));
    curve.density.push_back(parse_csv_number(fields[4], requires_finite_));
    if (!fields[5].empty()) curve.lower.push_back(parse_csv_number(fields[5], requires_finite_));
    if (!fields[6].empty()) curve.upper.push_back(parse_csv_number(fields[6], requires_finite_));
    for (const auto* ends : {&curve.lower, &curve.upper}) {
      if (!ends->empty() && ends->size() != curve.density.size()) {
        fail("a curve has intervals in some of its rows only");
      }
    }
    if (curve.lower.size() != curve.upper.size()) fail("an interval has one end only");
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(
        fmt::format("{}:{}: {}", base::to_printable_text(source_), line_number_, problem));
  }

 private:
  double parse_csv_number(const std::string& text, bool finite) const {
    const auto value = base::parse_number<double>(text);
    if (!value) fail(fmt::format("{} is not a number", base::in_quotes(text)));
    if (finite && !std::isfinite(*value)) fail(fmt::format("{} (numbers must be finite)", text));
    return *value;
  }

  std::string_view source_;
  const NonFinitePredicate& allows_non_finite_;
  bool requires_finite_ = true;  // whether all numbers of the current curve must be finite
  int line_number_ = 1;
};

}  // namespace

void write_marginals_csv(std::ostream& out, std::span<const CaseResult> cases,
                         std::vector<DensityCurve> CaseResult::*curves) {
  out << kHeader << '\n';
  for (const auto& case_result : cases) {
    const std::string case_name = quote_csv_field(case_result.name());
    for (const auto& curve : case_result.*curves) {
      for (std::size_t k = 0; k < curve.abscissa.size(); ++k) {
        fmt::print(out, "{},{},{},{},{},{},{}\n", case_name, curve.solution, name(curve.variable),
                   curve.abscissa[k], curve.density[k], interval_end_text(curve.lower, k),
                   interval_end_text(curve.upper, k));
      }
    }
  }
}

std::vector<CaseDensityCurve> read_marginals_csv(std::istream& in, std::string_view source,
                                                 const NonFinitePredicate& allows_non_finite) {
  DensityCurveCsvReader row(source, allows_non_finite);
  std::string line;
  if (!read_line(in, line) || line != kHeader) {
    row.fail(fmt::format("not a file of marginals (the header must be {})", kHeader));
  }
  std::vector<CaseDensityCurve> curves;
  for (int line_number = 2; read_line(in, line); ++line_number) {
    row.read(line, line_number, curves);
  }
  return curves;
}

std::string quote_csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace fpkcheck::results
