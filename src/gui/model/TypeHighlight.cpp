#include "gui/model/TypeHighlight.h"

#include <algorithm>

namespace velum::gui {

namespace {

constexpr QRgb kVeil = qRgba(8, 10, 14, 165);

}  // namespace

bool TypeHighlight::show(const session::TypeNumbers& types) {
  if (types == mTypes) return false;
  mTypes = types;
  return mIsStill ? look() : false;
}

bool TypeHighlight::takeAway() {
  mIsStill = false;
  bool was = isSeen();
  mVeil = {};
  mPixels = 0;
  return was;
}

bool TypeHighlight::look() {
  bool was = takeAway();
  mIsStill = true;
  if (mTypes.empty()) return was;
  Viewport::PixelIds picture = mViewport.idsOfPixels();
  if (picture.types.empty()) return was;
  std::vector<bool> isIn;
  for (std::uint32_t type : mTypes) {
    if (type >= isIn.size()) isIn.resize(type + 1, false);
    isIn[type] = true;
  }
  mVeil = QImage(picture.size.x, picture.size.y, QImage::Format_ARGB32);
  for (int y = 0; y < picture.size.y; ++y) {
    auto* line = reinterpret_cast<QRgb*>(mVeil.scanLine(y));
    const std::int32_t* types = picture.types.data() + std::ptrdiff_t(y) * picture.size.x;
    for (int x = 0; x < picture.size.x; ++x) {
      bool isShown = types[x] >= 0 && std::size_t(types[x]) < isIn.size() && isIn[std::size_t(types[x])];
      mPixels += isShown;
      line[x] = isShown ? 0u : kVeil;
    }
  }
  return true;
}

void TypeHighlight::paint(ViewPainter& over) const {
  if (&over.view != &mViewport || mVeil.isNull()) return;
  over.painter.save();
  over.painter.setRenderHint(QPainter::SmoothPixmapTransform);
  over.painter.drawImage(QRect(QPoint(), over.size), mVeil);
  over.painter.restore();
}

}  // namespace velum::gui
