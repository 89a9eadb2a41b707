#include "services/cell/doctor/check.h"

#include <fmt/format.h>

namespace cell::cli {

std::string ToString(const std::string& check, const Diagnosis& diagnosis) {
  switch (diagnosis.level) {
    case Diagnosis::Level::kOk:
      return fmt::format("ok   {}: {}", check, diagnosis.what);
    case Diagnosis::Level::kWarning:
      return fmt::format("warn {}: {}; fix: {}", check, diagnosis.what,
                         diagnosis.fix);
    case Diagnosis::Level::kBad:
      break;
  }
  return fmt::format("BAD  {}: {}; fix: {}", check, diagnosis.what,
                     diagnosis.fix);
}

}  // namespace cell::cli
