#include "velum/scene/Presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "velum/core/Error.h"

namespace velum::scene {

namespace {

/// The look behind a preset. Values as Preset says; opacities apply to `unit`: mm when absolute, voxels when relative.
struct Look {
  std::vector<ColorPoint> colors;
  std::vector<OpacityPoint> opacities;
  double unit = 1.0;
  double windowLevel = 0.5, windowWidth = 1.0;
  double specular = 0.25, occlusion = 0.7, shadow = 0.6, ambient = 0.35;
};

constexpr Preset kPresets[] = {
    {"ct-bone", "CT: bone", Modality::CT, true},
    {"ct-skin", "CT: skin", Modality::CT, true},
    {"ct-skin-bone", "CT: skin over bone", Modality::CT, true},
    {"ct-muscle", "CT: muscle and organs", Modality::CT, true},
    {"ct-lung", "CT: lung", Modality::CT, true},
    {"ct-vessels", "CT: contrast vessels and bone", Modality::CT, true},
    {"mr-head", "MR: head", Modality::MR, false},
    {"mr-brain", "MR: brain", Modality::MR, false},
    {"angiography", "Angiography: vessels", Modality::Angiography, false},
    {"ultrasound", "Ultrasound", Modality::Ultrasound, false},
    {"microscopy", "Ultramicroscopy: tissue", Modality::Microscopy, false},
    {"fluorescence", "Microscopy: bright structures", Modality::Microscopy, false},
    {"micro-ct", "Micro-CT: hard over soft", Modality::Unknown, false},
    {"seismic", "Seismic amplitudes", Modality::Seismic, false},
    {"seismic-velocity", "Seismic velocities", Modality::Seismic, false},
    {"grey", "First guess", Modality::Unknown, false},
};

const glm::vec3 kIvory(0.96f, 0.91f, 0.80f), kBone(0.98f, 0.95f, 0.88f), kSkin(0.90f, 0.70f, 0.58f),
    kFlesh(0.74f, 0.32f, 0.26f), kDark(0.42f, 0.12f, 0.10f), kFat(0.93f, 0.80f, 0.55f), kBlood(0.78f, 0.13f, 0.10f);

Look lookOf(std::string_view name) {
  Look look;
  if (name == "ct-bone") {
    look.colors = {{100, kDark}, {180, {0.76f, 0.52f, 0.36f}}, {320, kIvory}, {900, kBone}, {2000, {1, 1, 1}}};
    look.opacities = {{130, 0}, {220, 0.25}, {360, 0.75}, {700, 0.95}};
    look.windowLevel = 400, look.windowWidth = 1800;
  } else if (name == "ct-skin") {
    look.colors = {{-600, kSkin}, {120, kSkin}, {260, kIvory}, {1000, kBone}};
    look.opacities = {{-550, 0}, {-350, 0.55}, {-150, 0.9}, {3000, 0.95}};
    look.windowLevel = 40, look.windowWidth = 400, look.specular = 0.18;
  } else if (name == "ct-skin-bone") {
    look.colors = {{-600, kSkin}, {-100, kSkin}, {90, kFlesh}, {190, {0.80f, 0.58f, 0.42f}},
                   {320, kIvory}, {1200, kBone}};
    look.opacities = {{-560, 0}, {-420, 0.035}, {-250, 0.012}, {100, 0.006}, {170, 0.02}, {280, 0.5}, {500, 0.9}};
    look.windowLevel = 40, look.windowWidth = 400;
  } else if (name == "ct-muscle") {
    look.colors = {{-150, kFat},
                   {-60, kFat},
                   {-10, {0.85f, 0.55f, 0.42f}},
                   {35, kFlesh},
                   {90, {0.70f, 0.22f, 0.18f}},
                   {150, {0.86f, 0.48f, 0.36f}},
                   {260, kIvory},
                   {1000, kBone}};
    look.opacities = {{-30, 0}, {5, 0.12}, {40, 0.5}, {100, 0.75}, {300, 0.95}};
    look.windowLevel = 40, look.windowWidth = 350;
  } else if (name == "ct-lung") {
    look.colors = {{-950, {0.55f, 0.68f, 0.80f}},
                   {-750, {0.86f, 0.62f, 0.55f}},
                   {-400, {0.90f, 0.50f, 0.42f}},
                   {0, kFlesh},
                   {200, kIvory},
                   {900, kBone}};
    look.opacities = {{-960, 0},    {-880, 0.006}, {-760, 0.012}, {-600, 0.10}, {-400, 0.30},
                      {-250, 0.05}, {-200, 0.0},   {140, 0.0},    {260, 0.35},  {500, 0.8}};
    look.windowLevel = -500, look.windowWidth = 1500;
  } else if (name == "ct-vessels") {
    look.colors = {{80, kDark},   {150, kBlood}, {280, {0.87f, 0.25f, 0.16f}}, {420, {0.92f, 0.45f, 0.30f}},
                   {600, kIvory}, {1500, kBone}};
    look.opacities = {{110, 0}, {170, 0.10}, {240, 0.55}, {400, 0.85}, {800, 0.95}};
    look.windowLevel = 200, look.windowWidth = 700, look.specular = 0.4;
  } else if (name == "mr-head") {
    look.colors = {{0.05, kDark},
                   {0.2, {0.72f, 0.46f, 0.38f}},
                   {0.42, kSkin},
                   {0.62, {0.93f, 0.82f, 0.72f}},
                   {0.85, {0.98f, 0.93f, 0.84f}},
                   {1, {1, 1, 1}}};
    look.opacities = {{0.12, 0}, {0.2, 0.12}, {0.32, 0.5}, {0.6, 0.75}, {1, 0.85}};
  } else if (name == "mr-brain") {
    look.colors = {
        {0.1, kDark}, {0.35, {0.78f, 0.52f, 0.46f}}, {0.6, {0.92f, 0.76f, 0.68f}}, {0.85, {0.98f, 0.93f, 0.88f}}};
    look.opacities = {{0.30, 0}, {0.42, 0.35}, {0.6, 0.7}, {1, 0.9}};
  } else if (name == "angiography") {
    look.colors = {
        {0.1, {0.35f, 0.05f, 0.05f}}, {0.35, kBlood}, {0.65, {0.88f, 0.32f, 0.20f}}, {1, {1.0f, 0.80f, 0.62f}}};
    look.opacities = {{0.15, 0}, {0.28, 0.30}, {0.45, 0.8}, {1, 0.95}};
    look.specular = 0.45;
  } else if (name == "ultrasound") {
    look.colors = {{0.1, {0.16f, 0.10f, 0.08f}},
                   {0.4, {0.62f, 0.40f, 0.28f}},
                   {0.7, {0.90f, 0.72f, 0.54f}},
                   {1, {1.0f, 0.95f, 0.86f}}};
    look.opacities = {{0.18, 0}, {0.35, 0.04}, {0.6, 0.28}, {0.85, 0.7}, {1, 0.9}};
    look.specular = 0.12;
  } else if (name == "microscopy") {
    look.colors = {{0.02, {0.30f, 0.16f, 0.12f}},
                   {0.2, {0.70f, 0.42f, 0.30f}},
                   {0.5, {0.92f, 0.74f, 0.54f}},
                   {1, {1.0f, 0.97f, 0.90f}}};
    look.opacities = {{0.04, 0}, {0.12, 0.10}, {0.3, 0.45}, {1, 0.8}};
    look.specular = 0.2;
  } else if (name == "fluorescence") {
    look.colors = {{0.05, {0.02f, 0.08f, 0.20f}},
                   {0.3, {0.05f, 0.45f, 0.55f}},
                   {0.6, {0.35f, 0.85f, 0.55f}},
                   {1, {1.0f, 1.0f, 0.85f}}};
    look.opacities = {{0.12, 0}, {0.3, 0.10}, {0.6, 0.6}, {1, 0.9}};
    look.specular = 0.3;
  } else if (name == "micro-ct") {
    look.colors = {
        {0.05, kDark}, {0.25, {0.76f, 0.50f, 0.40f}}, {0.45, {0.90f, 0.72f, 0.55f}}, {0.65, kIvory}, {1, {1, 1, 1}}};
    look.opacities = {{0.18, 0}, {0.28, 0.015}, {0.42, 0.04}, {0.55, 0.5}, {0.75, 0.9}};
  } else if (name == "seismic") {
    look.colors = {{0, {0.12f, 0.25f, 0.55f}},
                   {0.3, {0.45f, 0.62f, 0.80f}},
                   {0.5, {0.93f, 0.91f, 0.87f}},
                   {0.7, {0.85f, 0.50f, 0.32f}},
                   {1, {0.55f, 0.10f, 0.08f}}};
    look.opacities = {{0.0, 0.9}, {0.25, 0.55}, {0.42, 0.02}, {0.58, 0.02}, {0.75, 0.55}, {1.0, 0.9}};
    look.specular = 0.1;
  } else if (name == "seismic-velocity") {
    look.colors = {{0, {0.18f, 0.22f, 0.45f}},
                   {0.3, {0.25f, 0.55f, 0.60f}},
                   {0.55, {0.80f, 0.80f, 0.58f}},
                   {0.8, {0.86f, 0.52f, 0.30f}},
                   {1, {0.62f, 0.18f, 0.14f}}};
    look.opacities = {{0.0, 0.0}, {0.15, 0.03}, {0.45, 0.06}, {0.62, 0.3}, {0.8, 0.75}, {1, 0.9}};
    look.specular = 0.1;
  } else {
    look.colors = {
        {0.05, {0.25f, 0.20f, 0.20f}}, {0.3, {0.66f, 0.52f, 0.44f}}, {0.6, {0.90f, 0.82f, 0.70f}}, {1, {1, 1, 1}}};
    look.opacities = {{0.15, 0}, {0.3, 0.06}, {0.5, 0.4}, {0.8, 0.85}};
  }
  return look;
}

/// Where fractions 0 and 1 of a relative preset lie in this volume.
/// @param brightShare  share of what is not background that counts as fully bright
glm::dvec2 relativeRange(const Volume& volume, int channel, bool isSigned, double brightShare) {
  Histogram histogram = computeHistogram(volume, 4096, channel);
  if (isSigned) return {quantile(histogram, 0.004), quantile(histogram, 0.996)};
  // The background is the highest peak of the lower half; without a peak, the lowest hundredth.
  std::size_t half = histogram.counts.size() / 2;
  std::size_t peak =
      std::size_t(std::max_element(histogram.counts.begin(), histogram.counts.begin() + std::ptrdiff_t(half)) -
                  histogram.counts.begin());
  double width = (histogram.range.y - histogram.range.x) / double(histogram.counts.size());
  std::uint64_t total = 0;
  for (auto count : histogram.counts) total += count;
  double low = histogram.range.x + width * double(peak);
  if (double(histogram.counts[peak]) < 0.02 * double(total)) low = quantile(histogram, 0.01);
  // The bright end is that of what is not background, which may be a thousandth of all.
  std::uint64_t above = 0;
  std::size_t first = std::min(histogram.counts.size() - 1, peak + histogram.counts.size() / 50 + 1);
  for (std::size_t i = first; i < histogram.counts.size(); ++i) above += histogram.counts[i];
  double high = histogram.range.y;
  std::uint64_t seen = 0;
  for (std::size_t i = histogram.counts.size(); i-- > first;) {
    seen += histogram.counts[i];
    if (double(seen) >= brightShare * double(above)) {
      high = histogram.range.x + width * double(i + 1);
      break;
    }
  }
  if (!(high > low)) high = low + std::max(1e-6, histogram.range.y - histogram.range.x);
  return {low, high};
}

bool isSigned(std::string_view name) { return name == "seismic" || name == "seismic-velocity"; }

const Preset& findPreset(std::string_view name) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", preset.name);
  }
  throw ArgumentError(fmt::format("no preset '{}'; there are {}", name, known));
}

}  // namespace

std::span<const Preset> presets() { return kPresets; }

void applyPreset(Scene& scene, std::string_view name) {
  const Preset& preset = findPreset(name);
  Look look = lookOf(name);
  VolumeLayer& layer = scene.volume;
  glm::dvec2 range(0, 1);
  double unitMm = 1.0;
  if (layer.data && !preset.isAbsolute) {
    int channel = mixesChannels(layer) ? layer.channel : 0;
    range = relativeRange(*layer.data, channel, isSigned(name), name == "microscopy" ? 0.04 : 0.01);
    glm::dvec3 spacing = spacingMm(*layer.data);
    unitMm = (spacing.x + spacing.y + spacing.z) / 3.0;
  }
  auto place = [&](double value) { return preset.isAbsolute ? value : range.x + value * (range.y - range.x); };
  for (auto& point : look.colors) point.value = place(point.value);
  for (auto& point : look.opacities) point.value = place(point.value);
  currentTransfer(layer) = {std::string(name), look.colors, look.opacities, {}, look.unit * unitMm};
  setWindow(layer, place(look.windowLevel),
            preset.isAbsolute ? look.windowWidth : look.windowWidth * (range.y - range.x));
  if (mixesChannels(layer)) {
    ChannelLook& current = layer.channels[std::size_t(layer.channel)];
    colorChannel(current, current.color);
  }
  scene.lighting.specular = look.specular;
  scene.lighting.occlusion = look.occlusion;
  scene.lighting.shadow = look.shadow;
  scene.lighting.ambient = look.ambient;
}

void colorChannel(ChannelLook& look, glm::vec3 color) {
  look.color = color;
  auto& points = look.transfer.opacities;
  double low = points.empty() ? 0.0 : points.front().value, high = points.empty() ? 1.0 : points.back().value;
  // From its dark tone to itself: shape shows by shading, density by saturation.
  look.transfer.colors = {{low, color * 0.45f}, {high, color}};
}

void completeChannels(VolumeLayer& layer) {
  if (!layer.data || layer.data->isColor || layer.data->channels < 2) return layer.channels.clear();
  if (int(layer.channels.size()) == layer.data->channels) return;
  static const glm::vec3 kColors[] = {{0.25f, 0.85f, 0.35f}, {0.95f, 0.30f, 0.85f}, {0.25f, 0.75f, 1.0f},
                                      {1.0f, 0.80f, 0.20f},  {1.0f, 0.45f, 0.25f},  {0.85f, 0.85f, 0.85f}};
  const Volume& volume = *layer.data;
  glm::dvec3 spacing = spacingMm(volume);
  layer.channels.clear();
  for (int c = 0; c < volume.channels; ++c) {
    ChannelLook& look = layer.channels.emplace_back();
    look.name = std::size_t(c) < volume.channelNames.size() && !volume.channelNames[std::size_t(c)].empty()
                    ? volume.channelNames[std::size_t(c)]
                    : fmt::format("Channel {}", c + 1);
    glm::dvec2 range = relativeRange(volume, c, false, 0.01);
    auto place = [&](double share) { return range.x + share * (range.y - range.x); };
    look.transfer.opacities = {{place(0.12), 0}, {place(0.35), 0.02}, {place(0.7), 0.12}, {place(1.0), 0.4}};
    look.transfer.unitDistanceMm = (spacing.x + spacing.y + spacing.z) / 3.0;
    look.windowLevel = place(0.5);
    look.windowWidth = range.y - range.x;
    colorChannel(look, kColors[std::size_t(c) % std::size(kColors)]);
  }
}

std::string_view choosePreset(const Volume& volume) {
  switch (volume.modality) {
    case Modality::CT:
      return volume.range.x < -200 ? "ct-bone" : "micro-ct";
    case Modality::MR:
      return "mr-head";
    case Modality::Angiography:
      return "angiography";
    case Modality::Ultrasound:
      return "ultrasound";
    case Modality::Microscopy:
      return "microscopy";
    case Modality::Seismic:
      return volume.range.x < 0 ? "seismic" : "seismic-velocity";
    default:
      break;
  }
  // Optical sections: 16 bits without a sign, in files that know neither patient nor spacing.
  if (volume.type == SampleType::UInt16 && !volume.isOrientationKnown && volume.range.x >= 0 && volume.range.y > 4095)
    return "microscopy";
  // Hounsfield units give themselves away: much air at -1000 and nothing far below it.
  if (volume.range.x <= -900 && volume.range.x >= -4100 && volume.range.y > 300 && volume.range.y < 35000)
    return "ct-bone";
  if (volume.range.x < 0 && volume.range.y > 0 && -volume.range.x > 0.3 * volume.range.y) return "seismic";
  return "grey";
}

}  // namespace velum::scene
