#pragma once
#include <QPushButton>
#include <QWidget>

#include "gui/rows/PictureList.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The lit spheres as pictures: the program's and the user's own, to which more can be added. The list inside is named
/// "litSphere"; its items hold the sphere's name as their data.
class LitSphereGrid : public QWidget {
  Q_OBJECT
 public:
  LitSphereGrid(session::Document& document, QWidget* parent);
  void refresh();
  /// Adds the picture in a file to the scene's lit spheres and chooses it, as one undo step.
  void addOwn(const QString& path);

 signals:
  /// A picture could not be read; one line.
  void failed(const QString& error);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fill();
  void askOwn();

  session::Document& mDocument;
  PictureList* mList;
  std::vector<scene::LitSphere> mOwn;  ///< The user's own spheres that the list shows.
};

}  // namespace velum::gui
