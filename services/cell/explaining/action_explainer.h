#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/cell/explaining/explainer.h"
#include "services/recognizer/recognizer.h"

namespace cell::cli {

/// Explains why manipulations were recognised as they were: which model, which
/// of its facts held, and what the next best one lacked. Recognises again what
/// the KEY_FRAMEs show, with the models of the run and its ACTION_RECORDs.
class ActionExplainer final : public Explainer {
 public:
  explicit ActionExplainer(const recognizer::Recognizer::Params& params);

  /// Takes the messages in canonical order.
  void Put(const Message& message);
  const std::vector<Explanation>& explanations() const { return explanations_; }

  std::vector<int64_t> Utimes() const override;
  std::vector<Explanation> At(int64_t utime) const override;

 private:
  void Begin();
  void OnKeyFrame(const Message& message);
  void OnRecord(const Message& message);
  void Explain(const ObservedManipulation& manipulation,
               const std::vector<recognizer::RecognisedAction>& actions);

  recognizer::Recognizer::Params params_;
  ActionModels actions_;
  std::shared_ptr<const SecLibrary> library_;
  std::unique_ptr<recognizer::Recognition> recognition_;
  std::vector<Explanation> explanations_;
};

}  // namespace cell::cli
