#pragma once
#include <string>

#include "scene/Mark.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What people call a kind of mark: "Distance".
const char* markTitle(scene::MarkKind kind);
/// What a mark is called in lists: its own words, else the name of what it names, else its kind.
std::string markName(const scene::Scene& scene, const scene::Mark& mark);
/// What a mark measures, as text: "23.4 mm"; empty where its kind measures nothing, or nothing that is known at once.
std::string markValue(const scene::Scene& scene, const scene::Mark& mark);
/// What is written beside a mark: its words, and what it measures behind them. Lines are parted by '\n'.
/// @param value  what it measures; empty: nothing, or it is not known yet
std::string markWords(const scene::Scene& scene, const scene::Mark& mark, const std::string& value);
inline std::string markWords(const scene::Scene& scene, const scene::Mark& mark) {
  return markWords(scene, mark, markValue(scene, mark));
}

}  // namespace velum::session
