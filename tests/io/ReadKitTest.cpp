#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <limits>

#include "TestFiles.h"
#include "core/Error.h"
#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/ReadVolume.h"

namespace velum::io {
namespace {

std::string noise(std::size_t count) {
  std::string bytes(count, '\0');
  std::uint32_t state = 1;
  for (char& c : bytes) c = char((state = state * 1664525u + 1013904223u) >> 24);
  return bytes;
}

std::string readAll(ByteSource& source, std::size_t most) {
  std::string bytes(most, '\0');
  bytes.resize(source.readSome(std::as_writable_bytes(std::span(bytes))));
  return bytes;
}

TEST(FileNames, ATitleHasNoEndings) {
  TempFolder folder;
  std::filesystem::create_directory(folder / "study.1");
  EXPECT_EQ(titleOf("a/brain.nii.gz"), "brain");
  EXPECT_EQ(titleOf("a/brain.seg.nrrd"), "brain");
  EXPECT_EQ(titleOf("a/brain.v2.mha"), "brain.v2");
  EXPECT_EQ(titleOf(folder / "study.1"), "study.1");
  EXPECT_EQ(titleOf((folder / "study.1").string() + "/"), "study.1");
}

TEST(FileNames, WhatAHeaderNamesLiesInItsFolder) {
  TempFolder folder;
  writeText(folder / "a.raw", "x");
  EXPECT_EQ(siblingFile(folder / "a.nhdr", "a.raw"), folder / "a.raw");
  for (const char* name : {"", "../a.raw", "/etc/passwd", "b.raw", "sub/../../a.raw"})
    EXPECT_THROW(siblingFile(folder / "a.nhdr", name), InputError) << name;
}

TEST(ByteSource, DeflatedOrNotGivesTheSameBytes) {
  TempFolder folder;
  std::string bytes = noise(3'000'001);
  writeText(folder / "plain", bytes);
  writeGzip(folder / "packed", bytes);
  // As pigz and bgzip write it: one stream behind the other.
  writeGzip(folder / "members", bytes.substr(0, 1'000'000));
  writeGzip(folder / "members", bytes.substr(1'000'000), "ab");
  for (const char* name : {"plain", "packed", "members"}) {
    ByteSource source(folder / name);
    EXPECT_EQ(source.skip(17), 17u);
    EXPECT_EQ(readAll(source, bytes.size()), bytes.substr(17)) << name;
    EXPECT_EQ(source.skip(5), 0u) << name;
    EXPECT_GE(source.mostBytes(), bytes.size()) << name;
  }
}

TEST(ByteSource, AStreamThatIsCutOrDamagedIsRefusedByName) {
  TempFolder folder;
  std::string bytes = noise(100'000);
  writeGzip(folder / "a.gz", bytes);
  std::string packed(std::filesystem::file_size(folder / "a.gz"), '\0');
  std::ifstream(folder / "a.gz", std::ios::binary).read(packed.data(), std::streamsize(packed.size()));
  writeText(folder / "cut.gz", packed.substr(0, packed.size() / 2));
  packed[packed.size() - 6] = char(packed[packed.size() - 6] ^ 1);  // in the check sum
  writeText(folder / "sum.gz", packed);
  for (const char* name : {"cut.gz", "sum.gz"}) {
    try {
      ByteSource source(folder / name);
      readAll(source, bytes.size());
      source.verifyEnd();
      ADD_FAILURE() << name << " was read";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

TEST(FileBytes, OnlyRegularFilesAreOpened) {
  TempFolder folder;
  EXPECT_THROW(FileBytes(folder / "missing"), InputError);
  EXPECT_THROW(FileBytes{folder.path()}, InputError);
  EXPECT_THROW(ByteSource(folder / "missing"), InputError);
}

TEST(CheckedBytes, NothingIsPromisedThatTheFileCannotHold) {
  EXPECT_EQ(checkedBytes("a", {4, 5, 6}, 3, 2, 4, 2880), 2880u);
  EXPECT_THROW(checkedBytes("a", {4, 5, 6}, 3, 2, 4, 2879), InputError);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (glm::dvec3 dims : {glm::dvec3(0, 5, 6), glm::dvec3(-4, 5, 6), glm::dvec3(kNaN, 5, 6), glm::dvec3(1e30, 1, 1),
                          glm::dvec3(1e9, 1e9, 1e9)})
    EXPECT_THROW(checkedBytes("a", dims, 1, 1, 1, std::numeric_limits<double>::infinity()), InputError);
}

TEST(ReadVolume, EachFormatSaysOnceThatItHasNoSpacingAndTakesTheUsers) {
  TempFolder folder;
  writeText(folder / "a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678");
  writeText(folder / "a.mha",
            "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 0 0 0\nElementType = MET_UCHAR\n"
            "ElementDataFile = LOCAL\n12345678");
  writeText(folder / "a.raw", "12345678");
  for (const char* name : {"a.nrrd", "a.mha", "a.raw"}) {
    Progress progress;
    scene::Source source;
    source.path = (folder / name).string();
    if (name == std::string("a.raw")) source.raw.dims = {2, 2, 2};
    Volume v = readVolume(source, progress);
    EXPECT_FALSE(v.isSpacingKnown) << name;
    int said = 0;
    for (const std::string& warning : v.warnings) said += warning.find("spacing") != std::string::npos;
    EXPECT_EQ(said, 1) << name;
    source.spacing = {0.5, 0.75, 2.0};
    v = readVolume(source, progress);
    EXPECT_EQ(spacingOf(v), source.spacing) << name;
    EXPECT_TRUE(v.isSpacingKnown) << name;
    for (const std::string& warning : v.warnings) EXPECT_EQ(warning.find("spacing"), std::string::npos) << warning;
  }
}

TEST(ReadVolume, ASpacingThatNobodyCanInvertIsNotTaken) {
  TempFolder folder;
  for (const char* spacing : {"1e-200", "1e200"}) {
    writeText(
        folder / "a.mha",
        std::string("ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementSpacing = ") +
            spacing + " " + spacing + " " + spacing + "\nElementDataFile = LOCAL\n12345678");
    Progress progress;
    Volume v = readVolume({(folder / "a.mha").string()}, progress);
    EXPECT_EQ(spacingOf(v), glm::dvec3(1.0)) << spacing;
    EXPECT_FALSE(v.isSpacingKnown);
    EXPECT_FALSE(v.warnings.empty());
  }
}

TEST(ReadVolume, WarningsAreInTheUnitOfTheData) {
  Volume v;
  v.lengthUnit = LengthUnit::Angstrom;
  v.isSpacingKnown = false;
  applySpacing(v, {});
  ASSERT_EQ(v.warnings.size(), 1u);
  EXPECT_EQ(v.warnings[0].find("mm"), std::string::npos) << v.warnings[0];
}

}  // namespace
}  // namespace velum::io
