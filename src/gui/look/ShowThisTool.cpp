#include "gui/look/ShowThisTool.h"

#include "core/Text.h"
#include "session/look/ShowThis.h"

namespace velum::gui {

void ShowThisTool::click(const PointerEvent& event) {
  auto place = event.at.material();
  const auto& volume = mDocument.scene().volume.data;
  if (!place || !volume) return;
  std::optional<session::Tissue> tissue;
  bool hide = event.keys & Qt::ControlModifier, add = event.keys & Qt::ShiftModifier;
  mDocument.edit(hide ? "Hide this tissue" : "Show this tissue", [&](scene::Scene& scene) {
    tissue = hide ? session::hideThis(scene, *place) : session::showThis(scene, *place, add);
  });
  if (!tissue) return;
  QString unit = QString::fromStdString(volume->unit);
  mMessages.showNote((hide ? tr("Hidden: values around %1 %2") : tr("Shown: values around %1 %2"))
                         .arg(QString::fromStdString(tidyNumber(tissue->value)), unit)
                         .trimmed());
}

}  // namespace velum::gui
