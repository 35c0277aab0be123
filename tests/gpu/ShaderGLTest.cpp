#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "SourceFolder.h"
#include "TempFolder.h"
#include "gpu/Buffer.h"
#include "gpu/GpuError.h"
#include "gpu/Program.h"
#include "shared/cut.h"
#include "shared/finish.h"
#include "shared/frame.h"
#include "shared/instance.h"

namespace velum::gpu {
namespace {

namespace fs = std::filesystem;

class ShaderGL : public GlTest {};

/// The members of a struct in shaders/shared, in order, as its text lists them.
std::vector<std::string> membersOf(const std::string& header, const std::string& structName) {
  std::ifstream in(sourceFolder() / "shaders" / "shared" / header);
  std::vector<std::string> members;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("struct " + structName + " {"))
      inside = true;
    else if (inside && line.starts_with("};"))
      break;
    else if (std::size_t end = line.find_first_of("[;"); inside && end != std::string::npos) {
      std::size_t start = line.rfind(' ', end) + 1;
      members.push_back(line.substr(start, end - start));
    }
  }
  return members;
}

struct Offset {
  const char* member;
  std::size_t bytes;
};
#define VELUM_OFFSET(type, member) \
  { #member, offsetof(shared::type, member) }

const Offset kFrameOffsets[] = {
    VELUM_OFFSET(FrameParams, texFromScene),   VELUM_OFFSET(FrameParams, sceneFromTex),
    VELUM_OFFSET(FrameParams, labelFromScene), VELUM_OFFSET(FrameParams, labelSize),
    VELUM_OFFSET(FrameParams, sharesBeyond),
    VELUM_OFFSET(FrameParams, clipFromScene),  VELUM_OFFSET(FrameParams, eye),
    VELUM_OFFSET(FrameParams, right),          VELUM_OFFSET(FrameParams, up),
    VELUM_OFFSET(FrameParams, forward),        VELUM_OFFSET(FrameParams, volumeSize),
    VELUM_OFFSET(FrameParams, storeSize),      VELUM_OFFSET(FrameParams, pageGrid),
    VELUM_OFFSET(FrameParams, pagesPerTex),    VELUM_OFFSET(FrameParams, firstPage),
    VELUM_OFFSET(FrameParams, cellGrid),       VELUM_OFFSET(FrameParams, cellsPerTex),
    VELUM_OFFSET(FrameParams, lightGrid),      VELUM_OFFSET(FrameParams, normalX),
    VELUM_OFFSET(FrameParams, normalY),        VELUM_OFFSET(FrameParams, normalZ),
    VELUM_OFFSET(FrameParams, keyLight),       VELUM_OFFSET(FrameParams, pictureUp),
    VELUM_OFFSET(FrameParams, planes),         VELUM_OFFSET(FrameParams, spareClasses),
    VELUM_OFFSET(FrameParams, planeBits),      VELUM_OFFSET(FrameParams, coarsening),
    VELUM_OFFSET(FrameParams, pictureSize),
    VELUM_OFFSET(FrameParams, subpixel),       VELUM_OFFSET(FrameParams, step),
    VELUM_OFFSET(FrameParams, opaqueAlpha),    VELUM_OFFSET(FrameParams, isoValue),
    VELUM_OFFSET(FrameParams, noise),          VELUM_OFFSET(FrameParams, voxelsPerLength),
    VELUM_OFFSET(FrameParams, tablePerTexel),  VELUM_OFFSET(FrameParams, tableOffset),
    VELUM_OFFSET(FrameParams, tablePerValue),  VELUM_OFFSET(FrameParams, extinctionUnit),
    VELUM_OFFSET(FrameParams, shownFrom),      VELUM_OFFSET(FrameParams, shownTo),
    VELUM_OFFSET(FrameParams, gradientUnit),   VELUM_OFFSET(FrameParams, gradientTableScale),
    VELUM_OFFSET(FrameParams, greyScale),      VELUM_OFFSET(FrameParams, greyOffset),
    VELUM_OFFSET(FrameParams, labelTint),      VELUM_OFFSET(FrameParams, unlabelledOpacity),
    VELUM_OFFSET(FrameParams, ambient),        VELUM_OFFSET(FrameParams, diffuse),
    VELUM_OFFSET(FrameParams, specular),       VELUM_OFFSET(FrameParams, shininess),
    VELUM_OFFSET(FrameParams, shadowStrength), VELUM_OFFSET(FrameParams, occlusionStrength),
    VELUM_OFFSET(FrameParams, lightCell),      VELUM_OFFSET(FrameParams, cutCount),
    VELUM_OFFSET(FrameParams, structureCount), VELUM_OFFSET(FrameParams, sampleIndex),
    VELUM_OFFSET(FrameParams, flags)};
const Offset kCutOffsets[] = {VELUM_OFFSET(CutData, localFromScene), VELUM_OFFSET(CutData, halfSize),
                              VELUM_OFFSET(CutData, kind),           VELUM_OFFSET(CutData, face),
                              VELUM_OFFSET(CutData, sheet),          VELUM_OFFSET(CutData, inlay)};

TEST_F(ShaderGL, FrameParamsLieWhereTheDriverPutsThem) {
  // A member that this list lacks would go unchecked.
  auto members = membersOf("frame.h", "FrameParams");
  ASSERT_EQ(members.size(), std::size(kFrameOffsets))
      << "shaders/shared/frame.h has changed: list its members here, too";
  Program program({"render/ray_cast.comp"}, {{"MODE", "0"}, {"LABELS", "1"}, {"COLOR", "0"}});
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_EQ(members[i], kFrameOffsets[i].member);
    int offset = program.memberOffset("FrameBlock", "frame." + members[i]);
    if (offset < 0) offset = program.memberOffset("FrameBlock", members[i]);
    EXPECT_EQ(offset, int(kFrameOffsets[i].bytes)) << members[i];
  }
  EXPECT_EQ(sizeof(shared::FrameParams), kFrameOffsets[std::size(kFrameOffsets) - 1].bytes + 4);
  EXPECT_EQ(sizeof(shared::FrameParams) % 16, 0u);
}

const Offset kFinishOffsets[] = {VELUM_OFFSET(FinishParams, contourColor),  VELUM_OFFSET(FinishParams, paperColor),
                                 VELUM_OFFSET(FinishParams, contours),      VELUM_OFFSET(FinishParams, contourPixels),
                                 VELUM_OFFSET(FinishParams, creases),       VELUM_OFFSET(FinishParams, steps),
                                 VELUM_OFFSET(FinishParams, structures),    VELUM_OFFSET(FinishParams, litSphere),
                                 VELUM_OFFSET(FinishParams, hatching),      VELUM_OFFSET(FinishParams, strokePixels),
                                 VELUM_OFFSET(FinishParams, cellPixels),    VELUM_OFFSET(FinishParams, paperGrain),
                                 VELUM_OFFSET(FinishParams, unitsPerPixel), VELUM_OFFSET(FinishParams, paperUnits),
                                 VELUM_OFFSET(FinishParams, reach),         VELUM_OFFSET(FinishParams, sphereRows),
                                 VELUM_OFFSET(FinishParams, cellsX),        VELUM_OFFSET(FinishParams, cellsY),
                                 VELUM_OFFSET(FinishParams, firstCellX),    VELUM_OFFSET(FinishParams, firstCellY),
                                 VELUM_OFFSET(FinishParams, stepLength),    VELUM_OFFSET(FinishParams, deepStep)};

void expectOffsets(const Program& program, const std::string& block, const std::string& name,
                   const std::vector<std::string>& members, const Offset* offsets) {
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_EQ(members[i], offsets[i].member);
    int own = program.memberOffset(block, name + "." + members[i]);
    EXPECT_EQ(own < 0 ? program.memberOffset(block, members[i]) : own, int(offsets[i].bytes)) << members[i];
  }
}

TEST_F(ShaderGL, FinishParamsLieWhereTheDriverPutsThem) {
  auto members = membersOf("finish.h", "FinishParams");
  ASSERT_EQ(members.size(), std::size(kFinishOffsets)) << "list the members of FinishParams here, too";
  expectOffsets(Program({"render/finish.comp"}, {{"FINISH", "1"}}), "FinishBlock", "finish", members, kFinishOffsets);
  EXPECT_EQ(sizeof(shared::FinishParams) % 16, 0u);
}

#define VELUM_VIEW_OFFSET(member) VELUM_OFFSET(InstanceView, member)
const Offset kInstanceViewOffsets[] = {
    VELUM_VIEW_OFFSET(eye),           VELUM_VIEW_OFFSET(right),          VELUM_VIEW_OFFSET(up),
    VELUM_VIEW_OFFSET(forward),       VELUM_VIEW_OFFSET(copyStep),       VELUM_VIEW_OFFSET(copySphere),
    VELUM_VIEW_OFFSET(pictureSize),   VELUM_VIEW_OFFSET(shift),          VELUM_VIEW_OFFSET(size),
    VELUM_VIEW_OFFSET(tilesX),        VELUM_VIEW_OFFSET(tilesY),         VELUM_VIEW_OFFSET(copiesX),
    VELUM_VIEW_OFFSET(copiesY),       VELUM_VIEW_OFFSET(copies),         VELUM_VIEW_OFFSET(instanceCount),
    VELUM_VIEW_OFFSET(cutCount),      VELUM_VIEW_OFFSET(isOrthographic), VELUM_VIEW_OFFSET(detail),
    VELUM_VIEW_OFFSET(largeRadius),   VELUM_VIEW_OFFSET(wholeInstances), VELUM_VIEW_OFFSET(levelCount),
    VELUM_VIEW_OFFSET(stateWords),    VELUM_VIEW_OFFSET(drawRoom),       VELUM_VIEW_OFFSET(firstWhole),
    VELUM_VIEW_OFFSET(wholeMolecule), VELUM_VIEW_OFFSET(allCopies),      VELUM_VIEW_OFFSET(copiesZ),
    VELUM_VIEW_OFFSET(showsInside),   VELUM_VIEW_OFFSET(padding0),       VELUM_VIEW_OFFSET(padding1),
    VELUM_VIEW_OFFSET(padding2)};

TEST_F(ShaderGL, InstanceViewsLieWhereTheDriverPutsThem) {
  auto members = membersOf("instance.h", "InstanceView");
  ASSERT_EQ(members.size(), std::size(kInstanceViewOffsets)) << "list the members of InstanceView here, too";
  expectOffsets(Program({"model/cull.comp"}, {{"STATES", "1"}}), "InstanceViewBlock", "view", members,
                kInstanceViewOffsets);
  EXPECT_EQ(sizeof(shared::InstanceView) % 16, 0u);
}

const Offset kFocusViewOffsets[] = {
    VELUM_OFFSET(FocusView, eye),      VELUM_OFFSET(FocusView, right),       VELUM_OFFSET(FocusView, up),
    VELUM_OFFSET(FocusView, forward),  VELUM_OFFSET(FocusView, size),        VELUM_OFFSET(FocusView, isOrthographic),
    VELUM_OFFSET(FocusView, cut),      VELUM_OFFSET(FocusView, guidesDepth), VELUM_OFFSET(FocusView, hasAperture),
    VELUM_OFFSET(FocusView, padding0), VELUM_OFFSET(FocusView, padding1)};

TEST_F(ShaderGL, FocusViewsLieWhereTheDriverPutsThem) {
  auto members = membersOf("instance.h", "FocusView");
  ASSERT_EQ(members.size(), std::size(kFocusViewOffsets)) << "list the members of FocusView here, too";
  Program program({"model/focus.comp"}, {{"OCCLUDERS", "1"}});
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_EQ(members[i], kFocusViewOffsets[i].member);
    int offset = program.memberOffset("FocusBlock", "focus." + members[i]);
    if (offset < 0) offset = program.memberOffset("FocusBlock", members[i]);
    // What this program does not read may be gone.
    if (offset < 0 && (members[i].starts_with("padding") || members[i] == "guidesDepth")) continue;
    EXPECT_EQ(offset, int(kFocusViewOffsets[i].bytes)) << members[i];
  }
  EXPECT_EQ(sizeof(shared::FocusView) % 16, 0u);
}

const Offset kInstanceShadeOffsets[] = {
    VELUM_OFFSET(InstanceShade, fogTop),        VELUM_OFFSET(InstanceShade, fogBottom),
    VELUM_OFFSET(InstanceShade, fog),           VELUM_OFFSET(InstanceShade, fogNear),
    VELUM_OFFSET(InstanceShade, fogFar),        VELUM_OFFSET(InstanceShade, nearColors),
    VELUM_OFFSET(InstanceShade, radius),        VELUM_OFFSET(InstanceShade, lightTexel),
    VELUM_OFFSET(InstanceShade, noise),         VELUM_OFFSET(InstanceShade, occlusionTaps),
    VELUM_OFFSET(InstanceShade, firstInstance), VELUM_OFFSET(InstanceShade, firstType),
    VELUM_OFFSET(InstanceShade, palette),       VELUM_OFFSET(InstanceShade, hasLight),
    VELUM_OFFSET(InstanceShade, angstrom),      VELUM_OFFSET(InstanceShade, padding0),
    VELUM_OFFSET(InstanceShade, openShift)};

TEST_F(ShaderGL, InstanceShadesLieWhereTheDriverPutsThem) {
  auto members = membersOf("instance.h", "InstanceShade");
  ASSERT_EQ(members.size(), std::size(kInstanceShadeOffsets)) << "list the members of InstanceShade here, too";
  Program program({"render/instances.comp"});
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_EQ(members[i], kInstanceShadeOffsets[i].member);
    int offset = program.memberOffset("InstanceShadeBlock", "shade." + members[i]);
    if (offset < 0) offset = program.memberOffset("InstanceShadeBlock", members[i]);
    // Padding that nobody reads may be gone.
    if (offset < 0 && members[i].starts_with("padding")) continue;
    EXPECT_EQ(offset, int(kInstanceShadeOffsets[i].bytes)) << members[i];
  }
  EXPECT_EQ(sizeof(shared::InstanceShade) % 16, 0u);
}

/// Offsets in storage blocks, asked of the shader itself: it writes what it reads from each member.
TEST_F(ShaderGL, CutDataLiesWhereTheDriverPutsIt) {
  ASSERT_EQ(membersOf("cut.h", "CutData").size(), std::size(kCutOffsets)) << "list the members of CutData here, too";
  ProbeShaders probes;
  probes.add("probe.comp", R"(layout(local_size_x = 1) in;
#include "shared/cut.h"
layout(std430, binding = 1) readonly buffer CutBlock { CutData cuts[]; };
layout(std430, binding = 2) buffer OutBlock { float seen[]; };
void main() {
  for (int c = 0; c < 2; ++c) {
    int at = c * 36;
    for (int i = 0; i < 16; ++i) seen[at + i] = cuts[c].localFromScene[i / 4][i % 4];
    for (int i = 0; i < 4; ++i) seen[at + 16 + i] = cuts[c].halfSize[i];
    for (int i = 0; i < 4; ++i) seen[at + 20 + i] = float(cuts[c].kind[i]);
    for (int i = 0; i < 4; ++i) seen[at + 24 + i] = cuts[c].face[i];
    for (int i = 0; i < 4; ++i) seen[at + 28 + i] = float(cuts[c].sheet[i]);
    for (int i = 0; i < 4; ++i) seen[at + 32 + i] = cuts[c].inlay[i];
  }
}
)");
  Program probe = probes.make({"probe.comp"});
  shared::CutData cuts[2];
  std::vector<float> expected;
  float next = 1;
  for (auto& cut : cuts) {
    for (int i = 0; i < 16; ++i) expected.push_back(cut.localFromScene[i / 4][i % 4] = next++);
    for (int i = 0; i < 4; ++i) expected.push_back(cut.halfSize[i] = next++);
    for (int i = 0; i < 4; ++i) expected.push_back(float(cut.kind[i] = int(next++)));
    for (int i = 0; i < 4; ++i) expected.push_back(cut.face[i] = next++);
    for (int i = 0; i < 4; ++i) expected.push_back(float(cut.sheet[i] = int(next++)));
    for (int i = 0; i < 4; ++i) expected.push_back(cut.inlay[i] = next++);
  }
  Buffer in("cuts", std::span<const shared::CutData>(cuts)), out("seen", expected.size() * sizeof(float));
  in.bindStorage(1);
  out.bindStorage(2);
  dispatch(probe, {1, 1, 1});
  barrier();
  std::vector<float> seen(expected.size());
  out.read(0, seen.size() * sizeof(float), seen.data());
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(sizeof(shared::CutData) % 16, 0u);
}

/// The message of compiling `file` from a copy of the shaders in which one line was added to `broken`.
std::string messageOfBroken(const std::string& file, const std::string& broken, int line, const std::string& text) {
  TempFolder folder;
  fs::copy(sourceFolder() / "shaders", folder.path(), fs::copy_options::recursive);
  std::ifstream in(folder / broken);
  std::string before, all;
  for (int number = 1; std::getline(in, before); ++number) all += (number == line ? text + "\n" : "") + before + "\n";
  in.close();
  std::ofstream(folder / broken) << all;
  ::setenv("VELUM_SHADER_DIR", folder.path().c_str(), 1);
  std::string message;
  try {
    Program({file}, {{"MODE", "0"}, {"LABELS", "0"}, {"COLOR", "0"}});
  } catch (const GpuError& error) {
    message = error.what();
  }
  ::unsetenv("VELUM_SHADER_DIR");
  return message;
}

TEST_F(ShaderGL, ACompileErrorNamesTheIncludedFileAndLine) {
  std::string message = messageOfBroken("render/ray_cast.comp", "common/volume.glsl", 3, "int broken = notDeclared;");
  EXPECT_NE(message.find("common/volume.glsl:3"), std::string::npos) << message;
  EXPECT_NE(message.find("notDeclared"), std::string::npos) << message;
  message = messageOfBroken("render/ray_cast.comp", "render/ray_cast.comp", 5, "int broken = alsoNotDeclared;");
  EXPECT_NE(message.find("render/ray_cast.comp:5"), std::string::npos) << message;
}

TEST_F(ShaderGL, AMissingIncludeIsNamed) {
  std::string message =
      messageOfBroken("render/ray_cast.comp", "common/volume.glsl", 2, "#include \"common/none.glsl\"");
  EXPECT_NE(message.find("common/none.glsl"), std::string::npos) << message;
}

TEST_F(ShaderGL, AnUnknownEntryPointIsNamed) {
  try {
    Program({"render/none.comp"});
    FAIL() << "there is no render/none.comp";
  } catch (const GpuError& error) {
    EXPECT_NE(std::string(error.what()).find("render/none.comp"), std::string::npos) << error.what();
  }
}

TEST_F(ShaderGL, AfterACompileErrorTheContextStillWorks) {
  EXPECT_NE(messageOfBroken("render/resolve.comp", "render/resolve.comp", 3, "syntax error here"), "");
  EXPECT_NO_THROW(Program({"render/resolve.comp"}));
}

}  // namespace
}  // namespace velum::gpu
