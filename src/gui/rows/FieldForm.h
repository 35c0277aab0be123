#pragma once
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QObject>
#include <QStringList>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gui/kit/Widgets.h"
#include "gui/rows/FieldKey.h"
#include "scene/json/FieldFacts.h"
#include "session/command/Command.h"
#include "session/document/Document.h"

namespace velum::gui {

/// What a form says about a field of the scene in addition to the field's own fields() entry. The functions are called
/// at every refresh.
struct FieldText {
  const char* object = "";   ///< Object name of the control, by which tests find it.
  QString tip = {};          ///< The control's tip; empty: the meaning of the field.
  QString name = {};         ///< What screen readers say; empty: the row's title.
  QString step = {};         ///< Name of the undo step; empty: made of the name above, or the name that `call` gives.
  QString stepOff = {};      ///< Name of the undo step when a tick is taken away; empty: the same name.
  QStringList choices = {};  ///< Texts of a choice's values, in the order of the values; empty: the values' names.
  /// The part of the field's range that the control offers; no function: the whole range.
  std::function<Range()> range = {};
  std::optional<bool> inPercent = {};  ///< Whether a number is shown in percent; nothing: a number from 0 to 1 is.
  std::function<bool()> isShown = {}, isEnabled = {};
  /// The number that is shown instead of the field's value, in the field's unit, where the path may be of no item.
  std::function<double()> number = {};
  /// The command that sets the field, where more has to change than the command `set` does. @param value  as `set`
  /// takes it
  std::function<session::Call(const std::string& value)> call = {};
};

/// Rows of a form, each for a field of the scene: a label, and a control that is made from the field's fields() entry,
/// shows the field and changes it by the command `set`. A drag is one undo step. The menus of label and control make
/// keys of the field; a mark beside the label, or over a control without a row, says that a film changes it.
class FieldForm : public QObject {
  Q_OBJECT
 public:
  /// @param root  beginning of the paths of all rows; "cuts.N.membrane." where `place` says which item N is
  /// @param place  the item's place in the list, from 0; -1: there is no item, and nothing is shown or changed
  FieldForm(session::Document& document, QObject* parent, std::string root = {}, std::function<int()> place = {});

  /// Sets the names of undo steps for fields whose text has none: "Change %1", with the row's name.
  void setSteps(const QString& steps) { mSteps = steps; }
  /// Sets the grid into which rows are added from now on.
  void setGrid(QGridLayout* grid) { mGrid = grid; }
  /// Adds a row: the title, and the field's control; a tick box and a button of a colour have the title on themselves.
  /// @param path  behind the root: "finish.contours"
  QWidget* add(const std::string& path, const QString& title, FieldText text = {});
  /// Makes a field's control without a row.
  QWidget* make(QWidget* parent, const std::string& path, const QString& title, FieldText text = {});
  /// Adds a widget that is of no field to the column of controls. @param title  of its row; empty: it has none
  void addWidget(QWidget* widget, const QString& title = {});
  /// Enables or disables all controls but those whose FieldText has isEnabled.
  void setEnabled(bool isEnabled);
  /// Shows the scene's values. Fields of hidden rows are not read.
  void refresh();

  /// A row as tests check it.
  struct Told {
    std::string path;  ///< with an N for the item
    QWidget* control;
    Range offered;  ///< range that the control offers for a number, in the field's unit
  };
  std::vector<Told> rows() const;

 private:
  struct Row {
    std::string path;  ///< behind the root
    scene::FieldFacts facts;
    FieldText text;
    QWidget* control = nullptr;
    QLabel* label = nullptr;
    FieldKey* key = nullptr;
  };
  std::string pathOf(const Row& row) const;
  Row& makeRow(QWidget* parent, const std::string& path, const QString& title, FieldText text);
  QWidget* makeControl(const Row& row, const QString& title, QWidget* parent);
  QWidget* makeNumber(const Row& row, QWidget* parent);
  QWidget* makeChoice(const Row& row, QWidget* parent);
  void show(const Row& row, const std::string& value);
  void set(const Row& row, const std::string& value, bool merge = false);

  session::Document& mDocument;
  std::string mRoot;
  std::function<int()> mPlace;
  QString mSteps;
  QGridLayout* mGrid = nullptr;
  std::deque<Row> mRows;  ///< a deque, as rows must stay where they are in memory
};

/// A grid of labels and controls. @param parent  null: the grid becomes part of another layout
QGridLayout* makeFieldGrid(QWidget* parent, int labelWidth);

}  // namespace velum::gui
