#include "common/actions/action_models.h"

#include <utility>

#include "common/actions/action_model_reader.h"

namespace cell {

ActionModels::ActionModels(Domain domain, PartTable parts,
                           std::vector<ActionModel> models)
    : domain_(std::move(domain)),
      parts_(std::move(parts)),
      models_(std::move(models)) {}

Result<ActionModels::Update> ActionModels::Apply(const ActionRecord& record) {
  ActionModel model;
  try {
    model = ReadActionModel(record, domain_, parts_);
  } catch (const ConfigError& e) {
    return Reason{e.what()};
  }
  domain_.Put(model.action);
  const auto place = static_cast<size_t>(*domain_.FindAction(record.name));
  if (place == models_.size()) {
    models_.push_back(std::move(model));
    return Update::kChanged;
  }
  if (models_[place] == model) return Update::kNone;
  models_[place] = std::move(model);
  return Update::kChanged;
}

}  // namespace cell
