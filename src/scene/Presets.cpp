#include "scene/Presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/ChannelHistogram.h"
#include "scene/ModelLooks.h"
#include "scene/PresetTable.h"

namespace velum::scene {

namespace {

/// Where fractions 0 and 1 of a relative preset lie in this volume.
/// @param brightShare  share of what is not background that counts as fully bright
glm::dvec2 relativeRange(const Volume& volume, int channel, Ends ends = Ends::Background, double brightShare = 0.01) {
  Histogram histogram = computeChannelHistogram(volume, channel);
  if (ends == Ends::BothTails) return {quantile(histogram, 0.004), quantile(histogram, 0.996)};
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

/// A CT whose values somebody has squeezed into bytes: air and fat are all 0, and a little of the rest is bone, far
/// above the many values of what is soft.
bool looksLikeByteCt(const Volume& volume) {
  if (volume.type != SampleType::UInt8 || volume.channels != 1 || !volume.isOrientationKnown) return false;
  Histogram histogram = computeHistogram(volume, 256);
  std::uint64_t total = 0, hard = 0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    total += histogram.counts[i];
    if (i >= 154) hard += histogram.counts[i];
  }
  double empty = double(histogram.counts[0]) / double(std::max<std::uint64_t>(total, 1));
  double share = double(hard) / std::max(1.0, double(total) * (1.0 - empty));
  return volume.range.x == 0 && empty > 0.5 && share > 0.003 && share < 0.35;
}

}  // namespace

bool isProjectionLook(std::string_view name) {
  const PresetRow* row = presetTable().find(name);
  return row && row->isProjection;
}

bool isAllMaterial(std::string_view preset) { return preset == "seismic" || preset == "seismic-velocity"; }

void applyPreset(Scene& scene, std::string_view name) {
  if (isModelLook(name)) return applyModelLook(scene, name);
  const PresetRow& row = presetTable().at(name);
  VolumeLayer& layer = scene.volume;
  glm::dvec2 range(0, 1);
  double unit = 1.0;
  if (layer.data && !row.preset.isAbsolute) {
    int channel = mixesChannels(layer) ? layer.channel : 0;
    range = relativeRange(*layer.data, channel, row.ends, row.brightShare);
    glm::dvec3 spacing = spacingOf(*layer.data);
    unit = (spacing.x + spacing.y + spacing.z) / 3.0;
  }
  auto place = [&](double value) { return row.preset.isAbsolute ? value : range.x + value * (range.y - range.x); };
  TransferFunction transfer{std::string(name), row.colors, row.opacities, {}, unit};
  for (auto& point : transfer.colors) point.value = place(point.value);
  for (auto& point : transfer.opacities) point.value = place(point.value);
  std::string previous = std::exchange(currentTransfer(layer), std::move(transfer)).preset;
  setWindow(layer, place(row.windowLevel),
            row.preset.isAbsolute ? row.windowWidth : row.windowWidth * (range.y - range.x));
  if (mixesChannels(layer)) {
    ChannelLook& current = layer.channels[std::size_t(layer.channel)];
    colorChannel(current, current.color);
  }
  // A projection's picture is another one than a look's in light, and lies on ground of its own.
  const PresetRow* before = presetTable().find(previous);
  if (row.isProjection) scene.rayCast.mode = RenderMode::Mip;
  if (row.background) scene.background.top = scene.background.bottom = *row.background;
  if (before && before->isProjection && !row.isProjection) scene.rayCast.mode = RenderMode::Volume;
  if (before && before->background && !row.background) {
    bool isTransparent = scene.background.transparent;
    scene.background = {};
    scene.background.transparent = isTransparent;
  }
  scene.lighting.specular = row.specular;
  scene.lighting.occlusion = 0.7;
  scene.lighting.shadow = 0.6;
  scene.lighting.ambient = 0.35;
}

void colorChannel(ChannelLook& look, glm::vec3 color) {
  look.color = color;
  auto& points = look.transfer.opacities;
  double low = points.empty() ? 0.0 : points.front().value, high = points.empty() ? 1.0 : points.back().value;
  // From its dark tone to itself: shape shows by shading, density by saturation.
  look.transfer.colors = {{low, color * 0.45f}, {high, color}};
}

std::optional<glm::dvec2> fileWindow(const Volume& volume, int channel) {
  if (std::size_t(channel) >= volume.channelWindows.size()) return std::nullopt;
  constexpr double kChosen = 0.9;  // of the range: programs write all of it, or of the type, where nobody chose
  glm::dvec2 window = volume.channelWindows[std::size_t(channel)] * volume.scale + volume.offset;
  if (window.x > window.y) std::swap(window.x, window.y);
  double range = volume.range.y - volume.range.x;
  double shared = std::min(window.y, volume.range.y) - std::max(window.x, volume.range.x);
  if (!(shared > 0.0) || shared >= kChosen * range) return std::nullopt;
  return window;
}

void completeChannels(VolumeLayer& layer) {
  if (!layer.data || layer.data->isColor || layer.data->channels < 2) return layer.channels.clear();
  if (int(layer.channels.size()) == layer.data->channels) return;
  static const glm::vec3 kColors[] = {{0.25f, 0.85f, 0.35f}, {0.95f, 0.30f, 0.85f}, {0.25f, 0.75f, 1.0f},
                                      {1.0f, 0.80f, 0.20f},  {1.0f, 0.45f, 0.25f},  {0.85f, 0.85f, 0.85f}};
  const Volume& volume = *layer.data;
  glm::dvec3 spacing = spacingOf(volume);
  layer.channels.clear();
  for (int c = 0; c < volume.channels; ++c) {
    ChannelLook& look = layer.channels.emplace_back();
    look.name = std::size_t(c) < volume.channelNames.size() && !volume.channelNames[std::size_t(c)].empty()
                    ? volume.channelNames[std::size_t(c)]
                    : fmt::format("Channel {}", c + 1);
    auto given = fileWindow(volume, c);
    glm::dvec2 range = given ? *given : relativeRange(volume, c);
    auto place = [&](double share) { return range.x + share * (range.y - range.x); };
    look.transfer.opacities = {{place(0.12), 0}, {place(0.35), 0.02}, {place(0.7), 0.12}, {place(1.0), 0.4}};
    look.transfer.unitDistance = (spacing.x + spacing.y + spacing.z) / 3.0;
    look.windowLevel = place(0.5);
    look.windowWidth = range.y - range.x;
    bool hasColor = std::size_t(c) < volume.channelColors.size();
    colorChannel(look, hasColor ? volume.channelColors[std::size_t(c)] : kColors[std::size_t(c) % std::size(kColors)]);
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
    case Modality::PET:
      return "pet-hot-metal";
    default:
      break;
  }
  if (looksLikeByteCt(volume)) return "ct8-bone";
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
