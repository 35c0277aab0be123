#pragma once
#include <optional>
#include <string>

#include "io/labels/ReadLabels.h"
#include "scene/SceneFwd.h"

/// Where labels lie beside the scan that they are of.
namespace velum::session {

/// What to say where the scene's labels are not where its scan is: less than a twentieth of the labelled voxels lies in
/// the scan, or all of them lie in a few of the scan's voxels. Empty where labels and scan fit, and where one of them
/// is missing. Looks at some hundred thousand voxels: milliseconds.
std::string misplacedLabels(const scene::Scene& scene);

/// The grid that labels without a place of their own take; nothing where there is no volume.
std::optional<io::LabelGrid> gridOfScan(const scene::Scene& scene);

/// Reads the labels that the scene names, onto the grid of its scan where they have no place of their own, with the ids
/// that its structures have. @throw InputError, Cancelled
LabelVolume readLabelsOf(const scene::Scene& scene, Progress& progress);

}  // namespace velum::session
