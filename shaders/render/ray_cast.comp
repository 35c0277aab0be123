// One ray a pixel through the volume, from stretch to stretch between the cuts, from segment to segment between the
// samples, leaping over cells that the transfer function leaves empty. The only ray march in the program.
//
// MODE 0 volume, 1 maximum, 2 isosurface; LABELS 0 none, 1 over a volume, 2 alone; COLOR 1 for colour volumes;
// GRADIENTS 1 looks gradients up in a texture.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"
#include "common/cuts.glsl"
#include "common/volume.glsl"
#include "common/shade.glsl"

layout(binding = kSkipUnit) uniform usampler3D skipTexture;  // r, g: cells to the nearest with content, with exempt content
layout(binding = kNoiseUnit) uniform sampler2D noiseTexture;
layout(binding = kSurfaceColorUnit) uniform sampler2D surfaceColorTexture;
layout(binding = kSurfaceAuxUnit) uniform sampler2D surfaceAuxTexture;  // xyz normal, w distance along the ray
layout(std430, binding = kCellBinding) readonly buffer CellBlock { vec2 cellRange[]; };

layout(binding = 0, rgba32f) uniform image2D sumImage;          // premultiplied colour, averaged over the samples so far
layout(binding = 1, rgba32f) uniform writeonly image2D placeImage;   // scene position, distance along the ray
layout(binding = 2, rgba32f) uniform writeonly image2D normalImage;  // normal, structure id

layout(location = 0) uniform ivec4 tile;     // x, y: corner in the image; z, w: its size
layout(location = 1) uniform ivec4 window_;  // x, y: the image's corner in the whole picture

struct Hit {
  vec4 color;      // premultiplied
  float distance;  // kFar: nothing
  vec3 normal;
  uint structure;
};

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

/// Walks the lattice of samples t_k = start + (k + jitter) dt and says which of them may be left out.
struct Walk {
  vec3 tex0;        // texture coordinates at t = 0
  vec3 texPerMm;
  float first;      // t of lattice point 0
  float dt;
};

vec3 texAt(Walk walk, float t) { return walk.tex0 + t * walk.texPerMm; }

ivec3 cellAt(vec3 tex) {
  return clamp(ivec3(tex * frame.cellsPerTex.xyz), ivec3(0), ivec3(frame.cellGrid.xyz) - 1);
}

/// Distance, in cells, to the next cell with content; 0 in one.
uint cellsToContent(ivec3 cell, bool exemptOnly) {
  uvec2 d = texelFetch(skipTexture, cell, 0).rg;
  return exemptOnly ? d.g : d.r;
}

/// Where the ray leaves the cube of empty cells around a cell.
float leaveEmpty(Walk walk, float t, ivec3 cell, uint reach) {
  vec3 edge = 1.0 / frame.cellsPerTex.xyz;
  vec3 low = (vec3(cell) - float(reach) + 1.0) * edge;
  vec3 high = (vec3(cell) + float(reach)) * edge;
  vec3 target = mix(low, high, greaterThan(walk.texPerMm, vec3(0.0)));
  vec3 d = mix(walk.texPerMm, vec3(1e-20), lessThan(abs(walk.texPerMm), vec3(1e-20)));
  vec3 exit = (target - walk.tex0) / d;
  exit = mix(exit, vec3(kFar), lessThan(abs(walk.texPerMm), vec3(1e-20)));
  return max(min(exit.x, min(exit.y, exit.z)), t);
}

/// The first lattice point after t.
float nextSample(Walk walk, float t) {
  float k = floor((t - walk.first) / walk.dt + 1.0 + 1e-4);
  return walk.first + k * walk.dt;
}

vec3 lightTexAt(vec3 p, vec3 normal) { return texFrom(p + normal * frame.lightGrid.w); }

float greyAt(float table) { return clamp(table / float(kTransferSize - 1) * frame.window.x + frame.window.y, 0.0, 1.0); }

#if MODE == 0

void addSample(inout Hit hit, vec4 premultiplied, float t, vec3 normal, uint structure) {
  float left = 1.0 - hit.color.a;
  // The layers (position, normal, id) are those of the sample that makes the ray half opaque, or of the first one.
  bool half_ = hit.color.a < 0.5 && hit.color.a + left * premultiplied.a >= 0.5;
  if (hit.distance == kFar || half_) {
    hit.distance = t;
    hit.normal = normal;
    hit.structure = structure;
  }
  hit.color += left * premultiplied;
}

/// The slice's grey values on a cut face, over everything behind it.
void addSliceFace(inout Hit hit, Ray ray, float t, int cut) {
  vec3 p = ray.origin + t * ray.direction;
  vec3 tex = texFrom(p);
#if COLOR
  vec3 grey = volumeColorAt(tex);
  float present = texelAt(tex) > 0.02 ? 1.0 : 0.0;
#elif LABELS == 2
  vec3 grey = vec3(0.0);
  float present = 0.0;
#else
  float value = greyAt(tableAt(tex));
  vec3 grey = vec3(value);
  float present = smoothstep(0.0, 0.02, value);
#endif
  uint structure = 0u;
#if LABELS != 0
  structure = labelAt(p);
  vec4 row = structureRow(structure);
  if (structure != 0u && row.a > 0.0) {
    grey = mix(grey, row.rgb * (0.35 + 0.65 * grey), 0.6 * frame.window.z);
    present = 1.0;
  }
#endif
  float alpha = present * cuts[cut].face.x;
  if (alpha > 0.0) addSample(hit, vec4(grey * alpha, alpha), t, cutNormal(cut, p), structure);
}

/// A segment of material and what the search already knows of it.
struct Segment {
  float t0;
  float t1;
  float x0;     // values at its ends, table positions
  float x1;
  float depth;  // optical depth by the transfer function
};

/// Shades and composites one segment.
void addSegment(inout Hit hit, Ray ray, Walk walk, Segment segment, float faceT, vec3 faceNormal, bool exemptOnly) {
  float tm = 0.5 * (segment.t0 + segment.t1);
  vec3 p = ray.origin + tm * ray.direction;
  vec3 tex = texAt(walk, tm);
  uint structure = 0u;
  float depth = segment.depth;
#if LABELS == 2
  structure = labelAt(p);
  if (exemptOnly && !cutsKeep(p, structure)) return;
  vec4 material = labelMaterial(p);
  vec3 albedo = material.rgb / max(material.a, 1e-6);
#else
#if COLOR
  vec3 albedo = volumeColorAt(tex);
#else
  vec3 albedo = colorBetween(segment.x0, segment.x1);
#endif
#if LABELS == 1
  structure = labelAt(p);
  if (exemptOnly && !cutsKeep(p, structure)) return;
  vec4 row = structureRow(structure);
  depth *= structure == 0u ? frame.window.w : row.a;
  if (structure != 0u) albedo = mix(albedo, row.rgb, frame.window.z);
  if (depth <= 0.0) return;
#endif
#endif
  vec3 normal = -ray.direction;
  vec3 color = albedo;
  if (hasFlag(kFlagShaded) || hasFlag(kFlagGradientOpacity)) {
#if LABELS == 2
    float h = 0.9 / frame.cellGrid.w;
    vec3 gradient = vec3(labelMaterial(p + vec3(h, 0, 0)).a - labelMaterial(p - vec3(h, 0, 0)).a,
                         labelMaterial(p + vec3(0, h, 0)).a - labelMaterial(p - vec3(0, h, 0)).a,
                         labelMaterial(p + vec3(0, 0, h)).a - labelMaterial(p - vec3(0, 0, h)).a);
    float steepness = 1.0;
#else
    vec3 gradient = gradientAt(tex);
    if (hasFlag(kFlagGradientOpacity)) depth *= gradientFactor(gradient);
    // Where the value hardly changes the gradient is noise: less of it counts.
    float steepness = smoothstep(0.0, 1.0, length(gradient) * frame.valueFromTexel.z * 60.0 / frame.cellGrid.w);
#endif
    float len = length(gradient);
    vec3 out_ = len > 0.0 ? -gradient / len : -ray.direction;
    if (dot(out_, ray.direction) > 0.0) out_ = -out_;
    normal = normalize(mix(-ray.direction, out_, steepness) + 1e-6);
    // On a cut the surface is the cut's; a voxel and a half behind it the data's own again.
    if (faceT >= 0.0) normal = normalize(mix(faceNormal, normal, smoothstep(0.25, 1.5, (tm - faceT) * frame.cellGrid.w * -dot(faceNormal, ray.direction))) + 1e-6);
    color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal));
  }
  float alpha = 1.0 - exp(-depth);
  addSample(hit, vec4(color * alpha, alpha), tm, normal, structure);
}

#if LABELS == 2
/// Extinction of a segment by the structures around its middle. Half coverage is the surface; a narrow ramp keeps it smooth.
float labelExtinction(vec3 scenePoint) {
  float coverage = labelMaterial(scenePoint).a;
  return smoothstep(0.35, 0.65, coverage) * coverage * 6.0 * frame.cellGrid.w;
}
#endif

/// Composites one stretch, front to back. Rays of a SIMD group go in step, and a software driver runs both sides of every
/// branch, so each kind of work has a loop of its own in which all rays have something to do: leaping over empty cells;
/// fetching a block of samples and marking the segments with material; shading the marked ones. Thin material is shaded a
/// group of segments at a time: what hides less than a tenth of what is behind it needs no gradient at every half voxel.
/// Groups and leaps keep to the same lattice, so leaping changes no picture.
void marchStretch(inout Hit hit, Ray ray, Walk walk, float a, float b, int face, bool exemptOnly) {
  vec3 faceNormal = vec3(0.0);
  float faceT = -1.0;
  if (face >= 0) {
    faceT = a;
    faceNormal = cutNormal(face, ray.origin + a * ray.direction);
    if (cuts[face].kind.y == 1) addSliceFace(hit, ray, a, face);
  }
  const int kBlock = 16;
  const int kGroup = 4;
  bool skipping = hasFlag(kFlagSkipEmpty);
  float cutoff = hasFlag(kFlagStopOpaque) ? frame.step.y : 2.0;
  float perGroupMm = float(kGroup) * walk.dt;
  float perGroup = 1.0 / perGroupMm;
  float values[kBlock + 1];   // of the block's lattice points, table positions
  float depths[kBlock];       // optical depth of its segments
  float t = a;
  while (t < b && hit.color.a < cutoff) {
    bool leaping = skipping;
    while (leaping) {
      ivec3 cell = cellAt(texAt(walk, t));
      uint reach = cellsToContent(cell, exemptOnly);
      // To the last lattice point inside the empty cube: the segment that leaves it is still looked at.
      float leave = leaveEmpty(walk, t, cell, reach);
      float target = leave >= b ? b : walk.first + floor((leave - walk.first) * perGroup - 1e-4) * perGroupMm;
      leaping = reach > 0u && target > t;
      t = leaping ? target : t;
      leaping = leaping && t < b;
    }
    float start = t;
    float lattice = walk.first + floor((t - walk.first) * perGroup + 1e-4) * perGroupMm;
    int first = clamp(int((t - lattice) / walk.dt + 1e-3), 0, kGroup - 1);
    int last = first;  // one past the block's last segment
    uint marks = 0u;
#if LABELS != 2
    values[first] = tableAt(texAt(walk, t));
#endif
    for (int n = first; n < kBlock && t < b; ++n) {
      float next = min(lattice + float(n + 1) * walk.dt, b);
#if LABELS == 2
      float value = 0.0;
      float sigma = labelExtinction(ray.origin + 0.5 * (t + next) * ray.direction);
#else
      float value = tableAt(texAt(walk, next));
      float sigma = extinctionBetween(values[n], value);
#endif
      values[n + 1] = value;
      depths[n] = sigma * (next - t);
      marks |= sigma > 0.0 ? 1u << n : 0u;
      last = n + 1;
      t = next;
    }
    while (marks != 0u && hit.color.a < cutoff) {
      int n = findLSB(marks);
      int end = n + 1;
      float depth = depths[n];
#if LABELS == 0
      int group = max(n & ~(kGroup - 1), first);
      int groupEnd = min((n | (kGroup - 1)) + 1, last);
      float together = 0.0;
      for (int i = group; i < groupEnd; ++i) together += depths[i];
      bool merge = together < 0.1;
      n = merge ? group : n;
      end = merge ? groupEnd : end;
      depth = merge ? together : depth;
#endif
      marks &= ~0u << end;
      float t0 = n == first ? start : lattice + float(n) * walk.dt;
      float t1 = min(lattice + float(end) * walk.dt, b);
      addSegment(hit, ray, walk, Segment(t0, t1, values[n], values[end], depth), faceT, faceNormal, exemptOnly);
    }
  }
}

#elif MODE == 1

float gBest = -1.0;

/// Largest table position, 0..1, that a cell's texel values reach.
float largestIn(vec2 texels) {
  vec2 mapped = texels * frame.valueFromTexel.x + frame.valueFromTexel.y;
  return clamp(max(mapped.x, mapped.y), 0.0, 1.0);
}

/// Keeps the largest value of one stretch. A cell whose largest value is not above it is left out.
void marchStretch(inout Hit hit, Ray ray, Walk walk, float a, float b, int face, bool exemptOnly) {
  const int kBlock = 16;
  bool skipping = hasFlag(kFlagSkipEmpty) && !exemptOnly;
  float perStep = 1.0 / walk.dt;
  float t = a;
  bool more = true;
  while (more) {
    bool leaping = skipping && t < b;
    while (leaping) {
      ivec3 cell = cellAt(texAt(walk, t));
      float largest = largestIn(cellRange[(cell.z * int(frame.cellGrid.y) + cell.y) * int(frame.cellGrid.x) + cell.x]);
      float leave = leaveEmpty(walk, t, cell, 1u);
      float target = min(walk.first + floor((leave - walk.first) * perStep + 1.0 - 1e-4) * walk.dt, b);
      leaping = largest <= gBest && target > t;
      t = leaping ? target : t;
      leaping = leaping && t < b;
    }
    for (int n = 0; n < kBlock && more; ++n) {
      float value = tableAt(texAt(walk, t)) / float(kTransferSize - 1);
      bool shown = true;
      uint structure = 0u;
#if LABELS == 1
      vec3 p = ray.origin + t * ray.direction;
      structure = labelAt(p);
      shown = structure == 0u ? frame.window.w > 0.0 : structureRow(structure).a > 0.0;
      if (exemptOnly) shown = shown && cutsKeep(p, structure);
#endif
      bool better = shown && value > gBest;
      gBest = better ? value : gBest;
      hit.distance = better ? t : hit.distance;
      hit.structure = better ? structure : hit.structure;
      more = t < b;
      t = min(nextSample(walk, t), b);
    }
  }
}

#else

/// What the surface looks like where the ray meets it; nothing when its structure is not shown.
void addSurface(inout Hit hit, Ray ray, Walk walk, float t, int face, bool exemptOnly) {
  float iso = frame.step.z * float(kTransferSize - 1);
  vec3 p = ray.origin + t * ray.direction;
  vec3 tex = texAt(walk, t);
  uint structure = 0u;
#if LABELS == 1
  structure = labelAt(p);
  bool shown = structure == 0u ? frame.window.w > 0.0 : structureRow(structure).a > 0.0;
  if (!shown || (exemptOnly && !cutsKeep(p, structure))) return;
#endif
  vec3 gradient = gradientAt(tex);
  float len = length(gradient);
  vec3 normal = len > 0.0 ? -gradient / len : -ray.direction;
  if (dot(normal, ray.direction) > 0.0) normal = -normal;
  if (face >= 0) normal = cutNormal(face, p);
  vec3 albedo = extinctionBetween(iso, iso) > 0.0 ? colorBetween(iso, iso) : vec3(0.9, 0.85, 0.78);
#if COLOR
  albedo = volumeColorAt(tex);
#endif
#if LABELS == 1
  if (structure != 0u) albedo = mix(albedo, structureRow(structure).rgb, frame.window.z);
#endif
  vec3 color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal));
  if (face >= 0 && cuts[face].kind.y == 1) color = vec3(greyAt(tableAt(tex)));
  hit = Hit(vec4(color, 1.0), t, normal, structure);
}

/// Stops at the first crossing of the iso value, found by bisection of its segment, or at once on a cut's face inside.
void marchStretch(inout Hit hit, Ray ray, Walk walk, float a, float b, int face, bool exemptOnly) {
  const int kBlock = 16;
  float iso = frame.step.z * float(kTransferSize - 1);
  bool skipping = hasFlag(kFlagSkipEmpty);
  float perStep = 1.0 / walk.dt;
  float t = a;
  float x = tableAt(texAt(walk, t));
  bool onFace = face >= 0 && x >= iso;
  if (onFace) addSurface(hit, ray, walk, a, face, exemptOnly);
  while (hit.distance == kFar && t < b) {
    bool leaping = skipping;
    while (leaping) {
      ivec3 cell = cellAt(texAt(walk, t));
      uint reach = cellsToContent(cell, exemptOnly);
      float leave = leaveEmpty(walk, t, cell, reach);
      float target = leave >= b ? b : walk.first + floor((leave - walk.first) * perStep - 1e-4) * walk.dt;
      leaping = reach > 0u && target > t;
      t = leaping ? target : t;
      leaping = leaping && t < b;
    }
    x = tableAt(texAt(walk, t));
    bool crosses = false;
    float low = t;
    float high = t;
    for (int n = 0; n < kBlock && t < b && !crosses; ++n) {
      float next = nextSample(walk, t);
      next = min(next > t ? next : t + walk.dt, b);
      float value = tableAt(texAt(walk, next));
      crosses = (x < iso) != (value < iso);
      low = t;
      high = next;
      x = crosses ? x : value;
      t = next;
    }
    for (int i = 0; crosses && i < 12; ++i) {
      float mid = 0.5 * (low + high);
      bool sameSide = (tableAt(texAt(walk, mid)) < iso) == (x < iso);
      low = sameSide ? mid : low;
      high = sameSide ? high : mid;
    }
    if (crosses) addSurface(hit, ray, walk, 0.5 * (low + high), -1, exemptOnly);
  }
}
#endif

/// Everything along one ray, up to an opaque surface at `stop`.
Hit castRay(Ray ray, float jitter, float stop) {
  Hit hit = Hit(vec4(0.0), kFar, -ray.direction, 0u);
  vec2 box = boxInterval(ray);
  float tEnd = min(box.y, stop);
  if (box.x >= tEnd) return hit;
  Walk walk = Walk(texFrom(ray.origin), (frame.texFromScene * vec4(ray.direction, 0.0)).xyz, box.x + jitter * frame.step.x, frame.step.x);
  float t = box.x;
  int remover = -1;
  // Each stretch ends at a face of some cut, and a ray meets each convex face at most twice.
  for (int guard = 0; guard < 4 * frame.counts.x + 2 && t < tEnd; ++guard) {
    Stretch stretch = stretchFrom(ray, t, tEnd, remover);
    if (stretch.end > t) {
      if (stretch.kept) marchStretch(hit, ray, walk, t, stretch.end, remover, false);
      else if (hasFlag(kFlagExemptions)) marchStretch(hit, ray, walk, t, stretch.end, -1, true);
    }
    remover = stretch.kept ? -1 : stretch.face;
    t = stretch.kept ? stretch.end : max(stretch.end, t + 1e-6);
#if MODE == 0
    if (hasFlag(kFlagStopOpaque) && hit.color.a >= frame.step.y) break;
#elif MODE == 2
    if (hit.distance < kFar) break;
#endif
  }
#if MODE == 1
  if (gBest >= 0.0) {
    float grey = greyAt(gBest * float(kTransferSize - 1));
    hit.color = vec4(vec3(grey), 1.0);
#if LABELS == 1
    if (hit.structure != 0u) hit.color.rgb = mix(vec3(grey), structureRow(hit.structure).rgb * grey, frame.window.z);
#endif
    hit.color *= smoothstep(0.0, 0.02, grey);
  }
#endif
  return hit;
}

void main() {
  // Neighbours in a SIMD group are neighbours in the picture: runs of eight are blocks of four by two.
  int i = int(gl_LocalInvocationIndex);
  ivec2 inGroup = ivec2(i & 3 | i >> 1 & 4, i >> 2 & 1 | i >> 3 & 6);
  ivec2 inTile = ivec2(gl_WorkGroupID.xy) * kTileGroup + inGroup;
  if (inTile.x >= tile.z || inTile.y >= tile.w) return;
  ivec2 pixel = tile.xy + inTile;
  ivec2 inPicture = pixel + window_.xy;
  Ray ray = rayThrough(vec2(inPicture) + 0.5 + frame.picture.zw);

  vec4 surface = texelFetch(surfaceColorTexture, min(pixel, textureSize(surfaceColorTexture, 0) - 1), 0);
  vec4 surfaceAux = texelFetch(surfaceAuxTexture, min(pixel, textureSize(surfaceAuxTexture, 0) - 1), 0);
  float stop = surface.a > 0.0 ? surfaceAux.w : kFar;
  float jitter = hasFlag(kFlagJitter) ? fract(texelFetch(noiseTexture, inPicture & (textureSize(noiseTexture, 0) - 1), 0).r + frame.step.w) : 0.5;

  Hit hit = castRay(ray, jitter, stop);
  if (surface.a > 0.0) {
    if (hit.color.a < 0.5) {
      hit.distance = surfaceAux.w;
      hit.normal = surfaceAux.xyz;
      hit.structure = 0u;
    }
    hit.color += (1.0 - hit.color.a) * vec4(surface.rgb, 1.0) * surface.a;
  }
  if (frame.counts.w == 0) {
    bool found = hit.distance < kFar && hit.color.a > 0.0;
    vec3 place = ray.origin + (found ? hit.distance : 0.0) * ray.direction;
    imageStore(placeImage, pixel, found ? vec4(place, hit.distance) : vec4(0.0, 0.0, 0.0, -1.0));
    imageStore(normalImage, pixel, found ? vec4(hit.normal, float(hit.structure)) : vec4(0.0));
  }
  vec4 before = frame.counts.w == 0 ? vec4(0.0) : imageLoad(sumImage, pixel);
  imageStore(sumImage, pixel, before + hit.color);
}
