#pragma once
#include "core/Image.h"
#include "io/images/ImageFile.h"
#include "session/picture/Picture.h"

/// Image: a picture; how one is to be drawn; and the files they are in, with their scene inside.
namespace velum {

using io::readImage;
using io::writeImage;
using session::PictureOptions;
using session::savePicture;

}  // namespace velum
