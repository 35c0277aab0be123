#pragma once
#include <functional>
#include <initializer_list>
#include <map>
#include <vector>

#include "io/phantoms/Phantom.h"

/// The parts of which hand and foot are built: bones with a shell and a spongy inside, with gaps of cartilage between
/// them, and the flesh around.
namespace velum::io::limb {

using namespace phantom;

constexpr float kAir = -1000.0f, kSkinHu = 40.0f, kFatHu = -95.0f, kMuscleHu = 58.0f, kTendonHu = 95.0f,
                kArteryHu = 320.0f, kVeinHu = 170.0f;

/// A bone like those of fingers: thick ends and a thin shaft. Lengths in mm, world.
struct LongBone {
  Vec base, head;                              ///< The middles of both ends.
  Vec up;                                      ///< Direction, roughly, to the bone's back.
  glm::vec2 baseRadii, shaftRadii, headRadii;  ///< Half width, half depth.
  float bow = 0.0f;                            ///< How far the shaft is bent to the back.
  float notch = 0.0f;                          ///< Depth of the groove that parts the head in two.
  float round = 1.0f;                          ///< Form of the head: 0 flat, 1 a ball.
};

/// The shape of a bone before it gives way to its neighbours.
struct Bone {
  std::uint16_t label = 0;
  Box box;
  Distance distance;
  float cortexMm = 1.0f;  ///< Thickness of the shell at the ends, or everywhere where there is no shaft.
  float shaftMm = 0.0f;   ///< By how much the shell is thicker in the middle of the shaft.
  Distance shaft = {};    ///< 1 in the middle of the shaft, 0 at the ends; null: the bone is spongy all along.
};

Bone longBone(std::uint16_t label, const LongBone& shape, float cortexMm, float shaftMm);
/// One of the ellipsoids of which shortBone() makes a bone, joined by fillets of `fillet` mm.
struct Lump {
  Vec centre, radii;
};
Bone shortBone(std::uint16_t label, std::vector<Lump> lumps, float fillet = 4.0f, float cortexMm = 0.9f);
/// Adds a process to a bone.
void join(Bone& bone, Box box, Distance part, float fillet);

/// Bones in the order in which they take their places: each gives way to those bones added before it that it touches.
class Skeleton {
 public:
  explicit Skeleton(float gapMm) : mGapMm(gapMm) {}
  void add(Bone bone, std::initializer_list<std::uint16_t> touches);
  /// Distance from a point to the surface of a bone.
  float distanceTo(std::uint16_t label, Vec p) const;
  /// Distance from a point to the surface of the nearest bone.
  float distanceTo(Vec p) const;
  /// Appends the layers of the skeleton: cartilage in the gaps, then each bone as shell and spongy inside. The skeleton
  /// must live as long as the layers.
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

/// A joint of a finger or toe: its place, and the directions along and up of the bone that follows it.
struct Joint {
  Vec place, along, up;
};
/// The joints of a ray of bones, each bent against the one before it; the last one is the tip.
/// @param flexDeg  bend of each bone towards the palm or sole
std::vector<Joint> walk(Joint start, std::span<const float> lengths, std::span<const float> flexDeg);
/// Sizes of a bone of a finger or toe: half widths and half depths, mm, and the other parameters of LongBone and
/// longBone().
struct Sizes {
  glm::vec2 base, shaft, head;
  float cortex, shell, bow, notch, round;
};
/// The long bone from one joint to the next. @param into  how far it reaches into the joint at its base, mm
Bone boneBetween(std::uint16_t label, const Joint& from, const Joint& to, const Sizes& sizes, float scale, float into);
/// A curve along joints at some distance above them (below where negative). @param heights  one per joint
std::vector<glm::vec4> along(std::span<const Joint> joints, std::span<const float> heights, float radius);

/// Distance to the nearest of some tubes, each joined to those before it by a fillet.
float distanceTo(std::span<const Segment> tubes, Vec p, float fillet);

/// Below this radius, in voxels, a tube may fall apart into voxels that share no face.
constexpr float kThinnestVoxels = 0.9f;

/// Colours that tell neighbouring bones apart, all of them like bone.
glm::vec3 boneColor(int index);

/// Adds the bones of a limb to its table, in the order of their labels: those next to the trunk (`names`), the five of
/// hand or foot, and the phalanges; the first ray has no middle phalanx.
/// @param first  label of the first bone @param middle  what the five bones of hand or foot are called: "metacarpal"
/// @param rays  names of the fingers or toes
void addBoneNames(std::vector<LabelInfo>& table, int first, std::span<const char* const> names, const char* middle,
                  std::span<const char* const, 5> rays);

/// Adds the skin with fat below it.
void addSkin(std::vector<Layer>& layers, const Box& box, const Distance& skin, std::uint16_t skinLabel,
             std::uint16_t fatLabel);
/// Adds flesh along tubes; only the labels in `onto`, the fat, give way to it.
void addFlesh(std::vector<Layer>& layers, std::uint16_t label, float value, std::vector<Segment> tubes,
              std::initializer_list<std::uint16_t> onto);
/// Adds vessels; where they can, they bend round blocked places, and veins bend round arteries.
/// @param blocked  distance to places where vessels cannot be @param leastMm  radius of the thinnest vessel
void addVessels(std::vector<Layer>& layers, Layer artery, Layer vein, const Distance& blocked, float leastMm);
/// The tissues with which a limb is painted.
struct Tissues {
  Box box;        ///< around all of it
  Distance skin;  ///< distance to the limb's outside
  std::uint16_t skinLabel, fatLabel, cartilageLabel;
  float spacingMm;  ///< of voxels
};
/// All layers of a limb, from the skin to the vessels, in the order in which they are painted.
/// @param addFleshTo  adds muscles and tendons; a tube below `leastMm` would fall apart between the voxels
/// @param addVesselsTo  adds vessels; `blocked`: distance to places where they cannot be
std::vector<Layer> layersOf(
    const Tissues& tissues, const Skeleton& skeleton,
    const std::function<void(std::vector<Layer>& layers, float leastMm)>& addFleshTo,
    const std::function<void(std::vector<Layer>& layers, const Distance& blocked, float leastMm)>& addVesselsTo);
/// Makes the phantom: paints the layers, adds noise, and clips values as scanners do.
Sample scan(const Description& description, const Grid& grid, const std::vector<Layer>& layers, std::uint64_t seed,
            Progress& progress);

}  // namespace velum::io::limb
