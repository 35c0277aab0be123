#include "session/film/FilmNames.h"

#include <algorithm>
#include <cmath>

#include "core/ImageChannels.h"
#include "scene/Project.h"
#include "scene/SectionPlane.h"

namespace velum::session {

namespace {

constexpr double kKeySeconds = 1.0;
constexpr int kKnownBefore = 3;     // key frames whose names a key frame knows
constexpr int kMostSettling = 200;  // steps until names have gone to their places
constexpr std::size_t kLooksKept = kKnownBefore + 3;

/// The place in the world that a pixel of a small picture shows. @param at  pixels of the film's picture
glm::dvec3 placeAt(const Image& image, int step, glm::dvec2 at) {
  glm::ivec2 pixel =
      glm::clamp(glm::ivec2(at / double(step)), glm::ivec2(0), glm::ivec2(image.width, image.height) - 1);
  int first = channelIndex(image, "position.X");
  const float* values =
      &image.pixels[(std::size_t(pixel.y) * std::size_t(image.width) + std::size_t(pixel.x)) * image.channels.size() +
                    std::size_t(first)];
  return {values[0], values[1], values[2]};
}

bool areAlike(const std::vector<NamePlace>& a, const std::vector<NamePlace>& b) {
  return std::ranges::equal(a, b, [](const NamePlace& x, const NamePlace& y) {
    return x.key == y.key && x.block.low == y.block.low && x.strength == y.strength;
  });
}

}  // namespace

FilmNames::FilmNames(const scene::FilmFrames& frames, glm::ivec2 size, int step,
                     std::optional<scene::SectionKind> section, LookAt lookAt)
    : mFrames(frames),
      mSize(size),
      mStep(step),
      mPeriod(std::max(1, int(std::lround(kKeySeconds * frames.framesPerSecond)))),
      mSection(section),
      mLookAt(std::move(lookAt)) {}

std::vector<NamePlace> FilmNames::placesIn(const scene::Scene& scene, const Seen& seen) const {
  return (mSection ? layLettering(scene, *mSection, mSize, seen) : layLettering(scene, mSize, seen)).names;
}

int FilmNames::frameOf(int key) const { return std::min(key * mPeriod, mFrames.count - 1); }

const FilmNames::Look& FilmNames::look(int key, Progress& progress) {
  auto known = mLooks.find(key);
  if (known != mLooks.end()) return known->second;
  while (mLooks.size() >= kLooksKept) mLooks.erase(mLooks.begin());
  return mLooks.emplace(key, mLookAt(frameOf(key), progress)).first->second;
}

/// @param before  the key frame before; null: the first that is known
FilmNames::Key FilmNames::keyAfter(int key, const Key* before, Progress& progress) {
  const Look& seen = look(key, progress);
  Key out;
  ImageMap small(seen.scene, seen.image, 1);
  SeenMap map = small.mapOfLarger(mStep);
  out.seen = seenNames(seen.scene, map, before ? before->seen : SeenNames());
  // As the frames have them: names stand where leaders and words of marks leave room.
  if (!mSection && needsSeenPlaces(seen.scene.lettering)) out.seen.places = seenPlaces(seen.scene, map);
  std::vector<NamePlace> places = before ? before->places : std::vector<NamePlace>();
  // With those before until nothing moves any more.
  for (int i = 0; i < (before ? kMostSettling : 1); ++i) {
    Seen all;
    all.names = out.seen;
    all.namesBefore = before ? &places : nullptr;
    std::vector<NamePlace> next = placesIn(seen.scene, all);
    bool isStill = areAlike(places, next);
    places = std::move(next);
    if (isStill) break;
  }
  for (const SeenName& name : out.seen.names) out.anchors[name.key] = placeAt(seen.image, mStep, name.anchor);
  for (const auto& [mark, name] : out.seen.marks) out.anchors[-1 - mark] = placeAt(seen.image, mStep, name.anchor);
  out.places = std::move(places);
  return out;
}

const FilmNames::Key& FilmNames::keyOf(int key, Progress& progress) {
  auto known = mKeys.find(key);
  if (known != mKeys.end()) return known->second;
  Key chain;
  for (int i = std::max(0, key - kKnownBefore), first = i; i <= key; ++i)
    chain = keyAfter(i, i == first ? nullptr : &chain, progress);
  while (mKeys.size() >= 2) mKeys.erase(mKeys.begin());
  return mKeys.emplace(key, std::move(chain)).first->second;
}

NamesBetween FilmNames::at(int frame, double share, const scene::Scene& scene, Progress& progress) {
  int first = frame / mPeriod;
  double way = (frame + share - frameOf(first)) / std::max(1, frameOf(first + 1) - frameOf(first));
  const Key from = keyOf(first, progress), to = keyOf(first + 1, progress);
  NamesBetween out{from.places, to.places, glm::smoothstep(0.0, 1.0, way), {}};
  ViewSpace space = mSection ? ViewSpace(scene::makeSectionPlane(scene, *mSection, glm::dvec2(mSize)))
                             : ViewSpace(scene.camera, glm::dvec2(mSize));
  // Where what was pointed at in the one and in the other frame is seen now.
  auto seenNow = [&](const Key& key, int name) {
    auto found = key.anchors.find(name);
    return found == key.anchors.end() ? std::nullopt : space.pixelFromWorld(found->second);
  };
  for (const Key* key : {&from, &to})
    for (SeenName name : key->seen.names) {
      if (std::ranges::find(out.near.names, name.key, &SeenName::key) != out.near.names.end()) continue;
      auto a = seenNow(from, name.key), b = seenNow(to, name.key);
      if (!a && !b) continue;
      name.anchor = a && b ? glm::mix(*a, *b, out.share) : a ? *a : *b;
      out.near.names.push_back(std::move(name));
    }
  return out;
}

}  // namespace velum::session
