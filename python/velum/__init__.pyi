# Made by python/tests/make_stub.py.
import os
from typing import Any, Callable, Iterator, Literal, Mapping, Optional, Sequence, Union

import numpy

__version__: str


class SceneCommands:
    """The commands scene.*"""
    def carry(self, volume: str = '', labels: str = '', structure: str = '') -> None:
        """Takes the scene and its film over to other data, such as another patient."""

class ViewCommands:
    """The commands view.*"""
    def from_(self, side: Literal['anterior', 'posterior', 'left', 'right', 'superior', 'inferior', 'oblique'] = 'anterior', aspect: float = 1.7777777777777777) -> None:
        """Looks at all that is seen from one side."""
    def first(self, aspect: float = 1.7777777777777777) -> None:
        """Looks at all that is seen as when data is opened."""
    def crosshair(self, place: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Puts the crosshair in a place."""
    def layout(self, layout: Literal['four-up', 'volume', 'volume-and-section', 'section'] = 'four-up') -> None:
        """Chooses which views there are."""

class CutCommands:
    """The commands cut.*"""
    def add(self, shape: Literal['plane', 'box', 'sphere', 'cylinder', 'cone', 'membrane', 'everywhere'] = 'plane', name: str = '') -> None:
        """Adds a cut where it is of use at once."""
    def alongView(self) -> None:
        """Adds a plane through the middle that faces the eye."""
    def remove(self, cut: str = '') -> None:
        """Removes a cut."""
    def duplicate(self, cut: str = '') -> None:
        """Adds a copy of a cut, right behind it."""
    def place(self, centre: Sequence[float] = (0.0, 0.0, 0.0), axis: Sequence[float] = (0.0, -1.0, 0.0), size: Sequence[float] = (100.0, 100.0, 100.0), spinDeg: float = 0.0, cut: str = '') -> None:
        """Puts a cut elsewhere, with what was pulled out of it."""
    def flip(self, cut: str = '') -> None:
        """Lets a cut take away the other side."""
    def enable(self, cut: str = '', enabled: bool = True) -> None:
        """Turns a cut on or off."""
    def rename(self, cut: str = '', name: str = '') -> None:
        """Gives a cut another name."""
    def moveInList(self, cut: str = '', by: int = 1) -> None:
        """Moves a cut up or down in the list."""
    def __call__(self, *arguments: Any, **fields: Any) -> None:
        """Adds a cut where it is of use at once."""

class MembraneCommands:
    """The commands membrane.*"""
    def hang(self, values: Union[float, Sequence[float]] = [], place: Union[float, Sequence[float]] = [], structures: Union[int, Sequence[int]] = [], types: Union[str, Sequence[str]] = [], sketch: Union[str, Sequence[str]] = [], avoid: Union[str, Sequence[str]] = [], axis: Union[float, Sequence[float]] = [], position: float = -1.0, reach: float = 0.0, leastPiece: str = '', denoise: bool = False) -> None:
        """Adds a membrane that protects what is said, as far as it can."""
    def protectValues(self, low: float = 0.0, high: float = 0.0, strength: float = 100.0, cut: str = '') -> None:
        """Lets a membrane's sheet go around all values of a range."""
    def protectAt(self, place: Sequence[float] = (0.0, 0.0, 0.0), strength: float = 100.0, cut: str = '') -> None:
        """Lets the sheet go around material like that in a place: what a click does."""
    def kernel(self, centre: Sequence[float] = (0.0, 0.0, 0.0), radius: float = 0.0, strength: float = 500.0, cut: str = '') -> None:
        """Puts a ball in that pushes the sheet away or draws it."""
    def pin(self, place: Sequence[float] = (0.0, 0.0, 0.0), cut: str = '') -> None:
        """Holds the sheet in a place."""
    def rule(self, rule: Literal['sided', 'paper'] = 'sided', cut: str = '') -> None:
        """Chooses how kernels push, with the cloth that goes with it."""
    def moveToKeep(self, keepsReach: bool = False, cut: str = '') -> None:
        """Moves a membrane along its axis to where it keeps what it protects."""

class ExtrusionCommands:
    """The commands extrusion.*"""
    def pull(self, structure: str = '', distance: float = 0.0, cut: str = '') -> None:
        """Pulls a structure out of a cut."""
    def putBack(self, structures: Union[str, Sequence[str]] = [], cut: str = '') -> None:
        """Puts back what stands out."""
    def putAllBack(self) -> None:
        """Puts back all that stands out."""
    def addPlane(self, cut: str = '') -> None:
        """Adds a second plane across one, so that the two open a wedge."""

class GrowthCommands:
    """The commands growth.*"""
    def grow(self, seed: Union[Sequence[float], Sequence[Sequence[float]]] = [], range: Union[float, Sequence[float]] = [], strokes: Union[str, Sequence[str]] = [], others: Union[Sequence[float], Sequence[Sequence[float]]] = [], otherStrokes: Union[str, Sequence[str]] = [], plane: Union[float, Sequence[float]] = [], distance: Optional[float] = None, steepest: Optional[float] = None, closing: float = 0.0, within: int = 0, fillHoles: bool = False, guard: bool = False, name: str = '') -> None:
        """Grows a structure out of the volume, from places on it."""
    def pullAt(self, place: Sequence[float] = (0.0, 0.0, 0.0), distance: float = 0.0, cut: str = '') -> None:
        """Pulls out of a cut what is in a place of its face; what has no label grows from there."""
    def addSeed(self, structure: str = '', place: Sequence[float] = (0.0, 0.0, 0.0), more: Union[Sequence[float], Sequence[Sequence[float]]] = []) -> None:
        """Lets a structure that was grown go on from another place."""
    def notThis(self, structure: str = '', place: Sequence[float] = (0.0, 0.0, 0.0), more: Union[Sequence[float], Sequence[Sequence[float]]] = []) -> None:
        """Says of a place that it is not of a structure that was grown."""
    def growOn(self, structure: str = '') -> None:
        """Lets a structure that was held grow as far as it is pulled, and minds no leak of it any more."""
    def stop(self) -> None:
        """Ends what is growing: what has grown so far stays."""
    def barrier(self, structure: str = '', path: Union[Sequence[float], Sequence[Sequence[float]]] = [], radius: float = 3.0) -> None:
        """Draws a stroke that a structure does not grow through."""
    def change(self, structure: str = '', field: str = '', value: str = '') -> None:
        """Changes how a structure grows: it grows anew."""
    def forget(self, structure: str = '') -> None:
        """Forgets a structure that was grown."""

class StructureCommands:
    """The commands structure.*"""
    def show(self, structures: Union[str, Sequence[str]] = [], visible: bool = True) -> None:
        """Shows structures, or hides them."""
    def showLabels(self, visible: bool = True) -> None:
        """Shows the labels, or hides them."""
    def invert(self, structures: Union[str, Sequence[str]] = []) -> None:
        """Shows those that are hidden and hides those that are shown."""
    def solo(self, structure: str = '', shown: Union[str, Sequence[str]] = [], unlabelled: float = 1.0) -> None:
        """Shows a structure alone; where it is alone already, what was shown before."""
    def color(self, structures: Union[str, Sequence[str]] = [], color: Sequence[float] = (1.0, 1.0, 1.0)) -> None:
        """Gives structures a colour of their own."""
    def opacity(self, structures: Union[str, Sequence[str]] = [], opacity: float = 1.0) -> None:
        """Makes structures more or less opaque."""
    def showAs(self, structures: Union[str, Sequence[str]] = [], showAs: Literal['material', 'solid'] = 'material') -> None:
        """Shows structures as material or as solid surfaces."""
    def litSphere(self, structures: Union[str, Sequence[str]] = [], litSphere: str = '') -> None:
        """Gives structures a lit sphere of their own in a finished picture."""
    def smooth(self, structures: Union[str, Sequence[str]] = [], deviation: float = 0.0) -> None:
        """Smooths the shapes that structures have in their file."""
    def rename(self, structure: str = '', name: str = '') -> None:
        """Gives a structure another name."""
    def spare(self, structures: Union[str, Sequence[str]] = [], whole: bool = True, cut: str = '') -> None:
        """Lets a cut leave structures whole, or go through them again."""
    def protect(self, structures: Union[str, Sequence[str]] = [], strength: float = 0.0, cut: str = '') -> None:
        """Lets a membrane's sheet go around structures, or draws it to them."""
    def listInLegend(self, structures: Union[str, Sequence[str]] = [], listed: bool = True) -> None:
        """Lists structures in the legend, or takes them out of its list; with an empty list it names what is shown."""

class LookCommands:
    """The commands look.*"""
    def preset(self, name: str = '') -> None:
        """Gives the volume colours, opacity and light made for a kind of data."""
    def finish(self, name: str = '') -> None:
        """Gives the picture what an illustrator adds at the end."""
    def model(self, name: str = '') -> None:
        """Gives a model light, lines and colours that go together."""
    def window(self, window: str = '') -> None:
        """Sets the grey window of sections."""
    def showThis(self, place: Sequence[float] = (0.0, 0.0, 0.0), hidden: bool = False, added: bool = False) -> None:
        """Makes the material at a place seen, and all else a veil."""
    def channelAlone(self, channel: int = 0) -> None:
        """Shows one of the channels that are mixed alone, or all again."""
    def channelColor(self, channel: int = 0, color: Sequence[float] = (1.0, 1.0, 1.0)) -> None:
        """Gives a channel that is mixed a colour."""
    def litSphere(self, sphere: str = '') -> None:
        """Paints material as a picture of a lit sphere is painted."""
    def mode(self, mode: Literal['volume', 'mip', 'iso'] = 'volume') -> None:
        """Chooses how rays are cast."""
    def surface(self) -> None:
        """Makes a look that lets one see through one of surfaces."""
    def import_(self, path: Union[str, bytes, os.PathLike[Any]] = '') -> None:
        """Takes the transfer function of a file."""
    def background(self, top: Sequence[float] = (0.0, 0.0, 0.0), bottom: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Sets what is behind everything."""

class VolumeCommands:
    """The commands volume.*"""
    def hideTable(self, hidden: bool = True) -> None:
        """Leaves out what is not part of the largest body: a scanner's table, head rests, cables."""

class ModelCommands:
    """The commands model.*"""
    def show(self, types: Union[str, Sequence[str]] = [], visible: bool = True) -> None:
        """Shows types of a model, or hides them."""
    def showModel(self, visible: bool = True) -> None:
        """Shows the model, or hides it."""
    def bringToSize(self) -> None:
        """Enlarges the model, or makes it smaller, so that it is seen beside the other data, at their right."""
    def color(self, types: Union[str, Sequence[str]] = [], color: Sequence[float] = (1.0, 1.0, 1.0)) -> None:
        """Gives types a colour of their own."""
    def paletteColor(self, types: Union[str, Sequence[str]] = []) -> None:
        """Gives types the palette's colours again."""
    def reset(self, types: Union[str, Sequence[str]] = []) -> None:
        """Shows types as if nothing had been said of them."""
    def ghosts(self, types: Union[str, Sequence[str]] = [], ghosts: Literal['none', 'filled', 'contour'] = 'none', asModel: bool = False) -> None:
        """Says how instances of types show that cuts have removed."""
    def solo(self, types: Union[str, Sequence[str]] = [], shown: Union[str, Sequence[str]] = []) -> None:
        """Shows types alone; where they are alone already, what was shown before."""
    def protect(self, types: Union[str, Sequence[str]] = [], strength: float = 100.0, cut: str = '') -> None:
        """Lets a membrane's sheet go around types of a model, or draws it to them."""
    def target(self, type: str = '', visible: str = '', isAny: bool = False) -> None:
        """Says how many instances of a type or compartment are to be seen."""
    def meetTargets(self, size: str = '1280x960') -> None:
        """Lets cuts leave as many instances as are to be seen of all types that have such a number."""
    def letSee(self, type: str = '', visible: str = '', cuts: Union[str, Sequence[str]] = [], size: str = '1280x960') -> None:
        """Lets cuts leave so many instances of a type that a number of them is seen."""
    def setDrawn(self, type: str = '', drawn: str = '', cuts: Union[str, Sequence[str]] = []) -> None:
        """Lets cuts leave so many instances of a type or compartment; its number stays when that of its group is set."""
    def letFollow(self, types: Union[str, Sequence[str]] = []) -> None:
        """Forgets the numbers of types: they follow those of their group."""
    def leave(self, types: Union[str, Sequence[str]] = [], share: float = 1.0, cut: str = '') -> None:
        """Lets a cut leave a share of the instances of types."""
    def leaveBy(self, types: Union[str, Sequence[str]] = [], field: str = '', value: str = '', cut: str = '') -> None:
        """Sets how a cut leaves the instances of types."""
    def leaveAsAbove(self, types: Union[str, Sequence[str]] = [], cut: str = '') -> None:
        """Lets a cut leave of types what it leaves of the compartment that they are in."""
    def showUncut(self) -> None:
        """Turns all cuts off: no instance is removed."""
    def showUnthinned(self) -> None:
        """Gives up shares and falloffs: where an instance is decides whether it is drawn."""
    def keepInView(self, type: str = '', kept: bool = True) -> None:
        """Clears away what hides a type or compartment, or lets it be hidden again."""
    def rename(self, type: str = '', name: str = '') -> None:
        """Gives a type or compartment the name by which it is shown."""
    def listInLegend(self, types: Union[str, Sequence[str]] = [], listed: bool = True) -> None:
        """Lists types, and compartments as one entry each, in the legend, or takes them out of its list; with an empty list it names what is seen most."""

class CaptionCommands:
    """The commands caption.*"""
    def add(self, text: str = '', place: Literal['topLeft', 'top', 'topRight', 'left', 'centre', 'right', 'bottomLeft', 'bottom', 'bottomRight'] = 'bottom', size: float = 1.0) -> None:
        """Adds a caption over the picture, whose fields are set as any other: set lettering.captions[#1].opacity 0.5."""
    def remove(self, caption: str = '') -> None:
        """Removes a caption."""

class MarkCommands:
    """The commands mark.*"""
    def add(self, kind: Literal['distance', 'angle', 'path', 'area', 'arrow', 'label', 'name', 'circle', 'box', 'region', 'profile'] = 'label', points: Union[Sequence[float], Sequence[Sequence[float]]] = [], text: str = '', structure: str = '', type: str = '', alongSurface: bool = False, pointInstances: Union[int, Sequence[int]] = [], pointStructures: Union[str, Sequence[str]] = [], normal: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Adds a mark: a measure, an arrow, or words beside a place; its fields are set as any other: set lettering.marks[#1].wordsAt 0.1,0."""
    def remove(self, marks: Union[str, Sequence[str]] = []) -> None:
        """Removes marks."""
    def follow(self, marks: Union[str, Sequence[str]] = [], follow: bool = True) -> None:
        """Lets each point of marks follow what is there: the instance of the model that holds it, or the structure in which it lies, in its middle."""
    def duplicate(self, marks: Union[str, Sequence[str]] = []) -> None:
        """Adds a copy of each mark."""
    def show(self, marks: Union[str, Sequence[str]] = [], visible: bool = True) -> None:
        """Shows or hides marks."""
    def __call__(self, *arguments: Any, **fields: Any) -> None:
        """Adds a mark: a measure, an arrow, or words beside a place; its fields are set as any other: set lettering.marks[#1].wordsAt 0.1,0."""

class LetteringCommands:
    """The commands lettering.*"""
    def style(self, style: str = '') -> None:
        """Gives all lettering a style by name: typeface, sizes on the page, colour, halo."""

class FilmCommands:
    """The commands film.*"""
    def key(self, field: str = '', time: float = -1.0, value: str = '') -> None:
        """Makes a key of a field: what the field is at a time of the film."""
    def removeKey(self, field: str = '', time: float = -1.0) -> None:
        """Removes a key."""
    def ease(self, field: str = '', time: float = -1.0, ease: Literal['hold', 'linear', 'in', 'out', 'both', 'smooth'] = 'smooth') -> None:
        """Says how a field gets from a key to the next one."""
    def moveKey(self, field: str = '', time: float = 0.0, to: float = 0.0, copy: bool = False) -> None:
        """Moves a key to another time, or copies it."""
    def removeTrack(self, field: str = '') -> None:
        """Removes all keys of a field."""
    def clear(self) -> None:
        """Removes all keys."""
    def at(self, time: float = 0.0) -> None:
        """Shows the scene at a time of its film; changes nothing."""
    def record(self, on: bool = True) -> None:
        """Makes keys of whatever is changed at the playhead from now on."""
    def save(self, path: Union[str, bytes, os.PathLike[Any]] = '', size: str = '1280x720', animate: Union[str, Sequence[str]] = [], seconds: float = 0.0, section: str = '', samples: int = 0, transparent: bool = False, layers: bool = False, dpi: float = 0.0, bits: int = 8, quality: int = 75, blur: int = 1, shutter: float = 0.5, part: str = '1/1', resume: bool = False, overwrite: bool = False) -> None:
        """Draws the film of the scene, and writes it as a video or as frames."""
    def turn(self, seconds: float = 8.0, turns: float = 1.0, gently: bool = False, start: float = 0.0) -> None:
        """Ready-made film: the eye goes round."""
    def cut(self, seconds: float = 6.0, cut: str = '', back: bool = False, start: float = 0.0) -> None:
        """Ready-made film: cuts come in from where the data ends."""
    def membrane(self, seconds: float = 6.0, cut: str = '', back: bool = False, start: float = 0.0) -> None:
        """Ready-made film: membranes sink in."""
    def pull(self, seconds: float = 8.0, overlap: float = 0.2, hold: float = 0.1, start: float = 0.0) -> None:
        """Ready-made film: structures come out of the cuts one after the other."""
    def equalize(self, seconds: float = 10.0, hold: float = 0.2, start: float = 0.0) -> None:
        """Ready-made film: a model from whole, over all that its cuts can take, to what they leave."""
    def fly(self, structure: str = '', seconds: float = 5.0, fill: float = 0.9, start: float = 0.0) -> None:
        """Ready-made film: the eye goes to a structure."""
    def time(self, seconds: float = 5.0, rounds: float = 1.0, start: float = 0.0) -> None:
        """Ready-made film: the volume goes through its time steps."""
    def compare(self, seconds: float = 6.0, hold: float = 0.35, start: float = 0.0) -> None:
        """Ready-made film: whole, then cut open."""
    def title(self, text: str = '', start: float = 0.0, seconds: float = 4.0, fade: float = 0.5, place: Literal['topLeft', 'top', 'topRight', 'left', 'centre', 'right', 'bottomLeft', 'bottom', 'bottomRight'] = 'bottom') -> None:
        """Ready-made film: words come and go."""
    def __call__(self, path: Union[str, bytes, os.PathLike[Any]] = '', size: str = '1280x720', animate: Union[str, Sequence[str]] = [], seconds: float = 0.0, section: str = '', samples: int = 0, transparent: bool = False, layers: bool = False, dpi: float = 0.0, bits: int = 8, quality: int = 75, blur: int = 1, shutter: float = 0.5, part: str = '1/1', resume: bool = False, overwrite: bool = False) -> None:
        """Draws the film of the scene, and writes it as a video or as frames."""

def open(what: Any, *, context: Literal['auto', 'egl', 'osmesa'] = 'auto', progress: Optional[Callable[[float, str], Any]] = None, **how: Any) -> Session:
    """A session in which something is open."""

class Session:
    """What is open, and all that can be done to it: a method for each command of scripts, s[FIELD] for each field of the scene."""
    def __init__(self, context: Literal['auto', 'egl', 'osmesa'] = 'auto', *, progress: Optional[Callable[[float, str], Any]] = None) -> None: ...
    @property
    def progress(self) -> Optional[Callable[[float, str], Any]]:
        """What is called while the session works."""
    @progress.setter
    def progress(self, progress: Optional[Callable[[float, str], Any]]) -> None: ...
    def run(self, script: str) -> list[str]:
        """Does the lines of a script, and gives what they answer."""
    def __getitem__(self, path: str) -> Any:
        """The value of a field, or of a part with all of its fields: s["camera.eye"], s["cuts[0]"]."""
    def __setitem__(self, path: str, value: Any) -> None:
        """Sets a field, with all that follows from it: s["rayCast.mode"] = "mip"."""
    @property
    def voxels(self) -> Optional[Volume]:
        """The volume that is open."""
    @property
    def labels(self) -> Optional[Labels]:
        """The labels that are open, with what was grown."""
    @labels.setter
    def labels(self, labels: Any) -> None: ...
    def render(self, width: int = 1280, height: int = 720, *, samples: int = 0, transparent: bool = False, section: str = '', dtype: Literal['uint8', 'float32'] = 'uint8') -> Image:
        """A picture with everything at rest, [row, column, channel]: as uint8 what files of 8 bits hold, to the byte."""
    def frames(self, width: int = 1280, height: int = 720, *, animate: str | Sequence[str] = (), seconds: float = 0.0, samples: int = 0, transparent: bool = False, section: str = '', dtype: Literal['uint8', 'float32'] = 'uint8', blur: int = 1, shutter: float = 0.5) -> Iterator[Image]:
        """The frames of the film one after the other, each drawn when it is asked for, as render() gives it: what film(...) writes."""
    def layers(self, width: int = 1280, height: int = 720, *, samples: int = 0) -> dict[str, numpy.ndarray]:
        """A picture and all that lies under it, by name, float32, [row, column] or [row, column, channel]."""
    def measure(self, *, marks: bool = True, structures: bool = False, faces: bool = False) -> dict[str, Any]:
        """What marks measure, what cuts leave of structures, and the faces of cuts: the lists marks, structures and faces, as `velum-batch measure --json` writes them."""
    def count(self, width: int = 1280, height: int = 720) -> list[dict[str, Any]]:
        """What became of the instances of each type of a model, or, without a model, of the pixels of each structure, in a picture of that size: how many are visible, hidden, clipped, and how many there are in total."""
    def asPython(self) -> str:
        """All that was done since something was opened, as a program: run again it leads to the same scene, and the same bytes of a picture."""
    def cancel(self) -> None:
        """Stops the work that another thread waits for: there it raises Cancelled."""
    def close(self) -> None:
        """Stops all work and gives up what is open."""
    def __enter__(self) -> Session: ...
    def __exit__(self, *error: Any) -> None: ...
    @property
    def scene(self) -> SceneCommands: ...
    @property
    def view(self) -> ViewCommands: ...
    @property
    def cut(self) -> CutCommands: ...
    @property
    def membrane(self) -> MembraneCommands: ...
    @property
    def extrusion(self) -> ExtrusionCommands: ...
    @property
    def growth(self) -> GrowthCommands: ...
    @property
    def structure(self) -> StructureCommands: ...
    @property
    def look(self) -> LookCommands: ...
    @property
    def volume(self) -> VolumeCommands: ...
    @property
    def model(self) -> ModelCommands: ...
    @property
    def caption(self) -> CaptionCommands: ...
    @property
    def mark(self) -> MarkCommands: ...
    @property
    def lettering(self) -> LetteringCommands: ...
    @property
    def film(self) -> FilmCommands: ...
    def open(self, path: Union[str, bytes, os.PathLike[Any]] = '', series: str = '', level: int = -1, raw: Optional[Mapping[str, Any]] = None, spacing: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Opens a file or folder in the place of what is open."""
    def add(self, path: Union[str, bytes, os.PathLike[Any]] = '', series: str = '', asLabels: bool = False) -> None:
        """Adds labels, a surface or a model beside what is open."""
    def save(self, path: Union[str, bytes, os.PathLike[Any]] = '') -> None:
        """Writes the scene: what is open, and how it is shown."""
    def picture(self, size: str = '1280x720', path: Union[str, bytes, os.PathLike[Any]] = '', samples: int = 0, transparent: bool = False, layers: bool = False, dpi: float = 0.0, part: str = '') -> None:
        """Makes a picture of the scene, with the scene inside."""
    def set(self, path: Union[str, bytes, os.PathLike[Any]] = '', value: str = '') -> None:
        """Sets a field of the scene, with all that follows from it."""
    def get(self, path: Union[str, bytes, os.PathLike[Any]] = '') -> list[str]:
        """Tells what a field of the scene is, as set takes it."""
    def undo(self) -> None:
        """Takes the last change back."""
    def redo(self) -> None:
        """Does again what was taken back."""
    def settle(self) -> None:
        """Waits until sheets rest and all has grown."""
    def commands(self) -> list[str]:
        """Tells the commands that lead to what is open, a line each: a script."""
    def protect(self, values: Union[float, Sequence[float]] = [], place: Union[float, Sequence[float]] = [], structures: Union[int, Sequence[int]] = [], types: Union[str, Sequence[str]] = [], sketch: Union[str, Sequence[str]] = [], avoid: Union[str, Sequence[str]] = [], axis: Union[float, Sequence[float]] = [], position: float = -1.0, reach: float = 0.0, leastPiece: str = '', denoise: bool = False) -> None:
        """Adds a membrane that protects what is said, as far as it can."""
    def grow(self, seed: Union[Sequence[float], Sequence[Sequence[float]]] = [], range: Union[float, Sequence[float]] = [], strokes: Union[str, Sequence[str]] = [], others: Union[Sequence[float], Sequence[Sequence[float]]] = [], otherStrokes: Union[str, Sequence[str]] = [], plane: Union[float, Sequence[float]] = [], distance: Optional[float] = None, steepest: Optional[float] = None, closing: float = 0.0, within: int = 0, fillHoles: bool = False, guard: bool = False, name: str = '') -> None:
        """Grows a structure out of the volume, from places on it."""

class Volume:
    """Voxels, and where they are in the world."""
    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> numpy.ndarray: ...
    @property
    def array(self) -> numpy.ndarray:
        """The samples as they are, [z, y, x] and more where there are channels or time steps: no copy, not to be written to."""
    @property
    def affine(self) -> numpy.ndarray:
        """4 x 4, from voxels (x, y, z) to the world: DICOM's axes (x to the left, y to the back, z to the head), in `lengthUnit`."""
    @property
    def spacing(self) -> tuple[float, float, float]:
        """Of the voxels along x, y and z, in `lengthUnit`."""
    @property
    def origin(self) -> tuple[float, float, float]:
        """Where the first voxel's middle is: x, y, z."""
    @property
    def lengthUnit(self) -> str:
        """Of the world: angstrom where that was said, else mm."""
    @property
    def name(self) -> str:
        """For people."""
    def save(self, path: str | bytes | os.PathLike[Any]) -> list[str]:
        """Writes the voxels and where they are, in the format that the path's extension says."""
    def __init__(self, array: Any, *, spacing: Optional[Sequence[float]] = None, origin: Optional[Sequence[float]] = None, affine: Any = None, lengthUnit: str = 'mm', unit: str = '', modality: str = 'unknown', color: bool = False, name: str = 'array', timeStepSeconds: float = 0.0, copy: Optional[bool] = None) -> None: ...
    @property
    def unit(self) -> str:
        """Of the values, as HU."""
    @property
    def modality(self) -> str:
        """CT, MR, ..., or unknown."""
    @property
    def color(self) -> bool:
        """The channels are red, green, blue (and alpha)."""
    @property
    def scale(self) -> float:
        """See array."""
    @property
    def offset(self) -> float:
        """See array."""
    @property
    def range(self) -> tuple[float, float]:
        """Least and most of the values."""
    @property
    def timeStepSeconds(self) -> float:
        """From a time step to the next; 0 where it is not known."""

class Labels:
    """Whole numbers that say to which structure each voxel belongs; 0: to none."""
    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> numpy.ndarray: ...
    @property
    def array(self) -> numpy.ndarray:
        """A copy of the numbers, uint16, [z, y, x]."""
    @property
    def affine(self) -> numpy.ndarray:
        """4 x 4, from voxels (x, y, z) to the world: DICOM's axes (x to the left, y to the back, z to the head), in `lengthUnit`."""
    @property
    def spacing(self) -> tuple[float, float, float]:
        """Of the voxels along x, y and z, in `lengthUnit`."""
    @property
    def origin(self) -> tuple[float, float, float]:
        """Where the first voxel's middle is: x, y, z."""
    @property
    def lengthUnit(self) -> str:
        """Of the world: angstrom where that was said, else mm."""
    @property
    def name(self) -> str:
        """For people."""
    def save(self, path: str | bytes | os.PathLike[Any]) -> list[str]:
        """Writes the voxels and where they are, in the format that the path's extension says."""
    def __init__(self, array: Any, *, names: Optional[Mapping[int, str]] = None, colors: Optional[Mapping[int, Sequence[float]]] = None, spacing: Optional[Sequence[float]] = None, origin: Optional[Sequence[float]] = None, affine: Any = None, lengthUnit: str = 'mm', name: str = 'labels') -> None: ...
    @property
    def names(self) -> dict[int, str]:
        """Of the structures, by number."""
    @property
    def colors(self) -> dict[int, tuple[float, float, float]]:
        """Of the structures, by number; sRGB, 0 to 1."""

class Image(numpy.ndarray):
    """A picture: an array [row, column, channel] of red, green, blue (and alpha): whole numbers from 0 to 255, or floating ones from 0 to 1."""
    def __getitem__(self, key: Any) -> Any: ...

class Note(UserWarning):
    """What somebody should know about a command that was done, in one line."""

class Error(RuntimeError):
    """What the library refuses, in one line: what, which value, what to do."""

class ArgumentError(Error, ValueError):
    """An argument, a name or a field's value that cannot be used."""

class InputError(Error):
    """A file that cannot be read or written, or data that is not there."""

class GpuError(Error):
    """There is no graphics driver that will do."""

class Cancelled(Error):
    """Session.cancel() has stopped the work."""
