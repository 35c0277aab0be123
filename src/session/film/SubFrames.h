#pragma once
#include <vector>

#include "core/Image.h"

namespace velum::session {

/// The moment of one of the pictures of which a blurred frame is the mean, as a share of the time from frame to frame,
/// from the frame's own moment: -0.5..0.5. The shutter is open around that moment, so that what moves is blurred about
/// the place where it would be sharp; a single picture is the frame's own.
/// @param shutter  how much of the time between frames it is open, 0..1
double subFrameShare(int subFrame, int subFrames, double shutter);

/// The picture from which a blurred frame has what is no colour, as ids and depths have no mean: the one at the frame's
/// own moment, or, of an even number, the next one.
inline int middleSubFrame(int subFrames) { return subFrames / 2; }

/// The mean of pictures of one size. Colours, of layers too, are averaged as the renderer averages its samples: in
/// display values, multiplied by alpha. Other channels are those of the picture that is said to be the middle. A single
/// picture is itself.
class MeanImage {
 public:
  void add(const Image& image, bool isMiddle);
  /// To be called once, after all pictures.
  Image mean();

 private:
  Image mMiddle;
  std::vector<float> mSum;  ///< as Image::pixels, colours multiplied by alpha
  int mCount = 0;
};

}  // namespace velum::session
