#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"
#include "session/lettering/Legend.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

/// What shares a name in a legend or beside a picture.
struct NameGroup {
  std::string name;
  std::uint64_t pixels = 0;             ///< that show its types
  TypeNumbers types;                    ///< of the model
  std::vector<std::size_t> structures;  ///< places in the scene's list of structures
};

std::uint64_t pixelsOf(const TypePixels& pixels, std::uint32_t type);
/// True of what is worth a name by how much of a picture shows it. @param all  pixels of the picture
bool isMoreThanDot(std::uint64_t pixels, double all);

/// What entries of a list (scene::Lettering) stand for, in their order; nothing of layers that are not shown.
std::vector<NameGroup> listedGroups(const scene::Scene& scene, const std::vector<std::string>& entries,
                                    const TypePixels& pixels);
/// Types of which a picture shows more than a dot, that which it shows most first.
std::vector<NameGroup> seenTypeGroups(const scene::Scene& scene, const TypePixels& pixels);
/// Adds the structures that are shown and have a name, in the order of their list.
void addShownStructures(std::vector<NameGroup>& groups, const scene::Scene& scene);

}  // namespace velum::session
