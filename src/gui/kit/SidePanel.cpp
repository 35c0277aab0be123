#include "gui/kit/SidePanel.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/kit/Preferences.h"

namespace velum::gui {

namespace {

constexpr const char* kSideWidthKey = "view/sideWidth";
constexpr int kRoomyPanel = 430, kRoomyWindow = 1200;  // names, bars and numbers of a model want more of a wide window
constexpr int kHandleWidth = 7, kWidthStep = 24;

/// The strip at the panel's left edge that is dragged, or moved by the arrow keys.
class SideHandle : public QWidget {
 public:
  explicit SideHandle(SidePanel& panel) : QWidget(&panel), mPanel(panel) {
    setObjectName("sideHandle");
    setCursor(Qt::SplitHCursor);
    setFocusPolicy(Qt::TabFocus);
    setAccessibleName(SidePanel::tr("Width of the side panel"));
    setToolTip(
        SidePanel::tr("Drag to make the panel wider or narrower (Left, Right). Double-click: as wide as suits "
                      "what is open (Home)"));
    setFixedWidth(kHandleWidth);
  }

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton) return event->ignore();
    mFrom = event->globalPosition().x() + mPanel.width();
    mIsHeld = true;
    update();
  }
  void mouseMoveEvent(QMouseEvent* event) override {
    if (mIsHeld) mPanel.choose(std::max(1, int(std::lround(mFrom - event->globalPosition().x()))));
  }
  void mouseReleaseEvent(QMouseEvent*) override {
    if (mIsHeld) mPanel.keep();
    mIsHeld = false;
    update();
  }
  void mouseDoubleClickEvent(QMouseEvent*) override { chooseAndKeep(0); }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Left) return chooseAndKeep(mPanel.width() + kWidthStep);
    if (event->key() == Qt::Key_Right) return chooseAndKeep(std::max(1, mPanel.width() - kWidthStep));
    if (event->key() == Qt::Key_Home) return chooseAndKeep(0);
    QWidget::keyPressEvent(event);
  }
  /// These keys act here rather than on commands of the window that have the same keys.
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home) event->accept();
    }
    return QWidget::event(event);
  }
  void enterEvent(QEnterEvent*) override { update(); }
  void leaveEvent(QEvent*) override { update(); }
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(QRect(0, 0, 1, height()), palette().color(QPalette::Mid));
    if (mIsHeld || underMouse() || hasFocus())
      painter.fillRect(QRect(0, 0, 3, height()), palette().color(QPalette::Link));
  }

 private:
  void chooseAndKeep(int pixels) {
    mPanel.choose(pixels);
    mPanel.keep();
  }

  SidePanel& mPanel;
  double mFrom = 0.0;  ///< where the panel would be without any width, pixels of the screen
  bool mIsHeld = false;
};

}  // namespace

SidePanel::SidePanel(QWidget& window, QWidget* parent)
    : QWidget(parent),
      mWindow(window),
      mTabs(nullptr),
      mHandle(new SideHandle(*this)),
      mChosen(std::max(0, Preferences().value(kSideWidthKey, 0).toInt())) {
  setObjectName("sidePanel");
  setAttribute(Qt::WA_StyledBackground);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  mTabs = new SideTabs(this);
  outer->addWidget(mTabs);
  mHandle->raise();
  window.installEventFilter(this);
  fit();
}

void SidePanel::setRoomy(bool isRoomy) {
  mIsRoomy = isRoomy;
  fit();
}

/// What is beyond the ends counts as the end: a handle that was drawn too far comes back at once.
void SidePanel::choose(int pixels) {
  mChosen = pixels > 0 ? std::clamp(pixels, kLeast, std::max(kLeast, mWindow.width() / 2)) : 0;
  fit();
}

void SidePanel::keep() const { Preferences().setValue(kSideWidthKey, mChosen); }

void SidePanel::fit() {
  int suits = mIsRoomy && mWindow.width() >= kRoomyWindow ? kRoomyPanel : kLeast;
  int wanted = std::clamp(mChosen > 0 ? mChosen : suits, kLeast, std::max(kLeast, mWindow.width() / 2));
  if (wanted == minimumWidth() && wanted == maximumWidth()) return;
  setFixedWidth(wanted);
  // A wide panel keeps no window from becoming narrow: it gives way as that does. With the panel at its least the
  // window's layout says how narrow it may be.
  wanted > kLeast ? mWindow.setMinimumWidth(2 * kLeast) : mWindow.setMinimumSize(0, 0);
}

bool SidePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &mWindow && event->type() == QEvent::Resize) fit();
  return QWidget::eventFilter(watched, event);
}

void SidePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  mHandle->resize(kHandleWidth, height());
}

}  // namespace velum::gui
