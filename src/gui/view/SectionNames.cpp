#include "gui/view/SectionNames.h"

#include <QGuiApplication>

#include "gui/view/SettleNames.h"
#include "session/lettering/SeenSection.h"

namespace velum::gui {

namespace {

constexpr qint64 kSectionSettleMs = 12;

scene::Lettering exceptMarks(scene::Lettering lettering) {
  lettering.marks.clear();
  return lettering;
}

/// A mark may be dragged: names find their places when it is let go, which paints anew.
bool isMarkHeld(const scene::Lettering& before, const scene::Lettering& now) {
  return QGuiApplication::mouseButtons() != Qt::NoButton && exceptMarks(before) == exceptMarks(now);
}

}  // namespace

void SectionNames::look(const scene::Scene& scene, const ToolView& view, const session::Seen& beside) {
  if (!session::needsSeenNames(scene.lettering)) {
    *this = {};
    return;
  }
  auto shown = view.shownSection();
  if (!shown) return;
  scene::Lettering naming = session::namingOf(scene.lettering);
  bool isOther = shown->number != mNumber || mStructures != scene.labels.structures;
  bool isNew = mNumber == 0 || naming != mNaming || (isOther && !shown->isMoving);
  if (!isNew && (mLettering == scene.lettering || isMarkHeld(mLettering, scene.lettering))) return;
  session::ViewSpace space(shown->plane);
  if (isNew) {
    session::SeenNames before = mNumber == 0 ? session::SeenNames() : seenFrom(space);
    session::SectionMap map(shown->image, scene.background.bottom);
    mSeen = session::seenNames(scene, map.map(), before);
    mSpace = space;
    mNumber = shown->number;
    mNaming = std::move(naming);
    mStructures = scene.labels.structures;
  }
  mLettering = scene.lettering;
  session::Seen seen = beside;
  seen.names = seenFrom(space);
  mPlaces = settledNames(std::move(mPlaces), std::move(seen), kSectionSettleMs,
                         [&](const session::Seen& of) { return session::layMarks(scene, space, of); });
}

session::SeenNames SectionNames::seenFrom(const session::ViewSpace& space) const {
  session::SeenNames seen = mSeen;
  const scene::SectionPlane *from = mSpace.section(), *to = space.section();
  if (!from || !to || *from == *to) return seen;
  auto follow = [&](session::SeenName& name) {
    if (auto at = space.pixelFromWorld(scene::worldFromSectionPixel(*from, name.anchor))) name.anchor = *at;
  };
  for (session::SeenName& name : seen.names) follow(name);
  for (auto& [mark, name] : seen.marks) follow(name);
  return seen;
}

}  // namespace velum::gui
