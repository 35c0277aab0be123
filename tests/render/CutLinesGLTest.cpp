// The cut lines of plates, against the outlines of faces by formulas.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cutBall.h"
#include "session/plate/Plate.h"

namespace velum {
namespace {

constexpr glm::ivec2 kPlateSize(200, 200);

class CutLinesGL : public CutPictures {
 protected:
  /// Places along the cut lines of a plate, pixels. @param name  of the cut that the shapes are to be named by
  static std::vector<glm::dvec2> tracedAlong(const scene::Scene& scene, const std::string& name) {
    Progress progress;
    vector::Drawing plate =
        session::drawPlate(renderer(), scene, {kPlateSize, 1, false, false, 0}, context().limits(), progress);
    std::vector<glm::dvec2> places;
    for (const vector::Layer& layer : plate.layers) {
      if (layer.name != "cut lines") continue;
      for (const vector::Item& item : layer.items) {
        const auto& shape = std::get<vector::Shape>(item);
        EXPECT_EQ(shape.name, name);
        for (const vector::Outline& outline : shape.outlines) addPlaces(outline, places);
      }
    }
    return places;
  }
  static void addPlaces(const vector::Outline& outline, std::vector<glm::dvec2>& places) {
    EXPECT_TRUE(outline.isClosed);
    glm::dvec2 from = outline.start;
    for (const vector::Curve& curve : outline.curves) {
      int count = int(std::ceil(2.0 * glm::distance(from, curve.end))) + 1;
      for (int i = 0; i < count; ++i) {
        double t = double(i) / count, s = 1.0 - t;
        places.push_back(s * s * s * from + 3.0 * s * s * t * curve.control1 + 3.0 * s * t * t * curve.control2 +
                         t * t * t * curve.end);
      }
      from = curve.end;
    }
  }
};

TEST_F(CutLinesGL, GoAlongTheOutlinesOfFacesWithinHalfAPixel) {
  scene::Cut plane, dome = membraneOf(domeSheet({64, 64}, {40, 40, 20}), {0.3, -1, 0.2}, {40, 40, 20});
  plane.shape = scene::CutShape::Plane;
  plane.centre = {1, -3, 2};
  plane.axis = {0.3, -1, 0.2};
  plane.name = "plane";
  dome.name = "dome";
  dome.membrane->cloth.particles = {64, 64};
  for (const scene::Cut& cut : {plane, dome}) {
    scene::Scene scene = ballScene(false, true);
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    scene.cuts = {cut};
    scene.finish.contours = 1.0;
    std::vector<CutFormula> formulas{formulaOf(cut)};
    auto isFace = [&](glm::dvec2 pixel) {
      return faceByFormula(formulas, rayThrough(scene.camera, kPlateSize, pixel)) > 0;
    };
    // How far the outline is from each place of the lines: the smallest circle about it that is not all of one kind.
    std::vector<double> apart;
    for (glm::dvec2 place : tracedAlong(scene, cut.name)) {
      double radius = 0.0;
      for (bool isWithin = true; isWithin && radius < 3.0;) {
        radius += 0.1;
        int of = 0;
        for (int i = 0; i < 12; ++i)
          of += isFace(place + radius * glm::dvec2(std::cos(i * 0.5236), std::sin(i * 0.5236)));
        isWithin = of == 0 || of == 12;
      }
      apart.push_back(radius);
    }
    ASSERT_GT(apart.size(), 300u) << cut.name;
    std::ranges::sort(apart);
    RecordProperty(cut.name + "-median", fmt::format("{:.2f}", apart[apart.size() / 2]));
    EXPECT_LE(apart[apart.size() * 95 / 100], 0.51) << cut.name << ", pixels, of 19 places in 20";
    EXPECT_LE(apart.back(), 0.91) << cut.name << ", pixels";
  }
}

}  // namespace
}  // namespace velum
