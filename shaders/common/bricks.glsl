// Where the voxels of a volume lie that is streamed: in bricks, side by side in one texture. The box of the data is divided
// into pages, and a table says in which slot of the texture the voxels of each page are to be found: those of the page's own
// level, or of a coarser one that stands in for it; in slot 0 the whole volume lies, coarse.
//
// BRICKS 1: the samples of a group are looked for once, by its middle: a brick carries as many voxels of its neighbours as a
// group reaches (kGroupReach in PageGrid.h). BRICKS 2: every sample by itself, for steps longer than that.

layout(binding = kPageUnit) uniform usamplerBuffer pageTexture;  // by page: its slot
layout(binding = kSlotRowUnit) uniform samplerBuffer slotTexture;  // two texels a slot: scale and offset of a Brick
#ifdef SEES_PAGES
layout(std430, binding = kSeenPageBinding) buffer SeenPageBlock { uint seenPages[]; };  // a bit a page: a ray came through it
#endif

/// A place in the textures is tex * scale + offset, of tex at least `edge` away from the data's border.
struct Brick {
  vec3 scale;
  vec3 offset;
  vec3 edge;
};

Brick brickOf(int slot) {
  vec3 edge = slot == 0 ? frame.coarseEdge.xyz : vec3(-1.0);
  return Brick(texelFetch(slotTexture, 2 * slot).xyz, texelFetch(slotTexture, 2 * slot + 1).xyz, edge);
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
  return brickOf(int(texelFetch(pageTexture, index).r));
}
#endif

vec3 storedIn(Brick brick, vec3 tex) { return clamp(tex, brick.edge, 1.0 - brick.edge) * brick.scale + brick.offset; }
vec3 storedAt(vec3 tex) { return storedIn(brickAt(tex), tex); }
