#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/Shared.h"
#include "core/Volume.h"
#include "gpu/Context.h"
#include "scene/Scene.h"

namespace velum::bench {

/// The one context of this process that draws without a window. GL thread.
gpu::Context& sharedContext();

/// The first channel and time step of a volume on a grid of so many voxels over the same box, axis-aligned about the
/// origin, by linear interpolation.
Volume resample(const Volume& from, glm::ivec3 dims);
/// A phantom brought to so many voxels by linear interpolation, its box axis-aligned about the origin.
Volume makePhantom(std::string_view name, glm::ivec3 dims);
/// The same with as many voxels along each axis.
Volume makeCube(std::string_view phantom, int n);

/// A volume of any size at once, uint8: a wavy double shell (skin and skull) about a gyroid; about a third is empty.
Volume makeShells(int n);

/// How much of makeShells() can be seen through.
enum class Opacity { Opaque, SkinOverBone, Translucent };
constexpr std::string_view kOpacityNames[] = {"opaque", "skin over bone", "translucent"};
/// A scene of makeShells() or alike with everything on and a camera from the front.
scene::Scene makeShellScene(const Shared<Volume>& volume, Opacity opacity, double aspect);

struct Case {
  std::string key;  ///< For figures and file names.
  std::string title;
  scene::Scene scene;  ///< With its data and a camera from the front.
};
/// Opaque bone, skin over bone, thin vessels; with real data beside them where it is at hand (VELUM_TEST_DATA, Debian's
/// invesalius-examples).
std::vector<Case> makeCases(int n, double aspect, bool withRealData);

/// What VTK does not do switched off, light from the eye, black background: the fair scene.
scene::Scene plain(scene::Scene scene);

/// The camera, turned about the vertical axis of the world to the i-th of n positions.
scene::Camera turned(scene::Camera camera, int i, int n);

}  // namespace velum::bench
