// Instances of molecules: how they lie in buffers, which of them cuts leave, and how fine each is drawn. C++ and GLSL compile
// this text.
#ifndef VELUM_SHARED_INSTANCE_H
#define VELUM_SHARED_INSTANCE_H
#include "shared/cuts.h"
#include "shared/random.h"
SHARED_BEGIN

// How the spheres of an instance are shared out to threads: a list of each kind, with as many threads an instance.
SHARED_CONST int kDrawOne = 0;    // a single sphere: one thread
SHARED_CONST int kDrawFew = 1;    // up to kFewSpheres: kFewThreads, over and over
SHARED_CONST int kDrawMany = 2;   // a group, over and over
SHARED_CONST int kDrawLarge = 3;  // spheres of many pixels: a group for each, a thread for some of its pixels
SHARED_CONST int kDrawLists = 4;
SHARED_CONST int kFewSpheres = 64;
SHARED_CONST int kFewThreads = 8;      // as many as a software driver runs side by side
SHARED_CONST int kOutlineBalls = 16;  // at most, of the level by which an instance is told to be hidden
SHARED_CONST int kInstanceGroup = 64;  // threads of a group
SHARED_CONST int kLargeParts = 16;     // groups that share the balls of an instance of large ones
SHARED_CONST uint kNoInstance = 0xffffffffu;
SHARED_CONST uint kNoDepth = 0xffffffffu;  // bits of a depth where nothing is

/// One of a model's instances, in the scene frame of the first copy.
struct InstanceRow {
  vec4 position;  ///< xyz; w: bits of the molecule's number
  vec4 rotation;  ///< unit quaternion x, y, z, w
};

/// A molecule: a sphere around all of it, and its levels, of which the first is the finest. Three texels.
struct MoleculeRow {
  vec4 sphere;  ///< centre in its own frame and radius, scene units
  uint type;
  uint firstLevel;
  uint levelCount;
  float reach;       ///< of the balls of all levels from the centre
  uint outlineLevel; ///< a level of few balls: those of it and of finer ones lie in these,
  float outlineGrow; ///< grown by so much, scene units
  float padding0;
  float padding1;
};

/// A level of detail: spheres one after the other.
struct LevelRow {
  uint first;
  uint count;
  float error;    ///< how far its outline may be off that of the atoms, scene units
  float radius;  ///< mean one of its spheres, scene units
};

/// A type: how it looks. What cuts leave of it stands in rows of its own, [types][cuts].
struct TypeRow {
  vec4 color;  ///< sRGB; a: kType*
};
SHARED_CONST float kTypeHidden = 0.0f;
SHARED_CONST float kTypeShown = 1.0f;
SHARED_CONST float kTypeFilled = 2.0f;   // shown, and its removed instances as filled ghosts,
SHARED_CONST float kTypeContour = 3.0f;  // or as contours

/// What a cut leaves of the instances of a type (scene::TypeSpare). All 0: nothing.
struct TypeSpareRow {
  float share;
  float distance;  ///< kCutFar: wherever they are
  float falloff;   ///< below 0: outside
  float amount;
  float exponent;
  float viewShare;  ///< of those that hide the cut's focus, so many stay
  float aperture;
  float isFocus;    ///< 1: the cut keeps it in view
};

/// From where instances are drawn into a buffer of depths, and how fine. Frame: the scene's.
struct InstanceView {
  vec4 eye;          ///< orthographic: middle of the picture plane, before everything
  vec4 right;        ///< from the middle of the picture to its right edge, at distance 1 (orthographic: a length)
  vec4 up;
  vec4 forward;      ///< unit
  vec4 copyStep;     ///< xyz: from copy to copy along each axis
  vec4 copySphere;   ///< around the first copy: middle, radius
  vec2 pictureSize;  ///< of the whole picture, pixels
  vec2 shift;        ///< from a pixel of the window to where its ray goes through the whole picture, pixels
  ivec2 size;        ///< of the window, pixels
  int tilesX;        ///< of the pyramid's first level
  int tilesY;
  int copiesX;
  int copiesY;
  int copies;        ///< that have slots: the numbers of their instances follow each other, slot by slot
  int instanceCount;  ///< of one copy
  int cutCount;
  int isOrthographic;
  float detail;        ///< pixels by which outlines may be off
  float largeRadius;   ///< pixels, from which on balls are drawn a group each
  uint wholeInstances; ///< a bit each of the first cuts: they remove what is inside with all of its sphere
  int levelCount;      ///< of the pyramid
  int stateWords;      ///< of each kind of InstanceStates' bits
  int drawRoom;        ///< instances that a list of draws has room for
  uint firstWhole;     ///< number of the first copy as an instance of the whole model; kNoInstance: none is drawn so
  int wholeMolecule;   ///< which molecule the whole model is
  int allCopies;       ///< with and without slots
  int copiesZ;
  int showsInside;     ///< 1: something of the model is taken away, so that what lies inside of whole copies may show
  int padding0;
  int padding1;
  int padding2;
};

/// From where a cut's focus is kept in view. Its mask is a picture of kFocusRows rows of the whole view, whatever part of
/// it is drawn and how large: the same instances are cleared. Frame: the scene's.
struct FocusView {
  vec4 eye;
  vec4 right;
  vec4 up;
  vec4 forward;
  ivec2 size;          ///< of the mask, pixels
  int isOrthographic;
  int cut;             ///< of the enabled ones
  int guidesDepth;     ///< the mask has the nearest depth at which a sphere of the focus begins; else the farthest at which one ends
  int hasAperture;     ///< distances in the mask are known
  int padding0;
  int padding1;
};
SHARED_CONST int kFocusRows = 384;
SHARED_CONST uint kNoSeed = 0xffffffffu;

/// How instances are shaded, beside what the frame says of light.
struct InstanceShade {
  vec4 fogTop;        ///< sRGB, what they fade into at the top of the picture
  vec4 fogBottom;
  float fog;          ///< 0..1
  float fogNear;      ///< depths between which it grows
  float fogFar;
  float nearColors;   ///< 0..1
  float radius;       ///< of the wider occlusion, scene units
  float lightTexel;   ///< of the light's view, scene units
  float noise;        ///< of the sample, 0..1
  int occlusionTaps;  ///< of either radius
  uint firstInstance; ///< the number of the model's first
  uint firstType;     ///< and of its first type, as a structure
  int palette;        ///< kPalette*
  int hasLight;       ///< the light's view is there
  float angstrom;     ///< scene units
  float padding0;
  ivec2 openShift;    ///< which pixel of a few is asked how open it lies
};
/// How open it is around what is seen is worked out for one pixel of so many along x and y.
SHARED_CONST int kOpenStep = 2;
/// As far as it is looked around, parts of the picture's height.
SHARED_CONST float kOpenReach = 0.12;
SHARED_CONST int kPaletteElement = 3;
SHARED_CONST int kPaletteChain = 4;

/// Pixels along the edges of a tile, which is a texel of the pyramid's first level.
SHARED_CONST int kPyramidTile = 4;
/// So many instances, which are neighbours in space, are a bundle.
SHARED_CONST int kBundle = 64;
/// Rows of a level of the whole model: all its balls, then those that are seen from each octant.
SHARED_CONST int kWholeRows = 9;
/// Copies nest: so many along each axis are a block.
SHARED_CONST int kBlockEdge = 4;

/// A bundle that may show.
struct BundleRow {
  uint slot;
  uint bundle;  ///< of a copy
};

/// What an instance is drawn by.
struct DrawRow {
  uint instance;  ///< number over all slots, then of whole copies
  uint level;     ///< in the rows of levels
};

/// Where a list has its rows: two share a room, one from its beginning on, one from its end.
/// @param place  in the list  @param room  instances that a room is for
SHARED_FN int drawSlot(int list, int place, int room) {
  int first = list / 2 * room;
  return list % 2 == 0 ? first + place : first + room - 1 - place;
}
SHARED_CONST int kDrawRooms = 2;

/// How deep in a cut's removed side an instance is left that has the random number u: kCutFar: wherever it is; below 0: it is
/// removed so far outside already. An instance at depth d stays where u < p(d); as p only falls with the depth, that is where
/// d is less than the depth at which p(d) = u. [VE] 3 and 5; p(d) = share + (1 - share) amount (1 - (d / falloff)^exponent) up
/// to d = falloff, share beyond; outside p(d) = 1 - (1 - share) amount (1 - (-d / -falloff)^exponent).
/// Differs: distances are in the scene's unit, and the falloff goes over to the share rather than to nothing.
SHARED_FN float typeSpareDepth(TypeSpareRow spare, float u) {
  // As deep as the falloff goes, too: no number stays where a smaller one does not.
  float whole = u < spare.share ? max(spare.distance, spare.falloff) : 0.0f;
  float span = (1.0f - spare.share) * spare.amount;
  if (spare.falloff == 0.0f || span <= 0.0f) return whole;
  // Solved for d; outside, removed nearer than there. One power for both sides: a software driver works both out.
  bool isInside = spare.falloff > 0.0f;
  float rest = 1.0f - (isInside ? u - spare.share : 1.0f - u) / span;
  float at = rest > 0.0f ? spare.falloff * pow(min(rest, 1.0f), 1.0f / spare.exponent) : 0.0f;
  return u < spare.share || (isInside && rest <= 0.0f) ? whole : at;
}

/// kCutKeeps or kCutRemoves: what a cut does with an instance. @param depth  typeSpareDepth()
/// @param reach  0: by its middle; its radius: when all of its sphere is removed
SHARED_FN int instanceAnswer(CutData cut, float depth, float reach, vec3 p SHARED_SHEETS) {
  if (depth >= kCutFar) return kCutKeeps;
#if SHARED_HAS_SHEETS
  // A sheet's side is quicker known than how far off it is.
  if (cut.kind.x == kCutMembrane && depth == 0.0f && reach == 0.0f)
    return cutRemoves(cut, p SHARED_PASS_SHEETS) ? kCutRemoves : kCutKeeps;
#endif
  return -(cutDistance(cut, p SHARED_PASS_SHEETS) + reach) > depth ? kCutRemoves : kCutKeeps;
}

/// A vector turned by a unit quaternion.
SHARED_FN vec3 turned(vec4 q, vec3 v) {
  vec3 axis = vec3(q.x, q.y, q.z);
  SHARED_EXACT vec3 t = 2.0f * cross(axis, v);
  SHARED_EXACT vec3 out_ = v + q.w * t + cross(axis, t);
  return out_;
}

/// Half the width and the height of a picture at distance 1.
SHARED_FN vec2 halfPicture(vec4 right, vec4 up) { return vec2(length(vec3(right)), length(vec3(up))); }

/// The pixels of a picture whose rays may meet a sphere: x, y from; z, w to, in pixels. @param q  its middle as seen from the eye
SHARED_FN vec4 spherePixels(vec4 right, vec4 up, vec4 forward, int isOrthographic, vec2 pictureSize, vec3 q, float radius) {
  float depth = dot(q, vec3(forward));
  vec2 half_ = halfPicture(right, up);
  vec2 at = vec2(dot(q, vec3(right)), dot(q, vec3(up))) / half_;
  vec2 low = at - radius;
  vec2 high = at + radius;
  if (isOrthographic == 0) {
    vec2 root = radius * sqrt(max(at * at + depth * depth - radius * radius, vec2(0.0f)));
    float below = max(depth * depth - radius * radius, 1e-30f);
    low = (at * depth - root) / below;
    high = (at * depth + root) / below;
  }
  // Rows run downwards.
  vec2 from = (vec2(low.x, -high.y) / half_ * 0.5f + 0.5f) * pictureSize;
  vec2 to = (vec2(high.x, -low.y) / half_ * 0.5f + 0.5f) * pictureSize;
  return vec4(from, to);
}

/// Depths at which a ray enters a ball and leaves it; below 0 where it does not meet it. By the point of the ray next to the
/// middle: differences of squared distances from the eye would leave nothing of a small ball.
/// @param q  its middle  @param offset  where the ray begins, both from the eye  @param ray  its depth grows by 1 with its length
SHARED_FN vec2 ballDepths(vec3 q, float radius, vec3 offset, vec3 ray) {
  SHARED_EXACT vec3 toMiddle = q - offset;
  SHARED_EXACT float squared = dot(ray, ray);
  SHARED_EXACT float nearest = dot(toMiddle, ray) / squared;
  SHARED_EXACT vec3 aside = toMiddle - nearest * ray;
  SHARED_EXACT float left = radius * radius - dot(aside, aside);
  SHARED_EXACT float reach = sqrt(max(left, 0.0f) / squared);
  return left >= 0.0f ? vec2(nearest - reach, nearest + reach) : vec2(-1.0f);
}

/// The pixels of a focus's mask that a sphere may cover; none where z < x. What is about the eye covers none.
SHARED_FN ivec4 focusRect(FocusView view, vec3 q, float radius) {
  if (dot(q, vec3(view.forward)) <= radius) return ivec4(0, 0, -1, -1);
  vec4 pixels = spherePixels(view.right, view.up, view.forward, view.isOrthographic, vec2(view.size), q, radius) - 0.5f;
  ivec2 from = max(ivec2(ceil(vec2(pixels.x, pixels.y))), ivec2(0));
  ivec2 to = min(ivec2(floor(vec2(pixels.z, pixels.w))), view.size - 1);
  return ivec4(from, to);
}

/// Depths of a sphere on the ray of a pixel of a focus's mask.
SHARED_FN vec2 focusDepths(FocusView view, ivec2 pixel, vec3 q, float radius) {
  vec2 at = vec2(2.0f, -2.0f) * (vec2(pixel) + 0.5f) / vec2(view.size) + vec2(-1.0f, 1.0f);
  vec3 across = at.x * vec3(view.right) + at.y * vec3(view.up);
  bool isOrthographic = view.isOrthographic != 0;
  vec3 ray = isOrthographic ? vec3(view.forward) : vec3(view.forward) + across;
  return ballDepths(q, radius, isOrthographic ? across : vec3(0.0f), ray);
}

/// Whether a sphere hides the focus in a pixel. @param mask  depth there; below 0: there is none
SHARED_FN bool hidesFocus(vec2 depths, float mask) { return depths.x > 0.0f && depths.x < mask; }

/// How far a pixel of the mask lies from the nearest that is none of it, pixels. @param seed  of jump flooding [JFA]
SHARED_FN float focusDistance(ivec2 pixel, uint seed) {
  if (seed == kNoSeed) return kCutFar;
  return length(vec2(ivec2(int(seed & 0xffffu), int(seed >> 16)) - pixel));
}

/// The nearer of two seeds; of two as near, the lower one: whatever the order.
SHARED_FN uint nearerSeed(ivec2 pixel, uint a, uint b) {
  if (a == kNoSeed || b == kNoSeed) return a == kNoSeed ? b : a;
  ivec2 toA = ivec2(int(a & 0xffffu), int(a >> 16)) - pixel;
  ivec2 toB = ivec2(int(b & 0xffffu), int(b >> 16)) - pixel;
  int lengthA = toA.x * toA.x + toA.y * toA.y;
  int lengthB = toB.x * toB.x + toB.y * toB.y;
  return lengthB < lengthA || (lengthB == lengthA && b < a) ? b : a;
}

/// Whether a type's aperture opens a place of the mask. @param most  the longest distance in the mask
SHARED_FN bool apertureOpens(float aperture, float distance, float most) {
  return aperture > 0.0f && distance >= (1.0f - aperture) * most;
}

SHARED_END
#endif
