#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/GreyWindows.h"
#include "scene/Scene.h"
#include "scene/Units.h"
#include "session/lettering/LetteringLayout.h"
#include "session/lettering/MarkLayout.h"

namespace velum::session {

namespace {

constexpr double kPlotWidth = 11.0, kPlotHeight = 4.5, kPlotGap = 0.5, kPlotMargin = 0.6;  // ems
constexpr double kPlotShare = 0.72;                                                        // of the letters
constexpr double kPlotFill = 0.6;

}  // namespace

/// The values along a line, over the way along it, with their least and their most.
void MarkLayout::addPlot(const scene::Mark& mark, glm::dvec2 at, const Measured& measured) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ProfileSample& sample : measured.profile)
    if (std::isfinite(sample.value)) low = std::min(low, sample.value), high = std::max(high, sample.value);
  if (measured.profile.size() < 2 || !(low <= high)) return;
  double em = mStyle.em(), last = measured.profile.back().distance;
  vector::Letters letters(mStyle.font(), kPlotShare * em);
  const auto& volume = mView.scene().volume.data;
  std::string unit = volume ? scene::valueUnit(*volume) : "";
  std::string most = fmt::format("{:.4g}{}{}", high, unit.empty() ? "" : " ", drawable(unit));
  std::string least = fmt::format("{:.4g}", low);
  double beside = std::max(letters.width(most), letters.width(least)) + kPlotGap * em;
  glm::dvec2 plot(kPlotWidth * em, kPlotHeight * em), room = plot + glm::dvec2(beside, 1.3 * em);
  glm::dvec2 wanted =
      mark.wordsAt ? at + *mark.wordsAt * mView.space().size().y - 0.5 * room : at + glm::dvec2(em, -0.5 * room.y);
  wanted = glm::max(glm::min(wanted, mView.space().size() - kPlotMargin * em - room), glm::dvec2(kPlotMargin * em));
  auto free = mPlaces.take(room, wanted, kPlotMargin * em, kPlotGap * em);
  if (!free) return;
  glm::dvec2 corner = *free + glm::dvec2(beside, 0.5 * em);
  auto pixelOf = [&](const ProfileSample& sample) {
    double t = high > low ? (sample.value - low) / (high - low) : 0.5;
    return corner + plot * glm::dvec2(last > 0.0 ? sample.distance / last : 0.0, 1.0 - t);
  };
  LetteringBlock block = mLines;
  block.items.clear();
  vector::Pen thin = mPen;
  thin.width *= 0.6;
  block.items.push_back(vector::Shape{{},
                                      {vector::rectangle(*free, *free + room, 0.0)},
                                      {},
                                      vector::Fill{LetteringStyle::glowOf(mPen.color, mGround), kPlotFill}});
  block.items.push_back(vector::Shape{
      {}, {vector::outlineThrough({corner, corner + glm::dvec2(0, plot.y), corner + plot}, false)}, thin, {}});
  // Outside the volume there is no value, and the line has a gap.
  std::vector<glm::dvec2> run;
  auto end = [&] {
    if (run.size() > 1) block.items.push_back(vector::Shape{{}, {vector::outlineThrough(run, false)}, mPen, {}});
    run.clear();
  };
  for (const ProfileSample& sample : measured.profile)
    std::isfinite(sample.value) ? run.push_back(pixelOf(sample)) : end();
  end();
  double cap = 0.72 * letters.em();
  auto addText = [&](const std::string& text, glm::dvec2 right) {
    block.items.push_back(letters.words(text, right - glm::dvec2(letters.width(text), 0.0), mPen.color));
  };
  addText(most, corner + glm::dvec2(-0.5 * kPlotGap * em, cap));
  addText(least, corner + glm::dvec2(-0.5 * kPlotGap * em, plot.y));
  std::string length = scene::lengthText(scene::lengthFormat(mView.scene()), last);
  addText(length, corner + glm::dvec2(plot.x, plot.y + cap + 0.25 * em));
  mBlocks.push_back(std::move(block));
}

}  // namespace velum::session
