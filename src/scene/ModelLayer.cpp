#include "velum/scene/ModelLayer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace velum::scene {

namespace {

/// Lightness 0..1, chroma, hue in degrees, of Oklab [OKLAB], in which steps look alike whatever the hue.
struct Tone {
  double lightness, chroma, hueDeg;
};

glm::vec3 colorOf(const Tone& tone) {
  double hue = glm::radians(tone.hueDeg);
  glm::dvec3 lab(tone.lightness, tone.chroma * std::cos(hue), tone.chroma * std::sin(hue));
  glm::dvec3 roots(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z,
                   lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z,
                   lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
  glm::dvec3 cones = roots * roots * roots;
  glm::dvec3 linear(4.0767416621 * cones.x - 3.3077115913 * cones.y + 0.2309699292 * cones.z,
                    -1.2684380046 * cones.x + 2.6097574011 * cones.y - 0.3413193965 * cones.z,
                    -0.0041960863 * cones.x - 0.7034186147 * cones.y + 1.7076147010 * cones.z);
  glm::vec3 out;
  for (int i = 0; i < 3; ++i) {
    double c = std::clamp(linear[i], 0.0, 1.0);
    out[i] = float(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055);
  }
  return out;
}

// Calm, and far enough from each other for who sees red and green alike: neighbours differ in lightness, too.
constexpr Tone kFamilies[] = {{0.79, 0.075, 80},  {0.66, 0.125, 25},  {0.70, 0.085, 235}, {0.62, 0.105, 330},
                              {0.74, 0.085, 165}, {0.60, 0.095, 285}, {0.77, 0.105, 55},  {0.66, 0.075, 200},
                              {0.72, 0.090, 130}, {0.70, 0.095, 0},   {0.64, 0.085, 260}, {0.80, 0.075, 110}};
constexpr Tone kLipid{0.83, 0.040, 120}, kStrand{0.84, 0.120, 95}, kUnknown{0.72, 0.010, 80};

/// Types in the order of how much of the picture they may take.
std::vector<std::uint32_t> byVolume(const Model& model) {
  std::vector<std::uint32_t> order(model.types.size());
  std::iota(order.begin(), order.end(), 0u);
  auto volume = [&](std::uint32_t i) {
    const MoleculeType& type = model.types[i];
    return type.mass * type.instanceCount;
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return volume(a) > volume(b); });
  return order;
}

/// The same family for types that share a key, in the order in which they are met.
template <class Key>
class Families {
 public:
  struct Place {
    std::size_t family;  ///< from 0
    int member;          ///< from 0, in the family
  };
  Place add(const Key& key) {
    auto [found, isNew] = mPlaces.try_emplace(key, Place{mPlaces.size(), 0});
    Place place = found->second;
    ++found->second.member;
    return place;
  }

 private:
  std::map<Key, Place> mPlaces;
};

Tone familyTone(std::size_t family) {
  constexpr std::size_t kCount = std::size(kFamilies);
  Tone tone = kFamilies[family % kCount];
  // Later rounds are darker: better than the same once more.
  tone.lightness -= 0.09 * double(family / kCount % 3);
  return tone;
}

/// A member of a family: beside the hue, lighter or darker, the further the later it comes.
Tone memberTone(Tone tone, int member) {
  if (member == 0) return tone;
  constexpr double kGolden = 0.6180339887498949;
  double turn = std::fmod(member * kGolden, 1.0) - 0.5, lift = std::fmod(member * kGolden * kGolden + 0.31, 1.0) - 0.5;
  return {std::clamp(tone.lightness + 0.17 * lift, 0.45, 0.88), tone.chroma * (1.0 - 0.25 * lift),
          tone.hueDeg + 42.0 * turn};
}

/// A part of a compartment that only says where in it something lies.
bool isPlain(const std::string& name) {
  return name == "surface" || name == "interior" || name == "proteins" || name == "lipids";
}

std::uint32_t familyCompartment(const Model& model, std::uint32_t compartment) {
  while (model.compartments[compartment].parent > 0 && isPlain(model.compartments[compartment].name))
    compartment = std::uint32_t(model.compartments[compartment].parent);
  return compartment;
}

std::vector<Tone> tonesOf(const Model& model, Palette palette) {
  std::vector<Tone> tones(model.types.size(), kUnknown);
  Families<std::uint32_t> compartments;
  Families<std::string> functions;
  for (std::uint32_t i : byVolume(model)) {
    const MoleculeType& type = model.types[i];
    if (palette == Palette::Function) {
      if (!type.function.empty()) tones[i] = familyTone(functions.add(type.function).family);
      continue;
    }
    auto place = compartments.add(familyCompartment(model, type.compartment));
    if (palette == Palette::Compartment) {
      tones[i] = familyTone(place.family);
    } else {
      bool isLipid = type.kind == MoleculeKind::Lipid, isStrand = type.kind == MoleculeKind::NucleicAcid;
      tones[i] = isLipid ? kLipid : isStrand ? kStrand : memberTone(familyTone(place.family), place.member);
    }
  }
  return tones;
}

}  // namespace

std::vector<glm::vec3> typeColors(const ModelLayer& layer) {
  if (!layer.data) return {};
  const Model& model = *layer.data;
  std::vector<glm::vec3> colors;
  for (const Tone& tone : tonesOf(model, layer.palette)) colors.push_back(colorOf(tone));
  if (layer.types.empty()) return colors;
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (auto look = typeLook(layer, pathOf(model, model.types[i])); look.color) colors[i] = *look.color;
  return colors;
}

bool hasGhosts(const ModelLayer& layer) {
  if (layer.ghostOpacity <= 0.0) return false;
  auto shows = [&](const TypeLook& look) { return look.visible && ghostsOf(layer, look) != Ghosts::None; };
  return layer.ghosts != Ghosts::None || std::any_of(layer.types.begin(), layer.types.end(), shows);
}

TypeLook typeLook(const ModelLayer& layer, std::string_view path) {
  auto found =
      std::find_if(layer.types.begin(), layer.types.end(), [&](const TypeLook& look) { return look.type == path; });
  if (found != layer.types.end()) return *found;
  TypeLook look;
  look.type = path;
  return look;
}

CopyGrid copyGrid(const ModelLayer& layer) {
  CopyGrid grid;
  if (!layer.data) return grid;
  int copies = std::clamp(layer.copies, 1, kMostCopies);
  int edge = 1;
  while (edge * edge * edge < copies) ++edge;
  grid.counts.x = edge;
  grid.counts.y = std::min(edge, (copies + edge - 1) / edge);
  grid.counts.z = (copies + edge * grid.counts.y - 1) / (edge * grid.counts.y);
  grid.step = glm::dvec3(layer.data->high) - glm::dvec3(layer.data->low);
  return grid;
}

ModelBox modelBox(const ModelLayer& layer) {
  if (!layer.data) return {};
  CopyGrid grid = copyGrid(layer);
  glm::dvec3 low(layer.data->low), high(layer.data->high);
  return {low, high + grid.step * glm::dvec3(glm::max(grid.counts - 1, 0))};
}

}  // namespace velum::scene
