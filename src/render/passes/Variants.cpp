#include "render/passes/Variants.h"

#include <fmt/format.h>

#include "shared/frame.h"

namespace velum::render {

std::uint32_t lightFlagsOf(std::uint32_t flags) {
  return flags & (shared::kFlagSpares | shared::kFlagSpareDepths | shared::kFlagInlays | shared::kFlagCutGrid |
                  shared::kFlagSolids | shared::kFlagVeils | shared::kFlagJoined);
}

bool usesGradients(const DataVariant& variant) {
  return variant.mode != scene::RenderMode::Mip && variant.labels != LabelUse::Alone;
}

gpu::Defines definesOf(const DataVariant& variant) {
  auto number = [](auto value) { return std::to_string(static_cast<int>(value)); };
  gpu::Defines defines{{"MODE", number(variant.mode)},
                       {"LABELS", number(variant.labels)},
                       {"COLOR", number(variant.texels)},
                       {"PACKED", number(variant.packing)},
                       {"BRICKS", number(variant.bricks)}};
  if (variant.hasLabelBricks) defines.push_back({"LABEL_BRICKS", "1"});
  if (variant.hasMembranes) defines.push_back({"MEMBRANES", "1"});
  if (variant.planes > 0) defines.push_back({"PLANES", std::to_string(variant.planes)});
  defines.push_back({"FLAGS", fmt::format("{}u", variant.flags)});
  return defines;
}

gpu::Defines definesOf(const RayVariant& variant) {
  gpu::Defines defines = definesOf(variant.data);
  defines.push_back({"GRADIENTS", variant.hasGradients ? "1" : "0"});
  // What has loops within loops within loops.
  if (variant.data.hasMembranes || (variant.data.flags & shared::kFlagSpares)) defines.push_back({"NOT_UNROLLED", "1"});
  return defines;
}

gpu::Defines definesOf(const ResolveVariant& variant) {
  gpu::Defines defines;
  if (variant.hasFinish) defines.push_back({"FINISH", "1"});
  if (variant.hasStrokes) defines.push_back({"STROKES", "1"});
  if (variant.hasPaper) defines.push_back({"PAPER", "1"});
  if (variant.hasGhosts) defines.push_back({"GHOSTS", "1"});
  return defines;
}

gpu::Defines definesOf(scene::Paper paper) {
  return {{"FINISH", "1"}, {"PAPER", std::to_string(static_cast<int>(paper))}};
}

std::vector<DataVariant> allLightVariants() {
  std::vector<DataVariant> all;
  for (bool hasMembranes : {false, true}) {
    for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Mip, scene::RenderMode::Iso})
      for (LabelUse labels : {LabelUse::None, LabelUse::OverVolume}) {
        for (TexelKind texels : {TexelKind::Value, TexelKind::Color, TexelKind::Mixed})
          all.push_back({mode, labels, texels, Packing::None, BrickUse::None, false, hasMembranes, {}});
        for (Packing packing : {Packing::Bytes, Packing::Shorts})
          all.push_back({mode, labels, TexelKind::Value, packing, BrickUse::None, false, hasMembranes, {}});
        // How values lie and how bricks are found have nothing to do with each other. Labels lie as the volume does.
        for (BrickUse bricks : {BrickUse::ByGroup, BrickUse::BySample})
          all.push_back(
              {mode, labels, TexelKind::Value, Packing::Bytes, bricks, labels != LabelUse::None, hasMembranes, {}});
      }
    // Labels alone have no values: there is one mode.
    all.push_back({scene::RenderMode::Volume,
                   LabelUse::Alone,
                   TexelKind::Value,
                   Packing::None,
                   BrickUse::None,
                   false,
                   hasMembranes,
                   {}});
  }
  return all;
}

std::vector<RayVariant> allRayVariants() {
  std::vector<RayVariant> all;
  for (const DataVariant& data : allLightVariants()) {
    // Who packs values has their gradients too.
    if (data.packing == Packing::None || !usesGradients(data)) all.push_back({data, false});
    if (usesGradients(data)) all.push_back({data, true});
  }
  return all;
}

std::vector<ResolveVariant> allResolveVariants() {
  std::vector<ResolveVariant> all;
  for (bool hasGhosts : {false, true}) {
    all.push_back({false, false, false, hasGhosts});
    for (bool hasStrokes : {false, true})
      for (bool hasPaper : {false, true}) all.push_back({true, hasStrokes, hasPaper, hasGhosts});
  }
  return all;
}

}  // namespace velum::render
