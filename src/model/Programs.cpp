#include "model/Programs.h"

#include <algorithm>

#include "model/InstanceTarget.h"

namespace velum::model {

namespace {

const gpu::Program& made(gpu::Program& program, std::string_view file, const gpu::Defines& defines = {}) {
  if (!program) program = gpu::Program({file}, defines);
  return program;
}

}  // namespace

gpu::Defines cullDefines(CullBy by, bool isOfWords) {
  gpu::Defines defines;
  if (by == CullBy::Membranes) defines.emplace_back("MEMBRANES", "1");
  if (by == CullBy::States) defines.emplace_back("STATES", "1");
  if (by == CullBy::Ghosts) defines.emplace_back("GHOSTS", "1");
  if (by == CullBy::Nearest) defines.emplace_back("NEAREST", "1");
  if (isOfWords) defines.emplace_back("WORDS", "1");
  return defines;
}

gpu::Defines splatDefines(DrawOf of, bool isLarge) {
  gpu::Defines defines;
  if (of != DrawOf::Molecules) defines.emplace_back("WHOLES", "1");
  if (of == DrawOf::WholesWithMembranes) defines.emplace_back("MEMBRANES", "1");
  if (isLarge) defines.emplace_back("LARGE", "1");
  return defines;
}

gpu::Defines listDefines(ListOf of) {
  if (of == ListOf::Bundles) return {};
  return {{of == ListOf::Copies ? "COPIES" : "BLOCKS", "1"}};
}

namespace {

gpu::Defines wholeDefines(bool isOfWords) {
  gpu::Defines defines{{"WHOLES", "1"}};
  if (isOfWords) defines.emplace_back("WORDS", "1");
  return defines;
}

}  // namespace

gpu::Defines focusDefines(bool hasMembranes, bool isOfOccluders) {
  gpu::Defines defines;
  if (hasMembranes) defines.emplace_back("MEMBRANES", "1");
  if (isOfOccluders) defines.emplace_back("OCCLUDERS", "1");
  return defines;
}

const gpu::Program& InstancePrograms::bundles(ListOf of) {
  return made(mBundles[of], "model/bundles.comp", listDefines(of));
}
const gpu::Program& InstancePrograms::cullWholes(bool isOfWords) {
  return made(mCullWholes[isOfWords], "model/cull.comp", wholeDefines(isOfWords));
}
const gpu::Program& InstancePrograms::cull(CullBy by, bool isOfWords) {
  return made(mCull[{by, isOfWords}], "model/cull.comp", cullDefines(by, isOfWords));
}
const gpu::Program& InstancePrograms::clip(bool hasMembranes) {
  return made(mClip[hasMembranes], "model/clip.comp", focusDefines(hasMembranes, false));
}
const gpu::Program& InstancePrograms::focus(bool hasMembranes, bool isOfOccluders) {
  return made(mFocus[{hasMembranes, isOfOccluders}], "model/focus.comp", focusDefines(hasMembranes, isOfOccluders));
}
const gpu::Program& InstancePrograms::flood() { return made(mFlood, "model/flood.comp"); }
const gpu::Program& InstancePrograms::shown() { return made(mShown, "model/shown.comp"); }
const gpu::Program& InstancePrograms::splat(DrawOf of, bool isLarge) {
  return made(mSplat[{of, isLarge}], "model/splat.comp", splatDefines(of, isLarge));
}
const gpu::Program& InstancePrograms::arguments() { return made(mArguments, "model/arguments.comp"); }
const gpu::Program& InstancePrograms::pyramid() { return made(mPyramid, "model/pyramid.comp"); }
const gpu::Program& InstancePrograms::seen() { return made(mSeen, "model/seen.comp"); }

bool InstancePrograms::compile(const Need& need) {
  std::vector<const gpu::Program*> needed{&bundles(ListOf::Copies),
                                          &bundles(ListOf::Bundles),
                                          &cull(need.by, true),
                                          &cull(need.by, false),
                                          &cull(CullBy::Nearest, true),
                                          &splat(DrawOf::Molecules, false),
                                          &splat(DrawOf::Molecules, true),
                                          &arguments(),
                                          &pyramid(),
                                          &seen()};
  if (need.by == CullBy::States) needed.insert(needed.end(), {&clip(need.hasMembranes), &shown()});
  if (need.hasFocus)
    needed.insert(needed.end(), {&focus(need.hasMembranes, false), &focus(need.hasMembranes, true), &flood()});
  if (need.hasGhosts) needed.insert(needed.end(), {&cull(CullBy::Ghosts, true), &cull(CullBy::Ghosts, false)});
  if (need.isCrowd) {
    DrawOf of = need.hasMembranes ? DrawOf::WholesWithMembranes : DrawOf::Wholes;
    needed.insert(needed.end(), {&bundles(ListOf::Blocks), &cullWholes(true), &cullWholes(false), &splat(of, false),
                                 &splat(of, true)});
  }
  return std::all_of(needed.begin(), needed.end(), [](const gpu::Program* program) { return program->isReady(); });
}

std::vector<gpu::ProgramSource> allPrograms() {
  std::vector<gpu::ProgramSource> all;
  for (const char* name : {"arguments", "pyramid", "seen", "flood", "shown"})
    all.push_back({{std::string("model/") + name + ".comp"}, {}});
  for (CullBy by : {CullBy::Cuts, CullBy::Membranes, CullBy::States, CullBy::Ghosts})
    for (bool isOfWords : {false, true}) all.push_back({{"model/cull.comp"}, cullDefines(by, isOfWords)});
  all.push_back({{"model/cull.comp"}, cullDefines(CullBy::Nearest, true)});
  for (bool isOfWords : {false, true}) all.push_back({{"model/cull.comp"}, wholeDefines(isOfWords)});
  for (ListOf of : {ListOf::Bundles, ListOf::Copies, ListOf::Blocks})
    all.push_back({{"model/bundles.comp"}, listDefines(of)});
  for (bool hasMembranes : {false, true}) {
    all.push_back({{"model/clip.comp"}, focusDefines(hasMembranes, false)});
    for (bool isOfOccluders : {false, true})
      all.push_back({{"model/focus.comp"}, focusDefines(hasMembranes, isOfOccluders)});
  }
  for (DrawOf of : {DrawOf::Molecules, DrawOf::Wholes, DrawOf::WholesWithMembranes})
    for (bool isLarge : {false, true}) all.push_back({{"model/splat.comp"}, splatDefines(of, isLarge)});
  return all;
}

}  // namespace velum::model
