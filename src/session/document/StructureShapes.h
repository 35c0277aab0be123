#pragma once
#include <string>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// True when the labels have the shapes that the scene's structures ask for, so that settleShapes() has nothing to do.
bool shapesFit(const scene::Scene& scene);

/// Makes the labels fit what the scene's structures say of smoothing: the shapes of the file, or smoothed shapes.
/// Structures that were grown must then be grown anew on these labels: settleGrowths(). Does nothing where the labels
/// fit already.
/// @throw Cancelled. Any thread. As smoothLabels().
void settleShapes(scene::Scene& scene, Progress& progress);

/// Takes over the shapes, and their smoothing, that settleShapes() gave to a copy of a scene, unless the scene has
/// other labels by now.
/// @param before  the labels of which the copy was made  @param settled  the labels of the copy  @return false where
/// the scene has other labels
bool takeShapes(scene::Scene& now, const scene::LabelLayer& before, const scene::LabelLayer& settled);

/// True of a structure that the labels' file has, so that it can be smoothed: structures that were grown follow the
/// volume's values.
bool isOfFile(const scene::LabelLayer& labels, int id);

/// What to tell the user of structures that are opened smoothed because they are made of blocks; empty where there are
/// none.
std::string sayBlocks(const scene::Scene& scene);

/// The largest standard deviation by which the shapes of a scene can be smoothed, scene units; 0 without labels.
double widestSmoothing(const scene::Scene& scene);

}  // namespace velum::session
