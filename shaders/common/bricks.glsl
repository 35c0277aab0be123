// Where the voxels of a volume lie that is streamed: in bricks, side by side in one texture. The box of the data is divided
// into pages, and a table says in which slot of the texture the voxels of each page are to be found: those of the page's own
// level, or of a coarser one that stands in for it; in slot 0 the whole volume lies, coarse.
//
// BRICKS 1: the samples of a group are looked for once, by its middle: a brick carries as many voxels of its neighbours as a
// group reaches (kGroupReach in PageGrid.h). BRICKS 2: every sample by itself, for steps longer than that.

// A row of kSlotTexels for each slot; then pages, four to a texel: their slots.
layout(binding = kPageUnit) uniform usamplerBuffer pageTexture;
#ifdef SEES_PAGES
layout(std430, binding = kSeenPageBinding) buffer SeenPageBlock { uint seenPages[]; };  // a bit a page: a ray came through it
#endif

/// Of a slot: where among the voxels of its level a place lies, and where these lie in the texture.
struct Brick {
  vec3 scale;  ///< place among voxels, whose middles are at whole numbers = tex * scale + first
  vec3 first;
  vec3 last;   ///< the level's last voxel
  ivec3 shift; ///< texel = voxel + shift
};

/// A place in the texture: voxels are counted in whole numbers, so that fractions are those of the level, to the last bit.
struct Stored {
  ivec3 texel;
  vec3 fraction;  ///< towards the next
};

Brick brickOf(int slot) {
  uvec4 scale = texelFetch(pageTexture, kSlotTexels * slot);
  uvec4 first = texelFetch(pageTexture, kSlotTexels * slot + 1);
  uvec4 shift = texelFetch(pageTexture, kSlotTexels * slot + 2);
  return Brick(uintBitsToFloat(scale.xyz), uintBitsToFloat(first.xyz), uintBitsToFloat(uvec3(scale.w, first.w, shift.w)), ivec3(shift.xyz));
}

#ifdef COARSE_ONLY
Brick brickAt(vec3 tex) { return brickOf(0); }
#else
Brick brickAt(vec3 tex) {
  ivec3 grid = ivec3(frame.pageGrid.xyz);
  ivec3 page = clamp(ivec3(tex * frame.pagesPerTex.xyz + frame.firstPage.xyz), ivec3(0), grid - 1);
  int index = (page.z * grid.y + page.y) * grid.x + page.x;
#ifdef SEES_PAGES
  uint bit = 1u << (index & 31);
  if ((seenPages[index >> 5] & bit) == 0u) atomicOr(seenPages[index >> 5], bit);
#endif
  uvec4 slots = texelFetch(pageTexture, int(frame.pageGrid.w) + (index >> 2));
  uvec2 pair = (index & 2) == 0 ? slots.xy : slots.zw;
  return brickOf(int((index & 1) == 0 ? pair.x : pair.y));
}
#endif

Stored storedIn(Brick brick, vec3 tex) {
  vec3 at = clamp(tex * brick.scale + brick.first, vec3(0.0), brick.last);
  ivec3 voxel = ivec3(at);
  return Stored(voxel + brick.shift, at - vec3(voxel));
}
Stored storedAt(vec3 tex) { return storedIn(brickAt(tex), tex); }
/// For samplers.
vec3 inTexture(Stored stored) { return (vec3(stored.texel) + stored.fraction + 0.5) / frame.storeSize.xyz; }
