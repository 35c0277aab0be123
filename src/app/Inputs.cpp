#include "app/Inputs.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <functional>

#include "app/StandardInput.h"
#include "core/Error.h"
#include "core/Log.h"
#include "core/Memory.h"
#include "core/ReplaceFile.h"
#include "core/Text.h"
#include "io/kinds/FileKind.h"
#include "scene/Finishes.h"
#include "scene/GreyWindows.h"
#include "scene/Presets.h"
#include "scene/SurfaceLook.h"
#include "scene/json/Paths.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LookCommands.h"
#include "session/command/ViewCommands.h"
#include "session/document/Open.h"
#include "session/document/SetFields.h"

namespace velum::app {

namespace {

/// What --window sets, among what --set does: level and width together.
constexpr std::string_view kWindowField = "volume.window";

/// Names of grey windows with their units, for the help.
std::string windowNames() {
  std::string names;
  for (const scene::GreyWindow& window : scene::greyWindows())
    names += (names.empty() ? "" : ", ") + fmt::format("{} ({})", window.name, window.unit);
  return names;
}

std::string finishNames() {
  std::string names;
  for (const scene::NamedFinish& finish : scene::finishes())
    names += (names.empty() ? "" : ", ") + std::string(finish.name);
  return names;
}

}  // namespace

namespace {

/// Options for how much memory volumes of any size take.
void addMemory(CLI::App& verb, bool draws) {
  auto add = [&verb](const char* name, double MemoryBudget::*field, const char* words) {
    verb.add_option_function<std::uint64_t>(
            name,
            [field](const std::uint64_t& bytes) {
              MemoryBudget budget = memoryBudget();
              budget.*field = double(bytes);
              setMemoryBudget(budget);
            },
            words)
        ->transform(CLI::AsSizeValue(true))
        ->type_name("SIZE");
  };
  add("--read-whole", &MemoryBudget::wholeBytes,
      "volumes with levels of detail up to this size are read whole, larger ones are streamed: 2GiB; default 512MiB");
  add("--brick-memory", &MemoryBudget::brickBytes,
      "most memory for the bricks of a streamed volume: 4GiB; default: an eighth of the machine's");
  if (!draws) return;
  add("--gpu-brick-memory", &MemoryBudget::gpuBrickBytes,
      "the same of the GPU's memory: 1GiB; default: a quarter of it, 2GiB at most");
}

}  // namespace

void addInput(CLI::App& verb, InputOptions& input, bool withScene) {
  verb.add_option("input", input.inputs,
                  "data file, DICOM folder, scene or picture of ours, - for standard input; then labels and surfaces")
      ->required();
  verb.add_option(
      "--series", input.series,
      "DICOM series UID, when a folder holds several; of a store: path of an image in it, as info lists them");
  verb.add_option("--level", input.level,
                  "of a pyramid: 0 reads the finest level; else the finest that fits into memory")
      ->check(CLI::Range(0, 62));
  verb.add_option("--spacing", input.spacing, "voxel spacing x,y,z in mm, over the file's own")
      ->delimiter(',')
      ->expected(3);
  verb.add_option("--raw", input.raw, "layout of a file without a header: 256x256x128:uint16[:be][:rgb][:+512]");
  addMemory(verb, withScene);
  if (!withScene) return;
  verb.add_option("--set", input.sets, "change a scene field: path=value, e.g. rayCast.mode=mip; repeatable");
  verb.add_option("--labels", input.labels,
                  "read this file as labels, whatever it looks like; with no other input, alone");
  verb.get_option("input")->required(false);
  verb.add_option("--preset", input.preset, "look by name, e.g. ct-bone");
  verb.add_flag_function(
      "--smooth,!--no-smooth", [&input](std::int64_t count) { input.smooth = count > 0; },
      "cubic between voxels, not linear; by itself where slices are over twice as thick as voxels are wide");
  verb.add_flag("--surface", input.makesSurface,
                "make a look that lets one see through one of surfaces, on which a finish draws its lines");
  verb.add_option("--finish", input.finish, fmt::format("what an illustrator adds: {}", finishNames()));
  verb.add_option("--transfer", input.transfer,
                  "transfer function from a file: .velum-transfer.json, or 3D Slicer's .vp.json or .vp");
  verb.add_option_function<std::string>(
      "--window", [&input](const std::string& text) { input.sets.push_back(std::string(kWindowField) + "=" + text); },
      fmt::format("grey window of sections: width,level in the values' unit (400,50), or one of {}", windowNames()));
  verb.add_flag("--hide-table", input.hidesTable,
                "leave out what is not part of the largest body: the scanner's table, head rests, cables");
  verb.add_option("--view", input.view, "camera: anterior, posterior, left, right, superior, inferior, oblique");
}

namespace {

/// "256x256x128:uint16:be:rgb:+512", the parts after the dimensions in any order.
scene::RawLayout parseRaw(const std::string& text) {
  scene::RawLayout raw;
  auto fail = [&](const std::string& what) {
    throw ArgumentError(fmt::format("--raw {}: {}; expected e.g. 256x256x128:uint16:be:+512", text, what));
  };
  std::size_t colon = text.find(':');
  std::string dims = text.substr(0, colon);
  int read = 0;
  if (std::sscanf(dims.c_str(), "%dx%dx%d%n", &raw.dims.x, &raw.dims.y, &raw.dims.z, &read) != 3 ||
      std::size_t(read) != dims.size())
    fail("the dimensions are not XxYxZ");
  if (raw.dims.x < 1 || raw.dims.y < 1 || raw.dims.z < 1) fail("the dimensions are not positive");
  while (colon != std::string::npos) {
    std::size_t next = text.find(':', colon + 1);
    std::string part = text.substr(colon + 1, next == std::string::npos ? next : next - colon - 1);
    colon = next;
    bool known = false;
    if (auto type = enumValue<SampleType>(part)) raw.type = *type, known = true;
    if (part == "be" || part == "le") raw.bigEndian = part == "be", known = true;
    if (part == "rgb" || part == "rgba") raw.channels = part == "rgb" ? 3 : 4, known = true;
    if (part.size() > 1 && part[0] == '+') {
      auto [end, error] = std::from_chars(part.data() + 1, part.data() + part.size(), raw.headerBytes);
      known = error == std::errc() && end == part.data() + part.size() && raw.headerBytes >= 0;
    }
    if (!known) fail(fmt::format("'{}' is neither a type, be, le, rgb, rgba nor +bytes", part));
  }
  return raw;
}

/// What decides how data is read, and where the camera then stands.
bool isSourceField(const std::string& path) {
  return path.find(".source.") != std::string::npos || path == "model.completes" || path == "model.copies";
}

/// "path=value" in two.
std::vector<scene::FieldValue> splitSets(const std::vector<std::string>& sets) {
  std::vector<scene::FieldValue> out;
  for (const auto& set : sets) {
    std::size_t equals = set.find('=');
    if (equals == std::string::npos) throw ArgumentError(fmt::format("--set {}: expected path=value", set));
    out.push_back({set.substr(0, equals), set.substr(equals + 1)});
  }
  return out;
}

}  // namespace

scene::Source firstSource(const InputOptions& input) {
  scene::Source source;
  source.path = fileOfInput(input.inputs.front());
  source.series = input.series;
  source.level = input.level;
  if (!input.raw.empty()) source.raw = parseRaw(input.raw);
  if (!input.spacing.empty()) source.spacing = {input.spacing[0], input.spacing[1], input.spacing[2]};
  for (double length : input.spacing)
    if (length != 0 && !(length >= scene::kLeastSpacing && length <= scene::kMostSpacing))
      throw ArgumentError(fmt::format("--spacing: {:.6g} mm is outside {:g} .. {:g} mm", length, scene::kLeastSpacing,
                                      scene::kMostSpacing));
  return session::foundInStore(source);
}

namespace {

/// Offers what the window offers beside a finish.
void sayWhereLinesLie(const scene::Scene& scene) {
  const auto& volume = scene.volume.data;
  bool drawsLines = scene.finish.contours > 0 || scene.finish.hatching > 0;
  if (!volume || volume->isColor || !drawsLines || scene.rayCast.mode != scene::RenderMode::Volume) return;
  if (scene::isTranslucent(scene::currentTransfer(scene.volume), computeHistogram(*volume, 1024, scene.volume.channel)))
    log::say(
        "note: the look lets one see through, and lines lie on all that is seen; --surface makes it one of surfaces");
}

}  // namespace

void withOptionsNamed(const Words& options, const std::function<void()>& work) {
  try {
    work();
  } catch (const ArgumentError& error) {
    std::string_view text = error.what();
    for (const auto& [words, option] : options)
      if (text.starts_with(words)) throw ArgumentError(option + std::string(text.substr(words.size())));
    throw;
  }
}

void run(session::Session& session, const session::Call& call, const Words& options) {
  withOptionsNamed(options, [&] {
    for (const std::string& note : session::run(session, call, consoleProgress())) log::warning(note);
  });
}

namespace {

/// What decides where data lies is known before the data is read.
session::DataPolicy policyOf(const std::vector<scene::FieldValue>& sets) {
  session::DataPolicy policy;
  policy.refusesOne = true;
  policy.beforeData = [&sets](scene::Scene& opened) {
    for (const auto& [path, value] : sets)
      if (isSourceField(path)) session::setField(opened, path, value);
  };
  return policy;
}

void openFiles(session::Session& session, const InputOptions& input, const std::vector<scene::FieldValue>& sets) {
  std::vector<scene::Source> sources;
  for (std::size_t i = 0; i < input.inputs.size(); ++i) {
    sources.push_back(i == 0 ? firstSource(input) : scene::Source{});
    if (i > 0) sources.back().path = fileOfInput(input.inputs[i]);
  }
  std::string labels = input.labels.empty() ? std::string() : fileOfInput(input.labels);
  if (sources.empty()) {
    session::Loaded loaded = session::readLabels({}, session::sourcesOf({labels}).front(), consoleProgress());
    return session.file().open(std::move(loaded), labels);
  }
  session::Loaded loaded = session::read(sources, consoleProgress(), policyOf(sets));
  for (const std::string& note : loaded.notes) log::warning(note);
  std::string path = loaded.path;
  session.file().open(std::move(loaded), path);
  if (!labels.empty()) app::run(session, session::AddFile{labels, true});
}

/// Of the scene's own, or as data is first seen, or from the side that is asked for.
void placeCamera(session::Session& session, const InputOptions& input, double aspect, bool hasOwn) {
  if (input.view.empty() && hasOwn) return;
  if (input.view.empty()) return app::run(session, session::LookFirst{aspect});
  app::run(session, session::LookFrom{named<scene::StandardView>("--view", input.view), aspect});
}

}  // namespace

void openInputs(session::Session& session, const InputOptions& input, double aspect) {
  if (input.inputs.empty() && input.labels.empty()) throw ArgumentError("name a file, folder or scene to open");
  openFiles(session, input, splitSets(input.sets));
  consoleProgress().report(1.0, "");
  bool isScene = !input.inputs.empty() && io::holdsScene(io::kindOf(session.file().path()));
  applyInput(session, input, aspect, isScene);
}

void applyInput(session::Session& session, const InputOptions& input, double aspect, bool hasCamera) {
  if (!input.preset.empty()) app::run(session, session::ChoosePreset{input.preset});
  if (input.smooth) app::run(session, session::SetField{"volume.smooth", *input.smooth ? "true" : "false"});
  if (!input.transfer.empty()) app::run(session, session::ImportLook{input.transfer});
  if (input.makesSurface) app::run(session, session::MakeSurface{});
  if (input.hidesTable) app::run(session, session::HideTable{true});
  placeCamera(session, input, aspect, hasCamera);
  if (!input.finish.empty()) app::run(session, session::ChooseFinish{input.finish});
  for (const auto& [path, value] : splitSets(input.sets)) {
    if (path == kWindowField)
      app::run(session, session::ChooseWindow{value}, {{"look.window", "--window"}});
    else
      app::run(session, session::SetField{path, value.empty() ? "\"\"" : value});
  }
  for (const std::string& note : session.grow(consoleProgress())) log::warning(note);
  if (std::string why = scene::whyOneColor(session.scene().model); !why.empty()) log::warning(why);
  if (!input.finish.empty()) sayWhereLinesLie(session.scene());
}

}  // namespace velum::app
