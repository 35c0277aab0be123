#include "gui/extrusion/LeakBox.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/kit/Length.h"
#include "session/command/Command.h"
#include "session/command/GrowthCommands.h"
#include "session/command/StructureCommands.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

LeakBox::LeakBox(session::Session& session, QWidget* parent)
    : QWidget(parent), mSession(session), mText(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  mText->setObjectName("leakText");
  mText->setWordWrap(true);
  column->addWidget(mText);
  auto* row = new QHBoxLayout;
  auto button = [&](const QString& text, const char* name, const QString& tip) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(name);
    made->setToolTip(tip);
    row->addWidget(made);
    return made;
  };
  auto* here = button(tr("As far as here"), "leakHere", tr("It stays as it is, however far it is pulled"));
  auto* on = button(tr("Go on"), "leakGoOn", tr("It is no leak: the structure goes on there"));
  auto* notThis = button(tr("Not this..."), "leakNotThis",
                         tr("Click on what it would flow into, or draw over it: the structure goes on without that.\n"
                            "In the views Ctrl+Shift+click says so at any time"));
  column->addLayout(row);
  hide();
  connect(here, &QPushButton::clicked, this, [this] {
    mSession.growth().acceptLeak();
    refresh();
  });
  connect(on, &QPushButton::clicked, this, &LeakBox::goOn);
  connect(notThis, &QPushButton::clicked, this, [this] {
    if (auto leak = mSession.growth().status().leak) emit notThisAsked(leak->structure);
  });
}

void LeakBox::goOn() {
  Progress progress;
  if (auto leak = mSession.growth().status().leak)
    session::run(mSession, session::GrowOn{session::structureNames(mSession.shown(), {leak->structure})[0]}, progress);
  refresh();
}

/// The text of the box about a leak; the buttons below it offer what to do.
QString LeakBox::textOf(const session::Leak& leak) const {
  const scene::Scene& scene = mSession.document().shown();
  QString name = QString::fromStdString(session::structureName(scene, leak.structure));
  if (leak.times == 0.0)
    return tr("%1 takes most of what there is in the cut, or the darkest values, which are around everything. It has "
              "not grown yet. Narrow its values; or:")
        .arg(name);
  return tr("%1 would flow into something else: %2 out its section becomes %L3 times as large. It is held "
            "there. Narrow its values, draw a barrier, stop at edges, or click on what it is not; or:")
      .arg(name, Length(scene).text(leak.distance))
      .arg(leak.times, 0, 'f', 1);
}

/// The same for a message over the view, as the pointer may be far from the page.
QString LeakBox::saidOf(const session::Leak& leak) const {
  const scene::Scene& scene = mSession.document().shown();
  QString name = QString::fromStdString(session::structureName(scene, leak.structure));
  if (leak.times == 0.0) return tr("%1 is not grown yet: the page Pull out says why, and lets it.").arg(name);
  return tr("%1 is held %2 out, where it would flow into something else: the page Pull out lets it go on.")
      .arg(name, Length(scene).text(leak.distance));
}

void LeakBox::refresh() {
  auto leak = mSession.growth().status().leak;
  setVisible(bool(leak));
  if (leak) mText->setText(textOf(*leak));
  if (leak && (!mSaid || mSaid->structure != leak->structure)) emit held(saidOf(*leak));
  mSaid = leak;
}

}  // namespace velum::gui
