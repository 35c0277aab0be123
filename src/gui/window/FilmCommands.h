#pragma once
#include <QHash>

#include "gui/view/Room.h"
#include "session/film/MakeFilm.h"
#include "session/film/ReadyFilms.h"

namespace velum::gui {

/// The commands that make films: ready-made ones, and the film of the scene as a file.
class FilmCommands : public Room {
  Q_OBJECT
 public:
  explicit FilmCommands(const WindowParts& parts);
  void refresh(const session::Session& session) override;
  /// Draws the film of a scene in the background and writes it; what becomes of it is told in the message bar, and what
  /// of it does not come out as it is meant. A film that is cancelled keeps what has been drawn; frames that could not
  /// be drawn are an error, see JobRunner::lastError().
  void saveFilmTo(const session::FilmOutput& output, const scene::Scene& scene);

 public slots:
  void askSaveFilm() { askSave(false); }

 private:
  void askReady(session::ReadyFilm film);
  void askSave(bool asMp4);
  void tell(const session::FilmReport& report, const session::FilmOutput& output,
            const std::vector<std::string>& notes);

  QHash<QString, QAction*> mReady;  ///< by the name of the film
  QAction* mClear;
};

}  // namespace velum::gui
