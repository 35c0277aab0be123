// What every pass of a frame knows. std140: only mat4, vec4 and groups of four scalars.
#ifndef VELUM_SHARED_FRAME_H
#define VELUM_SHARED_FRAME_H
#include "shared/types.h"
SHARED_BEGIN

// Bindings, one list for all passes.
SHARED_CONST uint kFrameBinding = 0u;      // uniform blocks
SHARED_CONST uint kVolumeUnit = 0u;        // samplers
SHARED_CONST uint kLabelUnit = 1u;
SHARED_CONST uint kSkipUnit = 2u;
SHARED_CONST uint kLightUnit = 3u;
SHARED_CONST uint kNoiseUnit = 4u;
SHARED_CONST uint kSurfaceColorUnit = 5u;
SHARED_CONST uint kSurfaceAuxUnit = 6u;
SHARED_CONST uint kTransferUnit = 7u;
SHARED_CONST uint kExtinctionUnit = 8u;
SHARED_CONST uint kGradientTableUnit = 9u;
SHARED_CONST uint kGradientUnit = 10u;     // 11: kSheetUnit
SHARED_CONST uint kCutBinding = 1u;
SHARED_CONST uint kStructureBinding = 2u;
SHARED_CONST uint kCellBinding = 3u;
SHARED_CONST uint kCellLabelBinding = 4u;
SHARED_CONST uint kMeshBinding = 5u;
SHARED_CONST uint kExemptBinding = 6u;

SHARED_CONST int kTransferSize = 4096;     // table positions 0 .. kTransferSize - 1; the sums have one entry more
SHARED_CONST int kTileGroup = 8;           // threads along x and y of a ray-cast group
SHARED_CONST float kFar = 1e30f;

// Bits of FrameParams.flags.
SHARED_CONST uint kFlagOrthographic = 1u;
SHARED_CONST uint kFlagShaded = 2u;
SHARED_CONST uint kFlagSkipEmpty = 4u;
SHARED_CONST uint kFlagStopOpaque = 8u;
SHARED_CONST uint kFlagGradientOpacity = 16u;
SHARED_CONST uint kFlagExemptions = 32u;   // some cut spares some structure
SHARED_CONST uint kFlagJitter = 64u;
SHARED_CONST uint kFlagCuts = 128u;
SHARED_CONST uint kFlagLightGrid = 256u;   // shadows or occlusion
SHARED_CONST uint kFlagMembranes = 512u;   // some cut is a membrane
SHARED_CONST uint kFlagSlices = 1024u;     // some membrane is a slice with what lies next to it
SHARED_CONST uint kFlagSheets = 2048u;     // some sheet is shown
SHARED_CONST uint kFlagHideFront = 4096u;  // of a scene with slices, for pictures of its parts: what lies before them
SHARED_CONST uint kFlagHideSlice = 8192u;  // their images
SHARED_CONST uint kFlagHideBehind = 16384u; // and what lies behind the first one

/// Scene-local frame: world millimetres minus an origin near the scene, so that floats are enough anywhere.
struct FrameParams {
  mat4 texFromScene;      ///< volume texture coordinates 0..1
  mat4 labelFromScene;    ///< label voxel indices
  mat4 clipFromScene;     ///< for what is rasterised; same rays
  vec4 eye;               ///< perspective: the eye; orthographic: middle of the picture plane
  vec4 right;             ///< from the middle of the picture to its right edge, at distance 1 (orthographic: mm)
  vec4 up;                ///< to its top edge
  vec4 forward;           ///< unit
  vec4 picture;           ///< width, height of the whole picture in pixels; subpixel offset x, y
  vec4 volumeSize;        ///< voxels x, y, z of the texture; w: voxels of the cell edge
  vec4 cellsPerTex;       ///< xyz: cells in a unit of texture coordinates
  vec4 cellGrid;          ///< cells x, y, z; w: reciprocal of the smallest spacing, 1/mm
  vec4 valueFromTexel;    ///< x: scale, y: offset from texels to the table 0..1; z: table 0..1 per data value
  vec4 step;              ///< x: step mm, y: opaque cutoff alpha, z: iso value (table 0..1), w: noise offset 0..1
  vec4 tableScale;        ///< x: extinction 1/mm of one unit of the running sums; y, z: from the first table entry with any to past the last
  vec4 gradientScale;     ///< x: texel difference of a gradient texel's full length; w: reciprocal of the largest gradient in its table, mm per data value
  vec4 window;            ///< x: scale, y: offset from table 0..1 to grey 0..1; z: label tint, w: opacity of the unlabelled
  vec4 light;             ///< ambient, diffuse, specular, shininess
  vec4 key;               ///< unit, towards the key light, scene frame; w: shadow strength
  vec4 hemisphere;        ///< xyz: unit up of the picture; w: occlusion strength
  vec4 normalX;           ///< rows of the matrix from differences of texels over two voxels to data value per mm, scene frame
  vec4 normalY;
  vec4 normalZ;
  vec4 lightGrid;         ///< cells x, y, z of the light grid; w: cell size mm
  ivec4 counts;           ///< x: cuts, y: words of the exemption mask a structure, z: number of structure rows, w: pass sample index
  uvec4 flags;            ///< x: kFlag*
};

/// One structure: index by label id.
struct StructureRow {
  vec4 color;  ///< rgb, a: opacity factor (0 when not visible)
};

SHARED_END
#endif
