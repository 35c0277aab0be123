#pragma once
#include <QMenu>
#include <QObject>

#include "gui/service/Selection.h"
#include "gui/view/CameraFlight.h"
#include "session/document/Document.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

/// What can be done to the types of a model, from the page, the menus and the picture alike. Each is one undo step with
/// a name.
class ModelCommands : public QObject {
  Q_OBJECT
 public:
  using Types = session::TypeNumbers;
  ModelCommands(session::Document& document, Selection& selection, QObject* parent);

  void setVisible(const Types& types, bool visible);
  /// Shows types alone, or what was shown before.
  void toggleSolo(const Types& types);
  void setColor(const Types& types, glm::vec3 color);
  /// Asks for a colour and gives it to all of them.
  void chooseColor(const Types& types, QWidget* window);
  /// The palette's colours again.
  void resetColor(const Types& types);
  /// Shown, in the palette's colours.
  void reset(const Types& types);
  /// Brings the camera to all instances of some types, or near to one.
  void goTo(const Types& types);
  void goToInstance(std::uint32_t instance);
  /// Cuts clear what stands before it, or no longer do. @param path  of a type or compartment
  void setInView(const std::string& path, bool kept);
  /// How many of a type or compartment are to be seen; none: any number.
  void setTarget(const std::string& path, std::optional<double> visible);
  /// Asks how many.
  void askTarget(const std::string& path, QWidget* window);
  void setGhosts(const Types& types, std::optional<scene::Ghosts> ghosts);
  /// The entries for one or several types. @param title  what they are  @param path  of the one type or compartment
  /// that they are; empty: several
  void fillMenu(QMenu& menu, const Types& types, const QString& title, const std::string& path);

  session::Document& document() { return mDocument; }
  Selection& selection() { return mSelection; }

 signals:
  /// What hides a type or compartment is to be said.
  void hidingAsked(const QString& path);
  /// What is seen is to be as wanted.
  void targetsAsked();

 private:
  std::vector<std::string> named(const Types& types) const;
  void fillMembraneMenu(QMenu& menu, const Types& types);
  void fillViewMenu(QMenu& menu, const std::string& path);
  void fillGhostMenu(QMenu& menu, const Types& types);
  void flyTo(const session::InstancePlace& place);

  session::Document& mDocument;
  Selection& mSelection;
  session::TypeSoloMemory mSolo;
  CameraFlight mFlight;
};

}  // namespace velum::gui
