#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/rules/symbols.h"

namespace cell::rules {

/// What holds in a state: a bit for each ground atom, a number for each ground
/// function. Only of use with its World.
struct WorldState {
  std::vector<uint64_t> bits;
  std::vector<int> values;
  std::vector<uint8_t> is_present;  ///< of each object; nothing holds of others
  bool operator==(const WorldState&) const = default;
};

/// Symbols and objects; the places of ground atoms and functions in a state.
class World {
 public:
  /// Value of a function for objects that it is not known of.
  static constexpr int kNoValue = INT32_MIN;

  /// The constants of the symbols come first, then `objects`.
  World(std::shared_ptr<const SymbolTable> symbols,
        const std::vector<std::string>& objects);

  const SymbolTable& symbols() const { return *symbols_; }
  const std::shared_ptr<const SymbolTable>& shared_symbols() const {
    return symbols_;
  }
  const std::vector<std::string>& objects() const { return objects_; }
  int num_objects() const { return static_cast<int>(objects_.size()); }
  int num_constants() const {
    return static_cast<int>(symbols_->constants().size());
  }
  std::optional<int> FindObject(const std::string& name) const;

  /// All atoms false, all values unknown.
  WorldState EmptyState(bool are_present = true) const;

  /// The place of a ground atom, or function, among all of a state.
  int PlaceOf(int symbol, std::span<const int> objects) const;
  /// The places of the symbol's atoms, or values: [first, first + number).
  int first(int symbol) const { return first_[static_cast<size_t>(symbol)]; }
  int num_places(int symbol) const;
  int num_bits() const { return num_bits_; }
  /// The objects of the symbol's atom at a place.
  std::vector<int> ObjectsAt(int symbol, int place) const;

  static bool Get(const WorldState& state, int place) {
    return state.bits[static_cast<size_t>(place) / 64] >> (place % 64) & 1;
  }
  static void Set(WorldState* state, int place, bool value);

  /// Sets all derived atoms and functions by what is primitive.
  void Derive(WorldState* state) const;

  /// "on(a, b)", "size(a) = 3"
  std::string Show(int symbol, std::span<const int> objects) const;

 private:
  void DeriveConjunction(int symbol, WorldState* state) const;
  void DeriveClosure(int symbol, WorldState* state) const;
  void DeriveCount(int symbol, WorldState* state) const;
  void DeriveSum(int symbol, WorldState* state) const;
  /// Number of bindings of the quantified variables for which all atoms of the
  /// definition hold (`is_satisfied`), or of those for which one does not.
  int CountBindings(const Definition& definition, std::vector<int>* binding,
                    const WorldState& state, bool is_satisfied) const;
  bool Satisfies(const Definition& definition, const std::vector<int>& binding,
                 const WorldState& state) const;

  std::shared_ptr<const SymbolTable> symbols_;
  std::vector<std::string> objects_;
  std::vector<int> first_;  // of each symbol
  std::vector<int> powers_;
  int num_bits_ = 0;
  int num_values_ = 0;
};

}  // namespace cell::rules
