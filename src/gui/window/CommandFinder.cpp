#include "CommandFinder.h"

#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "kit/RowPaint.h"

namespace velum::gui {

namespace {

constexpr int kMostShown = 200;
constexpr int kKeysRole = Qt::UserRole + 1;

/// A row: the menus on the way said quietly, the command, its keys at the right.
class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {60, option.fontMetrics.height() + 10};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintRowGround(*painter, option, true, true);
    bool isOn = option.state & QStyle::State_Enabled;
    QColor quiet = rowTextColor(option, false), strong = isOn ? rowTextColor(option, true) : quiet;
    if (!isOn) painter->setOpacity(0.6);
    QRect box = option.rect.adjusted(10, 0, -10, 0);
    QString name = index.data().toString(), way = name.left(name.lastIndexOf(kArrow) + 1);
    QString keys = index.data(kKeysRole).toString();
    painter->setPen(quiet);
    painter->drawText(box, Qt::AlignVCenter | Qt::AlignRight, keys);
    box.setRight(box.right() - option.fontMetrics.horizontalAdvance(keys) - 12);
    if (!way.isEmpty()) {
      way += "  ";
      painter->drawText(box, Qt::AlignVCenter | Qt::AlignLeft, way);
      box.setLeft(box.left() + option.fontMetrics.horizontalAdvance(way));
    }
    painter->setPen(strong);
    painter->drawText(box, Qt::AlignVCenter | Qt::AlignLeft, name.mid(name.lastIndexOf(kArrow) + 1).trimmed());
    painter->restore();
  }

 private:
  static constexpr QChar kArrow = '>';
};

/// "Cut > Add plane": the menus on the way, without mnemonics.
QString fullName(const QAction& action) {
  QString name = action.text();
  const QObject* owner = action.parent();
  for (auto* menu = qobject_cast<const QMenu*>(owner); menu; menu = qobject_cast<const QMenu*>(menu->parent()))
    if (!menu->title().isEmpty()) name = menu->title() + " > " + name;
  return name.remove('&').remove("...");
}

}  // namespace

CommandFinder::CommandFinder(const ActionTable& actions, QWidget* parent)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint),
      mActions(actions),
      mLetters(new QLineEdit(this)),
      mList(new QListWidget(this)) {
  setObjectName("commandFinder");
  setWindowTitle(tr("Find a command"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 10, 10, 10);
  layout->setSpacing(8);
  mLetters->setPlaceholderText(tr("What do you want to do?"));
  mLetters->setAccessibleName(tr("Letters of the command"));
  mLetters->setToolTip(tr("A few letters of its name; Up and Down choose, Enter does it, Esc leaves"));
  mLetters->installEventFilter(this);
  mList->setAccessibleName(tr("Commands"));
  mList->setItemDelegate(new Delegate(mList));
  mList->setMouseTracking(true);
  mList->setFocusPolicy(Qt::NoFocus);
  mList->setFocusProxy(mLetters);  // whose arrow keys choose
  layout->addWidget(mLetters);
  layout->addWidget(mList);
  resize(560, 380);
  if (parent) move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, parent->height() / 8)));
  connect(mLetters, &QLineEdit::textChanged, this, &CommandFinder::fill);
  connect(mLetters, &QLineEdit::returnPressed, this, &CommandFinder::doChosen);
  connect(mList, &QListWidget::itemClicked, this, &CommandFinder::doChosen);
  fill({});
}

int CommandFinder::score(const QString& letters, const QString& name) {
  int total = 1;
  qsizetype at = 0, last = -2;
  for (QChar letter : letters) {
    if (letter.isSpace()) continue;
    // The beginning of a word, where there is one ahead; else the next place.
    qsizetype found = -1;
    for (qsizetype i = at; i < name.size() && found < 0; ++i)
      if (name[i].toLower() == letter.toLower() && (i == last + 1 || i == 0 || !name[i - 1].isLetterOrNumber()))
        found = i;
    bool isGood = found >= 0;
    if (!isGood) found = name.indexOf(letter, at, Qt::CaseInsensitive);
    if (found < 0) return 0;
    total += found == last + 1 ? 8 : isGood ? 6 : 1;
    last = found;
    at = found + 1;
  }
  return total;
}

void CommandFinder::fill(const QString& letters) {
  struct Row {
    int score;
    QString name;
    QAction* action;
  };
  std::vector<Row> rows;
  for (QAction* action : mActions.all()) {
    QString name = fullName(*action);
    if (int found = score(letters, name); found > 0) rows.push_back({found, name, action});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.score > b.score; });
  mList->clear();
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), kMostShown); ++i) {
    const Row& row = rows[i];
    QString keys = row.action->shortcut().toString(QKeySequence::NativeText);
    auto* item = new QListWidgetItem(row.name, mList);
    item->setData(kKeysRole, keys);
    item->setData(Qt::AccessibleTextRole, keys.isEmpty() ? row.name : QString("%1, %2").arg(row.name, keys));
    item->setData(Qt::UserRole, row.action->objectName());
    item->setToolTip(row.action->toolTip());
    if (!row.action->isEnabled()) item->setFlags(Qt::NoItemFlags);
  }
  mList->setCurrentRow(0);
}

void CommandFinder::doChosen() {
  QListWidgetItem* item = mList->currentItem();
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
  QAction* action = mActions.find(item->data(Qt::UserRole).toString());
  accept();
  if (action) action->trigger();
}

bool CommandFinder::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    auto* key = static_cast<QKeyEvent*>(event);
    int step = key->key() == Qt::Key_Down ? 1 : key->key() == Qt::Key_Up ? -1 : 0;
    if (step != 0 && mList->count() > 0) {
      mList->setCurrentRow(std::clamp(mList->currentRow() + step, 0, mList->count() - 1));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace velum::gui
