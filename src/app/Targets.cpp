#include "app/Targets.h"
#include "app/Inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "core/Log.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "session/command/Command.h"
#include "session/model/InstanceNumber.h"
#include "session/model/ModelEdit.h"
#include "session/model/TypesAt.h"

namespace velum::app {

namespace {

/// What "TYPE=N" or "TYPE=P%" asks for.
struct WantedInstances {
  std::string path;
  double number = 0.0;
};

WantedInstances wantedInstances(const scene::Scene& scene, const char* option, const std::string& text) {
  std::size_t equals = text.rfind('=');
  if (equals == std::string::npos)
    throw ArgumentError(fmt::format("{} {}: expected TYPE=N, {}", option, text, session::kInstanceNumberForm));
  if (!scene.model.data) throw InputError(fmt::format("{} {}: there is no model", option, text));
  std::string path = session::typesAt(*scene.model.data, text.substr(0, equals)).path;
  try {
    return {path, session::instanceNumber(scene, path, text.substr(equals + 1))};
  } catch (const ArgumentError& error) {
    throw ArgumentError(fmt::format("{} {}: TYPE=N: {}", option, text, error.what()));
  }
}

/// Puts the options into the scene's targets: what they say of a type is all that is said of it.
void addWanted(scene::Scene& scene, const TargetOptions& options) {
  std::vector<WantedInstances> drawn, seen;
  for (const std::string& text : options.counts) drawn.push_back(wantedInstances(scene, "--set-count", text));
  for (const std::string& text : options.visibles) seen.push_back(wantedInstances(scene, "--set-visible", text));
  for (const WantedInstances& wanted : seen) session::setVisibleTarget(scene, wanted.path, wanted.number);
  for (const WantedInstances& wanted : drawn) {
    auto both = std::find_if(seen.begin(), seen.end(), [&](const auto& one) { return one.path == wanted.path; });
    session::holdDrawn(scene, wanted.path, wanted.number);
    if (both == seen.end()) continue;
    for (scene::TypeTarget& target : scene.model.targets)
      if (target.type == wanted.path) target.visible = both->number;
  }
}

}  // namespace

WantedNumber wantedNumber(const char* option, const std::string& text, const char* form, bool mayBePercent) {
  std::size_t equals = text.rfind('=');
  std::string_view number = equals == std::string::npos ? "" : std::string_view(text).substr(equals + 1);
  WantedNumber wanted{text.substr(0, equals)};
  wanted.isPercent = mayBePercent && number.ends_with('%');
  if (wanted.isPercent) number.remove_suffix(1);
  auto value = numberIn(number);
  if (!value || !std::isfinite(*value) || *value < 0.0 || (wanted.isPercent && *value > 100.0))
    throw ArgumentError(fmt::format("{} {}: expected {}", option, text, form));
  wanted.number = *value;
  return wanted;
}

void addTargets(CLI::App& verb, TargetOptions& options) {
  verb.add_option("--set-count", options.counts,
                  "let cuts leave N instances of a type or compartment, or P % of them: TYPE=N or TYPE=P%, by its path "
                  "or the end of it; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--set-visible", options.visibles, "the same until N of them show in the picture; repeatable")
      ->allow_extra_args(false);
  verb.add_flag("--meet-targets", options.meets,
                "let cuts leave as many as the scene's own numbers say (model.targets), for this picture");
}

std::optional<session::TargetsReport> settleTargets(session::Session& session, const TargetOptions& options,
                                                    double aspect, session::PictureCounter* counter) {
  if (options.counts.empty() && options.visibles.empty() && !options.meets) return std::nullopt;
  scene::Scene wanted = session.scene();
  addWanted(wanted, options);
  if (!wanted.model.data || wanted.model.targets.empty()) return std::nullopt;
  std::vector<scene::TypeTarget> targets = wanted.model.targets;
  if (!counter)
    for (scene::TypeTarget& target : targets) target.visible.reset();
  constexpr const char* kStep = "Meet numbers";
  session::editByHand(session.document(), kStep, [&](scene::Scene& scene) { scene = wanted; });
  Progress& progress = consoleProgress();
  if (counter) wanted = session.settled(progress);
  auto picture = [counter](const scene::Scene& of) { return counter->count(of); };
  session::TargetsReport report = session::solveTargets(wanted, targets, picture, {}, aspect);
  progress.report(1.0, "");
  session::editByHand(session.document(), kStep, [&](scene::Scene& scene) {
    for (const scene::Cut& cut : report.scene.cuts) {
      if (scene::Cut* own = scene::findCut(scene, cut.id))
        own->model = cut.model;
      else
        scene.cuts.push_back(cut);
    }
  });
  for (const session::TargetReport& target : report.targets)
    if (!target.isMet) log::warning(target.words);
  return report;
}

Json targetJson(const session::TargetReport& target) {
  auto orNull = [](const std::optional<std::uint64_t>& count) { return count ? Json(*count) : Json(); };
  return {{"type", target.path},
          {"wantedRendered", orNull(target.wantedRendered)},
          {"wantedVisible", orNull(target.wantedVisible)},
          {"rendered", target.rendered},
          {"visible", orNull(target.visible)},
          {"total", target.total},
          {"met", target.isMet},
          {"words", target.words}};
}

}  // namespace velum::app
