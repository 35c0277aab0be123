#include "PullSteps.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "velum/scene/Finishes.h"
#include "velum/session/extrusion/Extrusion.h"

namespace velum::gui {

namespace {

struct StepText {
  const char *name, *title, *tip, *text;
};
constexpr std::array<StepText, PullSteps::kCount> kTexts{{
    {"stepCut", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "1 Cut"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Add a plane that opens what is shown"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps",
                       "Cut what is shown open, and drag the cut to where it meets what you want to show.")},
    {"stepPull", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "2 Pull"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Take up the tool that drags structures out of the cut"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps",
                       "Press on a bone, a vessel or an organ in the cut's face and drag it towards you. What has no "
                       "label yet is found from its values as you pull.")},
    {"stepFinish", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "3 Finish"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Go to the page Finish"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps",
                       "Pull out what else belongs to the picture; then choose how it is drawn: as a plate, in pencil, "
                       "in ink.")},
    {"stepSave", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "4 Save"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Save the picture, at any size"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Save the picture. It opens as its scene, to be changed again.")},
}};

}  // namespace

PullSteps::PullSteps(QWidget* parent) : QWidget(parent), mText(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (int i = 0; i < kCount; ++i) {
    const StepText& text = kTexts[std::size_t(i)];
    auto* button = mButtons[std::size_t(i)] = new QPushButton(this);
    button->setObjectName(text.name);
    button->setProperty("role", "small");
    button->setCheckable(true);  // down: the one that comes next
    button->setToolTip(tr(text.tip));
    row->addWidget(button, 1);
    connect(button, &QPushButton::clicked, this, [this, i] {
      showNext();  // a press does not change what is next
      emit asked(static_cast<Step>(i));
    });
  }
  column->addLayout(row);
  mText->setObjectName("stepText");
  mText->setProperty("role", "muted");
  mText->setWordWrap(true);
  column->addWidget(mText);
  showNext();
}

void PullSteps::showScene(const scene::Scene& scene) {
  bool isCut = std::any_of(scene.cuts.begin(), scene.cuts.end(), session::canPullFrom);
  bool isPulled = !session::extrusionsOf(scene).empty();
  std::array<bool, kCount> done{isCut, isPulled, isPulled && scene::addsAnything(scene.finish), false};
  for (auto* button : mButtons) button->setEnabled(scene::hasData(scene));
  if (done == mDone) return;
  mDone = done;
  showNext();
}

void PullSteps::showNext() {
  auto next = std::size_t(std::find(mDone.begin(), mDone.end(), false) - mDone.begin());
  for (std::size_t i = 0; i < mButtons.size(); ++i) {
    QString title = tr(kTexts[i].title);
    mButtons[i]->setText(mDone[i] ? QStringLiteral("\u2713 ") + title.section(' ', 1) : title);
    mButtons[i]->setAccessibleName(mDone[i] ? tr("Step %1, done").arg(title) : tr("Step %1").arg(title));
    mButtons[i]->setChecked(i == next);
  }
  mText->setText(tr(kTexts[next].text));
}

}  // namespace velum::gui
