#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "app/Inputs.h"
#include "app/Verbs.h"
#include "core/BrickCache.h"
#include "core/Error.h"
#include "io/meshes/WriteMesh.h"
#include "io/volumes/WriteVolume.h"
#include "session/command/DocumentCommands.h"
#include "session/command/MembraneCommands.h"
#include "session/document/Open.h"
#include "session/membrane/HangMembrane.h"
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

/// "#3": a cut by its id, for commands.
std::string keyOf(const scene::Cut& cut) { return fmt::format("#{}", cut.id); }

std::vector<scene::Cut> membranesOf(const scene::Scene& scene) {
  std::vector<scene::Cut> membranes;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.membrane) membranes.push_back(cut);
  return membranes;
}

/// Which options stand for the fields of a new membrane.
const Words kMembraneWords{{"membrane.hang values", "--protect"},
                           {"membrane.hang place", "--protect-at"},
                           {"membrane.hang structures", "--protect-structure"},
                           {"membrane.hang types", "--protect-type"},
                           {"membrane.hang sketch: it fits the curve to its strokes: leave values and place out",
                            "--sketch fits the curve to its strokes: leave --protect and --protect-at out"},
                           {"membrane.hang sketch", "--sketch"},
                           {"membrane.hang avoid", "--avoid"},
                           {"membrane.hang axis", "--axis"},
                           {"membrane.hang leastPiece", "--least-piece"}};

session::HangMembrane newMembrane(const MembraneOptions& options) {
  session::HangMembrane asked;
  asked.values = options.protect;
  asked.place = options.at;
  asked.structures = options.structures;
  asked.types = options.types;
  asked.sketch = options.sketch;
  asked.avoid = options.avoid;
  asked.axis = options.axis;
  asked.position = options.position.value_or(-1.0);
  asked.reach = options.reach.value_or(0.0);
  asked.leastPiece = options.leastPiece;
  asked.denoise = options.denoise;
  return asked;
}

/// The membranes that the scene brings, where another reach or place is asked for.
void placeAnew(session::Session& session, const MembraneOptions& options) {
  for (const scene::Cut& cut : membranesOf(session.scene())) {
    std::string size = fmt::format("cuts.{}.size", scene::cutPlace(session.scene(), cut.id));
    if (options.reach)
      app::run(session, session::SetField{size, fmt::format("{},{},{}", cut.size.x, cut.size.y, *options.reach)});
    if (options.move) app::run(session, session::MoveToKeep{options.reach.has_value(), keyOf(cut)});
  }
}

/// @throw ArgumentError in the words of the option
void expectLeastPiece(const std::string& text) try { session::leastPieceOf(text); } catch (const ArgumentError& error) {
  throw ArgumentError("--least-piece" + std::string(error.what()).substr(std::string_view("leastPiece").size()));
}

/// Pins, kernels, rule, side and noise, on every membrane of the scene.
void putHandsOn(session::Session& session, const MembraneOptions& options) {
  for (const scene::Cut& cut : membranesOf(session.scene())) {
    for (const auto& text : options.kernels) {
      auto n = numbersOf("--kernel", text, 5, "x,y,z,radius,strength");
      if (!(n[3] > 0.0) || !(std::abs(n[4]) <= 1000.0))
        throw ArgumentError(
            fmt::format("--kernel {}: the radius must be more than 0, the strength within -1000 to 1000", text));
      app::run(session, session::PushSheet{{n[0], n[1], n[2]}, n[3], n[4], keyOf(cut)});
    }
    for (const auto& text : options.pins) {
      auto n = numbersOf("--pin", text, 3, "x,y,z");
      app::run(session, session::PinSheet{{n[0], n[1], n[2]}, keyOf(cut)}, {{"membrane.pin", "--pin"}});
    }
    if (auto rule = enumValue<scene::KernelRule>(options.rule))
      app::run(session, session::ChooseRule{*rule, keyOf(cut)});
    std::string field = fmt::format("cuts.{}.membrane.field.", scene::cutPlace(session.scene(), cut.id));
    if (!options.side.empty()) app::run(session, session::SetField{field + "side", options.side});
    if (options.denoise) app::run(session, session::SetField{field + "denoise", "true"});
    if (!options.leastPiece.empty())
      app::run(session,
               session::SetField{field + "leastPiece", std::to_string(session::leastPieceOf(options.leastPiece))});
  }
}

bool asksForMembrane(const MembraneOptions& options) {
  return !options.protect.empty() || !options.at.empty() || !options.structures.empty() || !options.types.empty() ||
         !options.sketch.empty();
}

void hangWhatIsAsked(session::Session& session, const MembraneOptions& options) {
  bool isAsked = asksForMembrane(options), isThere = session::hasMembranes(session.scene());
  if (!isAsked && !options.avoid.empty() && isThere)
    throw ArgumentError(
        "--avoid takes from what a new membrane keeps whole, and the scene has one: say what another is to keep with "
        "--sketch or --protect");
  if (!options.axis.empty() && glm::dvec3(options.axis[0], options.axis[1], options.axis[2]) == glm::dvec3(0.0))
    throw ArgumentError("--axis 0,0,0 has no direction");
  if (isAsked || !isThere)
    app::run(session, newMembrane(options), kMembraneWords);
  else
    placeAnew(session, options);
  putHandsOn(session, options);
}

/// What is left out of what is protected by value.
Json jsonOf(const membrane::LeftOut& leftOut, double voxelVolume) {
  return {{"leastPiece", leftOut.leastPiece},
          {"leastPieceVolume", leftOut.leastPiece * voxelVolume},
          {"pieces", leftOut.pieces},
          {"voxels", leftOut.voxels},
          {"share", double(leftOut.voxels) / double(std::max<std::size_t>(leftOut.protectedVoxels, 1))}};
}

/// What becomes of what is protected, in shares of its volume.
Json jsonOf(const membrane::Fate& fate) {
  return {{"kept", fate.kept}, {"removed", fate.removed}, {"cutOff", fate.cutOff}};
}

/// @param place  of the cut in the scene
Json jsonOf(const session::MembraneReport& report, const scene::Cut& cut, int place) {
  Json json = {{"cut", place},
               {"id", report.cut},
               {"name", report.name},
               {"rule", std::string(enumName(cut.membrane->field.rule))},
               {"side", std::string(enumName(cut.membrane->field.side))},
               {"level", report.voxels.level},
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
  if (report.leftOut) json["leftOut"] = jsonOf(*report.leftOut, report.voxels.volume);
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

void printReport(const session::MembraneReport& report, const scene::Cut& cut, const scene::Scene& scene) {
  LengthUnit unit = scene.unit;
  fmt::print("{}: {} kernels, {} x {} particles, {} after {} steps, {:.1f} ms a step\n",
             report.name.empty() ? "membrane" : report.name, report.kernels, report.particles.x, report.particles.y,
             report.atRest ? "at rest" : "still moving", report.steps, report.stepMs);
  if (scene.volume.data && scene.volume.data->finer)
    fmt::print("forces and figures come from level {} of 0 to {}\n", report.voxels.level,
               scene.volume.data->finer->bricks->source().levels().size() - 1);
  if (!report.kept) return;
  if (report.leftOut && report.leftOut->pieces > 0)
    fmt::print("leaves out {} pieces of fewer than {} voxels ({:.4g} {}^3): {:.2g} % of what is protected by value\n",
               report.leftOut->pieces, report.leftOut->leastPiece, report.leftOut->leastPiece * report.voxels.volume,
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
      "on average\n",
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
  if (!options.leastPiece.empty()) expectLeastPiece(options.leastPiece);
  session::Session session;
  session.setContextKind(options.common.context);
  session.renderer();  // before data is read: without a driver no sheet moves
  openInputs(session, options.input, 16.0 / 9.0);
  hangWhatIsAsked(session, options);
  auto reports = session.membraneReports({true, options.limit}, consoleProgress());
  consoleProgress().report(1.0, "");
  scene::Scene settled = session.settled(consoleProgress());
  if (!options.saveScene.empty()) session::saveScene(session.scene(), options.saveScene);
  auto warnings = exportWhatIsAsked(settled, reports, options);
  Json list = Json::array();
  for (const auto& report : reports) {
    if (options.common.json)
      list.push_back(jsonOf(report, *scene::findCut(settled, report.cut), scene::cutPlace(settled, report.cut)));
    else
      printReport(report, *scene::findCut(settled, report.cut), settled);
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
                  "write the volume with what the cuts remove emptied: .nrrd, .nii, .nii.gz, .vti, .vdb, .zarr, .ozx");
  verb.add_option("--save-scene", options->saveScene, "write the scene with its membranes as JSON");
  return [options] { return run(*options); };
}

}  // namespace velum::app
