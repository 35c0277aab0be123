#include "scene/ModelLooks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/Error.h"
#include "scene/Scene.h"

namespace velum::scene {

namespace {

struct LookRow {
  NamedModelLook look;
  Palette palette = Palette::Type;
  double nearColors = 0.0;
  double ambient = 0.9, diffuse = 0.2, specular = 0.0, shininess = 40.0, shadow = 0.0, occlusion = 0.5, fog = 0.0;
  double contours = 0.0, contourWidth = 1.6, contourStructures = 1.0, contourCreases = 0.0;
  glm::vec3 contourColor{0.10f, 0.08f, 0.09f};
  glm::vec3 top{1.0f}, bottom{1.0f};
};

constexpr glm::vec3 kPaperWhite(0.985f, 0.975f, 0.955f), kNight(0.10f, 0.115f, 0.14f), kDusk(0.035f, 0.04f, 0.05f);

// Ambient and diffuse light together are about one: colours stay those of the palette.
constexpr LookRow kTable[] = {
    {.look = {"plate", "Plate", "Flat calm colours and outlines, as in painted plates of cells"},
     .ambient = 1.1,
     .diffuse = 0.1,
     .shadow = 0.22,
     .occlusion = 0.27,
     .fog = 0.2,
     .contours = 0.6,
     .contourWidth = 1.3,
     .top = kPaperWhite,
     .bottom = kPaperWhite},
    {.look = {"soft", "Soft", "Light from the side, shadows, and darkness in the depths; no outlines"},
     .nearColors = 0.35,
     .ambient = 0.62,
     .diffuse = 0.58,
     .specular = 0.06,
     .shininess = 18.0,
     .shadow = 0.7,
     .occlusion = 0.85,
     .fog = 0.25,
     .top = kNight,
     .bottom = kDusk},
    {.look = {"technical", "Technical", "Atoms by their element, in plain light"},
     .palette = Palette::Element,
     .nearColors = 1.0,
     .ambient = 0.74,
     .diffuse = 0.5,
     .specular = 0.15,
     .shininess = 50.0,
     .shadow = 0.25,
     .occlusion = 0.45,
     .contours = 0.35,
     .contourWidth = 1.2,
     .top = {0.93f, 0.94f, 0.95f},
     .bottom = {0.86f, 0.87f, 0.89f}},
};

void put(const LookRow& row, Scene& scene) {
  scene.model.palette = row.palette;
  scene.model.nearColors = row.nearColors;
  Lighting& light = scene.lighting;
  light.shaded = true;
  light.ambient = row.ambient;
  light.diffuse = row.diffuse;
  light.specular = row.specular;
  light.shininess = row.shininess;
  light.shadow = row.shadow;
  light.occlusion = row.occlusion;
  light.fog = row.fog;
  Finish finish;
  finish.contours = row.contours;
  finish.contourWidth = row.contourWidth;
  finish.contourColor = row.contourColor;
  finish.contourStructures = row.contourStructures;
  finish.contourCreases = row.contourCreases;
  finish.ownPaper = scene.finish.ownPaper;
  finish.spheres = scene.finish.spheres;
  scene.finish = finish;
  scene.background.top = row.top;
  scene.background.bottom = row.bottom;
}

}  // namespace

std::span<const NamedModelLook> modelLooks() {
  static const std::vector<NamedModelLook> names = [] {
    std::vector<NamedModelLook> all;
    for (const LookRow& row : kTable) all.push_back(row.look);
    return all;
  }();
  return names;
}

void applyModelLook(Scene& scene, std::string_view name) {
  std::string known;
  for (const LookRow& row : kTable) {
    if (row.look.name == name) return put(row, scene);
    known += fmt::format("{}{}", known.empty() ? "" : ", ", row.look.name);
  }
  throw ArgumentError(fmt::format("no look of models '{}'; there are {}", name, known));
}

bool isModelLook(std::string_view name) {
  return std::any_of(std::begin(kTable), std::end(kTable), [&](const LookRow& row) { return row.look.name == name; });
}

std::string_view modelLookName(const Scene& scene) {
  for (const LookRow& row : kTable) {
    Scene wanted;
    wanted.model.palette = scene.model.palette;
    wanted.lighting = scene.lighting;
    wanted.finish = scene.finish;
    wanted.background = scene.background;
    put(row, wanted);
    bool isSame = wanted.model.palette == scene.model.palette && wanted.model.nearColors == scene.model.nearColors &&
                  wanted.lighting == scene.lighting && wanted.finish == scene.finish &&
                  wanted.background == scene.background;
    if (isSame) return row.look.name;
  }
  return {};
}

}  // namespace velum::scene
