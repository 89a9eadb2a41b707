#pragma once

#include "cell/action_record_t.hpp"
#include "services/library/action_record.h"

namespace cell::library {

/// All but the header.
action_record_t ToMessage(const ActionRecord& record);
ActionRecord FromMessage(const action_record_t& message);

}  // namespace cell::library
