// What the window holds, and what in it is hidden by what is drawn already.
#include "model/hidden.glsl"

layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;

// So many pixels along each edge are looked at by themselves: tiles around what is small have gaps.
const int kFewPixels = 16;

/// Whether all that is drawn in the pixels lies before a depth.
bool isHidden(vec4 pixels, float nearest) {
  ivec2 last = view.size - 1;
  // Rays go through the middles of pixels: what no middle lies in is not seen.
  ivec2 from = max(ivec2(ceil(pixels.xy - 0.01)), ivec2(0));
  ivec2 to = min(ivec2(floor(pixels.zw + 0.01)), last);
  if (any(lessThan(to, from))) return true;
  if (all(lessThan(to - from, ivec2(kFewPixels)))) {
    // Within the circle that a sphere is, nearly: its outline bulges by less than a pixel.
    uint bits = floatBitsToUint(nearest);
    vec2 middle = 0.5 * (pixels.xy + pixels.zw);
    vec2 reach = 0.5 * (pixels.zw - pixels.xy) + 0.5;
    ivec2 pixel = from;
    bool isOpen = false;
    while (pixel.y <= to.y && !isOpen) {
      vec2 d = (vec2(pixel) - middle) / reach;
      isOpen = dot(d, d) <= 1.0 && texelFetch(depthTexture, pixel.y * view.size.x + pixel.x).r > bits;
      pixel = pixel.x == to.x ? ivec2(from.x, pixel.y + 1) : pixel + ivec2(1, 0);
    }
    return !isOpen;
  }
  return nearest > farthestIn(from, to);
}

/// Whether a sphere lies beyond one of the planes through the eye and an edge of the window. What is next to the eye has no
/// pixels by which one could tell.
bool isAside(vec3 q, float depth, float radius) {
  if (view.isOrthographic != 0) return false;
  vec2 half_ = vec2(length(view.right.xyz), length(view.up.xyz));
  vec2 at = vec2(dot(q, view.right.xyz), dot(q, view.up.xyz)) / half_;
  // Edges of the window as slopes; rows run downwards.
  vec2 from = (2.0 * (view.shift - 1.0) / view.pictureSize - 1.0) * half_;
  vec2 to = (2.0 * (vec2(view.size) + view.shift) / view.pictureSize - 1.0) * half_;
  vec2 low = vec2(from.x, -to.y);
  vec2 high = vec2(to.x, -from.y);
  vec2 below = (low * depth - at) / sqrt(1.0 + low * low);
  vec2 above = (at - high * depth) / sqrt(1.0 + high * high);
  return any(greaterThan(max(below, above), vec2(radius)));
}
