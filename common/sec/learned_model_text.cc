#include "common/sec/learned_model_text.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "common/scene/scene_objects.h"
#include "common/sec/showing.h"

namespace cell {
namespace {

constexpr std::string_view kAny = "any ";

class Reader {
 public:
  Reader(const Config& config, const SceneWords& words)
      : config_(config), words_(words) {}

  LearnedModel Read() {
    ReadRoles();
    const auto moved = config_.Get<std::string>("moved");
    const auto role = FindRole(moved);
    if (!role) config_["moved"].Fail("'" + moved + "' is not a role");
    model_.moved = *role;
    model_.pick = ReadFacts(config_["pick"]);
    model_.place = ReadFacts(config_["place"]);
    model_.chain = ReadChain(config_["chain"]);
    model_.shown = ReadShown(config_, "shown");
    ReadTaught();
    Check();
    return std::move(model_);
  }

 private:
  void ReadRoles() {
    const Config roles = config_["roles"];
    for (const auto& [name, type_name] : roles.Entries()) {
      const auto text = type_name.As<std::string>();
      const auto type = words_.vocabulary.types().Find(text);
      if (!type) type_name.Fail("there is no type '" + text + "'");
      if (name.empty() || !std::isupper(static_cast<unsigned char>(name[0]))) {
        type_name.Fail("a role begins with a capital letter");
      }
      model_.roles.push_back({name, *type});
    }
    if (model_.roles.empty() || model_.roles.size() > kMaxRoles) {
      roles.Fail(fmt::format("needs 1 to {} roles", kMaxRoles));
    }
  }

  std::optional<size_t> FindRole(const std::string& name) const {
    for (size_t i = 0; i < model_.roles.size(); ++i) {
      if (model_.roles[i].name == name) return i;
    }
    return std::nullopt;
  }

  SceneFacts ReadFacts(const Config& config) const {
    SceneFacts facts;
    for (const Config& item : config.ItemsOf("touch")) {
      facts.touch.insert(ReadPartner(item));
    }
    for (const Config& item : config.ItemsOf("apart")) {
      if (!facts.apart.insert(ReadPartner(item)).second ||
          facts.touch.contains(ReadPartner(item))) {
        item.Fail("is also in touch, or twice in apart");
      }
    }
    if (config.Has("where")) {
      for (const Literal& literal :
           ParseLiterals(config["where"], words_.vocabulary, model_.roles)) {
        facts.where.insert(literal);
      }
    }
    return facts;
  }

  Partner ReadPartner(const Config& config) const {
    const auto text = config.As<std::string>();
    if (text.starts_with(kAny)) {
      const std::string type = text.substr(kAny.size());
      if (!words_.vocabulary.types().Find(type)) {
        config.Fail("there is no type '" + type + "'");
      }
      return {Partner::Kind::kType, 0, type};
    }
    if (const auto role = FindRole(text)) {
      if (*role == model_.moved) config.Fail("a part does not touch itself");
      return {Partner::Kind::kRole, *role, ""};
    }
    if (text != SceneObjects::kTable && !words_.parts.Find(text)) {
      config.Fail("'" + text +
                  "' is not a role, a part, the table, or any TYPE");
    }
    return {Partner::Kind::kObject, 0, text};
  }

  EventChain ReadChain(const Config& config) const {
    std::map<ObjectPair, std::string> rows;
    size_t num_columns = 0;
    for (const auto& [name, row] : config.Entries()) {
      const auto codes = row.As<std::string>();
      num_columns = rows.empty() ? codes.size() : num_columns;
      if (codes.empty() || codes.size() != num_columns ||
          !std::ranges::all_of(codes, [](char c) {
            return RelationFromCode(static_cast<int8_t>(c - '0')).has_value();
          })) {
        row.Fail("needs one code of a relation (0, 1, 2, 9) for each column");
      }
      if (name != SceneObjects::kTable &&
          !words_.vocabulary.types().Find(name)) {
        row.Fail("'" + name + "' is neither a type nor the table");
      }
      rows[MakePair(Showing::kMoved, name)] = codes;
    }
    EventChain chain;
    for (size_t column = 0; column < num_columns; ++column) {
      TouchGraph graph;
      for (const auto& [pair, codes] : rows) {
        graph[pair] =
            *RelationFromCode(static_cast<int8_t>(codes[column] - '0'));
      }
      chain.Append(graph);
    }
    return chain;
  }

  static std::map<std::string, int> ReadShown(const Config& config,
                                              const std::string& key) {
    std::map<std::string, int> counts;
    const Config shown = config[key];
    for (const auto& [name, count] : shown.Entries()) {
      counts[name] = shown.Integer(name, 1, std::numeric_limits<int>::max());
    }
    if (counts.empty()) shown.Fail("names no demonstration");
    return counts;
  }

  void ReadTaught() {
    if (!config_.Has("taught")) return;
    std::map<std::string, int> shown;
    for (const Config& item : config_["taught"].Items()) {
      model_.taught.push_back(ReadContribution(item));
      for (const auto& [name, count] : model_.taught.back().shown) {
        shown[name] += count;
      }
    }
    if (shown != model_.shown) {
      config_["taught"].Fail(
          "is not of the demonstrations in `shown`, as often as there");
    }
  }

  Contribution ReadContribution(const Config& config) const {
    Contribution contribution;
    contribution.shown = ReadShown(config, "by");
    if (config.Has("build")) {
      contribution.build = config.Get<std::string>("build");
    }
    const Config types = config["types"];
    for (const Config& item : types.Items()) {
      const auto text = item.As<std::string>();
      const auto type = words_.vocabulary.types().Find(text);
      if (!type) item.Fail("there is no type '" + text + "'");
      contribution.types.push_back(*type);
    }
    if (contribution.types.size() != model_.roles.size()) {
      types.Fail("needs one type for each role");
    }
    contribution.pick = ReadFacts(config["pick"]);
    contribution.place = ReadFacts(config["place"]);
    contribution.chain = ReadChain(config["chain"]);
    return contribution;
  }

  void Check() const {
    if (ChangedLiterals(model_.pick, model_.place).empty() &&
        ChangedPartners(model_.pick, model_.place).empty()) {
      config_.Fail("nothing that pick says is changed in place");
    }
    for (size_t i = 0; i < model_.roles.size(); ++i) {
      if (i == model_.moved || IsMentioned(i)) continue;
      config_.Fail("neither pick nor place mentions " + model_.roles[i].name +
                   ": any object would match");
    }
  }

  bool IsMentioned(size_t role) const {
    const Partner partner{Partner::Kind::kRole, role, ""};
    return std::ranges::any_of(
        std::array{&model_.pick, &model_.place}, [&](const SceneFacts* facts) {
          return facts->touch.contains(partner) ||
                 facts->apart.contains(partner) ||
                 std::ranges::any_of(facts->where, [role](const Literal& l) {
                   return Mentions(l, role);
                 });
        });
  }

  const Config& config_;
  const SceneWords& words_;
  LearnedModel model_;
};

std::string NameOf(const Partner& partner, std::span<const Variable> roles) {
  switch (partner.kind) {
    case Partner::Kind::kRole:
      return roles[partner.role].name;
    case Partner::Kind::kType:
      return std::string(kAny) + partner.name;
    case Partner::Kind::kObject:
      break;
  }
  return partner.name;
}

/// A list or map on one line.
YAML::Node Flow(YAML::NodeType::value type) {
  YAML::Node node(type);
  node.SetStyle(YAML::EmitterStyle::Flow);
  return node;
}

YAML::Node FactsNode(const SceneFacts& facts, const LearnedModel& model,
                     const Vocabulary& vocabulary) {
  YAML::Node node(YAML::NodeType::Map);
  const std::pair<const char*, const std::set<Partner>*> lists[] = {
      {"touch", &facts.touch}, {"apart", &facts.apart}};
  for (const auto& [key, partners] : lists) {
    if (partners->empty()) continue;
    node[key] = Flow(YAML::NodeType::Sequence);
    for (const Partner& partner : *partners) {
      node[key].push_back(NameOf(partner, model.roles));
    }
  }
  if (facts.where.empty()) return node;
  node["where"] = Flow(YAML::NodeType::Sequence);
  for (const Literal& literal : facts.where) {
    node["where"].push_back(cell::ToText(literal, vocabulary, model.roles));
  }
  return node;
}

YAML::Node ChainNode(const EventChain& chain) {
  YAML::Node node = Flow(YAML::NodeType::Map);
  for (size_t row = 0; row < chain.num_rows(); ++row) {
    const auto& [first, second] = chain.pairs()[row];
    std::string codes;
    for (const Relation relation : chain.Row(row)) {
      codes += static_cast<char>('0' + static_cast<int>(relation));
    }
    node[first == Showing::kMoved ? second : first] = codes;
  }
  return node;
}

YAML::Node CountsNode(const std::map<std::string, int>& shown) {
  YAML::Node node = Flow(YAML::NodeType::Map);
  for (const auto& [name, count] : shown) node[name] = count;
  return node;
}

YAML::Node ContributionNode(const Contribution& contribution,
                            const LearnedModel& model,
                            const Vocabulary& vocabulary) {
  YAML::Node node(YAML::NodeType::Map);
  node["by"] = CountsNode(contribution.shown);
  if (!contribution.build.empty()) node["build"] = contribution.build;
  node["types"] = Flow(YAML::NodeType::Sequence);
  for (const int type : contribution.types) {
    node["types"].push_back(vocabulary.types().name(type));
  }
  node["pick"] = FactsNode(contribution.pick, model, vocabulary);
  node["place"] = FactsNode(contribution.place, model, vocabulary);
  node["chain"] = ChainNode(contribution.chain);
  return node;
}

}  // namespace

LearnedModel LearnedModelFromConfig(const Config& config,
                                    const SceneWords& words) {
  return Reader(config, words).Read();
}

std::string ToText(const LearnedModel& model, const Vocabulary& vocabulary) {
  YAML::Node node(YAML::NodeType::Map);
  node["roles"] = Flow(YAML::NodeType::Map);
  for (const Variable& role : model.roles) {
    node["roles"][role.name] = vocabulary.types().name(role.type);
  }
  node["moved"] = model.roles[model.moved].name;
  node["pick"] = FactsNode(model.pick, model, vocabulary);
  node["place"] = FactsNode(model.place, model, vocabulary);
  node["chain"] = ChainNode(model.chain);
  node["shown"] = CountsNode(model.shown);
  for (const Contribution& contribution : model.taught) {
    node["taught"].push_back(ContributionNode(contribution, model, vocabulary));
  }
  return YAML::Dump(node);
}

std::string ToText(const Partner& partner, bool touches,
                   std::span<const Variable> roles) {
  return (touches ? "touches " : "apart from ") + NameOf(partner, roles);
}

}  // namespace cell
