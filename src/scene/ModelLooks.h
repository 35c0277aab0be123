#pragma once
#include <span>
#include <string_view>

#include "scene/Finish.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// A look of models by name: palette, light, contours, background.
struct NamedModelLook {
  std::string_view name;   ///< "painted"
  std::string_view title;  ///< "Painted"
  std::string_view tip;    ///< what it is, for people
};

/// The look of a model that has just been opened.
constexpr std::string_view kFirstModelLook = "painted";
/// Samples a pixel of a model that has just been opened. Instances are often smaller than a pixel: with six a picture
/// of 1000 rows looks like one of 4000.
constexpr int kModelSamples = 6;

/// Every look, in the order of the window.
std::span<const NamedModelLook> modelLooks();

/// Gives a scene a look by name. Colours that types have of their own, and the user's own lit spheres and paper, stay.
/// @param name  also one that a look had once
/// @throw ArgumentError for an unknown name, listing the known ones
void applyModelLook(Scene& scene, std::string_view name);

/// Gives a scene whose model has just been opened, and is alone, its first look, and samples enough for it.
void applyFirstModelLook(Scene& scene);

/// How much of a pixel a model's shapes may be off in a scene's picture: more samples resolve finer ones.
double shapeDetail(const Scene& scene);

/// The finish that belongs to the look which a scene's model was given last; it adds nothing where there is none. The
/// user's own lit spheres and paper are in it.
Finish lookFinish(const Scene& scene);

/// True when a look has this name, or had it once.
bool isModelLook(std::string_view name);

/// The name of the look that a scene has; empty: its look is the user's own.
std::string_view modelLookName(const Scene& scene);

}  // namespace velum::scene
