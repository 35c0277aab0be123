#pragma once
#include <string>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The labels have the shapes that the scene's structures say; settleShapes() has nothing to do.
bool shapesFit(const scene::Scene& scene);

/// Makes the labels fit what the scene's structures say of smoothing: the shapes of the file, or smoothed ones. What
/// was grown is to be grown on them anew: settleGrowths(). Nothing where they fit already.
/// @throw Cancelled. Any thread. As smoothLabels().
void settleShapes(scene::Scene& scene, Progress& progress);

/// Takes the shapes and their smoothing that settleShapes() gave a copy of a scene, unless it has other labels by now.
/// @param before  what the copy was made of @return false where it has
bool takeShapes(scene::Scene& now, const scene::LabelLayer& before, const scene::LabelLayer& settled);

/// True of a structure that the file has, so that it can be smoothed: those that were grown follow the volume's values.
bool isOfFile(const scene::LabelLayer& labels, int id);

/// What to tell of structures that open smoothed, as they are made of blocks; empty where none do.
std::string sayBlocks(const scene::Scene& scene);

/// Standard deviation up to which the shapes of a scene can be smoothed, a length; 0 without labels.
double widestSmoothing(const scene::Scene& scene);

}  // namespace velum::session
