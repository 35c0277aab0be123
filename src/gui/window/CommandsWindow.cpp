#include "gui/window/CommandsWindow.h"

#include <QClipboard>
#include <QCompleter>
#include <QFileDialog>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QVBoxLayout>

#include "core/ReplaceFile.h"
#include "gui/kit/CoreWords.h"

namespace velum::gui {

namespace {

constexpr int kPatienceMs = 150;  // a hand that drags does not wait for its lines

QStringList commandNames() {
  QStringList names;
  for (const session::Command& command : session::commands())
    if (command.change) names << QString::fromUtf8(command.name.data(), qsizetype(command.name.size()));
  return names;
}

}  // namespace

CommandsWindow::CommandsWindow(session::Session& session, JobRunner& jobs, QWidget* parent)
    : QWidget(parent, Qt::Window),
      mSession(session),
      mJobs(jobs),
      mLines(new QPlainTextEdit(this)),
      mTyped(new QLineEdit(this)),
      mSaid(new QLabel(this)) {
  setObjectName("commandsWindow");
  setWindowTitle(tr("Commands so far"));
  auto* layout = new QVBoxLayout(this);
  mLines->setObjectName("commandLines");
  mLines->setReadOnly(true);
  mLines->setLineWrapMode(QPlainTextEdit::NoWrap);
  mLines->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  mLines->setAccessibleName(tr("Commands so far"));
  mLines->setToolTip(tr("A script that leads to what is open: velum-batch run FILE does it again"));
  layout->addWidget(mLines, 1);
  mTyped->setObjectName("commandTyped");
  mTyped->setFont(mLines->font());
  mTyped->setPlaceholderText(tr("A command, as cut.add plane"));
  mTyped->setAccessibleName(tr("A command to do"));
  mTyped->setToolTip(
      tr("Enter does it; the names are completed as one types, and the guide's page Commands lists them"));
  auto* completer = new QCompleter(commandNames(), this);
  completer->setFilterMode(Qt::MatchContains);
  mTyped->setCompleter(completer);
  layout->addWidget(mTyped);
  mSaid->setWordWrap(true);
  mSaid->setProperty("role", "muted");
  mSaid->hide();
  layout->addWidget(mSaid);
  auto* row = new QHBoxLayout;
  auto add = [&](const QString& text, const QString& name, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  row->addStretch(1);
  auto* copy = add(tr("&Copy"), "commandsCopy", tr("Copy what is selected, or all lines"));
  auto* file = add(tr("&Save..."), "commandsSave", tr("Write all lines as a script"));
  layout->addLayout(row);
  connect(copy, &QPushButton::clicked, this, [this] {
    QString selected = mLines->textCursor().selectedText().replace(QChar::ParagraphSeparator, '\n');
    QGuiApplication::clipboard()->setText(selected.isEmpty() ? lines() : selected);
  });
  connect(file, &QPushButton::clicked, this, &CommandsWindow::save);
  connect(mTyped, &QLineEdit::returnPressed, this, &CommandsWindow::runTyped);
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
  mPatience.setSingleShot(true);
  mPatience.setInterval(kPatienceMs);
  connect(&mPatience, &QTimer::timeout, this, &CommandsWindow::fill);
  resize(720, 480);
}

void CommandsWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fill();
  mTyped->setFocus();
}

void CommandsWindow::refresh() {
  if (isVisible()) mPatience.start();
}

QString CommandsWindow::lines() const {
  QString text;
  for (const std::string& line : mSession.document().commandLines()) text += QString::fromStdString(line) + '\n';
  return text;
}

/// Whoever reads further up is left there.
void CommandsWindow::fill() {
  QScrollBar* bar = mLines->verticalScrollBar();
  int at = bar->value();
  bool isAtEnd = at >= bar->maximum();
  QString now = lines();
  if (now == mLines->toPlainText()) return;
  mLines->setPlainText(now);
  bar->setValue(isAtEnd ? bar->maximum() : at);
}

void CommandsWindow::runTyped() {
  QString said;
  try {
    session::Call call = session::parseCall(mTyped->text().toStdString());
    bool isFile = call.command().act && !call.command().answers;
    if (isFile) {
      said = tr("%1 is for scripts; in the window the menus do it.").arg(QString::fromUtf8(call.command().name.data()));
    } else if (call.command().answers) {
      Progress progress;
      for (const std::string& line : session::run(mSession, call, progress))
        said += QString::fromStdString(line) + '\n';
    } else {
      mJobs.run(call);
      said = mJobs.lastError();
      if (said.isEmpty()) mTyped->clear();
    }
  } catch (const std::exception& error) {
    said = inWords(error.what());
  }
  mSaid->setText(said.trimmed());
  mSaid->setVisible(!said.isEmpty());
}

void CommandsWindow::save() {
  QString path = QFileDialog::getSaveFileName(this, tr("Save as a script"), "commands.txt", tr("Scripts (*.txt)"));
  if (path.isEmpty()) return;
  QString said = tr("Saved %1").arg(path);
  try {
    replaceFile(path.toStdString(), lines().toStdString());
  } catch (const std::exception& error) {
    said = inWords(error.what());
  }
  mSaid->setText(said);
  mSaid->show();
}

}  // namespace velum::gui
