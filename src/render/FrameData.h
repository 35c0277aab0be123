#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "render/FrameSetup.h"
#include "render/passes/Variants.h"
#include "render/upload/CutGrid.h"
#include "render/upload/CutSheets.h"
#include "render/upload/LabelCells.h"
#include "render/upload/SpareTable.h"
#include "render/upload/StructureSets.h"
#include "render/upload/TransferTable.h"

namespace velum::render {

class Residency;

/// Identifies the texels of a volume that a frame is drawn from.
struct VolumeKey {
  std::uint64_t id = 0;  ///< Id of the volume's payload; 0: no volume.
  int channel = 0, timeStep = 0;
  std::vector<scene::TransferFunction> mixed;  ///< Transfer functions of the channels that are mixed, as they are part
                                               ///< of the texels; those of hidden channels are empty.
  bool isSmooth = false;
  bool isQuick = false;   ///< It is the small copy for previews.
  double brickBytes = 0;  ///< Of a streamed volume: Frame::brickBytes.
  bool operator==(const VolumeKey&) const = default;
};
/// @param layer  the layer's data may be missing or hidden
VolumeKey volumeKeyOf(const scene::VolumeLayer& layer);

/// Identifies the labels that a frame is drawn from, and the grid of cells for which their sets are made.
struct LabelKey {
  std::uint64_t id = 0;
  LabelSpace over;
  bool operator==(const LabelKey&) const = default;
};

/// Whether opaque things that stop rays (surfaces, outlines, instances) are drawn besides the data, and whether they
/// reach beyond the data's box. Code that draws further opaque things must be taken into account in opaqueOf().
enum class Opaque { None, InBox, Anywhere };
Opaque opaqueOf(const scene::Scene& scene);
bool isDrawn(const scene::Surface& surface);
bool isModelDrawn(const scene::Scene& scene);

/// Everything that the passes of one frame get. Made from the Frame before it is drawn, then only read; the copies on
/// the GPU belong to the passes and to FrameInputs.
struct FrameData {
  /// The frame, with its sizes filled in. After completeFrameData() its lengths and those of `grid` are in `unit`: the
  /// data's diameter is 1, so that the precision of floats, and what counts as near, are the same for a virus and for a
  /// seismic survey.
  Frame frame;
  double unit = 1.0;        ///< length of the scene frame's unit, in the scene's own
  bool isSoftware = false;  ///< the driver is a software driver
  // Data on the GPU, filled in by UploadPass.
  const GpuVolume* volume = nullptr;  ///< nullptr: none is drawn.
  Residency* residency = nullptr;     ///< Of a volume that is streamed; else nullptr.
  VolumeKey volumeKey;
  LabelUse labelUse = LabelUse::None;
  bool hasLabelBricks = false;             ///< They lie in bricks (LabelBricks).
  LabelKey labelKey;                       ///< id 0 where no labels are drawn.
  const LabelCells* labelCells = nullptr;  ///< nullptr where no labels are drawn.
  std::uint64_t labelCellsRevision = 0;    ///< Revision of the sets in labelCells, see LabelUpload::cellsRevision().
  StructureSets sets;                      ///< The sets of structures whose shares are on the GPU.
  FrameGrid grid;
  SheetPlans sheetPlans;
  SheetSources sheetSources;
  // Tables and parameters computed from the members above.
  TransferTable table;
  std::vector<shared::CutData> cuts;
  std::vector<shared::StructureRow> structures;
  SpareTable spares;
  shared::FrameParams params{};  ///< Parameters of the first sample.
};

/// Length of an angstrom in a completed frame's unit.
double angstromOf(const FrameData& data);
/// Where the model's own origin lies in the scene frame.
glm::dvec3 modelOrigin(const FrameData& data);
/// The variant for which programs that read the frame's data are compiled.
DataVariant dataVariantOf(const FrameData& data);
/// The pixels of the window that data or anything opaque may be in: x, y: corner; z, w: size.
glm::ivec4 drawnRect(const FrameData& data);
/// Rays a pixel that a frame asks for.
int samplesOf(const Frame& frame);
/// The frame with Frame::windowSize and other sizes filled in where the caller has left them open.
Frame withSizes(const Frame& frame);
/// Turns lengths into the unit in which the data's diameter is 1, and fills in the computed members.
void completeFrameData(FrameData& data);

/// The inputs of a frame that all passes read, on the GPU: tables, cuts, structures, parameters. GL thread.
class FrameInputs {
 public:
  FrameInputs() : mParams("frame") {}
  void write(const FrameData& data);
  /// Writes the parameters for one sample of the picture.
  void writeParams(const FrameData& data, int sample);
  void bind() const;

 private:
  gpu::UniformBuffer<shared::FrameParams> mParams;
  void writeCuts(const FrameData& data);

  gpu::Buffer mTransfer, mExtinction, mCuts, mCutGrid, mStructures, mSpares, mNoise;
  std::vector<shared::CutData> mGridCuts;  ///< What mCutGrid was made from, with the next two.
  glm::mat4 mGridBox{0.0f};
  bool mGridHasSpares = false;
  gpu::Texture mCutTexels, mTransferTexels, mExtinctionTexels, mStructureTexels, mSpareTexels;
};

}  // namespace velum::render
