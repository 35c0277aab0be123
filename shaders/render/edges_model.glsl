// Lines of cell models, in two weights, as painters of cells draw them: strong ones around the whole, around compartments and
// where the depth falls far; fine ones around instances, which go as these become small; faint ones within large instances.
//
// A pixel looks at places on a circle around it. The share of them that lie across an edge falls with the distance from it,
// alike for pictures of any size; samples shift the places by parts of a pixel, so that circles may be as narrow.

layout(binding = kGroupOfUnit) uniform usamplerBuffer groupOf;  // by structure: its compartment

// So many times the share of places that lie across an edge is a line's cover: it is 1.65 radii wide in sum, see kLineCircle.
const float kFullShare = 3.0;
// Sizes of instances between which their lines come, pixels of a picture of 1000 rows, or of a smaller one.
const float kNoLine = 6.0, kFullLine = 16.0;
// The widest pen for a size, as a share of it, and the finest one, which fades where it is too wide; of a strength of one:
// what is drawn half as dark may be twice as wide.
const float kMostPen = 0.035, kFinestPen = 0.65;
// And those between which faint lines within come, and how dark these are.
const float kNoneWithin = 25.0, kFullWithin = 55.0, kFaint = 0.27;
// What is left of the outlines of the whole and of compartments around what is too small for a line of its own, and how dark
// the line between compartments is where the depth does not fall.
const float kLeastOutline = 0.5;
const float kLeastBorder = 0.7;
const int kPlaces = 12;

float shownOf(float size) { return smoothstep(kNoLine, kFullLine, size); }

/// How wide a pen a place has: as wide as is asked for, or finer where what is drawn is small, as lines would be all that is seen.
float penOf(Sample s) {
  float most = max(kFinestPen, kMostPen * s.size) / (finish.contours * unitsOfSizes());
  return s.opacity > 0.5 ? min(finish.contourPixels, most) : finish.contourPixels;
}

/// Distance from the picture plane. @param depth  of a sample
float alongOf(float depth) { return hasFlag(kFlagOrthographic) ? depth : 1.0 / max(depth, 1e-9); }

uint groupOfSample(Sample s) { return texelFetch(groupOf, int(min(s.ids & 0xffffu, uint(textureSize(groupOf) - 1)))).r; }

/// What lies between a pixel and a place near it. x: strong, y: fine, each how dark; z: 1: there is anything.
vec3 betweenOf(Sample centre, Sample there, uint group) {
  bool isSolid = centre.opacity > 0.5;
  bool isOther = there.opacity > 0.5;
  if (isSolid != isOther) {
    float shown = shownOf(isSolid ? centre.size : there.size);
    return vec3(finish.steps * mix(kLeastOutline, 1.0, shown), 0.0, 1.0);
  }
  if (!isSolid || isSame(centre, there)) return vec3(0.0);
  float own = alongOf(centre.depth);
  float other = alongOf(there.depth);
  float shown = shownOf(own < other ? centre.size : there.size);
  float deep = smoothstep(0.5 * finish.deepStep, 1.5 * finish.deepStep, abs(own - other));
  bool isBorder = groupOfSample(there) != group;
  float strong = isBorder ? max(kLeastBorder * mix(kLeastOutline, 1.0, shown), deep * shown) : deep * shown;
  return vec3(max(finish.steps, finish.structures) * strong, finish.structures * shown, 1.0);
}

/// A place on the circle around a pixel. Places lie on whole pixels, and each sample shifts each by another part of one.
ivec2 placeOn(float radius, int place) {
  float turn = 6.2831853 / float(kPlaces) * float(place);
  vec2 shift = fract(0.5 + float(5 * place + frame.sampleIndex) * vec2(0.5698402909980532, 0.7548776662466927)) - 0.5;
  // Pixels widen a line that is finer than they are.
  float drawn = radius * min(0.6 + 0.4 * radius, 1.0);
  return ivec2(round(drawn * vec2(cos(turn), sin(turn)) + shift));
}

Sample sampleAt(ivec2 pixel) { return unpackSample(texelFetch(sampleTexture, clamp(pixel, ivec2(0), textureSize(sampleTexture, 0) - 1), 0)); }

/// The edges next to a pixel, 0..1.
float edgeAt(ivec2 pixel, Sample centre) {
  uint group = groupOfSample(centre);
  float own = alongOf(centre.depth);
  vec3 strong = vec3(0.0);
  vec3 fine = vec3(0.0);
  float folds = 0.0;
  float pen = penOf(centre);
  float wide = kStrongLine * kLineCircle * pen;
  float narrow = kFineLine * kLineCircle * pen;
  for (int i = 0; i < kPlaces / 2; ++i) {
    int across = i + kPlaces / 2;
    strong += betweenOf(centre, sampleAt(pixel + placeOn(wide, i)), group);
    strong += betweenOf(centre, sampleAt(pixel + placeOn(wide, across)), group);
    Sample a = sampleAt(pixel + placeOn(narrow, i));
    Sample b = sampleAt(pixel + placeOn(narrow, across));
    fine += betweenOf(centre, a, group) + betweenOf(centre, b, group);
    if (centre.opacity > 0.5 && isSame(centre, a) && isSame(centre, b)) {
      // On one side alone it falls: in a gap between atoms it does so on both.
      float before = abs(alongOf(a.depth) - own);
      float after = abs(alongOf(b.depth) - own);
      folds += smoothstep(finish.stepLength, 2.0 * finish.stepLength, max(before, after) - 3.0 * min(before, after));
    }
  }
  float line = min(1.0, kFullShare * strong.z / float(kPlaces)) * strong.x / max(strong.z, 1.0);
  line = max(line, min(1.0, kFullShare * fine.z / float(kPlaces)) * fine.y / max(fine.z, 1.0));
  float within = kFaint * finish.steps * smoothstep(kNoneWithin, kFullWithin, centre.size);
  return max(line, within * min(1.0, kFullShare * folds / float(kPlaces / 2)));
}
