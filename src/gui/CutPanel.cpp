#include "CutPanel.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "velum/session/CutTool.h"

namespace velum::gui {

CutPanel::CutPanel(session::Document& document, QWidget* parent)
    : QWidget(parent), mDocument(document), mList(new QListWidget(this)), mControls(new QWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  auto* head = new QHBoxLayout;
  head->addWidget(makeTitle(tr("Cuts"), this), 1);
  auto* add = new QPushButton(tr("Add plane"), this);
  add->setObjectName("addPlane");
  add->setToolTip(tr("Cut away the half that faces you (C)"));
  mRemove = new QPushButton(tr("Remove"), this);
  mRemove->setToolTip(tr("Remove the selected cut (Del)"));
  head->addWidget(add);
  head->addWidget(mRemove);
  layout->addLayout(head);
  mList->setToolTip(tr("Cuts of this scene; the tick turns one on and off"));
  mList->setFixedHeight(76);
  layout->addWidget(mList);
  layout->addWidget(mControls);
  buildControls();
  connect(add, &QPushButton::clicked, this, &CutPanel::addPlane);
  connect(mRemove, &QPushButton::clicked, this, &CutPanel::removeSelected);
  connect(mList, &QListWidget::currentRowChanged, this, &CutPanel::select);
  connect(mList, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    std::size_t row = std::size_t(mList->row(item));
    bool on = item->checkState() == Qt::Checked;
    mDocument.edit(on ? "Turn cut on" : "Turn cut off", [&](scene::Scene& scene) {
      if (row < scene.cuts.size()) scene.cuts[row].enabled = on;
    });
  });
}

void CutPanel::buildControls() {
  auto* grid = new QGridLayout(mControls);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  grid->setColumnMinimumWidth(0, 72);
  grid->setColumnStretch(1, 1);
  mPosition = new NumberRow(-1, 1, 1, " mm", mControls);
  mPosition->setObjectName("cutPosition");
  mPosition->setToolTip(tr("Distance of the plane from the middle of the data, along its normal, mm"));
  auto* snap = new QHBoxLayout;
  snap->setSpacing(6);
  auto addSnap = [&](const QString& text, const QString& tip, glm::dvec3 axis) {
    auto* button = new QPushButton(text, mControls);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, axis] { snapTo(axis); });
    snap->addWidget(button, 1);
  };
  addSnap(tr("Axial"), tr("Turn the plane across the body (its normal along inferior to superior)"), {0, 0, 1});
  addSnap(tr("Coronal"), tr("Turn the plane into front and back (its normal along anterior to posterior)"), {0, 1, 0});
  addSnap(tr("Sagittal"), tr("Turn the plane into left and right"), {1, 0, 0});
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  mFace = new QComboBox(mControls);
  mFace->setObjectName("cutFace");
  mFace->addItems({tr("Shaded"), tr("Slice (grey values)")});
  mFace->setToolTip(tr("How the cut surface looks: lit material, or the data's grey values as on a slice"));
  mFlip = new QPushButton(tr("Flip"), mControls);
  mFlip->setCheckable(true);
  mFlip->setToolTip(tr("Take away the other side (X)"));
  row->addWidget(mFace, 1);
  row->addWidget(mFlip);
  grid->addWidget(new QLabel(tr("Position"), mControls), 0, 0);
  grid->addWidget(mPosition, 0, 1);
  grid->addWidget(new QLabel(tr("Align"), mControls), 1, 0);
  grid->addLayout(snap, 1, 1);
  grid->addWidget(new QLabel(tr("Face"), mControls), 2, 0);
  grid->addLayout(row, 2, 1);
  connect(mPosition, &NumberRow::changed, this, [this](double mm) {
    editSelected(
        "Move cut", [&](scene::Cut& cut) { cut = session::withOffset(mDocument.scene(), cut, mm); }, true);
  });
  connect(mPosition, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  connect(mFace, &QComboBox::activated, this, [this](int index) {
    editSelected("Change cut face", [&](scene::Cut& cut) { cut.face = static_cast<scene::CutFace>(index); });
  });
  connect(mFlip, &QPushButton::clicked, this, &CutPanel::flipSelected);
}

void CutPanel::editSelected(const char* label, const std::function<void(scene::Cut&)>& change, bool merge) {
  if (mSelected < 0) return;
  std::size_t index = std::size_t(mSelected);
  mDocument.edit(
      label,
      [&](scene::Scene& scene) {
        if (index < scene.cuts.size()) change(scene.cuts[index]);
      },
      merge);
}

void CutPanel::addPlane() {
  const scene::Scene& scene = mDocument.scene();
  if (!scene.volume.data && !scene.labels.data && scene.surfaces.empty()) return;
  scene::Cut cut = session::cutFacingCamera(scene);
  cut.name = tr("Plane %1").arg(scene.cuts.size() + 1).toStdString();
  mSelected = int(scene.cuts.size());
  mDocument.edit("Add cut", [&](scene::Scene& s) { s.cuts.push_back(cut); });
  emit selectionChanged(mSelected);
}

void CutPanel::removeSelected() {
  if (mSelected < 0) return;
  std::size_t index = std::size_t(mSelected);
  mDocument.edit("Remove cut", [&](scene::Scene& scene) {
    if (index < scene.cuts.size()) scene.cuts.erase(scene.cuts.begin() + std::ptrdiff_t(index));
  });
}

void CutPanel::flipSelected() {
  editSelected("Flip cut", [](scene::Cut& cut) { cut.invert = !cut.invert; });
}

/// Keeps the plane where it crosses the middle of what it showed, and takes away the side that faces the eye.
void CutPanel::snapTo(glm::dvec3 axis) {
  const scene::Scene& scene = mDocument.scene();
  if (glm::dot(axis, scene.camera.eyeMm - scene.camera.targetMm) < 0) axis = -axis;
  editSelected("Align cut", [&](scene::Cut& cut) {
    cut.centreMm = session::makeCutGizmo(scene, cut, {100, 100}).centreMm;
    cut.axis = axis;
    if (cut.shape == scene::CutShape::Plane) cut.invert = false;
  });
}

void CutPanel::select(int index) {
  if (mSelected == index) return;
  mSelected = index;
  refresh();
  emit selectionChanged(index);
}

void CutPanel::refresh() {
  const auto& cuts = mDocument.scene().cuts;
  int before = mSelected;
  mSelected = std::clamp(mSelected, -1, int(cuts.size()) - 1);
  if (mSelected < 0 && !cuts.empty()) mSelected = 0;
  {
    const QSignalBlocker quiet(mList);
    while (mList->count() > int(cuts.size())) delete mList->takeItem(mList->count() - 1);
    for (int i = 0; i < int(cuts.size()); ++i) {
      const scene::Cut& cut = cuts[std::size_t(i)];
      QListWidgetItem* item = mList->item(i);
      if (!item) item = new QListWidgetItem(mList);
      QString name = QString::fromStdString(cut.name);
      if (name.isEmpty()) name = tr("Cut %1").arg(i + 1);
      item->setText(name);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
      item->setCheckState(cut.enabled ? Qt::Checked : Qt::Unchecked);
    }
    mList->setCurrentRow(mSelected);
  }
  bool any = mSelected >= 0;
  mRemove->setEnabled(any);
  mControls->setVisible(any);
  mList->setVisible(any);
  if (any) {
    const scene::Cut& cut = cuts[std::size_t(mSelected)];
    auto [offset, reach] = session::cutPosition(mDocument.scene(), cut);
    mPosition->setRange(std::min(-reach, offset), std::max(reach, offset));
    mPosition->setValue(offset);
    mFace->setCurrentIndex(static_cast<int>(cut.face));
    mFlip->setChecked(cut.invert);
  }
  if (before != mSelected) emit selectionChanged(mSelected);
}

}  // namespace velum::gui
