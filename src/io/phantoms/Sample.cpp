#include "io/phantoms/Sample.h"

#include <array>

#include <fmt/format.h>

#include "io/phantoms/Phantom.h"

namespace velum::io {

namespace {

struct Maker {
  SampleInfo info;
  int defaultSize;
  Sample (*make)(int size, Progress& progress);
  Sample (*makeTimeSteps)(int size, int frames, Progress& progress) = nullptr;        ///< Instead, where it moves.
  Sample (*makeOfContrast)(int size, double contrast, Progress& progress) = nullptr;  ///< Instead, where that is asked.
};

constexpr int kDefaultFrames = 12, kMostFrames = 100;
constexpr double kMostContrast = 20.0;

constexpr Maker kMakers[] = {
    {{"two-spheres", "Two spheres on either side of a slice, for membrane clipping"}, 128, makeTwoSpheres},
    {{"vessels", "Arterial and venous tree of an organ, angiography"}, 256, makeVessels},
    {{"torso", "Contrast-enhanced CT of a human trunk, Hounsfield units"}, 256, makeTorso},
    {{"skull", "CT of a head with its sinuses and teeth, Hounsfield units"}, 224, makeSkull},
    {{"hand", "CT angiography of a hand: each bone, tendons, vessels, Hounsfield units"}, 256, makeHand},
    {{"foot", "CT angiography of a foot with its ankle: each bone, tendons, vessels, Hounsfield units"}, 256, makeFoot},
    {{"lesion", "Lesion and artery that touch bone of the same values, CT, for region growing"}, 160, makeLesion},
    {{"seismic", "Folded and faulted strata with a salt dome, reflection seismics"}, 256, makeSeismic},
    {{"neurons", "Branching nerve cells with spines, ultramicroscopy"}, 256, makeNeurons},
    {{"fibres", "Noisy axons one to three voxels thick in bundles, light sheet"}, 300, nullptr, nullptr, makeFibres},
    {{"ultrasound", "A fetus in the womb under a fan-shaped probe, with speckle and shadows"}, 256, makeUltrasound},
    {{"heart", "A beat of a heart in contrast-enhanced CT, time steps; labels of the first one"},
     96,
     nullptr,
     makeHeart},
};

constexpr auto kInfos = [] {
  std::array<SampleInfo, std::size(kMakers)> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kMakers[i].info;
  return infos;
}();

std::string knownNames() {
  std::string names;
  for (const auto& info : kInfos) names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

}  // namespace

std::span<const SampleInfo> samples() { return kInfos; }

Sample makeSample(std::string_view name, int size, Progress& progress, int frames, double contrast) {
  if (size != 0 && (size < 16 || size > 1024))
    throw ArgumentError(
        fmt::format("a sample of size {} cannot be made; choose 16 to 1024, or 0 for its default", size));
  if (frames < 0 || frames > kMostFrames)
    throw ArgumentError(fmt::format("a sample of {} time steps cannot be made; choose 1 to {}, or 0 for its default",
                                    frames, kMostFrames));
  if (!(contrast >= 0.0 && contrast <= kMostContrast))
    throw ArgumentError(fmt::format("a sample of contrast {} cannot be made; choose up to {}, or 0 for its own",
                                    contrast, kMostContrast));
  for (const auto& maker : kMakers) {
    if (maker.info.name != name) continue;
    int voxels = size ? size : maker.defaultSize;
    if (maker.makeTimeSteps && contrast == 0.0)
      return maker.makeTimeSteps(voxels, frames ? frames : kDefaultFrames, progress);
    if (frames > 1 && !maker.makeTimeSteps)
      throw ArgumentError(fmt::format("{} time steps: the sample '{}' does not move", frames, name));
    if (maker.makeOfContrast) return maker.makeOfContrast(voxels, contrast, progress);
    if (contrast > 0.0) throw ArgumentError(fmt::format("contrast {}: the sample '{}' has its own", contrast, name));
    return maker.make(voxels, progress);
  }
  throw ArgumentError(fmt::format("there is no sample '{}'; choose one of {}", name, knownNames()));
}

}  // namespace velum::io
