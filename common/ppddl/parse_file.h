#pragma once

#include <string>
#include <vector>

#include "common/ppddl/expression.h"

namespace cell::ppddl {

/// The "(define (domain name) ...)" or "(define (problem name) ...)" of a file,
/// which may hold others. @throws PpddlError if there is none, or two
const Expression& FindDefine(const std::vector<Expression>& expressions,
                             const std::string& kind, const std::string& file);

/// @throws PpddlError if the definition has a section that is not among them
void CheckSections(const Expression& define,
                   const std::vector<std::string>& sections);

/// @throws PpddlError for a requirement that is unknown or not supported
std::vector<std::string> ReadRequirements(const Expression& section);

}  // namespace cell::ppddl
