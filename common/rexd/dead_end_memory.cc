#include "common/rexd/dead_end_memory.h"

#include <algorithm>
#include <utility>

namespace cell::rexd {

using namespace rules;
namespace {

std::vector<int> ObjectsOf(const Literal& literal) {
  std::vector<int> objects;
  for (const Term& term : literal.terms) objects.push_back(term.index);
  return objects;
}

}  // namespace

DeadEndMemory::DeadEndMemory(const RexdTask& task) : task_(&task) {}

DeadEndMemory::Facts DeadEndMemory::FactsOf(const WorldState& state) const {
  const World& world = *task_->world;
  Facts facts;
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (!world.symbols()[symbol].is_primitive_predicate()) continue;
    for (int i = 0; i < world.num_places(symbol); ++i) {
      const int place = world.first(symbol) + i;
      const bool holds = World::Get(state, place);
      if (!holds && !World::Get(task_->initial, place)) continue;
      const FactKind kind = holds ? FactKind::kHolds : FactKind::kUndone;
      facts[{kind, symbol}].push_back(
          {kind, symbol, world.ObjectsAt(symbol, place)});
    }
  }
  for (const Literal& literal : task_->goal) {
    if (Holds(literal, {}, state, world)) continue;
    facts[{FactKind::kMissing, literal.symbol}].push_back(
        {FactKind::kMissing, literal.symbol, ObjectsOf(literal)});
  }
  return facts;
}

/// What is sure to hold at the goal.
DeadEndMemory::Facts DeadEndMemory::FactsOfGoal() const {
  Facts facts;
  for (const Literal& literal : task_->goal) {
    const bool holds = literal.comparison == Comparison::kTrue;
    const FactKind kind = holds ? FactKind::kHolds : FactKind::kUndone;
    const bool was_there = Holds(literal, {}, task_->initial, *task_->world);
    if (!holds && was_there) continue;
    facts[{kind, literal.symbol}].push_back(
        {kind, literal.symbol, ObjectsOf(literal)});
  }
  return facts;
}

bool DeadEndMemory::MatchesFrom(const Nogood& nogood, size_t next,
                                const Facts& facts,
                                std::map<int, int>* binding) const {
  if (next == nogood.size()) return true;
  const Fact& wanted = nogood[next];
  const auto candidates = facts.find({wanted.kind, wanted.symbol});
  if (candidates == facts.end()) return false;
  for (const Fact& fact : candidates->second) {
    std::map<int, int> bound = *binding;
    bool is_equal = true;
    for (size_t i = 0; i < wanted.objects.size() && is_equal; ++i) {
      const int object = wanted.objects[i];
      is_equal = object < task_->world->num_objects()
                     ? object == fact.objects[i]
                     : bound.emplace(object, fact.objects[i]).first->second ==
                           fact.objects[i];
    }
    if (is_equal && MatchesFrom(nogood, next + 1, facts, &bound)) return true;
  }
  return false;
}

bool DeadEndMemory::Matches(const Nogood& nogood, const Facts& facts) const {
  std::map<int, int> binding;
  return MatchesFrom(nogood, 0, facts, &binding);
}

bool DeadEndMemory::IsRefuted(const Nogood& nogood) const {
  return Matches(nogood, FactsOfGoal()) ||
         std::ranges::any_of(alive_facts_, [&](const Facts& facts) {
           return Matches(nogood, facts);
         });
}

void DeadEndMemory::FindNogoods(DeadEnd* dead_end) const {
  const World& world = *task_->world;
  const auto lift = [&](Nogood nogood) {
    for (Fact& fact : nogood) {
      for (int& object : fact.objects) {
        if (object >= world.num_constants()) object += world.num_objects();
      }
    }
    return nogood;
  };
  std::vector<Fact> all;
  for (const auto& [key, facts] : FactsOf(dead_end->state)) {
    all.insert(all.end(), facts.begin(), facts.end());
  }
  const auto add = [&](const Nogood& ground) {
    Nogood nogood = lift(ground);
    if (!IsRefuted(nogood)) dead_end->nogoods.push_back(std::move(nogood));
  };
  for (const Fact& fact : all) add({fact});
  if (!dead_end->nogoods.empty()) return;
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t j = i + 1; j < all.size(); ++j) add({all[i], all[j]});
  }
}

void DeadEndMemory::AddAlive(const WorldState& state) {
  if (!alive_.insert(state.bits).second) return;
  alive_facts_.push_back(FactsOf(state));
  for (DeadEnd& dead_end : dead_ends_) {
    const auto num_refuted =
        std::erase_if(dead_end.nogoods, [&](const Nogood& nogood) {
          return Matches(nogood, alive_facts_.back());
        });
    if (num_refuted > 0 && dead_end.nogoods.empty()) FindNogoods(&dead_end);
  }
}

void DeadEndMemory::AddDeadEnd(const WorldState& state) {
  DeadEnd dead_end{state, {}};
  FindNogoods(&dead_end);
  dead_ends_.push_back(std::move(dead_end));
}

bool DeadEndMemory::LooksDead(const WorldState& state) const {
  if (dead_ends_.empty()) return false;
  const Facts facts = FactsOf(state);
  return std::ranges::any_of(dead_ends_, [&](const DeadEnd& dead_end) {
    return dead_end.state == state ||
           std::ranges::any_of(dead_end.nogoods, [&](const Nogood& nogood) {
             return Matches(nogood, facts);
           });
  });
}

std::string DeadEndMemory::Show(const Nogood& nogood) const {
  const World& world = *task_->world;
  constexpr const char* kWords[] = {"", "no longer ", "missing "};
  std::map<int, std::string> names;
  std::string text;
  for (const Fact& fact : nogood) {
    std::string arguments;
    for (const int object : fact.objects) {
      const bool is_constant = object < world.num_objects();
      const auto [it, is_new] = names.emplace(
          object, is_constant
                      ? world.objects()[static_cast<size_t>(object)]
                      : std::string(1, static_cast<char>('A' + names.size())));
      arguments += (arguments.empty() ? "" : ", ") + it->second;
    }
    text += (text.empty() ? "" : " and ") +
            (kWords[static_cast<size_t>(fact.kind)] +
             world.symbols()[fact.symbol].name) +
            "(" + arguments + ")";
  }
  return text;
}

std::string DeadEndMemory::ToText() const {
  std::set<std::string> lines;
  for (const DeadEnd& dead_end : dead_ends_) {
    for (const Nogood& nogood : dead_end.nogoods) lines.insert(Show(nogood));
  }
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace cell::rexd
