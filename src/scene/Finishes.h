#pragma once
#include <span>
#include <string>
#include <string_view>

#include "scene/Scene.h"

namespace velum::scene {

/// A finish by name.
struct NamedFinish {
  std::string_view name;   ///< "pencil"
  std::string_view title;  ///< "Pencil"
  std::string_view tip;    ///< what it is, for people
};

/// Every finish, in the order of the window; the first, "none", adds nothing to the picture: of a model, its look's own
/// contours stay.
std::span<const NamedFinish> finishes();

/// Gives a scene a finish by name. The user's own lit spheres and paper, and the spheres that structures name, stay.
/// @throw ArgumentError for an unknown name, listing the known ones
void applyFinish(Scene& scene, std::string_view name);

/// The name of the finish that has the values of the scene's; empty when there is none: the user has set the values.
std::string_view finishName(const Scene& scene);

/// True when a picture with this finish differs from one without.
bool addsAnything(const Finish& finish);

/// True where a model is all that is drawn: a finish then draws the lines of models.
bool drawsModelAlone(const Scene& scene);

/// Jumps of depth that a finish draws a line along: the least, and those that have a strong one (of models).
struct DepthSteps {
  double least = 0.0;
  double deep = 0.0;
};

/// The steps of a model's lines, angstrom.
DepthSteps modelDepthSteps(const ModelLayer& model);

/// The user's own lit sphere with a name; nullptr: there is none.
const LitSphere* ownLitSphere(const Finish& finish, std::string_view name);
/// True when one of our lit spheres or of the user's own has the name.
bool isLitSphere(const Finish& finish, std::string_view name);
/// Names of lit spheres that a scene uses but that do not exist.
std::vector<std::string> unknownLitSpheres(const Scene& scene);

}  // namespace velum::scene
