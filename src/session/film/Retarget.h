#pragma once
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/Scene.h"

namespace velum::session {

/// Other data for a scene: another patient, another specimen.
struct NewData {
  std::string volume;          ///< path
  std::string labels = {};     ///< path; empty: there are none
  std::string structure = {};  ///< name of a structure that both have, by which places are found again; empty: the box
};

/// The same scene and film of other data. Camera, cuts and all other places, in keys too, go from the box of the one
/// volume to that of the other, share by share, and lengths grow with the boxes' diagonals; with a named structure they
/// go from the middle of the one to the middle of the other, and grow with its size. Structures are found by their
/// names, whatever their numbers. Curves over values go along where both volumes are of one modality, by their first
/// grey windows (CT: unchanged); else the volume gets the preset that fits it. Structures that were grown, surfaces,
/// and marks and tracks of structures that the other labels do not have are left out.
/// @param notes  takes what the user should know, one line each
/// @throw InputError for data that cannot be read; ArgumentError where there is no volume, or no such structure;
/// Cancelled. Any thread.
scene::Scene retargeted(const scene::Scene& scene, const NewData& data, Progress& progress,
                        std::vector<std::string>& notes);

/// Names of the structures that have voxels both in a scene's labels and in those of a file, in the scene's order.
/// @param other  path, read as labels  @throw InputError, Cancelled. Any thread.
std::vector<std::string> sharedStructures(const scene::LabelLayer& labels, const std::string& other,
                                          Progress& progress);

}  // namespace velum::session
