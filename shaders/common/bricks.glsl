// Where the voxels of a volume lie that is streamed: in bricks, side by side in one texture. The box of the data is divided
// into pages, and a table says in which slot of the texture the voxels of each page are to be found: those of the page's own
// level, or of a coarser one that stands in for it; in slot 0 the whole volume lies, coarse.
//
// BRICKS 1: the samples of a group are looked for once, by its middle: a brick carries as many voxels of its neighbours as a
// group reaches (kGroupReach in PageGrid.h). BRICKS 2: every sample by itself, for steps longer than that.

// kSlotRows of four words for each slot (PageTable.h); then pages, which name their slots. A software driver fetches four
// words about as fast as one, and whatever is behind a branch: so there is no shorter way for what is simple.
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
  ivec3 place;
};

/// A place in the texture: voxels are counted in whole numbers, so that fractions are those of the level, to the last bit.
struct Stored {
  ivec3 voxel;
  vec3 fraction;  ///< towards the next
  ivec3 place;    ///< of the brick
};

/// Where values lie, and where gradients do. In textures: texel = voxel + place. Values that are packed:
/// element = place.x + voxel.x + voxel.y * place.y + voxel.z * place.z.
const int kOfValues = 2;
const int kOfGradients = 3;

Brick brickOf(int slot, int what) {
  uvec4 scale = texelFetch(pageTexture, kSlotRows * slot);
  uvec4 first = texelFetch(pageTexture, kSlotRows * slot + 1);
  uvec4 place = texelFetch(pageTexture, kSlotRows * slot + what);
  return Brick(uintBitsToFloat(scale.xyz), uintBitsToFloat(first.xyz), uintBitsToFloat(uvec3(scale.w, first.w, place.w)), ivec3(place.xyz));
}

#ifdef COARSE_ONLY
int slotAt(vec3 tex, bool marks) { return 0; }
#else
/// @param marks  says that rays want what lies there
int slotAt(vec3 tex, bool marks) {
  ivec3 grid = ivec3(frame.pageGrid.xyz);
  ivec3 page = clamp(ivec3(tex * frame.pagesPerTex.xyz + frame.firstPage.xyz), ivec3(0), grid - 1);
  int index = (page.z * grid.y + page.y) * grid.x + page.x;
#ifdef SEES_PAGES
  if (marks && index != metPage) {
    metPage = index;
    uint bit = 1u << (index & 31);
    if ((seenPages[index >> 5] & bit) == 0u) atomicOr(seenPages[index >> 5], bit);
  }
#endif
  uvec4 four = texelFetch(pageTexture, int(frame.pageGrid.w) + (index >> 2));
  uvec2 two = (index & 2) == 0 ? four.xy : four.zw;
  return int((index & 1) == 0 ? two.x : two.y);
}
#endif
int slotAt(vec3 tex) { return slotAt(tex, true); }

Stored storedIn(Brick brick, vec3 tex) {
  vec3 at = clamp(tex * brick.scale + brick.first, vec3(0.0), brick.last);
  ivec3 voxel = ivec3(at);
  return Stored(voxel, at - vec3(voxel), brick.place);
}
Stored storedAt(vec3 tex) { return storedIn(brickOf(slotAt(tex), kOfValues), tex); }
Stored gradientStoredAt(vec3 tex) { return storedIn(brickOf(slotAt(tex), kOfGradients), tex); }
/// For samplers.
vec3 inTexture(Stored stored) { return (vec3(stored.voxel + stored.place) + stored.fraction + 0.5) / frame.storeSize.xyz; }
/// For values that are packed.
int elementOf(Stored stored) { return stored.place.x + stored.voxel.x + stored.voxel.y * stored.place.y + stored.voxel.z * stored.place.z; }
