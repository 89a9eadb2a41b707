#include "services/cell/scoring/seated_parts.h"

#include "services/cell/scoring/assembly_score.h"

namespace cell::cli {

std::map<std::string, std::string> SeatedParts(
    const PoseHistory& looks, const SuccessCriterion& success) {
  std::map<std::string, std::string> seated;
  SuccessCriterion one = success;
  for (int atom = 0; atom < success.vocabulary.num_atoms(); ++atom) {
    const GroundAtom ground = success.vocabulary.Atom(atom);
    if (!success.seats.contains(ground.predicate)) continue;
    Literal literal{.relation = ground.predicate};
    for (const int object : ground.objects) {
      literal.terms.push_back({Term::Kind::kObject, object});
    }
    one.literals = {literal};
    if (ScoreAssembly(looks.earlier(), looks.last(), one).is_complete()) {
      seated[success.SiteOf(ground).name] = success.PartOf(ground).name;
    }
  }
  return seated;
}

std::set<std::string> PartsInTheWay(
    const std::map<std::string, std::string>& seated,
    const SuccessCriterion& success) {
  std::map<std::string, std::string> wanted;  // part by site
  for (const Literal& literal : success.literals) {
    if (literal.terms[0].kind != Term::Kind::kObject) continue;
    const size_t part = static_cast<size_t>(literal.terms[0].index);
    wanted[success.NameOf(literal)] = success.vocabulary.objects()[part].name;
  }
  std::set<std::string> in_the_way;
  for (const auto& [site, part] : seated) {
    for (const auto& [wanted_site, wanted_part] : wanted) {
      if ((site == wanted_site) != (part == wanted_part)) {
        in_the_way.insert(part);
      }
    }
  }
  return in_the_way;
}

std::set<std::string> WantedSites(const SuccessCriterion& success) {
  std::set<std::string> sites;
  for (const Literal& literal : success.literals) {
    if (!literal.is_negated) sites.insert(success.NameOf(literal));
  }
  return sites;
}

}  // namespace cell::cli
