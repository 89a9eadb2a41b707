#pragma once

#include <string>
#include <vector>

#include "common/actions/action_record.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"
#include "common/result/result.h"
#include "common/sec/learned_model.h"
#include "services/library/action_store.h"
#include "services/library/library_content.h"
#include "services/library/record_check.h"

namespace cell::library {

/// Changes of a library's content that a person asks for. Each is to be stored
/// as a whole; nothing is ever overwritten: records are the next versions, and
/// an experience that changes is stored anew. Refused with what is wrong and
/// what would be right.
class RecordEdits {
 public:
  using Records = std::vector<ActionRecord>;

  /// All references must outlive this object.
  RecordEdits(const LibraryContent& content, const Domain& domain,
              const PartTable& parts)
      : content_(content), domain_(domain), parts_(parts) {}

  /// Those that undo it go with it, and its experiences.
  Result<StoreEdit> Rename(const std::string& name,
                           const std::string& new_name) const;
  /// Its experiences are kept, and are told again if it comes back.
  Result<StoreEdit> Remove(const std::string& name) const;
  /// What was learned of an action, and its experiences, become part of
  /// another; the action is removed.
  Result<StoreEdit> Merge(const std::string& name,
                          const std::string& into) const;
  /// What a demonstration has taught is forgotten: its actions go back to what
  /// the others have taught. One that no other has taught is not recognised any
  /// more, or removed if nobody has named it.
  /// What people did in it is no experience any more.
  Result<StoreEdit> TakeBack(const std::string& demonstration) const;
  /// The content becomes what it was; what came later is removed.
  Result<StoreEdit> Restore(const LibraryContent& earlier) const;

 private:
  Result<ActionRecord> Find(const std::string& name) const;
  ActionRecord Next(ActionRecord record, const std::string& name) const;
  Result<ActionRecord> WithSec(const ActionRecord& record,
                               const LearnedModel& model) const;

  Result<Records> RecordsWithout(const std::string& demonstration) const;
  Records RecordsOf(const Records& earlier) const;

  const LibraryContent& content_;
  const Domain& domain_;
  const PartTable& parts_;
};

/// Why the records cannot be stored one after the other; empty: they can.
std::string WhyNotAll(const RecordEdits::Records& records,
                      const RecordCheck& check, const ActionStore& store);

}  // namespace cell::library
