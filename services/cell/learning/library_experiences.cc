#include "services/cell/learning/library_experiences.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <utility>

#include "common/actions/action_model_reader.h"
#include "common/experiences/task_experience.h"
#include "common/result/result.h"
#include "common/text/printable.h"
#include "services/library/sqlite_action_store.h"

namespace cell::cli {
namespace {

Result<rules::Experience> ToExperience(const ExperienceRecord& record,
                                       const Domain& domain,
                                       const RuleWorld& world) {
  const auto action = domain.FindAction(record.action);
  if (!action ||
      domain.actions()[static_cast<size_t>(*action)].agents.empty()) {
    return Reason{"the library has no action " + record.action};
  }
  const auto read = FromMessage(ToMessage(record), domain.vocabulary());
  if (!read) return Reason{read.reason()};
  const auto ground = domain.FindGroundAction(record.action, record.objects);
  if (!ground) {
    return Reason{record.action + " does not take these objects"};
  }
  return world.ToExperience(read->before, *ground, read->after);
}

}  // namespace

LibraryExperiences ReadLibraryExperiences(const std::filesystem::path& file,
                                          Domain domain) {
  const library::SqliteActionStore store(
      file, library::SqliteActionStore::Mode::kExisting);
  for (const ActionRecord& record : store.All()) {
    domain.Put(ReadAction(record, domain));
  }
  LibraryExperiences all{
      RuleWorld(std::make_shared<const Vocabulary>(domain.vocabulary()),
                domain.actions()),
      {},
      {},
      {}};
  for (const ExperienceRecord& record : store.Content().experiences) {
    auto experience = ToExperience(record, domain, all.world);
    if (experience) {
      all.experiences.push_back(*std::move(experience));
      all.demonstrations.push_back(record.demonstration);
    } else {
      all.left_out.push_back(
          fmt::format("experience {}: {}", record.id, experience.reason()));
    }
  }
  return all;
}

void PrintLeftOut(const LibraryExperiences& experiences) {
  for (const std::string& reason : experiences.left_out) {
    std::cout << "left out: " << Printable(reason) << "\n";
  }
}

}  // namespace cell::cli
