#pragma once

#include <span>
#include <string>

#include "common/config/config.h"
#include "common/sec/learned_model.h"
#include "common/sec/scene_words.h"

namespace cell {

/// Reads a model, e.g.
///
///   roles: {X: bolt, Y: hole}
///   moved: X
///   pick: {touch: [table], apart: [Y], where: [not InHole(X, Y)]}
///   place: {touch: [Y, any nut], apart: [table], where: ["InHole(X, Y)"]}
///   chain: {hole: "001", table: "100"}
///   shown: {assembly 1: 2}
///   taught:  # optional: what each demonstration has taught, as it was then
///     - {by: {assembly 1: 2}, build: 0.1.0, types: [bolt, hole], pick: ...,
///        place: ..., chain: ...}
///
/// touch and apart name what the moved part touches: a role (of a site the part
/// that has it), the table, a part, or any part of a type. The rows of the
/// chain are named by the table or a type, their entries are codes of
/// relations. `types` are those of the roles, in their order.
/// @throws ConfigError naming file:key; also if nothing changes, if a role is
/// not mentioned, if pick or place contradicts itself, and if `taught` is not
/// of the demonstrations in `shown`.
LearnedModel LearnedModelFromConfig(const Config& config,
                                    const SceneWords& words);

/// The text that is read as this model.
std::string ToText(const LearnedModel& model, const Vocabulary& vocabulary);

/// Short: "touches table, not InHole(X, Y)".
std::string ToText(const Partner& partner, bool touches,
                   std::span<const Variable> roles);

}  // namespace cell
