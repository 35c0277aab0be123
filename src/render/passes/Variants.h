#pragma once
#include <compare>
#include <cstdint>
#include <vector>

#include "gpu/Program.h"
#include "render/upload/PackedTexels.h"
#include "scene/Finish.h"
#include "scene/RayCast.h"

namespace velum::render {

/// What labels are to a picture. LABELS of the shaders.
enum class LabelUse { None, OverVolume, Alone };
/// What a volume's texels hold. COLOR of the shaders.
enum class TexelKind { Value, Color, Mixed };

/// What a program that reads the data is compiled for: all that is the same for all rays of a frame. One that asks for
/// it as it runs has the code of everything in it, thirty times what a plain picture needs: some drivers take minutes
/// to compile that, and software ones run both sides of a branch.
struct DataVariant {
  scene::RenderMode mode = scene::RenderMode::Volume;
  LabelUse labels = LabelUse::None;
  TexelKind texels = TexelKind::Value;
  Packing packing = Packing::None;  ///< Of values, on software drivers.
  bool hasMembranes = false;
  std::uint32_t flags = 0;  ///< kFlag*, the frame's, without its kSwitches.
  int planes = 0;           ///< Cuts, where all of them are planes and few; 0: any others.
  auto operator<=>(const DataVariant&) const = default;
};

/// The ray caster's.
struct RayVariant {
  DataVariant data;
  bool hasGradients = false;  ///< They are looked up in a texture.
  auto operator<=>(const RayVariant&) const = default;
};

/// What the picture's program is compiled for.
struct ResolveVariant {
  bool hasFinish = false, hasStrokes = false, hasPaper = false, hasGhosts = false;
  auto operator<=>(const ResolveVariant&) const = default;
};

/// Those of the flags that the light grid's shaders ask about.
std::uint32_t lightFlagsOf(std::uint32_t flags);
/// False for modes that shade nothing, and where there are no values to take differences of.
bool usesGradients(const DataVariant& variant);

gpu::Defines definesOf(const DataVariant& variant);
gpu::Defines definesOf(const RayVariant& variant);
gpu::Defines definesOf(const ResolveVariant& variant);
/// Of the program that makes a paper.
gpu::Defines definesOf(scene::Paper paper);

/// All that a frame can ask for, flags left open.
std::vector<DataVariant> allLightVariants();
std::vector<RayVariant> allRayVariants();
std::vector<ResolveVariant> allResolveVariants();

}  // namespace velum::render
