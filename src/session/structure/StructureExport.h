#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Which structures are written, and how.
struct StructureExport {
  std::vector<int> structures;  ///< ids; empty: all structures that have voxels
  double smoothness = 0.0;      ///< of surfaces: 0 as pictures show them, 1 very round
  bool apart = false;           ///< each structure in a file of its own: NAME-aorta.stl
};

/// True for the extensions in which surfaces are written.
bool isSurfaceFile(const std::filesystem::path& path);

/// Writes structures of a scene with the scene's names and colours. The extension says how: surfaces, with the borders
/// that pictures show, as .stl, .ply, .glb, .obj or .vtp; a label volume as .seg.nrrd, .nrrd, .nii(.gz) or .dcm.
/// Structures are written whole: cuts take nothing from them.
/// @return what the format could not hold, one line each, for people
/// @throw ArgumentError where there are no labels or a structure has no voxels; InputError as io::writeMeshes,
/// io::writeLabels; Cancelled. Any thread.
std::vector<std::string> exportStructures(const scene::Scene& scene, const std::filesystem::path& path,
                                          const StructureExport& what, Progress& progress);

/// The labels of a scene, with the scene's names and colours. @throw ArgumentError where there are none
LabelVolume labelsOf(const scene::Scene& scene);

/// The ids of structures that are given by names or numbers. @throw ArgumentError for one that the table does not have
std::vector<int> findStructures(const std::vector<LabelInfo>& table, const std::vector<std::string>& words);

}  // namespace velum::session
