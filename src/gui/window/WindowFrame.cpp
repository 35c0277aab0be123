#include "gui/window/WindowFrame.h"

#include <QMenuBar>
#include <QVBoxLayout>

#include "gui/kit/Words.h"
#include "gui/service/RecentFiles.h"

namespace velum::gui {

WindowFrame::WindowFrame(QMainWindow& window, session::Document& document, Player& player) {
  auto* centre = new QWidget(&window);
  recovery = new RecoveryBar(centre);
  messages = new MessageBar(centre);
  pages = new QStackedWidget(centre);
  empty = new EmptyState(pages);
  pages->addWidget(empty);
  progress = new ProgressStrip(centre);
  time = new TimeBar(document, player, centre);
  timeline = new TimelineStrip(document, centre);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(pages, 1);
  layout->addWidget(time);
  layout->addWidget(timeline);
  floating = new FloatingBars(*pages);
  floating->addToTop(*recovery);
  floating->addToTop(*messages);
  floating->addToBottom(*progress);
  window.setCentralWidget(centre);
  buildSide(window);
  bar = new ToolStrip(&window);
  window.addToolBar(bar);
  const char* titles[] = {QT_TRANSLATE_NOOP("Words", "&File"),  QT_TRANSLATE_NOOP("Words", "&Edit"),
                          QT_TRANSLATE_NOOP("Words", "&View"),  QT_TRANSLATE_NOOP("Words", "&Look"),
                          QT_TRANSLATE_NOOP("Words", "&Cut"),   QT_TRANSLATE_NOOP("Words", "&Structures"),
                          QT_TRANSLATE_NOOP("Words", "Mar&ks"), QT_TRANSLATE_NOOP("Words", "&Time"),
                          QT_TRANSLATE_NOOP("Words", "Fil&m"),  QT_TRANSLATE_NOOP("Words", "&Help")};
  static_assert(std::size(titles) == std::tuple_size_v<Menus>, "each menu has its title");
  for (std::size_t i = 0; i < menus.size(); ++i) menus[i] = window.menuBar()->addMenu(wordsOf(titles[i]));
}

void WindowFrame::buildSide(QMainWindow& window) {
  dock = new QDockWidget(&window);
  dock->setObjectName("sideDock");
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setTitleBarWidget(new QWidget(dock));
  side = new SidePanel(window, dock);
  tabs = &side->tabs();
  dock->setWidget(side);
  window.addDockWidget(Qt::RightDockWidgetArea, dock);
}

void WindowFrame::showViews(bool open) {
  bool wasOpen = pages->currentIndex() == 1;
  pages->setCurrentIndex(open ? 1 : 0);
  dock->setVisible(open);
  if (wasOpen && !open) empty->recent()->refresh();
}

}  // namespace velum::gui
