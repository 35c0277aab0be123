#pragma once
#include "core/Image.h"
#include "render/section/SectionImage.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What a section shows, as a picture with the channels "id", "instance" (0; -1 where there is nothing but the
/// ground, or what is as dark as the ground) and "position.X/Y/Z" (world): what seenNames() and FilmNames look at.
/// Structures count where they are shown and no shown cut removes them.
/// @param plane  of the section  @param ground  colour beyond the data  Any thread.
Image seenOfSection(const render::SectionImage& section, const scene::SectionPlane& plane, glm::vec3 ground);

}  // namespace velum::session
