#include "gui/rows/EyeList.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>

#include "gui/rows/RowPaint.h"

namespace velum::gui {

namespace {

constexpr int kEyeRowHeight = 27, kEyeWidth = 28, kSignWidth = 24, kValueGap = 8;
constexpr int kSignRole = Qt::UserRole, kWasOnRole = Qt::UserRole + 1, kWasNameRole = Qt::UserRole + 2,
              kRowIdRole = Qt::UserRole + 3, kValueRole = Qt::UserRole + 4, kDimRole = Qt::UserRole + 5;

class EyeRowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {60, kEyeRowHeight}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintRowGround(*painter, option, true, true);
    bool isOn = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    QColor color = rowTextColor(option, isOn && !index.data(kDimRole).toBool());
    paintEye(*painter, eyeBox(option.rect), color, isOn);
    QRectF sign(option.rect.left() + kEyeWidth, option.rect.top(), kSignWidth, option.rect.height());
    paintIcon(*painter, sign, color, static_cast<const char*>(index.data(kSignRole).value<const void*>()));
    QRect box = nameBox(option.rect);
    QString value = index.data(kValueRole).toString();
    int valueWidth = value.isEmpty() ? 0 : option.fontMetrics.horizontalAdvance(value) + kValueGap;
    painter->setPen(color);
    painter->drawText(box, Qt::AlignVCenter | Qt::AlignRight, value);
    box.setRight(box.right() - valueWidth);
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
        bool isOn = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        return model->setData(index, isOn ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
      }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
  }

 private:
  static QRectF eyeBox(const QRect& row) { return QRectF(row.left(), row.top(), kEyeWidth, row.height()); }
  static QRect nameBox(const QRect& row) { return row.adjusted(kEyeWidth + kSignWidth + 4, 0, -4, 0); }
};

}  // namespace

EyeList::EyeList(const char* name, int mostRows, QWidget* parent) : QListWidget(parent), mMostRows(mostRows) {
  setObjectName(name);
  setItemDelegate(new EyeRowDelegate(this));
  setMouseTracking(true);
  setEditTriggers(EditKeyPressed | DoubleClicked);
  setUniformItemSizes(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    // One signal for both: the eye has been told by the data when the state differs.
    bool isOn = item->checkState() == Qt::Checked;
    if (item->data(kWasOnRole).toBool() != isOn) emit toggled(idAt(row(item)), isOn);
    if (item->data(kWasNameRole).toString() != item->text()) emit renamed(idAt(row(item)), item->text());
  });
}

void EyeList::setRows(const std::vector<Row>& rows, int selected) {
  const QSignalBlocker quiet(this);
  while (count() > int(rows.size())) delete takeItem(count() - 1);
  for (int i = 0; i < int(rows.size()); ++i) {
    const Row& row = rows[std::size_t(i)];
    if (!item(i)) {
      auto* fresh = new QListWidgetItem(this);
      fresh->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    }
    auto set = [at = item(i)](int role, const QVariant& value) {
      if (at->data(role) != value) at->setData(role, value);
    };
    set(kRowIdRole, row.id);
    set(kSignRole, QVariant::fromValue(static_cast<const void*>(row.icon)));
    set(kWasOnRole, row.isOn);
    set(kWasNameRole, row.name);
    set(kValueRole, row.value);
    set(kDimRole, row.isDim);
    set(Qt::ToolTipRole, row.tip.isEmpty() ? QVariant() : QVariant(row.tip));
    set(Qt::CheckStateRole, int(row.isOn ? Qt::Checked : Qt::Unchecked));
    set(Qt::DisplayRole, row.name);
  }
  setFixedHeight(std::clamp(count(), 1, mMostRows) * kEyeRowHeight + 8);
  setCurrentRow(selected);
}

QString EyeList::valueAt(int row) const {
  const QListWidgetItem* found = item(row);
  return found ? found->data(kValueRole).toString() : QString();
}

int EyeList::idAt(int row) const { return item(row) ? item(row)->data(kRowIdRole).toInt() : 0; }

bool EyeList::event(QEvent* event) {
  // The list's own keys go before commands of the window that have the same.
  if (event->type() == QEvent::ShortcutOverride) {
    int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Space || key == Qt::Key_F2) event->accept();
  }
  return QListWidget::event(event);
}

void EyeList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && currentItem()) {
    currentItem()->setCheckState(currentItem()->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
    return;
  }
  QListWidget::keyPressEvent(event);
}

}  // namespace velum::gui
