#include "gui/model/InsideLine.h"

#include <QPushButton>
#include <QVBoxLayout>
#include <string>

#include "gui/kit/CoreWords.h"
#include "gui/rows/ListParts.h"
#include "scene/Scene.h"
#include "session/model/HiddenInside.h"

namespace velum::gui {

InsideLine::InsideLine(session::Document& document, Equalizer& equalizer, QWidget* parent)
    : QWidget(parent), mDocument(document), mEqualizer(equalizer) {
  setObjectName("modelInside");
  auto* column = makeColumn(this, 4);
  mWords = new QLabel(this);
  mWords->setWordWrap(true);
  column->addWidget(mWords);
  auto* button = new QPushButton(tr("Cut open"), this);
  button->setObjectName("modelCutOpen");
  button->setToolTip(tr("A plane through the middle that faces you (Shift+C)"));
  column->addWidget(button, 0, Qt::AlignLeft);
  connect(button, &QPushButton::clicked, this, &InsideLine::cutAsked);
  connect(&mEqualizer, &Equalizer::counted, this, &InsideLine::showCounts);
  hide();
}

void InsideLine::refresh() {
  // Without cuts the next picture that is counted says more.
  if (!mDocument.shown().cuts.empty()) showCounts();
}

/// By the last complete picture; while something moves, the line stays as it is.
void InsideLine::showCounts() {
  const scene::Scene& scene = mDocument.shown();
  const session::LiveCounts& counts = mEqualizer.counts();
  bool isOfThis = counts.model() && counts.model() == scene.model.data;
  if (isOfThis && !counts.isExact() && scene.cuts.empty()) return;
  std::string words =
      isOfThis ? session::hiddenWords(scene, session::hiddenInside(scene, counts.compartments())) : std::string();
  mWords->setText(inWords(words));
  setVisible(!words.empty());
}

}  // namespace velum::gui
