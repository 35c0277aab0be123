// From the sum of samples to a picture: mean, background.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"

layout(binding = kColorImage, rgba32f) uniform readonly image2D colorImage;
layout(binding = kPictureImage, rgba8) uniform writeonly image2D pictureImage;

layout(location = 0) uniform ivec2 windowOrigin;  // the image's corner in the whole picture
layout(location = 1) uniform int samples;         // that are complete
layout(location = 2) uniform int rowsDone;        // rows from the top that have one more
layout(location = 3) uniform ivec2 strip;         // first row and one past the last of the strip of tiles that is being drawn
layout(location = 4) uniform int columnsDone;     // of that strip, the columns that have one more
layout(location = 5) uniform vec4 top;            // rgb; a: 0 leaves the background out
layout(location = 6) uniform vec4 bottom;

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
  if (top.a > 0.0) color = vec4(color.rgb + (1.0 - color.a) * (behind + dither / 255.0), 1.0);
  imageStore(pictureImage, pixel, color);
}
