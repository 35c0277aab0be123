// The driver's own rate of trilinear fetches: rays through a volume, half a voxel from sample to sample, and nothing else.
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler3D volumeTexture;
layout(binding = 0, r32f) uniform writeonly image2D sumImage;

layout(location = 0) uniform ivec4 size;  // x, y: pixels; z: fetches a ray

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, size.xy))) return;
  // A little aslant, so that no axis of the texture is favoured by whole steps.
  vec3 at = vec3((vec2(pixel) + 0.5) / vec2(size.xy), 0.2);
  vec3 perStep = vec3(0.05, 0.03, 0.5) / vec3(textureSize(volumeTexture, 0));
  float sum = 0.0;
  for (int i = 0; i < size.z; ++i) {
    sum += textureLod(volumeTexture, at, 0.0).r;
    at += perStep;
  }
  imageStore(sumImage, pixel, vec4(sum));
}
