#include "app/EachPiece.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/FileName.h"
#include "core/Log.h"
#include "core/ReplaceFile.h"
#include "session/document/WorkFile.h"
#include "session/film/Retarget.h"
#include "session/measure/Table.h"
#include "session/membrane/Membranes.h"

namespace velum::app {

namespace {

/// The scene that is carried over, with its data; read when the first piece needs it.
const scene::Scene& sceneToCarry(const std::string& path) {
  static const scene::Scene scene = [&] {
    session::Loaded loaded = session::readPaths({path}, consoleProgress(), {});
    for (const std::string& note : loaded.notes) log::warning(note);
    return std::move(loaded.scene);
  }();
  return scene;
}

void openPiece(session::Session& session, const EachVerb& options, const session::Piece& piece) {
  glm::ivec2 size = pictureOf(options.drawn).size;
  double aspect = double(size.x) / size.y;
  InputOptions input = options.input;
  input.inputs = {piece.data};
  input.labels = piece.labels;
  if (options.scene.empty()) return openInputs(session, input, aspect);
  std::vector<std::string> notes;
  scene::Scene scene = session::retargeted(sceneToCarry(options.scene), {piece.data, piece.labels, options.by},
                                           consoleProgress(), notes);
  for (const std::string& note : notes) log::say(fmt::format("note: {}: {}", piece.data, note));
  session.document().replace(std::move(scene));
  applyInput(session, input, aspect, true);
}

void writeTable(session::Session& session, const EachVerb& options, const std::filesystem::path& path) {
  Progress& progress = consoleProgress();
  scene::Scene scene = session::hasMembranes(session.scene()) ? session.settled(progress) : session.scene();
  auto rows = session::measureAll(scene, {true, options.structures, options.faces}, progress);
  replaceFile(path, lowerExtension(path) == ".json" ? session::tableJson(rows, scene.unit) : session::tableCsv(rows));
}

void makeIn(session::Session& session, const EachVerb& options, const session::Piece& piece) {
  openPiece(session, options, piece);
  writeOver(session, options.lettering);
  session::PictureOptions picture = pictureOf(options.drawn);
  for (const std::filesystem::path& path : piece.outputs) {
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
    if (isTable(path)) {
      writeTable(session, options, path);
      continue;
    }
    for (const std::string& note : session.savePicture(picture, sectionOf(options.drawn), path, consoleProgress()))
      log::warning(fmt::format("{}: {}", path.string(), note));
  }
}

}  // namespace

bool isTable(const std::filesystem::path& path) {
  std::string extension = lowerExtension(path);
  return extension == ".csv" || extension == ".json";
}

PieceMaker::PieceMaker(const EachVerb& options) : mOptions(options) {
  mDraws = options.drawn.section.empty() && !std::ranges::all_of(options.names.outputs, isTable);
  // A machine without a driver is not the fault of the first piece, nor of any other.
  if (mDraws) session().renderer();
}

session::Session& PieceMaker::session() {
  if (!mSession) {
    mSession = std::make_unique<session::Session>();
    mSession->setContextKind(mOptions.common.context);
  }
  return *mSession;
}

void PieceMaker::make(const session::Piece& piece) {
  try {
    makeIn(session(), mOptions, piece);
  } catch (...) {
    mSession.reset();
    throw;
  }
  // The piece is there: what goes wrong from here on is no fault of its, and is not stopped with it.
  try {
    Progress quiet;
    mSession->file().close();
    // A picture of nothing lets go of the data of the last one.
    if (mDraws) mSession->picture({glm::ivec2(1), 1}, quiet);
  } catch (const std::exception&) {
    mSession.reset();
  }
}

}  // namespace velum::app
