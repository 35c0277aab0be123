// What is behind a finished picture: papers and cloths, made of noise and threads. Each place depends on where it lies in
// the whole picture alone, and lengths are in units of the paper: pixels of a picture of 1000 rows, times its scale.
//
// PAPER is the scene's, a scene::Paper.
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/finish.glsl"

layout(binding = kPaperImage, rgba8) uniform writeonly image2D paperImage;
layout(binding = kOwnPaperUnit) uniform sampler2D ownPaper;

layout(location = 0) uniform ivec2 windowOrigin;
layout(location = 1) uniform ivec2 turns;  // across, down: 1 turns over every other picture of the user's own

const int kSmooth = 1;
const int kRough = 2;
const int kLaid = 3;
const int kCanvas = 4;
const int kLinen = 5;
const int kParchment = 6;
const int kOwn = 7;

/// Noise about 0; what is finer than the picture's pixels is left out. @param size  length of its waves
float waves(vec2 p, float size) {
  float visible = smoothstep(1.0, 3.0, size / finish.paperUnits);
  return visible > 0.0 ? visible * (noiseAt(p * 2.0 / size + size * 7.31) - 0.5) : 0.0;
}

float cloudiness(vec2 p) { return waves(p, 620.0) + 0.6 * waves(p, 260.0) + 0.35 * waves(p, 90.0); }

/// Cold-pressed paper: bumps of several sizes.
float roughHeight(vec2 p) {
  vec2 bent = p + 5.0 * vec2(waves(p, 37.0), waves(p.yx + 91.0, 37.0));
  return 0.9 * waves(bent, 26.0) + 0.8 * waves(bent, 13.0) + 0.55 * waves(bent, 7.0) + 0.3 * waves(bent, 4.0);
}

/// A plain weave: threads go over and under by turns, none as thick as the next. @param size  from thread to thread
float weaveHeight(vec2 p, float size, float slubs) {
  vec2 bent = p + 0.12 * size * vec2(waves(p, 6.0 * size), waves(p.yx + 17.0, 6.0 * size));
  vec2 at = bent / size;
  ivec2 thread = ivec2(floor(at));
  vec2 part = at - vec2(thread) - 0.5;
  bool isOver = (thread.x + thread.y & 1) == 0;
  // Along the thread on top it rises in the middle; across, it is round.
  vec2 along = isOver ? part.yx : part;
  float thick = 1.0 + slubs * (randomOf(isOver ? ivec2(thread.x, 7001) : ivec2(7003, thread.y)) - 0.5);
  float visible = smoothstep(1.2, 3.0, size / finish.paperUnits);
  return visible * thick * (cos(3.1416 * along.y) * (0.75 + 0.25 * cos(6.2832 * along.x)) - 0.55);
}

float heightAt(vec2 p) {
  if (PAPER == kRough) return roughHeight(p);
  if (PAPER == kCanvas) return 1.5 * weaveHeight(p, 9.0, 0.5) + 0.5 * waves(p, 5.0);
  if (PAPER == kLinen) return 0.9 * weaveHeight(p, 5.5, 1.1) + 0.5 * waves(p, 4.0);
  return 0.35 * waves(p, 9.0) + 0.3 * waves(p, 4.0);
}

/// Lines of the mould: close ones across, and chains far apart.
float laidLines(vec2 p) {
  vec2 bent = p + vec2(1.5 * waves(p, 240.0), 2.0 * waves(p, 160.0));
  float visible = smoothstep(1.2, 3.0, 6.0 / finish.paperUnits);
  float chain = abs(fract(bent.x / 92.0) - 0.5) * 92.0;
  return 0.020 * visible * cos(6.2832 * bent.y / 6.0) - 0.035 * exp(-chain * chain / 3.0);
}

/// How much lighter or darker than the paper's colour a place is.
vec3 toneAt(vec2 p) {
  float slope = heightAt(p) - heightAt(p + vec2(0.9, 1.1));
  vec3 tone = vec3(0.20 * slope + 0.035 * cloudiness(p));
  if (PAPER == kLaid) tone += laidLines(p) + 0.05 * slope;
  if (PAPER == kCanvas || PAPER == kLinen) tone += 0.05 * heightAt(p);
  if (PAPER == kParchment) {
    float age = cloudiness(p * 0.8 + 300.0) + 0.5 * waves(p, 40.0);
    tone += age * vec3(0.10, 0.15, 0.24) - 0.06 * smoothstep(0.30, 0.42, waves(p, 11.0)) * vec3(0.7, 1.0, 1.2);
  }
  return tone;
}

/// The user's own picture, side by side, or turned over by turns where its edges do not fit.
vec3 ownPaperAt(vec2 p) {
  vec2 at = p / vec2(textureSize(ownPaper, 0));
  at = mix(fract(at), 1.0 - abs(mod(at, 2.0) - 1.0), vec2(turns));
  vec3 mean = textureLod(ownPaper, vec2(0.5), 99.0).rgb;
  vec3 color = textureLod(ownPaper, at, max(0.0, log2(finish.paperUnits))).rgb;
  return mean + 2.0 * finish.paperGrain * (color - mean);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(paperImage)))) return;
  ivec2 inPicture = pixel + windowOrigin;
  vec2 p = (vec2(inPicture) + 0.5) * finish.paperUnits;
  vec3 color = PAPER == kOwn ? ownPaperAt(p) : finish.paperColor.rgb * (1.0 + 2.0 * finish.paperGrain * toneAt(p));
  float dither = (randomOf(inPicture) - 0.5) / 255.0;
  imageStore(paperImage, pixel, vec4(clamp(color + dither, 0.0, 1.0), 1.0));
}
