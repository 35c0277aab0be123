#include "gui/window/HelpWindow.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QImage>
#include <QPushButton>
#include <QShortcut>
#include <QTextBlock>
#include <QUrl>

namespace velum::gui {

namespace {

constexpr int kPageWidth = 900;

/// Pictures no wider than the page.
class Page : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    QImage image(":/guide/" + name.path().section("guide/", -1));
    if (image.width() > kPageWidth - 90) image = image.scaledToWidth(kPageWidth - 90, Qt::SmoothTransformation);
    return image;
  }
};

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), mPage(new Page(this)), mWords(new QLineEdit(this)) {
  setWindowTitle(tr("Velum user guide"));
  auto* layout = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  auto* home = new QPushButton(tr("Guide"), this);
  home->setToolTip(tr("To the beginning of the guide"));
  auto* back = new QPushButton(tr("Back"), this);
  back->setToolTip(tr("To the page before (Alt+Left)"));
  mWords->setPlaceholderText(tr("Find in the guide"));
  mWords->setAccessibleName(tr("Words to find"));
  mWords->setToolTip(tr("Enter finds the next place (Ctrl+F)"));
  mPage->setAccessibleName(tr("User guide"));
  row->addWidget(home);
  row->addWidget(back);
  row->addStretch(1);
  row->addWidget(mWords, 1);
  layout->addLayout(row);
  layout->addWidget(mPage, 1);
  mPage->setOpenExternalLinks(true);
  mPage->setSource(QUrl("qrc:/guide/USER-GUIDE.md"), QTextDocument::MarkdownResource);
  connect(home, &QPushButton::clicked, mPage, &QTextBrowser::home);
  connect(back, &QPushButton::clicked, mPage, &QTextBrowser::backward);
  connect(mWords, &QLineEdit::returnPressed, this, &HelpWindow::find);
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, mWords, qOverload<>(&QWidget::setFocus));
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
  resize(kPageWidth, 860);
}

void HelpWindow::find() {
  if (mPage->find(mWords->text())) return;
  mPage->moveCursor(QTextCursor::Start);  // once round
  mPage->find(mWords->text());
}

}  // namespace velum::gui
