// InVesalius projects, made byte by byte: a tar of a plist and the voxels.
#include <fmt/format.h>

#include "TestFiles.h"
#include "io/volumes/Readers.h"

namespace velum::io {
namespace {

std::string tarMember(const std::string& name, const std::string& bytes) {
  std::string header(512, '\0');
  header.replace(0, name.size(), name);
  header.replace(100, 7, "0000644");
  header.replace(124, 11, fmt::format("{:011o}", bytes.size()));
  header[156] = '0';
  header.replace(257, 5, "ustar");
  header.replace(148, 8, 8, ' ');
  unsigned sum = 0;
  for (char c : header) sum += static_cast<unsigned char>(c);
  header.replace(148, 7, fmt::format("{:06o}", sum) + '\0');
  std::string padding((512 - bytes.size() % 512) % 512, '\0');
  return header + bytes + padding;
}

struct Project {
  std::string dtype = "int16", shape = "<integer>2</integer><integer>3</integer><integer>4</integer>";  // z, y, x
  std::string spacing = "<real>0.5</real><integer>2</integer><real>1.5</real>", modality = "CT";
  int orientation = 1;
  std::string plist() const {
    return fmt::format(
        "<?xml version=\"1.0\"?><plist version=\"1.0\"><dict>\n<key>name</key><string>a head</string>\n"
        "<key>modality</key><string>{}</string>\n<key>orientation</key><integer>{}</integer>\n"
        "<key>spacing</key><array>{}</array>\n<key>matrix</key><dict>\n<key>dtype</key><string>{}</string>\n"
        "<key>filename</key><string>matrix.dat</string>\n<key>shape</key><array>{}</array>\n</dict></dict></plist>",
        modality, orientation, spacing, dtype, shape);
  }
};

/// 24 samples: 100 times their number less 1000.
std::string matrix() {
  std::string bytes;
  for (int i = 0; i < 24; ++i) {
    auto value = std::int16_t(100 * i - 1000);
    bytes.append(reinterpret_cast<const char*>(&value), 2);
  }
  return bytes;
}

Volume readInv(const std::filesystem::path& path) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  return readInvesalius(source, progress);
}

void expectRefused(const std::string& tar, const char* words) {
  TempFolder folder;
  writeGzip(folder / "a.inv3", tar);
  try {
    readInv(folder / "a.inv3");
    ADD_FAILURE() << "opened: " << words;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(Invesalius, VoxelsStandUprightAndLookForward) {
  TempFolder folder;
  // The members in either order, with one before them that nobody asks for.
  for (bool voxelsFirst : {false, true})
    for (bool isPacked : {false, true}) {
      std::string plist = tarMember("head/main.plist", Project().plist()),
                  voxels = tarMember("head/matrix.dat", matrix());
      std::string tar = tarMember("head/mask_0.plist", std::string(700, 'x')) + (voxelsFirst ? voxels : plist) +
                        (voxelsFirst ? plist : voxels) + std::string(1024, '\0');
      if (isPacked)
        writeGzip(folder / "a.inv3", tar);
      else
        writeText(folder / "a.inv3", tar);
      Volume v = readInv(folder / "a.inv3");
      ASSERT_EQ(v.dims, glm::ivec3(4, 3, 2));
      EXPECT_EQ(valueAt(v, {1, 0, 0}), -900);
      EXPECT_EQ(valueAt(v, {0, 1, 0}), -600);
      EXPECT_EQ(valueAt(v, {0, 0, 1}), 200);
      // The second axis runs to the anterior, from where its last row lies at 0.
      EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(0.5, 0, 0, 0));
      EXPECT_EQ(v.worldFromVoxel[1], glm::dvec4(0, -2, 0, 0));
      EXPECT_EQ(v.worldFromVoxel[2], glm::dvec4(0, 0, 1.5, 0));
      EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(0, 4, 0, 1));
      EXPECT_EQ(v.unit, "HU");
      EXPECT_EQ(v.modality, Modality::CT);
      EXPECT_EQ(v.name, "a head");
      EXPECT_TRUE(v.warnings.empty());
    }
}

TEST(Invesalius, OtherModalitiesTypesAndOrientations) {
  TempFolder folder;
  Project project;
  project.dtype = "uint8";
  project.modality = "MRI";
  project.orientation = 2;
  project.shape = "<integer>4</integer><integer>3</integer><integer>4</integer>";
  writeText(folder / "a.inv3", tarMember("main.plist", project.plist()) + tarMember("matrix.dat", matrix()));
  Volume v = readInv(folder / "a.inv3");
  EXPECT_EQ(v.type, SampleType::UInt8);
  EXPECT_EQ(v.modality, Modality::MR);
  EXPECT_EQ(v.unit, "");
  EXPECT_EQ(v.warnings.size(), 1u) << "its slices were not axial";
}

TEST(Invesalius, DamageIsRefusedInWords) {
  std::string plist = tarMember("main.plist", Project().plist()), voxels = tarMember("matrix.dat", matrix());
  expectRefused(voxels, "no main.plist");
  expectRefused(plist, "'matrix.dat' is missing");
  expectRefused(plist + tarMember("matrix.dat", matrix().substr(2)), "can hold 46 at most");
  expectRefused(plist + tarMember("matrix.dat", matrix() + "ab"), "the voxels need 48 bytes");
  expectRefused(std::string(2000, 'x'), "no tar archive");
  expectRefused(tarMember("other", std::string(5000, 'x')).substr(0, 1500), "cut short");
  Project project;
  project.dtype = "complex64";
  expectRefused(tarMember("main.plist", project.plist()) + voxels, "'complex64'");
  project = {};
  project.spacing = "<real>0.5</real><real>0</real><real>1</real>";
  expectRefused(tarMember("main.plist", project.plist()) + voxels, "a voxel spacing of 0 mm");
  project = {};
  project.shape = "<integer>2</integer><integer>3</integer>";
  expectRefused(tarMember("main.plist", project.plist()) + voxels, "fewer than three");
  project.shape = "<integer>2000000</integer><integer>3000000</integer><integer>4000000</integer>";
  expectRefused(tarMember("main.plist", project.plist()) + voxels, "a.inv3");
}

}  // namespace
}  // namespace velum::io
