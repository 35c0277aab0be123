#include "gui/view/SectionOverlay.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <functional>

#include "gui/kit/Length.h"
#include "gui/kit/Points.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "gui/view/GreyWindowCorner.h"
#include "gui/view/SideNames.h"
#include "render/section/SectionImage.h"
#include "session/section/SectionTool.h"

namespace velum::gui {

namespace {

constexpr double kMargin = 10.0;
const QColor kGapColor(0xe0, 0x4a, 0x3a, 200);
/// The crosshair leaves its middle free, so that what it points at can be seen.
constexpr double kGap = 9.0;
/// Views smaller than this keep title, letters and lines only.
constexpr double kSmallWidth = 230.0, kSmallHeight = 150.0;

void drawTwice(QPainter& painter, const QPainterPath& path, QColor color, double width) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, color.alpha() / 3), width + 1.6, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPath(path);
}

void drawCrosshair(QPainter& painter, const scene::Scene& scene, scene::SectionKind kind,
                   const scene::SectionPlane& plane, const SectionHints& hints) {
  glm::dvec2 cross = scene::sectionPixelFromWorld(plane, scene.sections.crosshair);
  for (const auto& line : session::crosshairLines(scene, kind, plane)) {
    QColor color = kSectionColors[static_cast<int>(line.other)];
    color.setAlpha(190);
    QPainterPath path;
    glm::dvec2 along = glm::normalize(line.to - line.from);
    double middle = glm::dot(cross - line.from, along), length = glm::length(line.to - line.from);
    if (double end = std::min(middle - kGap, length); end > 0) {
      path.moveTo(toPoint(line.from));
      path.lineTo(toPoint(line.from + along * end));
    }
    if (double begin = std::max(middle + kGap, 0.0); begin < length) {
      path.moveTo(toPoint(line.from + along * begin));
      path.lineTo(toPoint(line.to));
    }
    drawTwice(painter, path, color, 1.1);
    if (!line.hasKnobs || !hints.showKnobs) continue;
    for (auto knob : line.knobs) {
      painter.setPen(QPen(QColor(0, 0, 0, 150), 1.2));
      painter.setBrush(hints.hotKnob ? color.lighter(130) : color);
      double radius = hints.hotKnob ? 5.0 : 4.0;
      painter.drawEllipse(toPoint(knob), radius, radius);
    }
  }
}

void drawLetters(QPainter& painter, const scene::SectionPlane& plane) {
  auto letters = [](glm::dvec3 v) { return QString::fromStdString(scene::patientLetters(v)); };
  QFont font = painter.font();
  font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  QRectF box = QRectF(0, 0, plane.size.x, plane.size.y).adjusted(kMargin, kMargin, -kMargin, -kMargin);
  drawOverTissue(painter, box, Qt::AlignRight | Qt::AlignVCenter, letters(plane.right));
  drawOverTissue(painter, box, Qt::AlignLeft | Qt::AlignVCenter, letters(-plane.right));
  drawOverTissue(painter, box, Qt::AlignHCenter | Qt::AlignTop, letters(plane.up));
  drawOverTissue(painter, box, Qt::AlignHCenter | Qt::AlignBottom, letters(-plane.up));
  font.setWeight(QFont::Normal);
  painter.setFont(font);
}

void drawRuler(QPainter& painter, const scene::SectionPlane& plane, const Length& unit, double bottom) {
  double length = session::rulerLength(plane.lengthPerPixel * std::min(160.0, plane.size.x * 0.3));
  double width = length / plane.lengthPerPixel;
  QPainterPath path(QPointF(kMargin, bottom - 5));
  path.lineTo(kMargin, bottom);
  path.lineTo(kMargin + width, bottom);
  path.lineTo(kMargin + width, bottom - 5);
  drawTwice(painter, path, kOverPicture, 1.3);
  drawOverTissue(painter, QRectF(kMargin + width + 7, bottom - 13, 120, 18), Qt::AlignLeft | Qt::AlignVCenter,
                 unit.roundText(length));
}

/// Where the section lies along its normal, then which plane of the data it is.
QStringList positionTexts(const scene::Scene& scene, scene::SectionKind kind, const scene::SectionPlane& plane,
                          bool letters) {
  QStringList parts;
  Length length(scene);
  if (scene::isOblique(scene.sections, kind)) {
    scene::Bounds bounds = scene::computeBounds(scene);
    double off = -scene::heightOverSection(plane, (bounds.min + bounds.max) * 0.5);
    parts << QCoreApplication::translate("velum::gui::SectionOverlay", "%1 off the middle").arg(length.text(off));
  } else {
    int axis = std::abs(plane.normal.x) > 0.9 ? 0 : std::abs(plane.normal.y) > 0.9 ? 1 : 2;
    double at = scene.sections.crosshair[axis];
    static constexpr const char *kPlus[] = {"L", "P", "S"}, *kMinus[] = {"R", "A", "I"};
    bool isMinus = length.number(at).startsWith('-');
    parts << (letters ? QString("%1 %2").arg(isMinus ? kMinus[axis] : kPlus[axis], length.text(std::abs(at)))
                      : length.text(at));
  }
  if (auto index = scene::sectionIndex(scene, kind))
    parts << QString("%1 / %2").arg(index->index + 1).arg(index->count);
  return parts;
}

/// The part of a polygon where an affine function of the place is not below zero.
QPolygonF clipped(const QPolygonF& polygon, const std::function<double(QPointF)>& side) {
  QPolygonF out;
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    QPointF a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    double sa = side(a), sb = side(b);
    if (sa >= 0) out << a;
    if ((sa < 0) != (sb < 0)) out << a + (b - a) * (sa / (sa - sb));
  }
  return out;
}

/// Where no slice was: hatched, so that nobody takes what is filled in for what was seen.
void drawGaps(QPainter& painter, const Volume& volume, const scene::SectionPlane& plane) {
  glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel);
  auto voxelAt = [&](QPointF place) {
    return glm::dvec3(voxelFromWorld * glm::dvec4(scene::worldFromSectionPixel(plane, {place.x(), place.y()}), 1.0));
  };
  QPolygonF view(QRectF(0, 0, plane.size.x, plane.size.y));
  view.removeLast();
  for (int axis = 0; axis < 2; ++axis) {
    view = clipped(view, [&](QPointF place) { return voxelAt(place)[axis] + 0.5; });
    view = clipped(view, [&](QPointF place) { return volume.dims[axis] - 0.5 - voxelAt(place)[axis]; });
  }
  for (glm::ivec2 gap : volume.gaps) {
    QPolygonF part = clipped(view, [&](QPointF place) { return voxelAt(place).z - (gap[0] - 0.5); });
    part = clipped(part, [&](QPointF place) { return gap[0] + gap[1] - 0.5 - voxelAt(place).z; });
    if (part.isEmpty()) continue;
    painter.setPen(QPen(kGapColor, 1.0));
    painter.setBrush(QBrush(kGapColor, Qt::BDiagPattern));
    painter.drawPolygon(part);
  }
}

void drawTitle(QPainter& painter, const scene::Scene& scene, scene::SectionKind kind, bool hasFocus) {
  QColor color = kSectionColors[static_cast<int>(kind)];
  QString name = planeName(scene, kind);
  if (scene::isOblique(scene.sections, kind))
    name += QCoreApplication::translate("velum::gui::SectionOverlay", " (turned)");
  double width = painter.fontMetrics().horizontalAdvance(name) + 30.0;
  QRectF chip(kMargin - 2, kMargin - 2, width, painter.fontMetrics().height() + 6.0);
  painter.setPen(hasFocus ? QPen(color, 1.0) : QPen(Qt::NoPen));
  painter.setBrush(QColor(16, 18, 21, 165));
  painter.drawRoundedRect(chip, 5, 5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QPointF(chip.left() + 11, chip.center().y()), 4.0, 4.0);
  painter.setPen(kOverPicture);
  painter.drawText(chip.adjusted(21, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, name);
}

}  // namespace

double cornerRoom(glm::dvec2 size) {
  // The letter in the middle of the lowest line keeps its room.
  return size.x < kSmallWidth || size.y < kSmallHeight ? 0.0 : 0.5 * size.x - kMargin - 12.0;
}

QPointF lowerRight(glm::dvec2 size) { return {size.x - kMargin, size.y - kMargin}; }

QString sectionName(scene::SectionKind kind) {
  static constexpr const char* kNames[] = {QT_TRANSLATE_NOOP("Words", "Axial"), QT_TRANSLATE_NOOP("Words", "Coronal"),
                                           QT_TRANSLATE_NOOP("Words", "Sagittal")};
  return wordsOf(kNames[static_cast<int>(kind)]);
}

void paintSectionOverlay(QPainter& painter, const scene::Scene& scene, scene::SectionKind kind,
                         const scene::SectionPlane& plane, const SectionHints& hints) {
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& volume = scene.volume.data;
  bool letters = hasPatientLetters(scene), lengths = !volume || volume->isSpacingKnown;
  if (volume && !volume->gaps.empty()) drawGaps(painter, *volume, plane);
  if (scene.sections.showCrosshair) drawCrosshair(painter, scene, kind, plane, hints);
  if (letters) drawLetters(painter, plane);
  drawTitle(painter, scene, kind, hints.hasFocus);
  if (cornerRoom(plane.size) <= 0.0) return;
  double line = painter.fontMetrics().height() + 2.0;
  QRectF box = QRectF(0, 0, plane.size.x, plane.size.y).adjusted(kMargin, kMargin, -kMargin, -kMargin);
  QStringList parts = positionTexts(scene, kind, plane, letters);
  QString position = parts.join("    ");
  bool fits = painter.fontMetrics().horizontalAdvance(position) < cornerRoom(plane.size);
  drawOverTissue(painter, box, Qt::AlignLeft | Qt::AlignBottom, fits ? position : parts.first());
  if (lengths) drawRuler(painter, plane, Length(scene), box.bottom() - line - 6.0);
}

}  // namespace velum::gui
