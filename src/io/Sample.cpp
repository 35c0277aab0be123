#include "velum/io/Sample.h"

#include <array>

#include <fmt/format.h>

#include "samples/Phantom.h"

namespace velum::io {

namespace {

struct Maker {
  SampleInfo info;
  int defaultSize;
  Sample (*make)(int size, Progress& progress);
};

constexpr Maker kMakers[] = {
    {{"two-spheres", "Two spheres on either side of a slice, for membrane clipping"}, 128, makeTwoSpheres},
    {{"vessels", "Arterial and venous tree of an organ, angiography"}, 256, makeVessels},
    {{"torso", "Contrast-enhanced CT of a human trunk, Hounsfield units"}, 256, makeTorso},
    {{"seismic", "Folded and faulted strata with a salt dome, reflection seismics"}, 256, makeSeismic},
    {{"neurons", "Branching nerve cells with spines, ultramicroscopy"}, 256, makeNeurons},
    {{"ultrasound", "A fetus in the womb under a fan-shaped probe, with speckle and shadows"}, 256, makeUltrasound},
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

Sample makeSample(std::string_view name, int size, Progress& progress) {
  if (size != 0 && (size < 16 || size > 1024))
    throw ArgumentError(
        fmt::format("a sample of size {} cannot be made; choose 16 to 1024, or 0 for its default", size));
  for (const auto& maker : kMakers)
    if (maker.info.name == name) return maker.make(size ? size : maker.defaultSize, progress);
  throw ArgumentError(fmt::format("there is no sample '{}'; choose one of {}", name, knownNames()));
}

}  // namespace velum::io
