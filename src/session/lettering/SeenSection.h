#pragma once
#include <cstdint>
#include <vector>

#include "core/Image.h"
#include "render/section/SectionImage.h"
#include "scene/SceneFwd.h"
#include "session/lettering/NamesToPlace.h"

namespace velum::session {

/// What a section shows, as a picture with the channels "id", "instance" (0; -1 where there is nothing but the
/// ground, or what is as dark as the ground) and "position.X/Y/Z" (world): what seenNames() and FilmNames look at.
/// Structures count where they are shown and no shown cut removes them.
/// @param plane  of the section  @param ground  colour beyond the data  Any thread.
Image seenOfSection(const render::SectionImage& section, const scene::SectionPlane& plane, glm::vec3 ground);

/// The map that seenNames() makes of that picture, without the picture: milliseconds for a large section. Any thread.
class SectionMap {
 public:
  SectionMap(const render::SectionImage& section, glm::vec3 ground);
  SectionMap(const SectionMap&) = delete;
  SectionMap& operator=(const SectionMap&) = delete;
  const SeenMap& map() const { return mMap; }

 private:
  std::vector<std::int32_t> mStructures;
  SeenMap mMap;
};

}  // namespace velum::session
