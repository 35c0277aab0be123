#pragma once
#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "session/command/Command.h"

namespace velum::gui {

/// A form for the arguments of a command, a row each, made from the command's table of arguments: shares of one as
/// sliders in percent, other numbers as fields, choices as lists, truths as tick boxes, texts as lines.
class ArgumentForm : public QWidget {
  Q_OBJECT
 public:
  /// Values among which a text is chosen: what is shown, and the argument's value.
  using Choices = std::vector<std::pair<QString, std::string>>;
  struct Extra {
    std::map<std::string, Choices> choices;        ///< by the argument's name
    std::map<std::string, std::string> beginning;  ///< values other than the default, as commands take them
  };
  ArgumentForm(const session::Command& command, const Extra& extra, QWidget* parent);
  /// The command with what the form shows. @throw ArgumentError
  session::Call call() const;
  /// The control of an argument; null where there is none.
  QWidget* control(const std::string& name) const;
  /// The number of an argument as it is shown; 0 where there is no such number.
  double number(const std::string& name) const;

 signals:
  void changed();

 private:
  struct Row {
    std::string name;
    QWidget* control;
    std::function<std::string()> value;  ///< as a word of a line
  };
  Row makeNumber(const scene::FieldRow& argument, const std::string& value);
  Row makeList(const scene::FieldRow& argument, const Choices& choices, const std::string& value);
  Row makeLine(const scene::FieldRow& argument, const std::string& value);
  Row makeRow(const scene::FieldRow& argument, const Extra& extra);

  const session::Command& mCommand;
  std::vector<Row> mRows;
};

}  // namespace velum::gui
