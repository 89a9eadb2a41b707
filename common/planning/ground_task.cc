#include "common/planning/ground_task.h"

namespace cell::planning {

std::string Show(const GroundAtom& atom) {
  std::string text = atom.predicate + "(";
  for (size_t i = 0; i < atom.objects.size(); ++i) {
    text += (i == 0 ? "" : ", ") + atom.objects[i];
  }
  return text + ")";
}

std::string Show(const Literal& literal, const std::vector<GroundAtom>& atoms) {
  return (literal.value ? "" : "not ") +
         Show(atoms[static_cast<size_t>(literal.atom)]);
}

}  // namespace cell::planning
