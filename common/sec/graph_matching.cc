#include "common/sec/graph_matching.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace cell {
namespace {

/// A graph by numbers of its objects, which are in the order of their names.
class NumberedGraph {
 public:
  NumberedGraph(const TouchGraph& graph, const ObjectTypes& kinds) {
    std::set<std::string> names;
    for (const auto& [pair, relation] : graph) {
      names.insert({pair.first, pair.second});
    }
    names_.assign(names.begin(), names.end());
    for (const std::string& name : names_) {
      const auto it = kinds.find(name);
      kinds_.push_back(it == kinds.end() ? name : it->second);
      is_alone_.push_back(it == kinds.end());
    }
    relations_.resize(size() * size(), Relation::kNotTouching);
    for (const auto& [pair, relation] : graph) {
      const size_t i = NumberOf(pair.first), j = NumberOf(pair.second);
      relations_[i * size() + j] = relations_[j * size() + i] = relation;
    }
    for (size_t i = 0; i < size(); ++i) signatures_.push_back(SignatureOf(i));
  }

  size_t size() const { return names_.size(); }
  const std::string& name(size_t i) const { return names_[i]; }
  Relation At(size_t i, size_t j) const { return relations_[i * size() + j]; }

  /// False if the two cannot correspond, whatever the others do.
  bool MayBe(size_t i, const NumberedGraph& other, size_t j) const {
    return signatures_[i] == other.signatures_[j];
  }
  /// The same for any isomorphic graph.
  std::vector<std::string> SortedKinds() const {
    std::vector<std::string> kinds = kinds_;
    std::ranges::sort(kinds);
    return kinds;
  }

 private:
  // Its kind, whether it is alone of it, and the relations with each kind.
  struct Signature {
    std::string kind;
    bool is_alone = false;
    std::map<std::pair<std::string, Relation>, int> num_relations;

    bool operator==(const Signature&) const = default;
  };

  size_t NumberOf(const std::string& name) const {
    return static_cast<size_t>(std::ranges::lower_bound(names_, name) -
                               names_.begin());
  }
  Signature SignatureOf(size_t i) const {
    Signature signature{kinds_[i], is_alone_[i], {}};
    for (size_t j = 0; j < size(); ++j) {
      if (j != i) ++signature.num_relations[{kinds_[j], At(i, j)}];
    }
    return signature;
  }

  std::vector<std::string> names_, kinds_;
  std::vector<bool> is_alone_;  // of its kind, as it is not listed
  std::vector<Relation> relations_;
  std::vector<Signature> signatures_;
};

class Search {
 public:
  Search(const NumberedGraph& a, const NumberedGraph& b) : a_(a), b_(b) {}

  /// Extends the match of the first objects of `a` to all.
  bool Extend() {
    const size_t i = match_.size();
    if (i == a_.size()) return true;
    for (const size_t j : Candidates(i)) {
      match_.push_back(j);
      if (Extend()) return true;
      match_.pop_back();
    }
    return false;
  }
  ObjectMap Names() const {
    ObjectMap names;
    for (size_t i = 0; i < match_.size(); ++i) {
      names.emplace(a_.name(i), b_.name(match_[i]));
    }
    return names;
  }

 private:
  // Itself first.
  std::vector<size_t> Candidates(size_t i) const {
    std::vector<size_t> candidates;
    for (size_t j = 0; j < b_.size(); ++j) {
      if (Fits(i, j)) candidates.push_back(j);
    }
    std::ranges::stable_partition(
        candidates, [&](size_t j) { return b_.name(j) == a_.name(i); });
    return candidates;
  }
  bool Fits(size_t i, size_t j) const {
    if (!a_.MayBe(i, b_, j)) return false;
    for (size_t k = 0; k < match_.size(); ++k) {
      if (match_[k] == j || a_.At(i, k) != b_.At(j, match_[k])) return false;
    }
    return true;
  }

  const NumberedGraph& a_;
  const NumberedGraph& b_;
  std::vector<size_t> match_;
};

}  // namespace

std::optional<ObjectMap> MatchGraphs(const TouchGraph& a, const TouchGraph& b,
                                     const ObjectTypes& kinds) {
  const NumberedGraph graph_a(a, kinds), graph_b(b, kinds);
  if (graph_a.SortedKinds() != graph_b.SortedKinds()) return std::nullopt;
  Search search(graph_a, graph_b);
  if (!search.Extend()) return std::nullopt;
  return search.Names();
}

}  // namespace cell
