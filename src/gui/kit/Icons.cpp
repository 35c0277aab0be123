#include "gui/kit/Icons.h"

#include <QApplication>
#include <QBuffer>
#include <QFile>
#include <QIconEngine>
#include <QImageReader>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>

namespace velum::gui {

namespace {

constexpr const char* kLineTone = "currentColor";
constexpr const char* kAccentTone = "#5fb0ea";

struct Tones {
  QColor line, accent;
};

/// On a selected item both tones are the item's text colour; a disabled icon is pale as a whole.
Tones tonesOf(QIcon::Mode mode, QIcon::State state) {
  QPalette palette = QApplication::palette();
  auto one = [](const QColor& color) { return Tones{color, color}; };
  if (mode == QIcon::Disabled) return one(palette.color(QPalette::Disabled, QPalette::ButtonText));
  if (state == QIcon::On || mode == QIcon::Selected) return one(palette.color(QPalette::HighlightedText));
  return {palette.color(QPalette::ButtonText), palette.color(QPalette::Link)};
}

QPixmap drawSvg(const QString& path, QSize size, const Tones& tones) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QByteArray svg = file.readAll();
  svg.replace(kLineTone, tones.line.name().toLatin1()).replace(kAccentTone, tones.accent.name().toLatin1());
  QBuffer buffer(&svg);
  QImageReader reader(&buffer, "svg");
  reader.setScaledSize(size);
  return QPixmap::fromImage(reader.read());
}

class Engine : public QIconEngine {
 public:
  Engine(const QString& name, const QColor& color) : mPath(":/icons/" + name + ".svg"), mColor(color) {}

  QIconEngine* clone() const override { return new Engine(*this); }
  QString iconName() override { return mPath; }
  bool isNull() override { return !QFile::exists(mPath); }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    Tones tones = mColor.isValid() ? Tones{mColor, mColor} : tonesOf(mode, state);
    QString key = QString("%1 %2 %3 %4").arg(mPath, tones.line.name(), tones.accent.name()).arg(size.width());
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = drawSvg(mPath, size, tones);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    double ratio = painter->device()->devicePixelRatioF();
    painter->drawPixmap(rect, pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state));
  }

 private:
  QString mPath;
  QColor mColor;
};

}  // namespace

QIcon makeIcon(const QString& name, const QColor& color) { return QIcon(new Engine(name, color)); }

}  // namespace velum::gui
