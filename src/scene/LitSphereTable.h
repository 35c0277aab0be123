#pragma once
#include <glm/glm.hpp>

#include "scene/LitSpheres.h"
#include "scene/NamedTable.h"

namespace velum::scene {

/// A row of the table of lit spheres: the material of a sphere. Colours are sRGB.
struct LitSphereRow {
  LitSphereName sphere;
  glm::vec3 dark, middle, light;  ///< away from the light, across it, towards it
  float soft = 0.6f;              ///< how far the light comes round: 0 as on the moon, 1 all the way
  float shine = 0.0f;             ///< strength of the highlight,
  float gloss = 20.0f;            ///< its exponent
  glm::vec3 rim{0.0f};            ///< what the edge turns into,
  float rimShare = 0.0f;          ///< how much of it,
  float rimPower = 1.8f;          ///< how close to the edge
  glm::vec3 bounce{0.0f};         ///< light from below right, added
  float mirror = 0.0f;            ///< of surroundings with a horizon, as on metal
  int steps = 0;                  ///< tones of a cartoon; 0: none
};

/// All our lit spheres, in the order of the window.
const NamedTable<LitSphereRow, LitSphereName>& litSphereTable();

}  // namespace velum::scene
