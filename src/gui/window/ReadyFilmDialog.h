#pragma once
#include <QLabel>
#include <QString>

#include "gui/rows/ArgumentForm.h"
#include "gui/window/FilmDialog.h"
#include "scene/Scene.h"
#include "session/film/ReadyFilms.h"

namespace velum::gui {

/// What a ready-made film is called in menus, with the letter that chooses it: "&Turntable".
QString readyFilmTitle(session::ReadyFilm film);
/// What it shows, one line.
QString readyFilmTip(session::ReadyFilm film);

/// Asks for the numbers of a ready-made film, and shows it as small pictures meanwhile.
class ReadyFilmDialog : public FilmDialog {
  Q_OBJECT
 public:
  /// @param start  when it is to begin, seconds
  ReadyFilmDialog(const scene::Scene& scene, session::ReadyFilm film, double start, QWidget* parent);
  /// The command that adds the film. @throw ArgumentError
  session::Call call() const { return mForm->call(); }
  ArgumentForm& form() { return *mForm; }
  /// The film is to be saved, too.
  bool savesFilm() const { return mSavesFilm; }

 private:
  ArgumentForm::Extra extraOf(session::ReadyFilm film, double start) const;
  void showFilm();
  void tell(const QString& why) override;

  scene::Scene mScene;
  ArgumentForm* mForm;
  QLabel* mSaid;
  bool mSavesFilm = false;
};

}  // namespace velum::gui
