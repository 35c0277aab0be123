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
  /// Shows these types alone, or, where they are shown alone already, the types that were shown before.
  void toggleSolo(const Types& types);
  void setColor(const Types& types, glm::vec3 color);
  /// Asks for a colour and gives that to all of the types.
  void chooseColor(const Types& types, QWidget* window);
  /// Gives types the palette's colours again.
  void resetColor(const Types& types);
  /// Shows types, in the palette's colours.
  void reset(const Types& types);
  /// Brings the camera to where it sees all instances of some types, or near to one instance.
  void goTo(const Types& types);
  void goToInstance(std::uint32_t instance);
  /// Makes cuts clear the instances that stand before a type or compartment, or no longer do so. @param path  of the
  /// type or compartment
  void setInView(const std::string& path, bool kept);
  /// Sets how many instances of a type or compartment are to be seen; nothing: any number.
  void setTarget(const std::string& path, std::optional<double> visible);
  /// @param name  empty: the file's again
  void rename(const std::string& path, const QString& name);
  /// Lists types or compartments in the legend, or takes them out of its list.
  void listInLegend(const std::vector<std::string>& paths, bool listed);
  void setGhosts(const Types& types, std::optional<scene::Ghosts> ghosts);
  /// Adds the entries for one or several types to a menu. @param title  names the types  @param path  of the single
  /// type or compartment that they are; empty: several are meant
  void fillMenu(QMenu& menu, const Types& types, const QString& title, const std::string& path);

  session::Document& document() { return mDocument; }
  Selection& selection() { return mSelection; }

 signals:
  /// The user asks what hides a type or compartment.
  void hidingAsked(const QString& path);
  /// The user wants to say how many instances of a type or compartment are to be seen.
  void targetWanted(const QString& path);
  /// The user wants to type another name for a type or compartment.
  void renameAsked(const QString& path);
  /// The user wants all targets to be met: as many instances are to be seen as the targets say.
  void targetsAsked();

 private:
  std::vector<std::string> named(const Types& types) const;
  void fillMembraneMenu(QMenu& menu, const Types& types);
  void fillViewMenu(QMenu& menu, const std::string& path);
  void fillNameMenu(QMenu& menu, const Types& types, const std::string& path);
  void fillGhostMenu(QMenu& menu, const Types& types);
  void flyTo(const session::InstancePlace& place);

  session::Document& mDocument;
  Selection& mSelection;
  session::TypeSoloMemory mSolo;
  CameraFlight mFlight;
};

}  // namespace velum::gui
