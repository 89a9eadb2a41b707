#include "services/cell/evaluations/sec_seeds.h"

#include <utility>

namespace cell::cli {
namespace {

struct SeedRow {
  ObjectPair pair;
  std::vector<int8_t> codes;
};

SecSeed Seed(std::string name, const std::vector<SeedRow>& rows,
             RoleTable* roles) {
  std::vector<uint32_t> row_roles;
  for (const SeedRow& row : rows) row_roles.push_back(roles->RoleOf(row.pair));
  RelationMatrix chain(row_roles, rows.front().codes.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    for (size_t j = 0; j < chain.num_columns(); ++j) {
      const auto relation = RelationFromCode(rows[i].codes.at(j));
      chain.Set(i, j, SymbolOf(relation.value()));
    }
  }
  return {std::move(name), std::move(chain)};
}

}  // namespace

SecSeed Figure12Seed(RoleTable* roles) {
  return Seed("Fig. 12",
              {{{"hand", "table"}, {9, 1, 1, 1, 9}},
               {{"hand", "box"}, {9, 0, 1, 0, 9}},
               {{"table", "box"}, {1, 1, 0, 1, 1}}},
              roles);
}

std::vector<SecSeed> Figure14Seeds(RoleTable* roles) {
  return {Seed("I",
               {{{"1", "2"}, {2, 2, 1, 1, 2, 2}},
                {{"2", "3"}, {9, 0, 1, 2, 2, 2}},
                {{"2", "4"}, {9, 0, 1, 1, 0, 9}},
                {{"3", "4"}, {9, 1, 1, 0, 9, 9}}},
               roles),
          Seed("II",
               {{{"1", "2"}, {2, 2, 2, 1, 1, 2, 2}},
                {{"1", "3"}, {9, 1, 1, 0, 0, 0, 0}},
                {{"1", "5"}, {9, 9, 1, 1, 1, 1, 9}},
                {{"2", "3"}, {9, 0, 0, 1, 2, 2, 2}},
                {{"2", "5"}, {9, 9, 0, 1, 1, 0, 9}}},
               roles),
          Seed("III",
               {{{"1", "2"}, {2, 2, 2, 1, 1, 2, 2, 2}},
                {{"1", "3"}, {9, 1, 1, 0, 0, 0, 0, 0}},
                {{"1", "5"}, {9, 9, 1, 1, 1, 1, 1, 9}},
                {{"2", "3"}, {9, 0, 0, 1, 2, 2, 2, 2}},
                {{"2", "5"}, {9, 9, 0, 1, 1, 1, 0, 9}},
                {{"3", "5"}, {9, 9, 1, 0, 0, 0, 0, 9}}},
               roles),
          Seed("IV",
               {{{"1", "2"}, {1, 1, 1, 1, 0, 0, 0, 0}},
                {{"1", "3"}, {9, 1, 1, 1, 1, 1, 2, 2}},
                {{"1", "4"}, {2, 2, 2, 2, 1, 1, 2, 2}},
                {{"2", "3"}, {9, 2, 1, 0, 0, 1, 2, 9}},
                {{"2", "4"}, {9, 1, 1, 2, 2, 0, 0, 0}},
                {{"3", "4"}, {0, 0, 0, 1, 1, 2, 2, 2}},
                {{"2", "5"}, {0, 0, 1, 1, 1, 1, 9, 9}},
                {{"3", "5"}, {9, 0, 2, 2, 1, 1, 0, 9}}},
               roles)};
}

std::vector<SecSeed> DistinctSeeds(RoleTable* roles) {
  auto seeds = Figure14Seeds(roles);
  return {Figure12Seed(roles), std::move(seeds[0]), std::move(seeds[1]),
          std::move(seeds[3]),
          Seed("box on box",
               {{{"hand", "box"}, {0, 1, 1, 1, 0}},
                {{"table", "box"}, {1, 1, 0, 0, 0}},
                {{"box", "box"}, {0, 0, 0, 1, 1}}},
               roles)};
}

}  // namespace cell::cli
