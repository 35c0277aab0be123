#include "render/Programs.h"

#include <iterator>

#include "render/passes/Variants.h"
#include "shared/frame.h"

namespace velum::render {

namespace {

/// All flags that a program can be compiled for.
constexpr std::uint32_t kEverything = (shared::kFlagLast * 2u - 1u) & ~shared::kSwitches;

/// Flags that come up together, one set after the other for one variant after the other.
std::vector<std::uint32_t> flagSets() {
  using namespace shared;
  std::uint32_t plain = kFlagShaded;
  std::uint32_t inlays = plain | kFlagCuts | kFlagMembranes | kFlagInlays;
  std::vector<std::uint32_t> sets{0u,
                                  kEverything,
                                  plain,
                                  plain | kFlagLightGrid,
                                  plain | kFlagCuts | kFlagLightGrid,
                                  plain | kFlagCuts | kFlagSpares,
                                  plain | kFlagCuts | kFlagWalks | kFlagLightGrid,
                                  plain | kFlagCuts | kFlagSpares | kFlagSpareDepths,
                                  plain | kFlagCuts | kFlagCutGrid | kFlagLightGrid,
                                  plain | kFlagCuts | kFlagCutGrid | kFlagSpares,
                                  plain | kFlagCuts | kFlagCutGrid | kFlagMembranes,
                                  plain | kFlagGradientOpacity,
                                  plain | kFlagCuts | kFlagMembranes | kFlagLightGrid,
                                  plain | kFlagCuts | kFlagMembranes | kFlagSheets,
                                  inlays,
                                  inlays | kFlagSheets | kFlagLightGrid};
  for (std::uint32_t flag = 1; flag != 0; flag *= 2)
    if (!(flag & kSwitches)) sets.push_back(flag);
  return sets;
}

}  // namespace

std::vector<gpu::ProgramSource> allPrograms() {
  std::vector<gpu::ProgramSource> all;
  all.push_back({{"render/light_grid.comp"}, {}});
  all.push_back({{"render/light_means.comp"}, {}});
  for (const ResolveVariant& variant : allResolveVariants())
    all.push_back({{"render/resolve.comp"}, definesOf(variant)});
  for (std::size_t paper = 1; paper < std::size(EnumNames<scene::Paper>::kNames); ++paper)
    all.push_back({{"render/paper.comp"}, definesOf(static_cast<scene::Paper>(paper))});
  for (const char* file : {"finish", "stroke_align", "stroke_field", "stroke_turns"})
    all.push_back({{std::string("render/") + file + ".comp"}, {{"FINISH", "1"}}});
  for (const gpu::Defines& defines : {gpu::Defines{}, gpu::Defines{{"MEMBRANES", "1"}}})
    all.push_back({{"render/surface.vert", "render/surface.frag"}, defines});
  all.push_back({{"render/openness.comp"}, {}});
  all.push_back({{"render/instances.comp"}, {}});
  all.push_back({{"render/ghosts.comp"}, {}});
  std::vector<std::uint32_t> sets = flagSets();
  std::size_t next = 0;
  // All that there is in one, which nobody asks for: other sets only take away.
  std::uint32_t everything = kEverything & ~shared::kFlagNoData;
  for (DataVariant variant : allLightVariants()) {
    for (std::uint32_t flags : {everything, sets[next++ % sets.size()]}) {
      variant.flags = lightFlagsOf(flags);
      all.push_back({{"render/light_extinction.comp"}, definesOf(variant)});
    }
  }
  for (RayVariant variant : allRayVariants()) {
    variant.data.flags = everything;
    all.push_back({{"render/ray_cast.comp"}, definesOf(variant)});
    std::uint32_t flags = variant.data.flags = sets[next++ % sets.size()];
    if (!variant.data.hasMembranes && (flags & shared::kFlagCuts))
      variant.data.planes = int(next % std::size_t(shared::kMostPlanes + 1));
    all.push_back({{"render/ray_cast.comp"}, definesOf(variant)});
  }
  return all;
}

}  // namespace velum::render
