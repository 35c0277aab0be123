#pragma once
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Scene.h"

/// Puts data that is in memory into a scene, with all that data brings with it: unit, first look, structures.
namespace velum::session {

/// Warns of each line on stderr. @param name  what the lines are of
void warnAll(const std::string& name, const std::vector<std::string>& warnings);
/// What the first data of a scene are in the scene is in, too.
void adoptUnit(scene::Scene& scene, LengthUnit unit);

/// Data of a scene file, which knows how they look.
void putVolume(scene::Scene& scene, Volume volume);
void putLabels(scene::Scene& scene, LabelVolume labels, Progress& progress);
/// Labels that were open before the scan that they are of, and have no place of their own, go where it is.
void placeLabels(scene::Scene& scene, Progress& progress);

/// Data that nobody has looked at yet, and that get the look that fits them; labels take the place of those that are
/// there. Any thread. @param source  where the data is from; without a path it is in no file, and no scene file names
/// it
/// @throw Cancelled
void takeVolume(scene::Scene& scene, const scene::Source& source, Volume volume, Progress& progress);
void takeLabels(scene::Scene& scene, const scene::Source& source, LabelVolume labels, Progress& progress);
/// A scene of a volume that is in no file. Any thread. @throw Cancelled
scene::Scene sceneOf(const Shared<Volume>& volume, Progress& progress);
/// Places camera and sections where they show all of the data.
void seeAll(scene::Scene& scene);

}  // namespace velum::session
