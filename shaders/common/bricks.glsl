// Where the voxels of a volume lie that is streamed: in bricks, side by side in one texture. The box of the data is divided
// into pages, and a table says in which slot of the texture the voxels of each page are to be found: those of the page's own
// level, or of a coarser one that stands in for it; in slot 0 the whole volume lies, coarse.
//
// BRICKS 1: the samples of a group are looked for once, by its middle: a brick carries as many voxels of its neighbours as a
// group reaches (kGroupReach in PageGrid.h). BRICKS 2: every sample by itself, for steps longer than that.

// A row of kSlotWords for each slot; then pages. A page whose slot holds its own brick says where the slot is, by
// kOwnBrick; others name their slot.
layout(binding = kPageUnit) uniform usamplerBuffer pageTexture;
#ifdef SEES_PAGES
layout(std430, binding = kSeenPageBinding) buffer SeenPageBlock { uint seenPages[]; };  // a bit a page: a ray came through it
int metPage = -1;  // that this ray met last
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

uvec3 slotWords(int slot, int part) {
  int at = kSlotWords * slot + 3 * part;
  return uvec3(texelFetch(pageTexture, at).r, texelFetch(pageTexture, at + 1).r, texelFetch(pageTexture, at + 2).r);
}

Brick brickOf(int slot) {
  return Brick(uintBitsToFloat(slotWords(slot, 0)), uintBitsToFloat(slotWords(slot, 1)), uintBitsToFloat(slotWords(slot, 2)), ivec3(slotWords(slot, 3)));
}

#ifdef COARSE_ONLY
Brick brickAt(vec3 tex) { return brickOf(0); }
#else
Brick brickAt(vec3 tex) {
  ivec3 grid = ivec3(frame.pageGrid.xyz);
  ivec3 page = clamp(ivec3(tex * frame.pagesPerTex.xyz + frame.firstPage.xyz), ivec3(0), grid - 1);
  int index = (page.z * grid.y + page.y) * grid.x + page.x;
#ifdef SEES_PAGES
  if (index != metPage) {
    metPage = index;
    uint bit = 1u << (index & 31);
    if ((seenPages[index >> 5] & bit) == 0u) atomicOr(seenPages[index >> 5], bit);
  }
#endif
  uint word = texelFetch(pageTexture, int(frame.pageGrid.w) + index).r;
  uvec3 place = uvec3(word & 255u, word >> 8u & 255u, word >> 16u & 1023u);
  ivec3 shift = ivec3(place) * kBrickSlotEdge - (page * kPageEdge - kBrickBefore);
  Brick brick = Brick(frame.volumeSize.xyz, vec3(-0.5), frame.volumeSize.xyz - 1.0, shift);
  if ((word & kOwnBrick) == 0u) brick = brickOf(int(word));
  return brick;
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
