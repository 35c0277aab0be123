#include "gui/window/ReadyFilmDialog.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QVBoxLayout>

#include "gui/kit/CutTitle.h"
#include "gui/kit/Widgets.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

using session::ReadyFilm;

/// By ReadyFilm.
struct ReadyText {
  const char *title, *tip;
};
constexpr ReadyText kReadyTexts[] = {
    {"&Turntable", "The eye goes round the data"},
    {"&Cuts come in", "Cuts come in from where the data ends"},
    {"&Membranes sink in", "Membranes sink into the data"},
    {"&Pull out", "Structures come out of the cuts one after the other"},
    {"&Equalize", "A model from whole, over all that its cuts can take, to what they leave"},
    {"&Fly to a structure", "The eye goes to a structure"},
    {"Time &steps", "The volume goes through its time steps"},
    {"&Before and after", "Whole, then cut open"},
    {"T&itle", "Words over the picture come and go"}};
static_assert(std::size(kReadyTexts) == std::size(EnumNames<ReadyFilm>::kNames));

const session::Command& commandOf(ReadyFilm film) {
  return session::findCommand("film." + std::string(enumName(film)));
}

bool comesIn(const scene::Cut& cut, ReadyFilm film) {
  return cut.enabled && cut.shape != scene::CutShape::Everywhere &&
         (film != ReadyFilm::Membrane || scene::isMembrane(cut));
}

}  // namespace

QString readyFilmTitle(ReadyFilm film) {
  return QCoreApplication::translate("ReadyFilm", kReadyTexts[std::size_t(film)].title);
}

QString readyFilmTip(ReadyFilm film) {
  return QCoreApplication::translate("ReadyFilm", kReadyTexts[std::size_t(film)].tip);
}

ReadyFilmDialog::ReadyFilmDialog(const scene::Scene& scene, ReadyFilm film, double start, QWidget* parent)
    : QDialog(parent), mScene(scene), mPreview(new FilmPreview(138, this)), mSaid(new QLabel(this)) {
  setWindowTitle(readyFilmTitle(film).remove('&'));
  mForm = new ArgumentForm(commandOf(film), extraOf(film, start), this);
  mSaid->setWordWrap(true);
  mSaid->setObjectName("readyFilmSaid");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(14);
  layout->addWidget(mPreview);
  layout->addWidget(mForm);
  layout->addStretch(1);
  layout->addWidget(mSaid);
  addButtons(layout);
  connect(mForm, &ArgumentForm::changed, this, &ReadyFilmDialog::showFilm);
  connect(mPreview, &FilmPreview::told, this, &ReadyFilmDialog::tell);
  showFilm();
}

ArgumentForm::Extra ReadyFilmDialog::extraOf(ReadyFilm film, double start) const {
  ArgumentForm::Extra extra;
  extra.beginning["start"] = fmt::format("{}", start);
  if (film == ReadyFilm::Title) extra.beginning["text"] = "\"Title\"";
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

void ReadyFilmDialog::addButtons(QLayout* layout) {
  auto* buttons = new QDialogButtonBox(this);
  mAdd = new QPushButton(tr("Add"), buttons);
  mAdd->setProperty("role", "main");  // before the box shows it: the style is chosen then
  mAdd->setObjectName("addFilm");
  mAdd->setToolTip(tr("Write its keys into the film of the scene, where they can be changed"));
  buttons->addButton(mAdd, QDialogButtonBox::AcceptRole);
  mAdd->setDefault(true);
  mSave = buttons->addButton(tr("Save as film..."), QDialogButtonBox::ActionRole);
  mSave->setObjectName("addAndSaveFilm");
  mSave->setToolTip(tr("Add it, and go on to save the film of the scene as a video"));
  buttons->addButton(QDialogButtonBox::Cancel);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(mSave, &QPushButton::clicked, this, [this] {
    mSavesFilm = true;
    accept();
  });
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
    tell(QString::fromUtf8(error.what()));
  }
}

void ReadyFilmDialog::tell(const QString& why) {
  double end = mForm->number("start") + mForm->number("seconds");
  QString text = why.isEmpty() ? tr("Its keys stand from %1 s to %2 s of the film; undo takes them back.")
                                     .arg(mForm->number("start"), 0, 'f', 1)
                                     .arg(end, 0, 'f', 1)
                               : why;
  sayIn(*mSaid, text, !why.isEmpty());
  for (QPushButton* button : {mAdd, mSave}) button->setEnabled(why.isEmpty());
}

}  // namespace velum::gui
