#pragma once
#include <functional>
#include <initializer_list>
#include <map>
#include <vector>

#include "io/phantoms/Phantom.h"

/// What hand and foot are built of: bones with a shell and a spongy inside that leave a gap of cartilage between them,
/// and the flesh around.
namespace velum::io::limb {

using namespace phantom;

constexpr float kAir = -1000.0f, kSkinHu = 40.0f, kFatHu = -95.0f, kMuscleHu = 58.0f, kTendonHu = 95.0f,
                kArteryHu = 320.0f, kVeinHu = 170.0f;

/// A bone like those of fingers: thick ends and a thin shaft. Lengths in mm, world.
struct LongBone {
  Vec base, head;                              ///< The middles of both ends.
  Vec up;                                      ///< Roughly to its back.
  glm::vec2 baseRadii, shaftRadii, headRadii;  ///< Half width, half depth.
  float bow = 0.0f;                            ///< How far the shaft is bent to the back.
  float notch = 0.0f;                          ///< Depth of the groove that parts the head in two.
  float round = 1.0f;                          ///< Of the head: 0 flat, 1 a ball.
};

/// A bone as it is before it gives way to its neighbours.
struct Bone {
  std::uint16_t label = 0;
  Box box;
  Distance distance;
  float cortexMm = 1.0f;  ///< At its ends, or everywhere.
  float shaftMm = 0.0f;   ///< What the shell is thicker in the middle of a shaft.
  Distance shaft = {};    ///< 1 in the middle of the shaft, 0 at the ends; null: all of it is spongy.
};

Bone longBone(std::uint16_t label, const LongBone& shape, float cortexMm, float shaftMm);
/// Balls joined by fillets of `fillet` mm, in ellipsoids of their own radii.
struct Lump {
  Vec centre, radii;
};
Bone shortBone(std::uint16_t label, std::vector<Lump> lumps, float fillet = 4.0f, float cortexMm = 0.9f);
/// Adds a process to a bone.
void join(Bone& bone, Box box, Distance part, float fillet);

/// Bones in the order in which they take their places: each gives way to those that it touches and that were there.
class Skeleton {
 public:
  explicit Skeleton(float gapMm) : mGapMm(gapMm) {}
  void add(Bone bone, std::initializer_list<std::uint16_t> touches);
  /// To the surface of a bone.
  float distanceTo(std::uint16_t label, Vec p) const;
  /// To that of the nearest bone.
  float distanceTo(Vec p) const;
  /// Cartilage in the gaps, then each bone as shell and spongy inside. The skeleton must live as long as the layers.
  void addLayers(std::vector<Layer>& layers, std::uint16_t cartilage) const;

 private:
  struct Placed {
    Bone bone;
    std::vector<std::uint16_t> touches;
  };
  void addCartilage(std::vector<Layer>& layers, std::uint16_t cartilage) const;

  float mGapMm;
  std::vector<Placed> mBones;
  std::map<std::uint16_t, std::size_t> mPlaces;
};

/// A joint of a finger or toe: where it is and how what follows points.
struct Joint {
  Vec place, along, up;
};
/// The joints of a ray of bones, each bent against the one before it; the last one is the tip.
/// @param flexDeg  towards the palm or sole, of each bone
std::vector<Joint> walk(Joint start, std::span<const float> lengths, std::span<const float> flexDeg);
/// Of a bone of a finger or toe: half widths and half depths, mm, and what LongBone and longBone() take.
struct Sizes {
  glm::vec2 base, shaft, head;
  float cortex, shell, bow, notch, round;
};
/// The bone from joint to joint. @param into  how far it reaches into the joint at its base, mm
Bone boneBetween(std::uint16_t label, const Joint& from, const Joint& to, const Sizes& sizes, float scale, float into);
/// A curve along joints at some distance above them (below where negative). @param heights  one per joint
std::vector<glm::vec4> along(std::span<const Joint> joints, std::span<const float> heights, float radius);

/// The least distance to tubes, each of them joined to what is there by a fillet.
float distanceTo(std::span<const Segment> tubes, Vec p, float fillet);

/// Below this radius, in voxels, a tube may fall apart into voxels that share no face.
constexpr float kThinnestVoxels = 0.9f;

/// Colours that tell neighbouring bones apart, all of them like bone.
glm::vec3 boneColor(int index);

/// Adds the bones of a limb to its table, in the order of their labels: those next to the trunk, five of hand or foot,
/// and the phalanges, of which the first ray has no middle one.
/// @param first  label of the first bone  @param middle  what the five are called, "metacarpal"
/// @param rays  names of the fingers or toes
void addBoneNames(std::vector<LabelInfo>& table, int first, std::span<const char* const> names, const char* middle,
                  std::span<const char* const, 5> rays);

/// Skin with fat below it.
void addSkin(std::vector<Layer>& layers, const Box& box, const Distance& skin, std::uint16_t skinLabel,
             std::uint16_t fatLabel);
/// Flesh that only fat gives way to.
void addFlesh(std::vector<Layer>& layers, std::uint16_t label, float value, std::vector<Segment> tubes,
              std::initializer_list<std::uint16_t> onto);
/// Vessels, which bend round what is blocked, and veins round arteries, where they can.
/// @param blocked  distance to where they cannot be  @param leastMm  radius of the thinnest
void addVessels(std::vector<Layer>& layers, Layer artery, Layer vein, const Distance& blocked, float leastMm);
/// What a limb is painted of.
struct Tissues {
  Box box;        ///< around all of it
  Distance skin;  ///< to its outside
  std::uint16_t skinLabel, fatLabel, cartilageLabel;
  float spacingMm;  ///< of voxels
};
/// All layers of a limb, from the skin to the vessels, in the order in which they are painted.
/// @param addFleshTo  adds muscles and tendons; a tube below `leastMm` would fall apart between the voxels
/// @param addVesselsTo  adds vessels; `blocked`: distance to where they cannot be
std::vector<Layer> layersOf(
    const Tissues& tissues, const Skeleton& skeleton,
    const std::function<void(std::vector<Layer>& layers, float leastMm)>& addFleshTo,
    const std::function<void(std::vector<Layer>& layers, const Distance& blocked, float leastMm)>& addVesselsTo);
/// Paints, adds noise, and clips as scanners do.
Sample scan(const Description& description, const Grid& grid, const std::vector<Layer>& layers, std::uint64_t seed,
            Progress& progress);

}  // namespace velum::io::limb
