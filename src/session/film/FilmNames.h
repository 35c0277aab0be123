#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "scene/Scene.h"
#include "scene/timeline/SceneAt.h"
#include "session/lettering/Lettering.h"

namespace velum::session {

/// Where names stand in the frames of a film. They find their places once a second, at key frames, each as a still
/// picture whose names know those of the three key frames before; between two key frames they go from the places of
/// the one to those of the other. So nothing jumps, and a frame still depends on the film and its number alone: to draw
/// one, at most five small pictures are looked at, whatever was drawn before.
class FilmNames {
 public:
  /// A small picture of a frame, with the channels of an ImageMap, "Z" where needsSeenPlaces(), and "position" (of a
  /// section as seenOfSection() makes it), and the scene that it shows.
  struct Look {
    Image image;
    scene::Scene scene;
  };
  using LookAt = std::function<Look(int frame, Progress& progress)>;
  /// @param size  of the film's pictures, pixels  @param step  how many of their pixels, along x and y, are one of a
  /// small picture  @param section  that the film shows; none: the 3D picture  @param lookAt  called with frames that
  /// mostly grow
  FilmNames(const scene::FilmFrames& frames, glm::ivec2 size, int step, std::optional<scene::SectionKind> section,
            LookAt lookAt);

  /// What a frame's lettering is to know of its names. @param scene  of the frame  @param share  see Film::at()
  /// @throw Cancelled, and what `lookAt` throws
  NamesBetween at(int frame, double share, const scene::Scene& scene, Progress& progress);

 private:
  /// What a key frame shows, and where its names stand.
  struct Key {
    SeenNames seen;
    std::map<int, glm::dvec3> anchors;  ///< by the names' keys: places in the world
    std::vector<NamePlace> places;
  };
  const Look& look(int key, Progress& progress);
  Key keyAfter(int key, const Key* before, Progress& progress);
  const Key& keyOf(int key, Progress& progress);
  int frameOf(int key) const;
  std::vector<NamePlace> placesIn(const scene::Scene& scene, const Seen& seen) const;

  scene::FilmFrames mFrames;
  glm::ivec2 mSize;
  int mStep, mPeriod;
  std::optional<scene::SectionKind> mSection;
  LookAt mLookAt;
  std::map<int, Look> mLooks;  ///< of the key frames that were looked at last
  std::map<int, Key> mKeys;
};

}  // namespace velum::session
