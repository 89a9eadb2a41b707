#include "common/sec/bound_scene.h"

#include <algorithm>

namespace cell {

bool BoundScene::Touches(const Partner& partner) const {
  switch (partner.kind) {
    case Partner::Kind::kRole:
      return TouchesPart(words_.PartOf(roles_[partner.role]));
    case Partner::Kind::kObject:
      return TouchesPart(partner.name);
    case Partner::Kind::kType:
      break;
  }
  const Vocabulary& vocabulary = words_.vocabulary;
  const auto type = vocabulary.types().Find(partner.name);
  return type && std::ranges::any_of(
                     vocabulary.ObjectsOf(*type), [&](const int object) {
                       const auto& name = vocabulary.objects()[object].name;
                       return !IsInRole(name) && TouchesPart(name);
                     });
}

bool BoundScene::MayHold(const Literal& literal) const {
  return cell::MayHold(literal, roles_, sensed_.state, words_.vocabulary);
}

bool BoundScene::MustHold(const Literal& literal) const {
  return cell::MustHold(literal, roles_, sensed_.state, words_.vocabulary);
}

bool BoundScene::IsInRole(const std::string& part) const {
  return std::ranges::any_of(
      roles_, [&](const int object) { return words_.PartOf(object) == part; });
}

bool BoundScene::TouchesPart(const std::string& part) const {
  return Touch(sensed_.frame.relations, words_.PartOf(roles_[moved_]), part);
}

}  // namespace cell
