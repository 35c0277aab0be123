#include "gui/kit/StepStrip.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace velum::gui {

StepStrip::StepStrip(const char* context, std::vector<GuidedStep> steps, QWidget* parent)
    : QWidget(parent), mContext(context), mSteps(std::move(steps)), mText(new QLabel(this)), mDone(mSteps.size()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (int i = 0; i < int(mSteps.size()); ++i) {
    auto* button = new QPushButton(this);
    mButtons.push_back(button);
    button->setObjectName(mSteps[std::size_t(i)].name);
    button->setProperty("role", "small");
    button->setCheckable(true);  // down: the one that comes next
    button->setToolTip(say(mSteps[std::size_t(i)].tip));
    row->addWidget(button, 1);
    connect(button, &QPushButton::clicked, this, [this, i] {
      showNext();  // a press does not change what is next
      emit pressed(i);
    });
  }
  column->addLayout(row);
  mText->setObjectName("stepText");
  mText->setProperty("role", "muted");
  mText->setWordWrap(true);
  column->addWidget(mText);
  showNext();
}

QString StepStrip::say(const char* text) const { return QCoreApplication::translate(mContext, text); }

void StepStrip::setDone(const std::vector<bool>& done, bool isUsable) {
  for (auto* button : mButtons) button->setEnabled(isUsable);
  if (done == mDone) return;
  mDone = done;
  showNext();
}

void StepStrip::showNext() {
  auto next = std::size_t(std::find(mDone.begin(), mDone.end(), false) - mDone.begin());
  next = std::min(next, mSteps.size() - 1);
  for (std::size_t i = 0; i < mButtons.size(); ++i) {
    QString title = say(mSteps[i].title);
    mButtons[i]->setText(mDone[i] ? QStringLiteral("\u2713 ") + title.section(' ', 1) : title);
    mButtons[i]->setAccessibleName(mDone[i] ? tr("Step %1, done").arg(title) : tr("Step %1").arg(title));
    mButtons[i]->setChecked(i == next);
  }
  mText->setText(say(mSteps[next].text));
}

}  // namespace velum::gui
