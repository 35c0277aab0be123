#include "gui/look/ShowThisTool.h"

#include "core/Text.h"
#include "gui/kit/Words.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/look/ShowThis.h"

namespace velum::gui {

void ShowThisTool::click(const PointerEvent& event) {
  auto place = event.at.material();
  const auto& volume = mDocument.shown().volume.data;
  if (!place || !volume) return;
  auto tissue = session::measureTissue(mDocument.shown().volume, *place);
  if (!tissue) return;
  bool hide = event.keys & Qt::ControlModifier, add = event.keys & Qt::ShiftModifier;
  session::edit(mDocument, session::ShowThis{*place, hide, add});
  QString unit = QString::fromStdString(volume->unit);
  mMessages.showNote((hide ? tr("Hidden: values around %1 %2") : tr("Shown: values around %1 %2"))
                         .arg(localNumber(tidyNumber(tissue->value)), unit)
                         .trimmed());
}

}  // namespace velum::gui
