// The scene that rides along in a drawing.
#include "vector/Description.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "Programs.h"
#include "core/Error.h"
#include "vector/WritePdf.h"
#include "vector/WriteSvg.h"

namespace velum::vector {
namespace {

/// Any bytes: what ends elements, CDATA, streams and texts, and much of them.
std::string hostileText() {
  std::string text = "{\"a\": \"</velum:scene> ]]> <!-- & endstream endobj /VelumScene \\u00e4 \xc3\xa4\"}";
  text += '\0';
  unsigned random = 5;
  for (int i = 0; i < 300'000; ++i) text += char((random = random * 1664525u + 1013904223u) >> 24);
  return text;
}

class Descriptions : public Programs {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(mFolder / name, std::ios::binary) << bytes;
    return mFolder / name;
  }
  /// What is said of a file that is refused; "" where it is read.
  std::string refusal(const std::string& name, const std::string& bytes) const {
    try {
      readDescription(file(name, bytes));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(Descriptions, AreReadAsTheyWereWritten) {
  for (const std::string& text : {std::string("{}"), std::string("{\"volume\": 1}\n"), hostileText()}) {
    writeSvg(plate(), mFolder / "a.svg", text);
    writePdf(plate(), mFolder / "a.pdf", text);
    EXPECT_TRUE(readDescription(mFolder / "a.svg") == text) << text.substr(0, 40);
    EXPECT_TRUE(readDescription(mFolder / "a.pdf") == text) << text.substr(0, 40);
  }
  writeSvg(plate(), mFolder / "a.svg");
  writePdf(plate(), mFolder / "a.pdf");
  EXPECT_EQ(readDescription(mFolder / "a.svg"), "");
  EXPECT_EQ(readDescription(mFolder / "a.pdf"), "");
}

TEST_F(Descriptions, ChangeNothingElseOfTheFile) {
  const std::string svg = svgOf(plate(), "{\"a\": 1}");
  std::size_t begin = svg.find("\n<velum:scene"), end = svg.find("</velum:scene>") + 14;
  EXPECT_EQ(svg.substr(0, begin) + svg.substr(end), svgOf(plate()));
  EXPECT_EQ(pdfOf(plate(), "{}"), pdfOf(plate(), "{}")) << "the same bytes each time";
}

TEST_F(Descriptions, AreFoundBehindMuchElse) {
  for (std::size_t before : {(1u << 20) - 13u, (1u << 20) - 6u, (1u << 20), (5u << 20) - 1u}) {
    std::string svg = svgOf(plate(), "{\"a\": 1}");
    svg.insert(svg.find("<metadata>"), "<!--" + std::string(before, ' ') + "-->");
    EXPECT_EQ(readDescription(file("a.svg", svg)), "{\"a\": 1}");
  }
}

TEST_F(Descriptions, SurviveProgramsThatWriteTheFileAnew) {
  const std::string text = hostileText();
  writeSvg(plate(), mFolder / "a.svg", text);
  writePdf(plate(), mFolder / "a.pdf", text);
  if (has("xmllint")) {
    run("xmllint --format --output b.svg a.svg");
    EXPECT_TRUE(readDescription(mFolder / "b.svg") == text) << "xmllint";
  }
  if (has("qpdf")) {
    for (const char* how :
         {"--qdf --object-streams=disable", "--object-streams=generate --recompress-flate", "--linearize"}) {
      run(std::string("qpdf ") + how + " a.pdf b.pdf");
      EXPECT_TRUE(readDescription(mFolder / "b.pdf") == text) << how;
    }
    EXPECT_EQ(run("qpdf --check a.pdf >/dev/null && echo sound"), "sound\n");
    EXPECT_EQ(run("qpdf --show-attachment=scene.json a.pdf"), text) << "by any other reader, too";
  }
  if (has("inkscape")) {
    run("inkscape --export-filename=c.svg a.svg");
    EXPECT_TRUE(readDescription(mFolder / "c.svg") == text) << "inkscape";
  }
}

TEST_F(Descriptions, WhatIsDamagedIsRefusedInOneLine) {
  const std::string svg = svgOf(plate(), "{\"a\": 1}"), pdf = pdfOf(plate(), hostileText());
  std::size_t inSvg = svg.find("<velum:scene"), inPdf = pdf.find("/VelumScene");
  for (std::size_t keep : {std::size_t(3), std::size_t(20), std::size_t(75)})
    EXPECT_NE(refusal("a.svg", svg.substr(0, inSvg + 12 + keep)), "") << keep;
  for (std::size_t keep : {std::size_t(3), std::size_t(40), std::size_t(20'000)})
    EXPECT_NE(refusal("a.pdf", pdf.substr(0, inPdf + 11 + keep)), "") << keep;
  std::string letters = svg;
  letters[svg.find('>', inSvg) + 3] = '*';
  EXPECT_NE(refusal("a.svg", letters), "");
  std::string bytes = pdf;
  for (std::size_t i = 0; i < 64; ++i) bytes[pdf.find("stream", inPdf) + 40 + i] = '\x55';
  EXPECT_NE(refusal("a.pdf", bytes), "");
  std::string said = refusal("a.svg", letters);
  EXPECT_EQ(std::ranges::count(said, '\n'), 0) << said;
  EXPECT_NE(said.find("a.svg"), std::string::npos) << said;
  EXPECT_THROW(readDescription(mFolder / "none.svg"), InputError);
}

TEST_F(Descriptions, WhatIsNotOursHoldsNoneAndBombsDoNotGoOff) {
  auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(readDescription(file("empty.svg", "")), "");
  EXPECT_EQ(readDescription(file("empty.pdf", "%PDF-1.4\n")), "");
  std::string laughs = "<!DOCTYPE svg [<!ENTITY a \"ha\">";
  for (char c = 'b'; c < 'z'; ++c) {
    laughs += std::string("<!ENTITY ") + c + " \"";
    for (int i = 0; i < 10; ++i) laughs += std::string("&") + char(c - 1) + ";";
    laughs += "\">";
  }
  EXPECT_EQ(readDescription(file("laughs.svg", laughs + "]><svg>&y;</svg>")), "");
  EXPECT_NE(refusal("laughs.svg", laughs + "]><svg><velum:scene encoding=\"base64\">&y;</velum:scene></svg>"), "");
  // Zeros that unpack to much more than they are: a text of 65 MiB is refused, and no more of it is made.
  std::string zeros(kLongestDescription + (1u << 20), ' ');
  EXPECT_THROW(svgOf(plate(), zeros), InputError);
  EXPECT_THROW(pdfOf(plate(), zeros), InputError);
  const std::string pdf = pdfOf(plate(), zeros.substr(0, kLongestDescription));
  EXPECT_LT(pdf.size(), 1u << 20);
  EXPECT_EQ(readDescription(file("most.pdf", pdf)).size(), kLongestDescription);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(30));
}

}  // namespace
}  // namespace velum::vector
