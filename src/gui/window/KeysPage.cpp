#include "gui/window/KeysPage.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "gui/window/Findable.h"

namespace velum::gui {

namespace {

QString textOf(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& key : keys) texts << key.toString(QKeySequence::NativeText);
  return texts.join(", ");
}

}  // namespace

KeysPage::KeysPage(ActionTable& actions, QWidget* parent)
    : QWidget(parent),
      mActions(actions),
      mWords(new QLineEdit(this)),
      mTable(new QTreeWidget(this)),
      mKeys(new QKeySequenceEdit(this)),
      mClear(new QPushButton(tr("&None"), this)),
      mUsual(new QPushButton(tr("The &usual ones"), this)),
      mSaid(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 12);
  layout->setSpacing(10);
  mWords->setObjectName("keyWords");
  mWords->setPlaceholderText(tr("Search a command or a key"));
  mWords->setAccessibleName(tr("Search a command or a key"));
  mWords->setToolTip(tr("Words of its name, or keys as they are written"));
  mWords->setClearButtonEnabled(true);
  mTable->setObjectName("keyTable");
  mTable->setAccessibleName(tr("Commands and their keys"));
  mTable->setHeaderLabels({tr("Command"), tr("Keys")});
  mTable->setRootIsDecorated(false);
  mTable->setUniformRowHeights(true);
  mTable->header()->setStretchLastSection(false);
  mTable->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  mTable->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  mKeys->setObjectName("keyEdit");
  mKeys->setAccessibleName(tr("Keys of the chosen command"));
  mKeys->setToolTip(tr("Click here and press the keys for the chosen command"));
  mClear->setToolTip(tr("The chosen command has no key"));
  mUsual->setToolTip(tr("The keys that the program comes with"));
  mSaid->setProperty("role", "muted");
  mSaid->setWordWrap(true);
  layout->addWidget(mWords);
  layout->addWidget(mTable, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(mKeys, 1);
  row->addWidget(mClear);
  row->addWidget(mUsual);
  layout->addLayout(row);
  layout->addWidget(mSaid);
  connect(mWords, &QLineEdit::textChanged, this, &KeysPage::filter);
  connect(mTable, &QTreeWidget::currentItemChanged, this, &KeysPage::showChosen);
  connect(mKeys, &QKeySequenceEdit::editingFinished, this, [this] {
    if (!mKeys->keySequence().isEmpty()) take({mKeys->keySequence()});
  });
  connect(mClear, &QPushButton::clicked, this, [this] { take({}); });
  connect(mUsual, &QPushButton::clicked, this, [this] { take(mActions.usualKeys(chosen())); });
  fill();
  mTable->setCurrentItem(mTable->topLevelItem(0));
}

QString KeysPage::chosen() const {
  QTreeWidgetItem* item = mTable->currentItem();
  return item ? item->data(0, Qt::UserRole).toString() : QString();
}

void KeysPage::fill() {
  for (QAction* action : mActions.all()) {
    auto* item = new QTreeWidgetItem(mTable, {fullName(*action), textOf(action->shortcuts())});
    item->setData(0, Qt::UserRole, action->objectName());
    item->setToolTip(0, action->statusTip());
  }
}

void KeysPage::filter(const QString& words) {
  for (int i = 0; i < mTable->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = mTable->topLevelItem(i);
    bool isIt = true;
    for (const QString& word : words.split(' ', Qt::SkipEmptyParts))
      isIt = isIt && (item->text(0) + " " + item->text(1)).contains(word, Qt::CaseInsensitive);
    item->setHidden(!isIt);
  }
}

void KeysPage::showChosen() {
  QAction* action = mActions.find(chosen());
  for (QWidget* widget : {static_cast<QWidget*>(mKeys), static_cast<QWidget*>(mClear), static_cast<QWidget*>(mUsual)})
    widget->setEnabled(action != nullptr);
  mKeys->setKeySequence(action ? action->shortcut() : QKeySequence());
  mSaid->clear();
}

void KeysPage::take(const QList<QKeySequence>& keys) {
  QString id = chosen(), said;
  QAction* action = mActions.find(id);
  if (!action || action->shortcuts() == keys) return;
  for (const QKeySequence& key : keys)
    if (QAction* other = mActions.withKey(key); other && other != action)
      said = tr("%1 was the key of \u201c%2\u201d, which has it no longer.")
                 .arg(key.toString(QKeySequence::NativeText), fullName(*other));
  QString failure = mActions.setKeys(id, keys);
  for (int i = 0; i < mTable->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = mTable->topLevelItem(i);
    item->setText(1, textOf(mActions.find(item->data(0, Qt::UserRole).toString())->shortcuts()));
  }
  mKeys->setKeySequence(action->shortcut());
  mSaid->setText(failure.isEmpty() ? said : failure);
}

}  // namespace velum::gui
