#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Fields.h"
#include "core/Image.h"
#include "core/Shared.h"
#include "scene/Source.h"

namespace velum::scene {

/// What is behind a finished picture.
enum class Paper { None, Smooth, Rough, Laid, Canvas, Linen, Parchment, Own };

/// A picture of a sphere that says how material looks from each side (lit sphere, matcap), of the user's own.
struct LitSphere {
  std::string name;  ///< by which structures refer to it
  Source source;
  Shared<Image> data;  ///< not saved: read from `source`
  bool operator==(const LitSphere&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("name", o.name, FieldInfo{"", {}, "Name by which structures and the finish know it."});
    visit("source", o.source, FieldInfo{"", {}, "Picture of a lit sphere that fills it to its edges."});
  }
};

/// A picture of paper or cloth, of the user's own; it lies side by side until it fills the background.
struct OwnPaper {
  Source source;
  Shared<Image> data;  ///< not saved: read from `source`
  bool operator==(const OwnPaper&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("source", o.source, FieldInfo{"", {}, "Picture of paper or cloth."});
  }
};

/// What an illustrator adds to a picture at the end ([ACS] 4.4): contours, lit spheres, hatching, paper. Each part is
/// off where it is 0.
struct Finish {
  double contours = 0.0;             ///< strength, 0..1
  double contourWidth = 2.4;         ///< pixels of a picture of 1000 rows
  glm::vec3 contourColor{0.05f};     ///< sRGB
  double contourCreases = 0.6;       ///< how much of it where the surface turns, 0..1
  double contourSteps = 1.0;         ///< where the depth jumps, 0..1
  double contourStructures = 1.0;    ///< between structures, 0..1
  double litSphere = 0.0;            ///< share of the lit spheres' colour; the paper has 0.5
  std::string sphere = "porcelain";  ///< lit sphere of all that names none: one of ours, or of `spheres`
  bool structureSpheres = true;      ///< structures have the spheres that they name; off: all have `sphere`
  double hatching = 0.0;             ///< strokes along the curvature, strength, 0..1
  double hatchWidth = 5.0;           ///< from stroke to stroke, pixels of a picture of 1000 rows
  Paper paper = Paper::None;
  glm::vec3 paperColor{0.96f, 0.94f, 0.89f};  ///< sRGB
  double paperGrain = 0.5;         ///< how much of the grain shows, 0..1; at 0.5 an own paper is as its picture
  double paperScale = 1.0;         ///< scale of the grain, or of the user's picture
  OwnPaper ownPaper;               ///< the picture for Paper::Own
  std::vector<LitSphere> spheres;  ///< the user's own
  bool operator==(const Finish&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("contours", o.contours, FieldInfo{"", {0, 1}, "Strength of the contours; 0: none."});
    visit("contourWidth", o.contourWidth, FieldInfo{"pixel", {0.5, 10}, "Their width in a picture of 1000 rows."});
    visit("contourColor", o.contourColor, FieldInfo{"", {0, 1}, "Their sRGB colour."});
    visit("contourCreases", o.contourCreases, FieldInfo{"", {0, 1}, "How much of them where the surface turns."});
    visit("contourSteps", o.contourSteps, FieldInfo{"", {0, 1}, "How much of them where the depth jumps."});
    visit("contourStructures", o.contourStructures, FieldInfo{"", {0, 1}, "How much of them between structures."});
    visit("litSphere", o.litSphere, FieldInfo{"", {0, 1}, "Share of the lit spheres' colour in the picture; 0: none."});
    visit("sphere", o.sphere, FieldInfo{"", {}, "Lit sphere of all that names none of its own."});
    visit("structureSpheres", o.structureSpheres,
          FieldInfo{"", {}, "Off: structures have that sphere, too, whatever they name."});
    visit("hatching", o.hatching, FieldInfo{"", {0, 1}, "Strength of strokes along the curvature; 0: none."});
    visit("hatchWidth", o.hatchWidth, FieldInfo{"pixel", {2, 30}, "From stroke to stroke in a picture of 1000 rows."});
    visit("paper", o.paper, FieldInfo{"", {}, "What is behind the picture; none: the background."});
    visit("paperColor", o.paperColor, FieldInfo{"", {0, 1}, "Its sRGB colour."});
    visit("paperGrain", o.paperGrain, FieldInfo{"", {0, 1}, "How much of its grain shows; 0.5: a picture as it is."});
    visit("paperScale", o.paperScale,
          FieldInfo{"", {0.1, 10}, "How large its grain is; 1: a pixel of an own picture is one of 1000 rows."});
    visit("ownPaper", o.ownPaper, FieldInfo{"", {}, "The user's own picture, of the paper `own`.", true});
    visit("spheres", o.spheres, FieldInfo{"", {}, "Lit spheres of the user's own."});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Paper> {
  static constexpr std::string_view kNames[] = {"none",   "smooth", "rough",     "laid",
                                                "canvas", "linen",  "parchment", "own"};
};
