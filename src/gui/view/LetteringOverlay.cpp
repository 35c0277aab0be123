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

/// Leaves of a picture's pixels each so-manieth along x and y.
template <class T>
void makeCoarser(std::vector<T>& pixels, glm::ivec2 size, int step) {
  if (pixels.empty() || step == 1) return;
  std::size_t to = 0;
  for (int y = 0; y < size.y; y += step)
    for (int x = 0; x < size.x; x += step) pixels[to++] = pixels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
  pixels.resize(to);
  pixels.shrink_to_fit();
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

bool LetteringOverlay::count() { return countIn(true); }

bool LetteringOverlay::recount() { return countIn(false); }

/// Makes sure that what the picture shows has been read. @return false: there is no picture of the scene as it stands
bool LetteringOverlay::look(bool isComplete, bool withDistances) {
  bool isOther = mLooked && isComplete && (!mLooked->isComplete || mLooked->picture != mViewport.pictureNumber());
  if (isOther || (mLooked && withDistances && !mLooked->hasDistances)) mLooked.reset();
  if (!mLooked && !read(isComplete, withDistances)) return false;
  const scene::Scene& scene = mDocument.shown();
  return mLooked->camera == scene.camera && mLooked->model == scene.model.data;
}

bool LetteringOverlay::read(bool isComplete, bool withDistances) {
  Viewport::PixelIds ids = mViewport.idsOfPixels(withDistances);
  if (ids.structures.empty()) return false;
  const scene::Scene& scene = mDocument.shown();
  if (scene.model.data) {
    mPixels = session::countPixels(ids.types, scene.model.data->types.size());
    mModel = scene.model.data;
  }
  int step = session::mapStep(ids.size.x);
  makeCoarser(ids.structures, ids.size, step);
  makeCoarser(ids.types, ids.size, step);
  makeCoarser(ids.instances, ids.size, step);
  makeCoarser(ids.distances, ids.size, step);
  ++mReadings;
  mLooked = {std::move(ids), step,         mViewport.pictureNumber(), isComplete,
             withDistances,  scene.camera, scene.model.data};
  return true;
}

bool LetteringOverlay::countIn(bool isComplete) {
  const scene::Scene& scene = mDocument.shown();
  bool hasLegend = scene.lettering.legend && scene.model.data, hasNames = session::needsSeenNames(scene.lettering),
       hasPlaces = session::needsSeenPlaces(scene.lettering);
  if (!hasNames && !hasPlaces) mSeen = {}, mAnchors.clear(), mNaming.reset();
  if (!hasLegend && !hasNames && !hasPlaces) {
    if (isComplete) mLooked.reset();
    return false;
  }
  std::vector<QString> before = names();
  if (!look(isComplete, hasPlaces)) return false;
  if (!hasNames && !hasPlaces) return names() != before;
  lookForNames(hasNames, hasPlaces);
  return true;
}

/// Finds what names and leaders point at, in what was read.
void LetteringOverlay::lookForNames(bool hasNames, bool hasPlaces) {
  const Viewport::PixelIds& ids = mLooked->ids;
  session::SeenMap map{session::mapSize(ids.size, mLooked->step),
                       ids.structures,
                       ids.types,
                       mLooked->step,
                       ids.instances,
                       ids.distances};
  bool isSame = mSeenReading == mReadings;
  Anchors known = isSame ? anchors() : Anchors();
  if (hasNames)
    findNames(map, isSame);
  else
    mSeen = {}, mNaming.reset();
  mSeen.places.clear();
  if (hasPlaces) findPlaces(map);
  mSize = ids.size;
  mSeenReading = mReadings;
  keepAnchors(known);
  session::Seen seen{pixels(), mMeasured, mSeen};
  seen.taken = takenIn(mViewport, mViewport.devicePixelRatioF());
  if (hasNames)
    mPlaces = settledNames(std::move(mPlaces), std::move(seen), kSettleMs, [&](const session::Seen& of) {
      return session::layLettering(mDocument.shown(), mSize, of);
    });
}

/// Looks for names, unless the picture and what is named are as they were.
void LetteringOverlay::findNames(const session::SeenMap& map, bool isSame) {
  const scene::Scene& scene = mDocument.shown();
  scene::Lettering naming = session::namingOf(scene.lettering);
  if (isSame && mNaming == naming && mNamedStructures == scene.labels.structures && mNamedTypes == scene.model.types)
    return;
  session::SeenNames old = mSize == mLooked->ids.size ? namesFrom(mViewport.space()) : session::SeenNames();
  mSeen = session::seenNames(scene, map, old);
  mNaming = std::move(naming);
  mNamedStructures = scene.labels.structures;
  mNamedTypes = scene.model.types;
}

void LetteringOverlay::findPlaces(const session::SeenMap& map) {
  const scene::Scene& scene = mDocument.shown();
  render::SheetIndices sheets = mViewport.membranes().indices();
  bool isMissing = std::ranges::any_of(scene.cuts, [&](const scene::Cut& cut) {
    auto sheet = sheets.find(cut.id);
    return cut.enabled && scene::isMembrane(cut) && (sheet == sheets.end() || !sheet->second);
  });
  mSeen.places = isMissing ? session::seenPlaces(mViewport.membranes().withShapes(scene), map, sheets)
                           : session::seenPlaces(scene, map, sheets);
}

LetteringOverlay::Anchors LetteringOverlay::anchors() const {
  Anchors all;
  auto add = [&](glm::dvec2 anchor) {
    if (all.size() < mAnchors.size()) all.emplace_back(anchor, mAnchors[all.size()]);
  };
  for (const session::SeenName& name : mSeen.names) add(name.anchor);
  for (const auto& [mark, name] : mSeen.marks) add(name.anchor);
  for (const session::SeenPlace& place : mSeen.places)
    if (place.at) add(*place.at);
  return all;
}

/// Places in the world, by which names follow a camera that moves. @param known  of the same reading
void LetteringOverlay::keepAnchors(const Anchors& known) {
  mAnchors.clear();
  glm::dvec2 pixel = mViewport.space().size() / glm::dvec2(mSize);
  auto keep = [&](glm::dvec2 anchor) {
    auto found = std::ranges::find(known, anchor, &Anchors::value_type::first);
    if (found != known.end()) return mAnchors.push_back(found->second);
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
