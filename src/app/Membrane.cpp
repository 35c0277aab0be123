#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "app/Verbs.h"
#include "core/Error.h"
#include "core/Text.h"
#include "io/meshes/WriteMesh.h"
#include "io/volumes/WriteVolume.h"
#include "scene/Project.h"
#include "session/cut/CutEdit.h"
#include "session/document/Open.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/FirstPlace.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"
#include "session/membrane/SheetHands.h"
#include "session/membrane/Sketch.h"
#include "session/membrane/StrokeSamples.h"
#include "session/model/TypesAt.h"
#include "session/picture/Export.h"

namespace velum::app {

namespace {

struct MembraneOptions {
  Common common;
  InputOptions input;
  std::vector<double> protect, axis, at;
  std::vector<int> structures;
  std::vector<std::string> types, sketch, avoid;
  std::optional<double> position, reach;
  std::vector<std::string> kernels, pins;
  std::string rule, side, leastPiece, saveScene, sheet, clipped;
  bool limit = false, denoise = false, move = false;
};

glm::dvec3 vectorOf(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// The frame as the window would hang it, its axis and its place as asked for.
scene::Cut newMembrane(const scene::Scene& scene, const MembraneOptions& options) {
  scene::Scene seen = scene;
  if (!options.axis.empty()) {
    // The frame hangs across the direction in which one looks.
    seen.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
    seen.camera.eye = seen.camera.target + vectorOf(options.axis) * 1000.0;
  }
  scene::Cut cut = session::makeCut(seen, scene::CutShape::Membrane);
  cut.name = "Membrane";
  // Made along the data's nearest axis, as one that is put in by hand.
  if (!options.axis.empty()) cut.axis = glm::normalize(vectorOf(options.axis));
  scene::Bounds bounds = scene::computeBounds(scene);
  glm::dvec3 middle = (bounds.min + bounds.max) * 0.5, z(scene::worldFromCut(cut)[2]);
  double deep = glm::dot(glm::abs(z), bounds.max - bounds.min);
  cut.centre = middle + z * (deep * (options.position.value_or(0.5) - 0.5));
  if (options.reach) cut.size.z = *options.reach;
  return cut;
}

/// "x,y,z:x,y,z@radius": the points of a path. @param name  of the option
scene::Stroke parseStroke(const std::string& text, const char* name) {
  auto refuse = [&](const char* why) {
    throw ArgumentError(fmt::format("{} {}: {}; expected points and a radius, x,y,z:x,y,z@radius", name, text, why));
  };
  scene::Stroke stroke;
  std::string_view rest = text;
  auto number = [&] {
    double value = takeNumber(rest).value_or(std::nan(""));
    if (!std::isfinite(value)) refuse("a number is missing");
    return value;
  };
  auto take = [&](char mark) {
    bool isNext = rest.starts_with(mark);
    if (isNext) rest.remove_prefix(1);
    return isNext;
  };
  do {
    glm::dvec3 point(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0 && !take(',')) refuse("a point has three numbers");
      point[axis] = number();
    }
    stroke.path.push_back(point);
  } while (take(':'));
  if (take('@')) {
    stroke.radius = number();
    if (!(stroke.radius > 0)) refuse("the radius must be more than 0");
  }
  if (!rest.empty()) refuse("it goes on after its end");
  return stroke;
}

/// Fits the curve to the strokes, as the window does.
void sketchWhatIsAsked(const scene::VolumeLayer& layer, scene::ForceField& field, const MembraneOptions& options) {
  std::vector<scene::Stroke> strokes;
  for (const auto& text : options.sketch) strokes.push_back(parseStroke(text, "--sketch"));
  for (const auto& text : options.avoid) {
    strokes.push_back(parseStroke(text, "--avoid"));
    strokes.back().avoid = true;
  }
  if (strokes.empty()) return;
  if (!layer.data) throw ArgumentError("--sketch, --avoid: there is no volume under the strokes");
  session::setStrokes(field, strokes, layer, session::wholeHistogram(layer));
  if (field.byValue.empty() && !options.sketch.empty())
    throw ArgumentError(
        "--sketch: the strokes lie outside the volume, or nothing under them differs from the rest by its values");
}

void protectWhatIsAsked(scene::Scene& scene, scene::Cut& cut, const MembraneOptions& options) {
  auto& membrane = *cut.membrane;
  if (!options.protect.empty()) {
    if (options.protect[0] >= options.protect[1]) throw ArgumentError("--protect A,B: A must be less than B");
    session::protectValues(membrane, options.protect[0], options.protect[1]);
  }
  for (int id : options.structures) session::protectStructure(membrane, id);
  for (const auto& path : options.types) {
    if (!session::protectsTypes(scene))
      throw ArgumentError("--protect-type: types are protected of a model that is alone in its scene");
    std::vector<int> ids = session::protectableTypes(*scene.model.data, path);
    if (ids.empty()) {
      std::string meant = session::nearestPath(*scene.model.data, path);
      throw ArgumentError(fmt::format("--protect-type {}: no type or compartment of the model is called so{}", path,
                                      meant.empty() ? "" : fmt::format(" (is {} meant?)", meant)));
    }
    for (int id : ids) session::protectStructure(membrane, id);
  }
  if (!options.at.empty() && !session::protectTissue(membrane, scene.volume, vectorOf(options.at)))
    throw ArgumentError(
        fmt::format("--protect-at {},{},{}: that is outside the volume", options.at[0], options.at[1], options.at[2]));
  sketchWhatIsAsked(scene.volume, membrane.field, options);
}

/// Pins and kernels, on every membrane of the scene whose frame is there.
void putHandsOn(scene::Scene& scene, const MembraneOptions& options) {
  for (auto& cut : scene.cuts) {
    if (!scene::isMembrane(cut)) continue;
    for (const auto& text : options.kernels) {
      auto n = numbersOf("--kernel", text, 5, "x,y,z,radius,strength");
      if (!(n[3] > 0.0) || !(std::abs(n[4]) <= 1000.0))
        throw ArgumentError(
            fmt::format("--kernel {}: the radius must be more than 0, the strength within -1000 to 1000", text));
      session::addKernel(*cut.membrane, vectorOf(n), n[3], n[4]);
    }
    for (const auto& text : options.pins) {
      auto pin = session::pinOver(cut, vectorOf(numbersOf("--pin", text, 3, "x,y,z")));
      if (!pin) throw ArgumentError(fmt::format("--pin {}: that is beside the frame of the membrane", text));
      cut.membrane->pins.push_back(*pin);
    }
  }
}

bool asksForMembrane(const MembraneOptions& options) {
  bool byCurve = !options.protect.empty() || !options.at.empty();
  if (byCurve && !options.sketch.empty())
    throw ArgumentError("--sketch fits the curve to its strokes: leave --protect and --protect-at out");
  return byCurve || !options.structures.empty() || !options.types.empty() || !options.sketch.empty();
}

void applyRule(scene::Scene& scene, const std::string& rule, const std::string& side) {
  for (auto& cut : scene.cuts) {
    if (!cut.membrane) continue;
    if (auto wanted = enumValue<scene::KernelRule>(rule)) session::setRule(*cut.membrane, *wanted);
    if (auto wanted = enumValue<scene::MembraneSide>(side)) cut.membrane->field.side = *wanted;
  }
}

void applyNoise(scene::Membrane& membrane, const MembraneOptions& options) {
  std::optional<int> least;
  if (options.leastPiece == "auto") least = -1;
  if (auto voxels = numberIn(options.leastPiece); voxels && *voxels >= 1 && *voxels <= 1e9 && *voxels == int(*voxels))
    least = int(*voxels);
  if (!least && !options.leastPiece.empty())
    throw ArgumentError(
        fmt::format("--least-piece {}: give a number of voxels, 1 or more, or auto", options.leastPiece));
  if (least) membrane.field.leastPiece = *least;
  if (options.denoise) membrane.field.denoise = true;
}

/// The membranes that the scene brings, where another reach or place is asked for.
void placeAnew(scene::Scene& scene, const MembraneOptions& options) {
  for (auto& cut : scene.cuts) {
    if (!scene::isMembrane(cut)) continue;
    if (options.reach) cut.size.z = *options.reach;
    if (options.move) cut = session::placedToKeep(scene, cut, consoleProgress(), !options.reach).value_or(cut);
  }
}

/// What is left out of what is protected by value.
Json jsonOf(const membrane::LeftOut& leftOut, double voxelSize) {
  return {{"leastPiece", leftOut.leastPiece},
          {"leastPieceVolume", leftOut.leastPiece * voxelSize},
          {"pieces", leftOut.pieces},
          {"voxels", leftOut.voxels},
          {"share", double(leftOut.voxels) / double(std::max<std::size_t>(leftOut.protectedVoxels, 1))}};
}

/// What becomes of what is protected, in shares of its volume.
Json jsonOf(const membrane::Fate& fate) {
  return {{"kept", fate.kept}, {"removed", fate.removed}, {"cutOff", fate.cutOff}};
}

/// @param place  of the cut in the scene
/// @param voxelSize  volume of a voxel
Json jsonOf(const session::MembraneReport& report, const scene::Cut& cut, int place, double voxelSize) {
  Json json = {{"cut", place},
               {"id", report.cut},
               {"name", report.name},
               {"rule", std::string(enumName(cut.membrane->field.rule))},
               {"side", std::string(enumName(cut.membrane->field.side))},
               {"kernels", report.kernels},
               {"particles", {report.particles.x, report.particles.y}},
               {"steps", report.steps},
               {"atRest", report.atRest},
               {"stepMs", report.stepMs},
               {"kernelsMs", report.kernelsMs},
               {"leastCutMs", report.leastCutMs},
               {"totalMs", report.totalMs}};
  if (report.kept) {
    json["cutAreaPlane"] = report.kept->cutAreaPlane;
    json["cutAreaMembrane"] = report.kept->cutAreaMembrane;
    json["ratio"] = report.kept->ratio;
    json["meanDistance"] = report.kept->meanDistance;
    membrane::Shares shares = membrane::sharesOf(*report.kept, cut);
    json["shares"] = {{"kept", shares.kept}, {"removed", shares.removed}, {"cut", shares.cut}};
    if (report.kept->fate.isOfSomething) json["protected"] = jsonOf(report.kept->fate);
  }
  if (report.leftOut) json["leftOut"] = jsonOf(*report.leftOut, voxelSize);
  json["reach"] = cut.size.z;
  for (const auto& advice : report.advice)
    json["advice"].push_back({{"step", std::string(enumName(advice.step))},
                              {"reason", std::string(session::reasonOf(advice.step))},
                              {"centre", {advice.cut.centre.x, advice.cut.centre.y, advice.cut.centre.z}},
                              {"reach", advice.cut.size.z},
                              {"protected", jsonOf(advice.fate)},
                              {"cut", advice.cutShare}});
  if (report.limit) {
    json["limit"] = report.limit->figure.ratio;
    json["limitMeanDistance"] = report.limit->figure.meanDistance;
  }
  return json;
}

/// What to do, for somebody at a command line.
std::string adviceInWords(const session::Advice& advice, const scene::Cut& cut, LengthUnit unit) {
  switch (advice.step) {
    case session::AdviceStep::DeepenReach:
      return fmt::format("A reach of {:.4g} {} (--reach)", advice.cut.size.z, symbolOf(unit));
    case session::AdviceStep::MoveToKeep:
      return fmt::format("The frame {:.4g} {} further along its axis, with a reach of {:.4g} {} (--move)",
                         glm::dot(advice.cut.centre - cut.centre, glm::normalize(cut.axis)), symbolOf(unit),
                         advice.cut.size.z, symbolOf(unit));
    case session::AdviceStep::ProtectLess:
      return "Protecting half as much";
  }
  return {};
}

void printReport(const session::MembraneReport& report, const scene::Cut& cut, LengthUnit unit, double voxelSize) {
  fmt::print("{}: {} kernels, {} x {} particles, {} after {} steps, {:.1f} ms a step\n",
             report.name.empty() ? "membrane" : report.name, report.kernels, report.particles.x, report.particles.y,
             report.atRest ? "at rest" : "still moving", report.steps, report.stepMs);
  if (!report.kept) return;
  if (report.leftOut && report.leftOut->pieces > 0)
    fmt::print("leaves out {} pieces of fewer than {} voxels ({:.4g} {}^3): {:.2g} % of what is protected by value\n",
               report.leftOut->pieces, report.leftOut->leastPiece, report.leftOut->leastPiece * voxelSize,
               symbolOf(unit), 100.0 * double(report.leftOut->voxels) / double(report.leftOut->protectedVoxels));
  const membrane::Fate& fate = report.kept->fate;
  if (fate.isOfSomething)
    fmt::print(
        "of all that is protected {:.1f} % is kept, {:.1f} % is removed whole, {:.1f} % is cut off (reach {:.4g} {})\n",
        100.0 * fate.kept, 100.0 * fate.removed, 100.0 * fate.cutOff, cut.size.z, symbolOf(unit));
  membrane::Shares shares = membrane::sharesOf(*report.kept, cut);
  fmt::print("of what the plane would cut {:.0f} % stays whole, {:.0f} % is removed whole, {:.0f} % is cut\n",
             100.0 * shares.kept, 100.0 * shares.removed, 100.0 * shares.cut);
  fmt::print(
      "cuts {} of the {} pairs of protected voxels that the plane cuts (ratio {:.3f}), {:.2f} {} from the rest plane "
      "on "
      "average\n",
      report.kept->cutAreaMembrane, report.kept->cutAreaPlane, report.kept->ratio, report.kept->meanDistance,
      symbolOf(unit));
  for (const auto& advice : report.advice)
    fmt::print("{} {} would keep about {:.0f} % and cut {:.0f} % of what the plane cuts\n",
               session::reasonOf(advice.step), adviceInWords(advice, cut, unit), 100.0 * advice.fate.kept,
               100.0 * advice.cutShare);
  if (report.limit)
    fmt::print("no sheet on this rest plane with this reach can do better than {:.3f}, at {:.2f} {}\n",
               report.limit->figure.ratio, report.limit->figure.meanDistance, symbolOf(unit));
}

/// @return what the files could not hold
std::vector<std::string> exportWhatIsAsked(const scene::Scene& settled,
                                           const std::vector<session::MembraneReport>& reports,
                                           const MembraneOptions& options) {
  std::vector<std::string> warnings;
  auto tell = [&](const std::string& path, const std::vector<std::string>& lines) {
    printWarnings(path, lines);
    warnings.insert(warnings.end(), lines.begin(), lines.end());
  };
  std::vector<int> cuts;
  for (const auto& report : reports) cuts.push_back(report.cut);
  if (!options.sheet.empty()) tell(options.sheet, session::exportSheets(settled, cuts, options.sheet));
  if (options.clipped.empty()) return warnings;
  auto lost = session::exportClippedVolume(settled, options.clipped, consoleProgress());
  consoleProgress().report(1.0, "");
  tell(options.clipped, lost);
  return warnings;
}

int run(const MembraneOptions& options) {
  expectOutput(options.sheet, io::expectMeshFormat);
  expectOutput(options.clipped, io::expectVolumeFormat);
  expectOutput(options.saveScene);
  auto context = gpu::Context::create(options.common.context);
  scene::Scene scene = openScene(options.input, 16.0 / 9.0);
  if (!options.axis.empty() && vectorOf(options.axis) == glm::dvec3(0.0))
    throw ArgumentError("--axis 0,0,0 has no direction");
  bool isAsked = asksForMembrane(options);
  if (!isAsked && !options.avoid.empty() && session::hasMembranes(scene))
    throw ArgumentError(
        "--avoid takes from what a new membrane keeps whole, and the scene has one: say what another is to keep with "
        "--sketch or --protect");
  if (isAsked || !session::hasMembranes(scene)) {
    scene::Cut cut = newMembrane(scene, options);
    if (!isAsked) cut.membrane->field = session::defaultField(scene);
    protectWhatIsAsked(scene, cut, options);
    applyNoise(*cut.membrane, options);
    if (!options.position) cut = session::placedToKeep(scene, cut, consoleProgress(), !options.reach).value_or(cut);
    scene::addCut(scene, cut);
  } else {
    placeAnew(scene, options);
  }
  putHandsOn(scene, options);
  applyRule(scene, options.rule, options.side);
  for (auto& cut : scene.cuts)
    if (cut.membrane) applyNoise(*cut.membrane, options);
  double voxelSize =
      scene.volume.data ? std::abs(glm::determinant(glm::dmat3(scene.volume.data->worldFromVoxel))) : 0.0;
  scene::Scene settled = scene;
  auto reports = session::settleMembranes(settled, {true, options.limit}, consoleProgress());
  consoleProgress().report(1.0, "");
  if (!options.saveScene.empty()) {
    // Where an active sheet rests is where it goes on from.
    for (auto& cut : scene.cuts)
      if (cut.membrane && cut.membrane->repositioning == scene::Repositioning::Active)
        cut.membrane->shape = scene::findCut(settled, cut.id)->membrane->shape;
    session::saveScene(scene, options.saveScene);
  }
  auto warnings = exportWhatIsAsked(settled, reports, options);
  Json list = Json::array();
  for (const auto& report : reports) {
    if (options.common.json)
      list.push_back(
          jsonOf(report, *scene::findCut(settled, report.cut), scene::cutPlace(settled, report.cut), voxelSize));
    else
      printReport(report, *scene::findCut(settled, report.cut), settled.unit, voxelSize);
  }
  if (!options.common.json) return 0;
  Json json = list.size() == 1 ? list[0] : Json{{"membranes", list}};
  json["warnings"] = warnings;
  printJson(json);
  return 0;
}

}  // namespace

Run registerMembrane(CLI::App& verb) {
  auto options = std::make_shared<MembraneOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  auto numbers = [&](const char* name, std::vector<double>& out, int count, const char* text) {
    verb.add_option(name, out, text)->delimiter(',')->expected(count);
  };
  numbers(
      "--protect", options->protect, 2,
      "add a membrane that keeps values from A to B whole: A,B; default, where the scene has none: what it shows most");
  numbers("--protect-at", options->at, 3, "the same for the material at a place, x,y,z: what a click does");
  verb.add_option("--protect-structure", options->structures, "the same for a structure, by label id; repeatable");
  auto repeated = [&](const char* name, std::vector<std::string>& out, const char* text) {
    verb.add_option(name, out, text)->allow_extra_args(false);
  };
  repeated(
      "--protect-type", options->types,
      "the same for a type of a model, or all types of a compartment, by its name or its path with dots; repeatable");
  repeated("--kernel", options->kernels,
           "put a ball in that pushes the sheet away (strength up to 1000) or draws it to its middle (down to -1000): "
           "x,y,z,radius,strength; repeatable");
  repeated("--pin", options->pins,
           "hold the sheet in a place, by its point that lies there when it hangs flat: x,y,z; repeatable");
  verb.add_option("--sketch", options->sketch,
                  "the same for what lies under a stroke, x,y,z:x,y,z@radius (radius 3 if left out); repeatable");
  verb.add_option("--avoid", options->avoid, "a stroke over what the sheet may cut; repeatable");
  numbers("--axis", options->axis, 3,
          "normal of the new membrane's frame, towards what is removed; default: to the eye");
  verb.add_option("--position", options->position,
                  "where along its axis the frame hangs, 0 to 1 of the data; else where it keeps what it protects")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb.add_option("--reach", options->reach,
                  "how far the sheet may go, both sides together, in the scene's unit; default: of a new membrane the "
                  "shortest that keeps what it protects, or, with --position, 0.22 of the frame's mean edge")
      ->check(CLI::PositiveNumber);
  verb.add_flag("--move", options->move,
                "move the membranes that the scene has along their axes to where they keep what they protect, with the "
                "reach that it takes");
  verb.add_option("--rule", options->rule, "how kernels push: sided, paper; default: as the scene says")
      ->check(CLI::IsMember({"sided", "paper"}));
  verb.add_option(
          "--side", options->side,
          "what the section would cut and the sheet can pass by: keep, remove, nearest; default: as the scene says")
      ->check(CLI::IsMember({"keep", "remove", "nearest"}));
  verb.add_option(
      "--least-piece", options->leastPiece,
      "what is protected by value counts in pieces of so many voxels, joined by faces, or more: a number, or "
      "auto, as many as noise does not explain; default: as the scene says, else auto");
  verb.add_flag(
      "--denoise", options->denoise,
      "take noise out of the data before its values say what is protected; --protect-at does so where it must");
  verb.add_flag("--limit", options->limit, "also the least that any sheet in this frame must cut; takes seconds");
  verb.add_option("--sheet", options->sheet, "write the sheet as a surface: .obj, .ply, .vtp, .stl");
  verb.add_option("--clipped", options->clipped,
                  "write the volume with what the cuts remove emptied: .nrrd, .nii, .nii.gz, .vti, .vdb");
  verb.add_option("--save-scene", options->saveScene, "write the scene with its membranes as JSON");
  return [options] { return run(*options); };
}

}  // namespace velum::app
