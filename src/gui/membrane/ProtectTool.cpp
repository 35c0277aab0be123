#include "ProtectTool.h"

#include <QApplication>
#include <QKeyEvent>

#include "velum/session/membrane/MembraneEdit.h"
#include "velum/session/structure/StructureEdit.h"

namespace velum::gui {

ProtectTool::ProtectTool(session::Document& document, ViewGrid& views, Selection& selection, MessageBar& messages,
                         QObject* parent)
    : QObject(parent), mDocument(document), mViews(views), mSelection(selection), mMessages(messages) {
  connect(&views.viewport(), &Viewport::clicked, this, &ProtectTool::clickedInPicture);
  connect(&views, &ViewGrid::clickedSlice, this, [this](glm::dvec3 worldMm, Qt::KeyboardModifiers keys) {
    if (mActive) protectAt(worldMm, render::probe(mDocument.scene(), worldMm).structure, keys);
  });
}

void ProtectTool::start(bool letThrough) {
  mLetThrough = letThrough;
  if (mActive) return;
  mActive = true;
  mViews.setPointing(true);
  qApp->installEventFilter(this);
}

void ProtectTool::stop() {
  if (!mActive) return;
  mActive = false;
  qApp->removeEventFilter(this);
  mViews.setPointing(false);
  emit ended();
}

bool ProtectTool::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();  // before a command that has the same key
    if (event->type() == QEvent::KeyPress) stop();
    return true;
  }
  return QObject::eventFilter(watched, event);
}

/// The picture's point lies on the material's border: what is meant is behind it.
void ProtectTool::clickedInPicture(QPointF place, Qt::KeyboardModifiers keys) {
  if (!mActive) return;
  auto pick = mViews.viewport().pickAt(place);
  if (!pick || !pick->hit) return;
  glm::dvec3 inside = pick->worldMm;
  if (const auto& volume = mDocument.scene().volume.data) {
    glm::dvec3 spacing = spacingMm(*volume);
    inside -= glm::dvec3(pick->normal) * (2.5 * std::max(spacing.x, std::max(spacing.y, spacing.z)));
  }
  protectAt(inside, pick->structure, keys);
}

void ProtectTool::protectAt(glm::dvec3 worldMm, int structure, Qt::KeyboardModifiers keys) {
  double strength = mLetThrough ? 0.0 : session::kProtectStrength;
  std::optional<session::Tissue> tissue;
  std::string label = mLetThrough ? "Let sheet through" : "Protect from sheet";
  mDocument.edit(label, [&](scene::Scene& scene) {
    scene::Cut* cut = scene::findCut(scene, mSelection.cut());
    if (!cut || !cut->membrane) return;
    scene::Membrane& membrane = *cut->membrane;
    if (structure > 0 && scene.labels.visible)
      session::protectStructure(membrane, structure, strength);
    else
      tissue = session::protectTissue(membrane, scene.volume, worldMm, strength);
  });
  QString what;
  if (structure > 0)
    what = QString::fromStdString(session::structureName(mDocument.scene(), structure));
  else if (tissue)
    what = tr("values around %1").arg(tissue->value, 0, 'g', 4);
  if (!what.isEmpty()) mMessages.showNote((mLetThrough ? tr("Let through: %1") : tr("Kept whole: %1")).arg(what));
  if (!(keys & Qt::ShiftModifier)) stop();
}

}  // namespace velum::gui
