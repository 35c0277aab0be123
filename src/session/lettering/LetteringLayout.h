#pragma once
#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/Caption.h"
#include "session/lettering/FreePlaces.h"
#include "session/lettering/Lettering.h"
#include "session/lettering/LetteringBlock.h"
#include "session/lettering/LetteringStyle.h"
#include "session/lettering/TimeStamp.h"
#include "vector/Letters.h"

namespace velum::session {

/// Lays out what stands at the picture's edges, one part after the other, so that none covers another.
class LetteringLayout {
 public:
  /// @param ground  before which all stands; none: the paper or background of the scene
  LetteringLayout(const scene::Scene& scene, glm::ivec2 size, std::optional<glm::vec3> ground = std::nullopt);

  void addLegend(const std::vector<LegendEntry>& entries);
  void addScaleBar(const ScaleBar& bar);
  void addTimeStamp(const TimeStamp& stamp);
  void addCaptions();
  FreePlaces& places() { return mPlaces; }
  std::vector<LetteringBlock> blocks() && { return std::move(mBlocks); }

 private:
  /// The top left corner of a part, and takes its room. @param room  of the part, pixels  @param em  of its letters
  std::optional<glm::dvec2> place(scene::CaptionPlace place, glm::dvec2 room, double em);
  LetteringBlock& add(const char* layer, glm::vec3 ground, double em);
  glm::vec3 ground(scene::CaptionPlace place) const;
  void addLegendRows(const std::vector<LegendEntry>& entries, const std::vector<std::string>& names, glm::dvec2 at);
  void addCaptionsAt(scene::CaptionPlace place, const std::vector<const scene::Caption*>& captions);
  struct LaidCaption;
  static glm::dvec2 stack(std::deque<LaidCaption>& captions, double share, double gap);
  void addCaption(const LaidCaption& laid, glm::dvec2 at);

  const scene::Scene& mScene;
  glm::dvec2 mSize;
  std::optional<glm::vec3> mGround;
  LetteringStyle mStyle;
  vector::Letters mLetters;
  FreePlaces mPlaces;
  std::vector<LetteringBlock> mBlocks;
};

/// A text that letters can be drawn of: no longer than anybody reads, and without what is no letter.
std::string drawable(std::string_view text);

}  // namespace velum::session
