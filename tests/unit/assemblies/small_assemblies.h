#pragma once

#include <string>
#include <vector>

#include "common/assemblies/annotation_reader.h"
#include "common/assemblies/order_evidence.h"

namespace cell::assemblies {

/// A sequence of rows "verb,part,part,label,remark".
inline AssemblySequence MakeSequence(const std::vector<std::string>& rows,
                                     const std::string& toy = "t1") {
  std::string text;
  for (const std::string& row : rows) text += "0,1," + row + "\n";
  return ReadAnnotations(text, "s_1-" + toy + "_.csv").sequence;
}

inline OrderEvidence EvidenceFrom(
    const std::vector<AssemblySequence>& sequences) {
  std::vector<const AssemblySequence*> pointers;
  for (const AssemblySequence& sequence : sequences) {
    pointers.push_back(&sequence);
  }
  return CollectEvidence(pointers);
}

}  // namespace cell::assemblies
