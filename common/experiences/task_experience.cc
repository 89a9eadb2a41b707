#include "common/experiences/task_experience.h"
namespace cell {
namespace {
std::vector<literal_t> Literals(const State& state, const Vocabulary& v) {
  std::vector<literal_t> out;
  for (int i = 0; i < state.num_atoms(); ++i) {
    if (state.Get(i) == Truth::kFalse) continue;
    const GroundAtom atom = v.Atom(i);
    literal_t l{};
    l.predicate = v.predicates()[atom.predicate].name;
    for (int o : atom.objects) l.arguments.push_back(v.objects()[o].name);
    l.num_arguments = l.arguments.size();
    l.value =
        state.Get(i) == Truth::kTrue ? literal_t::TRUE_ : literal_t::UNKNOWN;
    out.push_back(l);
  }
  return out;
}
std::optional<State> ToState(const std::vector<literal_t>& ls,
                             const Vocabulary& v) {
  State s(v.num_atoms());
  for (const auto& l : ls) {
    auto p = v.FindPredicate(l.predicate);
    if (!p || v.predicates()[*p].argument_types.size() != l.arguments.size())
      return std::nullopt;
    std::vector<int> os;
    for (const auto& n : l.arguments) {
      auto o = v.FindObject(n);
      if (!o) return std::nullopt;
      os.push_back(*o);
    }
    auto a = v.AtomIndex(*p, os);
    if (!a) return std::nullopt;
    s.Set(*a, l.value == literal_t::TRUE_ ? Truth::kTrue : Truth::kUnknown);
  }
  return s;
}
}  // namespace
Result<TaskExperience> FromMessage(const experience_t& m, const Vocabulary& v) {
  auto b = ToState(m.before, v), a = ToState(m.after, v);
  if (!b || !a) return Reason{"unknown atom"};
  TaskExperience e{m.action,
                   {},
                   m.agent == "robot" ? Agent::kRobot : Agent::kPerson,
                   *b,
                   *a};
  for (const auto& n : m.arguments) {
    auto o = v.FindObject(n);
    if (!o) return Reason{"unknown object " + n};
    e.objects.push_back(*o);
  }
  return e;
}
experience_t ToMessage(const TaskExperience& e, const Vocabulary& v) {
  experience_t m{};
  m.action = e.action;
  for (int o : e.objects) m.arguments.push_back(v.objects()[o].name);
  m.num_arguments = m.arguments.size();
  m.agent = e.agent == Agent::kRobot ? "robot" : "person";
  m.before = Literals(e.before, v);
  m.num_before = m.before.size();
  m.after = Literals(e.after, v);
  m.num_after = m.after.size();
  return m;
}
}  // namespace cell
