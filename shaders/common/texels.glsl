// Texels of the volume, wherever they lie: in textures that are the volume, or in bricks of it.
#include "common/frame.glsl"

#if BRICKS
#include "common/bricks.glsl"
#else
/// Where a place of the volume lies in the textures, which are the volume.
#define Stored vec3
Stored storedAt(vec3 tex) { return tex; }
Stored gradientStoredAt(vec3 tex) { return tex; }
vec3 inTexture(Stored stored) { return stored; }
#endif

// A texel is 0..1 of its type, or a float.
#if PACKED != 0
#if BRICKS
float rawTexelIn(Stored stored) { return packedIn(volumeTexture, elementOf(stored), stored.fraction); }
#else
float rawTexelIn(Stored stored) { return packedAt(volumeTexture, frame.storeSize.xyz, stored); }
#endif
const float kRawUnit = kPackedUnit;
#elif COLOR
/// COLOR 1: the colours of the data. COLOR 2: of mixed channels, which are kept multiplied by alpha.
vec3 volumeColorAt(vec3 tex) {
  vec4 texel = textureLod(volumeTexture, inTexture(storedAt(tex)), 0.0);
  return COLOR == 2 ? texel.rgb / max(texel.a, 1.0 / 255.0) : texel.rgb;
}
float rawTexelIn(Stored stored) { return textureLod(volumeTexture, inTexture(stored), 0.0).a; }
const float kRawUnit = 1.0;
#else
float rawTexelIn(Stored stored) { return textureLod(volumeTexture, inTexture(stored), 0.0).r; }
const float kRawUnit = 1.0;
#endif
float rawTexelAt(vec3 tex) { return rawTexelIn(storedAt(tex)); }
float texelAt(vec3 tex) { return rawTexelAt(tex) * kRawUnit; }

/// Position in the transfer table, 0..kTransferSize-1. @param stored  of storedAt()
float tableIn(Stored stored) {
  const float last = float(kTransferSize - 1);
  return clamp(rawTexelIn(stored) * (frame.tablePerTexel * kRawUnit * last) + frame.tableOffset * last, 0.0, last);
}
float tableAt(vec3 tex) { return tableIn(storedAt(tex)); }

// A group of samples: they lie close to its middle.
#if BRICKS == 1
#define GroupBrick Brick
GroupBrick groupBrick(vec3 middle) { return brickOf(slotAt(middle), kOfValues); }
Stored storedInGroup(GroupBrick brick, vec3 tex) { return storedIn(brick, tex); }
int groupSlot(vec3 middle) { return slotAt(middle, false); }
Stored gradientStoredInGroup(int slot, vec3 tex) { return storedIn(brickOf(slot, kOfGradients), tex); }
#else
#define GroupBrick int
GroupBrick groupBrick(vec3 middle) { return 0; }
Stored storedInGroup(GroupBrick brick, vec3 tex) { return storedAt(tex); }
int groupSlot(vec3 middle) { return 0; }
Stored gradientStoredInGroup(int slot, vec3 tex) { return gradientStoredAt(tex); }
#endif
