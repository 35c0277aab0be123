#pragma once
#include <QListWidget>
#include <vector>

namespace velum::gui {

/// A list of things that can be turned off and renamed: an eye, a sign of the kind, a name, and what there is to say of
/// it at the right.
class EyeList : public QListWidget {
  Q_OBJECT
 public:
  struct Row {
    int id = 0;
    const char* icon = "";  ///< for paintIcon(); lives as long as the program
    QString name;
    QString value = {};  ///< at the right
    bool isOn = true;
    bool isDim = false;  ///< on, but not to be seen just now
    QString tip = {};    ///< empty: that of the list
  };
  /// @param mostRows  that are seen before the list scrolls
  EyeList(const char* name, int mostRows, QWidget* parent);
  /// Rows that have not changed are left as they are. @param selected  number of the selected row; -1: none
  void setRows(const std::vector<Row>& rows, int selected);
  /// Id of what is in a row; 0: none.
  int idAt(int row) const;
  /// What a row says at the right.
  QString valueAt(int row) const;

 signals:
  // The user has changed something; `id` is its id.
  void toggled(int id, bool isOn);
  void renamed(int id, const QString& name);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  int mMostRows;
};

}  // namespace velum::gui
