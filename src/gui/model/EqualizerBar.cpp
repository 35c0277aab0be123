#include "gui/model/EqualizerBar.h"

#include <QHBoxLayout>
#include <QMenu>
#include <algorithm>

#include "gui/kit/CutTitle.h"
#include "session/command/Command.h"
#include "session/command/ModelCommands.h"
#include "session/model/ClipState.h"

namespace velum::gui {

namespace {

constexpr int kButtonHeight = 26;

}  // namespace

EqualizerBar::EqualizerBar(session::Document& document, Equalizer& equalizer, QWidget* parent)
    : QWidget(parent), mDocument(document), mEqualizer(equalizer) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(makeStates());
  row->addStretch(1);
  mCuts = new QToolButton(this);
  mCuts->setObjectName("equalizerCuts");
  mCuts->setPopupMode(QToolButton::InstantPopup);
  mCuts->setToolTip(tr("Which cuts the handles of the bars set"));
  auto* menu = new QMenu(mCuts);
  connect(menu, &QMenu::aboutToShow, this, &EqualizerBar::fillCuts);
  mCuts->setMenu(menu);
  mPercent = new QToolButton(this);
  mPercent->setObjectName("equalizerPercent");
  mPercent->setText("%");
  mPercent->setCheckable(true);
  mPercent->setChecked(true);
  mPercent->setToolTip(
      tr("On: bars in percent of their row. Off: numbers on a logarithmic ruler, so that rare types show"));
  mPercent->setAccessibleName(tr("Bars in percent"));
  connect(mPercent, &QToolButton::toggled, this, &EqualizerBar::percentAsked);
  for (QToolButton* button : {mCuts, mPercent}) {
    button->setFixedHeight(kButtonHeight);
    row->addWidget(button);
  }
  refresh();
}

QWidget* EqualizerBar::makeStates() {
  auto* group = new QWidget(this);
  auto* row = new QHBoxLayout(group);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(1);
  const std::pair<QString, QString> states[] = {
      {tr("Whole"), tr("No cut removes anything. Click to turn all cuts off")},
      {tr("Cut"), tr("Where an instance is decides whether it is drawn. Click to give up shares and falloffs")},
      {tr("Thinned"), tr("Of some types a share is left, drawn by lot: move the handles of the bars. Click to have the "
                         "shares again that "
                         "were left by these buttons")}};
  for (const auto& [name, tip] : states) {
    auto* button = new QPushButton(name, group);
    button->setObjectName("state" + name);
    button->setProperty("role", "small");
    button->setCheckable(true);
    button->setToolTip(tip);
    button->setFixedHeight(kButtonHeight);
    int state = int(mStates.size());
    mStates.push_back(button);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, state] { goToState(state); });
  }
  return group;
}

void EqualizerBar::goToState(int state) {
  session::ClipState now = session::clipState(mDocument.shown()), wanted = session::ClipState(state);
  if (wanted != now) {
    if (now == session::ClipState::Thinned) mThinned = mDocument.shown().cuts;
    if (wanted == session::ClipState::Whole) session::edit(mDocument, session::ShowUncut{});
    if (wanted == session::ClipState::Cut) session::edit(mDocument, session::ShowUnthinned{});
    if (wanted == session::ClipState::Thinned && !mThinned.empty())
      session::editByHand(mDocument, "Show thinned", [this](scene::Scene& scene) { scene.cuts = mThinned; });
  }
  showState();
}

void EqualizerBar::showState() {
  session::ClipState now = session::clipState(mDocument.shown());
  for (std::size_t i = 0; i < mStates.size(); ++i) mStates[i]->setChecked(int(i) == int(now));
  // A state can be gone to where there is a way to it: "Cut" needs cuts, "Thinned" needs shares that were there before.
  mStates[int(session::ClipState::Cut)]->setEnabled(!mDocument.shown().cuts.empty());
  mStates[int(session::ClipState::Thinned)]->setEnabled(now == session::ClipState::Thinned || !mThinned.empty());
}

void EqualizerBar::toggleCut(int id, bool on) {
  std::vector<int> chosen = mEqualizer.chosenCuts();
  std::erase(chosen, id);
  if (on) chosen.push_back(id);
  mEqualizer.setCuts(chosen);
  refresh();
}

void EqualizerBar::fillCuts() {
  QMenu* menu = mCuts->menu();
  menu->clear();
  const std::vector<int>& chosen = mEqualizer.chosenCuts();
  QAction* all = menu->addAction(tr("All cuts that are on"));
  all->setCheckable(true);
  all->setChecked(chosen.empty());
  connect(all, &QAction::triggered, this, [this] {
    mEqualizer.setCuts({});
    refresh();
  });
  menu->addSeparator();
  for (const scene::Cut& cut : mDocument.shown().cuts) {
    QAction* action = menu->addAction(cutTitle(mDocument.shown(), cut.id));
    action->setCheckable(true);
    action->setEnabled(cut.enabled);
    action->setChecked(std::find(chosen.begin(), chosen.end(), cut.id) != chosen.end());
    connect(action, &QAction::triggered, this, [this, id = cut.id](bool on) { toggleCut(id, on); });
  }
  if (mDocument.shown().cuts.empty())
    menu->addAction(tr("There is none: the first handle adds one that is everywhere"))->setEnabled(false);
}

void EqualizerBar::refresh() {
  const scene::Scene& scene = mDocument.shown();
  if (mModel != scene.model.data) mThinned.clear();  // shares of another model
  mModel = scene.model.data;
  std::vector<int> chosen = mEqualizer.chosenCuts();
  if (std::erase_if(chosen, [&](int id) { return !scene::findCut(scene, id); }) > 0) mEqualizer.setCuts(chosen);
  QString text = chosen.empty() ? tr("All cuts") : tr("%n cuts", nullptr, int(chosen.size()));
  if (chosen.size() == 1) text = cutTitle(scene, chosen[0]);
  mCuts->setText(mCuts->fontMetrics().elidedText(text, Qt::ElideRight, 84));
  mCuts->setAccessibleName(tr("Handles set: %1").arg(text));
  showState();
}

}  // namespace velum::gui
