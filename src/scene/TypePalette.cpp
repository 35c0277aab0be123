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

/// A family of hues: of what is on a surface, or of what is within.
struct Family {
  Tone tone;
  bool isSurface;
};
// Few and calm, in the manner of painted plates of cells: what is on a surface is green, what is within is blue. Chosen
// so that any two, and what is named below, differ by 0.07 or more in Oklab for who sees red, green or blue not at all.
constexpr Family kFamilies[] = {{{0.690, 0.115, 128}, true}, {{0.560, 0.108, 271}, false},
                                {{0.616, 0.090, 21}, true},  {{0.480, 0.093, 318}, false},
                                {{0.810, 0.090, 205}, true}, {{0.710, 0.115, 355}, false},
                                {{0.526, 0.115, 54}, true},  {{0.716, 0.108, 228}, false}};
constexpr std::size_t kFamilyCount = std::size(kFamilies);
/// In which types take them where there is one compartment only: the strongest beside the calmest.
constexpr std::size_t kAlone[kFamilyCount] = {2, 0, 4, 1, 6, 3, 7, 5};
/// What all else swims in is pale and warm, so that it stands back.
constexpr Tone kMedium{0.80, 0.058, 68};
constexpr Tone kLipid{0.93, 0.035, 100}, kStrand{0.88, 0.14, 95}, kUnknown{0.72, 0.010, 80};

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

 private:
  std::map<Key, std::size_t> mNumbers;
};

/// @param number  of a family; later rounds are darker or lighter: better than the same once more
Tone familyTone(std::size_t number) {
  Tone tone = kFamilies[number % kFamilyCount].tone;
  std::size_t round = number / kFamilyCount;
  if (round % 2 == 1) tone.lightness += tone.lightness > 0.62 ? -0.13 : 0.13;
  if (round % 4 > 1) tone.chroma *= 0.5;
  return tone;
}

Tone aloneTone(std::size_t number) {
  return familyTone(number / kFamilyCount * kFamilyCount + kAlone[number % kFamilyCount]);
}

/// 0, then -1/2, 1/4, -1/4, 1/8 ...: the first are as far apart as they can be, whatever comes later.
double spread(std::size_t number) {
  double place = 0.0, part = 0.5;
  for (; number > 0; number /= 2, part /= 2)
    if (number % 2) place += part;
  return place < 0.5 ? place : place - 1.0;
}

/// How far the members of a family are from each other.
struct Reach {
  double lightness, hueDeg;
};
constexpr Reach kFew{0.14, 52.0};   ///< of one or two families, to which all hues are left
constexpr Reach kMany{0.08, 36.0};  ///< of more
constexpr Reach kOfMedium{0.12, 100.0};
constexpr Reach kOfOneKind{0.06, 10.0};

/// One of a family: beside its hue, a step lighter and paler or darker and stronger; those of one kind by less.
Tone memberTone(Tone tone, const Reach& reach, std::size_t kind, std::size_t ofKind) {
  constexpr double kGolden = 0.6180339887498949;
  auto step = [](std::size_t n, double by) { return n == 0 ? 0.0 : std::fmod(double(n) * by, 1.0) - 0.5; };
  double lift = reach.lightness * step(kind, kGolden) + kOfOneKind.lightness * step(ofKind, kGolden);
  return {tone.lightness + lift, tone.chroma * (1.0 - lift),
          tone.hueDeg + reach.hueDeg * spread(kind) + kOfOneKind.hueDeg * step(ofKind, kGolden * kGolden)};
}

/// A part of a compartment that only says what is in it.
bool isPlain(const std::string& name) { return name == "interior" || name == "proteins" || name == "lipids"; }

/// The compartment whose family a type of another is of; the surface of one has a family of its own.
std::uint32_t familyCompartment(const Model& model, std::uint32_t compartment) {
  while (model.compartments[compartment].parent > 0 && isPlain(model.compartments[compartment].name))
    compartment = std::uint32_t(model.compartments[compartment].parent);
  return compartment;
}

std::size_t depthOf(const Model& model, std::uint32_t compartment) {
  std::size_t depth = 0;
  for (; model.compartments[compartment].parent >= 0; ++depth)
    compartment = std::uint32_t(model.compartments[compartment].parent);
  return depth;
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
    std::vector<std::uint32_t> compartments;
    for (std::uint32_t i : order) {
      std::uint32_t at = compartmentOf(i);
      bool isKnown = std::find(compartments.begin(), compartments.end(), at) != compartments.end();
      if (isOfFamily(model.types[i]) && !isMedium(model, at) && !isKnown) compartments.push_back(at);
    }
    // What is outside comes first, whatever there is most of.
    std::stable_sort(compartments.begin(), compartments.end(),
                     [&](auto a, auto b) { return depthOf(model, a) < depthOf(model, b); });
    for (std::uint32_t at : compartments) mFamilies[at] = freeFamily(model.compartments[at].name == "surface");
  }
  /// Of the next type in the order. @param isPlain  all of a family have its tone
  Tone next(std::uint32_t i, bool isPlain) {
    const MoleculeType& type = mModel.types[i];
    if (!isOfFamily(type)) return ofNoFamily(type.kind);
    std::uint32_t at = compartmentOf(i);
    bool isOfMedium = isMedium(mModel, at);
    Tone tone = isOfMedium ? kMedium : familyTone(mFamilies.at(at));
    if (isPlain) return tone;
    // What does the same looks alike.
    std::string does = type.function.empty() ? "=" + std::to_string(i) : type.function;
    std::size_t kind = mKinds[at].of(does), ofKind = mMembers[{at, kind}]++;
    if (isOfMedium) return memberTone(tone, kOfMedium, kind, ofKind);
    // One compartment alone: its types take the families.
    if (mFamilies.size() == 1) return memberTone(aloneTone(kind), kMany, 0, ofKind);
    return memberTone(tone, mFamilies.size() == 2 ? kFew : kMany, kind, ofKind);
  }
  /// Of a type that is in no family by what it is: the same in each palette.
  Tone ofNoFamily(MoleculeKind kind) {
    std::size_t number = mOthers[kind]++;
    if (kind == MoleculeKind::Lipid)
      return {kLipid.lightness - 0.02 * double(number % 2), kLipid.chroma, kLipid.hueDeg};
    auto step = double(number % 3);
    return {kStrand.lightness - 0.05 * step, kStrand.chroma, kStrand.hueDeg - 20.0 * step};
  }
  static bool isOfFamily(const MoleculeType& type) {
    return type.kind != MoleculeKind::Lipid && type.kind != MoleculeKind::NucleicAcid;
  }

 private:
  /// The first that is not taken of those on this side, else of all, else a later round.
  std::size_t freeFamily(bool isSurface) const {
    auto isTaken = [&](std::size_t number) {
      return std::any_of(mFamilies.begin(), mFamilies.end(), [&](const auto& one) { return one.second == number; });
    };
    for (std::size_t number = 0; number < kFamilyCount; ++number)
      if (kFamilies[number].isSurface == isSurface && !isTaken(number)) return number;
    std::size_t number = 0;
    while (isTaken(number)) ++number;
    return number;
  }
  std::uint32_t compartmentOf(std::uint32_t type) const {
    return familyCompartment(mModel, mModel.types[type].compartment);
  }

  const Model& mModel;
  std::map<std::uint32_t, std::size_t> mFamilies;        ///< numbers of those of compartments
  std::map<std::uint32_t, Numbers<std::string>> mKinds;  ///< of each compartment: what its types do
  std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> mMembers;
  std::map<MoleculeKind, std::size_t> mOthers;
};

std::vector<Tone> tonesOf(const Model& model, Palette palette) {
  std::vector<Tone> tones(model.types.size(), kUnknown);
  std::vector<std::uint32_t> order = byVolume(model);
  TypeFamilies families(model, order);
  Numbers<std::string> functions;
  for (std::uint32_t i : order) {
    const MoleculeType& type = model.types[i];
    if (palette != Palette::Function || !TypeFamilies::isOfFamily(type))
      tones[i] = families.next(i, palette == Palette::Compartment);
    else if (!type.function.empty())
      tones[i] = aloneTone(functions.of(type.function));
  }
  return tones;
}

}  // namespace

std::vector<glm::vec3> paletteColors(const Model& model, Palette palette) {
  std::vector<glm::vec3> colors;
  for (const Tone& tone : tonesOf(model, palette)) colors.push_back(colorOf(tone));
  return colors;
}

bool knowsFunctions(const Model& model) {
  return std::any_of(model.types.begin(), model.types.end(),
                     [](const MoleculeType& type) { return TypeFamilies::isOfFamily(type) && !type.function.empty(); });
}

}  // namespace velum::scene
