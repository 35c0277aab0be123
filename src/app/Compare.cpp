#include <fmt/format.h>

#include "app/Verbs.h"
#include "core/Error.h"
#include "io/images/ImageCompare.h"
#include "io/images/ImageFile.h"

namespace velum::app {

namespace {

struct CompareOptions {
  Common common;
  std::string a, b, diff;
  double maxDiff = 5.0, maxFraction = 0.001;
};

int run(const CompareOptions& options) {
  expectOutput(options.diff, io::expectImageFormat);
  Image a = io::readImage(options.a), b = io::readImage(options.b);
  io::ImageDifference difference = io::compareImages(a, b, options.maxDiff);
  if (!options.diff.empty()) io::writeImage(io::differenceImage(a, b, options.maxDiff), options.diff);
  bool ok = difference.failingFraction <= options.maxFraction;
  if (options.common.json)
    printJson({{"maxDiff", difference.maxDifference},
               {"failingFraction", difference.failingFraction},
               {"rms", difference.rms},
               {"equal", ok}});
  else
    fmt::print("largest difference {:.1f} of 255, {:.4f} % of pixels over {:.1f}, rms {:.3f}: {}\n",
               difference.maxDifference, difference.failingFraction * 100.0, options.maxDiff, difference.rms,
               ok ? "equal" : "different");
  return ok ? 0 : static_cast<int>(ExitCode::CompareFailed);
}

}  // namespace

Run registerCompare(CLI::App& verb) {
  auto options = std::make_shared<CompareOptions>();
  addCommon(verb, options->common);
  verb.add_option("a", options->a, "picture")->required();
  verb.add_option("b", options->b, "picture")->required();
  verb.add_option("--diff", options->diff, "write where they differ as a picture");
  verb.add_option("--max-diff", options->maxDiff, "difference of a channel that counts as failing, 0 to 255")
      ->check(CLI::Range(0.0, 255.0))
      ->capture_default_str();
  verb.add_option("--max-fraction", options->maxFraction, "share of failing pixels that is still equal, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  return [options] { return run(*options); };
}

}  // namespace velum::app
