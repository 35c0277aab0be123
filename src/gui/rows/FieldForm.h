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
#include "scene/json/FieldFacts.h"
#include "session/command/Command.h"
#include "session/document/Document.h"

namespace velum::gui {

/// What a form says of a field beyond what its fields() says. Its functions are asked at every refresh.
struct FieldText {
  const char* object = "";   ///< Name of the control's object, by which tests find it.
  QString tip = {};          ///< Where there is more to say than what the field means.
  QString name = {};         ///< What is read out; empty: the row's title.
  QString step = {};         ///< The undo step; empty: made of the name, or as `call` has it.
  QString stepOff = {};      ///< The same where a tick is taken away; empty: no other.
  QStringList choices = {};  ///< Of a choice, in the order of its values; empty: their names.
  /// The part of the field's range that is offered; without it all.
  std::function<Range()> range = {};
  std::optional<bool> inPercent = {};  ///< Without it: a number from 0 to 1 is.
  std::function<bool()> isShown = {}, isEnabled = {};
  /// What is shown, in the field's unit, where the path is of no item that is there.
  std::function<double()> number = {};
  /// The command that sets it, where more goes with it than `set` does. @param value  as of `set`
  std::function<session::Call(const std::string& value)> call = {};
};

/// Rows of a form, each of a field of the scene: its label, and a control that is made from the field's fields(), shows
/// it, and changes it by the command `set`. What is dragged is one undo step.
class FieldForm : public QObject {
  Q_OBJECT
 public:
  /// @param root   what the paths of the rows begin with; "cuts.N.membrane." where `place` says which
  /// @param place  the item of the list, from 0; -1: there is none, and nothing is shown or changed
  FieldForm(session::Document& document, QObject* parent, std::string root = {}, std::function<int()> place = {});

  /// How undo steps are named that have no text of their own: "Change %1", with the row's name.
  void setSteps(const QString& steps) { mSteps = steps; }
  /// Rows that are added come into that.
  void setGrid(QGridLayout* grid) { mGrid = grid; }
  /// A row: the title, and the field's control; a tick box and a colour have their title on them.
  /// @param path  behind the root: "finish.contours"
  QWidget* add(const std::string& path, const QString& title, FieldText text = {});
  /// The control alone.
  QWidget* make(QWidget* parent, const std::string& path, const QString& title, FieldText text = {});
  /// Something else in the column of controls.
  void addWidget(QWidget* widget);
  /// Of all controls, but for those that FieldText::isEnabled says it of.
  void setEnabled(bool isEnabled);
  /// Shows the scene. Rows that are not shown are not read.
  void refresh();

  /// A row as laws look at it.
  struct Told {
    std::string path;  ///< with an N for the item
    QWidget* control;
    Range offered;  ///< of numbers, in the field's unit
  };
  std::vector<Told> rows() const;

 private:
  struct Row {
    std::string path;  ///< behind the root
    scene::FieldFacts facts;
    FieldText text;
    QWidget* control = nullptr;
    QLabel* label = nullptr;
  };
  std::string pathOf(const Row& row) const;
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
  std::deque<Row> mRows;  ///< which stay where they are
};

/// A grid of labels and controls. @param parent  null: the grid becomes part of another layout
QGridLayout* makeFieldGrid(QWidget* parent, int labelWidth);

}  // namespace velum::gui
