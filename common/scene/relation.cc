#include "common/scene/relation.h"

namespace cell {

std::optional<Relation> RelationFromCode(int8_t code) {
  for (const Relation relation : {Relation::kNotTouching, Relation::kTouching,
                                  Relation::kOverlapping, Relation::kAbsent}) {
    if (static_cast<int8_t>(relation) == code) return relation;
  }
  return std::nullopt;
}

ObjectPair MakePair(const std::string& a, const std::string& b) {
  return a < b ? ObjectPair{a, b} : ObjectPair{b, a};
}

bool Touch(const TouchGraph& graph, const std::string& a,
           const std::string& b) {
  const auto it = graph.find(MakePair(a, b));
  return it != graph.end() && (it->second == Relation::kTouching ||
                               it->second == Relation::kOverlapping);
}

}  // namespace cell
