#include "gui/window/CommandFinder.h"

#include <QKeyEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Words.h"
#include "gui/rows/RowPaint.h"
#include "session/command/Command.h"

namespace velum::gui {

namespace {

constexpr int kMostShown = 200;
constexpr int kTyped = -1;  ///< In the place of a number in the list of what can be found.
constexpr int kIcon = 20;
enum Role { kBesideRole = Qt::UserRole + 1, kNumberRole };

/// A row: its icon, the menus on the way said quietly, the name, its keys or its number at the right.
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
    QColor off = option.palette.color(QPalette::Disabled, QPalette::Text);
    QColor quiet = isOn ? rowTextColor(option, false) : off, strong = isOn ? rowTextColor(option, true) : off;
    QRect box = option.rect.adjusted(10, 0, -10, 0), sign(box.left(), 0, kIcon, kIcon);
    sign.moveTop(box.center().y() - kIcon / 2);
    bool isChosen = option.state & QStyle::State_Selected;
    index.data(Qt::DecorationRole)
        .value<QIcon>()
        .paint(painter, sign, Qt::AlignCenter,
               !isOn      ? QIcon::Disabled
               : isChosen ? QIcon::Selected
                          : QIcon::Normal);
    box.setLeft(sign.right() + 10);
    QString name = index.data().toString(), way = name.left(name.lastIndexOf(kArrow) + 1);
    QString beside = index.data(kBesideRole).toString();
    painter->setPen(quiet);
    painter->drawText(box, Qt::AlignVCenter | Qt::AlignRight, beside);
    box.setRight(box.right() - option.fontMetrics.horizontalAdvance(beside) - 12);
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

/// "shadows 80": the name, and the number that goes with it.
struct Asked {
  QString letters, number;
};

Asked split(const QString& text) {
  static const QRegularExpression kNumber(R"(^(.*\S)\s+((?:[A-Za-z]\s+)?[-+]?[0-9.,][^\s]*(?:\s*\S+)?)$)");
  QRegularExpressionMatch match = kNumber.match(text.trimmed());
  return match.hasMatch() ? Asked{match.captured(1), match.captured(2)} : Asked{text, {}};
}

}  // namespace

CommandFinder::CommandFinder(std::vector<Findable> all, QWidget* parent, std::function<void(const QString&)> runLine)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint),
      mAll(std::move(all)),
      mRunLine(std::move(runLine)),
      mLetters(new QLineEdit(this)),
      mList(new QListWidget(this)) {
  setObjectName("commandFinder");
  setWindowTitle(tr("Find a command"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 10, 10, 10);
  layout->setSpacing(8);
  mLetters->setPlaceholderText(tr("What do you want to do?"));
  mLetters->setAccessibleName(tr("Letters of the command"));
  mLetters->setToolTip(
      tr("A few letters of a command, preset, structure or number, as \u201cshadows 80\u201d, or a command as in a "
         "script; Up and Down choose, Enter does it, Esc leaves"));
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
  connect(mLetters, &QLineEdit::textChanged, this, [this] { fill(); });
  connect(mLetters, &QLineEdit::returnPressed, this, &CommandFinder::doChosen);
  connect(mList, &QListWidget::itemClicked, this, &CommandFinder::doChosen);
  fill();
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

void CommandFinder::fill() {
  Asked asked = split(mLetters->text());
  struct Row {
    int score, index;
    QString number;
  };
  std::vector<Row> rows;
  for (int i = 0; i < int(mAll.size()); ++i) {
    const Findable& one = mAll[std::size_t(i)];
    // A name with a number in it is as good as a number behind a name.
    int whole = score(mLetters->text(), one.name);
    int part = one.takesNumber && !asked.number.isEmpty() ? score(asked.letters, one.name) : 0;
    if (std::max(whole, part) > 0) rows.push_back({std::max(whole, part), i, part > whole ? asked.number : QString()});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.score > b.score; });
  mList->clear();
  bool isTyped = addTyped();
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), kMostShown); ++i) {
    const Findable& one = mAll[std::size_t(rows[i].index)];
    QString beside = rows[i].number.isEmpty() ? one.beside : one.beside + " \u2192 " + rows[i].number;
    auto* item = new QListWidgetItem(one.icon, one.name, mList);
    item->setData(kBesideRole, beside);
    item->setData(kNumberRole, rows[i].number);
    item->setData(Qt::AccessibleTextRole, beside.isEmpty() ? one.name : QString("%1, %2").arg(one.name, beside));
    item->setData(Qt::UserRole, rows[i].index);
    item->setToolTip(one.tip);
    if (!one.isOn) item->setFlags(Qt::NoItemFlags);
  }
  if (rows.empty() && !isTyped) sayNothingFound();
  mList->setCurrentRow(0);
}

/// A command as in a script, "structure.opacity aorta 0.2", comes first; one that does not fit says why.
bool CommandFinder::addTyped() {
  if (!mRunLine) return false;
  QString line = mLetters->text().trimmed();
  std::string name = line.section(' ', 0, 0).toStdString();
  auto all = session::commands();
  if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name && one.change; }))
    return false;
  auto* item = new QListWidgetItem(mList);
  item->setData(Qt::UserRole, kTyped);
  try {
    session::parseCall(line.toStdString());
    item->setText(tr("Run > %1").arg(line));
    item->setToolTip(wordsOf(session::findCommand(name).doc));
  } catch (const std::exception& error) {
    item->setText(inWords(error.what()));
    item->setFlags(Qt::NoItemFlags);
  }
  return true;
}

void CommandFinder::sayNothingFound() {
  auto* item = new QListWidgetItem(tr("Nothing has these letters in its name. Fewer letters find more."), mList);
  item->setFlags(Qt::NoItemFlags);
}

void CommandFinder::doChosen() {
  QListWidgetItem* item = mList->currentItem();
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
  if (item->data(Qt::UserRole).toInt() == kTyped) {
    QString line = mLetters->text();
    accept();
    return mRunLine(line);
  }
  const Findable& chosen = mAll[std::size_t(item->data(Qt::UserRole).toInt())];
  QString number = item->data(kNumberRole).toString();
  accept();
  chosen.act(number);
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
