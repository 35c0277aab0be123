#pragma once
#include "RenderFixture.h"

/// Pictures of a solid block that is cut, against what is kept of it along each ray.
namespace velum {

inline constexpr glm::ivec3 kDims(40, 36, 44);

class CutPictures : public RenderTest {
 protected:
  static scene::Scene solidScene(double turnRad = 0.3) {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }, centredFrame(kDims, {1, 1.1, 0.9}, turnRad)));
    makeSolid(scene);
    return scene;
  }

  /// A pixel shows something exactly where something is kept, and never at a removed position.
  /// @param keptLength  (ray, stretch): millimetres of the stretch that no cut removes
  /// @param distance  (position): to the nearest that is removed, less than 0 inside; may err by `rounding`
  /// @return pixels that show something for certain
  template <class KeptLength, class Distance>
  int expectShowsWhatIsKept(const scene::Scene& scene, glm::ivec2 size, KeptLength keptLength, Distance distance,
                            float rounding, const std::string& what) {
    Image image = draw(scene, size, kAllLayers);
    int doubtful = 0, wrong = 0, shown = 0;
    for (int y = 0; y < size.y && wrong < 3; ++y)
      for (int x = 0; x < size.x && wrong < 3; ++x) {
        // Rays a hundredth of a pixel beside tell where rounding may decide.
        double least = 1e9, most = 0;
        for (int k = 0; k < 5; ++k) {
          glm::dvec2 shift(k == 1 ? 0.01 : k == 2 ? -0.01 : 0.0, k == 3 ? 0.01 : k == 4 ? -0.01 : 0.0);
          TestRay ray = rayThrough(scene.camera, size, glm::dvec2(x + 0.5, y + 0.5) + shift);
          glm::dvec2 box = boxInterval(*scene.volume.data, ray);
          double length = box.x < box.y ? keptLength(ray, box) : 0.0;
          least = std::min(least, length), most = std::max(most, length);
        }
        float alpha = sampleOf(image, {x, y}, "A");
        std::string where = what + ", pixel " + std::to_string(x) + ", " + std::to_string(y) + ", kept " +
                            std::to_string(most) + " mm, alpha " + std::to_string(alpha);
        if (most == 0.0) {
          EXPECT_EQ(alpha, 0.0f) << where << ": shown, but everything is cut away";
          wrong += alpha != 0.0f;
        } else if (least > 0.05) {
          EXPECT_GT(alpha, 0.9f) << where << ": empty, but something is kept";
          wrong += alpha <= 0.9f;
          ++shown;
        } else {
          ++doubtful;
        }
        if (alpha == 0.0f) continue;
        float inside = distance(vectorOf(image, {x, y}, "position"));
        EXPECT_GE(inside, -rounding) << where << ": the position lies in what is removed";
        wrong += inside < -rounding;
      }
    EXPECT_LT(doubtful, size.x * size.y / 12) << what << ": the test has decided too little";
    return shown;
  }
};

}  // namespace velum
