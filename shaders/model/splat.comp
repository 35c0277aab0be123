// Balls of instances into a view: their depths, then, where these won, who they are.
//
// LARGE: a group of threads takes one ball after the other of its part of an instance, and each thread some of its pixels.
// Else a thread takes a ball with all its pixels. WHOLES: instances are copies as wholes, whose balls have types of their own,
// and cuts leave each ball or not.
layout(local_size_x = 64) in;

#include "model/instances.glsl"
#include "model/hidden.glsl"
#ifdef WHOLES
#include "model/kept.glsl"
layout(binding = kBallKindUnit) uniform usamplerBuffer ballKindTexture;
#endif
#include "common/line.glsl"

layout(std430, binding = kDepthBinding) buffer DepthBlock { uint depths[]; };
layout(std430, binding = kOwnerBinding) buffer OwnerBlock { uint owners[]; };
layout(std430, binding = kBallBinding) buffer BallBlock { uint balls[]; };
layout(std430, binding = kSeenBinding) buffer SeenBlock { uint nearest[]; };  // a bit an instance: it was nearest in some pixel
layout(std430, binding = kCountBinding) readonly buffer CountBlock { uint counts[]; };
layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;
layout(binding = kDrawUnit) uniform usamplerBuffer drawTexture;

layout(location = 0) uniform int list;        // kDraw*
layout(location = 1) uniform int writesOwner; // 0: depths; 1: who has them
layout(location = 2) uniform int firstGroup;  // of this dispatch
layout(location = 3) uniform int hasPyramid;  // the pyramid is of depths that are drawn already
layout(location = 4) uniform ivec2 order;     // of the dispatch's groups: how many, 0: as they come; stride

/// @param least  bits of the depth of the ball's nearest place
/// @return whether it is nearer than what was there
bool drawPixel(ivec2 pixel, vec3 q, float radius, uint least, uint instance, uint ball) {
  int at = pixel.y * view.size.x + pixel.x;
  uint before = texelFetch(depthTexture, at).r;  // as a texel: it may be an older one, which is farther, but costs half
  if (before < least) return false;  // most are hidden: it costs a look
  vec3 offset;
  vec3 ray = rayOf(pixel, offset);
  float depth = ballDepth(q, radius, offset, ray);
  if (depth <= 0.0) return false;
  uint bits = floatBitsToUint(depth);
  if (writesOwner == 0) {
    if (bits >= before) return false;
    atomicMin(depths[at], bits);
    return true;
  }
  if (bits == before) {
    // Two may be as near: the least of both, each by itself, is the same whoever comes first; who reads looks which it is.
    atomicMin(owners[at], instance);
    atomicMin(balls[at], ball);
  }
  return false;
}

void note(uint instance) {
  uint bit = 1u << (instance & 31u);
  if ((nearest[instance >> 5] & bit) == 0u) atomicOr(nearest[instance >> 5], bit);
}

/// A little before it: depths are rounded.
uint leastBits(vec3 q, float radius) { return floatBitsToUint(max((dot(q, view.forward.xyz) - radius) * 0.999999, 0.0)); }

/// The pixels that a ball may cover, clipped to the window; none where z < x.
ivec4 rectOf(vec3 q, float radius) {
  if (dot(q, view.forward.xyz) <= radius) return ivec4(0, 0, -1, -1);
  vec4 pixels = pixelsOf(q, radius);
  return ivec4(max(ivec2(ceil(pixels.xy)), ivec2(0)), min(ivec2(floor(pixels.zw)), view.size - 1));
}

/// Whether a ball lies behind what is drawn: half of those of an instance lie behind the other half.
bool isHidden(ivec4 rect, uint least) { return hasPyramid != 0 && uintBitsToFloat(least) > farthestIn(rect.xy, rect.zw); }

#ifdef WHOLES
/// Whether a ball is of a type that shows, where no cut takes it.
bool isLeft(uint instance, uint number, vec3 q, float radius) {
  uvec2 kind = texelFetch(ballKindTexture, int(number)).rg;
  uint type = kind.x | kind.y << 8;
  if (texelFetch(typeTexture, int(type)).a == kTypeHidden) return false;
  return view.cutCount == 0 || cutsLeave(instanceBits(instance) ^ number, type, q + view.eye.xyz, radius);
}
#else
bool isLeft(uint instance, uint number, vec3 q, float radius) { return true; }
#endif

void main() {
  int lane = int(gl_LocalInvocationIndex);
  // A software driver gives each of its threads a run of groups: with a stride, those that take long are not all one thread's.
  int inDispatch = int(lineGroup());
  int group = firstGroup + (order.x > 0 ? inDispatch * order.y % order.x : inDispatch);
#ifdef LARGE
  int threads = kInstanceGroup;
#else
  int threads = list == kDrawOne ? 1 : list == kDrawFew ? kFewThreads : kInstanceGroup;
#endif
  int place = group * (kInstanceGroup / threads) + lane / threads;
  if (place >= int(counts[list])) return;
  uvec2 draw = texelFetch(drawTexture, drawSlot(list, place, view.drawRoom)).rg;
  bool isNearest = false;
#ifdef WHOLES
  Place at = wholePlace(draw.x);
#else
  Place at = placeOf(draw.x);
#endif
  LevelRow level = levelAt(draw.y);
  vec3 origin = at.position - view.eye.xyz;
#ifdef LARGE
  for (uint i = gl_WorkGroupID.z; i < level.count; i += uint(kLargeParts)) {
    uint number = level.first + i;
    vec4 ball = texelFetch(ballTexture, int(number));
    vec3 q = origin + turned(at.rotation, ball.xyz);
    ivec4 rect = rectOf(q, ball.w);
    uint least = leastBits(q, ball.w);
    int wide = rect.z - rect.x + 1;
    int count = rect.z < rect.x || rect.w < rect.y ? 0 : wide * (rect.w - rect.y + 1);
    if (count > 0 && (isHidden(rect, least) || !isLeft(draw.x, number, q, ball.w))) count = 0;
    for (int p = lane; p < count; p += kInstanceGroup)
      isNearest = drawPixel(rect.xy + ivec2(p % wide, p / wide), q, ball.w, least, draw.x, number) || isNearest;
  }
#else
  for (uint i = uint(lane % threads); i < level.count; i += uint(threads)) {
    uint number = level.first + i;
    vec4 ball = texelFetch(ballTexture, int(number));
    vec3 q = origin + turned(at.rotation, ball.xyz);
    ivec4 rect = rectOf(q, ball.w);
    uint least = leastBits(q, ball.w);
    if (any(greaterThan(rect.xy, rect.zw)) || isHidden(rect, least) || !isLeft(draw.x, number, q, ball.w)) continue;
    // One loop: a SIMD group goes on until the last of its threads is done.
    ivec2 pixel = rect.xy;
    while (pixel.y <= rect.w) {
      isNearest = drawPixel(pixel, q, ball.w, least, draw.x, number) || isNearest;
      bool isLast = pixel.x == rect.z;
      pixel = isLast ? ivec2(rect.x, pixel.y + 1) : pixel + ivec2(1, 0);
    }
  }
#endif
  if (isNearest) note(draw.x);
}
