// What every pass of a frame knows. std140: only mat4, vec4 and what fills 16 bytes.
#ifndef VELUM_SHARED_FRAME_H
#define VELUM_SHARED_FRAME_H
#include "shared/bindings.h"
#include "shared/types.h"
SHARED_BEGIN

SHARED_CONST int kTransferSize = 4096;  // table positions 0 .. kTransferSize - 1; the sums have one entry more, gradients' factors follow
SHARED_CONST int kTileGroup = 8;        // threads along x and y of a ray-cast group
SHARED_CONST int kNoiseEdge = 64;       // of the tile of blue noise, pixels
// Of a streamed volume (common/bricks.glsl, PageGrid.h): rows of four words of a slot in the table of pages; voxels along
// a page's edge; texels along a slot's.
SHARED_CONST int kSlotRows = 4;
SHARED_CONST int kPageEdge = 32;
SHARED_CONST int kBrickSlotEdge = 39;
SHARED_CONST int kLabelBrick = 32;      // voxels along an edge of a brick of labels,
SHARED_CONST int kLabelSlotHalo = 2;    // what its slot holds of its neighbours on each side,
SHARED_CONST int kLabelSlotEdge = kLabelBrick + 2 * kLabelSlotHalo;
SHARED_CONST int kLabelSlotsAlong = 16; // and slots of the texture along x and along y
SHARED_CONST float kFar = 1e30f;
SHARED_CONST int kMostPlanes = 3;       // so many cuts that are all planes have programs of their own: PLANES

// What the Gbuffer holds of what is seen in a pixel, besides its colour: vec4 of its normal (scene frame, unit) and its
// distance along the ray; uvec2 of ids: the structure (a label; 0: none) and the instance + 1 (0: nothing is seen). Of data
// the structure has 16 bits; above them stands the cut on whose face that is, of those that are enabled, + 1.
SHARED_CONST uint kDataInstance = 0u;          // the volume, its labels and what cuts show of them
SHARED_CONST int kFaceShift = 16;
SHARED_CONST float kFaceVoxels = 0.02f;        // so far behind a face lies what is seen on it
SHARED_CONST uint kFirstSurfaceInstance = 1u;  // scene.surfaces in their order; then whatever else is drawn

// Bits of FrameParams.flags.
SHARED_CONST uint kFlagOrthographic = 1u;
SHARED_CONST uint kFlagShaded = 2u;
SHARED_CONST uint kFlagSkipEmpty = 4u;
SHARED_CONST uint kFlagStopOpaque = 8u;
SHARED_CONST uint kFlagGradientOpacity = 16u;
SHARED_CONST uint kFlagSpares = 32u;  // some cut spares some structure
SHARED_CONST uint kFlagJitter = 64u;
SHARED_CONST uint kFlagCuts = 128u;
SHARED_CONST uint kFlagLightGrid = 256u;     // shadows or occlusion
SHARED_CONST uint kFlagMembranes = 512u;     // some cut is a membrane
SHARED_CONST uint kFlagInlays = 1024u;       // some membrane is an inlay with what lies next to it
SHARED_CONST uint kFlagSheets = 2048u;       // some sheet is shown
SHARED_CONST uint kFlagHideFront = 4096u;    // of a scene with inlays, for pictures of its parts: what lies before them
SHARED_CONST uint kFlagHideInlay = 8192u;    // their images
SHARED_CONST uint kFlagHideBehind = 16384u;  // and what lies behind the first one
SHARED_CONST uint kFlagSpareDepths = 32768u;  // some spare ends at a depth
SHARED_CONST uint kFlagWalks = 65536u;        // some cut goes along rays by cutWalk()
SHARED_CONST uint kFlagCutGrid = 131072u;     // a grid says which cuts matter where
SHARED_CONST uint kFlagJoined = 262144u;        // some cut is joined to the one before it
SHARED_CONST uint kFlagTints = 524288u;         // some structure takes less of its own colour than others
SHARED_CONST uint kFlagOverlaps = 1048576u;     // where spares of joined cuts overlap they are marked
SHARED_CONST uint kFlagFinish = 2097152u;      // each sample is kept for the finish: kSampleImage
SHARED_CONST uint kFlagStructureLooks = 4194304u;  // structures say what their material looks like
SHARED_CONST uint kFlagFaces = 8388608u;  // some cut shows the data on its face
SHARED_CONST uint kFlagNoData = 16777216u;  // neither a volume nor labels are drawn
SHARED_CONST uint kFlagValueColors = 33554432u;  // the largest value shows in its colour of the transfer function
SHARED_CONST uint kFlagHides = 67108864u;  // some structure, or what has no label, is hidden
SHARED_CONST uint kFlagSpareClasses = 134217728u;  // there are two kinds of spared structures, see spareClasses
SHARED_CONST uint kFlagSolids = 268435456u;  // some structure is shown as an opaque surface
SHARED_CONST uint kFlagVeils = 536870912u;   // some structure is shown as a surface that one can look through
SHARED_CONST uint kFlagOneSpared = 1073741824u;  // cuts spare one structure only: spareClasses.z
SHARED_CONST uint kFlagSaysFaces = 2147483648u;  // whoever draws asks on which cut's face each pixel lies
SHARED_CONST uint kFlagLast = kFlagSaysFaces;
// Those of them that programs ask for as they run: next to nothing hangs on them, and one program does for both.
SHARED_CONST uint kSwitches = kFlagOrthographic | kFlagSkipEmpty | kFlagStopOpaque | kFlagJitter | kFlagHideFront | kFlagHideInlay | kFlagHideBehind | kFlagOverlaps | kFlagFinish | kFlagValueColors;

/// Scene-local frame: world minus an origin near the scene, so that floats are enough anywhere. Lengths are in scene
/// units. "Table" positions 0..1 run over the transfer table's domain of data values. Members lie in groups of 16
/// bytes: a mat4's columns, a vec4 (a vector: its w means nothing), two vec2 or four scalars.
struct FrameParams {
  mat4 texFromScene;    ///< volume texture coordinates 0..1
  mat4 sceneFromTex;    ///< the way back
  mat4 labelFromScene;  ///< label voxel indices
  vec4 labelSize;       ///< label voxels x, y, z
  vec4 sharesBeyond;    ///< what shareTexture would hold beyond the labels' grid
  mat4 clipFromScene;   ///< for what is rasterised; same rays
  vec4 eye;             ///< perspective: the eye; orthographic: middle of the picture plane
  vec4 right;           ///< from the middle of the picture to its right edge, at distance 1 (orthographic: a length)
  vec4 up;              ///< to its top edge
  vec4 forward;         ///< unit
  vec4 volumeSize;      ///< voxels x, y, z of the volume
  vec4 storeSize;       ///< texels x, y, z of the texture that holds them
  vec4 pageGrid;        ///< of a streamed volume: pages x, y, z; w: the row of their table in which they begin
  vec4 pagesPerTex;     ///< place among the pages = texture coordinates * pagesPerTex + firstPage
  vec4 firstPage;
  vec4 cellGrid;        ///< cells x, y, z
  vec4 cellsPerTex;     ///< cells in a unit of texture coordinates
  vec4 lightGrid;       ///< cells x, y, z of the light grid
  vec4 normalX;         ///< rows of the matrix from differences of texels over two voxels to value per length, scene
  vec4 normalY;
  vec4 normalZ;
  vec4 keyLight;     ///< unit, towards the key light, scene frame
  vec4 pictureUp;    ///< unit
  vec4 planes[kMostPlanes];  ///< with PLANES, all cuts: rows of localFromScene that give z
  ivec4 spareClasses;        ///< x, y: bits of the cuts that spare structures of the first class, and of the second; z: the only one
  ivec4 planeBits;           ///< a bit each: x: those that are joined to the one before; y: those that remove the other side
  vec4 coarsening;  ///< of bricks: x: depth from which they hold voxels twice as large, and again at each doubling, y: how often
  vec2 pictureSize;  ///< of the whole picture, pixels
  vec2 subpixel;     ///< place of the sample, from the middle of its pixel

  float step;             ///< length of ray between two samples
  float opaqueAlpha;      ///< a ray ends where it is as opaque as this
  float isoValue;         ///< table position
  float noise;            ///< of this sample of the picture, 0..1; is added to each pixel's own
  float voxelsPerLength;  ///< reciprocal of the smallest spacing
  float tablePerTexel;    ///< table position = texel * tablePerTexel + tableOffset
  float tableOffset;
  float tablePerValue;       ///< per unit of data values
  float extinctionUnit;      ///< extinction, 1/length, of one unit of the running sums
  float shownFrom;           ///< first table entry with any extinction
  float shownTo;             ///< one past the last
  float gradientUnit;        ///< texel difference of a gradient texel's full length
  float gradientTableScale;  ///< reciprocal of the largest gradient in its table, data values per length
  float greyScale;           ///< grey 0..1 = table position * greyScale + greyOffset
  float greyOffset;
  float labelTint;          ///< 0..1, how much of a structure's colour its material takes
  float unlabelledOpacity;  ///< factor of what no structure owns
  float ambient;
  float diffuse;
  float specular;
  float shininess;
  float shadowStrength;     ///< 0..1
  float occlusionStrength;  ///< 0..1
  float lightCell;          ///< edge of a cell of the light grid
  int cutCount;
  int structureCount;  ///< rows of structures
  int sampleIndex;     ///< which sample of the picture, from 0
  uint flags;          ///< kFlag*
};

// What becomes of a structure, see StructureSets.
SHARED_CONST int kSetShown = 1;
SHARED_CONST int kSetSparedFirst = 2;  // by cuts of the first class
SHARED_CONST int kSetSparedSecond = 4;
SHARED_CONST int kSetSpared = kSetSparedFirst | kSetSparedSecond;
SHARED_CONST int kSetSolid = 8 | 16;

/// One structure: index by label id.
struct StructureRow {
  vec4 color;  ///< rgb, a: opacity factor (0 when not visible)
  vec4 look;   ///< x: factor on labelTint; y: 1: shown as a surface; z: kSet*
};

SHARED_END
#endif
