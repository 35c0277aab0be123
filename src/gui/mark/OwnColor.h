#pragma once
#include <QCheckBox>
#include <QWidget>
#include <functional>
#include <optional>

#include "gui/rows/FieldForm.h"

namespace velum::gui {

/// A row of a form for a colour that a thing may have of its own: a tick, and the colour where it is set.
class OwnColor : public QWidget {
  Q_OBJECT
 public:
  /// @param whose  "caption", for names and steps  @param name  of the controls for tests, before OwnColor and Color
  /// @param color  of the thing that the form shows; nothing: it has none of its own
  OwnColor(FieldForm& form, const QString& whose, const char* ownName, const char* colorName,
           std::function<std::optional<glm::vec3>()> color, QWidget* parent);
  void refresh() { mOwn->setChecked(mColorOf().has_value()); }

 signals:
  /// The user gives the thing a colour, or takes it away. @param value  of its field `color`, as `set` takes it
  void asked(const std::string& value);

 private:
  std::function<std::optional<glm::vec3>()> mColorOf;
  QCheckBox* mOwn;
};

}  // namespace velum::gui
