#include <gtest/gtest.h>

#include <random>
#include <string>

#include "common/ppddl/problem.h"
#include "tests/unit/small_ppddl.h"

namespace cell::ppddl {
namespace {

void ExpectRoundTrip(const Domain& domain) {
  EXPECT_EQ(ParseDomain(ToText(domain), "written"), domain) << ToText(domain);
}

TEST(PpddlRoundTrip, DomainAndProblemStayTheSame) {
  const Domain domain = ParseDomain(kCourier, "d");
  ExpectRoundTrip(domain);
  const Problem problem = ParseProblem(kDelivery, "p", domain);
  EXPECT_EQ(ParseProblem(ToText(problem, domain), "written", domain), problem);
  EXPECT_EQ(ToText(ParseDomain(ToText(domain), "written")), ToText(domain));
}

/// Random formulas over the courier's words.
class RandomFormula {
 public:
  explicit RandomFormula(uint64_t seed) : random_(seed) {}

  Condition MakeCondition(int depth, int num_variables) {
    using enum Condition::Kind;
    const int kind = depth == 0 ? Draw(2) : Draw(8);
    Condition condition{static_cast<Condition::Kind>(kind)};
    switch (condition.kind) {
      case kAtom:
        condition.predicate = 1;  // road
        [[fallthrough]];
      case kEqual:
        condition.terms = {Term(num_variables), Term(num_variables)};
        return condition;
      case kForall:
      case kExists:
        condition.variables = {{Name(num_variables), 1}};
        ++num_variables;
        break;
      default:
        break;
    }
    const int num_parts = condition.kind == kImply ? 2
                          : condition.kind == kAnd || condition.kind == kOr
                              ? Draw(4)
                              : 1;
    for (int i = 0; i < num_parts; ++i) {
      condition.parts.push_back(MakeCondition(depth - 1, num_variables));
    }
    return condition;
  }

  Effect MakeEffect(int depth, int num_variables) {
    using enum Effect::Kind;
    const int kind = depth == 0 ? Draw(2) : Draw(8);
    Effect effect{static_cast<Effect::Kind>(kind)};
    int num_parts = 1;
    switch (effect.kind) {
      case kAdd:
      case kDelete:
        effect.symbol = 1;
        effect.terms = {Term(num_variables), Term(num_variables)};
        return effect;
      case kIncrease:
      case kDecrease:
        effect.amount.number = Draw(1000) / 7.0;
        return effect;
      case kAnd:
        num_parts = Draw(4);
        break;
      case kWhen:
        effect.condition = MakeCondition(2, num_variables);
        break;
      case kForall:
        effect.variables = {{Name(num_variables), 3}};
        ++num_variables;
        break;
      case kProbabilistic:
        num_parts = 1 + Draw(3);
        for (int i = 0; i < num_parts; ++i) {
          effect.probabilities.push_back(Draw(1000) / 3001.0);
        }
        break;
    }
    for (int i = 0; i < num_parts; ++i) {
      effect.parts.push_back(MakeEffect(depth - 1, num_variables));
    }
    return effect;
  }

 private:
  int Draw(int below) {
    return static_cast<int>(random_() % static_cast<uint64_t>(below));
  }
  ppddl::Term Term(int num_variables) {
    if (Draw(4) == 0) return {false, 0};
    return {true, Draw(num_variables)};
  }
  static std::string Name(int i) { return "?v" + std::to_string(i); }

  std::mt19937_64 random_;
};

TEST(PpddlRoundTrip, RandomFormulasStayTheSame) {
  Domain domain = ParseDomain(kCourier, "d");
  for (uint64_t seed = 0; seed < 300; ++seed) {
    RandomFormula random(seed);
    domain.actions[0].precondition = random.MakeCondition(4, 2);
    domain.actions[0].effect = random.MakeEffect(4, 2);
    ExpectRoundTrip(domain);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace cell::ppddl
