#include "io/phantoms/Virion.h"

#include <array>
#include <cmath>
#include <glm/gtx/quaternion.hpp>

#include "core/ModelBuilder.h"
#include "io/models/Envelope.h"
#include "io/models/SphereGrid.h"
#include "io/models/Strands.h"
#include "io/phantoms/Phantom.h"

namespace velum::io {

namespace {

using Lobes = std::vector<glm::vec4>;  // centre and radius, angstrom

constexpr float kEnvelope = 500.0f, kCapsid = 265.0f, kPlasma = 1560.0f;
constexpr float kAtom = 1.7f;  ///< As far as atoms stay within their lobes.

Lobes ring(int count, float radius, float z, float size) {
  Lobes lobes;
  for (int i = 0; i < count; ++i) {
    float turn = 6.2831853f * float(i) / float(count);
    lobes.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z, size);
  }
  return lobes;
}
Lobes rod(float from, float to, float size) {
  Lobes lobes;
  for (float z = from; z <= to; z += size) lobes.emplace_back(0, 0, z, size);
  return lobes;
}
Lobes join(std::initializer_list<Lobes> parts) {
  Lobes all;
  for (const Lobes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Atoms at the density of protein, 17 cubic angstrom each, in all lobes; lobes are chains.
std::vector<Atom> filled(const Lobes& lobes, std::uint64_t seed) {
  constexpr float kStep = 2.57f;
  std::vector<Atom> atoms;
  glm::vec3 low(1e9f), high(-1e9f);
  for (const glm::vec4& l : lobes) low = glm::min(low, glm::vec3(l) - l.w), high = glm::max(high, glm::vec3(l) + l.w);
  glm::ivec3 count(glm::ceil((high - low) / kStep));
  for (int z = 0; z <= count.z; ++z)
    for (int y = 0; y <= count.y; ++y)
      for (int x = 0; x <= count.x; ++x) {
        std::uint64_t bits =
            phantom::hash(seed, (std::uint64_t(z) * 4096 + std::uint64_t(y)) * 4096 + std::uint64_t(x));
        glm::vec3 jitter(phantom::unit(bits), phantom::unit(bits << 20), phantom::unit(bits << 40));
        glm::vec3 p = low + kStep * (glm::vec3(x, y, z) + 0.35f * (jitter - 0.5f));
        for (std::size_t l = 0; l < lobes.size(); ++l) {
          if (glm::length(p - glm::vec3(lobes[l])) > lobes[l].w - kAtom) continue;
          // The mix of proteins, without hydrogens.
          float kind = phantom::unit(phantom::hash(bits));
          std::uint8_t element = kind < 0.63f ? 6 : kind < 0.80f ? 7 : kind < 0.993f ? 8 : 16;
          atoms.push_back({.position = p, .element = element, .chain = std::uint16_t(l)});
          break;
        }
      }
  return atoms;
}

struct Plan {
  const char* name;
  const char* function;
  int count;
  Lobes lobes;
};

class VirionMaker {
 public:
  explicit VirionMaker(Progress& progress) : mProgress(progress), mBuilder("virion") {}

  Model make() {
    makeEnvelopeProteins();
    makeMatrix();
    makeCapsid();
    makeStrand();
    makeInside();
    makePlasma();
    std::vector<std::string> path{"virus", "membrane"};
    addEnvelope(mBuilder, {path, glm::vec3(0), kEnvelope, Origin::File},
                [&](glm::vec3 p) { return !mTaken.touches(glm::vec4(p, 3.0f)); });
    return mBuilder.build();
  }

 private:
  std::uint32_t add(const Plan& plan, std::vector<std::string> path) {
    mProgress.report(double(mBuilder.typeCount()) / 35.0, "making a virus");
    MoleculeType type{.name = plan.name,
                      .compartment = mBuilder.compartment(path),
                      .function = plan.function,
                      .structure = "made: lobes of atoms"};
    return mBuilder.addMolecule(mBuilder.addType(std::move(type)), filled(plan.lobes, mBuilder.typeCount()));
  }

  /// Puts it there, where it touches nothing.
  bool put(std::uint32_t molecule, const Lobes& lobes, glm::vec3 at, const glm::quat& turn) {
    Lobes there;
    for (const glm::vec4& l : lobes) there.emplace_back(at + turn * glm::vec3(l), l.w);
    for (const glm::vec4& l : there)
      if (mTaken.touches(l)) return false;
    for (const glm::vec4& l : there) mTaken.add(l);
    mBuilder.addInstance(molecule, at, turn);
    return true;
  }

  glm::quat anyTurn() {
    float a = 6.2831853f * mRandom.uniform(), b = 6.2831853f * mRandom.uniform(), c = mRandom.uniform();
    float r = std::sqrt(1.0f - c), s = std::sqrt(c);
    return {s * std::cos(b), r * std::sin(a), r * std::cos(a), s * std::sin(b)};
  }
  /// z outwards, turned at random about it.
  glm::quat outwardTurn(glm::vec3 outward) {
    return glm::rotation(glm::vec3(0, 0, 1), outward) *
           glm::angleAxis(6.2831853f * mRandom.uniform(), glm::vec3(0, 0, 1));
  }

  void makeEnvelopeProteins() {
    const Plan kPlans[] = {
        {"spike", "entry into cells", 72, join({rod(-36, 66, 12), ring(3, 24, 92, 24), ring(3, 16, 124, 20)})},
        {"receptor", "taken along from the host", 40, join({rod(-24, 40, 10), ring(2, 16, 58, 16)})},
        {"channel", "ion channel", 30, join({ring(5, 13, -16, 10), ring(5, 13, 0, 10), ring(5, 13, 16, 10)})},
    };
    for (const Plan& plan : kPlans) {
      std::uint32_t molecule = add(plan, {"virus", "surface"});
      for (int placed = 0, tries = 0; placed < plan.count && tries < 100 * plan.count; ++tries) {
        glm::vec3 outward = mRandom.direction();
        placed += put(molecule, plan.lobes, outward * kEnvelope, outwardTurn(outward));
      }
    }
  }

  /// On a spiral below the envelope, where nothing reaches down.
  void makeMatrix() {
    Plan plan{"matrix", "holds envelope and capsid apart", 420, join({ring(3, 18, -44, 17), ring(3, 12, -58, 12)})};
    putOnSpiral(plan, {"virus", "surface"}, kEnvelope);
  }
  void makeCapsid() {
    Plan plan{"capsid_monomer", "shell of the genome", 780, {{0, 0, 9, 15}, {0, 0, -9, 12}}};
    putOnSpiral(plan, {"virus", "capsid", "surface"}, kCapsid);
  }
  void putOnSpiral(const Plan& plan, const std::vector<std::string>& path, float radius) {
    std::uint32_t molecule = add(plan, path);
    for (int i = 0; i < plan.count; ++i) {
      glm::vec3 outward = spiralPoint(std::size_t(i), std::size_t(plan.count));
      put(molecule, plan.lobes, outward * radius, outwardTurn(outward));
    }
  }

  /// A walk inside the capsid that keeps off itself; where it is caught it goes back.
  std::vector<glm::vec3> walk() {
    constexpr float kStep = 30.0f, kRoom = kCapsid - 45.0f, kApart = 20.0f;
    constexpr std::size_t kCount = 900;
    std::vector<glm::vec3> points{glm::vec3(0, 0, -100)};
    glm::vec3 along(0, 0, 1);
    for (int tries = 0; points.size() < kCount && tries < 200000; ++tries) {
      glm::vec3 next = points.back() + kStep * glm::normalize(along + 1.1f * mRandom.direction());
      bool isFree = glm::length(next) < kRoom;
      for (std::size_t i = 0; isFree && i + 1 < points.size(); ++i)
        isFree =
            glm::length(points[i] - next) > kApart && glm::length(0.5f * (points[i] + points[i + 1]) - next) > kApart;
      if (isFree) {
        along = glm::normalize(next - points.back());
        points.push_back(next);
      } else {
        along = mRandom.direction();
        if (tries % 60 == 59 && points.size() > 20) points.resize(points.size() - 12);
      }
    }
    return points;
  }

  void makeStrand() {
    std::vector<std::string> path{"virus", "capsid", "interior"};
    MoleculeType type{.name = "RNA",
                      .compartment = mBuilder.compartment(path),
                      .kind = MoleculeKind::NucleicAcid,
                      .function = "genome",
                      .structure = "made: nucleotide"};
    std::uint32_t index = mBuilder.addType(std::move(type));
    std::uint32_t molecule = mBuilder.addMolecule(index, nucleotideAtoms());
    std::vector<glm::vec3> points = walk();
    mBuilder.beginFibre();
    int count = 0;
    walkAlong(points, kNucleotide, [&](const Pose& pose) {
      mBuilder.addInstance(molecule, pose.position, pose.rotation);
      if (count++ % 3 == 0) mTaken.add(glm::vec4(pose.position, 11.5f));
    });
    mBuilder.addFibre(index, std::move(points));
  }

  void makeInside() {
    const Plan kCore[] = {
        {"reverse_transcriptase", "makes DNA of the genome", 30, {{-18, 0, 0, 20}, {18, 0, 0, 20}, {0, 14, 12, 16}}},
        {"integrase", "puts DNA into the cell's", 40, {{0, 0, -16, 16}, {0, 0, 16, 16}}},
        {"protease", "cuts the polyprotein", 80, {{-7, 0, 0, 14}, {7, 0, 0, 14}}},
        {"nucleocapsid", "binds the genome", 900, {{0, 0, -6, 8}, {0, 0, 6, 8}}},
    };
    for (const Plan& plan : kCore) scatter(plan, {"virus", "capsid", "interior"}, 0.0f, kCapsid - 35.0f);
    const Plan kAround[] = {
        {"infectivity_factor", "against the host's defence", 120, {{0, 0, -14, 14}, {0, 0, 14, 14}}},
        {"isomerase", "helps to open the capsid", 200, {{0, 0, 0, 17}}},
        {"p6", "budding", 1000, {{0, 0, -9, 9}, {0, 0, 9, 9}}},
        {"spacer_1", "cut off when the virus ripens", 1400, {{0, 0, -4, 7}, {0, 0, 4, 7}}},
        {"spacer_2", "cut off when the virus ripens", 1400, {{0, 0, 0, 9}}},
    };
    for (const Plan& plan : kAround) scatter(plan, {"virus", "interior"}, kCapsid + 30.0f, kEnvelope - 40.0f);
  }

  void makePlasma() {
    const Plan kPlans[] = {
        {"lipoprotein", "carries cholesterol", 60, {{0, 0, 0, 50}}},
        {"immunoglobulin_M", "first defence", 30, join({ring(5, 62, 0, 22), ring(10, 118, 0, 20)})},
        {"fibrinogen", "clotting", 160, join({rod(-210, 210, 14), ring(2, 20, -215, 20), ring(2, 20, 215, 20)})},
        {"complement_factor", "marks invaders", 70, rod(-150, 150, 15)},
        {"immunoglobulin_A", "defence", 120,
         join({rod(-20, 20, 20), {{30, 0, 62, 24}, {-30, 0, 62, 24}, {30, 0, -62, 24}, {-30, 0, -62, 24}}})},
        {"immunoglobulin_G",
         "defence",
         1500,
         {{0, 0, -52, 22}, {0, 0, -20, 20}, {28, 0, 18, 20}, {-28, 0, 18, 20}, {50, 0, 44, 20}, {-50, 0, 44, 20}}},
        {"ceruloplasmin", "carries copper", 220, ring(6, 24, 0, 21)},
        {"haemoglobin",
         "carries oxygen",
         250,
         {{15, 15, 10, 19}, {-15, -15, 10, 19}, {15, -15, -10, 19}, {-15, 15, -10, 19}}},
        {"transferrin", "carries iron", 900, {{0, 0, -24, 24}, {0, 0, 24, 24}}},
        {"albumin", "carries and buffers", 6500, {{0, 22, -10, 21}, {0, -22, -10, 21}, {0, 0, 18, 22}}},
        {"amylase", "digestion", 1000, {{0, 0, -12, 21}, {0, 0, 14, 18}}},
        {"antitrypsin", "inhibits proteases", 1800, {{0, 0, -13, 17}, {0, 0, 13, 19}}},
        {"insulin", "hormone", 300, {{0, 0, 0, 12}}},
    };
    for (const Plan& plan : kPlans) scatter(plan, {"plasma"}, kEnvelope + 40.0f, kPlasma);
  }

  /// Anywhere between two spheres, as far as there is room.
  void scatter(const Plan& plan, const std::vector<std::string>& path, float from, float to) {
    std::uint32_t molecule = add(plan, path);
    float reach = 0.0f;
    for (const glm::vec4& l : plan.lobes) reach = std::max(reach, glm::length(glm::vec3(l)) + l.w);
    float a = from > 0.0f ? from + reach : 0.0f, b = to - reach;
    for (int placed = 0, tries = 0; placed < plan.count && tries < 200 * plan.count; ++tries) {
      float r = std::cbrt(mRandom.uniform(a * a * a, b * b * b));
      placed += put(molecule, plan.lobes, r * mRandom.direction(), anyTurn());
    }
  }

  Progress& mProgress;
  ModelBuilder mBuilder;
  phantom::Random mRandom{20240607};
  SphereGrid mTaken{48.0f};
};

}  // namespace

Model makeVirion(Progress& progress) { return VirionMaker(progress).make(); }

}  // namespace velum::io
