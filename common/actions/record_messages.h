#pragma once

#include "cell/action_record_t.hpp"
#include "common/actions/action_record.h"

namespace cell {

/// All but the header.
action_record_t ToMessage(const ActionRecord& record);
ActionRecord FromMessage(const action_record_t& message);

}  // namespace cell
