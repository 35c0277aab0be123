#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/Renderer.h"
#include "scene/Scene.h"
#include "session/ViewSpace.h"

/// What hands do to marks: how marks stand in a view, what of them can be taken hold of, and what a drag makes of them.
/// Pixels are those of the view.
namespace velum::session {

/// A mark is drawn at the time step that is shown.
bool isShown(const scene::Scene& scene, const scene::Mark& mark);
/// How much of a mark a view shows, 0..1: in the 3D picture all of it; on a section as its nearest part is near the
/// section's plane: all within half a step, nothing from one step and a half on.
/// @param step  length of the smallest voxel edge, see scene::sectionStep()
double markShare(const ViewSpace& view, const scene::Mark& mark, double step);
/// The same of one of its points.
double pointShare(const ViewSpace& view, const scene::Mark& mark, std::size_t point, double step);

/// The lines of a mark in a view; each a polyline. Of a line that goes through a section only what marks are seen of
/// there, see markShare(). None for kinds without lines.
std::vector<std::vector<glm::dvec2>> markLines(const ViewSpace& view, const scene::Mark& mark, double step);
/// True where a mark of lines does not lie in a section that it meets, but goes through it.
bool goesThrough(const ViewSpace& view, const scene::Mark& mark, double step);
/// Where words stand in a view, as its lettering has laid them out.
struct PlacedWords {
  int mark = 0;                    ///< id of their mark; 0: they are a name that has found its place by itself
  int structure = 0;               ///< of such a name: what it is of, as Mark has it
  std::string type;                ///< the same
  glm::dvec2 low{0.0}, high{0.0};  ///< of the box around them
  glm::dvec2 at{0.0};              ///< the place that they belong to
  bool operator==(const PlacedWords&) const = default;
};

/// Places on a circle that has a normal, once around, the first again at the end. World.
std::vector<glm::dvec3> circlePlaces(const scene::Mark& mark);

/// A part of a mark that can be taken hold of.
enum class MarkPart { None, Point, Words, Line };
struct MarkGrip {
  MarkPart part = MarkPart::None;
  int mark = 0;           ///< its id
  std::size_t point = 0;  ///< number of the point
  bool operator==(const MarkGrip&) const = default;
};
/// What of the scene's marks is within reach of a pixel: points before words before lines, and those of the selected
/// mark first.
struct MarkReach {
  double reach = 9.0;  ///< pixels
  double step = 1.0;   ///< see markShare()
  int selected = 0;    ///< id of a mark; 0: none
  std::span<const PlacedWords> words;
};
MarkGrip markAt(const scene::Scene& scene, const ViewSpace& view, glm::dvec2 pixel, const MarkReach& reach);

/// A mark after one of its points was dragged to a place of the world. A circle goes with its middle; the point of a
/// box keeps its depth on a section, so that a box keeps its thickness there.
/// @param instance  of the model, whose middle the place is: the point follows it; -1: it follows nothing from now on
scene::Mark withPointAt(scene::Mark mark, std::size_t point, glm::dvec3 place, const ViewSpace& view,
                        int instance = -1);
/// A mark after its words were dragged by so many pixels. @param from  where they stood before
scene::Mark withWordsBy(scene::Mark mark, const PlacedWords& from, glm::dvec2 pixels, const ViewSpace& view);
/// The mark that a name becomes which was taken hold of; it has no id yet.
scene::Mark markOfName(const PlacedWords& name);

/// A place that is aimed at, and the instance of the model whose middle it is; -1: of none.
struct MarkAim {
  glm::dvec3 place{0.0};
  int instance = -1;
};
/// What a hand aims at that points at something in the 3D picture: the middle of the instance that is seen, where the
/// pixel is near it, else the place itself. On a section always the place. @param pick  what is seen there
MarkAim aimOf(const scene::Scene& scene, const ViewSpace& view, glm::dvec2 pixel, glm::dvec3 place,
              const render::Pick* pick);

/// What clicks make: a mark of a kind with these points. On a section a circle is flat, and a box one step thick.
scene::Mark markOfClicks(scene::MarkKind kind, std::vector<glm::dvec3> points, const ViewSpace& view, double step);

const scene::Mark* findMark(const scene::Scene& scene, int id);
scene::Mark* findMark(scene::Scene& scene, int id);

}  // namespace velum::session
