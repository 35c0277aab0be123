#include "gui/view/LetteringOverlay.h"

#include <QImage>

#include "gui/kit/Text.h"

namespace velum::gui {

namespace {

QImage imageOf(const session::Mark& mark) {
  QImage image(mark.size.x, mark.size.y, QImage::Format_ARGB32_Premultiplied);
  glm::vec3 color = glm::clamp(mark.color, 0.0f, 1.0f);
  for (int y = 0; y < mark.size.y; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < mark.size.x; ++x) {
      int covers = mark.covers[std::size_t(y) * std::size_t(mark.size.x) + std::size_t(x)];
      glm::ivec3 part(glm::round(color * float(covers)));
      line[x] = qRgba(part.r, part.g, part.b, covers);
    }
  }
  return image;
}

}  // namespace

bool LetteringOverlay::count() {
  const scene::Scene& scene = mDocument.shown();
  if (!scene.lettering.legend || !scene.model.data) return false;
  Viewport::TypePixels picture = mViewport.typesOfPixels();
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
  if (&over.view != &mViewport) return;
  double ratio = over.painter.device()->devicePixelRatioF();
  glm::ivec2 size(glm::round(glm::dvec2(over.size.width(), over.size.height()) * ratio));
  for (const session::Mark& mark : session::letteringMarks(mDocument.shown(), size, pixels())) {
    QImage image = imageOf(mark);
    image.setDevicePixelRatio(ratio);
    over.painter.drawImage(QPointF(mark.corner.x, mark.corner.y) / ratio, image);
  }
}

}  // namespace velum::gui
