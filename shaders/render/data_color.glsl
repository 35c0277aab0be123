// How the data itself looks where it is shown as on a section: on a cut's face and on the image of an inlay.
#include "common/volume.glsl"
#include "render/walk.glsl"

float greyAt(float table) { return clamp(table / float(kTransferSize - 1) * frame.greyScale + frame.greyOffset, 0.0, 1.0); }

uint structureAt(vec3 p) {
#if LABELS != 0
  return labelAt(p);
#else
  return 0u;
#endif
}

/// Grey values by the window, or colours, tinted by structures. a: 0 where it is black.
vec4 dataColor(vec3 p, uint structure) {
  vec3 tex = texFrom(p);
#if COLOR
  vec4 color = vec4(volumeColorAt(tex) * (COLOR == 2 ? texelAt(tex) : 1.0), texelAt(tex) > 0.02 ? 1.0 : 0.0);
#elif LABELS == 2
  vec4 color = vec4(0.0);
#else
  float value = greyAt(tableAt(tex));
  vec4 color = vec4(vec3(value), smoothstep(0.0, 0.02, value));
#endif
#if LABELS != 0
  vec4 row = structureRow(structure);
  if (structure != 0u && row.a > 0.0) color = vec4(mix(color.rgb, row.rgb * (0.35 + 0.65 * color.rgb), 0.6 * structureTint(structure)), 1.0);
#endif
  return color;
}
