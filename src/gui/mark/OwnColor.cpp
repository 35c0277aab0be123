#include "gui/mark/OwnColor.h"

#include <QHBoxLayout>

namespace velum::gui {

OwnColor::OwnColor(FieldForm& form, const QString& whose, const char* ownName, const char* colorName,
                   std::function<std::optional<glm::vec3>()> color, QWidget* parent)
    : QWidget(parent), mColorOf(std::move(color)), mOwn(new QCheckBox(tr("Own colour"), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  mOwn->setObjectName(ownName);
  mOwn->setAccessibleName(tr("Own colour of the %1").arg(whose));
  mOwn->setToolTip(tr("Off: as other lettering, dark on a light ground and light on a dark one if that has no colour"));
  connect(mOwn, &QCheckBox::clicked, this, [this](bool on) { emit asked(on ? "1,1,1" : "null"); });
  row->addWidget(mOwn, 1);
  row->addWidget(form.make(this, "color", tr("Colour"),
                           {.object = colorName,
                            .name = tr("Colour of the %1").arg(whose),
                            .step = tr("Change colour of %1").arg(whose),
                            .isShown = [this] { return mColorOf().has_value(); }}));
}

}  // namespace velum::gui
