#include "gui/view/LetteringOverlay.h"

#include <QImage>

#include "gui/kit/Text.h"

namespace velum::gui {

namespace {

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
  if (!scene.lettering.legend || !scene.model.data) return false;
  Viewport::PixelIds picture = mViewport.idsOfPixels();
  if (picture.types.empty()) return false;
  std::vector<QString> before = names();
  mPixels = session::countPixels(picture.types, scene.model.data->types.size());
  mModel = scene.model.data;
  return names() != before;
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
  session::Seen seen{pixels(), mMeasured};
  if (&over.view == &mViewport)
    paintBlocks(over.painter, session::letteringBlocks(scene, size, seen), size, ratio);
  else
    paintBlocks(over.painter, session::markBlocks(scene, finer(over.space, glm::dvec2(size), ratio), seen), size,
                ratio);
}

}  // namespace velum::gui
