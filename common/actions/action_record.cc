#include "common/actions/action_record.h"

namespace cell {

ActionRecord Removed(const ActionRecord& record) {
  ActionRecord removed;
  removed.version = record.version + 1;
  removed.name = record.name;
  removed.arguments = record.arguments;
  return removed;
}

}  // namespace cell
