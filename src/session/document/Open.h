#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/Scene.h"
#include "session/document/Sources.h"

namespace velum::session {

/// Makes a scene from whatever a user names: a scene file, a picture of ours with a scene inside, a volume, a folder, a
/// surface, labels. Data is read; a new volume gets the preset that fits it and a camera that sees all of it.
/// @param source  first input: path and how to read it
/// @param policy  of a scene file: what to do about data that has moved
/// @param notes   takes what the user should know, one line each; null: these lines go to stderr as warnings
/// @throw InputError, Cancelled. Any thread.
scene::Scene open(const scene::Source& source, Progress& progress, const DataPolicy& policy = {},
                  std::vector<std::string>* notes = nullptr);

/// The scene in a scene file or in a picture of ours, as text without its data; nothing for other files.
/// @throw InputError when it is damaged
std::optional<std::string> readSceneText(const std::filesystem::path& path);

/// Adds another input to a scene: a model, labels beside the volume, a surface, or, where the scene has no volume yet,
/// a volume.
/// @param notes, policy  as of open()
void add(scene::Scene& scene, const scene::Source& source, Progress& progress,
         std::vector<std::string>* notes = nullptr, const DataPolicy& policy = {});

/// Reads a file as labels, whatever it looks like, and puts them beside the scene's volume.
/// @throw InputError, Cancelled
void addLabels(scene::Scene& scene, const scene::Source& source, Progress& progress);

/// What several inputs gave.
struct Opened {
  scene::Scene scene;
  std::string path;  ///< the first input that opened, by which the scene is called
};

/// Opens several inputs as one scene: the input that carries the voxels first, then labels and surfaces, in whatever
/// order they were named. An input that cannot be read is noted, and the others open, unless the policy refuses that.
/// @throw ArgumentError when there is no input; InputError when none can be read; Cancelled
Opened openAll(std::vector<scene::Source> sources, Progress& progress, const DataPolicy& policy = {},
               std::vector<std::string>* notes = nullptr);
/// A source whose path leads into a store, as the list of what it holds shows it (a.ozx/labels/nuclei), by store and
/// image; all others as they are. Any thread.
scene::Source foundInStore(scene::Source source);
/// Sources for files and folders that say themselves how they are to be read.
std::vector<scene::Source> sourcesOf(const std::vector<std::string>& paths);

/// Adds several inputs to a scene as openAll() does. @throw InputError when none can be read; Cancelled
void addAll(scene::Scene& scene, const std::vector<std::string>& paths, Progress& progress,
            std::vector<std::string>* notes = nullptr, const DataPolicy& policy = {});

/// Reads the data that the scene names and does not hold yet. Paths are taken relative to `folder`; a file that is not
/// there is looked for; a file that is not found is an error, or is left out (missingData() then names it), as the
/// policy says.
void loadData(scene::Scene& scene, const std::filesystem::path& folder, Progress& progress,
              const DataPolicy& policy = {}, std::vector<std::string>* notes = nullptr);

/// Writes a scene file: to a temporary beside it, synced, then renamed. Paths become relative to the file's folder,
/// except where nothing but the root is common to both.
/// @throw InputError when the disk refuses
void saveScene(const scene::Scene& scene, const std::filesystem::path& path);

/// The scene's text as it is put inside a picture that is written to `path`.
std::string sceneTextFor(const scene::Scene& scene, const std::filesystem::path& path);

/// The phantoms that openSample() makes.
std::vector<std::string> sampleNames();

/// Writes a phantom and its labels into a folder and opens both, so that the scene can be saved like any other.
/// @param name  two-spheres, vessels, torso, seismic, neurons, fibres, ultrasound
/// @param size  voxels along the longest axis, 16..1024; 0: the phantom's own
/// @throw ArgumentError for an unknown name or size; InputError when the disk refuses; Cancelled
scene::Scene openSample(const std::string& name, int size, const std::filesystem::path& folder, Progress& progress);

}  // namespace velum::session
