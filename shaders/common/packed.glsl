// Values between voxels from texels that hold four each, those of 2 x 2 neighbours along y and z, in 8 (PACKED 1) or 16 bits
// (PACKED 2): two fetches for the eight of a sampler. A software driver loads each corner of each ray by itself, so that they are
// what fetching costs; and it fetches from a buffer with less ado than from a texture.

#if PACKED == 1
const float kPackedUnit = 1.0 / 255.0;
vec4 unpackTexel(uvec2 bits) { return vec4(bits.xxxx >> uvec4(0u, 8u, 16u, 24u) & 255u); }
#else
const float kPackedUnit = 1.0 / 65535.0;
vec4 unpackTexel(uvec2 bits) { return vec4(bits.xxyy >> uvec4(0u, 16u, 0u, 16u) & 65535u); }
#endif

/// Interpolated in units of the integers, between a voxel and those after it.
/// @param texels  by x, y and z, x fastest: values at (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1)
/// @param i  where the voxel's are
/// @param f  0..1, from the voxel to the next along each axis
float packedIn(usamplerBuffer texels, int i, vec3 f) {
  vec4 values = mix(unpackTexel(texelFetch(texels, i).rg), unpackTexel(texelFetch(texels, i + 1).rg), f.x);
  vec2 ends = mix(values.xz, values.yw, f.y);
  return mix(ends.x, ends.y, f.z);
}

/// As a sampler would return it that interpolates and repeats the border.
/// @param size  voxels
float packedAt(usamplerBuffer texels, vec3 size, vec3 tex) {
  vec3 at = clamp(tex * size - 0.5, vec3(0.0), size - 1.0);
  ivec3 voxel = ivec3(at);  // the last ones, too: what stands behind them is not mixed in
  return packedIn(texels, (voxel.z * int(size.y) + voxel.y) * int(size.x) + voxel.x, at - vec3(voxel));
}
