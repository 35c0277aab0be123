#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "membrane/sheet/Solver.h"

namespace velum::membrane {

/// The sheet's solver again, written from the papers: forces from [IMC] eq. 1 to 3 and from what Solver.h says differs,
/// lifts from [WENDLAND], constraints as lists of edges and of adjacent triangles, each handing out its corrections.
/// Double precision. Shares no text with the one on the GPU, nor with shaders/shared/cloth.h, which C++ compiles too: a
/// wrong formula there must not be its own witness. Slow.
class ReferenceSolver {
 public:
  ReferenceSolver(const SheetSetup& setup, const PushField& field) : mSetup(setup), mField(field) {
    glm::ivec2 n = setup.particles;
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        mPlaces.push_back(flat(x, y));
        bool border = x == 0 || y == 0 || x == n.x - 1 || y == n.y - 1;
        mWeights.push_back(border ? 0.0 : 1.0);
      }
    mVelocities.resize(mPlaces.size(), glm::dvec3(0.0));
    double mean = 2.0 * std::sqrt(setup.half.x * setup.half.y);
    mUnit = mean / 128.0;
    glm::dvec2 mesh = 2.0 * glm::dvec2(setup.half) / glm::dvec2(n - 1);
    double finer = mean / 49.0 / std::sqrt(mesh.x * mesh.y);
    int strides = 1;
    while (strides < 5 && std::pow(2.0, strides) <= 1.2 * finer && (2 << strides) < std::min(n.x, n.y)) ++strides;
    double sum2 = 0, sum4 = 0;
    for (int i = 0; i < strides; ++i) sum2 += std::pow(4.0, i), sum4 += std::pow(16.0, i);
    auto each = [&](double k) { return 1.0 - std::pow(1.0 - k, 1.0 / setup.cloth.iterations); };
    for (int i = 0; i < strides; ++i) {
      double stretch = std::min(each(setup.cloth.stretch) * finer * finer / sum2, 1.0 / strides);
      double bend = std::min(each(setup.cloth.bend) * std::min(4, setup.cloth.iterations) * std::pow(finer, 4.0) / sum4,
                             1.0 / strides);
      addStretch(1 << i, stretch);
      addBend(1 << i, bend);
    }
  }

  void step(int count) {
    for (int i = 0; i < count; ++i) stepOnce();
  }
  const std::vector<glm::dvec3>& places() const { return mPlaces; }

 private:
  struct Stretch {
    int a, b;
    double rest, stiffness;
  };
  struct Bend {
    std::array<int, 4> at;
    std::array<double, 4> k;
    double stiffness;
  };

  glm::dvec3 flat(int x, int y) const {
    glm::dvec2 share = glm::dvec2(x, y) / glm::dvec2(mSetup.particles - 1);
    return glm::dvec3((2.0 * share - 1.0) * glm::dvec2(mSetup.half), 0.0);
  }
  int index(int x, int y) const { return y * mSetup.particles.x + x; }

  /// Each particle is tied to its eight neighbours; beyond the border the border itself is the neighbour.
  void addStretch(int stride, double stiffness) {
    glm::ivec2 n = mSetup.particles;
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            int ox = std::clamp(x + dx * stride, 0, n.x - 1), oy = std::clamp(y + dy * stride, 0, n.y - 1);
            if ((dx == 0 && dy == 0) || (ox == x && oy == y)) continue;
            mStretches.push_back({index(x, y), index(ox, oy), glm::length(flat(ox, oy) - flat(x, y)), stiffness});
          }
  }

  static double cot(glm::dvec3 a, glm::dvec3 b) { return glm::dot(a, b) / glm::length(glm::cross(a, b)); }

  /// Meshes of `stride` particles from every offset, halved both ways.
  void addBend(int stride, double stiffness) {
    glm::ivec2 n = mSetup.particles;
    for (int oy = 0; oy < stride; ++oy)
      for (int ox = 0; ox < stride; ++ox)
        for (int diagonal = 0; diagonal < 2; ++diagonal) {
          std::map<std::pair<int, int>, std::vector<int>> opposite;
          auto triangle = [&](int a, int b, int c) {
            opposite[std::minmax(a, b)].push_back(c);
            opposite[std::minmax(b, c)].push_back(a);
            opposite[std::minmax(c, a)].push_back(b);
          };
          for (int y = oy; y + stride < n.y; y += stride)
            for (int x = ox; x + stride < n.x; x += stride) {
              int a = index(x, y), b = index(x + stride, y), c = index(x + stride, y + stride),
                  d = index(x, y + stride);
              if (diagonal == 0)
                triangle(a, b, c), triangle(a, c, d);
              else
                triangle(a, b, d), triangle(b, c, d);
            }
          for (const auto& [edge, others] : opposite)
            if (others.size() == 2) addBendPair({edge.first, edge.second, others[0], others[1]}, stiffness);
        }
  }

  void addBendPair(std::array<int, 4> at, double stiffness) {
    auto p = [&](int i) { return mPlaces[std::size_t(at[std::size_t(i)])]; };
    glm::dvec3 e0 = p(1) - p(0), e1 = p(2) - p(0), e2 = p(3) - p(0), e3 = p(2) - p(1), e4 = p(3) - p(1);
    double c01 = cot(e0, e1), c02 = cot(e0, e2), c03 = cot(-e0, e3), c04 = cot(-e0, e4);
    mBends.push_back({at, {c03 + c04, c01 + c02, -c01 - c03, -c02 - c04}, stiffness});
  }

  static double sideOf(double share) { return std::clamp(4.0 * share, -1.0, 1.0); }
  static double along(double delta, double width) {
    double share = delta / width;
    return std::abs(share) < 1 ? sideOf(share) * (1 - std::abs(share)) : 0;
  }
  static double tent(glm::dvec3 delta, double width) {
    double product = 1;
    for (int i = 0; i < 3; ++i) product *= std::max(0.0, 1 - std::abs(delta[i]) / width);
    return product;
  }

  /// Brute force over all kernels.
  glm::dvec3 force(glm::dvec3 place) const {
    glm::dvec3 sum(0.0);
    glm::dmat4 localFromKernel = glm::inverse(mField.kernelFromLocal);
    glm::dvec3 q(mField.kernelFromLocal * glm::dvec4(place, 1.0));
    double pitch = std::cbrt(std::abs(glm::determinant(glm::dmat3(localFromKernel))));
    std::size_t i = 0;
    for (int z = 0; z < mField.dims.z; ++z)
      for (int y = 0; y < mField.dims.y; ++y)
        for (int x = 0; x < mField.dims.x; ++x) {
          glm::dvec2 strength = mField.strengths[i++];
          glm::dvec3 delta = q - glm::dvec3(x, y, z);
          double weight = tent(delta, mField.areaOfEffect);
          if (weight <= 0) continue;
          glm::dvec3 kernel(localFromKernel * glm::dvec4(x, y, z, 1));
          if (mSetup.isAlongNormal) {
            sum.z += weight * (strength.x + sideOf((place.z - kernel.z) / (mField.areaOfEffect * pitch)) * strength.y);
          } else {
            for (int j = 0; j < 3; ++j)
              sum += strength.y * along(delta[j], mField.areaOfEffect) * glm::normalize(glm::dvec3(localFromKernel[j]));
          }
        }
    for (const auto& kernel : mField.placed) {
      // What repels stands a little below its place.
      bool repels = kernel.push != 0 || kernel.pull > 0;
      glm::dvec3 delta = place - kernel.centre;
      if (repels) delta.z += 0.05 * kernel.halfWidth;
      double weight = tent(delta, kernel.halfWidth);
      if (weight <= 0) continue;
      if (mSetup.isAlongNormal)
        sum.z += weight * (kernel.push + sideOf(delta.z / kernel.halfWidth) * kernel.pull);
      else
        for (int j = 0; j < 3; ++j) sum[j] += kernel.pull * along(delta[j], kernel.halfWidth);
    }
    return sum * mUnit;
  }

  /// How high the rest plane is lifted over a place: phi_3,1 of [WENDLAND] around each kernel, (1 - r)^4 (4 r + 1).
  double lift(glm::dvec3 place) const {
    double sum = 0;
    for (const auto& kernel : mField.placed) {
      double r = std::hypot(place.x - kernel.centre.x, place.y - kernel.centre.y) / kernel.halfWidth;
      if (r < 1 && mSetup.isAlongNormal) sum += kernel.lift * std::pow(1 - r, 4.0) * (4 * r + 1);
    }
    return sum;
  }

  void stepOnce() {
    const auto& cloth = mSetup.cloth;
    double dt = cloth.timeStepS, longest = mUnit;
    if (mField.dims.x > 0) {
      glm::dmat3 axes(glm::inverse(mField.kernelFromLocal));
      longest = 0.5 * std::min({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    }
    double pace = 1.0 / (1.0 + std::pow(std::max(0, mAge++ - 200) / 40.0, 2.0));
    std::vector<glm::dvec3> next = mPlaces;
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (mWeights[i] == 0) continue;
      glm::dvec3 f = force(mPlaces[i]);
      f.z -= cloth.restoring * (mPlaces[i].z - lift(mPlaces[i]));
      glm::dvec3 way = (mVelocities[i] + dt * f) * std::exp(-cloth.damping * dt) * dt;
      double length = glm::length(way);
      next[i] += length > longest ? way * (longest / length) : way;
    }
    for (int pass = 0; pass < cloth.iterations; ++pass) iterate(next, pass % 4 == 0);
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = glm::mix(mPlaces[i], next[i], pace);
    for (std::size_t i = 0; i < next.size(); ++i) mVelocities[i] = (next[i] - mPlaces[i]) / dt;
    mPlaces = next;
  }

  void iterate(std::vector<glm::dvec3>& places, bool bends) const {
    std::vector<glm::dvec3> ways(places.size(), glm::dvec3(0.0));
    for (const auto& s : mStretches) {
      auto a = std::size_t(s.a), b = std::size_t(s.b);
      if (mWeights[a] == 0) continue;
      glm::dvec3 d = places[b] - places[a];
      double length = glm::length(d);
      if (length > 1e-12) ways[a] += s.stiffness / 8.0 * d * ((length - s.rest) / length / (mWeights[a] + mWeights[b]));
    }
    for (const auto& bend : mBends) {
      if (!bends) break;
      glm::dvec3 c(0.0);
      double square = 0;
      for (std::size_t j = 0; j < 4; ++j)
        c += bend.k[j] * places[std::size_t(bend.at[j])], square += bend.k[j] * bend.k[j];
      for (std::size_t j = 0; j < 4; ++j)
        if (mWeights[std::size_t(bend.at[j])] > 0)
          ways[std::size_t(bend.at[j])] -= bend.stiffness / 24.0 * bend.k[j] / square * c;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (mWeights[i] == 0) continue;
      if (mSetup.isAlongNormal) ways[i].x = ways[i].y = 0;
      places[i] = glm::clamp(places[i] + ways[i], -mSetup.half, mSetup.half);
    }
  }

  SheetSetup mSetup;
  PushField mField;
  std::vector<glm::dvec3> mPlaces, mVelocities;
  std::vector<double> mWeights;
  std::vector<Stretch> mStretches;
  std::vector<Bend> mBends;
  double mUnit = 1.0;
  int mAge = 0;
};

}  // namespace velum::membrane
