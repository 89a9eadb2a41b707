#include "services/cell/evaluations/row_identity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <vector>

#include "common/text/fingerprint.h"
#include "services/cell/evaluations/row_shape.h"

namespace cell::cli {

using nlohmann::json;
namespace {

constexpr size_t kMostDifferences = 3;  // differences
constexpr char kRowsOf[] = "rows of";
constexpr char kRowOptions[] = "options", kRowFiles[] = "files";

using Texts = std::map<std::string, std::string>;

std::set<std::string> NamesOfBoth(const Texts& before, const Texts& now) {
  std::set<std::string> names;
  for (const Texts* texts : {&before, &now}) {
    for (const auto& [name, text] : *texts) names.insert(name);
  }
  return names;
}

std::string TextIn(const Texts& texts, const std::string& name) {
  const auto it = texts.find(name);
  return it == texts.end() ? "not there" : it->second;
}

}  // namespace

void RowIdentity::AddFile(const std::string& name, const std::string& text) {
  files[name] = fmt::format("{:016x}", Fingerprint(text));
}

json ToJson(const RowIdentity& identity) {
  const json line = {{kRowsOf, identity.command},
                     {kRowOptions, identity.options},
                     {kRowFiles, identity.files}};
  // As it can be written: names of files may be no UTF-8.
  return json::parse(line.dump(-1, ' ', false, json::error_handler_t::replace));
}

bool IsRowIdentity(const json& line) {
  const RowShape texts = RowShape::MapOf(RowShape::kText);
  return !MisfitOf(line, RowShape::Record({{kRowsOf, RowShape::kText},
                                           {kRowOptions, texts},
                                           {kRowFiles, texts}}));
}

std::string DifferenceFrom(const json& line, const RowIdentity& identity) {
  const auto command = line.at(kRowsOf).get<std::string>();
  if (command != identity.command) {
    return fmt::format("they are of 'cell {}', not of 'cell {}'", command,
                       identity.command);
  }
  const json mine = ToJson(identity);
  std::vector<std::string> all;
  const auto options = line.at(kRowOptions).get<Texts>();
  const auto my_options = mine.at(kRowOptions).get<Texts>();
  for (const std::string& name : NamesOfBoth(options, my_options)) {
    const std::string before = TextIn(options, name);
    const std::string now = TextIn(my_options, name);
    if (before == now) continue;
    all.push_back(fmt::format("{} was {}, now it is {}", name, before, now));
  }
  const auto files = line.at(kRowFiles).get<Texts>();
  const auto my_files = mine.at(kRowFiles).get<Texts>();
  for (const std::string& name : NamesOfBoth(files, my_files)) {
    if (TextIn(files, name) == TextIn(my_files, name)) continue;
    all.push_back(name + (!files.contains(name)      ? " is new"
                          : !my_files.contains(name) ? " is gone"
                                                     : " is another"));
  }
  if (all.size() > kMostDifferences) {
    const size_t num_more = all.size() - kMostDifferences;
    all.resize(kMostDifferences);
    all.push_back(fmt::format("and {} more", num_more));
  }
  return fmt::format("{}", fmt::join(all, "; "));
}

}  // namespace cell::cli
