#include "common/text/counted.h"

namespace cell {

std::string Counted(int64_t number, const std::string& noun,
                    const std::string& plural) {
  const std::string many = plural.empty() ? noun + "s" : plural;
  return std::to_string(number) + " " + (number == 1 ? noun : many);
}

}  // namespace cell
