#include "gui/kit/SideTabs.h"

#include <QScrollArea>
#include <QTabBar>
#include <QVBoxLayout>

#include "gui/kit/Widgets.h"
#include "gui/kit/Words.h"

namespace velum::gui {

namespace {

constexpr int kMargin = 16, kMarginTop = 14;
constexpr const char* kPageTitle = "title";

/// A page that scrolls where the window is low. The scroll bar stands in the margin, so that the page's widgets do not
/// move.
class PageScroll : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    if (QLayout* page = widget() ? widget()->layout() : nullptr)
      page->setContentsMargins(kMargin, kMarginTop, kMargin - (width() - viewport()->width()), kMarginTop);
    QScrollArea::resizeEvent(event);
  }
};

}  // namespace

SideTabs::SideTabs(QWidget* parent) : QTabWidget(parent) {
  setObjectName("sideTabs");
  setDocumentMode(true);
  tabBar()->setExpanding(true);
}

void SideTabs::addPage(QWidget* panel, const char* title, const QString& tip) {
  auto* scroll = new PageScroll(this);
  scroll->setProperty(kPageTitle, title);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);  // the widgets on the page take it; the area scrolls to them
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* contents = new QWidget(scroll);
  contents->setObjectName("sideContents");
  auto* layout = new QVBoxLayout(contents);
  layout->setContentsMargins(kMargin, kMarginTop, kMargin, kMarginTop);
  layout->setSpacing(14);
  layout->addWidget(panel);
  if (panel->sizePolicy().verticalPolicy() != QSizePolicy::Expanding) layout->addStretch(1);
  scroll->setWidget(contents);
  tabInLayoutOrder(panel);
  setTabToolTip(addTab(scroll, wordsOf(title)), tip);
}

void SideTabs::showPage(const QWidget* panel) {
  for (int i = 0; i < count(); ++i)
    if (widget(i)->isAncestorOf(panel) && isTabVisible(i)) setCurrentIndex(i);
}

void SideTabs::setPageShown(const QWidget* panel, bool shown) {
  for (int i = 0; i < count(); ++i)
    if (widget(i)->isAncestorOf(panel) && isTabVisible(i) != shown) setTabVisible(i, shown);
}

bool SideTabs::showPage(const QString& title) {
  for (int i = 0; i < count(); ++i) {
    auto isIt = [&](const QString& one) { return one.compare(title, Qt::CaseInsensitive) == 0; };
    if (isTabVisible(i) && (isIt(tabText(i)) || isIt(widget(i)->property(kPageTitle).toString()))) {
      setCurrentIndex(i);
      return true;
    }
  }
  return false;
}

}  // namespace velum::gui
