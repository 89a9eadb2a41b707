#pragma once

#include <compare>
#include <string>
#include <string_view>

namespace cell::assemblies {

/// Two parts that are attached to each other; their order means nothing.
struct PartPair {
  std::string first;
  std::string second;  ///< not before `first` in the alphabet
  auto operator<=>(const PartPair&) const = default;

  bool Has(const std::string& part) const {
    return first == part || second == part;
  }
  bool Touches(const PartPair& other) const {
    return Has(other.first) || Has(other.second);
  }
  /// Two parts that go by one name, such as two wheels.
  bool is_of_one_name() const { return first == second; }
};

/// The names normalised, in alphabetical order.
PartPair MakePair(std::string_view a, std::string_view b);

/// A part's name as rules write it: small letters and digits; whatever stands
/// between words becomes one '_'. "Turntable  top" is turntable_top. Empty if
/// there is neither letter nor digit.
std::string NormalisedName(std::string_view name);

/// "cabin - turntable top"
std::string Show(const PartPair& pair);

}  // namespace cell::assemblies
