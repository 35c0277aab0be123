#include "gui/window/ReadyFilmDialog.h"

#include <fmt/format.h>

#include <QCoreApplication>

#include "gui/kit/CoreWords.h"
#include "gui/kit/CutTitle.h"
#include "gui/kit/Widgets.h"
#include "gui/kit/Words.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

using session::ReadyFilm;

/// By ReadyFilm.
struct ReadyText {
  const char *title, *tip;
};
constexpr ReadyText kReadyTexts[] = {
    {QT_TRANSLATE_NOOP("Words", "&Turntable"), QT_TRANSLATE_NOOP("Words", "The eye goes round the data")},
    {QT_TRANSLATE_NOOP("Words", "&Cuts come in"), QT_TRANSLATE_NOOP("Words", "Cuts come in from where the data ends")},
    {QT_TRANSLATE_NOOP("Words", "&Membranes sink in"), QT_TRANSLATE_NOOP("Words", "Membranes sink into the data")},
    {QT_TRANSLATE_NOOP("Words", "&Pull out"),
     QT_TRANSLATE_NOOP("Words", "Structures come out of the cuts one after the other")},
    {QT_TRANSLATE_NOOP("Words", "&Equalize"),
     QT_TRANSLATE_NOOP("Words", "A model from whole, over all that its cuts can take, to what they leave")},
    {QT_TRANSLATE_NOOP("Words", "&Fly to a structure"), QT_TRANSLATE_NOOP("Words", "The eye goes to a structure")},
    {QT_TRANSLATE_NOOP("Words", "Time &steps"), QT_TRANSLATE_NOOP("Words", "The volume goes through its time steps")},
    {QT_TRANSLATE_NOOP("Words", "&Before and after"), QT_TRANSLATE_NOOP("Words", "Whole, then cut open")},
    {QT_TRANSLATE_NOOP("Words", "T&itle"), QT_TRANSLATE_NOOP("Words", "Words over the picture come and go")}};
static_assert(std::size(kReadyTexts) == std::size(EnumNames<ReadyFilm>::kNames));

const session::Command& commandOf(ReadyFilm film) {
  return session::findCommand("film." + std::string(enumName(film)));
}

bool comesIn(const scene::Cut& cut, ReadyFilm film) {
  return cut.enabled && cut.shape != scene::CutShape::Everywhere &&
         (film != ReadyFilm::Membrane || scene::isMembrane(cut));
}

}  // namespace

QString readyFilmTitle(ReadyFilm film) { return wordsOf(kReadyTexts[std::size_t(film)].title); }

QString readyFilmTip(ReadyFilm film) { return wordsOf(kReadyTexts[std::size_t(film)].tip); }

ReadyFilmDialog::ReadyFilmDialog(const scene::Scene& scene, ReadyFilm film, double start, QWidget* parent)
    : FilmDialog(readyFilmTitle(film).remove('&'), 138, parent), mScene(scene), mSaid(new QLabel(this)) {
  mForm = new ArgumentForm(commandOf(film), extraOf(film, start), this);
  mSaid->setWordWrap(true);
  mSaid->setObjectName("readyFilmSaid");
  mColumn->addWidget(mForm);
  mColumn->addStretch(1);
  mColumn->addWidget(mSaid);
  addButtons(
      {tr("Add"), "addFilm", tr("Write its keys into the film of the scene, where they can be changed")},
      {tr("Save as film..."), "addAndSaveFilm", tr("Add it, and go on to save the film of the scene as a video")});
  connect(mOther, &QPushButton::clicked, this, [this] {
    mSavesFilm = true;
    accept();
  });
  connect(mForm, &ArgumentForm::changed, this, &ReadyFilmDialog::showFilm);
  showFilm();
}

ArgumentForm::Extra ReadyFilmDialog::extraOf(ReadyFilm film, double start) const {
  ArgumentForm::Extra extra;
  extra.beginning["start"] = fmt::format("{}", start);
  if (film == ReadyFilm::Title) extra.beginning["text"] = tr("\"Title\"").toStdString();
  if (film == ReadyFilm::Cut || film == ReadyFilm::Membrane) {
    auto& cuts = extra.choices["cut"];
    cuts.emplace_back(tr("All that are on"), "");
    for (std::size_t i = 0; i < mScene.cuts.size(); ++i)
      if (comesIn(mScene.cuts[i], film))
        cuts.emplace_back(cutTitle(mScene.cuts[i], int(i)), fmt::format("#{}", mScene.cuts[i].id));
  }
  if (film == ReadyFilm::Fly)
    for (const scene::Structure& structure : mScene.labels.structures)
      extra.choices["structure"].emplace_back(QString::fromStdString(session::structureName(mScene, structure.id)),
                                              fmt::format("#{}", structure.id));
  return extra;
}

void ReadyFilmDialog::showFilm() {
  try {
    FilmPreview::Asked asked;
    asked.film = [scene = mScene, call = call()](Progress& progress) {
      return session::editOf(scene, call, progress).after;
    };
    asked.span = session::FilmSpan{mForm->number("start"), mForm->number("seconds")};
    mPreview->show(std::move(asked));
    tell({});
  } catch (const std::exception& error) {
    tell(inWords(error.what()));
  }
}

void ReadyFilmDialog::tell(const QString& why) {
  double end = mForm->number("start") + mForm->number("seconds");
  QString text = why.isEmpty() ? tr("Its keys stand from %L1 s to %L2 s of the film; undo takes them back.")
                                     .arg(mForm->number("start"), 0, 'f', 1)
                                     .arg(end, 0, 'f', 1)
                               : why;
  sayIn(*mSaid, text, !why.isEmpty());
  for (QPushButton* button : {mMain, mOther}) button->setEnabled(why.isEmpty());
}

}  // namespace velum::gui
