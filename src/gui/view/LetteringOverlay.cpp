#include "gui/view/LetteringOverlay.h"

#include <QImage>
#include <algorithm>

#include "gui/kit/Text.h"
#include "gui/view/SettleNames.h"
#include "session/mark/MarkHands.h"

namespace velum::gui {

namespace {

constexpr double kLeastLetters = 12.0;  // of marks in small views, pixels
constexpr qint64 kSettleMs = 25;
constexpr double kMostFurniture = 0.25;  // of a view: what is larger lies over all of it
constexpr double kHiddenShare = 0.05;    // of a mark: less cannot be read

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

/// What stands over a view and is no part of its picture, such as the cube and buttons: pixels of the screen.
std::vector<session::Rectangle> takenIn(ToolView& view, double ratio) {
  std::vector<session::Rectangle> taken;
  const QWidget& widget = view.widget();
  double whole = double(widget.width()) * widget.height();
  for (const QWidget* child : widget.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    QRect at = child->geometry();
    if (child->isVisible() && double(at.width()) * at.height() < kMostFurniture * whole)
      taken.push_back({ratio * glm::dvec2(at.left(), at.top()), ratio * glm::dvec2(at.right() + 1, at.bottom() + 1)});
  }
  return taken;
}

}  // namespace

bool LetteringOverlay::count(const scene::Scene& settled) {
  const scene::Scene& scene = mDocument.shown();
  bool hasLegend = scene.lettering.legend && scene.model.data, hasNames = session::needsSeenNames(scene.lettering),
       hasPlaces = session::needsSeenPlaces(scene.lettering);
  if (!hasNames && !hasPlaces) mSeen = {}, mAnchors.clear();
  if (!hasLegend && !hasNames && !hasPlaces) return false;
  Viewport::PixelIds picture = mViewport.idsOfPixels(hasPlaces);
  if (picture.structures.empty()) return false;
  std::vector<QString> before = names();
  if (hasLegend) {
    mPixels = session::countPixels(picture.types, scene.model.data->types.size());
    mModel = scene.model.data;
  }
  if (!hasNames && !hasPlaces) return names() != before;
  session::SeenMap map{picture.size, picture.structures, picture.types, 1, picture.instances, picture.distances};
  session::SeenNames old = mSize == picture.size ? namesFrom(mViewport.space()) : session::SeenNames();
  mSeen = hasNames ? session::seenNames(scene, map, old) : session::SeenNames();
  if (hasPlaces) mSeen.places = session::seenPlaces(settled, map);
  mSize = picture.size;
  keepAnchors();
  session::Seen seen{pixels(), mMeasured, mSeen};
  seen.taken = takenIn(mViewport, mViewport.devicePixelRatioF());
  if (hasNames)
    mPlaces = settledNames(std::move(mPlaces), std::move(seen), kSettleMs,
                           [&](const session::Seen& of) { return session::layLettering(scene, mSize, of); });
  return true;
}

/// Places in the world, by which names follow a camera that moves.
void LetteringOverlay::keepAnchors() {
  mAnchors.clear();
  glm::dvec2 pixel = mViewport.space().size() / glm::dvec2(mSize);
  auto keep = [&](glm::dvec2 anchor) {
    glm::dvec2 at = anchor * pixel;
    auto pick = mViewport.pickAt({at.x, at.y});
    mAnchors.push_back(pick && pick->hit ? pick->world : mDocument.shown().camera.target);
  };
  for (const session::SeenName& name : mSeen.names) keep(name.anchor);
  for (const auto& [mark, name] : mSeen.marks) keep(name.anchor);
  for (const session::SeenPlace& place : mSeen.places)
    if (place.at) keep(*place.at);
}

/// What the last complete picture showed, where a space shows it now.
session::SeenNames LetteringOverlay::namesFrom(const session::ViewSpace& space) const {
  session::SeenNames seen = mSeen;
  session::ViewSpace own(space.camera(), glm::dvec2(mSize));
  std::size_t place = 0;
  auto follow = [&](glm::dvec2& anchor) {
    if (auto at = own.pixelFromWorld(mAnchors[place++])) anchor = *at;
  };
  for (session::SeenName& name : seen.names) follow(name.anchor);
  for (auto& [mark, name] : seen.marks) follow(name.anchor);
  for (session::SeenPlace& one : seen.places)
    if (one.at) follow(*one.at);
  return seen;
}

std::set<int> LetteringOverlay::hidden() const {
  std::set<int> ids;
  if (mSize == glm::ivec2(0)) return ids;
  for (const scene::Mark& mark : mDocument.shown().lettering.marks) {
    if (!session::isShown(mDocument.shown(), mark)) continue;
    auto at = std::ranges::find(mSeen.places, mark.id, &session::SeenPlace::mark);
    bool isHidden = at != mSeen.places.end() && at->share < kHiddenShare;
    bool isUnseen =
        mark.points.empty() && std::ranges::none_of(mSeen.marks, [&](const auto& one) { return one.first == mark.id; });
    if (isHidden || isUnseen) ids.insert(mark.id);
  }
  return ids;
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
  seen.taken = takenIn(over.view, ratio);
  session::LaidLettering laid;
  // Words stay where they are while the camera moves, and point at what they name.
  session::NamesBetween held;
  if (&over.view == &mViewport) {
    bool isNaming = session::needsSeenNames(scene.lettering) || session::needsSeenPlaces(scene.lettering);
    if (size == mSize && isNaming) {
      seen.names = namesFrom(over.space);
      held.from = held.to = mPlaces;
      seen.between = &held;
    }
    laid = session::layLettering(scene, size, seen);
  } else {
    session::ViewSpace space = finer(over.space, glm::dvec2(size), ratio);
    SectionNames& names = mSections[&over.view];
    names.look(scene, over.view, seen);
    seen.names = names.seenFrom(space);
    held.from = held.to = names.places();
    seen.between = &held;
    laid = session::layMarks(scene, space, seen);
  }
  paintBlocks(over.painter, laid.blocks, size, ratio);
  for (session::PlacedWords& words : laid.words) words.low /= ratio, words.high /= ratio, words.at /= ratio;
  mWords[&over.view] = std::move(laid.words);
}

}  // namespace velum::gui
