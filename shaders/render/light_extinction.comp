// The light grid's first step: mean extinction of each of its cells, as cut and as the structures are shown.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

// A streamed volume throws the shadows of its coarse level, whatever else has come: they hang on nothing that was seen before.
#define COARSE_ONLY

#include "common/frame.glsl"
#include "common/cuts.glsl"
#include "common/volume.glsl"

layout(binding = kLightImage, r32f) uniform writeonly image3D extinctionImage;

layout(location = 0) uniform int firstLayer;  // z of the first cells

/// Inlays let less of the material show, which then throws less of a shadow.
float shownExtinction(float extinction, vec3 p, uint structure) {
#ifdef MEMBRANES
  float thickness = 1.0 / frame.voxelsPerLength;
  if (hasFlag(kFlagInlays)) return fadedDepth(extinction * thickness, thickness, inlayShare(p, structure)) / thickness;
#endif
  return extinction;
}

/// What is at a position, uncut.
struct Place {
  vec3 point;  // scene
  uint structure;
  float extinction;  // 1/length
};

Place placeAt(vec3 tex) {
  Place place;
  mat4 edges = frame.sceneFromTex;
  place.point = edges[3].xyz + tex.x * edges[0].xyz + tex.y * edges[1].xyz + tex.z * edges[2].xyz;
  place.structure = 0u;
#if LABELS == 2
  place.structure = labelAt(place.point);
  place.extinction = smoothstep(0.35, 0.65, solidsOf(sharesIn(labelVoxelAt(place.point)), 1.0).x) * solidExtinction();
#else
  float factor = 1.0;
#if LABELS == 1
  place.structure = labelAt(place.point);
  factor = place.structure == 0u ? frame.unlabelledOpacity : structureRow(place.structure).a;
#endif
  bool isSolid = false;
#if LABELS == 1
  if (hasSolids()) isSolid = structureLook(place.structure).y > 0.0 && structureRow(place.structure).a > 0.0;
#endif
#if MODE == 2
  place.extinction = tableAt(tex) >= frame.isoValue * float(kTransferSize - 1) ? 4.0 * frame.voxelsPerLength : 0.0;
#else
  place.extinction = extinctionAt(tableAt(tex)) * factor;
#endif
  if (isSolid) place.extinction = factor < 0.995 ? 0.0 : 4.0 * frame.voxelsPerLength;
#endif
  place.extinction = min(shownExtinction(place.extinction, place.point, place.structure), 2.0 / frame.lightCell);
  return place;
}

/// Eight places in a cell, each at a height of its own along each axis: a cut that goes through fills it in eighths.
vec3 sampleTex(ivec3 cell, int i) {
  return (vec3(cell) + (vec3(i, i * 3 & 7, i * 5 + 2 & 7) + 0.5) / 8.0) / frame.lightGrid.xyz;
}

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstLayer);
  if (any(greaterThanEqual(cell, ivec3(frame.lightGrid.xyz)))) return;
  float sum = 0.0;
#ifdef MEMBRANES
  // Samples with material next to a sheet are few: they have a loop of their own.
  uint near = 0u;
  for (int i = 0; i < 8; ++i) {
    Place place = placeAt(sampleTex(cell, i));
    int guess = cutsGuess(place.point, place.structure);
    sum += guess == kCutKeeps ? place.extinction : 0.0;
    near |= guess == kCutNear && place.extinction > 0.0 ? 1u << i : 0u;
  }
  do {
    Place place = placeAt(sampleTex(cell, max(findLSB(near), 0)));
    bool isKept = near != 0u && cutsKeep(place.point, place.structure);
    sum += isKept ? place.extinction : 0.0;
    near &= near - 1u;
  } while (near != 0u);
#else
  for (int i = 0; i < 8; ++i) {
    Place place = placeAt(sampleTex(cell, i));
    sum += frame.cutCount == 0 || cutsKeep(place.point, place.structure) ? place.extinction : 0.0;
  }
#endif
  imageStore(extinctionImage, cell, vec4(sum * 0.125));
}
