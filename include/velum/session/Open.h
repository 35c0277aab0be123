#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "velum/core/Task.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// Makes a scene from whatever a user names: a scene file, a picture of ours with a scene inside, a volume, a folder, a
/// surface, labels. Data is read; a new volume gets the preset that fits it and a camera that sees it all.
/// @param source  first input: path and how to read it
/// @throw InputError, Cancelled. Any thread.
scene::Scene open(const scene::Source& source, Progress& progress);

/// Adds another input to a scene: labels beside the volume, a surface, or, where the scene has no volume yet, a volume.
void add(scene::Scene& scene, const scene::Source& source, Progress& progress);

/// Reads the data that the scene names and does not hold yet. Paths are taken relative to `folder`.
void loadData(scene::Scene& scene, const std::filesystem::path& folder, Progress& progress);

/// Writes a scene file: to a temporary beside it, synced, then renamed. Paths become relative to the file's folder.
/// @throw InputError when the disk refuses
void saveScene(const scene::Scene& scene, const std::filesystem::path& path);

/// The scene's text as it rides in a picture that is written to `path`.
std::string sceneTextFor(const scene::Scene& scene, const std::filesystem::path& path);

}  // namespace velum::session
