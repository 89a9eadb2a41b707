#include "services/cell/doctor/check.h"

#include <fmt/format.h>

#include "common/text/printable.h"

namespace cell::cli {

namespace {

std::string LineOf(const std::string& check, const Diagnosis& diagnosis) {
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

}  // namespace

// Names of processes and files are untrusted text.
std::string ToString(const std::string& check, const Diagnosis& diagnosis) {
  return Printable(LineOf(check, diagnosis));
}

}  // namespace cell::cli
