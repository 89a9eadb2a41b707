#include "common/experiences/experience_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <string_view>

namespace cell {
namespace {

constexpr char kUnknownSign = '?';
constexpr std::string_view kBetweenObjects = ", ";

std::vector<std::string> TextsOf(const std::vector<literal_t>& literals) {
  std::vector<std::string> texts;
  for (const literal_t& literal : literals) {
    texts.push_back(fmt::format(
        "{}{}({})", literal.value == literal_t::UNKNOWN ? "?" : "",
        literal.predicate, fmt::join(literal.arguments, kBetweenObjects)));
  }
  return texts;
}

std::vector<literal_t> AtomsFrom(const std::vector<std::string>& texts) {
  std::vector<literal_t> atoms;
  for (const std::string& text : texts) {
    const auto atom = ParseAtom(text);
    if (!atom) {
      throw std::invalid_argument(
          "'" + text + "' should be a predicate of objects, as On(a, b)");
    }
    atoms.push_back(*atom);
  }
  return atoms;
}

bool IsWord(std::string_view text) {
  return !text.empty() && text.find_first_of("(), ?") == std::string_view::npos;
}

}  // namespace

std::optional<literal_t> ParseAtom(const std::string& text) {
  literal_t literal{};
  std::string_view rest = text;
  const bool is_unknown = rest.starts_with(kUnknownSign);
  if (is_unknown) rest.remove_prefix(1);
  literal.value = is_unknown ? literal_t::UNKNOWN : literal_t::TRUE_;
  const size_t open = rest.find('(');
  if (open == std::string_view::npos || !rest.ends_with(')')) {
    return std::nullopt;
  }
  literal.predicate = rest.substr(0, open);
  rest = rest.substr(open + 1, rest.size() - open - 2);
  while (!rest.empty()) {
    const size_t end = rest.find(kBetweenObjects);
    literal.arguments.emplace_back(rest.substr(0, end));
    if (!IsWord(literal.arguments.back())) return std::nullopt;
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + kBetweenObjects.size());
    if (rest.empty()) return std::nullopt;
  }
  if (!IsWord(literal.predicate)) return std::nullopt;
  literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
  return literal;
}

ExperienceRecord ToRecord(const experience_t& message) {
  ExperienceRecord record;
  record.id = message.id;
  record.action = message.action;
  record.objects = message.arguments;
  record.agent = message.agent;
  record.before = TextsOf(message.before);
  record.after = TextsOf(message.after);
  return record;
}

experience_t ToMessage(const ExperienceRecord& record) {
  experience_t message{};
  message.id = record.id;
  message.action = record.action;
  message.arguments = record.objects;
  message.num_arguments = static_cast<int32_t>(message.arguments.size());
  message.agent = record.agent;
  message.before = AtomsFrom(record.before);
  message.num_before = static_cast<int32_t>(message.before.size());
  message.after = AtomsFrom(record.after);
  message.num_after = static_cast<int32_t>(message.after.size());
  return message;
}

}  // namespace cell
