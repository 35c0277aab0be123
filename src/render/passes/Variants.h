#pragma once
#include <compare>
#include <cstdint>
#include <vector>

#include "gpu/Program.h"
#include "render/upload/PackedTexels.h"
#include "scene/Finish.h"
#include "scene/RayCast.h"

namespace velum::render {

/// The part that labels play in a picture; the shaders' define LABELS.
enum class LabelUse { None, OverVolume, Alone };
/// What a volume's texels hold; the shaders' define COLOR.
enum class TexelKind { Value, Color, Mixed };

/// Whether a volume lies in bricks, and who asks in which; the shaders' define BRICKS.
enum class BrickUse { None, ByGroup, BySample };

/// What a program that reads the data is compiled for: everything that is the same for all rays of a frame. A program
/// that would test this while it runs would hold the code for everything, thirty times what a plain picture needs: some
/// drivers take minutes to compile that, and software drivers run both sides of a branch.
struct DataVariant {
  scene::RenderMode mode = scene::RenderMode::Volume;
  LabelUse labels = LabelUse::None;
  TexelKind texels = TexelKind::Value;
  Packing packing = Packing::None;  ///< How values are packed, on software drivers.
  BrickUse bricks = BrickUse::None;
  bool hasLabelBricks = false;  ///< Labels lie in bricks; the shaders' define LABEL_BRICKS.
  bool hasMembranes = false;
  std::uint32_t flags = 0;  ///< The frame's kFlag* bits without those of kSwitches.
  int planes = 0;           ///< Number of cuts where all of them are planes, and few; 0: any other cuts.
  auto operator<=>(const DataVariant&) const = default;
};

/// The variant of the ray caster's program.
struct RayVariant {
  DataVariant data;
  bool hasGradients = false;  ///< Gradients are looked up in a texture.
  auto operator<=>(const RayVariant&) const = default;
};

/// What the picture's program is compiled for.
struct ResolveVariant {
  bool hasFinish = false, hasStrokes = false, hasPaper = false, hasGhosts = false;
  auto operator<=>(const ResolveVariant&) const = default;
};

/// Those of the flags that the light grid's shaders test.
std::uint32_t lightFlagsOf(std::uint32_t flags);
/// Whether a variant uses gradients: false for modes that shade nothing, and where there are no values to take
/// differences of.
bool usesGradients(const DataVariant& variant);

gpu::Defines definesOf(const DataVariant& variant);
gpu::Defines definesOf(const RayVariant& variant);
gpu::Defines definesOf(const ResolveVariant& variant);
/// Defines of the program that makes a paper.
gpu::Defines definesOf(scene::Paper paper);

/// All variants that a frame can ask for, whatever the flags.
std::vector<DataVariant> allLightVariants();
std::vector<RayVariant> allRayVariants();
std::vector<ResolveVariant> allResolveVariants();

}  // namespace velum::render
