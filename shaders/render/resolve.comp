// From the sum of samples to a picture: mean, background.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"

layout(binding = 0, rgba32f) uniform readonly image2D sumImage;
layout(binding = 1, rgba8) uniform writeonly image2D pictureImage;

layout(location = 0) uniform ivec4 window_;   // x, y: the image's corner in the whole picture; z: complete samples, w: rows that have one more
layout(location = 1) uniform vec4 top;        // rgb; a: 0 leaves the background out
layout(location = 2) uniform vec4 bottom;
layout(location = 3) uniform ivec4 part;      // x, y: rows of the strip that is being drawn; z: its columns to the left of this have one more sample, too

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(pictureImage);
  if (any(greaterThanEqual(pixel, size))) return;
  bool inPart = pixel.y >= part.x && pixel.y < part.y && pixel.x < part.z;
  int samples = window_.z + (pixel.y < window_.w || inPart ? 1 : 0);
  vec4 color = samples > 0 ? imageLoad(sumImage, pixel) / float(samples) : vec4(0.0);
  float v = (float(pixel.y + window_.y) + 0.5) / frame.picture.y;
  vec3 behind = mix(top.rgb, bottom.rgb, v);
  // Half a grey level of ordered noise hides the steps of a slow gradient.
  float dither = fract(52.9829189 * fract(dot(vec2(pixel + window_.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
  if (top.a > 0.0) color = vec4(color.rgb + (1.0 - color.a) * (behind + dither / 255.0), 1.0);
  imageStore(pictureImage, pixel, color);
}
