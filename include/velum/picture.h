#pragma once
#include "core/Image.h"
#include "io/images/ImageFile.h"
#include "session/picture/Picture.h"

/// Image: a picture. PictureOptions: how a picture is to be drawn. Also reads and writes files of pictures, which hold
/// their scene.
namespace velum {

using io::readImage;
using io::writeImage;
using session::PictureOptions;
using session::savePicture;

}  // namespace velum
