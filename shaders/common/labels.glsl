// Labels, and how far inside their structures places among them lie, in the labels' own grid.
//
// LABEL_BRICKS: the labels of a streamed volume lie in bricks, side by side in the textures, with what their neighbours lend;
// bricks that are one structure's alone share a slot for it (LabelBricks).

layout(binding = kLabelUnit) uniform usampler3D labelTexture;
layout(binding = kCoverUnit) uniform sampler3D coverTexture;  // cover of a voxel, 0..1
layout(binding = kShareUnit) uniform sampler3D shareTexture;  // shares of a voxel: r, g: that cuts spare, by class; a: that is shown
#ifdef LABEL_BRICKS
layout(binding = kLabelPageUnit) uniform usamplerBuffer labelPageTexture;  // by brick: its slot
#else
layout(binding = kCoarseShareUnit) uniform sampler3D coarseShareTexture;  // their means over 2 x 2 x 2 voxels
#endif

ivec3 lastLabel() { return ivec3(frame.labelSize.xyz) - 1; }

/// A voxel's texel is it plus this. @param voxel  of the grid
#ifdef LABEL_BRICKS
ivec3 labelShift(ivec3 voxel) {
  ivec3 grid = lastLabel() / kLabelBrick + 1;
  ivec3 brick = voxel / kLabelBrick;
  int slot = int(texelFetch(labelPageTexture, (brick.z * grid.y + brick.y) * grid.x + brick.x).r);
  ivec3 place = ivec3(slot % kLabelSlotsAlong, slot / kLabelSlotsAlong % kLabelSlotsAlong, slot / (kLabelSlotsAlong * kLabelSlotsAlong));
  return place * kLabelSlotEdge + kLabelSlotHalo - brick * kLabelBrick;
}
/// Texture coordinates of a place in label voxels.
vec3 labelTex(vec3 p) {
  vec3 q = clamp(p, vec3(0.0), frame.labelSize.xyz);
  return (q + vec3(labelShift(min(ivec3(q), lastLabel())))) / vec3(textureSize(shareTexture, 0));
}
#else
ivec3 labelShift(ivec3 voxel) { return ivec3(0); }
vec3 labelTex(vec3 p) { return p / frame.labelSize.xyz; }
#endif

/// A position among the label voxels, whose corners are at whole numbers.
vec3 labelVoxelAt(vec3 scenePoint) { return (frame.labelFromScene * vec4(scenePoint, 1.0)).xyz + 0.5; }

/// True outside the grid. A ray enters and leaves exactly on the grid's faces: they belong to it.
bool isBeyondLabels(vec3 p) {
  return any(lessThan(p, vec3(-1e-3))) || any(greaterThan(p, frame.labelSize.xyz + 1e-3));
}

/// The label of the voxel there; 0 outside the grid.
uint labelIn(vec3 p) {
  ivec3 voxel = clamp(ivec3(p), ivec3(0), lastLabel());
  return isBeyondLabels(p) ? 0u : texelFetch(labelTexture, voxel + labelShift(voxel), 0).r;
}
uint labelAt(vec3 scenePoint) { return labelIn(labelVoxelAt(scenePoint)); }

#if LABELS != 0
float coverIn(vec3 p) { return textureLod(coverTexture, labelTex(p), 0.0).r; }

/// Interpolated shares, see shareTexture. @param p  label voxels
vec4 sharesIn(vec3 p) { return textureLod(shareTexture, labelTex(p), 0.0); }
/// Means of them around a place. @param endsHere  beyond the grid there is nothing; else what is at its end goes on
vec4 coarseSharesIn(vec3 p, bool endsHere) {
#ifdef LABEL_BRICKS
  vec4 means = textureLod(shareTexture, labelTex(p), 1.0);
#else
  vec4 means = textureLod(coarseShareTexture, p / (2.0 * vec3(textureSize(coarseShareTexture, 0))), 0.0);
#endif
  return endsHere && isBeyondLabels(p) ? frame.sharesBeyond : means;
}
#endif
