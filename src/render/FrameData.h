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

/// Which texels a frame is drawn from.
struct VolumeKey {
  std::uint64_t id = 0;  ///< Of the volume; 0: none.
  int channel = 0, timeStep = 0;
  std::vector<scene::TransferFunction>
      mixed;  ///< Of the channels that are mixed, empty of hidden ones: they are in the texels.
  bool isSmooth = false;
  bool isQuick = false;  ///< The small copy.
  bool operator==(const VolumeKey&) const = default;
};
/// @param layer  its data may be missing or hidden
VolumeKey volumeKeyOf(const scene::VolumeLayer& layer);

/// Which labels a frame is drawn from, and over which grid of cells they are looked for.
struct LabelKey {
  std::uint64_t id = 0;
  LabelSpace over;
  bool operator==(const LabelKey&) const = default;
};

/// What is drawn besides the data for rays to stop at, and how far it reaches. Whatever draws more of it is asked for
/// in opaqueOf().
enum class Opaque { None, InBox, Anywhere };
Opaque opaqueOf(const scene::Scene& scene);
bool isDrawn(const scene::Surface& surface);
bool isModelDrawn(const scene::Scene& scene);
/// The number of a model's first instance: after the data and the surfaces. Pick::instance.
std::uint32_t firstModelInstance(const scene::Scene& scene);

/// All that the passes of one frame are told. Made of the frame before it is drawn, then only read; what is on the GPU
/// of it is the passes' and FrameInputs'.
struct FrameData {
  /// With its sizes filled in. Once completed, its lengths are in `unit`, as the grid's are: the data's diameter is 1,
  /// so that floats and what counts as near are the same for a virus and for a survey.
  Frame frame;
  double unit = 1.0;        ///< length of the scene frame's unit, in the scene's own
  bool isSoftware = false;  ///< the driver
  // Of the data that is on the GPU: UploadPass.
  const GpuVolume* volume = nullptr;  ///< nullptr: none is drawn.
  VolumeKey volumeKey;
  LabelUse labelUse = LabelUse::None;
  LabelKey labelKey;                       ///< id 0 where no labels are drawn.
  const LabelCells* labelCells = nullptr;  ///< nullptr where no labels are drawn.
  std::uint64_t labelCellsRevision = 0;    ///< Of the sets in them, see LabelUpload::cellsRevision().
  StructureSets sets;                      ///< Of what the shares are.
  FrameGrid grid;
  SheetPlans sheetPlans;
  SheetSources sheetSources;
  // What is worked out from it.
  TransferTable table;
  std::vector<shared::CutData> cuts;
  std::vector<shared::StructureRow> structures;
  SpareTable spares;
  shared::FrameParams params{};  ///< Of the first sample.
};

/// Length of an angstrom in a completed frame's unit.
double angstromOf(const FrameData& data);
/// What programs that read the data are compiled for.
DataVariant dataVariantOf(const FrameData& data);
/// Frame::windowSize and the like where the caller has left them open.
Frame withSizes(const Frame& frame);
/// Goes over to lengths of the data's size, and fills in what is worked out.
void completeFrameData(FrameData& data);

/// What all passes read of a frame, on the GPU: tables, cuts, structures, parameters. GL thread.
class FrameInputs {
 public:
  FrameInputs() : mParams("frame") {}
  void write(const FrameData& data);
  /// The parameters, for one sample of the picture.
  void writeParams(const FrameData& data, int sample);
  void bind() const;

 private:
  gpu::UniformBuffer<shared::FrameParams> mParams;
  void writeCuts(const FrameData& data);

  gpu::Buffer mTransfer, mExtinction, mCuts, mCutGrid, mStructures, mSpares;
  std::vector<shared::CutData> mGridCuts;  ///< What mCutGrid was made of,
  glm::mat4 mGridBox{0.0f};
  bool mGridHasSpares = false;
  gpu::Texture mCutTexels, mNoise, mTransferTexels, mExtinctionTexels, mStructureTexels, mSpareTexels;
};

}  // namespace velum::render
