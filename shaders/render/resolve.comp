// From the sum of samples to a picture: mean, finish, background.
//
// GHOSTS is there when removed instances show over it. FINISH is there when something is added at the end, STROKES when hatching is, PAPER when the background is one.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"
#ifdef FINISH
#include "render/strokes.glsl"
layout(binding = kFinishImage, rgba32f) uniform readonly image2D finishImage;
layout(binding = kSampleUnit) uniform usampler2D sampleTexture;  // the last of the samples
layout(binding = kPaperUnit) uniform sampler2D paperTexture;
layout(location = 7) uniform int finishSamples;  // that finishImage is the sum of
layout(location = 8) uniform int finishRows;     // rows from the top that have one more
#endif

#ifdef GHOSTS
layout(binding = kGhostUnit) uniform sampler2D ghostTexture;  // the sum of samples, premultiplied
layout(location = 9) uniform int ghostSamples;
#endif

layout(binding = kColorImage, rgba32f) uniform readonly image2D colorImage;
layout(binding = kPictureImage) uniform writeonly image2D pictureImage;  // in 8 bits, or in floats

layout(location = 0) uniform ivec2 windowOrigin;  // the image's corner in the whole picture
layout(location = 1) uniform int samples;         // that are complete
layout(location = 2) uniform int rowsDone;        // rows from the top that have one more
layout(location = 3) uniform ivec2 strip;         // first row and one past the last of the strip of tiles that is being drawn
layout(location = 4) uniform int columnsDone;     // of that strip, the columns that have one more
layout(location = 5) uniform vec4 top;            // rgb; a: 0 leaves the background out
layout(location = 6) uniform vec4 bottom;     // rgb; a: 1 where the picture has 256 levels

#ifdef FINISH
/// What lines leave of the light, by channel: [ACS] 4.4 calls it the contour's intensity.
vec3 inkLeaves(float share) { return 1.0 - share * (1.0 - finish.contourColor.rgb); }

/// The share of a pixel that strokes cover.
float hatchingAt(ivec2 pixel, vec4 color) {
#ifdef STROKES
  float tone = color.a > 0.0 ? dot(color.rgb, vec3(0.30, 0.59, 0.11)) / max(color.a, 1e-3) : 1.0;
  float roomy = roomOf(unpackSample(texelFetch(sampleTexture, pixel, 0)));
  return finish.hatching * color.a * strokesAt(vec2(pixel + windowOrigin) + 0.5, 1.0 - min(tone, 1.0), roomy);
#else
  return 0.0;
#endif
}

/// rgb = ((1 - m) * ray-cast colour + m * lit sphere's colour) * contour intensity, [ACS] 4.4.
/// Differs: half of a line at an outline lies on the background, so that it is as wide as others.
vec4 finished(ivec2 pixel, vec4 color, bool hasBackground, vec3 behind) {
  // As it is seen without a finish: highlights end at white.
  color.rgb = min(color.rgb, vec3(color.a));
  int count = finishSamples + (pixel.y < finishRows ? 1 : 0);
  vec4 sum = count > 0 ? imageLoad(finishImage, pixel) / float(count) : vec4(color.rgb, 0.0);
  float line = finish.contours * sum.a;
  vec3 leaves = inkLeaves(line) * inkLeaves(hatchingAt(pixel, color));
  vec3 material = mix(color.rgb, sum.rgb, finish.litSphere) * leaves;
  float through = 1.0 - color.a;
  if (hasBackground) return vec4(material + through * behind * inkLeaves(line), 1.0);
  return vec4(material + through * line * finish.contourColor.rgb, color.a + through * line);
}
#endif

/// A finished colour with what is blended over it.
void store(ivec2 pixel, vec4 color) {
#ifdef GHOSTS
  vec4 ghosts = ghostSamples > 0 ? texelFetch(ghostTexture, pixel, 0) / float(ghostSamples) : vec4(0.0);
  color = ghosts + (1.0 - ghosts.a) * color;
#endif
  imageStore(pictureImage, pixel, color);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(pictureImage);
  if (any(greaterThanEqual(pixel, size))) return;
  bool inStrip = pixel.y >= strip.x && pixel.y < strip.y && pixel.x < columnsDone;
  int count = samples + (pixel.y < rowsDone || inStrip ? 1 : 0);
  vec4 color = count > 0 ? imageLoad(colorImage, pixel) / float(count) : vec4(0.0);
  float v = (float(pixel.y + windowOrigin.y) + 0.5) / frame.pictureSize.y;
  vec3 behind = mix(top.rgb, bottom.rgb, v);
  // Half a grey level of ordered noise hides the steps of a slow gradient.
  float dither = fract(52.9829189 * fract(dot(vec2(pixel + windowOrigin), vec2(0.06711056, 0.00583715)))) - 0.5;
  dither *= bottom.a;
#ifdef FINISH
#ifdef PAPER
  vec3 backdrop = texelFetch(paperTexture, pixel, 0).rgb;
#else
  vec3 backdrop = behind + dither / 255.0;
#endif
  store(pixel, finished(pixel, color, top.a > 0.0, backdrop));
  return;
#endif
  if (top.a > 0.0) color = vec4(color.rgb + (1.0 - color.a) * (behind + dither / 255.0), 1.0);
  store(pixel, color);
}
