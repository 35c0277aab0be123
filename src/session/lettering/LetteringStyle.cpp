#include "session/lettering/LetteringStyle.h"

#include <algorithm>
#include <cmath>

#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr double kLeastEm = 8.0, kLeastEmOfPage = 2.0;  // pixels
constexpr double kLeastLine = 0.6;                      // pixels
constexpr double kLineOfEm = 0.085;                     // width of lines without a page
constexpr double kMmPerPoint = 25.4 / 72.0;

const glm::vec3 kDarkInk(0.08f, 0.09f, 0.11f), kLightInk(0.96f, 0.97f, 0.98f);

bool isLight(glm::vec3 color) {
  // As light as the eye takes it: middle grey is 0.18 of white's light.
  glm::vec3 light = glm::pow(glm::clamp(color, 0.0f, 1.0f), glm::vec3(2.2f));
  return glm::dot(light, glm::vec3(0.2126f, 0.7152f, 0.0722f)) > 0.18f;
}
glm::vec3 contrastTo(glm::vec3 color) { return isLight(color) ? kDarkInk : kLightInk; }

}  // namespace

LetteringStyle::LetteringStyle(const scene::Lettering& lettering, glm::ivec2 size, double leastEm)
    : mLettering(lettering), mSize(size), mLeastEm(leastEm) {}

double LetteringStyle::em(double share) const {
  if (mLettering.pageWidth <= 0.0)
    return std::max({kLeastEm, mLeastEm, share * mLettering.textSize * mSize.y / 1000.0});
  double pixels = mLettering.textPoints * kMmPerPoint * mSize.x / mLettering.pageWidth;
  return std::max({kLeastEmOfPage, mLeastEm, share * pixels});
}

double LetteringStyle::lineWidth() const {
  if (mLettering.pageWidth <= 0.0) return std::max(kLeastLine, kLineOfEm * em());
  return std::max(kLeastLine, mLettering.linePoints * kMmPerPoint * mSize.x / mLettering.pageWidth);
}

vector::Font LetteringStyle::font() const {
  if (mLettering.typeface == scene::Typeface::Serif)
    return mLettering.bold ? vector::Font::SerifBold : vector::Font::Serif;
  return mLettering.bold ? vector::Font::SansBold : vector::Font::Sans;
}

glm::vec3 LetteringStyle::inkOn(glm::vec3 ground) const { return mLettering.color.value_or(contrastTo(ground)); }

glm::vec3 LetteringStyle::glowOf(glm::vec3 ink, glm::vec3 ground) {
  return isLight(ink) == isLight(ground) ? contrastTo(ink) : ground;
}

glm::vec3 groundOf(const scene::Scene& scene, scene::CaptionPlace place) {
  if (scene.finish.paper != scene::Paper::None) return scene.finish.paperColor;
  return glm::mix(scene.background.top, scene.background.bottom, 0.5f * float(cellOf(place).y));
}

}  // namespace velum::session
