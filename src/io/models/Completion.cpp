#include "io/models/Completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/FileName.h"
#include "core/Text.h"
#include "io/models/Envelope.h"
#include "io/models/SphereGrid.h"
#include "io/models/Strands.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {

/// The sphere on which the surface proteins of a compartment stand, or the shell that they make.
struct Shell {
  std::uint32_t compartment = 0;
  glm::vec3 middle{0.0f};
  float radius = 0.0f;
  std::vector<std::uint32_t> members;  ///< Instances, by index.
};

bool isNamed(const std::string& name, std::string_view word) { return lowerCase(name).find(word) != std::string::npos; }

class Completion {
 public:
  Completion(ModelBuilder& builder, const Path& path) : mBuilder(builder), mPath(path) {}

  void complete() {
    for (std::uint32_t t = 0; t < mBuilder.typeCount(); ++t) {
      if (mBuilder.type(t).kind == MoleculeKind::Lipid) mHasLipids = true;
      if (mBuilder.type(t).kind == MoleculeKind::NucleicAcid) mHasStrand = true;
    }
    gatherShells();
    auto envelope = std::find_if(mShells.begin(), mShells.end(),
                                 [&](const Shell& s) { return isNamed(parentName(s), "envelope") && isSphere(s); });
    if (envelope == mShells.end()) return;
    if (!mHasLipids) addLipids(*envelope);
    auto capsid = std::find_if(mShells.begin(), mShells.end(), [&](const Shell& s) {
      return isNamed(parentName(s), "capsid") && s.members.size() >= 100;
    });
    if (!mHasStrand && capsid != mShells.end()) addStrand(*capsid);
  }

 private:
  std::uint32_t typeOf(const Instance& instance) const { return mBuilder.molecule(instance.molecule).type; }
  const std::string& parentName(const Shell& shell) const {
    const Compartment& own = mBuilder.compartmentAt(shell.compartment);
    return mBuilder.compartmentAt(std::uint32_t(std::max(own.parent, 0))).name;
  }

  void gatherShells() {
    auto instances = mBuilder.instances();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
      std::uint32_t compartment = mBuilder.type(typeOf(instances[i])).compartment;
      if (mBuilder.compartmentAt(compartment).name != "surface") continue;
      auto at =
          std::find_if(mShells.begin(), mShells.end(), [&](const Shell& s) { return s.compartment == compartment; });
      if (at == mShells.end()) at = mShells.insert(at, Shell{.compartment = compartment});
      at->members.push_back(i);
    }
    for (Shell& shell : mShells) {
      glm::dvec3 low(1e9), high(-1e9);
      for (std::uint32_t i : shell.members) {
        low = glm::min(low, glm::dvec3(instances[i].position));
        high = glm::max(high, glm::dvec3(instances[i].position));
      }
      shell.middle = glm::vec3(0.5 * (low + high));
      double sum = 0.0;
      for (std::uint32_t i : shell.members) sum += double(glm::length(instances[i].position - shell.middle));
      shell.radius = float(sum / double(shell.members.size()));
    }
  }

  /// Whether its proteins stand on a sphere to a fiftieth, so that one can be drawn through them.
  bool isSphere(const Shell& shell) const {
    if (shell.members.size() < 50 || shell.radius < 100.0f) return false;
    auto far = std::count_if(shell.members.begin(), shell.members.end(), [&](std::uint32_t i) {
      float radius = glm::length(mBuilder.instances()[i].position - shell.middle);
      return std::abs(radius - shell.radius) > 0.02f * shell.radius;
    });
    return double(far) < 0.05 * double(shell.members.size());
  }

  /// A ball for every twentieth atom of the surface's proteins near the membrane.
  void addLipids(const Shell& shell) {
    SphereGrid taken(20.0f);
    for (std::uint32_t i : shell.members) {
      const Instance& instance = mBuilder.instances()[i];
      const auto& atoms = mBuilder.molecule(instance.molecule).atoms;
      for (std::size_t a = 0; a < atoms.size(); a += 20) {
        glm::vec3 p = instance.position + instance.rotation * atoms[a].position;
        if (std::abs(glm::length(p - shell.middle) - shell.radius) < 25.0f) taken.add(glm::vec4(p, 5.0f));
      }
    }
    std::vector<std::string> path{parentName(shell), "membrane"};
    std::size_t count = addEnvelope(mBuilder, {path, shell.middle, shell.radius, Origin::Added},
                                    [&](glm::vec3 p) { return !taken.touches(glm::vec4(p, 3.0f)); });
    mBuilder.sayAdded(fmt::format(
        "{} lipids of the envelope, on two spheres around {:.0f} angstrom, where no protein is", count, shell.radius));
  }

  /// Control points of the strand that lie beside the model or in a folder beside it, as cellVIEW has them.
  std::vector<glm::vec3> pointsBeside() const {
    Path folder = std::filesystem::absolute(mPath).lexically_normal().parent_path();
    std::vector<Path> folders{folder};
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder.parent_path(), error))
      if (folders.size() < 1000 && entry.is_directory(error)) folders.push_back(entry.path());
    std::sort(folders.begin() + 1, folders.end());
    for (const Path& at : folders)
      if (Path file = at / "rna_allpoints.txt"; std::filesystem::is_regular_file(file, error)) return pointsIn(file);
    return {};
  }

  static std::vector<glm::vec3> pointsIn(const Path& file) {
    std::string text = textOf(file);
    std::string_view rest(text);
    std::vector<glm::vec3> points;
    for (;;) {
      glm::vec3 p;
      for (int axis = 0; axis < 3; ++axis) {
        auto value = takeNumber(rest);
        if (!value || !(std::abs(*value) < 1e6)) return points;
        p[axis] = float(*value);
      }
      points.push_back(p);
      if (points.size() > 1000000) refuse(file, "holds more than a million points");
    }
  }

  void addStrand(const Shell& capsid) {
    std::vector<glm::vec3> points = pointsBeside();
    bool isFromFile = points.size() >= 2;
    if (!isFromFile) points = walkWithin(capsid);
    if (points.size() < 2) return;
    std::vector<std::string> path{parentName(capsid), "interior"};
    MoleculeType type{.name = "RNA",
                      .compartment = mBuilder.compartment(path),
                      .kind = MoleculeKind::NucleicAcid,
                      .function = "genome",
                      .structure = "made: nucleotide",
                      .origin = Origin::Added};
    std::uint32_t index = mBuilder.addType(std::move(type));
    std::uint32_t molecule = mBuilder.addMolecule(index, nucleotideAtoms());
    mBuilder.beginFibre();
    std::size_t count = 0;
    walkAlong(points, kNucleotide, [&](const Pose& pose) {
      place(mBuilder, mPath, molecule, pose);
      ++count;
    });
    mBuilder.addFibre(index, std::move(points));
    mBuilder.sayAdded(fmt::format("a strand of {} nucleotides in the capsid, {}", count,
                                  isFromFile ? "along points of rna_allpoints.txt" : "on a walk at random"));
  }

  /// A walk of as many steps as the published one has, that stays 45 angstrom below the capsid's monomers. The capsid
  /// is seen from its middle as a radius in each direction.
  std::vector<glm::vec3> walkWithin(const Shell& capsid) const {
    constexpr std::size_t kCount = 1354;
    constexpr float kStep = 41.0f, kBelow = 45.0f;
    std::vector<glm::vec3> directions;
    std::vector<float> radii;
    for (std::uint32_t i : capsid.members) {
      glm::vec3 d = mBuilder.instances()[i].position - capsid.middle;
      radii.push_back(glm::length(d));
      directions.push_back(d / std::max(radii.back(), 1e-3f));
    }
    auto isInside = [&](glm::vec3 p) {
      float length = glm::length(p);
      if (length < 1.0f) return true;
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < directions.size(); ++i)
        if (glm::dot(directions[i], p) > glm::dot(directions[nearest], p)) nearest = i;
      return length < radii[nearest] - kBelow;
    };
    std::vector<glm::vec3> points{capsid.middle};
    glm::vec3 along(0, 0, 1);
    for (std::uint32_t tries = 0; points.size() < kCount && tries < 100 * kCount; ++tries) {
      glm::vec3 any = spiralPoint(std::size_t(randomOf(tries, 2000) * 9973.0f), 9973);
      glm::vec3 next = points.back() + kStep * glm::normalize(along + 1.1f * any);
      if (!isInside(next - capsid.middle)) {
        along = any;
        continue;
      }
      along = glm::normalize(next - points.back());
      points.push_back(next);
    }
    return points;
  }

  ModelBuilder& mBuilder;
  const Path& mPath;
  std::vector<Shell> mShells;
  bool mHasLipids = false, mHasStrand = false;
};

}  // namespace

void completeVirus(ModelBuilder& builder, const Path& path) { Completion(builder, path).complete(); }

}  // namespace velum::io
