// What was drawn into the surfaces, without specks: an illustrator draws none.
layout(binding = kSurfaceColorUnit) uniform sampler2D surfaceColorTexture;
layout(binding = kSurfaceAuxUnit) uniform sampler2D surfaceAuxTexture;  // xyz normal, w distance along the ray
layout(binding = kSurfaceIdUnit) uniform usampler2D surfaceIdTexture;  // structure, instance, what a line goes around, how large it is

#include "shared/finish.h"

const float kLeastCalm = 1.0;  // pixels to the places that are asked

/// The pixel that is shown in a pixel. A gap in an instance, too narrow for a pen, is the instance's, and so is a speck on it.
ivec2 calmed(ivec2 pixel) {
  float reach = max(kCalmReach * frame.pictureSize.y / 1000.0, kLeastCalm);
  ivec2 last = textureSize(surfaceIdTexture, 0) - 1;
  uint own = texelFetch(surfaceIdTexture, pixel, 0).b;
  float depth = own == 0u ? kFar : texelFetch(surfaceAuxTexture, pixel, 0).w;
  ivec2 found = pixel;
  ivec2 around = pixel;
  int like = 0;
  for (int i = 0; i < 6; ++i) {
    // No place lies half way between pixels, whichever way that would be rounded.
    float turn = 3.14159265 / 6.0 * (float(i) + 0.25);
    ivec2 way = ivec2(round(reach * vec2(cos(turn), sin(turn))));
    ivec2 there = clamp(pixel + way, ivec2(0), last);
    ivec2 across = clamp(pixel - way, ivec2(0), last);
    uint a = texelFetch(surfaceIdTexture, there, 0).b;
    uint b = texelFetch(surfaceIdTexture, across, 0).b;
    like += (a == own ? 1 : 0) + (b == own ? 1 : 0);
    if (a == b && a != own && a != 0u) {
      around = there;
      if (max(texelFetch(surfaceAuxTexture, there, 0).w, texelFetch(surfaceAuxTexture, across, 0).w) < depth) found = there;
    }
  }
  return like == 0 ? around : found;
}
