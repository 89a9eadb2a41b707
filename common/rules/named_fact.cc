#include "common/rules/named_fact.h"

#include <fmt/format.h>

#include <vector>

#include "common/text/nearest.h"

namespace cell::rules {

int FactNamed(const std::string& name, const SymbolTable& symbols,
              const TokenReader& in, const std::string& where) {
  std::vector<std::string> names;
  for (size_t i = 0; i < symbols.all().size(); ++i) {
    const Symbol& symbol = symbols.all()[i];
    const bool is_action = symbol.kind == Symbol::Kind::kAction;
    if (!is_action) names.push_back(symbol.name);
    if (symbol.name != name) continue;
    if (!is_action) return static_cast<int>(i);
    in.Fail(fmt::format("'{}' is an action; expected a predicate or a function",
                        name));
  }
  in.Fail(fmt::format("there is no predicate or function '{}'{}{}", name, where,
                      NamesInstead(name, names)));
}

}  // namespace cell::rules
