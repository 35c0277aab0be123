#pragma once
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/Scene.h"
#include "scene/json/Paths.h"

/// The one place where fields of a scene are set by their paths, together with all that must follow from them.
namespace velum::session {

/// Sets fields of a scene, and does what follows from them: see setField() and followFields(). Where one of the fields
/// does not fit, nothing is changed. Any thread. @return what the user should know, one line each
/// @throw ArgumentError for a path or value that does not fit; InputError for data that cannot be read; Cancelled
std::vector<std::string> setFields(scene::Scene& scene, const std::vector<scene::FieldValue>& values,
                                   Progress& progress);

/// Sets a field as scene::setField() does, and nothing that follows from it. A path of a file is taken relative to the
/// current folder, not to the scene's; a file as `finish.paper` is the user's own paper. @throw ArgumentError
void setField(scene::Scene& scene, const std::string& path, const std::string& value);

/// True when a change of fields asks for something to be read or computed, so that followFields() takes long. Any
/// thread.
bool mustFollow(const scene::Scene& after, const scene::Scene& before);

/// Makes what a scene holds fit what its fields say: another source is read (as rereadVolume() where only voxel size or
/// layout differ), a volume loses its table or gets it back, shapes are smoothed, lit spheres and paper are read,
/// tracks of one field become one. Regions that grow are left to settleGrowths(), or to a session. Any thread.
/// @param before  the scene before the change, whose data did fit its fields  @return what the user should know, one
/// line each
/// @throw InputError for data that cannot be read; ArgumentError where a field asks for what cannot be; Cancelled
std::vector<std::string> followFields(scene::Scene& after, const scene::Scene& before, Progress& progress);

}  // namespace velum::session
