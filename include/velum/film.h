#pragma once
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/film/JoinFrames.h"
#include "session/film/MakeFilm.h"
#include "session/film/ReadyFilms.h"
#include "session/film/Retarget.h"
#include "velum/picture.h"
#include "velum/progress.h"
#include "velum/scene.h"

/// Timeline, a member of Scene: which fields change in a film, and when. sceneAt(): the scene at a time. setKey() and
/// addReadyFilm() write films. Session::film() draws the film of a scene and writes it, as FilmOutput says, and tells
/// by a Progress how far it is; makeFilm() does so with frames that a program draws itself. retargeted(): the same
/// film of other data.
namespace velum {

using scene::Ease;
using scene::FilmFrames;
using scene::framesOf;
using scene::Key;
using scene::removeKeys;
using scene::sceneAt;
using scene::setKey;
using scene::stablePath;
using scene::Timeline;
using scene::Track;
using scene::tracksThatDoNotFit;
using scene::valueAt;
using session::addReadyFilm;
using session::expectFilmOutput;
using session::failedFrames;
using session::FilmFrame;
using session::filmIdentity;
using session::FilmOutput;
using session::FilmReport;
using session::FilmSpan;
using session::FrameSource;
using session::joinFrames;
using session::makeFilm;
using session::namesInFolder;
using session::NewData;
using session::Part;
using session::ReadyFilm;
using session::retargeted;
using session::whyNoFilm;

}  // namespace velum
