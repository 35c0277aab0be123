#include "gui/view/SectionNames.h"

#include "gui/view/SettleNames.h"
#include "session/lettering/SeenSection.h"

namespace velum::gui {

namespace {

constexpr qint64 kSectionSettleMs = 12;

}  // namespace

void SectionNames::look(const scene::Scene& scene, const ToolView& view, const session::Seen& beside) {
  if (!session::needsSeenNames(scene.lettering)) {
    *this = {};
    return;
  }
  auto shown = view.shownSection();
  bool isKnown =
      shown && shown->number == mNumber && mLettering == scene.lettering && mStructures == scene.labels.structures;
  if (!shown || isKnown) return;
  bool isFirst = mNumber == 0;
  mNumber = shown->number;
  mLettering = scene.lettering;
  mStructures = scene.labels.structures;
  session::ViewSpace space(shown->plane);
  Image image = session::seenOfSection(shown->image, shown->plane, scene.background.bottom);
  session::SeenNames before = isFirst ? session::SeenNames() : seenFrom(space);
  mSpace = space;
  mSeen = session::seenNames(scene, image, before);
  session::Seen seen = beside;
  seen.names = mSeen;
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
