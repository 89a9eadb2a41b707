#include "common/sec/scene_facts.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace cell {
namespace {

template <class Set>
Set CommonTo(const Set& a, const Set& b) {
  Set common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(),
                        std::inserter(common, common.end()), a.key_comp());
  return common;
}

std::optional<Literal> Renamed(Literal literal, const RoleMap& places) {
  for (Term& term : literal.terms) {
    if (term.kind != Term::Kind::kVariable) continue;
    const auto place = places.at(static_cast<size_t>(term.index));
    if (!place) return std::nullopt;
    term.index = static_cast<int>(*place);
  }
  return literal;
}

std::set<Partner> Renamed(const std::set<Partner>& partners,
                          const RoleMap& places) {
  std::set<Partner> renamed;
  for (Partner partner : partners) {
    if (partner.kind == Partner::Kind::kRole) {
      const auto place = places.at(partner.role);
      if (!place) continue;
      partner.role = *place;
    }
    renamed.insert(std::move(partner));
  }
  return renamed;
}

}  // namespace

bool LiteralOrder::operator()(const Literal& a, const Literal& b) const {
  const auto key = [](const Literal& l) {
    return std::tuple(!l.is_static, l.relation, l.is_negated, l.terms.size());
  };
  if (key(a) != key(b)) return key(a) < key(b);
  return std::ranges::lexicographical_compare(
      a.terms, b.terms, [](const Term& s, const Term& t) {
        return std::tuple(s.kind, s.index) < std::tuple(t.kind, t.index);
      });
}

Literal Negated(Literal literal) {
  literal.is_negated = !literal.is_negated;
  return literal;
}

bool Mentions(const Literal& literal, size_t role) {
  return std::ranges::any_of(literal.terms, [role](const Term& term) {
    return term.kind == Term::Kind::kVariable &&
           static_cast<size_t>(term.index) == role;
  });
}

SceneFacts Intersection(const SceneFacts& a, const SceneFacts& b) {
  return {CommonTo(a.touch, b.touch), CommonTo(a.apart, b.apart),
          CommonTo(a.where, b.where)};
}

LiteralSet Renamed(const LiteralSet& literals, const RoleMap& places) {
  LiteralSet renamed;
  for (const Literal& literal : literals) {
    if (auto changed = Renamed(literal, places)) {
      renamed.insert(*std::move(changed));
    }
  }
  return renamed;
}

SceneFacts Renamed(const SceneFacts& facts, const RoleMap& places) {
  return {Renamed(facts.touch, places), Renamed(facts.apart, places),
          Renamed(facts.where, places)};
}

LiteralSet ChangedLiterals(const SceneFacts& before, const SceneFacts& after) {
  LiteralSet changed;
  for (const Literal& literal : before.where) {
    if (after.where.contains(Negated(literal))) changed.insert(literal);
  }
  return changed;
}

std::set<Partner> ChangedPartners(const SceneFacts& before,
                                  const SceneFacts& after) {
  std::set<Partner> changed = CommonTo(before.touch, after.apart);
  changed.merge(CommonTo(before.apart, after.touch));
  return changed;
}

}  // namespace cell
