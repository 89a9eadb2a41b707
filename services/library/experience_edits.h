#pragma once

#include <string>
#include <vector>

#include "services/library/library_content.h"

namespace cell::library {

/// What an edit of a library's actions does to its experiences: each function
/// adds that to `edit`. Nothing is ever overwritten: a changed experience is
/// stored anew, and the one before it is removed.
using Experiences = std::vector<ExperienceRecord>;

/// Those of the action are of another one from now on.
void MoveExperiences(const Experiences& experiences, const std::string& action,
                     const std::string& to, StoreEdit* edit);
/// What people did in the demonstration is forgotten; what arms did in the same
/// episode is not.
void ForgetExperiences(const Experiences& experiences,
                       const std::string& demonstration, StoreEdit* edit);
/// They become the earlier ones.
void RestoreExperiences(const Experiences& experiences,
                        const Experiences& earlier, StoreEdit* edit);

/// Those that are in `experiences` and not in `others`, whatever their ids; of
/// equal ones as many as are missing there.
Experiences ExperiencesMissingIn(const Experiences& others,
                                 const Experiences& experiences);

}  // namespace cell::library
