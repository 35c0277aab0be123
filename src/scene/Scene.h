#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Mesh.h"
#include "core/Shared.h"
#include "core/SmoothLabels.h"
#include "core/Units.h"
#include "core/Volume.h"
#include "scene/Camera.h"
#include "scene/Cut.h"
#include "scene/Finish.h"
#include "scene/Growth.h"
#include "scene/Lettering.h"
#include "scene/Lighting.h"
#include "scene/ModelLayer.h"
#include "scene/RayCast.h"
#include "scene/Sections.h"
#include "scene/Source.h"
#include "scene/Structure.h"
#include "scene/Timeline.h"
#include "scene/TransferFunction.h"

namespace velum::scene {

/// A volume and how it is shown.
struct VolumeLayer {
  Source source;
  Shared<Volume> data;    ///< not saved: read from `source`; where `bodyOnly`, the body of `given`
  bool bodyOnly = false;  ///< all but the largest body, such as a scanner's table, is replaced by air
  Shared<Volume> given;   ///< not saved: the whole volume of `source`, where `data` has only its body
  bool visible = true;
  bool smooth = false;  ///< cubic between voxels, not linear: thick slices without stairs
  int timeStep = 0;     ///< 0..timeSteps-1
  /// 0..channels-1; colour volumes show their colours. The one that is edited where several are mixed
  int channel = 0;
  TransferFunction transfer;
  std::vector<ChannelLook> channels;  ///< one per channel where several are mixed; empty: `channel` by `transfer`
  double windowLevel = 0.0;           ///< middle of the grey window of sections and MIP, the volume's unit
  double windowWidth = 0.0;           ///< its width; 0: the whole range
  bool operator==(const VolumeLayer&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("source", o.source, FieldInfo{"", {}, "Where the volume comes from."});
    visit("bodyOnly", o.bodyOnly,
          FieldInfo{"", {}, "On: what is not part of the largest body, as the scanner's table, is left out."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the volume is not drawn."});
    visit("smooth", o.smooth, FieldInfo{"", {}, "Cubic between voxels, not linear: thick slices without stairs."});
    visit("timeStep", o.timeStep, FieldInfo{"", {0, 1e9}, "Time step."});
    visit("channel", o.channel, FieldInfo{"", {0, 1e9}, "Channel that is shown."});
    visit("transfer", o.transfer, FieldInfo{"", {}, "Colour and opacity by value."});
    visit("channels", o.channels, FieldInfo{"", {}, "Looks of the channels that are mixed; empty: one channel."});
    visit("windowLevel", o.windowLevel, FieldInfo{"", {}, "Middle of the grey window of sections and MIP."});
    visit("windowWidth", o.windowWidth, FieldInfo{"", {0, 1e300}, "Width of the grey window; 0: the whole range."});
  }
};

/// Most growing steps in a scene.
constexpr std::size_t kMostGrowths = 4096;

/// Labelled structures beside the volume (same grid or another, overlaid by world position), or alone.
struct LabelLayer {
  Source source;
  Shared<LabelVolume> data;        ///< not saved: `given` with the growths that are in `grown`
  std::vector<Growth> growths;     ///< what was grown out of the volume on demand, in its order
  Shared<LabelVolume> given;       ///< not saved: `unsmoothed` with the shapes in `smoothed`, where there are growths
  Shared<LabelVolume> unsmoothed;  ///< not saved: what `source` holds, where structures are smoothed
  std::vector<ShapeSmoothing> smoothed;  ///< not saved: the smoothing by which `given` was made from `unsmoothed`
  std::vector<Growth> grown;  ///< not saved: the growths that `data` holds, of its time step; others are on their way
  bool visible = true;
  double tint = 1.0;        ///< how far structures take their own colour rather than the transfer function's, 0..1
  double unlabelled = 1.0;  ///< factor on the opacity of what has no label, 0..1
  std::vector<Structure> structures;  ///< ascending by id; filled from the data's table where empty
  bool operator==(const LabelLayer&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("source", o.source, FieldInfo{"", {}, "Where the labels come from."});
    visit("growths", o.growths,
          FieldInfo{"", {}, "What was grown out of the volume on demand, in its order.", true, false, kMostGrowths});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: labels change nothing."});
    visit("tint", o.tint, FieldInfo{"", {0, 1}, "How far structures take their own colour."});
    visit("unlabelled", o.unlabelled, FieldInfo{"", {0, 1}, "Factor on the opacity of what has no label."});
    visit("structures", o.structures, FieldInfo{"", {}, "Name, colour, opacity of each structure."});
  }
};

/// An opaque surface in the scene: an implant, a segmentation's mesh.
struct Surface {
  Source source;
  Shared<Mesh> data;      ///< not saved
  glm::vec3 color{0.8f};  ///< sRGB
  bool visible = true;
  bool operator==(const Surface&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("source", o.source, FieldInfo{"", {}, "Where the surface comes from."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour."});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: the surface is not drawn."});
  }
};

/// Everything that changes the picture or is saved.
struct Scene {
  LengthUnit unit = LengthUnit::Millimetre;  ///< of every length in the scene, and of the world in which its data lie
  VolumeLayer volume;
  LabelLayer labels;
  std::vector<Surface> surfaces;
  ModelLayer model;
  std::vector<Cut> cuts;
  Camera camera;
  Sections sections;
  RayCast rayCast;
  Lighting lighting;
  Background background;
  Finish finish;
  Lettering lettering;
  Timeline timeline;        ///< what changes in a film
  bool showBounds = false;  ///< thin outlines of the volume's box and of the cuts
  // Compiled once, in SceneCopies.cpp: nearly every file copies some.
  Scene();
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();
  bool operator==(const Scene&) const;
  static void fields(auto& o, auto& visit) {
    visit("unit", o.unit, FieldInfo{"", {}, "What lengths are in: mm, or angstrom for molecules."});
    visit("volume", o.volume, FieldInfo{"", {}, "The volume and how it is shown."});
    visit("labels", o.labels, FieldInfo{"", {}, "Labelled structures."});
    visit("surfaces", o.surfaces, FieldInfo{"", {}, "Opaque surfaces."});
    visit("model", o.model, FieldInfo{"", {}, "Molecules and where their instances stand.", true});
    visit("cuts", o.cuts, FieldInfo{"", {}, "What removes material, in order.", false, false, kMostCuts});
    visit("camera", o.camera, FieldInfo{"", {}, "Where the eye is."});
    visit("sections", o.sections, FieldInfo{"", {}, "The section views."});
    visit("rayCast", o.rayCast, FieldInfo{"", {}, "How rays are cast."});
    visit("lighting", o.lighting, FieldInfo{"", {}, "Light and shadow."});
    visit("background", o.background, FieldInfo{"", {}, "What is behind everything."});
    visit("finish", o.finish, FieldInfo{"", {}, "Contours, lit spheres, hatching, paper."});
    visit("lettering", o.lettering, FieldInfo{"", {}, "What is written over the picture.", true});
    visit("timeline", o.timeline, FieldInfo{"", {}, "What changes in a film, and when.", true});
    visit("showBounds", o.showBounds, FieldInfo{"", {}, "Thin outlines of the volume's box and of the cuts."});
  }
};

/// True when something is open that can be cut and seen.
bool hasData(const Scene& scene);

/// A box in the world.
inline ModelFrame modelFrame(const Scene& scene) {
  return {unitsPer(LengthUnit::Angstrom, scene.unit) * scene.model.enlargement, scene.model.offset};
}
/// modelBox() in the world, scene units.
inline ModelBox worldBoxOfModel(const Scene& scene) {
  ModelBox box = modelBox(scene.model);
  ModelFrame frame = modelFrame(scene);
  return {frame.worldOf(box.low), frame.worldOf(box.high)};
}

struct Bounds {
  glm::dvec3 min{0.0}, max{0.0};
};
/// The box around volume, labels, surfaces and model, hidden ones, too; {0,0} when the scene is empty.
Bounds computeBounds(const Scene& scene);

/// A camera that sees all of the scene from one of the patient's sides. Keeps projection and field of view.
/// @param aspect  width / height of the picture
Camera frameCamera(const Scene& scene, StandardView view, double aspect);

/// The side from which new data is first seen: from the front, where the patient's axes are known; on its face, where
/// it is a thin slab; else obliquely.
StandardView defaultView(const Scene& scene);

/// The cut with an id; null when the scene has none. The place of a cut in the list is for the order of rows only.
Cut* findCut(Scene& scene, int id);
const Cut* findCut(const Scene& scene, int id);
/// Index in the list of the cut with an id; -1 when the scene has none.
int cutPlace(const Scene& scene, int id);

/// A number that no cut of a scene has: one more than the largest.
int nextCutId(const Scene& scene);
/// Appends a cut under a new id, whatever id it had. @return the new id
int addCut(Scene& scene, Cut cut);
/// For scenes from outside: cuts and captions without an id of their own get one, cuts of shape Membrane and no others
/// a Cut::membrane, and keys of tracks come into the order of time.
void completeItems(Scene& scene);

/// The rigid transform from a cut's local frame, in which z is the cut's axis, to the world.
glm::dmat4 worldFromCut(const Cut& cut);

/// Adds a structure, with name and colour from the label data, for every id that the layer does not list yet.
void completeStructures(LabelLayer& labels);
/// Structure::fileId as a number; 0 where there is none.
std::uint64_t fileIdOf(const Structure& structure);

/// True when the volume's channels are mixed, each by its own look.
bool mixesChannels(const VolumeLayer& layer);

/// The transfer function that is edited: that of the current channel where several are mixed, else the layer's own.
TransferFunction& currentTransfer(VolumeLayer& layer);
const TransferFunction& currentTransfer(const VolumeLayer& layer);

/// The grey window in force (that of the current channel where several are mixed): level and width, the volume's unit.
glm::dvec2 effectiveWindow(const VolumeLayer& layer);
/// The grey window in force for one channel. @param look  of a channel of the layer
glm::dvec2 effectiveWindow(const VolumeLayer& layer, const ChannelLook& look);
/// Sets the window of the current channel, or of the layer.
void setWindow(VolumeLayer& layer, double level, double width);

/// True when the 3D picture shows grey values by the window: a maximum, or sections on the faces of cuts.
bool usesWindow(const Scene& scene);

/// A membrane reduced to what pictures of its sheet depend on: without what moves the sheet.
Membrane drawnMembrane(Membrane membrane);

/// The scene reduced to what the 3D picture depends on: without sections and names, without a window that it does not
/// use, and without what moves the sheets of membranes.
Scene pictureScene(Scene scene);

/// Puts the crosshair into the middle of the data where it has no place yet.
void placeSections(Scene& scene);

}  // namespace velum::scene
