// A ray's way through the volume: its lattice of samples, the cells under it, and leaps over those that are empty.
#include "common/frame.glsl"

layout(binding = kSkipUnit) uniform usampler3D skipTexture;  // r, g: cells to the nearest with content, with spared content, by octant

vec3 texFrom(vec3 p) { return (frame.texFromScene * vec4(p, 1.0)).xyz; }

/// Part of the ray inside the volume's box.
vec2 boxInterval(Ray ray) {
  vec3 o = texFrom(ray.origin);
  vec3 d = (frame.texFromScene * vec4(ray.direction, 0.0)).xyz;
  d = mix(d, vec3(1e-12), lessThan(abs(d), vec3(1e-12)));
  vec3 a = -o / d;
  vec3 b = (1.0 - o) / d;
  vec3 low = min(a, b);
  vec3 high = max(a, b);
  return vec2(max(max(low.x, low.y), max(low.z, 0.0)), min(min(high.x, high.y), high.z));
}

/// Walks the lattice of samples t_k = first + k dt and says which of them may be left out.
struct Walk {
  vec3 tex0;           // texture coordinates at t = 0
  vec3 texPerLength;
  vec3 cell0;          // the same in cells
  vec3 cellPerLength;  // never 0
  vec3 lengthPerCell;
  vec3 forward;        // signs of the ray's way through the cells, half of 1
  int octantLayer;     // z in the skip map of the octant into which the ray goes
  float first;         // t of lattice point 0
  float dt;
#if BRICKS
  float coarseFrom;    // t from which steps are twice as long, twice again at each doubling
#endif
};

Walk walkAlong(Ray ray, float first) {
  Walk walk;
  walk.tex0 = texFrom(ray.origin);
  walk.texPerLength = (frame.texFromScene * vec4(ray.direction, 0.0)).xyz;
  walk.cell0 = walk.tex0 * frame.cellsPerTex.xyz;
  walk.cellPerLength = walk.texPerLength * frame.cellsPerTex.xyz;
  walk.cellPerLength = mix(walk.cellPerLength, vec3(1e-12), lessThan(abs(walk.cellPerLength), vec3(1e-12)));
  walk.lengthPerCell = 1.0 / walk.cellPerLength;
  bvec3 grows = greaterThan(walk.cellPerLength, vec3(0.0));
  walk.forward = mix(vec3(-0.5), vec3(0.5), grows);
  walk.octantLayer = (int(grows.x) | int(grows.y) << 1 | int(grows.z) << 2) * int(frame.cellGrid.z);
  walk.first = first;
  walk.dt = frame.step;
#if BRICKS
  walk.coarseFrom = frame.coarsening.x / max(dot(ray.direction, frame.forward.xyz), 1e-6);
#endif
  return walk;
}

/// How far groups of so many samples that begin at a place are apart, and its reciprocal.
struct Stride {
  float apart;
  float per;
};
Stride strideAt(Walk walk, float t, int samples) {
  float stride = float(samples) * walk.dt;
#if BRICKS
  // As bricks hold larger voxels farther away. Where strides change, a whole number of the longer ones has gone by.
  float doublings = clamp(floor(log2(max(t, 1e-30) / max(walk.coarseFrom, 1e-30))) + 1.0, 0.0, frame.coarsening.y);
  float scale = uintBitsToFloat((uint(doublings) + 127u) << 23);
  float longer = stride * scale;
  float begin = walk.first + ceil((0.5 * scale * walk.coarseFrom - walk.first) / longer) * longer;
  stride = scale > 1.0 && t < begin - 0.01 * stride ? 0.5 * longer : longer;
#endif
  return Stride(stride, 1.0 / stride);
}

vec3 texAt(Walk walk, float t) { return walk.tex0 + t * walk.texPerLength; }
vec3 texBetween(Walk walk, float a, float b) { return texAt(walk, 0.5 * (a + b)); }

/// The least that is more than t. From afar floats are so coarse that t and a step are t again, and a ray would never end.
float afterAll(float t) { return t + 2.4e-7 * abs(t); }

/// The first lattice point after t.
float nextSample(Walk walk, float t) {
  float k = floor((t - walk.first) / walk.dt + 1.0 + 1e-4);
  float next = walk.first + k * walk.dt;
  return max(next > t ? next : next + walk.dt, afterAll(t));
}

ivec3 cellAt(Walk walk, float t) {
  return ivec3(clamp(walk.cell0 + t * walk.cellPerLength, vec3(0.0), frame.cellGrid.xyz - 0.5));
}

/// Where the ray leaves the cube of cells, `reach` along a side, that begins with a cell and lies the ray's way.
float leaveCube(Walk walk, float t, ivec3 cell, uint reach) {
  vec3 target = vec3(cell) + 0.5 + walk.forward * (2.0 * float(reach) - 1.0);
  vec3 exit = (target - walk.cell0) * walk.lengthPerCell;
  return max(min(exit.x, min(exit.y, exit.z)), t);
}

/// Distance, in cells, to the nearest cell with content that lies the ray's way; 0 in one.
uint cellsToContent(Walk walk, ivec3 cell, bool sparedOnly) {
  uvec2 d = texelFetch(skipTexture, cell + ivec3(0, 0, walk.octantLayer), 0).rg;
  return sparedOnly ? d.g : d.r;
}

/// Leaps from t over cells without content, at most to b, and only to places that are a number of strides (1 / perStride)
/// from the lattice's first point: what is sampled is the same as without leaping.
float leapEmpty(Walk walk, float t, float b, float stride, float perStride, bool sparedOnly) {
  bool leaping;
  do {
    ivec3 cell = cellAt(walk, t);
    uint reach = cellsToContent(walk, cell, sparedOnly);
    // To the last place that lies inside the empty cube: the segment that leaves it is still looked at.
    float leave = leaveCube(walk, t, cell, reach);
    float target = leave >= b ? b : walk.first + floor((leave - walk.first) * perStride - 1e-4) * stride;
    leaping = hasFlag(kFlagSkipEmpty) && reach > 0u && target > t;
    t = leaping ? target : t;
  } while (leaping && t < b);
  return t;
}

/// Where a group of samples lies on a ray.
struct GroupPlace {
  float lattice;  // t of the first lattice point
  float dt;       // between two
  float from;     // where it begins, behind what was leapt over
};

/// The next group that may hold something, from t on; at b where none does.
GroupPlace nextGroup(Walk walk, float t, float b, int samples, bool sparedOnly) {
  Stride stride = strideAt(walk, t, samples);
  float leapt = leapEmpty(walk, t, b, stride.apart, stride.per, sparedOnly);
#if BRICKS
  stride = strideAt(walk, leapt, samples);
#endif
  float lattice = walk.first + floor((leapt - walk.first) * stride.per + 1e-4) * stride.apart;
#if BRICKS
  // A group of longer steps may begin before the leap's end.
  leapt = leapt < b ? max(t, min(lattice, leapt)) : b;
#endif
  return GroupPlace(lattice, stride.apart / float(samples), leapt);
}
