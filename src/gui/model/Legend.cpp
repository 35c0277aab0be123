#include "gui/model/Legend.h"

#include <algorithm>
#include <numeric>

#include "gui/kit/Text.h"

namespace velum::gui {

namespace {

constexpr std::size_t kMostNames = 20;
constexpr double kLeastShare = 2e-4;  // of the picture; below it is a dot that nobody looks for
constexpr int kRow = 19, kPatch = 11, kMargin = 12, kInset = 9, kMostWidth = 230;
const QColor kGround(0x14, 0x18, 0x1e, 0xc8), kText(0xf0, 0xf3, 0xf7);  // over white paper and black alike

}  // namespace

void Legend::setShown(bool shown) {
  mIsShown = shown;
  if (shown) count();
}

bool Legend::count() {
  if (!mIsShown) return false;
  const auto& model = mDocument.scene().model.data;
  Viewport::TypePixels picture = mViewport.typesOfPixels();
  if (!model || picture.types.empty()) return false;
  std::vector<std::uint32_t> pixels(model->types.size()), order(pixels.size());
  for (std::int32_t type : picture.types)
    if (type >= 0 && std::size_t(type) < pixels.size()) ++pixels[std::size_t(type)];
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return pixels[a] > pixels[b]; });
  double all = double(picture.size.x) * picture.size.y;
  std::erase_if(order, [&](std::uint32_t type) { return pixels[type] <= kLeastShare * all; });
  if (order.size() > kMostNames) order.resize(kMostNames);
  if (order == mTypes && mModel == model) return false;
  mTypes = order;
  mModel = model;
  mNames.clear();
  for (std::uint32_t type : mTypes) mNames.push_back(nameText(model->types[type].name));
  return true;
}

void Legend::paint(ViewPainter& over) const {
  const scene::ModelLayer& layer = mDocument.scene().model;
  if (!mIsShown || &over.view != &mViewport || mTypes.empty() || layer.data != mModel || !layer.visible) return;
  QPainter& painter = over.painter;
  painter.save();
  QFontMetrics metrics(painter.font());
  int widest = 0;
  for (const QString& name : mNames) widest = std::max(widest, metrics.horizontalAdvance(name));
  int text = std::min(widest + 2, std::min(kMostWidth, over.size.width() / 3));
  int most = std::max(1, (over.size.height() - 2 * kMargin - 2 * kInset) / kRow);
  int rows = std::min(int(mTypes.size()), most);
  QRectF box(kMargin, kMargin, text + kPatch + 8 + 2 * kInset, rows * kRow + 2 * kInset - 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kGround);
  painter.drawRoundedRect(box, 6, 6);
  std::vector<glm::vec3> colors = scene::typeColors(layer);
  for (int i = 0; i < rows; ++i) {
    QRectF line(box.left() + kInset, box.top() + kInset - 2 + i * kRow, box.width() - 2 * kInset, kRow);
    glm::vec3 c = glm::clamp(colors[mTypes[std::size_t(i)]], 0.0f, 1.0f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor::fromRgbF(c.r, c.g, c.b));
    painter.drawRoundedRect(QRectF(line.left(), line.center().y() - kPatch / 2.0, kPatch, kPatch), 2.5, 2.5);
    painter.setPen(kText);
    painter.drawText(line.adjusted(kPatch + 8, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(mNames[std::size_t(i)], Qt::ElideMiddle, text));
  }
  painter.restore();
}

}  // namespace velum::gui
