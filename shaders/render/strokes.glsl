// Strokes along a field of directions. A cell has a direction and the phases of two families of strokes, one across the
// other; in between the waves of the cells around are added up, and what comes out has strokes of even distance and any
// width [PHASOR].
#include "render/finish.glsl"

const float kTurn = 6.28318530718;

/// A cell's, as seen by another: directions have no sign.
struct Strokes {
  vec2 across;
  vec2 phase;
};

vec2 crossed(vec2 across) { return vec2(across.y, -across.x); }

Strokes towards(vec4 cell, vec2 across) {
  float side = dot(cell.xy, across) < 0.0 ? -1.0 : 1.0;
  return Strokes(side * cell.xy, side * cell.zw);
}

/// Pixels of the whole picture.
vec2 cellMiddle(ivec2 cell) { return (vec2(cell + ivec2(finish.firstCellX, finish.firstCellY)) + 0.5) * finish.cellPixels; }

/// The share of a stroke's pixels that are covered. @param wave  cosine and sine; thick  share of the distance
float strokeCover(vec2 wave, float thick) {
  float off = acos(clamp(wave.x * inversesqrt(max(dot(wave, wave), 1e-12)), -1.0, 1.0)) * 2.0 / kTurn;
  return clamp((thick - off) * 0.5 * finish.strokePixels + 0.5, 0.0, 1.0) * smoothstep(0.0, 0.16, thick);
}

#ifdef STROKES
/// Cosine and sine to a thousandth, in a quarter of the time.
vec2 waveOf(float angle) {
  vec2 x = fract(vec2(angle / kTurn + 0.25, angle / kTurn)) - 0.5;
  vec2 arch = x * (16.0 * abs(x) - 8.0);
  return arch + 0.225 * (arch * abs(arch) - arch);
}

// Of the darkness of a hatched place, what is left where everything is small: one family of fine strokes, an even tone.
const float kLeastPressed = 0.4;
const float kMostEven = 0.3;

// No stroke is on what is lighter, however hard a hand presses.
const float kLeastDark = 0.08;

layout(binding = kStrokeUnit) uniform sampler2D strokeTexture;

/// How dark strokes make a place.
/// @param at  pixels of the whole picture; darkness  of the shading, 0..1; roomy  how far there is room for strokes, see roomOf()
float strokesAt(vec2 at, float darkness, float roomy) {
  darkness = mix(min(kLeastPressed * darkness, kMostEven), darkness, roomy);
  vec2 inCells = at / finish.cellPixels - 0.5;
  vec2 whole = floor(inCells);
  vec2 part = inCells - whole;
  ivec2 cell = ivec2(whole) - ivec2(finish.firstCellX, finish.firstCellY);
  ivec2 last = ivec2(finish.cellsX, finish.cellsY) - 1;
  vec2 own = texelFetch(strokeTexture, clamp(cell, ivec2(0), last), 0).xy;
  float wave = kTurn / finish.strokePixels;
  vec4 sum = vec4(0.0);
  // A loop of one turn, as software drivers step over loops, but never over branches.
  for (int turn = 0; turn < (darkness > kLeastDark ? 1 : 0); ++turn)
    for (int i = 0; i < 4; ++i) {
      ivec2 to = ivec2(i & 1, i >> 1);
      ivec2 next = clamp(cell + to, ivec2(0), last);
      Strokes strokes = towards(texelFetch(strokeTexture, next, 0), own);
      vec2 way = at - cellMiddle(next);
      vec2 near = mix(1.0 - part, part, vec2(to));
      vec2 phase = strokes.phase + wave * vec2(dot(way, strokes.across), dot(way, crossed(strokes.across)));
      sum += near.x * near.y * vec4(waveOf(phase.x), waveOf(phase.y));
    }
  // A hand does not press alike everywhere.
  float hand = 0.14 * (noiseAt(at * finish.unitsPerPixel * 0.11) - 0.5);
  float once = clamp((darkness - 0.16) * 1.05 + hand, 0.0, 0.72);
  float twice = clamp((darkness - 0.60) * 1.5 + hand, 0.0, 0.6);
  return 1.0 - (1.0 - strokeCover(sum.xy, once)) * (1.0 - strokeCover(sum.zw, twice));
}
#endif
