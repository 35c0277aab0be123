#include "gui/view/LetteringOverlay.h"

#include <QElapsedTimer>
#include <QImage>
#include <algorithm>

#include "gui/kit/Text.h"

namespace velum::gui {

namespace {

constexpr double kLeastLetters = 12.0;  // of marks in small views, pixels
constexpr qint64 kSettleMs = 25;
constexpr int kMostSteps = 120;  // until names have gone to new places

void paintBlocks(QPainter& painter, const std::vector<session::LetteringBlock>& blocks, glm::ivec2 size, double ratio) {
  for (const session::LetteringBlock& block : blocks) {
    vector::Raster raster = session::stampOf(block, size);
    QImage image(raster.rgba.data(), raster.size.x, raster.size.y, 4 * raster.size.x,
                 QImage::Format_RGBA8888_Premultiplied);
    image.setDevicePixelRatio(ratio);
    painter.drawImage(QPointF(raster.corner.x, raster.corner.y) / ratio, image);
  }
}

/// The space of a view in pixels of the screen.
session::ViewSpace finer(const session::ViewSpace& space, glm::dvec2 size, double ratio) {
  if (!space.section()) return {space.camera(), size};
  scene::SectionPlane plane = *space.section();
  plane.size = size;
  plane.lengthPerPixel /= ratio;
  return session::ViewSpace(plane);
}

}  // namespace

bool LetteringOverlay::count() {
  const scene::Scene& scene = mDocument.shown();
  bool hasLegend = scene.lettering.legend && scene.model.data, hasNames = session::needsSeenNames(scene.lettering);
  if (!hasLegend && !hasNames) return false;
  Viewport::PixelIds picture = mViewport.idsOfPixels();
  if (picture.structures.empty()) return false;
  std::vector<QString> before = names();
  if (hasLegend) {
    mPixels = session::countPixels(picture.types, scene.model.data->types.size());
    mModel = scene.model.data;
  }
  if (!hasNames) return names() != before;
  mSeen = session::seenNames(scene, {picture.size, picture.structures, picture.types, 1},
                             mSize == picture.size ? namesFrom(mViewport.space()) : session::SeenNames());
  mSize = picture.size;
  keepAnchors();
  settleNames();
  return true;
}

/// Places in the world, by which names follow a camera that moves.
void LetteringOverlay::keepAnchors() {
  mAnchors.clear();
  glm::dvec2 pixel = mViewport.space().size() / glm::dvec2(mSize);
  auto keep = [&](const session::SeenName& name) {
    glm::dvec2 at = name.anchor * pixel;
    auto pick = mViewport.pickAt({at.x, at.y});
    mAnchors.push_back(pick && pick->hit ? pick->world : mDocument.shown().camera.target);
  };
  for (const session::SeenName& name : mSeen.names) keep(name);
  for (const auto& [mark, name] : mSeen.marks) keep(name);
}

/// The names of the last complete picture, where a space shows them now.
session::SeenNames LetteringOverlay::namesFrom(const session::ViewSpace& space) const {
  session::SeenNames seen = mSeen;
  session::ViewSpace own(space.camera(), glm::dvec2(mSize));
  std::size_t place = 0;
  auto follow = [&](session::SeenName& name) {
    if (auto at = own.pixelFromWorld(mAnchors[place++])) name.anchor = *at;
  };
  for (session::SeenName& name : seen.names) follow(name);
  for (auto& [mark, name] : seen.marks) follow(name);
  return seen;
}

/// Lets names go from their places before to those of the new picture, until none moves any more.
void LetteringOverlay::settleNames() {
  session::Seen seen{pixels(), mMeasured, mSeen};
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < kMostSteps; ++i) {
    if (clock.elapsed() > kSettleMs) break;
    std::vector<session::NamePlace> before = mPlaces;
    seen.namesBefore = before.empty() ? nullptr : &before;
    mPlaces = session::layLettering(mDocument.shown(), mSize, seen).names;
    bool isStill = std::ranges::equal(before, mPlaces, [](const auto& a, const auto& b) {
      return a.key == b.key && a.block.low == b.block.low && a.strength == b.strength;
    });
    if (isStill) return;
  }
  // Too far to go: as in a picture of its own.
  seen.namesBefore = nullptr;
  mPlaces = session::layLettering(mDocument.shown(), mSize, seen).names;
}

std::span<const session::PlacedWords> LetteringOverlay::words(const ToolView& view) const {
  auto found = mWords.find(&view);
  return found == mWords.end() ? std::span<const session::PlacedWords>() : found->second;
}

const session::TypePixels& LetteringOverlay::pixels() const {
  static const session::TypePixels kUnknown;
  return mDocument.shown().model.data == mModel ? mPixels : kUnknown;
}

std::vector<QString> LetteringOverlay::names() const {
  std::vector<QString> names;
  if (!mDocument.shown().lettering.legend) return names;
  for (const session::LegendEntry& entry : session::legendEntries(mDocument.shown(), pixels()))
    names.push_back(toText(entry.name));
  return names;
}

void LetteringOverlay::paint(ViewPainter& over) const {
  double ratio = over.painter.device()->devicePixelRatioF();
  glm::ivec2 size(glm::round(glm::dvec2(over.size.width(), over.size.height()) * ratio));
  const scene::Scene& scene = mDocument.shown();
  session::Seen seen{pixels(), mMeasured, {}};
  seen.leastEm = kLeastLetters * ratio;
  session::LaidLettering laid;
  if (&over.view == &mViewport) {
    session::NamesBetween held;
    if (size == mSize && session::needsSeenNames(scene.lettering)) {
      // Words stay where they are while the camera moves, and point at what they name.
      seen.names = namesFrom(over.space);
      held.from = held.to = mPlaces;
      seen.between = &held;
    }
    laid = session::layLettering(scene, size, seen);
  } else {
    laid = session::layMarks(scene, finer(over.space, glm::dvec2(size), ratio), seen);
  }
  paintBlocks(over.painter, laid.blocks, size, ratio);
  for (session::PlacedWords& words : laid.words) words.low /= ratio, words.high /= ratio, words.at /= ratio;
  mWords[&over.view] = std::move(laid.words);
}

}  // namespace velum::gui
