#include "gui/model/HidersBox.h"

#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Text.h"
#include "scene/Scene.h"
#include "session/model/ModelEdit.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

constexpr std::size_t kMostHiders = 5;
constexpr int kBarWidth = 90, kBarHeight = 9;

/// A share as a bar in the colour of the type that has it.
class ShareLabel : public QWidget {
 public:
  ShareLabel(double share, QColor color, QWidget* parent) : QWidget(parent), mShare(share), mColor(color) {
    setFixedSize(kBarWidth, kBarHeight + 6);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    QRectF box(0, 3, width(), kBarHeight);
    painter.fillRect(box, palette().color(QPalette::Mid));
    painter.fillRect(QRectF(box.topLeft(), QSizeF(std::max(1.0, box.width() * mShare), box.height())), mColor);
  }

 private:
  double mShare;
  QColor mColor;
};

QPushButton* makeSmall(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setProperty("role", "quiet");
  button->setToolTip(tip);
  return button;
}

}  // namespace

HidersBox::HidersBox(QWidget* parent) : QFrame(parent), mWords(new QLabel(this)), mRows(new QVBoxLayout) {
  setObjectName("hiders");
  setFrameShape(QFrame::StyledPanel);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(4);
  auto* head = new QHBoxLayout;
  mWords->setObjectName("hidersWords");
  mWords->setWordWrap(true);
  head->addWidget(mWords, 1);
  auto* close = makeSmall(QString::fromUtf8("\u00d7"), tr("Close"), this);
  close->setAccessibleName(tr("Close"));
  connect(close, &QPushButton::clicked, this, &QWidget::hide);
  head->addWidget(close, 0, Qt::AlignTop);
  layout->addLayout(head);
  mRows->setSpacing(2);
  layout->addLayout(mRows);
  auto* clear = new QPushButton(tr("Clear the way"), this);
  clear->setObjectName("clearTheWay");
  clear->setToolTip(tr("Adds a cut that keeps it in view: what stands before it goes, as you turn, too"));
  layout->addWidget(clear);
  connect(clear, &QPushButton::clicked, this, [this] {
    hide();
    emit clearAsked(QString::fromStdString(mHiding.path));
  });
  hide();
}

void HidersBox::addRow(const session::Hider& hider, const scene::ModelLayer& layer) {
  auto* row = new QWidget(this);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  QColor color(0x80, 0x80, 0x80);
  bool isType = !hider.path.empty();
  if (isType) {
    glm::vec3 c = scene::typeColors(layer)[session::typesAt(*layer.data, hider.path).types.front()];
    c = glm::clamp(c, 0.0f, 1.0f);
    color = QColor::fromRgbF(c.r, c.g, c.b);
  }
  line->addWidget(new ShareLabel(hider.share, color, row));
  auto* share = new QLabel(tr("%L1 %").arg(100.0 * hider.share, 0, 'f', hider.share < 0.0995 ? 1 : 0), row);
  share->setMinimumWidth(44);
  share->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  share->setToolTip(tr("Of the pixels that it would take, %1 are taken by this").arg(hider.pixels));
  line->addWidget(share);
  QString path = QString::fromStdString(hider.path);
  auto* name = makeSmall(
      isType ? toText(scene::shownName(layer, hider.path, session::shortName(hider.path))) : tr("What is no model"),
      isType ? readableText(hider.path) : QString(), row);
  name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  name->setStyleSheet("text-align: left;");
  name->setEnabled(isType);
  line->addWidget(name, 1);
  if (isType) {
    auto* hide = makeSmall(tr("Hide"), tr("Hide all of this type"), row);
    connect(hide, &QPushButton::clicked, this, [this, path] { emit hideAsked(path); });
    connect(name, &QPushButton::clicked, this, [this, path] { emit selectAsked(path); });
    line->addWidget(hide);
  }
  mRows->addWidget(row);
}

void HidersBox::showHiding(const session::Hiding& hiding, const scene::ModelLayer& layer) {
  mHiding = hiding;
  mWords->setText(inWords(withoutLinks(hiding.words)));
  while (QLayoutItem* item = mRows->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t i = 0; i < std::min(kMostHiders, hiding.hiders.size()); ++i) addRow(hiding.hiders[i], layer);
  setVisible(true);
}

}  // namespace velum::gui
