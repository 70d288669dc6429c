#pragma once

#include "solver/simulation/scene.hpp"
#include "validation/study.hpp"

namespace cleave::validation {

/// What the paper's figures claim, measured on running scenes: figures of each (scene_figures.hpp; the place is the scene's name), and
/// comparisons between two of them (the place is the claim's name; 1 where it holds, 0 where it does not).
StudyInfo scene_claims_study();

/// Texts "KEY=VALUE", as `cleave simulate --set` takes them.
simulation::Overrides read_overrides(TableReader& table, const std::string& key);

}  // namespace cleave::validation
