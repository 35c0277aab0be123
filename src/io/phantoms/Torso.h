#pragma once
#include <vector>

#include "io/phantoms/Phantom.h"

/// The trunk of an adult lying on the back, arms raised: world LPS in mm, origin in the middle of the scan. The levels:
/// first thoracic vertebra at z = 205, diaphragm's domes near 10, last lumbar vertebra down to -170, iliac crests at
/// -140.
namespace velum::io::torso {

using namespace phantom;

enum Part : std::uint16_t {
  kSkin = 1,
  kFat,
  kMuscle,
  kVisceralFat,
  kRibsLeft,
  kRibsRight,
  kCartilage,
  kSternum,
  kVertebrae,
  kDiscs,
  kSacrum,
  kHips,
  kScapulae,
  kClavicles,
  kHumeri,
  kSpinalCanal,
  kLungLeft,
  kLungRight,
  kAirways,
  kLungVessels,
  kPulmonaryArtery,
  kHeartMuscle,
  kLeftVentricle,
  kRightVentricle,
  kLeftAtrium,
  kRightAtrium,
  kAorta,
  kArteries,
  kVenaCava,
  kPortalVein,
  kLiver,
  kGallbladder,
  kKidneyLeft,
  kKidneyRight,
  kMedulla,
  kSpleen,
  kPancreas,
  kStomach,
  kGas,
  kSmallBowel,
  kColon,
  kOesophagus
};

/// Names, colours and CT numbers of the parts.
std::vector<LabelInfo> partTable();

// The surfaces and curves by which the parts are placed.
float spineY(float z);                  ///< Middle of the vertebral bodies.
float skinDistance(Vec p);              ///< Distance to the body's surface.
glm::vec3 cageEllipse(float z);         ///< Inner trunk wall: half width, half depth, y of the middle.
float cavityDistance(Vec p);            ///< Distance to the inner wall of chest and belly.
float diaphragmZ(float x, float y);     ///< Height of the diaphragm.
float bellyDistance(Vec p);             ///< Distance to the part of the cavity below the diaphragm.
float lungDistance(Vec p, float side);  ///< Distance to a lung; side: +1 left, -1 right.
/// The point (x, y) at height z that lies `outMm` outside the inner trunk wall. angle: 0 at the back, pi at the front,
/// rad.
glm::vec2 onCage(float z, float angle, float outMm);

const Box kEverywhere{Vec(-210.0f, -150.0f, -240.0f), Vec(210.0f, 150.0f, 240.0f)};

// The layers, in painting order. Each takes the list and appends to it.
void addBodyWall(std::vector<Layer>& layers);
void addLungs(std::vector<Layer>& layers, float spacing);
void addHeart(std::vector<Layer>& layers);
void addGreatVessels(std::vector<Layer>& layers);
void addBowel(std::vector<Layer>& layers);
void addBellyOrgans(std::vector<Layer>& layers, float spacing);
void addBones(std::vector<Layer>& layers);

}  // namespace velum::io::torso
