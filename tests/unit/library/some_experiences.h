#pragma once

#include <string>

#include "common/experiences/experience_record.h"

namespace cell {

/// An experience in the words of the shipped task; differs with the number.
inline ExperienceRecord Tried(const std::string& action, int number = 0) {
  ExperienceRecord experience;
  experience.action = action;
  experience.objects = {number % 2 == 0 ? "separator" : "shaft"};
  experience.agent = number % 3 == 0 ? "robot" : "person";
  experience.before = {"Clear(separator)", "?Clear(shaft)"};
  experience.after = {"Clear(shaft)"};
  experience.demonstration = "assembly " + std::to_string(number);
  return experience;
}

}  // namespace cell
