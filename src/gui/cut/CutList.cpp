#include "gui/cut/CutList.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>

#include "gui/kit/CutTitle.h"
#include "gui/rows/RowPaint.h"
#include "scene/Scene.h"
#include "session/cut/ShapeTraits.h"

namespace velum::gui {

namespace {

constexpr int kRowHeight = 27, kEyeWidth = 28, kShapeWidth = 24;
constexpr int kMostRows = 5;
constexpr int kShapeRole = Qt::UserRole, kIdRole = Qt::UserRole + 3;

class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {60, kRowHeight}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintRowGround(*painter, option, true, true);
    bool enabled = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    QColor color = rowTextColor(option, enabled);
    paintEye(*painter, eyeBox(option.rect), color, enabled);
    QRectF shape(option.rect.left() + kEyeWidth, option.rect.top(), kShapeWidth, option.rect.height());
    auto of = static_cast<scene::CutShape>(index.data(kShapeRole).toInt());
    paintIcon(*painter, shape, color, session::traitsOf(of).icon);
    QRect box = nameBox(option.rect);
    painter->setPen(color);
    painter->drawText(box, Qt::AlignVCenter,
                      option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, box.width()));
    painter->restore();
  }

  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    editor->setGeometry(nameBox(option.rect).adjusted(-6, 0, 0, 0));
  }

  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
    bool presses = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (presses || event->type() == QEvent::MouseButtonRelease) {
      auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->button() == Qt::LeftButton && eyeBox(option.rect).contains(mouse->position())) {
        // The base would take the release over its own box, which lies in the eye, for a second click.
        if (!presses) return true;
        bool enabled = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        return model->setData(index, enabled ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
      }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
  }

 private:
  static QRectF eyeBox(const QRect& row) { return QRectF(row.left(), row.top(), kEyeWidth, row.height()); }
  static QRect nameBox(const QRect& row) { return row.adjusted(kEyeWidth + kShapeWidth + 4, 0, -4, 0); }
};

}  // namespace

CutList::CutList(QWidget* parent) : QListWidget(parent) {
  setObjectName("cutList");
  setAccessibleName(tr("Cuts"));
  setToolTip(tr("The eye turns a cut on and off; F2 or a double click renames it; Alt+Up and Alt+Down move it"));
  setItemDelegate(new Delegate(this));
  setMouseTracking(true);
  setEditTriggers(EditKeyPressed | DoubleClicked);
  setUniformItemSizes(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    // One signal for both: the eye has been told by the data when the state differs.
    bool enabled = item->checkState() == Qt::Checked;
    if (item->data(Qt::UserRole + 1).toBool() != enabled) emit toggled(cutAt(row(item)), enabled);
    if (item->data(Qt::UserRole + 2).toString() != item->text()) emit renamed(cutAt(row(item)), item->text());
  });
}

void CutList::setCuts(const std::vector<scene::Cut>& cuts, int selected) {
  const QSignalBlocker quiet(this);
  while (count() > int(cuts.size())) delete takeItem(count() - 1);
  for (int i = 0; i < int(cuts.size()); ++i) {
    const scene::Cut& cut = cuts[std::size_t(i)];
    if (!item(i)) {
      auto* fresh = new QListWidgetItem(this);
      fresh->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    }
    auto set = [row = item(i)](int role, const QVariant& value) {
      if (row->data(role) != value) row->setData(role, value);
    };
    set(kIdRole, cut.id);
    set(kShapeRole, static_cast<int>(cut.shape));
    set(Qt::UserRole + 1, cut.enabled);
    set(Qt::UserRole + 2, cutTitle(cut, i));
    set(Qt::CheckStateRole, int(cut.enabled ? Qt::Checked : Qt::Unchecked));
    set(Qt::DisplayRole, cutTitle(cut, i));
  }
  setFixedHeight(std::clamp(count(), 1, kMostRows) * kRowHeight + 8);
  setCurrentRow(selected);
}

int CutList::cutAt(int row) const { return item(row) ? item(row)->data(kIdRole).toInt() : 0; }

bool CutList::event(QEvent* event) {
  // The list's own keys go before commands of the window that have the same.
  if (event->type() == QEvent::ShortcutOverride) {
    int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Space || key == Qt::Key_F2) event->accept();
  }
  return QListWidget::event(event);
}

void CutList::keyPressEvent(QKeyEvent* event) {
  bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
  if ((event->modifiers() & Qt::AltModifier) && (up || down)) {
    emit moveAsked(up ? -1 : 1);
    return;
  }
  if (event->key() == Qt::Key_Space && currentItem()) {
    currentItem()->setCheckState(currentItem()->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
    return;
  }
  QListWidget::keyPressEvent(event);
}

}  // namespace velum::gui
