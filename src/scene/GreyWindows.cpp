#include "scene/GreyWindows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "scene/NamedTable.h"
#include "scene/Presets.h"

namespace velum::scene {

namespace {

/// Windows of one unit follow each other. Those of CT are the usual ones of radiology's textbooks.
constexpr GreyWindow kTable[] = {{"soft-tissue", "Soft tissue", "HU", 50, 350},
                                 {"abdomen", "Abdomen", "HU", 50, 400},
                                 {"lung", "Lung", "HU", -600, 1500},
                                 {"bone", "Bone", "HU", 400, 1800},
                                 {"brain", "Brain", "HU", 40, 80},
                                 {"angio", "Angiography", "HU", 300, 600},
                                 {"suv-5", "0 to 5", "SUVbw", 2.5, 5},
                                 {"suv-10", "0 to 10", "SUVbw", 5, 10},
                                 {"suv-20", "0 to 20", "SUVbw", 10, 20}};

const GreyWindow* find(std::string_view name) {
  auto found = std::find_if(std::begin(kTable), std::end(kTable), [&](const auto& row) { return row.name == name; });
  return found == std::end(kTable) ? nullptr : &*found;
}

/// How many values of a histogram lie from one to another.
double countBetween(const Histogram& histogram, double low, double high) {
  double width = (histogram.range.y - histogram.range.x) / double(histogram.counts.size()), count = 0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    double middle = histogram.range.x + width * (double(i) + 0.5);
    if (middle >= low && middle < high) count += double(histogram.counts[i]);
  }
  return count;
}

// Between CTs of an abdomen and a thorax (0.06 and 0.10; the phantom of a trunk 0.19) and an angiogram of a heart
// (0.27).
constexpr double kMuchContrast = 0.22;  ///< of what is denser than fat
constexpr double kLittleSoft = 0.25;    ///< of what is denser than air

glm::dvec2 firstOfCt(const Histogram& histogram) {
  constexpr double kAir = -500, kFat = -30, kBlood = 200, kMetal = 700, kAll = 1e9;
  double matter = countBetween(histogram, kAir, kAll), firm = countBetween(histogram, kFat, kAll);
  double soft = countBetween(histogram, -200, kBlood), contrast = countBetween(histogram, kBlood, kMetal),
         bone = countBetween(histogram, kMetal, kAll);
  const GreyWindow* row = find("abdomen");
  if (soft < kLittleSoft * matter)
    row = find("bone");
  else if (contrast > kMuchContrast * firm && bone < 0.2 * contrast)
    row = find("angio");
  return {row->level, row->width};
}

glm::dvec2 firstOfPet(const Histogram& histogram) {
  constexpr double kBright = 0.01;   // of the body: more than a bladder, less than a brain
  constexpr double kOverMean = 3.0;  // what is even shows as a grey, not as white
  double width = (histogram.range.y - histogram.range.x) / double(histogram.counts.size());
  auto valueOf = [&](std::size_t bin) { return histogram.range.x + width * (double(bin) + 0.5); };
  auto meanAbove = [&](double floor) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
      if (!(valueOf(i) > floor)) continue;
      sum += valueOf(i) * double(histogram.counts[i]);
      count += double(histogram.counts[i]);
    }
    return count > 0 ? sum / count : 0.0;
  };
  // Around the body there is next to nothing: what lies over half of the mean of all is body.
  double floor = 0.5 * meanAbove(0.0), high = kOverMean * meanAbove(floor);
  double body = countBetween(histogram, floor, 1e300), above = 0;
  std::size_t bright = histogram.counts.size();
  while (bright > 0 && above < kBright * body) above += double(histogram.counts[--bright]);
  if (bright < histogram.counts.size()) high = std::max(high, valueOf(bright));
  return {0.5 * high, high};
}

}  // namespace

std::span<const GreyWindow> greyWindows() { return kTable; }

std::span<const GreyWindow> greyWindowsFor(const Volume& volume) {
  std::string unit = volume.isColor ? std::string() : valueUnit(volume);
  auto isOf = [&](const GreyWindow& row) { return row.unit == unit; };
  auto first = std::find_if(std::begin(kTable), std::end(kTable), isOf);
  return {first, std::find_if_not(first, std::end(kTable), isOf)};
}

std::string valueUnit(const Volume& volume) {
  if (!volume.unit.empty()) return volume.unit;
  bool mayBeCt = volume.modality == Modality::CT || volume.modality == Modality::Unknown;
  bool isCt = mayBeCt && volume.range.x < -200 && choosePreset(volume) == "ct-bone";
  return isCt ? "HU" : "";
}

void applyGreyWindow(VolumeLayer& layer, std::string_view name) {
  const GreyWindow* row = find(name);
  if (!row) {
    std::vector<std::string> known;
    for (const GreyWindow& window : kTable) known.emplace_back(window.name);
    failNoName("window", name, known);
  }
  std::string unit = layer.data ? valueUnit(*layer.data) : std::string(row->unit);
  if (unit != row->unit)
    throw ArgumentError(fmt::format("the window '{}' is in {}, the values are {}; give level and width instead", name,
                                    row->unit, unit.empty() ? "of no known unit" : "in " + unit));
  setWindow(layer, row->level, row->width);
}

glm::dvec2 firstWindow(const Volume& volume) {
  if (volume.isColor || volume.channels > 1) return glm::dvec2(0.0);
  if (valueUnit(volume) == "HU") return firstOfCt(computeHistogram(volume));
  if (volume.modality == Modality::PET) return firstOfPet(computeHistogram(volume));
  return glm::dvec2(0.0);
}

}  // namespace velum::scene
