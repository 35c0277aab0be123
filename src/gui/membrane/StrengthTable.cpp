#include "gui/membrane/StrengthTable.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "core/Text.h"
#include "gui/kit/NumberField.h"
#include "gui/kit/Widgets.h"
#include "gui/kit/Words.h"
#include "gui/membrane/StrengthCanvas.h"
#include "gui/rows/RowPaint.h"
#include "scene/Scene.h"
#include "session/membrane/MembraneEdit.h"

namespace velum::gui {

namespace {

constexpr int kRowHeight = 24, kMostRows = 6, kNumberWidth = 76, kSwatch = 13;
enum Column { Name, Strength };

/// Forces with their sign, edited in a field of numbers.
class StrengthDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QString displayText(const QVariant& value, const QLocale&) const override {
    double number = value.toDouble();
    return (number > 0 ? "+" : "") + localNumber(tidyNumber(number));
  }
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* spin = new NumberField(parent);
    spin->setRange(-mostStrength(), mostStrength());
    spin->setDecimals(0);
    spin->setSingleStep(10);
    spin->setAccessibleName(StrengthTable::tr("Force of the structure"));
    return spin;
  }
};

QIcon swatchOf(glm::vec3 color) {
  glm::vec3 c = glm::clamp(color, 0.0f, 1.0f);
  QPixmap pixmap(2 * kSwatch, 2 * kSwatch);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintSwatch(painter, QRectF(0.5, 0.5, kSwatch - 1, kSwatch - 1), QColor::fromRgbF(c.r, c.g, c.b),
              QColor(0, 0, 0, 70));
  return pixmap;
}

QString nameOf(const session::Protectable& one) {
  return one.name.empty() ? StrengthTable::tr("structure %1").arg(one.structure) : QString::fromStdString(one.name);
}

}  // namespace

StrengthTable::StrengthTable(QWidget* parent)
    : QWidget(parent),
      mTable(new QTableWidget(0, 2, this)),
      mAdd(new QComboBox(this)),
      mRemove(new QPushButton(tr("Remove"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  mTable->setObjectName("strengthTable");
  mTable->setAccessibleName(tr("Forces of structures and types"));
  mTable->setToolTip(
      tr("Force of each structure, -1000 to 1000: above 0 the sheet goes around it, below it is drawn to it.\n"
         "Double click a number to change it; Del removes a structure."));
  mTable->horizontalHeader()->hide();
  mTable->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
  mTable->horizontalHeader()->setSectionResizeMode(Strength, QHeaderView::Fixed);
  mTable->setColumnWidth(Strength, kNumberWidth);
  mTable->verticalHeader()->hide();
  mTable->verticalHeader()->setDefaultSectionSize(kRowHeight);
  mTable->verticalHeader()->setMinimumSectionSize(kRowHeight);
  mTable->setShowGrid(false);
  mTable->setTabKeyNavigation(false);
  mTable->setSelectionBehavior(QAbstractItemView::SelectRows);
  mTable->setIconSize(QSize(kSwatch, kSwatch));
  mTable->setItemDelegateForColumn(Strength, new StrengthDelegate(mTable));
  mTable->installEventFilter(this);
  layout->addWidget(mTable);
  auto* row = new QHBoxLayout;
  mAdd->setObjectName("strengthAdd");
  mAdd->setAccessibleName(tr("Add a structure to protect"));
  mAdd->setToolTip(tr("Add a structure that the sheet goes around"));
  mAdd->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row->addWidget(mAdd, 1);
  mRemove->setObjectName("strengthRemove");
  mRemove->setProperty("role", "quiet");
  mRemove->setToolTip(tr("The selected structures have no force any more (Del)"));
  row->addWidget(mRemove);
  layout->addLayout(row);
  connect(mRemove, &QPushButton::clicked, this, &StrengthTable::removeSelected);
  // When the field is closed: the answer may take its row away.
  connect(mTable, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    session::Protectable what = mRows.at(item->data(Qt::UserRole).toULongLong());
    double strength = item->data(Qt::EditRole).toDouble();
    QMetaObject::invokeMethod(
        this, [this, what, strength] { emit strengthAsked(what, strength); }, Qt::QueuedConnection);
  });
  connect(mTable, &QTableWidget::itemSelectionChanged, this,
          [this] { mRemove->setEnabled(!mTable->selectedItems().isEmpty()); });
  connect(mAdd, &QComboBox::activated, this, [this](int index) {
    if (index > 0)
      emit strengthAsked(session::Protectable(mRows.at(mAdd->itemData(index).toULongLong())),
                         session::kProtectStrength);
  });
}

void StrengthTable::showRows(const std::vector<session::Protectable>& rows) {
  setVisible(!rows.empty());
  if (rows == mRows && mAdd->count() > 0) return;
  mRows = rows;
  fill();
}

/// In the order of the lists of structures and of types.
void StrengthTable::fill() {
  const QSignalBlocker quiet(mTable), quietAdd(mAdd);
  QString selected = mTable->currentRow() >= 0 ? mTable->item(mTable->currentRow(), Name)->text() : QString();
  mTable->setRowCount(0);
  mAdd->clear();
  bool hasTypes = std::any_of(mRows.begin(), mRows.end(), [](const auto& one) { return one.structure == 0; });
  mAdd->addItem(hasTypes ? tr("Add a structure or a type") : tr("Add a structure"));
  for (std::size_t i = 0; i < mRows.size(); ++i) {
    const session::Protectable& one = mRows[i];
    if (one.strength == 0.0) {
      mAdd->addItem(swatchOf(one.color), nameOf(one), qulonglong(i));
      continue;
    }
    int row = mTable->rowCount();
    mTable->insertRow(row);
    auto* name = new QTableWidgetItem(swatchOf(one.color), nameOf(one));
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    auto* number = new QTableWidgetItem;
    number->setData(Qt::EditRole, one.strength);
    number->setData(Qt::UserRole, qulonglong(i));
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    mTable->setItem(row, Name, name);
    mTable->setItem(row, Strength, number);
    if (name->text() == selected) mTable->selectRow(row);
  }
  int rows = mTable->rowCount();
  mTable->setFixedHeight(std::min(rows, kMostRows) * kRowHeight + 4);
  mTable->setVisible(rows > 0);
  mRemove->setVisible(rows > 0);
  mRemove->setEnabled(!mTable->selectedItems().isEmpty());
  mAdd->setEnabled(mAdd->count() > 1);
}

void StrengthTable::removeSelected() {
  std::vector<session::Protectable> taken;
  for (const auto& index : mTable->selectionModel()->selectedRows(Strength))
    taken.push_back(mRows.at(index.data(Qt::UserRole).toULongLong()));
  for (const auto& what : taken) emit strengthAsked(what, 0.0);
}

/// Del comes before the command that has the same key.
bool StrengthTable::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (watched == mTable && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete && mRemove->isEnabled()) {
    event->accept();
    if (event->type() == QEvent::KeyPress) removeSelected();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace velum::gui
