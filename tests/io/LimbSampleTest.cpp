#include <cmath>
#include <span>

#include "SampleParts.h"

/// Phantoms of a hand, a foot and a lesion.
namespace velum {
namespace {

std::vector<std::string> bonesOf(std::string_view name) {
  std::vector<std::string> bones;
  bool isBone = false;  // from the forearm or the leg on
  for (const auto& info : make(name, 128).labels.table) {
    isBone = isBone || info.name == "radius" || info.name == "tibia";
    if (isBone) bones.push_back(info.name);
  }
  return bones;
}

TEST(Hand, HasEachBoneInOnePiece) {
  // Radius and ulna, eight carpals, five metacarpals, fourteen phalanges.
  auto bones = bonesOf("hand");
  EXPECT_EQ(bones.size(), 29u);
  io::Sample s = make("hand", 128);
  EXPECT_EQ(s.labels.table.size(), 37u);
  for (const auto& bone : bones) EXPECT_EQ(connectedPart(s, bone), 1.0) << bone;
}

TEST(Foot, HasEachBoneInOnePiece) {
  // Tibia and fibula, seven tarsals, five metatarsals, fourteen phalanges.
  auto bones = bonesOf("foot");
  EXPECT_EQ(bones.size(), 28u);
  io::Sample s = make("foot", 128);
  EXPECT_EQ(s.labels.table.size(), 37u);
  for (const auto& bone : bones) EXPECT_EQ(connectedPart(s, bone), 1.0) << bone;
}

TEST(Limbs, VesselsHangTogetherOverFaces) {
  for (const char* limb : {"hand", "foot"})
    for (int size : {96, 128, 160}) {
      io::Sample s = make(limb, size);
      for (const char* vessel : {"artery", "vein"})
        EXPECT_EQ(connectedPart(s, vessel, Joint::Faces), 1.0) << vessel << " of a " << limb << " of " << size;
    }
}

struct MlRange {
  const char* name;
  double least, most;
};

void expectMl(const io::Sample& s, std::span<const MlRange> parts) {
  double ml = std::abs(glm::determinant(glm::dmat3(s.volume.worldFromVoxel))) / 1000.0;
  for (const MlRange& part : parts) {
    double volume = double(measure(s, part.name).count) * ml;
    EXPECT_GT(volume, part.least) << part.name;
    EXPECT_LT(volume, part.most) << part.name;
  }
}

TEST(Hand, BonesAreAsLargeAndWhereTheyAreInAHand) {
  const io::Sample& s = cached("hand");
  // Of grown-ups, as CT gives them.
  const MlRange parts[] = {{"scaphoid", 2, 4.5},         {"lunate", 1.2, 3.2},
                           {"pisiform", 0.4, 1.4},       {"capitate", 2.4, 5},
                           {"hamate", 1.6, 4},           {"trapezium", 1.0, 3.2},
                           {"third metacarpal", 4, 9},   {"proximal phalanx of middle finger", 2, 5},
                           {"first metacarpal", 3.5, 8}, {"distal phalanx of little finger", 0.1, 0.6}};
  expectMl(s, parts);
  // A right hand that hangs down, palm forward: thumb to -x, palm to -y, fingers to -z.
  auto centre = [&](const char* name) { return measure(s, name).centre; };
  EXPECT_LT(centre("first metacarpal").x, centre("fifth metacarpal").x - 30.0);
  EXPECT_LT(centre("pisiform").y, centre("triquetrum").y - 5.0);
  EXPECT_LT(centre("distal phalanx of middle finger").z, centre("capitate").z - 100.0);
  EXPECT_GT(centre("radius").z, centre("scaphoid").z + 15.0);
  EXPECT_LT(centre("radius").x, centre("ulna").x - 10.0);
}

TEST(Hand, NoPlaneHoldsAllFingers) {
  const io::Sample& s = cached("hand");
  // The middles of the phalanges of four fingers: their least extent, as a plane through them has it.
  std::vector<glm::dvec3> places;
  glm::dvec3 mean(0.0);
  for (const char* bone : {"proximal", "middle", "distal"})
    for (const char* finger : {"index", "middle", "ring", "little"}) {
      places.push_back(measure(s, std::string(bone) + " phalanx of " + finger + " finger").centre);
      mean += places.back() / 12.0;
    }
  double least = 1e9;
  for (int i = 0; i < 2000; ++i) {
    double z = (i + 0.5) / 2000, angle = i * 2.39996, r = std::sqrt(1 - z * z), sum = 0;
    glm::dvec3 normal(r * std::cos(angle), r * std::sin(angle), z);
    for (const auto& p : places) sum += std::pow(glm::dot(p - mean, normal), 2.0);
    least = std::min(least, std::sqrt(sum / 12.0));
  }
  EXPECT_GT(least, 2.5) << "mm off the best plane, on the mean";
}

TEST(Foot, BonesAreAsLargeAndWhereTheyAreInAFoot) {
  const io::Sample& s = cached("foot");
  const MlRange parts[] = {{"talus", 25, 50},
                           {"calcaneus", 45, 95},
                           {"navicular", 6, 16},
                           {"cuboid", 8, 20},
                           {"first metatarsal", 9, 22},
                           {"second metatarsal", 4, 12},
                           {"proximal phalanx of great toe", 3, 9},
                           {"distal phalanx of fifth toe", 0.05, 0.6}};
  expectMl(s, parts);
  // A right foot that stands: the great toe's side to +x, toes to -y.
  auto centre = [&](const char* name) { return measure(s, name).centre; };
  EXPECT_GT(centre("first metatarsal").x, centre("fifth metatarsal").x + 30.0);
  EXPECT_LT(centre("distal phalanx of great toe").y, centre("talus").y - 120.0);
  EXPECT_GT(centre("talus").z, centre("calcaneus").z + 15.0);
  EXPECT_GT(centre("calcaneus").y, centre("cuboid").y + 40.0);
  EXPECT_GT(centre("tibia").x, centre("fibula").x + 15.0);
}

TEST(Hand, BonesHaveAShellASpongyInsideAndAGapOfCartilage) {
  io::Sample s = make("hand", 256);
  EXPECT_NEAR(measure(s, "capitate", 3).mean, 330.0, 60.0);
  // No two bones touch: between them lies what is no bone.
  glm::ivec3 dims = s.volume.dims;
  auto ids = idsOf(s.labels);
  std::uint16_t first = idOf(s, "radius");
  int touching = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x + 1 < dims.x; ++x) {
        auto i = std::size_t((z * dims.y + y) * dims.x + x);
        touching += ids[i] >= first && ids[i + 1] >= first && ids[i] != ids[i + 1];
      }
  EXPECT_EQ(touching, 0);
}

TEST(Lesion, ValuesAloneLeakFromItIntoBone) {
  const io::Sample& s = cached("lesion");
  EXPECT_EQ(connectedPart(s, "lesion"), 1.0);
  EXPECT_EQ(connectedPart(s, "bone"), 1.0);
  EXPECT_GT(connectedPart(s, "artery"), 0.99);
  // How many voxels of one part lie beside another's of like values.
  auto contacts = [&](const char* one, const char* other) {
    std::uint16_t b = idOf(s, other);
    int count = 0;
    forEachVoxel(s, idOf(s, one), 0, [&](glm::ivec3 v) {
      for (glm::ivec3 step : {glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)})
        for (glm::ivec3 w : {v + step, v - step})
          if (s.labels.at(w) == b) {
            count += std::abs(valueAt(s.volume, v) - valueAt(s.volume, w)) < 60.0;
            return;
          }
    });
    return count;
  };
  EXPECT_GT(contacts("lesion", "bone"), 100);
  EXPECT_GT(contacts("artery", "bone"), 20);
  EXPECT_EQ(contacts("vein", "bone"), 0) << "which is there to compare with";
}

}  // namespace
}  // namespace velum
