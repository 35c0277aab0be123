// Where everything is bound: a texture unit, a uniform block and a storage block below kFirstLent are one thing's alone, while image
// units and the storage blocks from there on are lent to one dispatch at a time, which binds all of its own right before.
#ifndef VELUM_SHARED_BINDINGS_H
#define VELUM_SHARED_BINDINGS_H
#include "shared/types.h"
SHARED_BEGIN

// Uniform blocks.
SHARED_CONST uint kFrameBinding = 0u;
SHARED_CONST uint kFinishBinding = 1u;
SHARED_CONST uint kInstanceViewBinding = 2u;
SHARED_CONST uint kInstanceLightBinding = 3u;  // the light's view of them
SHARED_CONST uint kInstanceShadeBinding = 4u;
SHARED_CONST uint kFocusViewBinding = 5u;
SHARED_CONST uint kNoiseBinding = 6u;

// Samplers.
SHARED_CONST uint kVolumeUnit = 0u;
SHARED_CONST uint kLabelUnit = 1u;
SHARED_CONST uint kSkipUnit = 2u;
SHARED_CONST uint kLightUnit = 3u;
SHARED_CONST uint kLightExtinctionUnit = 9u;  // while the light grid is made
SHARED_CONST uint kSurfaceColorUnit = 5u;
SHARED_CONST uint kSurfaceAuxUnit = 6u;
SHARED_CONST uint kTransferUnit = 7u;
SHARED_CONST uint kExtinctionUnit = 8u;
SHARED_CONST uint kGradientUnit = 10u;
SHARED_CONST uint kSheetUnit = 11u;  // the rows of all sheets
SHARED_CONST uint kSurfaceIdUnit = 12u;
SHARED_CONST uint kStructureUnit = 13u;
SHARED_CONST uint kShareUnit = 39u;
SHARED_CONST uint kCoverUnit = 40u;
SHARED_CONST uint kCoarseShareUnit = 41u;
SHARED_CONST uint kLabelPageUnit = 48u;  // of labels that lie in bricks: the slot of each
SHARED_CONST uint kPageUnit = 47u;  // of a streamed volume: where its slots lie, and the slot of each page

// Those of the finish.
SHARED_CONST uint kSampleUnit = 14u;     // what kSampleImage holds
SHARED_CONST uint kLitSphereUnit = 15u;  // the lit spheres of the scene, one below the other
SHARED_CONST uint kSphereOfUnit = 16u;   // by structure: which of them
SHARED_CONST uint kGroupOfUnit = 44u;    // by structure: the compartment of a model's type
SHARED_CONST uint kPaperUnit = 17u;
SHARED_CONST uint kStrokeUnit = 18u;    // directions and phases of strokes, a texel a cell
SHARED_CONST uint kOwnPaperUnit = 19u;  // the user's picture of paper

SHARED_CONST uint kSpareUnit = 20u;  // what cuts spare

// Instances: what is the same for all views of a model, as texels, which software drivers fetch faster than blocks.
SHARED_CONST uint kInstanceUnit = 22u;  // InstanceRow: two texels each
SHARED_CONST uint kMoleculeUnit = 23u;  // MoleculeRow: three texels each
SHARED_CONST uint kLevelUnit = 24u;     // LevelRow
SHARED_CONST uint kBallUnit = 25u;      // centre and radius, scene units, the molecule's frame
SHARED_CONST uint kBallKindUnit = 26u;  // element, chain; of the whole model type, in two bytes
SHARED_CONST uint kTypeUnit = 27u;      // TypeRow
SHARED_CONST uint kCutUnit = 37u;       // CutData: kCutTexels each
SHARED_CONST uint kTypeSpareUnit = 38u; // TypeSpareRow: two texels each, [types][cuts]
SHARED_CONST uint kOrderUnit = 42u;     // instances, bundle by bundle
SHARED_CONST uint kBundleUnit = 43u;    // the sphere around each bundle
SHARED_CONST uint kSlotUnit = 45u;      // of copies: shift from the first copy, bits of the copy's number
SHARED_CONST uint kSlottedUnit = 46u;   // a bit a copy: it has a slot
// And of a view.
SHARED_CONST uint kDrawUnit = 28u;      // DrawRow
SHARED_CONST uint kPyramidUnit = 29u;   // farthest depths
SHARED_CONST uint kDepthUnit = 30u;     // bits of the nearest depth of each pixel
SHARED_CONST uint kShadowUnit = 31u;    // the same as the light sees it
SHARED_CONST uint kOpenUnit = 21u;      // openness and light of pixels

// What a cut keeps in view: its mask and the seeds of distances in it; and what of the picture is looked through.
SHARED_CONST uint kMaskUnit = 32u;
SHARED_CONST uint kSeedUnit = 33u;
SHARED_CONST uint kPictureIdUnit = 34u;
SHARED_CONST uint kPictureSurfaceUnit = 35u;
SHARED_CONST uint kGhostUnit = 36u;  // the sum of ghosts, for the picture

// Storage blocks of a frame. OpenGL promises eight places to all blocks together.
SHARED_CONST uint kCutBinding = 0u;
SHARED_CONST uint kCellBinding = 1u;
SHARED_CONST uint kCutGridBinding = 2u;
SHARED_CONST uint kFirstLent = 3u;

// That of casting rays through a streamed volume.
SHARED_CONST uint kSeenPageBinding = 3u;

// Storage blocks of a view of instances.
SHARED_CONST uint kDepthBinding = 3u;
SHARED_CONST uint kOwnerBinding = 4u;  // instance of each pixel,
SHARED_CONST uint kBallBinding = 5u;   // and its ball
SHARED_CONST uint kSeenBinding = 6u;   // a bit an instance: seen last time
SHARED_CONST uint kCountBinding = 7u;  // of the lists of draws; then the dispatches that these make

// Those while it is found which may show.
SHARED_CONST uint kBundleBinding = 4u;  // bundles that may show,
SHARED_CONST uint kCopyBinding = 5u;    // and copies

// Those while it is found out what becomes of instances.
SHARED_CONST uint kStateBinding = 3u;  // bits of instances, also while they are culled
SHARED_CONST uint kMaskBinding = 4u;
SHARED_CONST uint kSeedBinding = 5u;
SHARED_CONST uint kReachBinding = 6u;  // the longest distance in the mask

// Those while a sheet is indexed.
SHARED_CONST uint kSheetBinding = 3u;        // its rows (SHARED_SHEET_BLOCK),
SHARED_CONST uint kSheetValuesBinding = 4u;  // the same as single floats,
SHARED_CONST uint kSheetCountsBinding = 5u;  // and a count a cell, then 1 when the lists had no room for all

// Images. The ray caster's are the Gbuffer's.
SHARED_CONST uint kColorImage = 0u;
SHARED_CONST uint kSurfaceImage = 1u;
SHARED_CONST uint kIdImage = 2u;
SHARED_CONST uint kSampleImage = 3u;   // of the sample that is cast, for the finish (render/sample.glsl)
SHARED_CONST uint kPictureImage = 1u;  // where that of colours becomes one to show
SHARED_CONST uint kFinishImage = 2u;   // sums of what the finish adds
SHARED_CONST uint kPaperImage = 0u;
SHARED_CONST uint kStrokeImage = 0u;
SHARED_CONST uint kDrawImage = 0u;  // the lists of draws while they are written: as texels, of which drivers take more than of a block
SHARED_CONST uint kPyramidImage = 0u;
SHARED_CONST uint kOpenImage = 0u;
SHARED_CONST uint kGhostImage = 0u;
SHARED_CONST uint kSurfaceColorImage = 0u;  // what surfaces are drawn into, for who adds to it
SHARED_CONST uint kSurfaceAuxImage = 1u;
SHARED_CONST uint kSurfaceIdImage = 2u;
SHARED_CONST uint kLightImage = 0u;  // a level of the light grid, or of its extinction

SHARED_END
#endif
