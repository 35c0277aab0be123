#pragma once
#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/Caption.h"
#include "session/lettering/Block.h"
#include "session/lettering/FreePlaces.h"
#include "session/lettering/Lettering.h"
#include "session/lettering/Letters.h"
#include "session/lettering/TimeStamp.h"

namespace velum::session {

/// Lays out one part after the other, so that none covers another.
class LetteringLayout {
 public:
  /// @param ground  before which all stands; none: the paper or background of the scene
  LetteringLayout(const scene::Scene& scene, glm::ivec2 size, std::optional<glm::vec3> ground = std::nullopt);

  void addLegend(const std::vector<LegendEntry>& entries);
  void addScaleBar(const ScaleBar& bar);
  void addTimeStamp(const TimeStamp& stamp);
  void addCaptions();
  std::vector<Mark> marks() && { return std::move(mMarks); }

 private:
  /// Pixels. @param size  of the letters, in those of the scene's lettering
  double emOf(double size) const;
  /// The top left corner of a part, and takes its room. @param room  of the part, pixels  @param em  of its letters
  std::optional<glm::dvec2> place(scene::CaptionPlace place, glm::dvec2 room, double em);
  void finish(const Block& block, scene::CaptionPlace place);
  glm::vec3 ground(scene::CaptionPlace place) const;
  void addLegendRows(const std::vector<LegendEntry>& entries, const std::vector<std::string>& names, glm::dvec2 at,
                     glm::dvec2 size);
  void addCaptionsAt(scene::CaptionPlace place, const std::vector<const scene::Caption*>& captions);
  struct LaidCaption;
  static glm::dvec2 stack(std::deque<LaidCaption>& captions, double share, double gap);
  void addCaption(const LaidCaption& laid, glm::dvec2 at);

  const scene::Scene& mScene;
  glm::dvec2 mSize;
  std::optional<glm::vec3> mGround;
  Letters mLetters;
  FreePlaces mPlaces;
  std::vector<Mark> mMarks;
};

}  // namespace velum::session
