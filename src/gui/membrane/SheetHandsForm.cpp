#include "gui/membrane/SheetHandsForm.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Length.h"
#include "gui/kit/Widgets.h"
#include "gui/membrane/SheetHandsPaint.h"
#include "gui/membrane/StrengthCanvas.h"
#include "gui/service/SelectedCut.h"

namespace velum::gui {

namespace {

using session::Hand;
using session::HandKind;

constexpr int kSign = 20, kNameWidth = 86;

/// Pin or kernel as it is drawn over the views.
QIcon signOf(Hand hand, double strength) {
  QPixmap pixmap(kSign * 2, kSign * 2);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  if (hand.kind == HandKind::Pin)
    drawPin(painter, QPointF(7, 15), false, false);
  else
    drawKernel(painter, QPointF(kSign / 2.0, kSign / 2.0), strength, false, false);
  return pixmap;
}

QString nameOf(Hand hand, const scene::Membrane& membrane) {
  if (hand.kind == HandKind::Pin) return SheetHandsForm::tr("Pin %1").arg(hand.index + 1);
  bool pushes = membrane.field.kernels[std::size_t(hand.index)].strength >= 0;
  return (pushes ? SheetHandsForm::tr("Push %1") : SheetHandsForm::tr("Pull %1")).arg(hand.index + 1);
}

}  // namespace

SheetHandsForm::SheetHandsForm(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), mDocument(document), mSelection(selection) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(makeTitle(tr("Pins and forces"), this));
  auto* tools = new QHBoxLayout;
  layout->addLayout(tools);
  auto add = [&](const char* name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    tools->addWidget(button, 1);
    return button;
  };
  mPin = add("pinTool", tr("Pin"),
             tr("Click the sheet in any view and hold it there, or drag it on. Shift: several. (P)"));
  mPush = add("pushTool", tr("Push sheet"),
              tr("Drag a ball in a section, or click in the picture: the sheet goes around it (B)"));
  mPull = add("pullTool", tr("Pull sheet"),
              tr("Drag a ball in a section, or click in the picture: the sheet is drawn to its middle (Shift+B)"));
  mList = new QWidget(this);
  mRowLayout = new QVBoxLayout(mList);
  mRowLayout->setContentsMargins(0, 0, 0, 0);
  mRowLayout->setSpacing(4);
  layout->addWidget(mList);
  mList->hide();
  mUnheld = new QLabel(this);
  mUnheld->setObjectName("unheldPins");
  mUnheld->setWordWrap(true);
  layout->addWidget(mUnheld);
  mUnheld->hide();
}

void SheetHandsForm::edit(const char* label, const std::function<void(scene::Cut&)>& change, bool merge) {
  editSelectedCut(mDocument, mSelection, label, change, merge);
}

void SheetHandsForm::remove(Hand hand) {
  edit(
      hand.kind == HandKind::Pin ? "Remove pin" : "Remove force",
      [hand](scene::Cut& cut) { session::removeHand(*cut.membrane, hand); }, false);
}

NumberField* SheetHandsForm::makeNumber(QWidget* row, double min, double max, int decimals, const QString& suffix,
                                        const QString& name, std::function<void(scene::Cut&, double)> set) {
  auto* spin = new NumberField(row);
  spin->setRange(min, max);
  spin->setDecimals(decimals);
  spin->setSuffix(suffix);
  spin->setAccessibleName(name);
  spin->setToolTip(name);
  connect(spin, &QDoubleSpinBox::valueChanged, this, [this, set = std::move(set)](double value) {
    edit(
        "Change pins and forces", [&](scene::Cut& cut) { set(cut, value); }, true);
  });
  connect(spin, &QDoubleSpinBox::editingFinished, this, [this] { mDocument.endMerge(); });
  return spin;
}

SheetHandsForm::Row SheetHandsForm::makeRow(Hand hand) {
  Row row;
  row.hand = hand;
  row.widget = new QWidget(mList);
  auto* layout = new QHBoxLayout(row.widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  // Its sign and name select it in the views.
  row.name = new QToolButton(row.widget);
  row.name->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  row.name->setIconSize({kSign, kSign});
  row.name->setCheckable(true);
  row.name->setFocusPolicy(Qt::StrongFocus);
  row.name->setFixedWidth(kNameWidth);
  row.name->setToolTip(tr("Select it in the views; Del removes it"));
  row.name->installEventFilter(this);
  layout->addWidget(row.name);
  connect(row.name, &QToolButton::clicked, this, [this, hand](bool on) { emit selectAsked(on ? hand : Hand{}); });
  // Its numbers: of a pin its height, of a kernel radius and strength.
  auto index = std::size_t(hand.index);
  if (hand.kind == HandKind::Pin) {
    row.first = makeNumber(row.widget, 0, 0, 1, {}, tr("Height over the rest plane"),
                           [hand](scene::Cut& cut, double length) { session::setPinHeight(cut, hand, length); });
  } else {
    row.first = makeNumber(row.widget, 0, 0, 1, {}, tr("Radius of the ball"), [index](scene::Cut& cut, double length) {
      if (index < cut.membrane->field.kernels.size()) cut.membrane->field.kernels[index].radius = length;
    });
    row.second = makeNumber(row.widget, -mostStrength(), mostStrength(), 0, {},
                            tr("Strength, -1000 to 1000: above 0 it pushes the sheet away, below it pulls"),
                            [index](scene::Cut& cut, double strength) {
                              if (index < cut.membrane->field.kernels.size())
                                cut.membrane->field.kernels[index].strength = strength;
                            });
  }
  layout->addWidget(row.first, 1);
  if (row.second) layout->addWidget(row.second, 1);
  // The way to be rid of it.
  auto* away = new QToolButton(row.widget);
  away->setText(QString::fromUtf8("\u00d7"));
  away->setFocusPolicy(Qt::StrongFocus);
  away->setToolTip(tr("Remove"));
  away->setObjectName("removeHand");
  layout->addWidget(away);
  connect(away, &QToolButton::clicked, this, [this, hand] { remove(hand); });
  mRowLayout->addWidget(row.widget);
  return row;
}

void SheetHandsForm::showRow(const Row& row, const scene::Cut& cut) {
  auto index = std::size_t(row.hand.index);
  auto set = [](NumberField* spin, double value) {
    const QSignalBlocker quiet(spin);
    spin->setValue(value);
  };
  row.first->setFreeLength(Length(mDocument.shown()), row.hand.kind != HandKind::Pin);
  QString name = nameOf(row.hand, *cut.membrane);
  double strength = 0.0;
  if (row.hand.kind == HandKind::Pin) {
    set(row.first, session::pinHeight(cut, row.hand));
  } else {
    const auto& kernel = cut.membrane->field.kernels[index];
    strength = kernel.strength;
    set(row.first, kernel.radius);
    set(row.second, kernel.strength);
  }
  if (row.name->text() == name) return;
  row.name->setText(name);
  row.name->setIcon(signOf(row.hand, strength));
}

void SheetHandsForm::showCut(const scene::Cut& cut) {
  std::vector<Hand> hands;
  for (int i = 0; i < int(cut.membrane->pins.size()); ++i) hands.push_back({HandKind::Pin, i});
  for (int i = 0; i < int(cut.membrane->field.kernels.size()); ++i) hands.push_back({HandKind::Kernel, i});
  // Rows are kept while they mean the same, so that the keyboard stays where it is.
  while (mRows.size() > hands.size() || (!mRows.empty() && mRows.back().hand != hands[mRows.size() - 1])) {
    mRows.back().widget->hide();  // it may be the one that is speaking
    mRows.back().widget->deleteLater();
    mRows.pop_back();
  }
  while (mRows.size() < hands.size()) mRows.push_back(makeRow(hands[mRows.size()]));
  for (const Row& row : mRows) showRow(row, cut);
  mList->setVisible(!mRows.empty());
  showUnheld(cut);
}

/// Says of each pin that the sheet does not pass through why it does not.
void SheetHandsForm::showUnheld(const scene::Cut& cut) {
  QStringList lines;
  for (const Row& row : mRows) {
    std::string why = session::whyNotHeld(scene::lengthFormat(mDocument.shown()), cut, row.hand);
    if (!why.empty()) lines << tr("%1 %2.").arg(nameOf(row.hand, *cut.membrane), inWords(why));
  }
  mUnheld->setText(lines.join("\n"));
  mUnheld->setVisible(!lines.isEmpty());
}

void SheetHandsForm::showSelected(Hand hand) {
  for (const Row& row : mRows) row.name->setChecked(row.hand == hand);
}

bool SheetHandsForm::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (!isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Delete) return QWidget::eventFilter(watched, event);
  for (const Row& row : mRows)
    if (row.name == watched) {
      event->accept();  // before the command that removes the cut
      if (event->type() == QEvent::KeyPress) remove(row.hand);
      return true;
    }
  return QWidget::eventFilter(watched, event);
}

}  // namespace velum::gui
