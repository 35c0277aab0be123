#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A type that hides another, or what is no model at all.
struct Hider {
  std::string path;          ///< empty: a volume, surfaces, or what else is no instance
  std::uint64_t pixels = 0;  ///< where it is seen instead
  double share = 0.0;        ///< of the pixels of what is hidden
};

/// What is seen in the place of a type or compartment.
struct Hiding {
  std::string path;
  std::uint64_t pixels = 0;   ///< that it would take if nothing stood before it
  std::uint64_t seen = 0;     ///< of these, where it is seen
  std::vector<Hider> hiders;  ///< those that hide most of it first
  std::string words;          ///< one short sentence for people
};

/// The scene with a type or compartment alone: other types are not shown, nor are volume, labels and surfaces, and
/// nothing is cleared for a view. In its picture stands what the type would take. @throw InputError as of typesAt()
scene::Scene aloneScene(const scene::Scene& scene, std::string_view path);

/// What hides a type or compartment, and by how much: by who has its pixels in the whole picture. Instances that cuts
/// clear are hidden by nobody, and are left out.
/// @param alone  a picture of aloneScene() with the layers type and instance  @param whole  of the scene, of the same
/// size
Hiding whatHides(const scene::Scene& scene, std::string_view path, const Image& alone, const Image& whole);

/// Draws a scene with the layers type and instance.
using TypePicture = std::function<Image(const scene::Scene&)>;
Hiding whatHides(const scene::Scene& scene, std::string_view path, const TypePicture& picture);

/// Adds a cut everywhere that keeps a type or compartment in view, so that what stands before it goes and all else
/// stays; where there is one that does this for others, the type is added to them. @return the cut's id
/// @throw InputError as of typesAt()
int clearTheWay(scene::Scene& scene, std::string_view path);
/// A cut that is on keeps it in view.
bool isKeptInView(const scene::Scene& scene, std::string_view path);
/// No cut does any more. One that was everywhere, and for nothing else, goes.
void endKeepInView(scene::Scene& scene, std::string_view path);

}  // namespace velum::session
