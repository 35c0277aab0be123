#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "velum/core/Task.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// What is written of structures, and how.
struct StructureExport {
  std::vector<int> structures;  ///< ids; empty: all that have voxels
  double smoothness = 0.5;      ///< of surfaces, 0 as voxels lie .. 1
  bool apart = false;           ///< a file of its own for each: NAME-aorta.stl
};

/// A format that structures are exported in.
struct ExportKind {
  std::string name, extension;  ///< "glTF", ".glb"
  bool isSurface = false;       ///< else a label volume
};
/// Surfaces first, each with its usual extension. For file dialogs and `--help`.
std::vector<ExportKind> exportKinds();
/// The extension is one of surfaces.
bool isSurfaceFile(const std::filesystem::path& path);

/// Writes structures with names and colours of the labels' table, by extension: surfaces as .stl, .ply, .glb, .obj or
/// .vtp, a label volume as .seg.nrrd, .nrrd, .nii(.gz) or .dcm. They are whole: cuts take nothing from them.
/// @return what the format could not hold, one line each, for people
/// @throw ArgumentError where a structure has no voxels; InputError as io::writeMeshes, io::writeLabels; Cancelled. Any
/// thread.
std::vector<std::string> exportStructures(const LabelVolume& labels, const std::filesystem::path& path,
                                          const StructureExport& what, Progress& progress);

/// The labels of a scene, with its names and colours. @throw ArgumentError where there are none
LabelVolume labelsOf(const scene::Scene& scene);

/// Ids by names or numbers. @throw ArgumentError for one that the table does not have
std::vector<int> findStructures(const std::vector<LabelInfo>& table, const std::vector<std::string>& words);

}  // namespace velum::session
