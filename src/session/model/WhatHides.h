#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A type that hides another type or compartment; or all that is no model, taken together.
struct Hider {
  std::string path;          ///< empty: a volume, surfaces, or anything else that is no instance
  std::uint64_t pixels = 0;  ///< on how many pixels this type is seen instead
  double share = 0.0;        ///< share of the pixels of what is hidden
};

/// What is seen in the place of a type or compartment.
struct Hiding {
  std::string path;
  std::uint64_t pixels = 0;   ///< how many pixels the type would take if nothing stood before it
  std::uint64_t seen = 0;     ///< on how many of these pixels the type is seen
  std::vector<Hider> hiders;  ///< the types that hide most of it first
  std::string words;          ///< one short sentence for people
};

/// The scene with a type or compartment alone: other types, volume, labels and surfaces are not shown, and cuts clear
/// nothing for a view. A picture of this scene shows what the type would take. @throw InputError as of typesAt()
scene::Scene aloneScene(const scene::Scene& scene, std::string_view path);

/// What hides a type or compartment, and by how much: told by which types have its pixels in the whole picture.
/// Instances that cuts clear for a view are hidden by no type, and are left out.
/// @param alone  a picture of aloneScene() with the layers type and instance  @param whole  such a picture of the
/// scene, of the same size
Hiding whatHides(const scene::Scene& scene, std::string_view path, const Image& alone, const Image& whole);

/// Draws a scene with the layers type and instance.
using TypePicture = std::function<Image(const scene::Scene&)>;
Hiding whatHides(const scene::Scene& scene, std::string_view path, const TypePicture& picture);

/// Keeps a type or compartment in view by a cut everywhere, so that what stands before it goes and everything else
/// stays. The type is added to a cut that does this for other types, where there is one; else a cut is added.
/// @return the cut's id
/// @throw InputError as of typesAt()
int clearTheWay(scene::Scene& scene, std::string_view path);
/// True when a cut that is on keeps the type or compartment in view.
bool isKeptInView(const scene::Scene& scene, std::string_view path);
/// Lets no cut keep the type or compartment in view any more. A cut that is everywhere, and served nothing else, is
/// removed.
void endKeepInView(scene::Scene& scene, std::string_view path);

/// Says that only instances are cleared where a volume could hide them, too; empty without one.
std::string clearingWords(const scene::Scene& scene);

}  // namespace velum::session
