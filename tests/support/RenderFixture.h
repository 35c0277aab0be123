#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "GlFixture.h"
#include "makeVolume.h"
#include "render/RenderPicture.h"

namespace velum {

/// A ray of a picture, world frame, direction unit.
struct TestRay {
  glm::dvec3 origin, direction;
  glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The ray through a pixel, from what Camera.h says; pixel middles at .5. Written anew, in doubles, to check the
/// shaders.
inline TestRay rayThrough(const scene::Camera& camera, glm::ivec2 size, glm::dvec2 pixel) {
  glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  glm::dvec3 up = glm::cross(right, forward);
  bool parallel = camera.projection == scene::Projection::Orthographic;
  double tall = parallel ? camera.height * 0.5 : std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  double wide = tall * size.x / size.y;
  glm::dvec3 across = (2.0 * pixel.x / size.x - 1.0) * wide * right + (1.0 - 2.0 * pixel.y / size.y) * tall * up;
  if (parallel) return {camera.target + across - 1000.0 * forward, forward};
  return {camera.eye, glm::normalize(forward + across)};
}

/// The stretch of a ray inside the box of all voxels, from the eye on; x > y when it misses.
inline glm::dvec2 boxInterval(const Volume& v, const TestRay& ray) {
  glm::dmat4 m = glm::inverse(v.worldFromVoxel);
  glm::dvec3 o(m * glm::dvec4(ray.origin, 1.0)), d(m * glm::dvec4(ray.direction, 0.0));
  glm::dvec2 t(0.0, 1e30);
  for (int i = 0; i < 3; ++i) {
    double low = -0.5, high = v.dims[i] - 0.5;
    if (std::abs(d[i]) < 1e-14) {
      if (o[i] < low || o[i] > high) return {1.0, -1.0};
      continue;
    }
    double a = (low - o[i]) / d[i], b = (high - o[i]) / d[i];
    t = {std::max(t.x, std::min(a, b)), std::min(t.y, std::max(a, b))};
  }
  return t;
}

inline std::size_t channelIndex(const Image& image, std::string_view name) {
  return std::size_t(std::find(image.channels.begin(), image.channels.end(), name) - image.channels.begin());
}
inline float sampleOf(const Image& image, glm::ivec2 pixel, std::string_view channel) {
  std::size_t at = std::size_t(pixel.y) * std::size_t(image.width) + std::size_t(pixel.x);
  return image.pixels.at(at * image.channels.size() + channelIndex(image, channel));
}
inline glm::vec3 vectorOf(const Image& image, glm::ivec2 pixel, std::string_view layer) {
  std::string name(layer);
  return {sampleOf(image, pixel, name + ".X"), sampleOf(image, pixel, name + ".Y"),
          sampleOf(image, pixel, name + ".Z")};
}
inline glm::vec4 colorOf(const Image& image, glm::ivec2 pixel) {
  return {sampleOf(image, pixel, "R"), sampleOf(image, pixel, "G"), sampleOf(image, pixel, "B"),
          sampleOf(image, pixel, "A")};
}

/// How two pictures differ. Premultiplied, so that a pixel that is hardly there hardly counts. 0..255.
struct Difference {
  double largest = 0, mean = 0;
  glm::ivec2 where{0};
};
inline Difference differenceOf(const Image& a, const Image& b) {
  Difference difference;
  if (a.width != b.width || a.height != b.height) return {255, 255, {}};
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      glm::vec4 p = colorOf(a, {x, y}), q = colorOf(b, {x, y});
      p *= glm::vec4(p.a, p.a, p.a, 1.0f), q *= glm::vec4(q.a, q.a, q.a, 1.0f);
      for (int c = 0; c < 4; ++c) {
        double d = 255.0 * std::abs(double(p[c]) - double(q[c]));
        difference.mean += d / (4.0 * a.width * a.height);
        if (d > difference.largest) difference.largest = d, difference.where = {x, y};
      }
    }
  return difference;
}
/// Visits (pixel, its position in the world) what shows, in a picture with the layer of positions. @return how many
template <class Visit>
int eachShown(const Image& image, Visit visit, float leastAlpha = 0.02f) {
  int shown = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      glm::ivec2 pixel(x, y);
      if (sampleOf(image, pixel, "A") < leastAlpha) continue;
      ++shown;
      visit(pixel, vectorOf(image, pixel, "position"));
    }
  return shown;
}
/// Share of pixels that show anything.
inline double coverageOf(const Image& image) {
  double count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += sampleOf(image, {x, y}, "A") > 0.02f;
  return count / (double(image.width) * image.height);
}

/// Draws small pictures of small scenes. All tests of a program share a renderer, whose programs a driver that compiles
/// for the processor takes seconds to make: what it keeps of a picture before changes none, see DependencyGL.
class RenderTest : public GlTest {
 protected:
  static constexpr render::Layers kAllLayers{true, true, true, true, true};

  static render::Renderer& renderer() {
    static auto* one = new render::Renderer(context());  // as long as its context
    return *one;
  }

  /// A volume seen from the front, with plain colours: no light, no jitter, one sample, no background.
  static scene::Scene sceneOf(Volume volume) {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(std::move(volume));
    scene.lighting.shaded = false;
    scene.rayCast.jitter = false;
    scene.rayCast.samplesPerPixel = 1;
    scene.background.transparent = true;
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
    return scene;
  }
  /// Opaque within a fraction of a voxel, whatever the value.
  static void makeSolid(scene::Scene& scene, glm::vec3 color = {0.9f, 0.6f, 0.3f}) {
    scene.volume.transfer.colors = {{0, color}};
    scene.volume.transfer.opacities = {{0, 0.999}, {1, 0.999}};
    scene.volume.transfer.unitDistance = 0.02;
  }
  static void lookAlong(scene::Scene& scene, glm::dvec3 toEye, double distance = 200.0) {
    scene.camera.eye = scene.camera.target + glm::normalize(toEye) * distance;
    scene.camera.up = std::abs(glm::normalize(toEye).z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  }
  static render::Frame frameOf(const scene::Scene& scene, glm::ivec2 size) {
    render::Frame frame;
    frame.scene = scene;
    frame.pictureSize = size;
    return frame;
  }
  Image draw(const scene::Scene& scene, glm::ivec2 size = {96, 96}, const render::Layers& layers = {}) {
    return drawWith(renderer(), scene, size, layers);
  }
  static Image drawWith(render::Renderer& renderer, const scene::Scene& scene, glm::ivec2 size,
                        const render::Layers& layers = {}) {
    Progress progress;
    return render::renderPicture(renderer, frameOf(scene, size), layers, 4096, progress);
  }
  /// Every float of every channel, infinities included; says where the first difference is.
  static void expectIdentical(const Image& a, const Image& b, std::string_view what) {
    ASSERT_EQ(a.channels, b.channels);
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    int shown = 0;
    for (std::size_t i = 0; i < a.pixels.size() && shown < 4; ++i) {
      if (std::bit_cast<std::uint32_t>(a.pixels[i]) == std::bit_cast<std::uint32_t>(b.pixels[i])) continue;
      ++shown;
      std::size_t pixel = i / a.channels.size();
      ADD_FAILURE() << what << ": pixel " << pixel % std::size_t(a.width) << ", " << pixel / std::size_t(a.width)
                    << " channel " << a.channels[i % a.channels.size()] << ": " << a.pixels[i] << " and "
                    << b.pixels[i];
    }
  }
  /// @param largest  0..255, of the largest difference of any channel of any pixel
  static void expectSame(const Image& a, const Image& b, double largest, std::string_view what = {}) {
    Difference difference = differenceOf(a, b);
    // Half a hundredth: pictures are multiples of 1/255 turned into floats.
    EXPECT_LE(difference.largest, largest + 0.005) << what << ": at pixel " << difference.where.x << ", "
                                                   << difference.where.y << "; mean difference " << difference.mean;
  }

 private:
};

}  // namespace velum
