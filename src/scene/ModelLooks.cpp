#include "scene/ModelLooks.h"

#include <algorithm>
#include <cmath>

#include "scene/NamedTable.h"
#include "scene/Scene.h"

namespace velum::scene {

namespace {

struct LookRow {
  NamedModelLook look;
  Palette palette;
  double nearColors;
  Lighting lighting;  ///< but for where it comes from
  Finish finish;      ///< but for what is the user's own
  Background background;
};

constexpr glm::vec3 kPlateWhite(0.985f, 0.975f, 0.955f), kNight(0.10f, 0.115f, 0.14f), kDusk(0.035f, 0.04f, 0.05f),
    kOutline(0.10f, 0.08f, 0.09f);

const NamedTable<LookRow, NamedModelLook>& lookTable() {
  // Ambient and diffuse light together are about one: colours stay those of the palette.
  static const LookRow kTable[] = {
      {.look = {"painted", "Painted", "Flat calm colours and outlines, as cells are painted"},
       .palette = Palette::Type,
       .nearColors = 0.0,
       .lighting = {.ambient = 1.1, .diffuse = 0.1, .specular = 0.0, .shadow = 0.22, .occlusion = 0.27, .fog = 0.2},
       .finish = {.contours = 0.5, .contourWidth = 1.3, .contourColor = kOutline, .contourCreases = 0.0},
       .background = {kPlateWhite, kPlateWhite}},
      {.look = {"soft", "Soft", "Light from the side, shadows, and darkness in the depths; no outlines"},
       .palette = Palette::Type,
       .nearColors = 0.35,
       .lighting = {.ambient = 0.62,
                    .diffuse = 0.58,
                    .specular = 0.06,
                    .shininess = 18.0,
                    .shadow = 0.7,
                    .occlusion = 0.85,
                    .fog = 0.25},
       .finish = {.contourWidth = 1.6, .contourColor = kOutline, .contourCreases = 0.0},
       .background = {kNight, kDusk}},
      {.look = {"technical", "Technical", "Atoms by their element, in plain light"},
       .palette = Palette::Element,
       .nearColors = 1.0,
       .lighting =
           {.ambient = 0.74, .diffuse = 0.5, .specular = 0.15, .shininess = 50.0, .shadow = 0.25, .occlusion = 0.45},
       .finish = {.contours = 0.35, .contourWidth = 1.2, .contourColor = kOutline, .contourCreases = 0.0},
       .background = {{0.93f, 0.94f, 0.95f}, {0.86f, 0.87f, 0.89f}}},
  };
  static const NamedTable all("look of models", std::span<const LookRow>(kTable), &LookRow::look);
  return all;
}

/// The finish of a look is called Plate as well: that name was one for two things.
std::string_view presentName(std::string_view name) { return name == "plate" ? "painted" : name; }

/// @param own  whose own lit spheres and paper it has
Finish finishOf(const LookRow& row, const Finish& own) {
  Finish finish = row.finish;
  finish.ownPaper = own.ownPaper;
  finish.spheres = own.spheres;
  return finish;
}

void put(const LookRow& row, Scene& scene) {
  scene.model.look = row.look.name;
  scene.model.palette = row.palette;
  scene.model.nearColors = row.nearColors;
  Lighting light = row.lighting;
  light.keyDirection = scene.lighting.keyDirection;
  light.occlusionRadius = scene.lighting.occlusionRadius;
  scene.lighting = light;
  scene.finish = finishOf(row, scene.finish);
  scene.background.top = row.background.top;
  scene.background.bottom = row.background.bottom;
}

}  // namespace

std::span<const NamedModelLook> modelLooks() { return lookTable().names(); }

void applyModelLook(Scene& scene, std::string_view name) { put(lookTable().at(presentName(name)), scene); }

void applyFirstModelLook(Scene& scene) {
  applyModelLook(scene, kFirstModelLook);
  scene.rayCast.samplesPerPixel = kModelSamples;
}

double shapeDetail(const Scene& scene) {
  return scene.model.detail / std::sqrt(double(std::max(1, scene.rayCast.samplesPerPixel)));
}

Finish lookFinish(const Scene& scene) {
  const LookRow* row = lookTable().find(scene.model.look);
  return finishOf(row ? *row : LookRow{}, scene.finish);
}

bool isModelLook(std::string_view name) { return lookTable().find(presentName(name)); }

std::string_view modelLookName(const Scene& scene) {
  for (const LookRow& row : lookTable().rows()) {
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
