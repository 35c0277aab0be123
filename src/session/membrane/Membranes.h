#pragma once
#include <vector>

#include "core/Mesh.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "membrane/forces/Forces.h"
#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"
#include "session/membrane/MembraneReport.h"

namespace velum::session {

/// What to find out about membranes, beside letting them settle.
struct MembraneQuestions {
  bool kept = false;
  bool limit = false;  ///< takes seconds
};

/// Lets the sheets of all enabled membranes come to rest, and puts their shapes into the scene. Passive sheets start
/// from flat. Active sheets rest where their shape says that they have come to rest, and go on from there where their
/// frame or the time step is another one. The same scene gives the same sheets on one driver, as in a session. Uses the
/// GL context that is current, GL thread; takes seconds on a software driver. @throw Cancelled
std::vector<MembraneReport> settleMembranes(scene::Scene& scene, MembraneQuestions questions, Progress& progress);

/// True when a picture of the scene needs settleMembranes() first.
bool hasMembranes(const scene::Scene& scene);

/// The sheet of a membrane as a surface, world: with the shape that the cut holds, flat when that is empty. Any thread.
Mesh sheetMesh(const scene::Cut& cut);

/// The scene's volume (its current time step) with everything that the cuts remove set to the smallest value of its
/// data, membranes as their shapes are. Any thread. @throw Cancelled, ArgumentError without a volume
Volume clippedVolume(const scene::Scene& scene, Progress& progress);

/// What helps a membrane with these figures, where it keeps little of what it protects. Any thread. @throw Cancelled
std::vector<Advice> adviceFor(const membrane::KeptWhole& figures, const membrane::Potential& potential,
                              const scene::Scene& scene, const scene::Cut& cut, Progress& progress);

/// How much of what a membrane protects its sheet cuts, and how much its rest plane would cut. Any thread.
/// @throw Cancelled
membrane::KeptWhole measureCut(const membrane::Potential& potential, const scene::Cut& cut,
                               const scene::SheetShape& shape, Progress& progress);
/// As measureCut() with the voxels of the forces, and what becomes of all that is protected, by the data in memory. Any
/// thread. @throw InputError when a brick of a streamed volume cannot be read; Cancelled
membrane::KeptWhole measureMembrane(membrane::ForceMaker& maker, const scene::Cut& cut, const scene::SheetShape& shape,
                                    Progress& progress);

/// The least that any sheet in a membrane's frame must cut. Any thread. @throw Cancelled
membrane::KeptWholeLimit limitOf(const membrane::Potential& potential, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
