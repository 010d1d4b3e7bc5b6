#include "report/verdict/standing.hpp"

#include <algorithm>
#include <cmath>

#include "compare/reference.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;
using transform::Status;
using transform::Variable;

std::optional<double> larger_of(std::optional<double> one, std::optional<double> other) {
  if (one && other) return std::max(*one, *other);
  return one ? one : other;
}

// Distances within the error estimate of the reference are not significant.
bool within_what_is_known(const Solution& reference, const Stand& stand) {
  const auto within = [&](const std::optional<double>& l1, Variable variable) {
    const double known = compare::own_error(reference, variable);
    return !l1 || (std::isfinite(known) && *l1 <= known);
  };
  return within(stand.y, Variable::y) && within(stand.ydot, Variable::ydot);
}

}  // namespace

std::optional<double> Stand::farthest() const { return larger_of(y, ydot); }

bool Stand::reproduces() const {
  return standing == Standing::reference || standing == Standing::indistinguishable ||
         standing == Standing::close;
}

Stand stand_in(const results::Case& one, std::string_view id) {
  Stand stand{.solution = one.find(id)};
  if (stand.solution == nullptr) return stand;
  const Solution* reference = compare::reference(one.solutions);
  if (reference == stand.solution) {
    stand.standing = Standing::reference;
    return stand;
  }
  if (reference != nullptr) {
    stand.y = one.l1(id, reference->id(), Variable::y);
    stand.ydot = one.l1(id, reference->id(), Variable::ydot);
  }
  const bool is_density =
      stand.solution->has_density() && stand.solution->status != Status::inadmissible;
  if (!is_density) {
    stand.standing = Standing::no_density;
  } else if (!stand.farthest()) {
    stand.standing = Standing::unjudged;
  } else if (within_what_is_known(*reference, stand)) {
    stand.standing = Standing::indistinguishable;
  } else {
    stand.standing = *stand.farthest() <= kCloseL1 ? Standing::close : Standing::off;
  }
  return stand;
}

int Record::present() const { return static_cast<int>(stands.size()) - count(Standing::absent); }

int Record::reproduced() const {
  return static_cast<int>(std::ranges::count_if(stands, &Stand::reproduces));
}

int Record::count(Standing standing) const {
  return static_cast<int>(std::ranges::count(stands, standing, &Stand::standing));
}

std::optional<double> Record::largest(std::optional<double> Stand::*marginal) const {
  std::optional<double> most;
  for (const auto& stand : stands) {
    if (stand.standing != Standing::no_density) most = larger_of(most, stand.*marginal);
  }
  return most;
}

std::optional<double> Record::farthest() const {
  return larger_of(largest(&Stand::y), largest(&Stand::ydot));
}

double Record::seconds() const {
  double longest = 0;
  for (const auto& stand : stands) {
    if (stand.solution != nullptr) longest = std::max(longest, stand.solution->seconds);
  }
  return longest;
}

std::vector<Record> records(const results::Run& run) {
  std::vector<Record> all;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    auto place = all.begin();
    for (const auto& solution : run.cases[k].solutions) {
      const auto known = std::ranges::find(
          all, solution.id(), [](const Record& record) { return record.identity->id; });
      if (known != all.end()) {
        place = known + 1;
        continue;
      }
      // Inserted behind the solution that precedes it in the case where it first occurs.
      place = all.insert(place, Record{&solution.identity, {}}) + 1;
    }
  }
  for (auto& record : all) {
    for (const auto& one : run.cases) {
      record.stands.push_back(stand_in(one, record.identity->id));
    }
  }
  // Solutions that apply to no case have no row.
  std::erase_if(all, [](const Record& record) {
    return std::ranges::all_of(record.stands, [](const Stand& stand) {
      return stand.solution == nullptr || stand.solution->status == transform::Status::not_offered;
    });
  });
  return all;
}

}  // namespace fpkcheck::report
