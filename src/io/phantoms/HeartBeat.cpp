#include "io/phantoms/Heart.h"

namespace velum::io::heart {

namespace {

const Vec kAxis = glm::normalize(Vec(0.66f, -0.58f, -0.48f));        // base to apex: left, forward, down
const Vec kMiddle(20.0f, -8.0f, -19.0f);                             // of the left ventricle
constexpr float kHalf = 48.0f, kAcross = 33.0f;                      // of its outer surface
constexpr float kBaseMm = -30.0f, kApexMm = 50.0f, kTopMm = -92.0f;  // along the axis: valves' plane, and what rests
constexpr float kDescentMm = 12.0f;                                  // of the valves' plane
constexpr float kTwistRad = 0.24f;  // of the apex, half as much the other way at the base

/// A bump in a cycle: up from `start` to `top`, down from `fall` to `end`, parts of the cycle.
float bump(float phase, float start, float top, float fall, float end) {
  auto once = [&](float x) { return smoothStep(start, top, x) * (1.0f - smoothStep(fall, end, x)); };
  return once(phase) + once(phase + 1.0f);
}

/// An ellipsoid of revolution about the heart's axis.
float egg(Vec p, Vec centre, float half, float across) {
  Vec q = p - centre;
  float along = glm::dot(q, kAxis), away = glm::length(q - along * kAxis);
  return ellipse({along, away}, {0, 0}, {half, across});
}

/// The outer surface keeps its place nearly: what the cavity loses the wall gains.
float leftOuter(Vec p, const Beat& beat, float growMm) {
  return egg(p, kMiddle, kHalf + growMm, kAcross - 2.0f * beat.squeeze + growMm);
}

/// 1 in the valves' plane, 0 at the apex and above the atria, without a kink.
float follows(float alongMm) {
  return smoothStep(kTopMm, kBaseMm, alongMm) * (1.0f - smoothStep(kBaseMm, kApexMm, alongMm));
}

Vec turned(Vec p, float angleRad) {
  Vec q = p - kMiddle;
  float c = std::cos(angleRad), s = std::sin(angleRad);
  return kMiddle + q * c + glm::cross(kAxis, q) * s + kAxis * (glm::dot(kAxis, q) * (1.0f - c));
}

/// Angle by which the heart is turned about its axis in some place of it at rest.
float twistAt(float alongMm, const Beat& beat) {
  float toApex = smoothStep(kBaseMm, kApexMm, alongMm), above = 1.0f - smoothStep(kTopMm, kBaseMm, alongMm);
  return beat.squeeze * kTwistRad * (1.5f * toApex - 0.5f * (1.0f - above));
}

float alongOf(Vec p) { return glm::dot(p - kMiddle, kAxis); }

}  // namespace

Beat::Beat(float phase) {
  phase -= std::floor(phase);
  squeeze = bump(phase, 0.02f, 0.34f, 0.40f, 0.70f);
  float kick = bump(phase, 0.80f, 0.94f, 0.95f, 1.06f);
  filling = bump(phase, 0.04f, 0.38f, 0.42f, 0.66f) - 0.5f * kick;
  valve = bump(phase, 0.42f, 0.50f, 0.96f, 1.02f);
  ejection = bump(phase, 0.06f, 0.22f, 0.26f, 0.60f);
}

Vec Beat::moved(Vec rest) const {
  float along = alongOf(rest);
  return turned(rest, twistAt(along, *this)) + kAxis * (kDescentMm * squeeze * follows(along));
}

Vec Beat::rest(Vec moved) const {
  // The way along the axis is a contraction: 12 mm by a slope of at most 1.5 / 62 mm.
  float there = alongOf(moved), along = there;
  for (int i = 0; i < 8; ++i) along = there - kDescentMm * squeeze * follows(along);
  return turned(moved + kAxis * (along - there), -twistAt(along, *this));
}

float leftVentricle(Vec p, const Beat& beat) {
  Vec centre = kMiddle - kAxis * (5.6f + 2.0f * beat.squeeze);
  float cavity = egg(p, centre, 39.0f - 4.0f * beat.squeeze, 21.5f - 8.0f * beat.squeeze);
  float papillary = std::min(distance({kMiddle + Vec(17, 0, -24), kMiddle + Vec(1, 8, -6), 5.5f, 3.5f}, p),
                             distance({kMiddle + Vec(21, -18, -2), kMiddle + Vec(3, -10, 10), 5.5f, 3.5f}, p));
  return smoothMax(cavity + (1.3f + 0.7f * beat.squeeze) * noise(p / 6.0f, 79), -papillary, 3.0f);
}

float rightVentricle(Vec p, const Beat& beat, float growMm) {
  // The free wall comes towards the septum.
  Vec centre = glm::mix(kMiddle + Vec(-33, -18, -2), kMiddle, 0.16f * beat.squeeze);
  float size = 1.0f - 0.17f * beat.squeeze, grow = growMm + 1.5f * beat.squeeze * (growMm > 0.0f ? 1.0f : 0.0f);
  float body = ellipsoid(p, centre, Vec(36, 27, 29) * size + grow);
  float outflow = distance({kMiddle + Vec(-27, -20, 9), kMiddle + Vec(-19, -18, 42), 19 * size + grow, 12 + grow}, p);
  float both = smoothMin(body, outflow, 12.0f) + (growMm > 0.0f ? 0.0f : 1.2f * noise(p / 5.0f, 83));
  return smoothMax(both, -leftOuter(p, beat, 0.0f), 4.0f);
}

float leftAtrium(Vec p, const Beat& beat, float growMm) {
  float grow = growMm + 2.5f * beat.filling;
  float body = ellipsoid(p, Vec(-11, 36, 3), Vec(29, 17, 20) + grow), veins = 1e3f;
  for (float side : {-1.0f, 1.0f})
    for (float z : {-5.0f, 11.0f})
      veins = std::min(
          veins, distance({Vec(side * 14 - 13, 38, z), Vec(side * 46 - 13, 46, z + 2), 7 + growMm, 5.5f + growMm}, p));
  return smoothMin(body, veins, 6.0f);
}

float rightAtrium(Vec p, const Beat& beat, float growMm) {
  return ellipsoid(p, Vec(-46, 2, -9), Vec(21, 24, 28) + growMm + 2.5f * beat.filling);
}

float outerSurface(Vec p, const Beat& beat) {
  float d = smoothMin(leftOuter(p, beat, 0.0f), rightVentricle(p, beat, 4.0f), 8.0f);
  return smoothMin(smoothMin(d, rightAtrium(p, beat, 2.5f), 10.0f), leftAtrium(p, beat, 2.5f), 8.0f);
}

float mitralValve(Vec p, const Beat& beat) {
  // Two leaflets: a dome that leans into the ventricle and parts in the middle.
  float along = alongOf(p);
  Vec q = p - kMiddle;
  float away = glm::length(q - along * kAxis),
        dome = along - (kBaseMm + 2.0f + 0.02f * (16.0f - away) * (16.0f - away));
  float leaf = std::max(std::abs(dome) - 1.3f, away - 19.0f);
  return smoothMax(leaf, 13.5f * beat.valve - away, 2.0f);
}

std::vector<Segment> coronaries(const Beat& beat) {
  // Places near the surface; each is brought onto it. Left: forward in the groove, and round to the back; right.
  const std::vector<glm::vec4> paths[] = {
      {{-3, -4, 19, 2.2f}, {9, -22, 15, 2.2f}, {21, -42, -3, 2}, {34, -52, -27, 1.8f}, {48, -46, -46, 1.4f}},
      {{21, -42, -3, 1.7f}, {36, -38, 0, 1.6f}, {50, -32, -14, 1.3f}},
      {{34, -50, -26, 1.5f}, {48, -42, -24, 1.4f}, {57, -30, -36, 1.2f}},
      {{-3, -4, 19, 2.2f}, {19, 6, 11, 2}, {38, 14, -2, 1.8f}, {46, 14, -26, 1.4f}},
      {{30, 10, 5, 1.7f}, {48, -4, -4, 1.5f}, {58, -14, -26, 1.2f}},
      {{-19, -12, 17, 2.1f}, {-38, -28, 7, 2.1f}, {-50, -26, -17, 2}, {-42, -12, -41, 1.7f}, {-20, 2, -46, 1.4f}},
      {{-48, -28, -10, 1.6f}, {-34, -44, -28, 1.4f}, {-12, -46, -42, 1.2f}},
  };
  auto onSurface = [&](Vec p) {
    constexpr float kStep = 0.5f;
    for (int i = 0; i < 12; ++i) {
      float d = outerSurface(p, beat);
      Vec g(outerSurface(p + Vec(kStep, 0, 0), beat), outerSurface(p + Vec(0, kStep, 0), beat),
            outerSurface(p + Vec(0, 0, kStep), beat));
      g = (g - Vec(d)) / kStep;
      p -= 0.7f * d * g / std::max(glm::dot(g, g), 0.2f);
    }
    return p;
  };
  std::vector<Segment> all;
  for (const auto& path : paths) {
    std::vector<Segment> twig = tube(path, 7);
    for (auto& s : twig) s.a = beat.moved(onSurface(s.a)), s.b = beat.moved(onSurface(s.b));
    append(all, twig);
  }
  return all;
}

}  // namespace velum::io::heart
