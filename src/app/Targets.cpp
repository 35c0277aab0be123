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
#include "session/model/TypesAt.h"

namespace velum::app {

namespace {

/// The scene's target of what "TYPE=N" names; a new one where it has none.
scene::TypeTarget& targetOf(scene::Scene& scene, const char* option, const std::string& text, double& number) {
  WantedNumber wanted = wantedNumber(option, text, "TYPE=N, how many instances", false);
  if (!scene.model.data) throw InputError(fmt::format("{} {}: there is no model", option, text));
  number = std::round(wanted.number);
  std::string path = session::typesAt(*scene.model.data, wanted.name).path;
  std::vector<scene::TypeTarget>& targets = scene.model.targets;
  auto found = std::find_if(targets.begin(), targets.end(), [&](const auto& target) { return target.type == path; });
  return found != targets.end() ? *found : targets.emplace_back(scene::TypeTarget{path, std::nullopt, std::nullopt});
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
  verb.add_option(
          "--set-count", options.counts,
          "let cuts leave N instances of a type or compartment: TYPE=N, by its path or the end of it; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--set-visible", options.visibles, "the same until N of them show in the picture; repeatable")
      ->allow_extra_args(false);
}

std::optional<session::TargetsReport> settleTargets(session::Session& session, const TargetOptions& options,
                                                    double aspect, session::PictureCounter* counter) {
  scene::Scene wanted = session.scene();
  double number = 0.0;
  for (const std::string& text : options.counts)
    if (scene::TypeTarget& target = targetOf(wanted, "--set-count", text, number); true) target.rendered = number;
  for (const std::string& text : options.visibles)
    if (scene::TypeTarget& target = targetOf(wanted, "--set-visible", text, number); true) target.visible = number;
  if (!wanted.model.data || wanted.model.targets.empty()) return std::nullopt;
  std::vector<scene::TypeTarget> targets = wanted.model.targets;
  if (!counter)
    for (scene::TypeTarget& target : targets) target.visible.reset();
  std::vector<int> cuts = session::cutsToSet(wanted);
  constexpr const char* kStep = "Meet numbers";
  session::editByHand(session.document(), kStep, [&](scene::Scene& scene) { scene = wanted; });
  Progress& progress = consoleProgress();
  if (counter) wanted = session.settled(progress);
  auto picture = [counter](const scene::Scene& of) { return counter->count(of); };
  session::TargetsReport report = session::solveTargets(wanted, cuts, targets, picture, {}, aspect);
  progress.report(1.0, "");
  session::editByHand(session.document(), kStep, [&](scene::Scene& scene) {
    for (scene::Cut& cut : scene.cuts) cut.model = scene::findCut(report.scene, cut.id)->model;
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
