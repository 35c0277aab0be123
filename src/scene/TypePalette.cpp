#include "scene/TypePalette.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "core/Color.h"

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
  for (int i = 0; i < 3; ++i) out[i] = float(srgbFromLinear(std::clamp(linear[i], 0.0, 1.0)));
  return out;
}

// Calm, and far enough from each other for who sees red and green alike: neighbours differ in lightness, too.
constexpr Tone kFamilies[] = {{0.71, 0.080, 190}, {0.62, 0.125, 355}, {0.67, 0.095, 248}, {0.73, 0.095, 145},
                              {0.60, 0.100, 300}, {0.68, 0.120, 35},  {0.78, 0.095, 85},  {0.66, 0.075, 215},
                              {0.72, 0.090, 125}, {0.70, 0.095, 10},  {0.64, 0.085, 270}, {0.80, 0.075, 105}};
/// What all else swims in is pale and warm, so that it stands back.
constexpr Tone kMedium{0.83, 0.074, 72};
constexpr Tone kLipid{0.88, 0.045, 108}, kStrand{0.84, 0.120, 92}, kUnknown{0.72, 0.010, 80};

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

/// Numbers from 0 for keys, in the order in which they are met.
template <class Key>
class Numbers {
 public:
  std::size_t of(const Key& key) { return mNumbers.try_emplace(key, mNumbers.size()).first->second; }
  std::size_t count() const { return mNumbers.size(); }

 private:
  std::map<Key, std::size_t> mNumbers;
};

Tone familyTone(std::size_t family) {
  constexpr std::size_t kCount = std::size(kFamilies);
  Tone tone = kFamilies[family % kCount];
  // Later rounds are darker: better than the same once more.
  tone.lightness -= 0.09 * double(family / kCount % 3);
  return tone;
}

/// 0, then -1/2, 1/4, -1/4, 1/8 ...: the first are as far apart as they can be, whatever comes later.
double spread(std::size_t number) {
  double place = 0.0, part = 0.5;
  for (; number > 0; number /= 2, part /= 2)
    if (number % 2) place += part;
  return place < 0.5 ? place : place - 1.0;
}

/// One of a family: beside its hue, lighter or darker.
/// @param hues  degrees that the family has
Tone memberTone(Tone tone, double hues, std::size_t kind, std::size_t ofKind) {
  constexpr double kGolden = 0.6180339887498949;
  auto step = [](std::size_t n, double by) { return n == 0 ? 0.0 : std::fmod(double(n) * by, 1.0) - 0.5; };
  double lift = step(kind, kGolden) + 0.6 * step(ofKind, kGolden);
  return {std::clamp(tone.lightness + 0.14 * lift, 0.45, 0.88), tone.chroma * (1.0 - 0.2 * lift),
          tone.hueDeg + hues * spread(kind) + 10.0 * step(ofKind, kGolden * kGolden)};
}

/// A part of a compartment that only says what is in it.
bool isPlain(const std::string& name) { return name == "interior" || name == "proteins" || name == "lipids"; }

/// @param bySurface  the surface of a compartment is one of its own
std::uint32_t familyCompartment(const Model& model, std::uint32_t compartment, bool bySurface) {
  auto isPart = [&](const std::string& name) { return isPlain(name) || (!bySurface && name == "surface"); };
  while (model.compartments[compartment].parent > 0 && isPart(model.compartments[compartment].name))
    compartment = std::uint32_t(model.compartments[compartment].parent);
  return compartment;
}

/// Whether a compartment is what others swim in: one that holds none beside one that does, such as plasma beside a
/// virus.
bool isMedium(const Model& model, std::uint32_t compartment) {
  auto hasParts = [&](std::size_t c) {
    return std::any_of(model.compartments.begin(), model.compartments.end(),
                       [c](const Compartment& other) { return other.parent == std::int32_t(c); });
  };
  if (model.compartments[compartment].parent != 0 || hasParts(compartment)) return false;
  for (std::size_t c = 1; c < model.compartments.size(); ++c)
    if (model.compartments[c].parent == 0 && hasParts(c)) return true;
  return false;
}

/// How the types of a model fall into families of hues.
class TypeFamilies {
 public:
  TypeFamilies(const Model& model, const std::vector<std::uint32_t>& order) : mModel(model) {
    for (std::uint32_t i : order) {
      if (!isOfFamily(model.types[i])) continue;
      std::uint32_t at = compartmentOf(i);
      if (!isMedium(model, at)) mFamilies.of(at);
    }
  }
  /// Of the next type in the order.
  Tone next(std::uint32_t i) {
    const MoleculeType& type = mModel.types[i];
    if (!isOfFamily(type)) return type.kind == MoleculeKind::Lipid ? kLipid : kStrand;
    std::uint32_t at = compartmentOf(i);
    // What does the same looks alike.
    std::string does = type.function.empty() ? "=" + std::to_string(i) : type.function;
    std::size_t kind = mKinds[at].of(does), ofKind = mMembers[{at, kind}]++;
    if (isMedium(mModel, at)) return memberTone(kMedium, 100.0, kind, ofKind);
    std::size_t count = mFamilies.count();
    double hues = std::clamp(300.0 / double(std::max<std::size_t>(count, 1)), 60.0, 150.0);
    if (count > 1) return memberTone(familyTone(mFamilies.of(at)), hues, kind, ofKind);
    // One compartment alone: its types take the families.
    Tone tone = familyTone(kind + 1);
    return ofKind == 0 ? tone : memberTone(tone, 0.0, 0, ofKind);
  }

 private:
  static bool isOfFamily(const MoleculeType& type) {
    return type.kind != MoleculeKind::Lipid && type.kind != MoleculeKind::NucleicAcid;
  }
  std::uint32_t compartmentOf(std::uint32_t type) const {
    return familyCompartment(mModel, mModel.types[type].compartment, true);
  }

  const Model& mModel;
  Numbers<std::uint32_t> mFamilies;
  std::map<std::uint32_t, Numbers<std::string>> mKinds;  ///< of each compartment: what its types do
  std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> mMembers;
};

std::vector<Tone> tonesOf(const Model& model, Palette palette) {
  std::vector<Tone> tones(model.types.size(), kUnknown);
  std::vector<std::uint32_t> order = byVolume(model);
  TypeFamilies families(model, order);
  Numbers<std::uint32_t> compartments;
  Numbers<std::string> functions;
  for (std::uint32_t i : order) {
    const MoleculeType& type = model.types[i];
    if (palette == Palette::Function) {
      if (!type.function.empty()) tones[i] = familyTone(functions.of(type.function));
    } else if (palette == Palette::Compartment) {
      std::uint32_t at = familyCompartment(model, type.compartment, false);
      tones[i] = isMedium(model, at) ? kMedium : familyTone(compartments.of(at));
    } else {
      tones[i] = families.next(i);
    }
  }
  return tones;
}

}  // namespace

std::vector<glm::vec3> paletteColors(const Model& model, Palette palette) {
  std::vector<glm::vec3> colors;
  for (const Tone& tone : tonesOf(model, palette)) colors.push_back(colorOf(tone));
  return colors;
}

}  // namespace velum::scene
