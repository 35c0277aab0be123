#include "session/command/DocumentCommands.h"

#include <filesystem>

#include "session/Session.h"
#include "session/command/CommandRow.h"
#include "session/document/SetFields.h"
#include "session/film/Retarget.h"

namespace velum::session {

PictureOptions optionsOf(const MakePicture& arguments) {
  return {parsePictureSize(arguments.size, arguments.dpi),
          arguments.samples,
          arguments.transparent,
          arguments.layers,
          arguments.dpi,
          PictureOptions().bits,
          arguments.part.empty() ? Part() : parsePart(arguments.part)};
}

namespace {

std::string wholePath(const std::string& path) {
  if (path.empty()) throw ArgumentError("a path is missing");
  return std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace

std::string pathToSave(const WorkFile& file, const SaveScene& asked) {
  if (!asked.path.empty()) return wholePath(asked.path);
  if (!file.scenePath().empty()) return file.scenePath();
  std::filesystem::path data = wholePath(file.path());
  if (!data.has_filename()) data = data.parent_path();
  std::string name = data.filename().string();
  std::filesystem::path beside = data.parent_path() / (name.substr(0, name.find('.', 1)) + ".json");
  if (std::filesystem::exists(beside))
    throw InputError(fmt::format("{}: the file is there already; say where to save", beside.string()));
  return beside.string();
}

namespace detail {

namespace {

using Lines = std::vector<std::string>;

Lines open(Session& session, const OpenFile& arguments, Progress& progress) {
  scene::Source source;
  source.path = wholePath(arguments.path);
  source.series = arguments.series;
  source.level = arguments.level;
  source.raw = arguments.raw;
  source.spacing = arguments.spacing;
  Loaded loaded = read({source}, progress, {});
  Lines notes = loaded.notes;
  session.file().open(std::move(loaded), source.path);
  return notes;
}

Lines addFile(Session& session, const AddFile& arguments, Progress& progress) {
  std::string path = wholePath(arguments.path);
  scene::Source labels;
  labels.path = path;
  labels.series = arguments.series;
  if (!arguments.series.empty()) path += "/" + arguments.series;
  Loaded loaded = arguments.asLabels ? readLabels(session.shown(), labels, progress)
                                     : readBeside(session.shown(), {path}, progress);
  session.file().add(loaded);
  return loaded.notes;
}

Lines carry(Session& session, const CarryScene& arguments, Progress& progress) {
  Lines notes;
  NewData data{wholePath(arguments.volume), arguments.labels.empty() ? std::string() : wholePath(arguments.labels),
               arguments.structure};
  scene::Scene scene = retargeted(session.scene(), data, progress, notes);
  session.file().carry(std::move(scene), Call(arguments).line());
  return notes;
}

Lines makePicture(Session& session, const MakePicture& arguments, Progress& progress) {
  return session.savePicture(optionsOf(arguments), {}, wholePath(arguments.path), progress);
}

Command answering(Command row) {
  row.answers = true;
  return row;
}

void expectStep(bool isThere, const char* what) {
  if (!isThere) throw InputError(fmt::format("there is nothing to {}", what));
}

}  // namespace

std::vector<Command> documentCommands() {
  return {
      actRow<OpenFile>("Opens a file or folder in the place of what is open.", "open head.nii.gz", open),
      actRow<AddFile>("Adds labels, a surface or a model beside what is open.", "add head_labels.seg.nrrd", addFile),
      actRow<CarryScene>("Takes the scene and its film over to other data, such as another patient.",
                         "scene.carry other.nii.gz other_labels.nii.gz liver", carry),
      actRow<SaveScene>("Writes the scene: what is open, and how it is shown.", "save work.json",
                        [](Session& session, const SaveScene& arguments, Progress&) {
                          session.file().save(pathToSave(session.file(), arguments));
                          return Lines();
                        }),
      actRow<MakePicture>("Makes a picture of the scene, with the scene inside.", "picture 1280x720 head.png",
                          makePicture),
      editRow<SetField>(
          "Sets a field of the scene, with all that follows from it.", "set rayCast.mode mip",
          [](const scene::Scene&, const SetField& arguments) { return "Set " + arguments.path; },
          [](scene::Scene& scene, const SetField& arguments) {
            if (arguments.value.empty()) throw ArgumentError("set wants a field and a value");
            setField(scene, arguments.path, arguments.value);
          }),
      answering(actRow<GetField>("Tells what a field of the scene is, as set takes it.", "get camera.eye",
                                 [](Session& session, const GetField& arguments, Progress&) {
                                   return Lines{scene::getField(session.scene(), arguments.path)};
                                 })),
      actRow<Undo>("Takes the last change back.", "undo",
                   [](Session& session, const Undo&, Progress&) {
                     expectStep(session.document().canUndo(), "undo");
                     session.document().undo();
                     return Lines();
                   }),
      actRow<Redo>("Does again what was taken back.", "redo",
                   [](Session& session, const Redo&, Progress&) {
                     expectStep(session.document().canRedo(), "redo");
                     session.document().redo();
                     return Lines();
                   }),
      actRow<Settle>("Waits until sheets rest and all has grown.", "settle",
                     [](Session& session, const Settle&, Progress& progress) {
                       session.settle(progress);
                       return Lines();
                     }),
      answering(actRow<ListCommands>(
          "Tells the commands that lead to what is open, a line each: a script.", "commands",
          [](Session& session, const ListCommands&, Progress&) { return session.document().commandLines(); })),
  };
}

}  // namespace detail

}  // namespace velum::session
