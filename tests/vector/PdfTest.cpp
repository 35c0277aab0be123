#include "vector/WritePdf.h"

#include <thread>

#include "Programs.h"
#include "vector/Letters.h"
#include "vector/Paint.h"

namespace velum::vector {
namespace {

TEST(Pdf, TheSameDrawingHasTheSameBytes) {
  std::string pdf = pdfOf(plate());
  EXPECT_EQ(pdf, pdfOf(plate()));
  EXPECT_EQ(pdf.substr(0, 8), "%PDF-1.5");
}

TEST(Pdf, ThreadsWriteAtOnce) {
  const Drawing drawing = plate();
  std::vector<std::string> files(4);
  std::vector<std::thread> threads;
  for (std::string& file : files) threads.emplace_back([&] { file = pdfOf(drawing); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& file : files) EXPECT_EQ(file, pdfOf(drawing));
}

TEST(Pdf, LinesAndLabelsAreSmall) {
  Drawing drawing{{4000, 3000}, 300.0, "", {{"contours", {}}, {"labels", {}}}};
  for (int i = 0; i < 100; ++i) drawing.layers[0].items.push_back(stroked({wave(i)}, Pen{}));
  for (int i = 0; i < 40; ++i)
    drawing.layers[1].items.push_back(
        Words{"Musculus longus", {50, 60.0 * i}, 40.0, Font::Sans, kBlack, 1.0, Pen{kWhite, 9.0}});
  EXPECT_LT(pdfOf(drawing).size(), 2'000'000u);
}

class PdfPrograms : public Programs {
 protected:
  void SetUp() override {
    if (!has("pdftocairo")) GTEST_SKIP() << "pdftocairo is not there: install Debian's poppler-utils";
    writePdf(plate(), mFolder / "plate.pdf");
  }
  /// The document as qpdf prints it, unpacked.
  std::string unpacked() const { return run("qpdf --qdf --object-streams=disable plate.pdf -"); }
};

TEST_F(PdfPrograms, PopplerDrawsWhatIsPainted) {
  run("pdftocairo -png -singlefile -r 300 plate.pdf plate");
  Drawing drawing = plate();
  Image image = plainImage(400, 300);
  paint(drawing.layers, image);
  Difference difference = differenceOf(readPng("plate.png"), image);
  EXPECT_LT(difference.mean, 0.6 / 255.0);
  EXPECT_LT(difference.far, 0.006) << "it puts letters on whole pixels";
  // At four times the size letters stand where they should. A plate is enlarged in another way there.
  drawing.layers.erase(drawing.layers.begin());
  writePdf(drawing, mFolder / "lines.pdf");
  run("pdftocairo -png -singlefile -r 1200 lines.pdf lines");
  image = plainImage(1600, 1200);
  paint(drawing.layers, image, 4.0);
  difference = differenceOf(readPng("lines.png"), image);
  EXPECT_LT(difference.mean, 0.2 / 255.0);
  EXPECT_LT(difference.far, 0.002);
}

TEST_F(PdfPrograms, APlateKeepsItsPixelsAndItsAlpha) {
  Image noise = plainImage(64, 48, kBlack, 1.0f);
  unsigned random = 11;
  for (float& sample : noise.pixels) sample = float((random = random * 1664525u + 1013904223u) >> 24) / 255.0f;
  Item placed = Plate{noise, {5, 8}, {64, 48}};
  writePdf({{90, 80}, 72.0, "", {{"a", {placed}}}}, mFolder / "noise.pdf");
  run("pdfimages -png noise.pdf noise");
  Image color = readPng("noise-000.png"), alpha = readPng("noise-001.png");
  ASSERT_EQ(color.width, 64);
  ASSERT_EQ(alpha.width, 64);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(sampleOf(color, x, y, c), sampleOf(noise, x, y, c), 1e-6);
      ASSERT_NEAR(sampleOf(alpha, x, y, 0), sampleOf(noise, x, y, 3), 1e-6);
    }
  run("pdftocairo -png -singlefile -r 72 noise.pdf drawn");
  Image image = plainImage(90, 80);
  paint(std::vector<Item>{placed}, image);
  EXPECT_LT(differenceOf(readPng("drawn.png"), image).mean, 1.0 / 255.0);
}

TEST_F(PdfPrograms, TextIsFoundOnce) {
  std::string text = run("pdftotext -layout plate.pdf -");
  for (const char* words : {"Pulmo sinister", "Hepar", "\u00b5m, \u2192 AVA", "Bold 3.5"}) {
    std::size_t at = text.find(words);
    ASSERT_NE(at, std::string::npos) << words << " in:\n" << text;
    EXPECT_EQ(text.find(words, at + 1), std::string::npos) << "the halo is no text";
  }
}

TEST_F(PdfPrograms, WordsStandWhereTheirLettersSay) {
  std::string boxes = run("pdftotext -bbox plate.pdf -");
  std::size_t word = boxes.find(">Hepar<");
  ASSERT_NE(word, std::string::npos) << boxes;
  auto number = [&](const char* name) {
    return std::atof(boxes.c_str() + boxes.rfind(name, word) + std::string(name).size());
  };
  double start = 300.0 * 0.24, width = Letters(Font::SerifBold, 18.0).width("Hepar") * 0.24;
  EXPECT_NEAR(number("xMin=\""), start, 0.02);
  EXPECT_NEAR(number("xMax=\""), start + width, 0.05);
}

TEST_F(PdfPrograms, FontsAreInTheFileAndOnlyWhatIsUsed) {
  std::string fonts = run("pdffonts plate.pdf");
  for (const char* name : {"LiberationSans", "LiberationSans-Bold", "LiberationSerif", "LiberationSerif-Bold"}) {
    std::size_t at = fonts.find(std::string("+") + name + " ");
    ASSERT_NE(at, std::string::npos) << name << "\n" << fonts;
    std::string line = fonts.substr(at, fonts.find('\n', at) - at);
    EXPECT_NE(line.find("yes yes yes"), std::string::npos) << "embedded, subset, to Unicode: " << line;
  }
}

TEST_F(PdfPrograms, PageAndTitleAreThoseOfTheDrawing) {
  std::string facts = run("pdfinfo plate.pdf");
  EXPECT_NE(facts.find("Page size:       96 x 72 pts"), std::string::npos) << facts;
  EXPECT_NE(facts.find("Title:           Thorax & abdomen"), std::string::npos) << facts;
  EXPECT_NE(facts.find("Pages:           1"), std::string::npos) << facts;
}

TEST_F(PdfPrograms, LayersAreSwitchedByTheirNames) {
  if (!has("qpdf")) GTEST_SKIP() << "qpdf is not there: install Debian's qpdf";
  EXPECT_NE(run("qpdf --check plate.pdf").find("No syntax or stream encoding errors"), std::string::npos);
  std::string text = unpacked();
  std::size_t at = 0;
  for (const char* name : {"picture", "contours", "leaders", "labels", "legend"}) {
    at = text.find(std::string("/Name (") + name + ")", at);
    ASSERT_NE(at, std::string::npos) << name;
  }
  // With the labels off poppler draws what is painted without them.
  at = text.find("/ON [");
  ASSERT_NE(at, std::string::npos);
  std::string list = text.substr(at + 5, text.find(']', at) - at - 5), labels;
  std::size_t begin = 0, end = 0;
  for (int i = 0; i < 4; ++i) begin = end, end = list.find('R', begin) + 1;
  labels = list.substr(begin, end - begin);
  text.insert(at, "/OFF [" + labels + "] ");
  std::ofstream(mFolder / "off.qdf", std::ios::binary) << text;
  run("sh -c 'fix-qdf off.qdf > off.pdf'");
  run("pdftocairo -png -singlefile -r 300 off.pdf off");
  Drawing drawing = plate();
  drawing.layers.erase(drawing.layers.begin() + 3);
  Image image = plainImage(400, 300);
  paint(drawing.layers, image);
  EXPECT_LT(differenceOf(readPng("off.png"), image).far, 0.001);
}

TEST_F(PdfPrograms, GroupsAreListedWithinTheirLayerAndHiddenLayersAreOff) {
  if (!has("qpdf")) GTEST_SKIP() << "qpdf is not there: install Debian's qpdf";
  auto inGroup = [](const char* group, double x) {
    Shape shape = filled({circle({x, 50}, 20)});
    shape.group = group;
    return shape;
  };
  Drawing drawing{{400, 100},
                  72.0,
                  "",
                  {{"lines", {inGroup("inner", 50), inGroup("inner", 100), inGroup("outer", 150)}},
                   {"off", {inGroup("", 300)}, true}}};
  writePdf(drawing, mFolder / "plate.pdf");
  EXPECT_NE(run("qpdf --check plate.pdf").find("No syntax or stream encoding errors"), std::string::npos);
  std::string text = unpacked();
  for (const char* name : {"lines", "inner", "outer", "off"})
    EXPECT_NE(text.find(std::string("/Name (") + name + ")"), std::string::npos) << name;
  EXPECT_EQ(text.find("/Name (inner)", text.find("/Name (inner)") + 1), std::string::npos) << "once";
  EXPECT_NE(text.find("/OFF ["), std::string::npos);
  run("pdftocairo -png -singlefile -r 72 plate.pdf drawn");
  Image image = plainImage(400, 100);
  paint(drawing.layers, image);
  EXPECT_NEAR(coverOf(image), 3 * 3.1416 * 400, 20.0) << "a hidden layer is not painted";
  EXPECT_LT(differenceOf(readPng("drawn.png"), image).far, 0.001) << "nor drawn";
}

TEST_F(PdfPrograms, AnyTextIsAFile) {
  Shape shape = filled({circle({5, 5}, 2)});
  shape.name = kHostileText;
  Drawing drawing{{400, 30}, 72.0, kHostileText, {{kHostileText, {shape, Words{kHostileText, {2, 15}}}}, {"", {}}}};
  writePdf(drawing, mFolder / "hostile.pdf");
  std::string text = run("pdftotext hostile.pdf -");
  EXPECT_NE(text.find("<\"&'>]]>-->"), std::string::npos) << text;
  EXPECT_NE(text.find("\u6f22\U0001f600"), std::string::npos)
      << "boxes are drawn, and their letters are found: " << text;
  if (has("qpdf")) {
    EXPECT_NE(run("qpdf --check hostile.pdf").find("No syntax"), std::string::npos);
  }
  writePdf({{10, 10}, 72.0, "", {{"a", undrawable()}}}, mFolder / "none.pdf");
  EXPECT_NE(run("pdftocairo -png -singlefile none.pdf none && echo fine").find("fine"), std::string::npos);
  EXPECT_EQ(outputOf("cat " + (mFolder / "err.txt").string()), "");
  writePdf({{10, 10}, 72.0, "", {}}, mFolder / "empty.pdf");
  EXPECT_NE(run("pdfinfo empty.pdf").find("10 x 10 pts"), std::string::npos);
}

}  // namespace
}  // namespace velum::vector
