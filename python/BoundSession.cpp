#include "BoundSession.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "Lock.h"
#include "Texts.h"
#include "core/Counts.h"
#include "core/Error.h"
#include "render/kept/StructureHits.h"
#include "scene/json/FieldPaths.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/PythonLines.h"
#include "session/command/SaveFilm.h"
#include "session/document/PutData.h"
#include "session/film/FilmDrawer.h"
#include "session/measure/Table.h"
#include "session/membrane/Membranes.h"
#include "session/model/CountFiles.h"
#include "session/model/PictureCounter.h"
#include "session/picture/Picture.h"
#include "session/structure/StructureAreas.h"

namespace velum::python {

namespace py = pybind11;

namespace {

using Json = nlohmann::ordered_json;

gpu::ContextKind contextOf(const std::string& name) {
  if (auto kind = enumValue<gpu::ContextKind>(name)) return *kind;
  throw ArgumentError(fmt::format("context '{}' is not one of auto, egl, osmesa", name));
}

glm::ivec2 sizeOf(int width, int height) { return session::parsePictureSize(fmt::format("{}x{}", width, height), 0); }

std::string jsonText(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

session::PictureOptions optionsOf(const BoundSession::Wanted& wanted) {
  if (wanted.samples < 0 || wanted.samples > 256)
    throw ArgumentError(fmt::format("samples {}: 0 to 256, 0 as the scene says", wanted.samples));
  return {sizeOf(wanted.width, wanted.height),
          wanted.samples,
          wanted.transparent,
          wanted.layers,
          0,
          wanted.isFine ? 16 : 8};
}

/// What an array was is in no file that a scene could name.
void expectFiles(const scene::Scene& scene) {
  auto expect = [](bool hasData, const scene::Source& source, const char* what) {
    if (hasData && source.path.empty())
      throw ArgumentError(
          fmt::format("save: the {0} are an array, which no scene can name; write them by {0}.save() and "
                      "open the file",
                      what));
  };
  expect(bool(scene.volume.data), scene.volume.source, "volume");
  bool areGrown = !scene.labels.growths.empty() && !scene.labels.given;
  expect(scene.labels.data && !areGrown, scene.labels.source, "labels");
}

Json countsOf(const Counts& counts) {
  Json json;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) json[std::string(kCountKinds[i].name)] = counts.parts[i];
  json["total"] = counts.total();
  return json;
}

Json modelCounts(const scene::Scene& scene, session::PictureCounter& counter) {
  Json rows = Json::array();
  auto types = render::countTypes(*scene.model.data, counter.count(scene));
  for (const session::CountRow& row : session::countRows(scene.model, types)) {
    rows.push_back({{"name", row.name}, {"path", row.path}, {"isCompartment", row.isCompartment}});
    rows.back().update(countsOf(row.count));
  }
  return rows;
}

Json structureCounts(const scene::Scene& scene, session::PictureCounter& counter, Progress& progress) {
  Json rows = Json::array();
  auto hits = render::structureHits(scene, counter.size(), {}, progress);
  for (const session::StructureArea& area : session::structureAreas(scene, hits, counter.structures(scene))) {
    rows.push_back({{"id", area.structure}, {"name", area.name}});
    rows.back().update(countsOf(area.count));
  }
  return rows;
}

}  // namespace

BoundSession::BoundSession(const std::string& context) : mThread(contextOf(context)) {}

BoundSession::~BoundSession() { close(); }

void BoundSession::close() {
  Unlocked unlocked;
  mThread.close();
}

void BoundSession::in(const SessionThread::Work& work) {
  auto pulse = [this](const SessionThread::News* news) {
    Locked locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    py::object told = listener;
    if (news && !told.is_none()) told(news->fraction, textOf(news->what));
  };
  Unlocked unlocked;
  mThread.run(work, pulse);
}

BoundSession::Told BoundSession::run(const std::vector<std::string>& lines) {
  Told told;
  in([&](session::Session& session, Progress& progress) {
    for (const std::string& line : lines) {
      session::Call call = session::parseCall(line);
      if (call.command().name == session::SaveScene::kName) expectFiles(session.scene());
      auto news = session::run(session, call, progress);
      told.isAnswer = call.command().answers;
      told.lines.insert(told.lines.end(), news.begin(), news.end());
      session.settle(progress);
      progress.throwIfCancelled();
    }
  });
  return told;
}

std::string BoundSession::field(const std::string& path) {
  std::string json;
  in([&](session::Session& session, Progress&) {
    json = scene::detail::parseValue(scene::getField(session.scene(), path))
               .dump(-1, ' ', false, Json::error_handler_t::replace);
  });
  return json;
}

std::string BoundSession::program() {
  std::string program;
  in([&](session::Session& session, Progress&) {
    program = session::pythonProgram(session.document().commandLines());
  });
  return program;
}

void BoundSession::openVolume(const Shared<Volume>& volume) {
  in([&](session::Session& session, Progress& progress) {
    session::Loaded loaded;
    loaded.scene = session::sceneOf(volume, progress);
    session.file().open(std::move(loaded), volume->name);
  });
}

void BoundSession::putLabels(const Shared<LabelVolume>& labels) {
  in([&](session::Session& session, Progress& progress) {
    session.document().edit("Put labels that are in no file",
                            [&](scene::Scene& scene) { session::takeLabels(scene, {}, *labels, progress); });
    session.settle(progress);
  });
}

std::optional<Shared<Volume>> BoundSession::volume() {
  Shared<Volume> data;
  in([&](session::Session& session, Progress&) { data = session.scene().volume.data; });
  return data ? std::optional(data) : std::nullopt;
}

std::optional<Shared<LabelVolume>> BoundSession::labels() {
  std::optional<Shared<LabelVolume>> found;
  in([&](session::Session& session, Progress&) {
    const scene::LabelLayer& layer = session.scene().labels;
    if (!layer.data) return;
    LabelVolume labels = *layer.data;
    labels.table.clear();  // names and colours are the scene's
    for (const scene::Structure& structure : layer.structures)
      labels.table.push_back(
          {std::uint16_t(structure.id), structure.name, structure.color, float(structure.opacity), 0});
    found = Shared<LabelVolume>(std::move(labels));
  });
  return found;
}

Image BoundSession::picture(const Wanted& wanted) {
  auto section = session::sectionNamed(wanted.section);
  session::PictureOptions options = optionsOf(wanted);
  Image image;
  in([&](session::Session& session, Progress& progress) {
    image = section ? session::drawSectionPicture(session.settled(progress), *section, options, progress)
                    : session.picture(options, progress);
  });
  return image;
}

/// The source has a reference to the output.
struct BoundSession::Frames::Drawer {
  session::FilmOutput output;
  session::FrameSource source;
};

BoundSession::Frames BoundSession::frames(const std::string& line) {
  session::Call call = session::parseCall(line);
  const auto& film = std::any_cast<const session::SaveFilm&>(call.arguments());
  Frames frames;
  auto begin = [&](session::Session& session, Progress& progress) {
    auto drawer = std::make_shared<Frames::Drawer>(Frames::Drawer{session::outputOf(film), {}});
    drawer->source = session::framesOf(session, session::filmedScene(session.scene(), film, progress), drawer->output);
    frames = {drawer, drawer->source.count};
    mThread.keep(std::move(drawer));
  };
  try {
    in(begin);
  } catch (...) {
    endFrames(frames);  // the last pulse may stop the call when they are there already
    throw;
  }
  return frames;
}

Image BoundSession::frame(const Frames& frames, int frame) {
  Image image;
  in([&](session::Session&, Progress& progress) {
    auto drawer = frames.drawer.lock();
    if (!drawer) throw ArgumentError("these frames have ended");
    image = session::drawFrame(drawer->source, drawer->output, frame, progress).image;
  });
  return image;
}

void BoundSession::endFrames(const Frames& frames) { mThread.drop(frames.drawer); }

std::string BoundSession::measure(bool marks, bool structures, bool faces) {
  std::string json;
  in([&](session::Session& session, Progress& progress) {
    // Only sheets need a driver.
    scene::Scene scene = session::hasMembranes(session.scene()) ? session.settled(progress) : session.scene();
    json = session::tableJson(session::measureAll(scene, {marks, structures, faces}, progress), scene.unit);
  });
  return json;
}

std::string BoundSession::count(int width, int height) {
  glm::ivec2 size = sizeOf(width, height);
  Json rows;
  in([&](session::Session& session, Progress& progress) {
    scene::Scene scene = session.settled(progress);
    if (!scene.model.data && !scene.labels.data)
      throw InputError("there is no model to count in, nor structures: open a file that has them");
    session::PictureCounter counter = session.counter(size, progress);
    rows = scene.model.data ? modelCounts(scene, counter) : structureCounts(scene, counter, progress);
  });
  return jsonText(rows);
}

}  // namespace velum::python
