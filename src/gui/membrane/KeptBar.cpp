#include "gui/membrane/KeptBar.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

#include "gui/kit/Words.h"
#include "session/membrane/FirstPlace.h"

namespace velum::gui {

namespace {

/// In percent, with a digit more where a whole number would say all or nothing.
QString shareText(double share) {
  bool isNearEnd = (share > 0.0 && share < 0.095) || (share > 0.905 && share < 1.0);
  return QLocale().toString(100.0 * share, 'f', isNearEnd ? 1 : 0);
}

QString textOf(const session::MembraneStatus& status, bool attracts) {
  const membrane::Fate& fate = status.fate;
  if (!fate.isOfSomething && attracts)
    return KeptBar::tr("The sheet is drawn to what attracts it; nothing is protected from it.");
  if (!fate.isOfSomething) return KeptBar::tr("This membrane protects nothing: say what is to stay with Protect this.");
  QString what = KeptBar::tr("Of what the membrane protects %1 % is kept, %2 % is removed whole, %3 % is cut off.")
                     .arg(shareText(fate.kept), shareText(fate.removed), shareText(fate.cutOff));
  if (!status.advice.empty()) return what + " " + wordsOf(session::reasonOf(status.advice.front().step));
  if (status.wantsAdvice && fate.kept < session::kEnoughKept)
    return what + " " + KeptBar::tr("No place along its axis, and no reach, keeps more.");
  return what;
}

}  // namespace

KeptBar::KeptBar(QWidget* parent) : QFrame(parent), mText(new QLabel(this)) {
  setObjectName("keptBar");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 6, 8, 6);
  layout->setSpacing(8);
  mText->setObjectName("keptText");
  mText->setWordWrap(true);
  mText->setTextFormat(Qt::PlainText);
  mText->setTextInteractionFlags(Qt::TextSelectableByMouse);
  mText->setToolTip(
      tr("By volume, of all that is protected, near the sheet and far from it. Removed whole: pieces of which next to "
         "nothing "
         "stays; cut off: what is taken of pieces of which a part stays."));
  layout->addWidget(mText);
  // Under the text, which a narrow view would squeeze beside them.
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addStretch(1);
  layout->addLayout(row);
  for (int i = 0; i < kMostAdvice; ++i) {
    mButtons[i] = new QPushButton(this);
    mButtons[i]->setObjectName(i == 0 ? "membraneAdvice" : "membraneOtherAdvice");
    mButtons[i]->hide();
    row->addWidget(mButtons[i]);
    connect(mButtons[i], &QPushButton::clicked, this, [this, i] {
      if (std::size_t(i) < mAdvice.size()) emit adviceTaken(mAdvice[std::size_t(i)], mButtons[i]->text());
    });
  }
  hide();
}

void KeptBar::showStatus(const session::MembraneStatus& status, const Length& length, bool attracts) {
  setEnabled(status.isMeasured);
  if (!status.isMeasured) return;
  mText->setText(textOf(status, attracts));
  showAdvice(status.advice, length);
}

void KeptBar::showAdvice(const std::vector<session::Advice>& advice, const Length& length) {
  using Step = session::AdviceStep;
  mAdvice = advice;
  for (std::size_t i = 0; i < kMostAdvice; ++i) {
    QPushButton& button = *mButtons[i];
    button.setVisible(i < advice.size());
    if (i >= advice.size()) continue;
    const session::Advice& one = advice[i];
    QString reach = length.text(one.cut.size.z);
    button.setText(one.step == Step::DeepenReach  ? tr("Deepen the reach to %1").arg(reach)
                   : one.step == Step::MoveToKeep ? tr("Move to where it can be kept")
                                                  : tr("Protect less"));
    QString then = tr("Then about %1 % is kept; the sheet cuts %2 % of what its plane would cut")
                       .arg(shareText(one.fate.kept), shareText(one.cutShare));
    button.setToolTip(one.step == Step::MoveToKeep ? tr("Along its axis, with a reach of %1. %2").arg(reach, then)
                                                   : then);
  }
}

}  // namespace velum::gui
