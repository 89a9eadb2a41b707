#pragma once

#include <string>
#include <vector>

#include "common/actions/action_record.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"
#include "common/result/result.h"
#include "common/sec/learned_model.h"
#include "services/library/action_store.h"
#include "services/library/record_check.h"

namespace cell::library {

/// Changes of a library's content that a person asks for. Each is a list of
/// records to store in this order, all or none; nothing is ever overwritten:
/// they are the next versions. Refused with what is wrong and what would be
/// right.
class RecordEdits {
 public:
  using Records = std::vector<ActionRecord>;

  /// @param content  the latest version of each name
  /// All references must outlive this object.
  RecordEdits(const Records& content, const Domain& domain,
              const PartTable& parts)
      : content_(content), domain_(domain), parts_(parts) {}

  /// Those that undo it go with it.
  Result<Records> Rename(const std::string& name,
                         const std::string& new_name) const;
  Result<Records> Remove(const std::string& name) const;
  /// What was learned of an action becomes part of another; the action is
  /// removed.
  Result<Records> Merge(const std::string& name, const std::string& into) const;
  /// What a demonstration has taught is forgotten: its actions go back to what
  /// the others have taught. One that no other has taught is not recognised any
  /// more, or removed if nobody has named it.
  Result<Records> TakeBack(const std::string& demonstration) const;
  /// The content becomes what it was; what came later is removed.
  Result<Records> Restore(const Records& earlier) const;

 private:
  Result<ActionRecord> Find(const std::string& name) const;
  ActionRecord Next(ActionRecord record, const std::string& name) const;
  Result<ActionRecord> WithSec(const ActionRecord& record,
                               const LearnedModel& model) const;

  const Records& content_;
  const Domain& domain_;
  const PartTable& parts_;
};

/// Why the records cannot be stored one after the other; empty: they can.
std::string WhyNotAll(const std::vector<ActionRecord>& records,
                      const RecordCheck& check, const ActionStore& store);

}  // namespace cell::library
