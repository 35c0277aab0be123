// One ray a pixel through the volume, from stretch to stretch between the cuts. How a stretch is marched is the mode's:
// marchStretch(), isDone(), addImage(), addSheet() and finishRay() of march_*.glsl.
//
// MODE 0 volume, 1 maximum, 2 isosurface; LABELS 0 none, 1 over a volume, 2 alone; COLOR 1 for colour volumes, 2 for mixed
// channels; GRADIENTS 1 looks gradients up in a texture; MEMBRANES is there when some cut is a membrane.
layout(local_size_x = 8, local_size_y = 8) in;
#define SEES_PAGES

#include "common/frame.glsl"
#include "common/cuts.glsl"
#include "common/volume.glsl"
#include "common/shade.glsl"
#include "common/noise.glsl"
#include "render/walk.glsl"
#include "render/hit.glsl"
#include "render/data_color.glsl"
#include "render/composite.glsl"
// Files are put in once, where they are first named: what a march includes must have been named above this line.
//
// The three marches are three loops: what they look ahead for (a group with material, a larger value, a crossing) decides
// how many samples a turn takes and what may be leapt over, and a loop that asks the mode inside runs every mode's turn for
// all rays of a SIMD group. They share the walk, its leaps, hits, faces, and the loops over stretches below.
#if MODE == 0
#include "render/march_volume.glsl"
#elif MODE == 1
#include "render/march_mip.glsl"
#else
#include "render/march_iso.glsl"
#endif
#include "render/inlays.glsl"
#include "render/sample.glsl"
#include "render/calm.glsl"


// The Gbuffer: see shared/frame.h.
layout(binding = kColorImage, rgba32f) uniform image2D colorImage;  // premultiplied, the sum of the samples so far
layout(binding = kSurfaceImage, rgba32f) uniform writeonly image2D surfaceImage;
layout(binding = kIdImage, rg32ui) uniform writeonly uimage2D idImage;
layout(binding = kSampleImage, rgba32ui) uniform writeonly uimage2D sampleImage;  // with kFlagFinish

layout(location = 0) uniform ivec4 tile;          // x, y: corner in the image; z, w: its size
layout(location = 1) uniform ivec2 windowOrigin;  // the image's corner in the whole picture
layout(location = 2) uniform ivec2 groups;        // x: of a row of the tile; y: stride
layout(location = 3) uniform int pixelStep;       // 1; more: only one of so many pixels along each axis, to see which pages rays meet

/// Everything along one ray, stretch by stretch.
void castStretches(inout Hit hit, Ray ray, Walk walk, float from, float tEnd) {
  float t = from;
  Face face = kNoFace;
  int guard = 4 * frame.cutCount + 2;  // each stretch ends at a face of some cut, and a ray meets each at most twice
#ifdef MEMBRANES
  guard += 256;  // but a folded sheet more often
#endif
  if (hasFlag(kFlagWalks)) guard += 64;  // and a shape that is not convex
  do {
    Stretch stretch = stretchFrom(ray, t, tEnd);
#if MODE == 0
    if (hasFlag(kFlagSpares) && !hasFlag(kFlagFaces)) {
      // What is removed and what is kept behind it take one turn: a software driver runs all of a turn for both.
      float from = t;
      face = stretch.kept ? kNoFace : Face(stretch.face, stretch.triangle);
      t = stretch.kept ? t : max(stretch.end, t + 1e-6 * max(1.0, abs(t)));
      stretch = stretchFrom(ray, t, tEnd);
      float end = stretch.kept ? stretch.end : t;
      march(hit, ray, walk, from, t, kNoFace, true);
      march(hit, ray, walk, t, end, face, false);
      t = end;
    } else
#endif
    {
      float end = stretch.kept ? stretch.end : max(stretch.end, t + 1e-6 * max(1.0, abs(t)));
      Span span = Span(t, end, stretch.kept ? face : kNoFace, !stretch.kept);
      if (end > t && (stretch.kept || hasFlag(kFlagSpares))) marchStretch(hit, ray, walk, span);
      face = stretch.kept ? kNoFace : Face(stretch.face, stretch.triangle);
      t = end;
    }
  } while (t < tEnd && --guard > 0 && !isDone(hit));
}

/// Everything along one ray, up to an opaque surface at `stop`.
Hit castRay(Ray ray, float jitter, float stop) {
  Hit hit = Hit(vec4(0.0), kFar, -ray.direction, 0u, 1.0, -1, 0.0);
  if (hasFlag(kFlagNoData)) return hit;
  vec2 box = boxInterval(ray);
  float tEnd = min(box.y, stop);
  if (box.x >= tEnd) return hit;
  Walk walk = walkAlong(ray, box.x + jitter * frame.step);
  if (!hasFlag(kFlagCuts)) {
    marchStretch(hit, ray, walk, Span(box.x, tEnd, kNoFace, false));
#ifdef MEMBRANES
  } else if (hasFlag(kFlagInlays) || hasFlag(kFlagSheets)) {
    castMarked(hit, ray, walk, box.x, tEnd);
#endif
  } else {
    castStretches(hit, ray, walk, box.x, tEnd);
  }
  finishRay(hit, ray, walk);
  return hit;
}

/// The pixel of the tile that is this thread's.
ivec2 pixelInTile() {
  // Neighbours in a SIMD group are neighbours in the picture: runs of eight are blocks of four by two.
  int i = int(gl_LocalInvocationIndex);
  ivec2 inGroup = ivec2(i & 3 | i >> 1 & 4, i >> 2 & 1 | i >> 3 & 6);
  // A software driver gives each of its threads a run of groups. With a stride of as many as there are threads neighbours,
  // which take about as long, are different threads'.
  int group = int(gl_WorkGroupID.x) * groups.y % int(gl_NumWorkGroups.x);
  return ivec2(group % groups.x, group / groups.x) * kTileGroup + inGroup;
}

void main() {
  ivec2 inTile = pixelInTile() * pixelStep;
  if (inTile.x >= tile.z || inTile.y >= tile.w) return;
  ivec2 pixel = tile.xy + inTile;
  ivec2 inPicture = pixel + windowOrigin;
  Ray ray = rayThrough(vec2(inPicture) + 0.5 + frame.subpixel);

  ivec2 ownPixel = min(pixel, textureSize(surfaceColorTexture, 0) - 1);
  ivec2 surfacePixel = ownPixel;
  if (hasFlag(kFlagNoData) && hasFlag(kFlagFinish)) surfacePixel = calmed(ownPixel);
  vec4 surface = texelFetch(surfaceColorTexture, surfacePixel, 0);
  vec4 surfaceAux = texelFetch(surfaceAuxTexture, surfacePixel, 0);
  float stop = surface.a > 0.0 ? surfaceAux.w : kFar;
  float jitter = hasFlag(kFlagJitter) ? noiseAt(inPicture, frame.noise) : 0.5;

  Hit hit = castRay(ray, jitter, stop);
  if (pixelStep > 1) return;
  uint instance = kDataInstance;
  uint group = kDataInstance;
  float size = kLargestSize;
  if (surface.a > 0.0 && !hasFlag(kFlagHideBehind)) {
    if (hit.color.a < 0.5) {
      uvec4 ids = texelFetch(surfaceIdTexture, surfacePixel, 0);
      instance = ids.y;
      group = ids.z;
      if (ids.w != 0u) size = uintBitsToFloat(ids.w);
      hit.distance = surfaceAux.w;
      hit.normal = surfaceAux.xyz;
      hit.structure = ids.x;
      hit.solid = 1.0;
      hit.face = -1;
    }
    hit.color += (1.0 - hit.color.a) * vec4(surface.rgb, 1.0) * surface.a;
  }
  if (hasFlag(kFlagFinish)) imageStore(sampleImage, pixel, packSample(ray, hit, group, size));
  if (frame.sampleIndex == 0) {
    // What is on a face is where the face is: a hair behind it, in the material.
    int face = hasFlag(kFlagSaysFaces) ? hit.face : -1;
    if (face >= 0) hit.distance = min(hit.distance, hit.faceT + kFaceVoxels / frame.voxelsPerLength);
    bool found = hit.distance < kFar && hit.color.a > 0.0;
    if (surfacePixel != ownPixel) {
      // Counts and clicks ask who is there, not who is drawn there.
      vec4 ownAux = texelFetch(surfaceAuxTexture, ownPixel, 0);
      uvec4 ownIds = texelFetch(surfaceIdTexture, ownPixel, 0);
      found = texelFetch(surfaceColorTexture, ownPixel, 0).a > 0.0;
      hit.normal = ownAux.xyz;
      hit.distance = ownAux.w;
      hit.structure = ownIds.x;
      instance = ownIds.y;
    }
    imageStore(surfaceImage, pixel, found ? vec4(hit.normal, hit.distance) : vec4(0.0));
    imageStore(idImage, pixel, found ? uvec4(hit.structure | uint(face + 1) << kFaceShift, instance + 1u, 0u, 0u) : uvec4(0u));
  }
  vec4 before = frame.sampleIndex == 0 ? vec4(0.0) : imageLoad(colorImage, pixel);
  imageStore(colorImage, pixel, before + hit.color);
}
