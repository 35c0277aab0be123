<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>%1 structures</source>
        <translation>%1 Strukturen</translation>
    </message>
    <message>
        <source>%1 types</source>
        <translation>%1 Typen</translation>
    </message>
    <message>
        <source>%1 marks</source>
        <translation>%1 Marken</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Einzelbilder</translation>
    </message>
    <message>
        <source>: %1 by %2</source>
        <translation>: %1 durch %2</translation>
    </message>
    <message>
        <source>, %1 by %2</source>
        <translation>, %1 durch %2</translation>
    </message>
    <message>
        <source>brick</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>bricks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>tile</source>
        <translation>Kachel</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>quote</source>
        <translation>Anführungszeichen</translation>
    </message>
    <message>
        <source>bracket</source>
        <translation>Klammer</translation>
    </message>
    <message>
        <source>supported</source>
        <translation>unterstützt</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>Reading voxels</source>
        <translation>Voxel werden gelesen</translation>
    </message>
    <message>
        <source>a label volume needs at least one voxel along each axis</source>
        <translation>ein Labelvolumen braucht entlang jeder Achse mindestens ein Voxel</translation>
    </message>
    <message>
        <source>the box to write leaves the label volume</source>
        <translation>der zu schreibende Quader ragt aus dem Labelvolumen</translation>
    </message>
    <message>
        <source>too few labels for the box to write</source>
        <translation>zu wenige Labels für den zu schreibenden Quader</translation>
    </message>
    <message>
        <source>the box to read leaves the label volume</source>
        <translation>der zu lesende Quader ragt aus dem Labelvolumen</translation>
    </message>
    <message>
        <source>too little room for the box to read</source>
        <translation>zu wenig Platz für den zu lesenden Quader</translation>
    </message>
    <message>
        <source> (is &apos;%1&apos; meant?)</source>
        <translation> (ist „%1“ gemeint?)</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2); check the folder and the free space</source>
        <translation>%1: kann nicht geschrieben werden (%2); Ordner und freien Platz prüfen</translation>
    </message>
    <message>
        <source>%1: is a folder; give the name of a file</source>
        <translation>%1: ist ein Ordner; den Namen einer Datei angeben</translation>
    </message>
    <message>
        <source>%1: is no regular file; give the name of a file</source>
        <translation>%1: ist keine gewöhnliche Datei; den Namen einer Datei angeben</translation>
    </message>
    <message>
        <source>%1: is read-only; choose another name, or permit writing</source>
        <translation>%1: ist schreibgeschützt; einen anderen Namen wählen oder das Schreiben erlauben</translation>
    </message>
    <message>
        <source>%1: its folder does not exist; create it first</source>
        <translation>%1: der Ordner dafür fehlt; ihn zuerst anlegen</translation>
    </message>
    <message>
        <source>structure %1 is smoothed by nothing</source>
        <translation>Struktur %1 wird um nichts geglättet</translation>
    </message>
    <message>
        <source>Smoothing structures</source>
        <translation>Strukturen werden geglättet</translation>
    </message>
    <message>
        <source>the driver&apos;s shaders reach %1 MiB of a buffer, and %2 MiB are needed: take fewer copies, or a smaller picture or volume</source>
        <translation>die Shader des Treibers erreichen %1 MiB eines Puffers, nötig sind %2 MiB: weniger Kopien nehmen oder ein kleineres Bild oder Volumen</translation>
    </message>
    <message>
        <source>the driver cannot draw into %1</source>
        <translation>der Treiber kann nicht in %1 zeichnen</translation>
    </message>
    <message>
        <source>the shader %1 does not link: %2</source>
        <translation>der Shader %1 lässt sich nicht binden: %2</translation>
    </message>
    <message>
        <source>the driver does not answer: update it, or restart</source>
        <translation>der Treiber antwortet nicht: ihn aktualisieren oder neu starten</translation>
    </message>
    <message>
        <source>the shader %1/%2 is missing</source>
        <translation>der Shader %1/%2 fehlt</translation>
    </message>
    <message>
        <source>the shader %1 is not part of the program</source>
        <translation>der Shader %1 gehört nicht zum Programm</translation>
    </message>
    <message>
        <source>%1: %2 texels are more than the %3 that the driver takes in a buffer: use a smaller model, picture or volume</source>
        <translation>%1: %2 Texel sind mehr als die %3, die der Treiber in einem Puffer nimmt: ein kleineres Modell, Bild oder Volumen verwenden</translation>
    </message>
    <message>
        <source>no way to draw without a display: %1; %2</source>
        <translation>ohne Bildschirm lässt sich nicht zeichnen: %1; %2</translation>
    </message>
    <message>
        <source>EGL: libEGL.so.1 is not installed (Debian package libegl1)</source>
        <translation>EGL: libEGL.so.1 ist nicht installiert (Debian-Paket libegl1)</translation>
    </message>
    <message>
        <source>EGL: no display offers an OpenGL 4.5 core context (Debian package libgl1-mesa-dri has a software one)</source>
        <translation>EGL: kein Bildschirm bietet einen OpenGL-4.5-Core-Kontext (das Debian-Paket libgl1-mesa-dri hat einen in Software)</translation>
    </message>
    <message>
        <source>EGL: the context cannot be made current</source>
        <translation>EGL: der Kontext lässt sich nicht aktivieren</translation>
    </message>
    <message>
        <source>OSMesa: libOSMesa.so.8 is not installed (Debian package libosmesa6)</source>
        <translation>OSMesa: libOSMesa.so.8 ist nicht installiert (Debian-Paket libosmesa6)</translation>
    </message>
    <message>
        <source>OSMesa: it offers no OpenGL 4.5 core context</source>
        <translation>OSMesa: es bietet keinen OpenGL-4.5-Core-Kontext</translation>
    </message>
    <message>
        <source>OSMesa: the context cannot be made current</source>
        <translation>OSMesa: der Kontext lässt sich nicht aktivieren</translation>
    </message>
    <message>
        <source>the plane to grow from has a number that is not finite</source>
        <translation>die Ebene, von der aus gewachsen wird, hat eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>the distance to grow is not a number</source>
        <translation>der Abstand zum Wachsen ist keine Zahl</translation>
    </message>
    <message>
        <source>channel %1 to grow in: the volume has %2</source>
        <translation>Kanal %1 zum Wachsen: das Volumen hat %2</translation>
    </message>
    <message>
        <source>time step %1 to grow in: the volume has %2</source>
        <translation>Zeitschritt %1 zum Wachsen: das Volumen hat %2</translation>
    </message>
    <message>
        <source>structure %1 to grow: give a label from 1 to 65535</source>
        <translation>Struktur %1 zum Wachsen: ein Label von 1 bis 65535 angeben</translation>
    </message>
    <message>
        <source>structure %1 to grow within: give a label from 0 to 65535</source>
        <translation>Struktur %1, in der gewachsen wird: ein Label von 0 bis 65535 angeben</translation>
    </message>
    <message>
        <source>the labels have another grid than the volume: what grows made them take its grid, by the nearest voxel</source>
        <translation>die Labels haben ein anderes Gitter als das Volumen: durch das Wachsen haben sie nun dessen Gitter, nach dem nächsten Voxel</translation>
    </message>
    <message>
        <source>what grows reaches over a box of %1 x %2 x %3 voxels, and to tell it from what is not of it takes %4 GB of memory; grow it less far, or give it a narrower range</source>
        <translation>das Gewachsene reicht über einen Quader von %1 x %2 x %3 Voxeln; es von dem zu trennen, was nicht dazugehört, braucht %4 GB Speicher; weniger weit wachsen lassen oder einen engeren Bereich angeben</translation>
    </message>
    <message>
        <source>the labels to grow in are not on the grid of the volume</source>
        <translation>die Labels, in denen gewachsen wird, liegen nicht auf dem Gitter des Volumens</translation>
    </message>
    <message>
        <source>the structure reaches over a box of %1 x %2 x %3 voxels, and to close it or to fill its holes takes %4 GB of memory; leave that out, or grow it less far</source>
        <translation>die Struktur reicht über einen Quader von %1 x %2 x %3 Voxeln; sie zu schließen oder ihre Löcher zu füllen braucht %4 GB Speicher; das weglassen oder sie weniger weit wachsen lassen</translation>
    </message>
    <message>
        <source>cannot read or write %1: %2 was not found in %3</source>
        <translation>%1 nicht lesbar und nicht schreibbar: %2 wurde in %3 nicht gefunden</translation>
    </message>
    <message>
        <source>cannot read or write %1: %2</source>
        <translation>%1 nicht lesbar und nicht schreibbar: %2</translation>
    </message>
    <message>
        <source>packed pages of TIFF files</source>
        <translation>gepackte Seiten von TIFF-Dateien</translation>
    </message>
    <message>
        <source>surfaces and files of VTK</source>
        <translation>Oberflächen und Dateien von VTK</translation>
    </message>
    <message>
        <source>the pictures differ in size: %1 x %2 and %3 x %4</source>
        <translation>die Bilder sind verschieden groß: %1 x %2 und %3 x %4</translation>
    </message>
    <message>
        <source>the pictures have %1 and %2 channels</source>
        <translation>die Bilder haben %1 und %2 Kanäle</translation>
    </message>
    <message>
        <source>%1: cannot write a picture of %2 x %3 pixels with %4 channels and %5 samples</source>
        <translation>%1: ein Bild von %2 x %3 Pixeln mit %4 Kanälen und %5 Werten kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>%1: the picture has no channels R, G and B; write it as .exr</source>
        <translation>%1: das Bild hat keine Kanäle R, G und B; als .exr schreiben</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2)</source>
        <translation>%1: kann nicht geschrieben werden (%2)</translation>
    </message>
    <message>
        <source>-: the picture cannot be written to the standard output</source>
        <translation>-: das Bild kann nicht auf die Standardausgabe geschrieben werden</translation>
    </message>
    <message>
        <source>%1: there is no such picture</source>
        <translation>%1: dieses Bild gibt es nicht</translation>
    </message>
    <message>
        <source>%1: is cut short or damaged</source>
        <translation>%1: ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>%1: its header is damaged</source>
        <translation>%1: der Dateikopf ist beschädigt</translation>
    </message>
    <message>
        <source>%1: is no picture in PNG, TIFF or OpenEXR; convert it to one of these</source>
        <translation>%1: ist kein Bild in PNG, TIFF oder OpenEXR; es in eines davon umwandeln</translation>
    </message>
    <message>
        <source>%1: cannot be read as a picture (%2)</source>
        <translation>%1: kann nicht als Bild gelesen werden (%2)</translation>
    </message>
    <message>
        <source>%1: a picture of %2 x %3 x %4 is not read</source>
        <translation>%1: ein Bild von %2 x %3 x %4 wird nicht gelesen</translation>
    </message>
    <message>
        <source>%1: the header promises more pixels than the file can hold</source>
        <translation>%1: der Dateikopf verspricht mehr Pixel, als in ihr sein können</translation>
    </message>
    <message>
        <source>%1: the picture is cut short</source>
        <translation>%1: das Bild ist abgeschnitten</translation>
    </message>
    <message>
        <source>%1: this OpenImageIO cannot write %2</source>
        <translation>%1: dieses OpenImageIO kann %2 nicht schreiben</translation>
    </message>
    <message>
        <source>%1: this OpenImageIO keeps the scene out of it</source>
        <translation>%1: dieses OpenImageIO lässt die Szene weg</translation>
    </message>
    <message>
        <source>%1: the picture is damaged (%2)</source>
        <translation>%1: das Bild ist beschädigt (%2)</translation>
    </message>
    <message>
        <source>%1: pictures are written as .png, .tif or .exr, not &apos;%2&apos;</source>
        <translation>%1: Bilder werden als .png, .tif oder .exr geschrieben, nicht „%2“</translation>
    </message>
    <message>
        <source>the segmentation has no pixel data</source>
        <translation>die Segmentierung hat keine Pixel</translation>
    </message>
    <message>
        <source>compressed DICOM segmentations are not supported</source>
        <translation>komprimierte DICOM-Segmentierungen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>segmentations of %1 bits are not supported</source>
        <translation>Segmentierungen mit %1 Bit werden nicht unterstützt</translation>
    </message>
    <message>
        <source>the pixel data is cut off: %1 bytes of %2</source>
        <translation>die Pixel sind abgeschnitten: %1 Bytes von %2</translation>
    </message>
    <message>
        <source>frames of the segmentation lie in several directions; one is supported</source>
        <translation>die Einzelbilder der Segmentierung liegen in mehreren Richtungen; unterstützt wird eine</translation>
    </message>
    <message>
        <source>the places of its frames do not fit on a grid</source>
        <translation>die Orte der Einzelbilder passen auf kein Gitter</translation>
    </message>
    <message>
        <source>planes are not evenly apart; each was put on the nearest of %1 mm, by up to %2 mm</source>
        <translation>die Ebenen haben ungleiche Abstände; jede wurde auf die nächste von %1 mm gelegt, um bis zu %2 mm verschoben</translation>
    </message>
    <message>
        <source>frames of the segmentation have no position; they are stacked as they come</source>
        <translation>die Einzelbilder der Segmentierung haben keinen Ort; sie sind gestapelt, wie sie kommen</translation>
    </message>
    <message>
        <source>the segmentation has no pixel spacing; 1 mm was taken</source>
        <translation>die Segmentierung hat keinen Pixelabstand; 1 mm wurde angenommen</translation>
    </message>
    <message>
        <source>Reading segments</source>
        <translation>Segmente werden gelesen</translation>
    </message>
    <message>
        <source>is damaged, or no DICOM segmentation</source>
        <translation>ist beschädigt oder keine DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>the DICOM segmentation cannot be read</source>
        <translation>die DICOM-Segmentierung kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the DICOM segmentation is damaged</source>
        <translation>die DICOM-Segmentierung ist beschädigt</translation>
    </message>
    <message>
        <source>the segmentation says how much of a voxel is inside; what is over half is taken as inside</source>
        <translation>die Segmentierung sagt, wie viel eines Voxels innen ist; mehr als die Hälfte gilt als innen</translation>
    </message>
    <message>
        <source>%1 frames repeat a segment at its place; they are joined</source>
        <translation>%1 Einzelbilder wiederholen ein Segment an seinem Ort; sie sind vereint</translation>
    </message>
    <message>
        <source>%1 voxels belong to several segments; the last one has them</source>
        <translation>%1 Voxel gehören zu mehreren Segmenten; das letzte bekommt sie</translation>
    </message>
    <message>
        <source>the segments do not fit into one DICOM file; write fewer structures</source>
        <translation>die Segmente passen nicht in eine DICOM-Datei; weniger Strukturen schreiben</translation>
    </message>
    <message>
        <source>Writing segments</source>
        <translation>Segmente werden geschrieben</translation>
    </message>
    <message>
        <source>DICOM holds lengths of patients, in millimetres</source>
        <translation>DICOM enthält Längen von Patienten, in Millimetern</translation>
    </message>
    <message>
        <source>the axes of the labels are not at right angles, as those of DICOM are; write .seg.nrrd or .nii.gz</source>
        <translation>die Achsen der Labels stehen nicht rechtwinklig, wie es DICOM verlangt; als .seg.nrrd oder .nii.gz schreiben</translation>
    </message>
    <message>
        <source>DICOM has no planes that large</source>
        <translation>so große Ebenen gibt es in DICOM nicht</translation>
    </message>
    <message>
        <source>nothing is labelled, and DICOM has no segmentation of nothing</source>
        <translation>kein Label ist vergeben, und eine Segmentierung von nichts gibt es in DICOM nicht</translation>
    </message>
    <message>
        <source>the DICOM segmentation cannot be written</source>
        <translation>die DICOM-Segmentierung kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>%1 names of structures are changed: DICOM has %2 characters for them, and no backslash</source>
        <translation>%1 Namen von Strukturen sind geändert: DICOM hat dafür %2 Zeichen und keinen umgekehrten Schrägstrich</translation>
    </message>
    <message>
        <source>opacities are left out: DICOM has no place for them</source>
        <translation>Deckkraft ist weggelassen: DICOM hat keinen Platz dafür</translation>
    </message>
    <message>
        <source>Reading labels</source>
        <translation>Labels werden gelesen</translation>
    </message>
    <message>
        <source>Counting ids</source>
        <translation>Labels werden gezählt</translation>
    </message>
    <message>
        <source>it has %1 ids, and %2 are the most that are read; the largest were taken, which have %3 % of what is labelled</source>
        <translation>es hat %1 Labels, höchstens %2 werden gelesen; die größten wurden genommen, sie machen %3 % des Bezeichneten aus</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels</source>
        <translation>%1 x %2 x %3 Voxel</translation>
    </message>
    <message>
        <source>labels of %1 take more memory than bricks may (%2 GB); they were %3 %4</source>
        <translation>Labels von %1 brauchen mehr Speicher, als Blöcken zusteht (%2 GB); sie wurden %3 %4</translation>
    </message>
    <message>
        <source>read at a coarser level,</source>
        <translation>in einer gröberen Stufe gelesen,</translation>
    </message>
    <message>
        <source>halved to</source>
        <translation>halbiert auf</translation>
    </message>
    <message>
        <source>level %1 of 0 to %2, %3, were read; the finest has %4</source>
        <translation>Stufe %1 von 0 bis %2 (%3) wurde gelesen; die feinste hat %4</translation>
    </message>
    <message>
        <source>is too large for a label table</source>
        <translation>ist zu groß für eine Labeltabelle</translation>
    </message>
    <message>
        <source>no line is a label: expected a number and a name</source>
        <translation>keine Zeile ist ein Label: erwartet werden eine Zahl und ein Name</translation>
    </message>
    <message>
        <source>is no label volume: it has %1 samples per voxel</source>
        <translation>ist kein Labelvolumen: es hat %1 Werte je Voxel</translation>
    </message>
    <message>
        <source>the file has %1 time frames; the first was taken</source>
        <translation>die Datei hat %1 Zeitschritte; der erste wurde genommen</translation>
    </message>
    <message>
        <source>there is no level %1; they are 0 to %2</source>
        <translation>Stufe %1 gibt es nicht; es gibt 0 bis %2</translation>
    </message>
    <message>
        <source>is no label volume: it has the value %1; ids are whole numbers from 0 on</source>
        <translation>ist kein Labelvolumen: es hat den Wert %1; Labels sind ganze Zahlen ab 0</translation>
    </message>
    <message>
        <source>is no label volume: it has the value %1</source>
        <translation>ist kein Labelvolumen: es hat den Wert %1</translation>
    </message>
    <message>
        <source>Sorting labels</source>
        <translation>Labels werden geordnet</translation>
    </message>
    <message>
        <source>is no label volume: values run from %1 to %2, ids from 0 to %3</source>
        <translation>ist kein Labelvolumen: die Werte reichen von %1 bis %2, Labels von 0 bis %3</translation>
    </message>
    <message>
        <source>%1 voxels of the layers are of no segment; they are left out</source>
        <translation>%1 Voxel der Ebenen gehören zu keinem Segment; sie sind weggelassen</translation>
    </message>
    <message>
        <source>%1 segments have numbers of their own here: in the file they share values of other layers</source>
        <translation>%1 Segmente haben hier eigene Zahlen: in der Datei teilen sie Werte mit anderen Ebenen</translation>
    </message>
    <message>
        <source>the folder holds no images and %1 files of segments; %2 was taken</source>
        <translation>der Ordner enthält keine Bilder und %1 Dateien mit Segmenten; %2 wurde genommen</translation>
    </message>
    <message>
        <source>the structure set has no closed contours</source>
        <translation>das Structure-Set hat keine geschlossenen Konturen</translation>
    </message>
    <message>
        <source>its contours do not fit on a grid</source>
        <translation>die Konturen passen auf kein Gitter</translation>
    </message>
    <message>
        <source>Filling contours</source>
        <translation>Konturen werden gefüllt</translation>
    </message>
    <message>
        <source>is damaged, or no DICOM structure set</source>
        <translation>ist beschädigt oder kein DICOM-Structure-Set</translation>
    </message>
    <message>
        <source>the DICOM structure set is damaged</source>
        <translation>das DICOM-Structure-Set ist beschädigt</translation>
    </message>
    <message>
        <source>%1 points and open lines of the structure set are left out</source>
        <translation>%1 Punkte und offene Linien des Structure-Sets sind weggelassen</translation>
    </message>
    <message>
        <source>%1 contours lie across the others and are left out</source>
        <translation>%1 Konturen liegen quer zu den anderen und sind weggelassen</translation>
    </message>
    <message>
        <source>%1 voxels belong to several structures; the smaller one has them</source>
        <translation>%1 Voxel gehören zu mehreren Strukturen; die kleinere bekommt sie</translation>
    </message>
    <message>
        <source>labels of %1 GB do not fit into half of the memory, %2 GB, as this format needs; write a store (.zarr)</source>
        <translation>Labels von %1 GB passen nicht in die Hälfte des Speichers, %2 GB, wie es dieses Format braucht; einen Datenspeicher (.zarr) schreiben</translation>
    </message>
    <message>
        <source>%1 structures have other ids than in the file that they come from; a store keeps those</source>
        <translation>%1 Strukturen haben andere Zahlen als in der Datei, aus der sie kommen; ein Datenspeicher behält sie</translation>
    </message>
    <message>
        <source>%1 names of structures are changed: line ends, or what ends a name in XML, cannot stand in them</source>
        <translation>%1 Namen von Strukturen sind geändert: Zeilenenden, oder was in XML einen Namen beendet, können darin nicht stehen</translation>
    </message>
    <message>
        <source>labels are written as .seg.nrrd, .nrrd, .nii, .nii.gz, .dcm, .zarr or .ozx</source>
        <translation>Labels werden als .seg.nrrd, .nrrd, .nii, .nii.gz, .dcm, .zarr oder .ozx geschrieben</translation>
    </message>
    <message>
        <source>the file&apos;s light is left out</source>
        <translation>das Licht der Datei ist weggelassen</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; is not a number</source>
        <translation>Zeile %1: „%2“ ist keine Zahl</translation>
    </message>
    <message>
        <source>line %1: %2 is no count of points of %3 numbers</source>
        <translation>Zeile %1: %2 ist keine Anzahl von Punkten mit je %3 Zahlen</translation>
    </message>
    <message>
        <source>line %1: %2 numbers are announced and %3 are there</source>
        <translation>Zeile %1: %2 Zahlen sind angekündigt, %3 sind da</translation>
    </message>
    <message>
        <source>%1 has too many points: Slicer reads %2 characters of a line; write .vp.json instead</source>
        <translation>%1 hat zu viele Punkte: Slicer liest %2 Zeichen einer Zeile; stattdessen .vp.json schreiben</translation>
    </message>
    <message>
        <source>numbers of %1 are rounded to six digits: Slicer reads %2 characters of a line</source>
        <translation>die Zahlen von %1 sind auf sechs Stellen gerundet: Slicer liest %2 Zeichen einer Zeile</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>there is no list &quot;%1&quot;</source>
        <translation>die Liste „%1“ fehlt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 items; %3 is the most</source>
        <translation>„%1“ hat %2 Einträge; höchstens %3 sind möglich</translation>
    </message>
    <message>
        <source>&quot;color&quot; is not three numbers</source>
        <translation>„color“ besteht nicht aus drei Zahlen</translation>
    </message>
    <message>
        <source>the name of the preset, %1, is left out</source>
        <translation>der Name der Vorgabe, %1, ist weggelassen</translation>
    </message>
    <message>
        <source>%1 light of %2 becomes 1, the most that Slicer has</source>
        <translation>%1-Licht von %2 wird 1, mehr hat Slicer nicht</translation>
    </message>
    <message>
        <source>shadows and occlusion are left out: Slicer has none</source>
        <translation>Schatten und Verschattung sind weggelassen: Slicer hat keine</translation>
    </message>
    <message>
        <source>the direction of the light is left out: Slicer&apos;s comes from the eye</source>
        <translation>die Richtung des Lichts ist weggelassen: in Slicer kommt es vom Auge</translation>
    </message>
    <message>
        <source>brackets are nested too deep</source>
        <translation>Klammern sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a volume property of Slicer has 9 lines, this has %1</source>
        <translation>eine Volumendarstellung von Slicer hat 9 Zeilen, diese hat %1</translation>
    </message>
    <message>
        <source>the text is not a JSON object; the file is damaged or of another kind</source>
        <translation>der Text ist kein JSON-Objekt; die Datei ist beschädigt oder von anderer Art</translation>
    </message>
    <message>
        <source>&quot;volumeProperties&quot; is empty</source>
        <translation>„volumeProperties“ ist leer</translation>
    </message>
    <message>
        <source>&quot;components&quot; is empty</source>
        <translation>„components“ ist leer</translation>
    </message>
    <message>
        <source>of %1 properties the first was taken</source>
        <translation>von %1 Darstellungen wurde die erste genommen</translation>
    </message>
    <message>
        <source>of %1 components the first was taken</source>
        <translation>von %1 Komponenten wurde die erste genommen</translation>
    </message>
    <message>
        <source>%1 bent segments became short straight ones</source>
        <translation>%1 gebogene Abschnitte wurden kurze gerade</translation>
    </message>
    <message>
        <source>opacities are written for 1 mm of material instead of %1: .vp has no other</source>
        <translation>die Deckkraft ist für 1 mm Material statt %1 geschrieben: etwas anderes kennt .vp nicht</translation>
    </message>
    <message>
        <source>the opacity curve</source>
        <translation>die Kurve der Deckkraft</translation>
    </message>
    <message>
        <source>the gradient curve</source>
        <translation>die Kurve der Gradienten</translation>
    </message>
    <message>
        <source>the colour map</source>
        <translation>die Farbtabelle</translation>
    </message>
    <message>
        <source>%1: a transfer function is kept in .velum-transfer.json, .vp.json or .vp; give one of these</source>
        <translation>%1: eine Transferfunktion wird als .velum-transfer.json, .vp.json oder .vp gespeichert; eines davon angeben</translation>
    </message>
    <message>
        <source>there are no points of opacity in it; nothing would be seen</source>
        <translation>sie enthält keine Punkte der Deckkraft; nichts wäre zu sehen</translation>
    </message>
    <message>
        <source>%1: %2 KiB is too much for a transfer function</source>
        <translation>%1: %2 KiB sind zu viel für eine Transferfunktion</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>point %1 is not a number, or too large for one</source>
        <translation>Punkt %1 ist keine Zahl oder zu groß</translation>
    </message>
    <message>
        <source>has more points than 32 bits count</source>
        <translation>hat mehr Punkte, als 32 Bit zählen</translation>
    </message>
    <message>
        <source>a face names point %1, which is not there</source>
        <translation>ein Dreieck nennt Punkt %1, den es nicht gibt</translation>
    </message>
    <message>
        <source>its points or faces have colours of their own, which are not shown</source>
        <translation>Punkte oder Flächen haben eigene Farben, die nicht gezeigt werden</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>reading surface</source>
        <translation>Oberfläche wird gelesen</translation>
    </message>
    <message>
        <source>is damaged: point or normal %1 has no three numbers</source>
        <translation>ist beschädigt: Punkt oder Normale %1 hat keine drei Zahlen</translation>
    </message>
    <message>
        <source>is damaged: a face has %1 where a point&apos;s number belongs</source>
        <translation>ist beschädigt: eine Fläche hat %1, wo die Nummer eines Punkts hingehört</translation>
    </message>
    <message>
        <source>a face names point or normal %1, which is not there</source>
        <translation>eine Fläche nennt Punkt oder Normale %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>a face names normal %1, which is not there</source>
        <translation>eine Fläche nennt Normale %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>promises %1 %2, more than the file can hold; it is damaged or cut short</source>
        <translation>verspricht %1 %2, mehr, als in der Datei sein können; sie ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>is cut short</source>
        <translation>ist abgeschnitten</translation>
    </message>
    <message>
        <source>has %1 where a number belongs</source>
        <translation>hat %1, wo eine Zahl hingehört</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>hat keine Punkte</translation>
    </message>
    <message>
        <source>has points but no faces; a cloud of points is no surface</source>
        <translation>hat Punkte, aber keine Flächen; eine Punktwolke ist keine Oberfläche</translation>
    </message>
    <message>
        <source>its points have no x, y or z</source>
        <translation>die Punkte haben kein x, y oder z</translation>
    </message>
    <message>
        <source>its faces name no points: the list &apos;vertex_indices&apos; is missing</source>
        <translation>die Flächen nennen keine Punkte: die Liste „vertex_indices“ fehlt</translation>
    </message>
    <message>
        <source>has a list of %1 items</source>
        <translation>hat eine Liste von %1 Einträgen</translation>
    </message>
    <message>
        <source>items in a list</source>
        <translation>Einträge in einer Liste</translation>
    </message>
    <message>
        <source>surfaces are read from %1, not &apos;%2&apos;</source>
        <translation>Oberflächen werden aus %1 gelesen, nicht „%2“</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>hat keine Dreiecke</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>braucht mehr Speicher, als da ist</translation>
    </message>
    <message>
        <source>is damaged (a length in it makes no sense)</source>
        <translation>ist beschädigt (eine Länge darin ist unsinnig)</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>is damaged, or no STL file: it has %1 where %2 belongs</source>
        <translation>ist beschädigt oder keine STL-Datei: hat %1, wo %2 hingehört</translation>
    </message>
    <message>
        <source>its last solid has no end; the file may be cut short</source>
        <translation>der letzte Körper hat kein Ende; die Datei kann abgeschnitten sein</translation>
    </message>
    <message>
        <source>is cut short, or no STL file</source>
        <translation>ist abgeschnitten oder keine STL-Datei</translation>
    </message>
    <message>
        <source>promises %1 triangles, more than the file can hold; it is damaged or cut short</source>
        <translation>verspricht %1 Dreiecke, mehr, als in der Datei sein können; sie ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>structure %1 has no voxels, and so no surface</source>
        <translation>Struktur %1 hat keine Voxel und deshalb keine Oberfläche</translation>
    </message>
    <message>
        <source>is damaged: %1 %2 makes no sense</source>
        <translation>ist beschädigt: %1 %2 ist unsinnig</translation>
    </message>
    <message>
        <source>is damaged: its pieces have more values than the file can hold</source>
        <translation>ist beschädigt: die Teile haben mehr Werte, als in der Datei sein können</translation>
    </message>
    <message>
        <source>is damaged: it has no points</source>
        <translation>ist beschädigt: hat keine Punkte</translation>
    </message>
    <message>
        <source>is damaged: its points have no three coordinates</source>
        <translation>ist beschädigt: die Punkte haben keine drei Koordinaten</translation>
    </message>
    <message>
        <source>is damaged: its normals have no three coordinates</source>
        <translation>ist beschädigt: die Normalen haben keine drei Koordinaten</translation>
    </message>
    <message>
        <source>is damaged: its %1 have no connectivity or offsets</source>
        <translation>ist beschädigt: bei %1 fehlen connectivity oder offsets</translation>
    </message>
    <message>
        <source>is damaged: its %1 have offsets that go back</source>
        <translation>ist beschädigt: bei %1 laufen die offsets rückwärts</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>kann nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>normals of points are left out, and with them soft shading: %1 has those of triangles</source>
        <translation>Normalen von Punkten sind weggelassen und mit ihnen weiche Schattierung: %1 hat die der Dreiecke</translation>
    </message>
    <message>
        <source>colours are left out: %1 is written without</source>
        <translation>Farben sind weggelassen: %1 wird ohne sie geschrieben</translation>
    </message>
    <message>
        <source>%1 surfaces are written as one, without their names</source>
        <translation>%1 Oberflächen sind als eine geschrieben, ohne ihre Namen</translation>
    </message>
    <message>
        <source>surfaces are written as .stl, .ply, .glb, .obj or .vtp</source>
        <translation>Oberflächen werden als .stl, .ply, .glb, .obj oder .vtp geschrieben</translation>
    </message>
    <message>
        <source>an empty surface cannot be written</source>
        <translation>eine leere Oberfläche kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>its operator %1 is no rotation</source>
        <translation>der Operator %1 ist keine Drehung</translation>
    </message>
    <message>
        <source>names more than %1 instances</source>
        <translation>nennt mehr als %1 Instanzen</translation>
    </message>
    <message>
        <source>the assembly %1 names an operator that is not there</source>
        <translation>die Anordnung %1 nennt einen Operator, den es nicht gibt</translation>
    </message>
    <message>
        <source>the assembly %1 makes no sense</source>
        <translation>die Anordnung %1 ist unsinnig</translation>
    </message>
    <message>
        <source>the structure of %1 does not lie where its beads are, and is left out</source>
        <translation>die Struktur von %1 liegt nicht, wo ihre Kugeln sind, und ist weggelassen</translation>
    </message>
    <message>
        <source>is no sound BinaryCIF: its MessagePack is damaged or cut short</source>
        <translation>ist kein gültiges BinaryCIF: das MessagePack ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>is no BinaryCIF: it has no data blocks</source>
        <translation>ist kein BinaryCIF: hat keine Datenblöcke</translation>
    </message>
    <message>
        <source>category _%1 promises %2 rows, more than the file can hold</source>
        <translation>die Kategorie _%1 verspricht %2 Zeilen, mehr, als in der Datei sein können</translation>
    </message>
    <message>
        <source>column %1 has %2 values in %3 rows</source>
        <translation>die Spalte %1 hat %2 Werte in %3 Zeilen</translation>
    </message>
    <message>
        <source>is no sound BinaryCIF: its MessagePack is damaged</source>
        <translation>ist kein gültiges BinaryCIF: das MessagePack ist beschädigt</translation>
    </message>
    <message>
        <source>is no packing of cellPACKgpu: %1 bytes are none that fit</source>
        <translation>ist keine Packung von cellPACKgpu: %1 Bytes passen nicht</translation>
    </message>
    <message>
        <source>its recipe, a JSON file that names its types, does not lie beside it</source>
        <translation>das Rezept, eine JSON-Datei mit den Typen, liegt nicht daneben</translation>
    </message>
    <message>
        <source>its curves are left out</source>
        <translation>die Kurven sind weggelassen</translation>
    </message>
    <message>
        <source>instance %1 stands nowhere</source>
        <translation>Instanz %1 steht nirgends</translation>
    </message>
    <message>
        <source>instance %1 is of type %2, which its recipe lacks</source>
        <translation>Instanz %1 ist vom Typ %2, den das Rezept nicht hat</translation>
    </message>
    <message>
        <source>balls stand for %1 types whose structures are not to be found</source>
        <translation>Kugeln stehen für %1 Typen, deren Strukturen nicht zu finden sind</translation>
    </message>
    <message>
        <source>reading model</source>
        <translation>Modell wird gelesen</translation>
    </message>
    <message>
        <source>has types but no instances</source>
        <translation>hat Typen, aber keine Instanzen</translation>
    </message>
    <message>
        <source>has types but no instances (_pdbx_struct_assembly_gen)</source>
        <translation>hat Typen, aber keine Instanzen (_pdbx_struct_assembly_gen)</translation>
    </message>
    <message>
        <source>its generators name no asyms, or no operators</source>
        <translation>die Generatoren nennen keine asyms oder keine Operatoren</translation>
    </message>
    <message>
        <source>%1 has no rotation</source>
        <translation>%1 hat keine Drehung</translation>
    </message>
    <message>
        <source>%1 has a rotation of %2 numbers</source>
        <translation>%1 hat eine Drehung mit %2 Zahlen</translation>
    </message>
    <message>
        <source>%1 has a rotation of %2 rows</source>
        <translation>%1 hat eine Drehung mit %2 Zeilen</translation>
    </message>
    <message>
        <source>%1 has a rotation of %2 columns</source>
        <translation>%1 hat eine Drehung mit %2 Spalten</translation>
    </message>
    <message>
        <source>%1 has a matrix that is no rotation</source>
        <translation>%1 hat eine Matrix, die keine Drehung ist</translation>
    </message>
    <message>
        <source>%1 has %2 beads and %3 radii</source>
        <translation>%1 hat %2 Kugeln und %3 Radien</translation>
    </message>
    <message>
        <source>balls stand for %1 types whose structures are not to be found, such as %2</source>
        <translation>Kugeln stehen für %1 Typen, deren Strukturen nicht zu finden sind, etwa %2</translation>
    </message>
    <message>
        <source>has a recipe but no instances</source>
        <translation>hat ein Rezept, aber keine Instanzen</translation>
    </message>
    <message>
        <source>is of a newer cellPACK, whose JSON is left-handed in its own way; open the mmCIF of the model</source>
        <translation>ist von einem neueren cellPACK, dessen JSON auf seine Art linkshändig ist; die mmCIF-Datei des Modells öffnen</translation>
    </message>
    <message>
        <source>%1 has an instance without a place</source>
        <translation>%1 hat eine Instanz ohne Ort</translation>
    </message>
    <message>
        <source>%1 lacks its curve %2</source>
        <translation>%1 fehlt die Kurve %2</translation>
    </message>
    <message>
        <source>rotations are read the other way round: so %1 % instead of %2 % of the directions on surfaces agree</source>
        <translation>Drehungen werden andersherum gelesen: so stimmen %1 % statt %2 % der Richtungen auf Oberflächen</translation>
    </message>
    <message>
        <source>the beads of %1 are not where its atoms are, and are left out</source>
        <translation>die Kugeln von %1 liegen nicht, wo die Atome sind, und sind weggelassen</translation>
    </message>
    <message>
        <source>%1 has a curve of %2 angstrom</source>
        <translation>%1 hat eine Kurve von %2 Ångström</translation>
    </message>
    <message>
        <source>has no atoms (_atom_site)</source>
        <translation>hat keine Atome (_atom_site)</translation>
    </message>
    <message>
        <source>its atoms have no places (_atom_site.Cartn_x, _y, _z)</source>
        <translation>die Atome haben keine Orte (_atom_site.Cartn_x, _y, _z)</translation>
    </message>
    <message>
        <source>atom %1 has no place</source>
        <translation>Atom %1 hat keinen Ort</translation>
    </message>
    <message>
        <source>has no encoding</source>
        <translation>hat keine Kodierung</translation>
    </message>
    <message>
        <source>has broken numbers where whole ones belong</source>
        <translation>hat gebrochene Zahlen, wo ganze hingehören</translation>
    </message>
    <message>
        <source>has no bytes</source>
        <translation>hat keine Bytes</translation>
    </message>
    <message>
        <source>has %1 encodings</source>
        <translation>hat %1 Kodierungen</translation>
    </message>
    <message>
        <source>is encoded, but not from bytes</source>
        <translation>ist kodiert, aber nicht aus Bytes</translation>
    </message>
    <message>
        <source>has the number %1, which is too large</source>
        <translation>hat die Zahl %1, die zu groß ist</translation>
    </message>
    <message>
        <source>has bytes of no known type</source>
        <translation>hat Bytes von unbekanntem Typ</translation>
    </message>
    <message>
        <source>is %1 of broken numbers</source>
        <translation>ist %1 aus gebrochenen Zahlen</translation>
    </message>
    <message>
        <source>has the factor 0</source>
        <translation>hat den Faktor 0</translation>
    </message>
    <message>
        <source>has an interval of fewer than two steps</source>
        <translation>hat ein Intervall mit weniger als zwei Schritten</translation>
    </message>
    <message>
        <source>has an encoding that is not known</source>
        <translation>hat eine unbekannte Kodierung</translation>
    </message>
    <message>
        <source>has a packed number that is too large</source>
        <translation>hat eine gepackte Zahl, die zu groß ist</translation>
    </message>
    <message>
        <source>ends within a number</source>
        <translation>endet mitten in einer Zahl</translation>
    </message>
    <message>
        <source>repeats values more often than there are rows</source>
        <translation>wiederholt Werte öfter, als es Zeilen gibt</translation>
    </message>
    <message>
        <source>has a difference that is too large</source>
        <translation>hat eine Differenz, die zu groß ist</translation>
    </message>
    <message>
        <source>has texts that reach beyond their end</source>
        <translation>hat Texte, die über ihr Ende hinausreichen</translation>
    </message>
    <message>
        <source>names text %1 of %2</source>
        <translation>nennt Text %1 von %2</translation>
    </message>
    <message>
        <source>is no sound CIF: %1</source>
        <translation>ist kein gültiges CIF: %1</translation>
    </message>
    <message>
        <source>writing model</source>
        <translation>Modell wird geschrieben</translation>
    </message>
    <message>
        <source>%1 &apos;point symmetry operation&apos;</source>
        <translation>%1 „point symmetry operation“</translation>
    </message>
    <message>
        <source>%1 lipids of the envelope, on two spheres around %2 angstrom, where no protein is</source>
        <translation>%1 Lipide der Hülle, auf zwei Kugeln um %2 Ångström, wo kein Protein ist</translation>
    </message>
    <message>
        <source>holds more than a million points</source>
        <translation>enthält mehr als eine Million Punkte</translation>
    </message>
    <message>
        <source>a strand of %1 nucleotides in the capsid, %2</source>
        <translation>ein Strang von %1 Nukleotiden im Kapsid, %2</translation>
    </message>
    <message>
        <source>along points of rna_allpoints.txt</source>
        <translation>entlang den Punkten von rna_allpoints.txt</translation>
    </message>
    <message>
        <source>on a walk at random</source>
        <translation>auf einem Zufallsweg</translation>
    </message>
    <message>
        <source>holds more than %1 MiB, which no model does</source>
        <translation>enthält mehr als %1 MiB, wie kein Modell es tut</translation>
    </message>
    <message>
        <source>an instance stands nowhere: its place is no number</source>
        <translation>eine Instanz steht nirgends: ihr Ort ist keine Zahl</translation>
    </message>
    <message>
        <source>line %1 has no coordinates</source>
        <translation>Zeile %1 hat keine Koordinaten</translation>
    </message>
    <message>
        <source>line %1 is no operator</source>
        <translation>Zeile %1 ist kein Operator</translation>
    </message>
    <message>
        <source>line %1 ends an operator that is no rotation</source>
        <translation>Zeile %1 beendet einen Operator, der keine Drehung ist</translation>
    </message>
    <message>
        <source>has models but no instances of them (_pdbx_struct_assembly_gen)</source>
        <translation>hat Modelle, aber keine Instanzen davon (_pdbx_struct_assembly_gen)</translation>
    </message>
    <message>
        <source>has no instances of its models</source>
        <translation>hat keine Instanzen seiner Modelle</translation>
    </message>
    <message>
        <source>has no atoms</source>
        <translation>hat keine Atome</translation>
    </message>
    <message>
        <source>has %1 models in one place; the first is taken</source>
        <translation>hat %1 Modelle an einem Ort; das erste wird genommen</translation>
    </message>
    <message>
        <source>its assembly names no chain that is there</source>
        <translation>die Anordnung nennt keine vorhandene Kette</translation>
    </message>
    <message>
        <source>is no model that can be read</source>
        <translation>ist kein lesbares Modell</translation>
    </message>
    <message>
        <source>has compartments within compartments without end</source>
        <translation>hat Kompartimente in Kompartimenten ohne Ende</translation>
    </message>
    <message>
        <source>is no list of balls of 16 bytes each: it has %1 bytes</source>
        <translation>ist keine Liste von Kugeln zu je 16 Bytes: hat %1 Bytes</translation>
    </message>
    <message>
        <source>has a ball that is none</source>
        <translation>hat eine Kugel, die keine ist</translation>
    </message>
    <message>
        <source>the balls of %1 molecules become atoms without an element and a radius</source>
        <translation>die Kugeln von %1 Molekülen werden Atome ohne Element und Radius</translation>
    </message>
    <message>
        <source>coarser balls of molecules are left out</source>
        <translation>gröbere Kugeln von Molekülen sind weggelassen</translation>
    </message>
    <message>
        <source>atoms of rarer elements are written as carbon</source>
        <translation>Atome seltenerer Elemente sind als Kohlenstoff geschrieben</translation>
    </message>
    <message>
        <source>%1 strands are written as their instances, without their curves</source>
        <translation>%1 Stränge sind als ihre Instanzen geschrieben, ohne ihre Kurven</translation>
    </message>
    <message>
        <source>models are written as .cif, .cif.gz, .glb, .csv or .ply</source>
        <translation>Modelle werden als .cif, .cif.gz, .glb, .csv oder .ply geschrieben</translation>
    </message>
    <message>
        <source>an empty model cannot be written</source>
        <translation>ein leeres Modell kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>a brain of %1 voxels along its longest axis: from %2 to %3 are made</source>
        <translation>ein Gehirn von %1 Voxeln entlang der längsten Achse: von %2 bis %3 wird erzeugt</translation>
    </message>
    <message>
        <source>%1 phalanx of %2</source>
        <translation>%1 Phalanx von %2</translation>
    </message>
    <message>
        <source>a sample of size %1 cannot be made; choose 16 to 1024, or 0 for its default</source>
        <translation>ein Phantom der Größe %1 gibt es nicht; 16 bis 1024 wählen, oder 0 für die übliche</translation>
    </message>
    <message>
        <source>a sample of %1 time steps cannot be made; choose 1 to %2, or 0 for its default</source>
        <translation>ein Phantom mit %1 Zeitschritten gibt es nicht; 1 bis %2 wählen, oder 0 für die übliche Zahl</translation>
    </message>
    <message>
        <source>a sample of contrast %1 cannot be made; choose up to %2, or 0 for its own</source>
        <translation>ein Phantom mit Kontrast %1 gibt es nicht; höchstens %2 wählen, oder 0 für den eigenen</translation>
    </message>
    <message>
        <source>%1 time steps: the sample &apos;%2&apos; does not move</source>
        <translation>%1 Zeitschritte: das Phantom „%2“ bewegt sich nicht</translation>
    </message>
    <message>
        <source>contrast %1: the sample &apos;%2&apos; has its own</source>
        <translation>Kontrast %1: das Phantom „%2“ hat einen eigenen</translation>
    </message>
    <message>
        <source>there is no sample &apos;%1&apos;; choose one of %2</source>
        <translation>das Phantom „%1“ gibt es nicht; eines von %2 wählen</translation>
    </message>
    <message>
        <source>scanning ultrasound</source>
        <translation>Ultraschall wird aufgenommen</translation>
    </message>
    <message>
        <source>making a virus</source>
        <translation>Virus wird erzeugt</translation>
    </message>
    <message>
        <source>cannot be deflated</source>
        <translation>kann nicht komprimiert werden</translation>
    </message>
    <message>
        <source>cannot be inflated</source>
        <translation>kann nicht entpackt werden</translation>
    </message>
    <message>
        <source>the compressed data is cut off</source>
        <translation>die komprimierten Daten sind abgeschnitten</translation>
    </message>
    <message>
        <source>the compressed data is damaged (%1)</source>
        <translation>die komprimierten Daten sind beschädigt (%1)</translation>
    </message>
    <message>
        <source>the file is cut short</source>
        <translation>die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>names too many data files</source>
        <translation>nennt zu viele Datendateien</translation>
    </message>
    <message>
        <source>has an empty list of data files</source>
        <translation>hat eine leere Liste von Datendateien</translation>
    </message>
    <message>
        <source>its range of data files %1 is not possible</source>
        <translation>der Bereich der Datendateien, %1, ist nicht möglich</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>kann nicht geöffnet werden (%1)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>its data file %1 lies outside the header&apos;s folder</source>
        <translation>die Datendatei %1 liegt außerhalb des Ordners</translation>
    </message>
    <message>
        <source>its data file %1 is missing</source>
        <translation>die Datendatei %1 fehlt</translation>
    </message>
    <message>
        <source>is no sound JSON: at byte %1 of %2</source>
        <translation>ist kein gültiges JSON: bei Byte %1 von %2</translation>
    </message>
    <message>
        <source>is no sound JSON: it holds a number that is too large</source>
        <translation>ist kein gültiges JSON: enthält eine Zahl, die zu groß ist</translation>
    </message>
    <message>
        <source>%1 has something for a number that is none, or is too large</source>
        <translation>%1 hat statt einer Zahl etwas, das keine oder zu groß ist</translation>
    </message>
    <message>
        <source>%1 is no list of numbers</source>
        <translation>%1 ist keine Liste von Zahlen</translation>
    </message>
    <message>
        <source>%1 is no place of three numbers</source>
        <translation>%1 ist kein Ort aus drei Zahlen</translation>
    </message>
    <message>
        <source>%1 has %2 numbers, not three a place</source>
        <translation>%1 hat %2 Zahlen, nicht drei je Ort</translation>
    </message>
    <message>
        <source>the data would start at byte %1, the file ends at %2</source>
        <translation>die Daten begännen bei Byte %1, die Datei endet bei %2</translation>
    </message>
    <message>
        <source>ends before the data</source>
        <translation>endet vor den Daten</translation>
    </message>
    <message>
        <source>is cut off: %1 bytes of data are missing</source>
        <translation>ist abgeschnitten: %1 Bytes Daten fehlen</translation>
    </message>
    <message>
        <source>has too few numbers</source>
        <translation>hat zu wenige Zahlen</translation>
    </message>
    <message>
        <source>%1 of %2 integers of 64 bits have more digits than a double and are rounded</source>
        <translation>%1 von %2 ganzen Zahlen zu 64 Bit haben mehr Stellen als ein double und sind gerundet</translation>
    </message>
    <message>
        <source>the data files do not divide the volume evenly</source>
        <translation>die Datendateien teilen das Volumen nicht gleichmäßig</translation>
    </message>
    <message>
        <source>there is no memory for %1 bytes</source>
        <translation>für %1 Bytes ist kein Speicher da</translation>
    </message>
    <message>
        <source>the file has no voxel spacing, 1 %1 is taken; give it as spacing in %1 (x, y, z)</source>
        <translation>die Datei nennt keinen Voxelabstand, angenommen wird 1 %1; ihn als spacing in %1 angeben (x, y, z)</translation>
    </message>
    <message>
        <source>the orientation in the file cannot be used; axes along x, y, z with %1 x %2 x %3 %4 were taken</source>
        <translation>die Lage in der Datei ist unbrauchbar; Achsen entlang x, y, z mit %1 x %2 x %3 %4 wurden angenommen</translation>
    </message>
    <message>
        <source>the origin in the file is not a number of use; 0 was taken</source>
        <translation>der Ursprung in der Datei ist keine brauchbare Zahl; 0 wurde angenommen</translation>
    </message>
    <message>
        <source>the file does not say how the body lies in it; axes were taken as right, anterior, superior</source>
        <translation>die Datei sagt nicht, wie der Körper darin liegt; die Achsen wurden als rechts, anterior, superior angenommen</translation>
    </message>
    <message>
        <source>a volume of %1 x %2 x %3 voxels, %4 channels and %5 frames makes no sense</source>
        <translation>ein Volumen von %1 x %2 x %3 Voxeln, %4 Kanälen und %5 Zeitschritten ist unsinnig</translation>
    </message>
    <message>
        <source>the header promises %1 bytes of voxels, but the file can hold %2 at most</source>
        <translation>der Dateikopf verspricht %1 Bytes Voxel, in ihr können aber höchstens %2 sein</translation>
    </message>
    <message>
        <source>is not a TIFF file that can be read</source>
        <translation>ist keine lesbare TIFF-Datei</translation>
    </message>
    <message>
        <source>%1 %2 is damaged or cut short</source>
        <translation>%1 %2 ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>a page is damaged</source>
        <translation>eine Seite ist beschädigt</translation>
    </message>
    <message>
        <source>pages that are packed by scheme %1 cannot be read</source>
        <translation>nach Schema %1 gepackte Seiten können nicht gelesen werden</translation>
    </message>
    <message>
        <source>its pages are not of one size, or are not packed alike</source>
        <translation>die Seiten sind nicht gleich groß oder nicht gleich gepackt</translation>
    </message>
    <message>
        <source>a page promises more than the file can hold</source>
        <translation>eine Seite verspricht mehr, als in der Datei sein kann</translation>
    </message>
    <message>
        <source>%1: is not a TIFF file</source>
        <translation>%1: ist keine TIFF-Datei</translation>
    </message>
    <message>
        <source>%1: the TIFF file is damaged: no page can be read</source>
        <translation>%1: die TIFF-Datei ist beschädigt: keine Seite ist lesbar</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund genannt</translation>
    </message>
    <message>
        <source>is damaged: a packed block of its values cannot be unpacked</source>
        <translation>ist beschädigt: ein gepackter Block von Werten lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>is not a VTK file of %1</source>
        <translation>ist keine VTK-Datei mit %1</translation>
    </message>
    <message>
        <source>is cut short: it has no element %1</source>
        <translation>ist abgeschnitten: hat kein Element %1</translation>
    </message>
    <message>
        <source>a header_type %1 is not known</source>
        <translation>ein header_type %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>a compressor %1 is not known</source>
        <translation>ein Kompressor %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>is cut short: its values lie behind the end of the file</source>
        <translation>ist abgeschnitten: die Werte liegen hinter dem Ende der Datei</translation>
    </message>
    <message>
        <source>is damaged or cut short: its base64 has other letters</source>
        <translation>ist beschädigt oder abgeschnitten: das base64 hat fremde Zeichen</translation>
    </message>
    <message>
        <source>is damaged: its base64 is padded wrongly</source>
        <translation>ist beschädigt: das base64 ist falsch aufgefüllt</translation>
    </message>
    <message>
        <source>samples of type %1 are not read</source>
        <translation>Werte vom Typ %1 werden nicht gelesen</translation>
    </message>
    <message>
        <source>%1 components make no sense</source>
        <translation>%1 Komponenten sind unsinnig</translation>
    </message>
    <message>
        <source>is cut short: it has no AppendedData</source>
        <translation>ist abgeschnitten: hat kein AppendedData</translation>
    </message>
    <message>
        <source>is damaged or cut short: the values of an array lie behind the end of the file</source>
        <translation>ist beschädigt oder abgeschnitten: die Werte eines Felds liegen hinter dem Ende der Datei</translation>
    </message>
    <message>
        <source>an array&apos;s format %1 is not known</source>
        <translation>das Format %1 eines Felds ist nicht bekannt</translation>
    </message>
    <message>
        <source>the header promises %1 values, more than a file of %2 bytes can hold</source>
        <translation>der Dateikopf verspricht %1 Werte, mehr, als in %2 Bytes sein können</translation>
    </message>
    <message>
        <source>is damaged: an array has %1 bytes where its values need %2</source>
        <translation>ist beschädigt: ein Feld hat %1 Bytes, seine Werte brauchen %2</translation>
    </message>
    <message>
        <source>is damaged: its block table promises %1 bytes where its values need %2</source>
        <translation>ist beschädigt: die Blocktabelle verspricht %1 Bytes, die Werte brauchen %2</translation>
    </message>
    <message>
        <source>is cut short within a block table</source>
        <translation>ist in einer Blocktabelle abgeschnitten</translation>
    </message>
    <message>
        <source>reading VTK values</source>
        <translation>VTK-Werte werden gelesen</translation>
    </message>
    <message>
        <source>is cut short: a packed block of its values is not there</source>
        <translation>ist abgeschnitten: ein gepackter Block von Werten fehlt</translation>
    </message>
    <message>
        <source>is damaged: its blocks do not fill its values</source>
        <translation>ist beschädigt: die Blöcke füllen die Werte nicht</translation>
    </message>
    <message>
        <source>has %1 numbers where %2 are needed</source>
        <translation>hat %1 Zahlen, %2 sind nötig</translation>
    </message>
    <message>
        <source>it has a document type or other things that no VTK file needs</source>
        <translation>enthält einen Dokumenttyp oder anderes, was keine VTK-Datei braucht</translation>
    </message>
    <message>
        <source>a tag &lt;%1&gt; closes nothing</source>
        <translation>ein Tag &lt;%1&gt; schließt nichts</translation>
    </message>
    <message>
        <source>it has too many elements</source>
        <translation>hat zu viele Elemente</translation>
    </message>
    <message>
        <source>is damaged: %1 (byte %2)</source>
        <translation>ist beschädigt: %1 (Byte %2)</translation>
    </message>
    <message>
        <source>is cut short: its XML has no end</source>
        <translation>ist abgeschnitten: das XML hat kein Ende</translation>
    </message>
    <message>
        <source>a tag has no end</source>
        <translation>ein Tag hat kein Ende</translation>
    </message>
    <message>
        <source>an attribute of &lt;%1&gt; is not understood</source>
        <translation>ein Attribut von &lt;%1&gt; ist unverständlich</translation>
    </message>
    <message>
        <source>has %1 voxels along an axis, where %2 are said</source>
        <translation>hat %1 Voxel entlang einer Achse, angesagt sind %2</translation>
    </message>
    <message>
        <source>its chunks or its type are not those of the first array of its level</source>
        <translation>Chunks oder Typ sind nicht die des ersten Felds der Stufe</translation>
    </message>
    <message>
        <source>holds no view setups or no time points</source>
        <translation>enthält keine View-Setups oder keine Zeitpunkte</translation>
    </message>
    <message>
        <source>each time point has a place of its own in the file; all were put where the first one lies</source>
        <translation>jeder Zeitpunkt hat in der Datei einen eigenen Ort; alle wurden dorthin gelegt, wo der erste liegt</translation>
    </message>
    <message>
        <source>the file places voxels in a unit of %1 of those of its voxel size; they were made as large as that</source>
        <translation>die Datei legt die Voxel in einer Einheit aus, die das %1-Fache der ihrer Voxelgröße ist; sie wurden so groß gemacht</translation>
    </message>
    <message>
        <source>level %1 of %2 is missing at all time points</source>
        <translation>Stufe %1 von %2 fehlt zu allen Zeitpunkten</translation>
    </message>
    <message>
        <source>the store holds no image %1</source>
        <translation>der Datenspeicher enthält kein Bild %1</translation>
    </message>
    <message>
        <source>there is no XML beside it that says how large voxels are and where they lie</source>
        <translation>daneben liegt kein XML, das sagt, wie groß die Voxel sind und wo sie liegen</translation>
    </message>
    <message>
        <source>the factors %1, %2, %3 of a level make no sense</source>
        <translation>die Faktoren %1, %2, %3 einer Stufe sind unsinnig</translation>
    </message>
    <message>
        <source>the resolutions of setup %1 are missing, or are no rows of three</source>
        <translation>die Auflösungen von Setup %1 fehlen oder sind keine Dreierzeilen</translation>
    </message>
    <message>
        <source>%1 levels make no sense</source>
        <translation>%1 Stufen sind unsinnig</translation>
    </message>
    <message>
        <source>its size of %1 in chunks of %2 makes no sense</source>
        <translation>die Größe %1 in Chunks von %2 ist unsinnig</translation>
    </message>
    <message>
        <source>its chunks of %1 samples are larger than 2 GiB</source>
        <translation>die Chunks von %1 Werten sind größer als 2 GiB</translation>
    </message>
    <message>
        <source>there is no memory to inflate it</source>
        <translation>zum Entpacken fehlt der Speicher</translation>
    </message>
    <message>
        <source>there is no memory to unpack it</source>
        <translation>zum Auspacken fehlt der Speicher</translation>
    </message>
    <message>
        <source>is too short for its check sum</source>
        <translation>ist zu kurz für die Prüfsumme</translation>
    </message>
    <message>
        <source>its check sum (crc32c) is wrong: it is damaged</source>
        <translation>die Prüfsumme (crc32c) ist falsch: beschädigt</translation>
    </message>
    <message>
        <source>holds %1 bytes of samples, where a chunk has %2</source>
        <translation>enthält %1 Bytes Werte, ein Chunk hat %2</translation>
    </message>
    <message>
        <source>holds whole numbers of the type %1 that need more than 32 bits, which cannot be held yet</source>
        <translation>enthält ganze Zahlen vom Typ %1, die mehr als 32 Bit brauchen, was noch nicht geht</translation>
    </message>
    <message>
        <source>a box from voxel %1 %2 %3 to before %4 %5 %6 does not lie in the %7 x %8 x %9 voxels</source>
        <translation>ein Quader von Voxel %1 %2 %3 bis vor %4 %5 %6 liegt nicht in den %7 x %8 x %9 Voxeln</translation>
    </message>
    <message>
        <source>has %1 axes, where an image has z, y and x</source>
        <translation>hat %1 Achsen, ein Bild hat z, y und x</translation>
    </message>
    <message>
        <source>a chunk lies beyond the file&apos;s end: the file is damaged or cut short</source>
        <translation>ein Chunk liegt hinter dem Ende der Datei: sie ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>the place of a chunk cannot be found: it is damaged%1</source>
        <translation>der Ort eines Chunks ist nicht zu finden: er ist beschädigt%1</translation>
    </message>
    <message>
        <source>its samples are no whole numbers or floats of 8 to 64 bits</source>
        <translation>die Werte sind keine ganzen Zahlen oder Gleitkommazahlen von 8 bis 64 Bit</translation>
    </message>
    <message>
        <source>samples cannot be read%1</source>
        <translation>Werte können nicht gelesen werden%1</translation>
    </message>
    <message>
        <source>has %1 axes, which makes no sense%2</source>
        <translation>hat %1 Achsen, was unsinnig ist%2</translation>
    </message>
    <message>
        <source>its samples lie in other files, which are not opened</source>
        <translation>die Werte liegen in anderen Dateien, die nicht geöffnet werden</translation>
    </message>
    <message>
        <source>its chunks do not fit it</source>
        <translation>die Chunks passen nicht dazu</translation>
    </message>
    <message>
        <source>a group cannot be read: it is damaged%1</source>
        <translation>eine Gruppe kann nicht gelesen werden: sie ist beschädigt%1</translation>
    </message>
    <message>
        <source>%1 is no short list of numbers%2</source>
        <translation>%1 ist keine kurze Liste von Zahlen%2</translation>
    </message>
    <message>
        <source>%1 cannot be read%2</source>
        <translation>%1 kann nicht gelesen werden%2</translation>
    </message>
    <message>
        <source>%1 cannot be opened%2</source>
        <translation>%1 kann nicht geöffnet werden%2</translation>
    </message>
    <message>
        <source>cannot be opened as HDF5: it is none, is damaged or cut short%1</source>
        <translation>kann nicht als HDF5 geöffnet werden: ist keines, ist beschädigt oder abgeschnitten%1</translation>
    </message>
    <message>
        <source>is a file of HDF5 of no kind that is read here; those of Imaris and BigDataViewer are</source>
        <translation>ist eine HDF5-Datei von einer Art, die hier nicht gelesen wird; gelesen werden die von Imaris und BigDataViewer</translation>
    </message>
    <message>
        <source>is not whole: it is being written, or its writer was stopped; to go on, give the same command again or make the pyramid again in the window; or remove it</source>
        <translation>ist nicht vollständig: es wird noch geschrieben, oder das Schreiben wurde angehalten; zum Fortsetzen denselben Befehl noch einmal geben oder im Fenster die Pyramide noch einmal erzeugen; oder es löschen</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>is no store: neither Zarr nor N5, no HDF5 of Imaris or BigDataViewer, and no XML of the latter; it may be damaged</source>
        <translation>ist kein Datenspeicher: weder Zarr noch N5, kein HDF5 von Imaris oder BigDataViewer und kein XML von diesem; vielleicht beschädigt</translation>
    </message>
    <message>
        <source>holds %1 of %2</source>
        <translation>enthält %1 von %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>its %1 bytes are damaged, or unpack to more than the chunk holds</source>
        <translation>die %1 Bytes sind beschädigt oder ergeben mehr, als der Chunk enthält</translation>
    </message>
    <message>
        <source>the type %1 of its samples is not known</source>
        <translation>der Typ %1 der Werte ist nicht bekannt</translation>
    </message>
    <message>
        <source>its blocks are packed by %1, which is not known here; raw, gzip, bzip2, xz, lz4, blosc and zstd are</source>
        <translation>die Blöcke sind mit %1 gepackt, was hier nicht bekannt ist; raw, gzip, bzip2, xz, lz4, blosc und zstd sind es</translation>
    </message>
    <message>
        <source>is too short for the head of a block</source>
        <translation>ist zu kurz für den Kopf eines Blocks</translation>
    </message>
    <message>
        <source>its list of dimensions</source>
        <translation>die Liste dimensions</translation>
    </message>
    <message>
        <source>its blockSize</source>
        <translation>die blockSize</translation>
    </message>
    <message>
        <source>it has %1 axes, where 2 to %2 are read</source>
        <translation>hat %1 Achsen, gelesen werden 2 bis %2</translation>
    </message>
    <message>
        <source>its blocks have another number of axes than it has</source>
        <translation>die Blöcke haben eine andere Zahl von Achsen</translation>
    </message>
    <message>
        <source>is no block of samples of its dataset</source>
        <translation>ist kein Block mit Werten dieses Datenfelds</translation>
    </message>
    <message>
        <source>its size of %1 is not that of a block, %2</source>
        <translation>die Größe %1 ist nicht die eines Blocks, %2</translation>
    </message>
    <message>
        <source>has another number of samples than its size says</source>
        <translation>hat eine andere Zahl von Werten, als die Größe sagt</translation>
    </message>
    <message>
        <source>it has another type, or other channels or time steps, than the finest level</source>
        <translation>hat einen anderen Typ oder andere Kanäle oder Zeitschritte als die feinste Stufe</translation>
    </message>
    <message>
        <source>is no dataset of N5, and holds no levels s0, s1, ...</source>
        <translation>ist kein Datenfeld in N5 und enthält keine Stufen s0, s1, ...</translation>
    </message>
    <message>
        <source>its list of multiscales is empty</source>
        <translation>die Liste multiscales ist leer</translation>
    </message>
    <message>
        <source>its multiscales have no axes</source>
        <translation>multiscales hat keine Achsen</translation>
    </message>
    <message>
        <source>it has %1 axes; %2 are the most</source>
        <translation>hat %1 Achsen; höchstens %2 sind möglich</translation>
    </message>
    <message>
        <source>one of its axes has no name</source>
        <translation>eine der Achsen hat keinen Namen</translation>
    </message>
    <message>
        <source>the type of one of its axes is no word</source>
        <translation>der Typ einer der Achsen ist kein Wort</translation>
    </message>
    <message>
        <source>two of its axes are called %1</source>
        <translation>zwei der Achsen heißen %1</translation>
    </message>
    <message>
        <source>it has two axes, %1 and %2, where there is room for one beside those of space</source>
        <translation>hat zwei Achsen, %1 und %2, wo neben denen des Raums nur für eine Platz ist</translation>
    </message>
    <message>
        <source>it has %1 axes of space, not 2 or 3</source>
        <translation>hat %1 Raumachsen, nicht 2 oder 3</translation>
    </message>
    <message>
        <source>its multiscales have no datasets</source>
        <translation>multiscales hat keine datasets</translation>
    </message>
    <message>
        <source>it has %1 levels, which makes no sense</source>
        <translation>hat %1 Stufen, was unsinnig ist</translation>
    </message>
    <message>
        <source>one of its datasets has no path</source>
        <translation>eines der datasets hat keinen Pfad</translation>
    </message>
    <message>
        <source>a level has no coordinateTransformations</source>
        <translation>eine Stufe hat keine coordinateTransformations</translation>
    </message>
    <message>
        <source>a level has %1 scales, not one</source>
        <translation>eine Stufe hat %1 Maßstäbe, nicht einen</translation>
    </message>
    <message>
        <source>a sequence of transformations is no list</source>
        <translation>eine Folge von Transformationen ist keine Liste</translation>
    </message>
    <message>
        <source>it has a sequence in a sequence of transformations</source>
        <translation>hat eine Folge in einer Folge von Transformationen</translation>
    </message>
    <message>
        <source>the transformation %1 is not known here; scale and translation are</source>
        <translation>die Transformation %1 ist hier nicht bekannt; scale und translation sind es</translation>
    </message>
    <message>
        <source>a %1 is kept in an array of its own, which is not known here</source>
        <translation>%1 liegt in einem eigenen Feld, was hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>a %1 has not one number for each axis</source>
        <translation>%1 hat nicht eine Zahl je Achse</translation>
    </message>
    <message>
        <source>a %1 holds something that is no number</source>
        <translation>%1 enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>its plate has no wells</source>
        <translation>die Platte hat keine Wells</translation>
    </message>
    <message>
        <source>a well of its plate has no path</source>
        <translation>ein Well der Platte hat keinen Pfad</translation>
    </message>
    <message>
        <source>an image of its well has no path</source>
        <translation>ein Bild im Well hat keinen Pfad</translation>
    </message>
    <message>
        <source>the store holds no image: no group of it says that it is one, and it is no array</source>
        <translation>der Datenspeicher enthält kein Bild: keine Gruppe darin nennt sich so, und er ist kein Feld</translation>
    </message>
    <message>
        <source>the store holds %1 images; %2 was taken; choose by series</source>
        <translation>der Datenspeicher enthält %1 Bilder; %2 wurde genommen; mit series wählen</translation>
    </message>
    <message>
        <source>the file gives no unit of lengths; millimetres were taken</source>
        <translation>die Datei nennt keine Längeneinheit; Millimeter wurden angenommen</translation>
    </message>
    <message>
        <source>the unit of lengths, %1, is not known; millimetres were taken</source>
        <translation>die Längeneinheit %1 ist nicht bekannt; Millimeter wurden angenommen</translation>
    </message>
    <message>
        <source>zstd cannot pack: %1</source>
        <translation>zstd kann nicht packen: %1</translation>
    </message>
    <message>
        <source>is no XML of BigDataViewer: it has no sequence of views</source>
        <translation>ist kein XML von BigDataViewer: hat keine Folge von Ansichten</translation>
    </message>
    <message>
        <source>its &lt;%1&gt; lacks &lt;%2&gt;</source>
        <translation>in &lt;%1&gt; fehlt &lt;%2&gt;</translation>
    </message>
    <message>
        <source>%1 is no number but %2</source>
        <translation>%1 ist keine Zahl, sondern %2</translation>
    </message>
    <message>
        <source>the id of a view setup</source>
        <translation>die id eines View-Setups</translation>
    </message>
    <message>
        <source>it has no view setups</source>
        <translation>hat keine View-Setups</translation>
    </message>
    <message>
        <source>the first time point</source>
        <translation>der erste Zeitpunkt</translation>
    </message>
    <message>
        <source>the last time point</source>
        <translation>der letzte Zeitpunkt</translation>
    </message>
    <message>
        <source>the id of a time point</source>
        <translation>die id eines Zeitpunkts</translation>
    </message>
    <message>
        <source>a step of time points</source>
        <translation>eine Schrittweite von Zeitpunkten</translation>
    </message>
    <message>
        <source>a time point</source>
        <translation>ein Zeitpunkt</translation>
    </message>
    <message>
        <source>the time point of a registration</source>
        <translation>der Zeitpunkt einer Registrierung</translation>
    </message>
    <message>
        <source>the setup of a registration</source>
        <translation>das Setup einer Registrierung</translation>
    </message>
    <message>
        <source>a transformation of the type %1 is not known here; affine is</source>
        <translation>eine Transformation vom Typ %1 ist hier nicht bekannt; affine ist es</translation>
    </message>
    <message>
        <source>an affine transformation has not twelve numbers</source>
        <translation>eine affine Transformation hat nicht zwölf Zahlen</translation>
    </message>
    <message>
        <source>its voxels are kept as %1, which is not known here; bdv.hdf5 and bdv.n5 are%2</source>
        <translation>die Voxel liegen als %1 vor, was hier nicht bekannt ist; bdv.hdf5 und bdv.n5 sind es%2</translation>
    </message>
    <message>
        <source>; open the .zarr itself</source>
        <translation>; das .zarr selbst öffnen</translation>
    </message>
    <message>
        <source>the folder %1 that it names does not lie beside it</source>
        <translation>der genannte Ordner %1 liegt nicht daneben</translation>
    </message>
    <message>
        <source>the folder %1 that it names is missing</source>
        <translation>der genannte Ordner %1 fehlt</translation>
    </message>
    <message>
        <source>the store is gone: it was removed or renamed, or its disk is away</source>
        <translation>der Datenspeicher ist weg: gelöscht, umbenannt, oder sein Laufwerk fehlt</translation>
    </message>
    <message>
        <source>has %1 bytes, where %2 are the most that make sense</source>
        <translation>hat %1 Bytes, höchstens %2 sind sinnvoll</translation>
    </message>
    <message>
        <source>the path %1 leads out of the store</source>
        <translation>der Pfad %1 führt aus dem Datenspeicher hinaus</translation>
    </message>
    <message>
        <source>Writing level %1 of 0 to %2</source>
        <translation>Stufe %1 von 0 bis %2 wird geschrieben</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>der Ordner kann nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>holds what was written of another volume, or in another way, and is not whole; remove it, or give another name</source>
        <translation>enthält, was von einem anderen Volumen oder auf andere Weise geschrieben wurde, und ist nicht vollständig; es löschen oder einen anderen Namen angeben</translation>
    </message>
    <message>
        <source>is there already; remove it, or give another name</source>
        <translation>gibt es schon; es löschen oder einen anderen Namen angeben</translation>
    </message>
    <message>
        <source>how the volume is turned is kept in an attribute that other programs do not know</source>
        <translation>wie das Volumen gedreht ist, steht in einem Attribut, das andere Programme nicht kennen</translation>
    </message>
    <message>
        <source>values are samples times %1 plus %2: other programs will show the samples</source>
        <translation>Werte sind gespeicherte Zahlen mal %1 plus %2: andere Programme zeigen die gespeicherten Zahlen</translation>
    </message>
    <message>
        <source>colours become channels for other programs</source>
        <translation>Farben werden für andere Programme zu Kanälen</translation>
    </message>
    <message>
        <source>cannot be removed: %1</source>
        <translation>kann nicht gelöscht werden: %1</translation>
    </message>
    <message>
        <source>its folder does not exist; create it first</source>
        <translation>der Ordner dafür fehlt; ihn zuerst anlegen</translation>
    </message>
    <message>
        <source>archives are of OME-Zarr 0.5; write a folder (.zarr) of 0.4</source>
        <translation>Archive gibt es in OME-Zarr 0.5; für 0.4 einen Ordner (.zarr) schreiben</translation>
    </message>
    <message>
        <source>Reading samples</source>
        <translation>Werte werden gelesen</translation>
    </message>
    <message>
        <source>samples of the type %1 cannot be read; whole numbers, floats of 16 to 64 bits and bool can</source>
        <translation>Werte vom Typ %1 können nicht gelesen werden; ganze Zahlen, Gleitkommazahlen von 16 bis 64 Bit und bool schon</translation>
    </message>
    <message>
        <source>its fill_value is no sample of its type</source>
        <translation>fill_value ist kein Wert dieses Typs</translation>
    </message>
    <message>
        <source>the separator in its chunks&apos; keys is neither / nor .</source>
        <translation>das Trennzeichen in den Schlüsseln der Chunks ist weder / noch .</translation>
    </message>
    <message>
        <source>it is a single number and no array</source>
        <translation>ist eine einzelne Zahl und kein Feld</translation>
    </message>
    <message>
        <source>its chunks have another number of axes than it has</source>
        <translation>die Chunks haben eine andere Zahl von Achsen</translation>
    </message>
    <message>
        <source>its list of chunks</source>
        <translation>die Liste chunks</translation>
    </message>
    <message>
        <source>the order of its samples is neither C nor F</source>
        <translation>die Reihenfolge der Werte ist weder C noch F</translation>
    </message>
    <message>
        <source>its metadata has %1, which is not known here</source>
        <translation>die Metadaten haben %1, was hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>the storage transformer %1 is not known here</source>
        <translation>der storage transformer %1 ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>its grid of chunks, %1, is not known here</source>
        <translation>das Gitter der Chunks, %1, ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>its chunk_shape</source>
        <translation>chunk_shape</translation>
    </message>
    <message>
        <source>the way %1 of naming chunks is not known here</source>
        <translation>die Art %1, Chunks zu benennen, ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>is no metadata of Zarr version 2 or 3</source>
        <translation>sind keine Metadaten von Zarr, Version 2 oder 3</translation>
    </message>
    <message>
        <source>its shape</source>
        <translation>shape</translation>
    </message>
    <message>
        <source>the index of the shard points beyond its end: it is damaged or cut short</source>
        <translation>der Index des Shards zeigt hinter sein Ende: er ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>is too short for the index of a shard</source>
        <translation>ist zu kurz für den Index eines Shards</translation>
    </message>
    <message>
        <source>its chunks are packed by the codec %1, which is not known here; gzip, zlib, zstd, lz4, blosc, crc32c, transpose and sharding_indexed are</source>
        <translation>die Chunks sind mit dem Codec %1 gepackt, der hier nicht bekannt ist; gzip, zlib, zstd, lz4, blosc, crc32c, transpose und sharding_indexed sind es</translation>
    </message>
    <message>
        <source>the byte order %1 is not known</source>
        <translation>die Bytefolge %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>the codec &apos;transpose&apos; gives no order of the array&apos;s axes</source>
        <translation>der Codec „transpose“ nennt keine Reihenfolge der Achsen</translation>
    </message>
    <message>
        <source>the shards&apos; index has no codecs</source>
        <translation>der Index der Shards hat keine Codecs</translation>
    </message>
    <message>
        <source>the shards&apos; index is packed by the codec %1, which is not known here</source>
        <translation>der Index der Shards ist mit dem Codec %1 gepackt, der hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>the shards&apos; index lacks the codec &apos;bytes&apos;</source>
        <translation>dem Index der Shards fehlt der Codec „bytes“</translation>
    </message>
    <message>
        <source>it has shards within shards, which are not known here</source>
        <translation>hat Shards in Shards, was hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>its shards are transposed as a whole, which is not known here</source>
        <translation>die Shards sind als Ganzes transponiert, was hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>the chunk_shape of the shards</source>
        <translation>chunk_shape der Shards</translation>
    </message>
    <message>
        <source>the chunks in its shards do not divide the shards</source>
        <translation>die Chunks in den Shards teilen diese nicht ganzzahlig</translation>
    </message>
    <message>
        <source>the place %1 of the shards&apos; index is not known</source>
        <translation>der Ort %1 des Index der Shards ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 is no list of sizes</source>
        <translation>%1 ist keine Liste von Größen</translation>
    </message>
    <message>
        <source>%1 holds something that is no size</source>
        <translation>%1 enthält etwas, das keine Größe ist</translation>
    </message>
    <message>
        <source>its samples are filtered by %1, which is not known here</source>
        <translation>die Werte sind mit %1 gefiltert, was hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>it has no list of codecs</source>
        <translation>hat keine Liste von Codecs</translation>
    </message>
    <message>
        <source>two of its codecs make bytes of samples</source>
        <translation>zwei der Codecs machen Bytes aus Werten</translation>
    </message>
    <message>
        <source>its shards are packed as a whole</source>
        <translation>die Shards sind als Ganzes gepackt</translation>
    </message>
    <message>
        <source>none of its codecs makes bytes of samples</source>
        <translation>keiner der Codecs macht Bytes aus Werten</translation>
    </message>
    <message>
        <source>the array of a level is missing</source>
        <translation>das Feld einer Stufe fehlt</translation>
    </message>
    <message>
        <source>it has %1 axes, where its image has %2</source>
        <translation>hat %1 Achsen, das Bild hat %2</translation>
    </message>
    <message>
        <source>a shape of %1 makes no sense</source>
        <translation>eine Form von %1 ist unsinnig</translation>
    </message>
    <message>
        <source>a member of the archive is cut short</source>
        <translation>eine Datei im Archiv ist abgeschnitten</translation>
    </message>
    <message>
        <source>a member of the archive promises %1 bytes, which it cannot hold</source>
        <translation>eine Datei im Archiv verspricht %1 Bytes, die sie nicht enthalten kann</translation>
    </message>
    <message>
        <source>there is no memory to inflate a member</source>
        <translation>zum Entpacken einer Datei im Archiv fehlt der Speicher</translation>
    </message>
    <message>
        <source>a deflated member of the archive is damaged</source>
        <translation>eine komprimierte Datei im Archiv ist beschädigt</translation>
    </message>
    <message>
        <source>is no ZIP archive, or one that is cut short</source>
        <translation>ist kein ZIP-Archiv oder abgeschnitten</translation>
    </message>
    <message>
        <source>the ZIP archive&apos;s directory is damaged</source>
        <translation>das Verzeichnis des ZIP-Archivs ist beschädigt</translation>
    </message>
    <message>
        <source>the ZIP archive is encrypted</source>
        <translation>das ZIP-Archiv ist verschlüsselt</translation>
    </message>
    <message>
        <source>the ZIP archive packs %1 by method %2; members may be stored or deflated</source>
        <translation>das ZIP-Archiv packt %1 nach Verfahren %2; Dateien darin dürfen gespeichert oder mit deflate gepackt sein</translation>
    </message>
    <message>
        <source>its place in the ZIP archive lies beyond the end</source>
        <translation>der Ort im ZIP-Archiv liegt hinter dem Ende</translation>
    </message>
    <message>
        <source>its place in the ZIP archive is damaged</source>
        <translation>der Ort im ZIP-Archiv ist beschädigt</translation>
    </message>
    <message>
        <source>cannot be listed: %1</source>
        <translation>kann nicht aufgelistet werden: %1</translation>
    </message>
    <message>
        <source>Joining the archive</source>
        <translation>Archiv wird zusammengefügt</translation>
    </message>
    <message>
        <source>is larger than any file of a store that we write</source>
        <translation>ist größer als jede Datei, die für einen Datenspeicher geschrieben wird</translation>
    </message>
    <message>
        <source>%1 is not installed: apt install %2</source>
        <translation>%1 ist nicht installiert: apt install %2</translation>
    </message>
    <message>
        <source>%1: cannot be started (%2)</source>
        <translation>%1: kann nicht gestartet werden (%2)</translation>
    </message>
    <message>
        <source>%1: videos are written as .mp4, .webm or .gif</source>
        <translation>%1: Videos werden als .mp4, .webm oder .gif geschrieben</translation>
    </message>
    <message>
        <source>%1 frames a second: expected more than 0, at most 1000</source>
        <translation>%1 Bilder je Sekunde: mehr als 0 und höchstens 1000 angeben</translation>
    </message>
    <message>
        <source>quality %1: expected 0 to 100</source>
        <translation>Qualität %1: 0 bis 100 angeben</translation>
    </message>
    <message>
        <source>%1: an %2 has no alpha; write .webm, .gif or pictures</source>
        <translation>%1: ein %2 hat keine Durchsichtigkeit; .webm, .gif oder Bilder schreiben</translation>
    </message>
    <message>
        <source>%1: programs show no more than %2 frames a second of a .gif, not %3</source>
        <translation>%1: Programme zeigen höchstens %2 Bilder je Sekunde eines .gif, nicht %3</translation>
    </message>
    <message>
        <source>%1: a .gif counts in hundredths of a second, so frames take %2 or %3 of them in turn</source>
        <translation>%1: ein .gif zählt in Hundertstelsekunden, deshalb dauern Bilder abwechselnd %2 oder %3 davon</translation>
    </message>
    <message>
        <source>%1: a frame of %2 x %3 pixels does not fit into a video of %4 x %5</source>
        <translation>%1: ein Einzelbild von %2 x %3 Pixeln passt nicht in ein Video von %4 x %5</translation>
    </message>
    <message>
        <source>%1: a frame has no channel %2</source>
        <translation>%1: einem Einzelbild fehlt der Kanal %2</translation>
    </message>
    <message>
        <source>%1: ffmpeg has failed%2%3</source>
        <translation>%1: ffmpeg ist gescheitert%2%3</translation>
    </message>
    <message>
        <source>the pictures are stored with white as zero (MONOCHROME1); they were turned round</source>
        <translation>die Bilder sind mit Weiß als null gespeichert (MONOCHROME1); sie wurden umgekehrt</translation>
    </message>
    <message>
        <source>the pictures are to be shown with white as zero (MONOCHROME1); values are the file&apos;s</source>
        <translation>die Bilder sind mit Weiß als null zu zeigen (MONOCHROME1); die Werte sind die der Datei</translation>
    </message>
    <message>
        <source>Decoding DICOM slices</source>
        <translation>DICOM-Schichten werden dekodiert</translation>
    </message>
    <message>
        <source>the slice differs from its series in size or pixel type</source>
        <translation>die Schicht weicht in Größe oder Pixeltyp von ihrer Serie ab</translation>
    </message>
    <message>
        <source>frame %1 of %2 is missing</source>
        <translation>Einzelbild %1 von %2 fehlt</translation>
    </message>
    <message>
        <source>Looking for DICOM images</source>
        <translation>DICOM-Bilder werden gesucht</translation>
    </message>
    <message>
        <source>none of the %1 files that this index lists lies beside it</source>
        <translation>keine der %1 Dateien, die dieses Verzeichnis nennt, liegt daneben</translation>
    </message>
    <message>
        <source>a rescale slope of %1 and an intercept of %2 are no numbers to scale by and are left out</source>
        <translation>eine Steigung von %1 und ein Achsenabschnitt von %2 taugen nicht zum Umrechnen und sind weggelassen</translation>
    </message>
    <message>
        <source>the dose has no grid scaling; its values are the stored numbers</source>
        <translation>der Dosis fehlt die Skalierung; die Werte sind die gespeicherten Zahlen</translation>
    </message>
    <message>
        <source>the dose is relative to one that the file does not tell</source>
        <translation>die Dosis ist relativ zu einer, die die Datei nicht nennt</translation>
    </message>
    <message>
        <source>correction for attenuation and decay</source>
        <translation>Korrektur von Schwächung und Zerfall</translation>
    </message>
    <message>
        <source>decay correction to the scan&apos;s start or the injection</source>
        <translation>Zerfallskorrektur auf den Beginn des Scans oder die Injektion</translation>
    </message>
    <message>
        <source>the patient&apos;s weight</source>
        <translation>das Gewicht des Patienten</translation>
    </message>
    <message>
        <source>the injected dose</source>
        <translation>die injizierte Dosis</translation>
    </message>
    <message>
        <source>the half-life</source>
        <translation>die Halbwertszeit</translation>
    </message>
    <message>
        <source>the time of injection</source>
        <translation>der Zeitpunkt der Injektion</translation>
    </message>
    <message>
        <source>the time of the scan</source>
        <translation>der Zeitpunkt des Scans</translation>
    </message>
    <message>
        <source>uptake values (SUV) cannot be had of these Bq/ml: the scan begins %1 minutes after injection</source>
        <translation>Uptake-Werte (SUV) lassen sich aus diesen Bq/ml nicht gewinnen: der Scan beginnt %1 Minuten nach der Injektion</translation>
    </message>
    <message>
        <source>values are SUVbw: the file&apos;s Bq/ml times %1 (%2 kg, %3 MBq%4)</source>
        <translation>die Werte sind SUVbw: Bq/ml der Datei mal %1 (%2 kg, %3 MBq%4)</translation>
    </message>
    <message>
        <source> %1 minutes before the scan</source>
        <translation> %1 Minuten vor dem Scan</translation>
    </message>
    <message>
        <source>DICOM pixels of %1 bits are not supported</source>
        <translation>DICOM-Pixel mit %1 Bit werden nicht unterstützt</translation>
    </message>
    <message>
        <source>its header asks for %1 bytes of pixels</source>
        <translation>der Dateikopf verlangt %1 Bytes Pixel</translation>
    </message>
    <message>
        <source>pixels of %1 bits, %2 of them stored, are not supported</source>
        <translation>Pixel mit %1 Bit, davon %2 gespeichert, werden nicht unterstützt</translation>
    </message>
    <message>
        <source>a palette for %1 samples of %2 bits is not supported</source>
        <translation>eine Palette für %1 Werte zu %2 Bit wird nicht unterstützt</translation>
    </message>
    <message>
        <source>%1 samples per pixel are not supported</source>
        <translation>%1 Werte je Pixel werden nicht unterstützt</translation>
    </message>
    <message>
        <source>the DICOM pixels cannot be read: missing, damaged, or of an unsupported kind</source>
        <translation>die DICOM-Pixel können nicht gelesen werden: sie fehlen, sind beschädigt oder von nicht unterstützter Art</translation>
    </message>
    <message>
        <source>its colour planes cannot be interleaved</source>
        <translation>die Farbebenen lassen sich nicht verschränken</translation>
    </message>
    <message>
        <source>the DICOM pixels cannot be read (%1)</source>
        <translation>die DICOM-Pixel können nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>its header and its pixel data disagree about colours</source>
        <translation>der Dateikopf und die Pixel widersprechen sich über die Farben</translation>
    </message>
    <message>
        <source>the DICOM pixels cannot be decoded: cut off, damaged, or of an unsupported kind</source>
        <translation>die DICOM-Pixel können nicht dekodiert werden: abgeschnitten, beschädigt oder von nicht unterstützter Art</translation>
    </message>
    <message>
        <source>is DICOM compressed by gzip; unpack it first</source>
        <translation>ist mit gzip gepacktes DICOM; es zuerst entpacken</translation>
    </message>
    <message>
        <source>is no DICOM file, or cut off or damaged: its elements do not fit together</source>
        <translation>ist keine DICOM-Datei, abgeschnitten oder beschädigt: die Elemente passen nicht zusammen</translation>
    </message>
    <message>
        <source>is damaged, or no DICOM file</source>
        <translation>ist beschädigt oder keine DICOM-Datei</translation>
    </message>
    <message>
        <source>is a DICOM segmentation; open it as labels</source>
        <translation>ist eine DICOM-Segmentierung; sie als Labels öffnen</translation>
    </message>
    <message>
        <source>is a DICOM structure set; open it as labels</source>
        <translation>ist ein DICOM-Structure-Set; es als Labels öffnen</translation>
    </message>
    <message>
        <source>holds no image (DICOM modality %1)</source>
        <translation>enthält kein Bild (DICOM-Modalität %1)</translation>
    </message>
    <message>
        <source>its number of frames is not possible</source>
        <translation>die Zahl der Einzelbilder ist nicht möglich</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images</source>
        <translation>der Ordner enthält keine DICOM-Bilder</translation>
    </message>
    <message>
        <source>holds no DICOM series %1</source>
        <translation>enthält keine DICOM-Serie %1</translation>
    </message>
    <message>
        <source>the folder holds %1 DICOM series; %2 was taken</source>
        <translation>der Ordner enthält %1 DICOM-Serien; %2 wurde genommen</translation>
    </message>
    <message>
        <source>the largest</source>
        <translation>die größte</translation>
    </message>
    <message>
        <source>the slice has %1 x %2 pixels, the others of its series %3 x %4</source>
        <translation>die Schicht hat %1 x %2 Pixel, die anderen der Serie %3 x %4</translation>
    </message>
    <message>
        <source>%1 images of another orientation were left out</source>
        <translation>%1 Bilder anderer Ausrichtung wurden weggelassen</translation>
    </message>
    <message>
        <source>slices differ in unit (%1); the volume has none</source>
        <translation>die Schichten haben verschiedene Einheiten (%1); das Volumen hat keine</translation>
    </message>
    <message>
        <source>its %1 slices lie too far apart for a volume of this size</source>
        <translation>die %1 Schichten liegen für ein Volumen dieser Größe zu weit auseinander</translation>
    </message>
    <message>
        <source>distances between slices run from %1 to %2 mm (%3 slices); resampled onto %4 slices %5 mm apart</source>
        <translation>die Abstände der Schichten reichen von %1 bis %2 mm (%3 Schichten); umgerechnet auf %4 Schichten im Abstand von %5 mm</translation>
    </message>
    <message>
        <source>, %1 missing ones filled in linearly</source>
        <translation>, %1 fehlende linear ergänzt</translation>
    </message>
    <message>
        <source>, %1 left empty where slices are more than %2 mm apart</source>
        <translation>, %1 leer gelassen, wo Schichten mehr als %2 mm auseinanderliegen</translation>
    </message>
    <message>
        <source>planes are missing: %1 of %2 are there, %3 mm apart</source>
        <translation>Ebenen fehlen: %1 von %2 sind da, im Abstand von %3 mm</translation>
    </message>
    <message>
        <source>the slices are stacked %1 degrees off their normal (gantry tilt); the volume is sheared accordingly</source>
        <translation>die Schichten sind %1 Grad schräg zu ihrer Normalen gestapelt (Gantry-Kippung); das Volumen ist entsprechend geschert</translation>
    </message>
    <message>
        <source>the slices have no position; they are stacked by number, %1 mm apart</source>
        <translation>die Schichten haben keinen Ort; sie sind nach Nummer gestapelt, im Abstand von %1 mm</translation>
    </message>
    <message>
        <source>%1 images repeat the place of another and were left out</source>
        <translation>%1 Bilder wiederholen den Ort eines anderen und wurden weggelassen</translation>
    </message>
    <message>
        <source>its %1 is damaged: it is not described by three numbers of which the last is 8 to 16 bits</source>
        <translation>%1 ist beschädigt: nicht durch drei Zahlen beschrieben, deren letzte 8 bis 16 Bit ist</translation>
    </message>
    <message>
        <source>its %1 is cut off: %2 words for %3 entries</source>
        <translation>%1 ist abgeschnitten: %2 Wörter für %3 Einträge</translation>
    </message>
    <message>
        <source>its palette comes in segments, which is not supported</source>
        <translation>die Palette ist in Abschnitten gespeichert, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>its palette is damaged: red, green and blue differ in length</source>
        <translation>die Palette ist beschädigt: Rot, Grün und Blau sind verschieden lang</translation>
    </message>
    <message>
        <source>its grid frame offsets are damaged: %1 for %2 planes</source>
        <translation>die grid frame offsets sind beschädigt: %1 für %2 Ebenen</translation>
    </message>
    <message>
        <source>the offsets of the dose&apos;s planes begin at %1 mm and not at 0; they are taken from there</source>
        <translation>die Lagen der Dosisebenen beginnen bei %1 mm und nicht bei 0; sie sind von dort gezählt</translation>
    </message>
    <message>
        <source>its header has a line %1 without &apos;=&apos;</source>
        <translation>der Dateikopf hat eine Zeile %1 ohne „=“</translation>
    </message>
    <message>
        <source>its header has no ElementDataFile</source>
        <translation>dem Dateikopf fehlt ElementDataFile</translation>
    </message>
    <message>
        <source>a DimSize of %1 is not possible</source>
        <translation>eine DimSize von %1 ist nicht möglich</translation>
    </message>
    <message>
        <source>a HeaderSize of %1 is not legal</source>
        <translation>eine HeaderSize von %1 ist nicht erlaubt</translation>
    </message>
    <message>
        <source>the header asks for %1 bytes of data, the file has %2</source>
        <translation>der Dateikopf verlangt %1 Bytes Daten, die Datei hat %2</translation>
    </message>
    <message>
        <source>%1 dimensions are not supported</source>
        <translation>%1 Dimensionen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>the slices are frames of a tracked sweep, not planes of one volume</source>
        <translation>die Schichten sind Bilder einer geführten Bewegung, nicht Ebenen eines Volumens</translation>
    </message>
    <message>
        <source>MRC mode %1 is not supported; 0, 1, 2 and 6 are</source>
        <translation>MRC-Modus %1 wird nicht unterstützt; 0, 1, 2 und 6 schon</translation>
    </message>
    <message>
        <source>is too short for an MRC header</source>
        <translation>ist zu kurz für den Dateikopf von MRC</translation>
    </message>
    <message>
        <source>an extended header of %1 bytes is not possible</source>
        <translation>ein erweiterter Kopf von %1 Bytes ist nicht möglich</translation>
    </message>
    <message>
        <source>is one half of a pair, and its .img file is missing</source>
        <translation>ist die Hälfte eines Paars, die .img-Datei fehlt</translation>
    </message>
    <message>
        <source>is one half of a pair, and its .hdr file is missing</source>
        <translation>ist die Hälfte eines Paars, die .hdr-Datei fehlt</translation>
    </message>
    <message>
        <source>voxels of NIfTI data type %1 are not %2</source>
        <translation>Voxel vom NIfTI-Datentyp %1 sind nicht %2</translation>
    </message>
    <message>
        <source>%1 dimensions are not possible</source>
        <translation>%1 Dimensionen sind nicht möglich</translation>
    </message>
    <message>
        <source>has more than five dimensions, which is not supported</source>
        <translation>hat mehr als fünf Dimensionen, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>has colour vectors, which are not supported</source>
        <translation>hat Farbvektoren, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>%1 samples per voxel are not possible</source>
        <translation>%1 Werte je Voxel sind nicht möglich</translation>
    </message>
    <message>
        <source>the file&apos;s sform matrix is singular and was left out</source>
        <translation>die sform-Matrix der Datei ist singulär und wurde weggelassen</translation>
    </message>
    <message>
        <source>is too short for a NIfTI header</source>
        <translation>ist zu kurz für den Dateikopf von NIfTI</translation>
    </message>
    <message>
        <source>is not a NIfTI file</source>
        <translation>ist keine NIfTI-Datei</translation>
    </message>
    <message>
        <source>has no NIfTI magic, but %1</source>
        <translation>hat nicht das Kennzeichen von NIfTI, sondern %1</translation>
    </message>
    <message>
        <source>the data cannot start at byte %1</source>
        <translation>die Daten können nicht bei Byte %1 beginnen</translation>
    </message>
    <message>
        <source>Writing NIfTI</source>
        <translation>NIfTI wird geschrieben</translation>
    </message>
    <message>
        <source>the name %1 is left out: NIfTI has no place for it</source>
        <translation>der Name %1 ist weggelassen: NIfTI hat keinen Platz dafür</translation>
    </message>
    <message>
        <source>the unit of values, %1, is left out: NIfTI has no place for it</source>
        <translation>die Einheit der Werte, %1, ist weggelassen: NIfTI hat keinen Platz dafür</translation>
    </message>
    <message>
        <source>that it is %1 is left out: NIfTI has no place for it</source>
        <translation>dass es %1 ist, ist weggelassen: NIfTI hat keinen Platz dafür</translation>
    </message>
    <message>
        <source>the names of channels are left out: NIfTI has no place for them</source>
        <translation>die Namen der Kanäle sind weggelassen: NIfTI hat keinen Platz dafür</translation>
    </message>
    <message>
        <source>colours are left as %1 values of a voxel: NIfTI has colours of 8 bits only</source>
        <translation>Farben bleiben %1 Werte je Voxel: NIfTI hat nur Farben mit 8 Bit</translation>
    </message>
    <message>
        <source>lengths are written in um: NIfTI knows no angstrom</source>
        <translation>Längen sind in µm geschrieben: NIfTI kennt kein Ångström</translation>
    </message>
    <message>
        <source>places are kept as floats, which puts voxels off by %1 of their size</source>
        <translation>Orte sind als float gespeichert, was Voxel um %1 ihrer Größe verschiebt</translation>
    </message>
    <message>
        <source>scale and offset are kept as floats, which changes values by up to %1</source>
        <translation>Maßstab und Verschiebung sind als float gespeichert, was Werte um bis zu %1 ändert</translation>
    </message>
    <message>
        <source>NIfTI is written as .nii or .nii.gz</source>
        <translation>NIfTI wird als .nii oder .nii.gz geschrieben</translation>
    </message>
    <message>
        <source>its header has a line %1 without a colon</source>
        <translation>der Dateikopf hat eine Zeile %1 ohne Doppelpunkt</translation>
    </message>
    <message>
        <source>is not a NRRD file</source>
        <translation>ist keine NRRD-Datei</translation>
    </message>
    <message>
        <source>its header ends in the first line</source>
        <translation>der Dateikopf endet in der ersten Zeile</translation>
    </message>
    <message>
        <source>its header has no end</source>
        <translation>der Dateikopf hat kein Ende</translation>
    </message>
    <message>
        <source>a dimension of %1 is not possible</source>
        <translation>eine Dimension von %1 ist nicht möglich</translation>
    </message>
    <message>
        <source>has %1 sizes for %2 dimensions</source>
        <translation>hat %1 Größen für %2 Dimensionen</translation>
    </message>
    <message>
        <source>has a wrong number of space directions</source>
        <translation>hat eine falsche Zahl von Raumrichtungen</translation>
    </message>
    <message>
        <source>a size of %1 is not possible</source>
        <translation>eine Größe von %1 ist nicht möglich</translation>
    </message>
    <message>
        <source>has an axis between those of space, which is not supported</source>
        <translation>hat eine Achse zwischen denen des Raums, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>has fewer than two dimensions of space</source>
        <translation>hat weniger als zwei Raumdimensionen</translation>
    </message>
    <message>
        <source>samples of type %1 are not supported</source>
        <translation>Werte vom Typ %1 werden nicht unterstützt</translation>
    </message>
    <message>
        <source>the sizes are too large</source>
        <translation>die Größen sind zu groß</translation>
    </message>
    <message>
        <source>does not say its byte order: &apos;endian: little&apos; or &apos;endian: big&apos; is missing%1</source>
        <translation>nennt die Bytefolge nicht: „endian: little“ oder „endian: big“ fehlt%1</translation>
    </message>
    <message>
        <source>, it has %1</source>
        <translation>, hat %1</translation>
    </message>
    <message>
        <source>the encoding %1 is not supported; raw, gzip and ascii are</source>
        <translation>die Kodierung %1 wird nicht unterstützt; raw, gzip und ascii schon</translation>
    </message>
    <message>
        <source>has fewer lines than its line skip</source>
        <translation>hat weniger Zeilen als line skip</translation>
    </message>
    <message>
        <source>a line skip of %1 is not legal</source>
        <translation>ein line skip von %1 ist nicht erlaubt</translation>
    </message>
    <message>
        <source>a byte skip of %1 is not legal</source>
        <translation>ein byte skip von %1 ist nicht erlaubt</translation>
    </message>
    <message>
        <source>detached NRRD headers are not written; use .nrrd</source>
        <translation>NRRD mit getrenntem Dateikopf wird nicht geschrieben; .nrrd verwenden</translation>
    </message>
    <message>
        <source>NRRD has no scale: other programs read stored samples, of which a value is %1 times one plus %2</source>
        <translation>NRRD kennt keinen Maßstab: andere Programme lesen gespeicherte Zahlen, ein Wert ist das %1-Fache plus %2</translation>
    </message>
    <message>
        <source>the name is written in one line: NRRD has no other</source>
        <translation>der Name ist in einer Zeile geschrieben: mehr hat NRRD nicht</translation>
    </message>
    <message>
        <source>tiles of %1 x %2 make no sense</source>
        <translation>Kacheln von %1 x %2 sind unsinnig</translation>
    </message>
    <message>
        <source>Looking at the file</source>
        <translation>Datei wird untersucht</translation>
    </message>
    <message>
        <source>is compressed; it has no preview</source>
        <translation>ist komprimiert; davon gibt es keine Vorschau</translation>
    </message>
    <message>
        <source>ends before this plane</source>
        <translation>endet vor dieser Ebene</translation>
    </message>
    <message>
        <source>give its size, sample type, byte order and header length (raw.dims, raw.type, raw.bigEndian, raw.headerBytes)</source>
        <translation>Größe, Typ der Werte, Bytefolge und Länge des Dateikopfs angeben (raw.dims, raw.type, raw.bigEndian, raw.headerBytes)</translation>
    </message>
    <message>
        <source>the layout given needs %1 bytes, header included, but the file has %2</source>
        <translation>die angegebene Anordnung braucht mit Dateikopf %1 Bytes, die Datei hat aber %2</translation>
    </message>
    <message>
        <source>a file without a header: %1</source>
        <translation>eine Datei ohne Dateikopf: %1</translation>
    </message>
    <message>
        <source>raw.channels %1 or raw.headerBytes %2 makes no sense</source>
        <translation>raw.channels %1 oder raw.headerBytes %2 ist unsinnig</translation>
    </message>
    <message>
        <source>the layout given needs %1 slices, but the folder has %2 files</source>
        <translation>die angegebene Anordnung braucht %1 Schichten, der Ordner hat aber %2 Dateien</translation>
    </message>
    <message>
        <source>its level %1 has %2 GB of voxels, and %3 GB are the most that is read whole; velum-batch convert makes a store with coarser levels of it</source>
        <translation>Stufe %1 hat %2 GB Voxel, höchstens %3 GB werden im Ganzen gelesen; velum-batch convert macht daraus einen Datenspeicher mit gröberen Stufen</translation>
    </message>
    <message>
        <source>level %1 of 0 to %2, %3 voxels</source>
        <translation>Stufe %1 von 0 bis %2, %3 Voxel</translation>
    </message>
    <message>
        <source>streamed: pictures, sections and what grows have up to %1 voxels; what works on all voxels at once works on %2</source>
        <translation>gestreamt: Bilder, Schnittbilder und Wachsen haben bis zu %1 Voxel; was auf allen Voxeln zugleich arbeitet, arbeitet auf %2</translation>
    </message>
    <message>
        <source>%1, were read; the finest has %2</source>
        <translation>%1, wurde gelesen; die feinste hat %2</translation>
    </message>
    <message>
        <source>the file does not say where its coarser levels lie; they were taken as means of blocks, border on border</source>
        <translation>die Datei sagt nicht, wo die gröberen Stufen liegen; sie wurden als Mittel von Blöcken genommen, Rand auf Rand</translation>
    </message>
    <message>
        <source>neither the folder nor one below it holds a DICOM series, and it holds no TIFF or PNG planes; for headerless slices give their size and type</source>
        <translation>weder der Ordner noch einer darunter enthält eine DICOM-Serie, und er enthält keine Ebenen in TIFF oder PNG; für Schichten ohne Dateikopf Größe und Typ angeben</translation>
    </message>
    <message>
        <source>is empty or cannot be read</source>
        <translation>ist leer oder nicht lesbar</translation>
    </message>
    <message>
        <source>is a ZIP archive; unpack it first</source>
        <translation>ist ein ZIP-Archiv; es zuerst entpacken</translation>
    </message>
    <message>
        <source>is a Git LFS pointer, not the data</source>
        <translation>ist ein Git-LFS-Verweis, nicht die Daten</translation>
    </message>
    <message>
        <source>is a PNG picture; a folder of PNG planes can be read</source>
        <translation>ist ein PNG-Bild; ein Ordner mit PNG-Ebenen ist lesbar</translation>
    </message>
    <message>
        <source>is of no kind that can be read; for headerless samples give their size and type</source>
        <translation>ist von keiner lesbaren Art; für Werte ohne Dateikopf Größe und Typ angeben</translation>
    </message>
    <message>
        <source>it has %1 GB of voxels in one level, and half of the memory, %2 GB, is the most that is read whole; velum-batch convert makes a store of it, which is streamed</source>
        <translation>hat %1 GB Voxel in einer Stufe, höchstens die Hälfte des Speichers, %2 GB, wird im Ganzen gelesen; velum-batch convert macht daraus einen Datenspeicher, der gestreamt wird</translation>
    </message>
    <message>
        <source>has no header; give its size and type</source>
        <translation>hat keinen Dateikopf; Größe und Typ angeben</translation>
    </message>
    <message>
        <source>the traces have no inline and crossline numbers; they are shown as one line in the file&apos;s order</source>
        <translation>die Spuren haben keine Inline- und Crossline-Nummern; sie werden als eine Linie in der Reihenfolge der Datei gezeigt</translation>
    </message>
    <message>
        <source>%1: holds %2 traces as they were shot (gathers before stacking, offsets from %3 to %4); read are stacks with one trace for each inline and crossline (bytes 189/193 or 9/21), and single lines: stack it first</source>
        <translation>%1: enthält %2 Spuren, wie sie geschossen wurden (Gather vor dem Stapeln, Offsets von %3 bis %4); gelesen werden Stapel mit einer Spur je Inline und Crossline (Bytes 189/193 oder 9/21) und einzelne Linien: zuerst stapeln</translation>
    </message>
    <message>
        <source>%1: has no traces</source>
        <translation>%1: hat keine Spuren</translation>
    </message>
    <message>
        <source>%1: %2 traces are too few for a grid of %3 inlines by %4 crosslines; the line numbers are not in bytes 189/193 or 9/21</source>
        <translation>%1: %2 Spuren sind zu wenige für ein Gitter von %3 Inlines mal %4 Crosslines; die Liniennummern stehen nicht in den Bytes 189/193 oder 9/21</translation>
    </message>
    <message>
        <source>the file is prestack: </source>
        <translation>die Datei ist ungestapelt: </translation>
    </message>
    <message>
        <source>the first offset is shown</source>
        <translation>der erste Offset wird gezeigt</translation>
    </message>
    <message>
        <source>that one is shown</source>
        <translation>jene wird gezeigt</translation>
    </message>
    <message>
        <source>%1 of %2 traces are missing and shown as 0</source>
        <translation>%1 von %2 Spuren fehlen und werden als 0 gezeigt</translation>
    </message>
    <message>
        <source>the file holds a single line; it is shown as one plane</source>
        <translation>die Datei enthält eine einzelne Linie; sie wird als eine Ebene gezeigt</translation>
    </message>
    <message>
        <source>has a variable number of extended text headers, of which none says that it is the last</source>
        <translation>hat eine veränderliche Zahl erweiterter Textköpfe, von denen sich keiner den letzten nennt</translation>
    </message>
    <message>
        <source>the %1 extended text headers that it claims are not there</source>
        <translation>die %1 angekündigten erweiterten Textköpfe fehlen</translation>
    </message>
    <message>
        <source>is a Git LFS pointer and not the data; fetch it with &apos;git lfs pull&apos;</source>
        <translation>ist ein Git-LFS-Verweis und nicht die Daten; sie mit „git lfs pull“ holen</translation>
    </message>
    <message>
        <source>is not SEG-Y: %1 bytes are fewer than its headers (%2)</source>
        <translation>ist kein SEG-Y: %1 Bytes sind weniger als die Köpfe (%2)</translation>
    </message>
    <message>
        <source>is not SEG-Y, or of a kind that is not read (sample format %1, %2 samples a trace)</source>
        <translation>ist kein SEG-Y oder von einer Art, die nicht gelesen wird (Format der Werte %1, %2 Werte je Spur)</translation>
    </message>
    <message>
        <source>has headers but no whole trace</source>
        <translation>hat Köpfe, aber keine ganze Spur</translation>
    </message>
    <message>
        <source>has %1 traces; that many are not read</source>
        <translation>hat %1 Spuren; so viele werden nicht gelesen</translation>
    </message>
    <message>
        <source>reading trace headers</source>
        <translation>Köpfe der Spuren werden gelesen</translation>
    </message>
    <message>
        <source>has traces of several lengths (%1 and %2 samples); only files of one are read</source>
        <translation>hat Spuren verschiedener Längen (%1 und %2 Werte); gelesen werden nur Dateien mit einer</translation>
    </message>
    <message>
        <source>%1 of %2 traces claim another length than the file&apos;s %3 samples, which was taken</source>
        <translation>%1 von %2 Spuren nennen eine andere Länge als die %3 Werte der Datei, die genommen wurde</translation>
    </message>
    <message>
        <source>reading traces</source>
        <translation>Spuren werden gelesen</translation>
    </message>
    <message>
        <source>sample interval %1: %2 ms of time shown as %3 m, or %4 m if the file is in depth</source>
        <translation>Abtastintervall %1: %2 ms Zeit als %3 m gezeigt, oder %4 m, falls die Datei in Tiefe ist</translation>
    </message>
    <message>
        <source>reading SEG-Y</source>
        <translation>SEG-Y wird gelesen</translation>
    </message>
    <message>
        <source>the file ends within a trace, which is left out</source>
        <translation>die Datei endet in einer Spur, die weggelassen ist</translation>
    </message>
    <message>
        <source>Reading metadata</source>
        <translation>Metadaten werden gelesen</translation>
    </message>
    <message>
        <source>its coarsest level is too large for a small picture</source>
        <translation>die gröbste Stufe ist zu groß für ein kleines Bild</translation>
    </message>
    <message>
        <source>samples of type &apos;%1&apos; are not read</source>
        <translation>Werte vom Typ „%1“ werden nicht gelesen</translation>
    </message>
    <message>
        <source>a plane of %1 x %2 x %3 pixels is not read</source>
        <translation>eine Ebene von %1 x %2 x %3 Pixeln wird nicht gelesen</translation>
    </message>
    <message>
        <source>cannot be read as a picture (%1)</source>
        <translation>kann nicht als Bild gelesen werden (%1)</translation>
    </message>
    <message>
        <source>page %1 is damaged (%2)</source>
        <translation>Seite %1 ist beschädigt (%2)</translation>
    </message>
    <message>
        <source>reading TIFF pages</source>
        <translation>TIFF-Seiten werden gelesen</translation>
    </message>
    <message>
        <source>page %1 is %2, but the first is %3</source>
        <translation>Seite %1 ist %2, die erste aber %3</translation>
    </message>
    <message>
        <source>the first page cannot be read</source>
        <translation>die erste Seite kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the pages have a colour table; they are read as colours</source>
        <translation>die Seiten haben eine Farbtabelle; sie werden als Farben gelesen</translation>
    </message>
    <message>
        <source>the folder has no .tif or .png planes</source>
        <translation>der Ordner enthält keine Ebenen als .tif oder .png</translation>
    </message>
    <message>
        <source>reading planes</source>
        <translation>Ebenen werden gelesen</translation>
    </message>
    <message>
        <source>a plane of a folder must have one page, this has %1</source>
        <translation>eine Ebene eines Ordners muss eine Seite haben, diese hat %1</translation>
    </message>
    <message>
        <source>the slice is %1, but the first, &apos;%2&apos;, is %3; all slices of a folder must agree</source>
        <translation>die Schicht ist %1, die erste, „%2“, aber %3; alle Schichten eines Ordners müssen gleich sein</translation>
    </message>
    <message>
        <source>reading TIFF</source>
        <translation>TIFF wird gelesen</translation>
    </message>
    <message>
        <source>page %1 is %2 x %3 (%4 samples of %5 bits), but the first is %6 x %7 (%8 of %9); a volume needs pages of one size</source>
        <translation>Seite %1 ist %2 x %3 (%4 Werte zu %5 Bit), die erste aber %6 x %7 (%8 zu %9); ein Volumen braucht gleich große Seiten</translation>
    </message>
    <message>
        <source>the file has thumbnails only</source>
        <translation>die Datei enthält nur Vorschaubilder</translation>
    </message>
    <message>
        <source>the file tells the size of a pixel but not the distance of planes; they are taken as equal</source>
        <translation>die Datei nennt die Größe eines Pixels, aber nicht den Abstand der Ebenen; sie werden als gleich angenommen</translation>
    </message>
    <message>
        <source>%1 x %2, %3 channels, %4</source>
        <translation>%1 x %2, %3 Kanäle, %4</translation>
    </message>
    <message>
        <source>the file is cut short: page %1 is not whole</source>
        <translation>die Datei ist abgeschnitten: Seite %1 ist nicht vollständig</translation>
    </message>
    <message>
        <source>the file is cut short after %1 whole pages</source>
        <translation>die Datei ist nach %1 ganzen Seiten abgeschnitten</translation>
    </message>
    <message>
        <source>the description promises %1 x %2 x %3 planes (z, channels, time), but the file has %4 pages%5</source>
        <translation>die Beschreibung verspricht %1 x %2 x %3 Ebenen (z, Kanäle, Zeit), die Datei hat aber %4 Seiten%5</translation>
    </message>
    <message>
        <source>; the others are in other files</source>
        <translation>; die anderen sind in anderen Dateien</translation>
    </message>
    <message>
        <source> that fit</source>
        <translation>, die passen</translation>
    </message>
    <message>
        <source>a stack of several channels of colours behind one page is not read; save it as OME-TIFF</source>
        <translation>ein Stapel mehrerer Farbkanäle hinter einer Seite wird nicht gelesen; als OME-TIFF speichern</translation>
    </message>
    <message>
        <source>a packed one-page stack is not read</source>
        <translation>ein gepackter Stapel auf einer Seite wird nicht gelesen</translation>
    </message>
    <message>
        <source>the grid&apos;s transform is not linear; resample it first</source>
        <translation>die Transformation des Gitters ist nicht linear; es zuerst umrechnen</translation>
    </message>
    <message>
        <source>the grid has no active voxels</source>
        <translation>das Gitter hat keine aktiven Voxel</translation>
    </message>
    <message>
        <source>the active voxels span %1 x %2 x %3; at most 4096 along an axis and 2 GiB of voxels are read</source>
        <translation>die aktiven Voxel reichen über %1 x %2 x %3; höchstens 4096 je Achse und 2 GiB Voxel werden gelesen</translation>
    </message>
    <message>
        <source>%1 active voxels in a file of %2 bytes span %3 x %4 x %5; at most %6 voxels for each active one, or %7 for each byte, are read. If the file is not damaged, crop the grid</source>
        <translation>%1 aktive Voxel in einer Datei von %2 Bytes reichen über %3 x %4 x %5; höchstens %6 Voxel je aktivem oder %7 je Byte werden gelesen. Ist die Datei nicht beschädigt, das Gitter zuschneiden</translation>
    </message>
    <message>
        <source>an OpenVDB file has no unit; its world units are taken as mm</source>
        <translation>eine OpenVDB-Datei hat keine Einheit; ihre Welteinheiten werden als mm genommen</translation>
    </message>
    <message>
        <source>of %1 grids the first of floats or doubles, %2, was taken</source>
        <translation>von %1 Gittern wurde das erste mit float oder double, %2, genommen</translation>
    </message>
    <message>
        <source>reading OpenVDB</source>
        <translation>OpenVDB wird gelesen</translation>
    </message>
    <message>
        <source>cannot be read by OpenVDB (%1)</source>
        <translation>kann von OpenVDB nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>is damaged, or needs more memory than there is</source>
        <translation>ist beschädigt oder braucht mehr Speicher, als da ist</translation>
    </message>
    <message>
        <source>is damaged (%1)</source>
        <translation>ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>is damaged: %1 (before byte %2 of %3)</source>
        <translation>ist beschädigt: %1 (vor Byte %2 von %3)</translation>
    </message>
    <message>
        <source>it ends before its grid does</source>
        <translation>sie endet vor ihrem Gitter</translation>
    </message>
    <message>
        <source>it has become shorter</source>
        <translation>sie ist kürzer geworden</translation>
    </message>
    <message>
        <source>a text of %1 bytes is too long</source>
        <translation>ein Text von %1 Bytes ist zu lang</translation>
    </message>
    <message>
        <source>it ends within a text</source>
        <translation>sie endet in einem Text</translation>
    </message>
    <message>
        <source>its tree has more than one buffer</source>
        <translation>der Baum hat mehr als einen Puffer</translation>
    </message>
    <message>
        <source>a tile is neither active nor inactive</source>
        <translation>eine Kachel ist weder aktiv noch inaktiv</translation>
    </message>
    <message>
        <source>a node lies off its lattice</source>
        <translation>ein Knoten liegt nicht auf seinem Raster</translation>
    </message>
    <message>
        <source>two nodes lie at one place</source>
        <translation>zwei Knoten liegen an einem Ort</translation>
    </message>
    <message>
        <source>a value stands where a node is</source>
        <translation>ein Wert steht, wo ein Knoten ist</translation>
    </message>
    <message>
        <source>a leaf has more than one buffer</source>
        <translation>ein Blatt hat mehr als einen Puffer</translation>
    </message>
    <message>
        <source>values are packed in an unknown way, %1</source>
        <translation>Werte sind auf unbekannte Weise gepackt, %1</translation>
    </message>
    <message>
        <source>a block of %1 bytes has %2</source>
        <translation>ein Block von %1 Bytes hat %2</translation>
    </message>
    <message>
        <source>a block of %1 bytes is longer than the file</source>
        <translation>ein Block von %1 Bytes ist länger als die Datei</translation>
    </message>
    <message>
        <source>a block of %1 bytes says that it has %2 of %3</source>
        <translation>ein Block von %1 Bytes nennt %2 von %3</translation>
    </message>
    <message>
        <source>its grid&apos;s transform %1 is not linear, or not known</source>
        <translation>die Transformation %1 des Gitters ist nicht linear oder nicht bekannt</translation>
    </message>
    <message>
        <source>is not an OpenVDB file</source>
        <translation>ist keine OpenVDB-Datei</translation>
    </message>
    <message>
        <source>is an OpenVDB file of version %1; %2 to %3 are read</source>
        <translation>ist eine OpenVDB-Datei der Version %1; gelesen werden %2 bis %3</translation>
    </message>
    <message>
        <source>its first grid is a %1, which is not read</source>
        <translation>das erste Gitter ist ein %1, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>a grid ends before it begins</source>
        <translation>ein Gitter endet, bevor es beginnt</translation>
    </message>
    <message>
        <source>a compression %1 is not known</source>
        <translation>eine Kompression %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>its grid ends here and should at byte %1</source>
        <translation>das Gitter endet hier und sollte bei Byte %1 enden</translation>
    </message>
    <message>
        <source>has no grid of floats or doubles (it has: %1)</source>
        <translation>hat kein Gitter mit float oder double (vorhanden: %1)</translation>
    </message>
    <message>
        <source>writing OpenVDB</source>
        <translation>OpenVDB wird geschrieben</translation>
    </message>
    <message>
        <source>a .vdb of ours holds one channel and one time step, not %1 and %2</source>
        <translation>ein .vdb von Velum enthält einen Kanal und einen Zeitschritt, nicht %1 und %2</translation>
    </message>
    <message>
        <source>lengths are written in angstrom: OpenVDB takes so small voxels in mm for none</source>
        <translation>Längen sind in Ångström geschrieben: so kleine Voxel in mm gelten OpenVDB als keine</translation>
    </message>
    <message>
        <source>the name of the channel is left out: OpenVDB has no place for it</source>
        <translation>der Name des Kanals ist weggelassen: OpenVDB hat keinen Platz dafür</translation>
    </message>
    <message>
        <source>an extent of %1 makes no sense</source>
        <translation>eine Ausdehnung von %1 ist unsinnig</translation>
    </message>
    <message>
        <source>is damaged: a piece lies outside the image</source>
        <translation>ist beschädigt: ein Teil liegt außerhalb des Bildes</translation>
    </message>
    <message>
        <source>is damaged: its pieces have values of different types</source>
        <translation>ist beschädigt: die Teile haben Werte verschiedener Typen</translation>
    </message>
    <message>
        <source>%1 values make no sense</source>
        <translation>%1 Werte sind unsinnig</translation>
    </message>
    <message>
        <source>is damaged: its pieces do not fill the image</source>
        <translation>ist beschädigt: die Teile füllen das Bild nicht</translation>
    </message>
    <message>
        <source>reading VTK image</source>
        <translation>VTK-Bild wird gelesen</translation>
    </message>
    <message>
        <source>has no array of values</source>
        <translation>hat kein Feld mit Werten</translation>
    </message>
    <message>
        <source>the values stand in cells; each cell is taken as a voxel</source>
        <translation>die Werte stehen in Zellen; jede Zelle gilt als ein Voxel</translation>
    </message>
    <message>
        <source>64-bit integers are read as doubles</source>
        <translation>ganze Zahlen mit 64 Bit werden als double gelesen</translation>
    </message>
    <message>
        <source>a .vti holds one time step, not %1; write .nrrd or .nii</source>
        <translation>ein .vti enthält einen Zeitschritt, nicht %1; .nrrd oder .nii schreiben</translation>
    </message>
    <message>
        <source>writing VTK image</source>
        <translation>VTK-Bild wird geschrieben</translation>
    </message>
    <message>
        <source>.vti has no scale: other programs read stored samples, of which a value is %1 times one plus %2</source>
        <translation>.vti kennt keinen Maßstab: andere Programme lesen gespeicherte Zahlen, ein Wert ist das %1-Fache plus %2</translation>
    </message>
    <message>
        <source>lengths are written in mm: .vti has no unit of length for other programs</source>
        <translation>Längen sind in mm geschrieben: .vti hat für andere Programme keine Längeneinheit</translation>
    </message>
    <message>
        <source>is not a legacy VTK file</source>
        <translation>ist keine VTK-Datei der alten Art</translation>
    </message>
    <message>
        <source>an encoding &apos;%1&apos; is not known</source>
        <translation>eine Kodierung „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>holds a &apos;%1&apos;, not STRUCTURED_POINTS</source>
        <translation>enthält „%1“, nicht STRUCTURED_POINTS</translation>
    </message>
    <message>
        <source>has no SCALARS to show</source>
        <translation>hat keine SCALARS zum Zeigen</translation>
    </message>
    <message>
        <source>reading numbers</source>
        <translation>Zahlen werden gelesen</translation>
    </message>
    <message>
        <source>reading VTK structured points</source>
        <translation>VTK-Punktgitter wird gelesen</translation>
    </message>
    <message>
        <source>dimension %1, spacing %2 or origin %3 makes no sense</source>
        <translation>Dimension %1, Abstand %2 oder Ursprung %3 ist unsinnig</translation>
    </message>
    <message>
        <source>an empty volume cannot be written</source>
        <translation>ein leeres Volumen kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>volumes are written as %1</source>
        <translation>Volumen werden als %1 geschrieben</translation>
    </message>
    <message>
        <source>a lattice needs one node along each axis</source>
        <translation>ein Gitter braucht entlang jeder Achse einen Knoten</translation>
    </message>
    <message>
        <source>a lattice of %1 layers is too high</source>
        <translation>ein Gitter von %1 Lagen ist zu hoch</translation>
    </message>
    <message>
        <source>measuring gradients</source>
        <translation>Gradienten werden gemessen</translation>
    </message>
    <message>
        <source>looking where types are dense</source>
        <translation>dichte Typen werden gesucht</translation>
    </message>
    <message>
        <source>taking noise out</source>
        <translation>Rauschen wird entfernt</translation>
    </message>
    <message>
        <source>looking for specks</source>
        <translation>Flecken werden gesucht</translation>
    </message>
    <message>
        <source>the box of voxels leaves the volume</source>
        <translation>der Quader von Voxeln ragt aus dem Volumen</translation>
    </message>
    <message>
        <source>evaluating forces</source>
        <translation>Kräfte werden berechnet</translation>
    </message>
    <message>
        <source>a lattice for the least cut needs two layers at least</source>
        <translation>ein Gitter für den kleinsten Schnitt braucht mindestens zwei Lagen</translation>
    </message>
    <message>
        <source>the rest plane at layer %1 lies outside the lattice</source>
        <translation>die Ruheebene in Lage %1 liegt außerhalb des Gitters</translation>
    </message>
    <message>
        <source>finding the least cut</source>
        <translation>kleinster Schnitt wird gesucht</translation>
    </message>
    <message>
        <source>too few nodes in the mask of a lattice</source>
        <translation>zu wenige Knoten in der Maske eines Gitters</translation>
    </message>
    <message>
        <source>a sheet&apos;s columns do not match the lattice</source>
        <translation>die Spalten eines Tuchs passen nicht zum Gitter</translation>
    </message>
    <message>
        <source>what membranes protect</source>
        <translation>was Membranen schützen</translation>
    </message>
    <message>
        <source>levels of detail</source>
        <translation>Detailstufen</translation>
    </message>
    <message>
        <source>what becomes of each instance</source>
        <translation>was aus jeder Instanz wird</translation>
    </message>
    <message>
        <source>following rays</source>
        <translation>Strahlen werden verfolgt</translation>
    </message>
    <message>
        <source>%1 instances are too many for this driver; %2 are the most: leave out what completes the model</source>
        <translation>%1 Instanzen sind zu viele für diesen Treiber; höchstens %2 gehen: weglassen, was das Modell ergänzt</translation>
    </message>
    <message>
        <source>%1 %2 could not be read and %3 seen coarse: %4</source>
        <translation>%1 %2 nicht lesbar und nur grob zu sehen: %4</translation>
    </message>
    <message>
        <source>%1shown %2 times coarser than pixels: the %3 bricks that are seen have no room in %4 MiB; Preferences &gt; Memory or --gpu-brick-memory gives more</source>
        <translation>%1%2-mal gröber als Pixel gezeigt: die %3 sichtbaren Blöcke haben in %4 MiB keinen Platz; mehr gibt Einstellungen &gt; Speicher oder --gpu-brick-memory</translation>
    </message>
    <message>
        <source>the driver&apos;s memory has no room for the borders of the structures; hide the labels</source>
        <translation>der Speicher des Treibers hat keinen Platz für die Ränder der Strukturen; die Labels ausblenden</translation>
    </message>
    <message>
        <source>structures are drawn %1 times coarser than they are: their borders have no room in %2 MiB</source>
        <translation>Strukturen werden %1-mal gröber gezeichnet, als sie sind: ihre Ränder haben in %2 MiB keinen Platz</translation>
    </message>
    <message>
        <source>the labels (%1 x %2 x %3) are larger than the driver&apos;s 3D textures (%4) or memory; crop or reduce them</source>
        <translation>die Labels (%1 x %2 x %3) sind größer als die 3D-Texturen (%4) oder der Speicher des Treibers; sie zuschneiden oder verkleinern</translation>
    </message>
    <message>
        <source>not as smooth as asked for: that takes more than %1 MiB or %2 texels along a side</source>
        <translation>nicht so glatt wie verlangt: das braucht mehr als %1 MiB oder %2 Texel entlang einer Seite</translation>
    </message>
    <message>
        <source>shown at 1/%1 of its resolution (%2 x %3 x %4 of %5 x %6 x %7 voxels): %8</source>
        <translation>mit 1/%1 der Auflösung gezeigt (%2 x %3 x %4 von %5 x %6 x %7 Voxeln): %8</translation>
    </message>
    <message>
        <source>the driver&apos;s 3D textures end at %1 texels</source>
        <translation>die 3D-Texturen des Treibers enden bei %1 Texeln</translation>
    </message>
    <message>
        <source>a scene holds %1 captions at most; remove one first</source>
        <translation>eine Szene enthält höchstens %1 Bildtexte; zuerst einen entfernen</translation>
    </message>
    <message>
        <source>%1 copies of %2 instances are drawn as a crowd, in which instances have no numbers: %3 can be had of up to %4 copies</source>
        <translation>%1 Kopien von %2 Instanzen werden als Menge gezeichnet, in der Instanzen keine Nummern haben: %3 gibt es bis %4 Kopien</translation>
    </message>
    <message>
        <source>the window &apos;%1&apos; is in %2, the values are %3; give level and width instead</source>
        <translation>das Grauwertfenster „%1“ ist in %2, die Werte sind %3; stattdessen Mitte und Breite angeben</translation>
    </message>
    <message>
        <source>of no known unit</source>
        <translation>ohne bekannte Einheit</translation>
    </message>
    <message>
        <source>a picture of a lit sphere is empty</source>
        <translation>das Bild einer Lichtkugel ist leer</translation>
    </message>
    <message>
        <source>a scene holds %1 marks at most; remove one first</source>
        <translation>eine Szene enthält höchstens %1 Marken; zuerst eine entfernen</translation>
    </message>
    <message>
        <source>a mark of the kind %1 has %2 points, not %3</source>
        <translation>eine Marke der Art %1 hat %2 Punkte, nicht %3</translation>
    </message>
    <message>
        <source>a mark of the kind %1 has %2 to %3 points, not %4</source>
        <translation>eine Marke der Art %1 hat %2 bis %3 Punkte, nicht %4</translation>
    </message>
    <message>
        <source>The file says of no type what it does, so that all are grey: choose the palette by type or by compartment</source>
        <translation>Die Datei sagt bei keinem Typ, was er tut, deshalb sind alle grau: die Palette nach Typ oder nach Kompartiment wählen</translation>
    </message>
    <message>
        <source>no %1 &apos;%2&apos;%3; there are %4</source>
        <translation>%1 „%2“ gibt es nicht%3; es gibt: %4</translation>
    </message>
    <message>
        <source>a picture of paper is empty</source>
        <translation>das Bild eines Papiers ist leer</translation>
    </message>
    <message>
        <source>a scene holds %1 cuts at most; remove one first</source>
        <translation>eine Szene enthält höchstens %1 Schnitte; zuerst einen entfernen</translation>
    </message>
    <message>
        <source>Level of a pyramid, 0 the finest; -1: the finest that fits into memory.</source>
        <translation>Stufe einer Pyramide, 0 die feinste; -1: die feinste, die in den Speicher passt.</translation>
    </message>
    <message>
        <source>scene: the text is not a JSON object</source>
        <translation>Szene: der Text ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>journal: a change is not a list of add, replace and remove</source>
        <translation>Verlauf: eine Änderung ist keine Liste von add, replace und remove</translation>
    </message>
    <message>
        <source>journal: a change does not fit: %1</source>
        <translation>Verlauf: eine Änderung passt nicht: %1</translation>
    </message>
    <message>
        <source>journal: a change leaves no scene</source>
        <translation>Verlauf: eine Änderung lässt keine Szene übrig</translation>
    </message>
    <message>
        <source>%1: there is no part &apos;%2&apos;</source>
        <translation>%1: einen Teil „%2“ gibt es nicht</translation>
    </message>
    <message>
        <source>scene: %1: %2</source>
        <translation>Szene: %1: %2</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> und %1 weitere</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>erwartet wird eine Zahl</translation>
    </message>
    <message>
        <source>the number is not finite</source>
        <translation>die Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>%1 is outside %2 .. %3%4%5</source>
        <translation>%1 liegt außerhalb von %2 bis %3%4%5</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>expected an object</source>
        <translation>erwartet wird ein Objekt</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>erwartet wird true oder false</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>erwartet wird ein Text</translation>
    </message>
    <message>
        <source>expected a word</source>
        <translation>erwartet wird ein Wort</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of %2</source>
        <translation>„%1“ ist keines von %2</translation>
    </message>
    <message>
        <source>expected %1 numbers</source>
        <translation>erwartet werden %1 Zahlen</translation>
    </message>
    <message>
        <source>expected a list</source>
        <translation>erwartet wird eine Liste</translation>
    </message>
    <message>
        <source>the list has %1 items; %2 is the most</source>
        <translation>die Liste hat %1 Einträge; höchstens %2 sind möglich</translation>
    </message>
    <message>
        <source>no field &apos;%1&apos; in %2%3; there are %4</source>
        <translation>ein Feld „%1“ gibt es nicht in %2%3; es gibt: %4</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>einer Szene</translation>
    </message>
    <message>
        <source>%1 has %2 items, and more it cannot have</source>
        <translation>%1 hat %2 Einträge, mehr gehen nicht</translation>
    </message>
    <message>
        <source>%1 has no part &apos;%2&apos;</source>
        <translation>%1 hat keinen Teil „%2“</translation>
    </message>
    <message>
        <source>%1 has %2 items; &apos;%3&apos; is none of them (use + to append, * for each)</source>
        <translation>%1 hat %2 Einträge; „%3“ ist keiner davon (+ hängt an, * nimmt jeden)</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <source>any value</source>
        <translation>irgendein Wert</translation>
    </message>
    <message>
        <source>list of %1</source>
        <translation>Liste von %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>%1brackets are nested deeper than in any scene</source>
        <translation>%1Klammern sind tiefer verschachtelt als in jeder Szene</translation>
    </message>
    <message>
        <source>%1the text is no JSON; %2</source>
        <translation>%1der Text ist kein JSON; %2</translation>
    </message>
    <message>
        <source>%1the text is not a JSON object; the file is damaged or of another kind</source>
        <translation>%1der Text ist kein JSON-Objekt; die Datei ist beschädigt oder von anderer Art</translation>
    </message>
    <message>
        <source>scene: no &quot;velum&quot; version number; this is not a scene of ours</source>
        <translation>Szene: keine Versionsnummer „velum“; dies ist keine Szene von Velum</translation>
    </message>
    <message>
        <source>scene: written by a newer Velum (scene version %1, this one reads up to %2); update Velum</source>
        <translation>Szene: von einem neueren Velum geschrieben (Szenenversion %1, dieses liest bis %2); Velum aktualisieren</translation>
    </message>
    <message>
        <source>no &quot;velumTransfer&quot; version number; this is not a transfer function of ours, or it is damaged</source>
        <translation>keine Versionsnummer „velumTransfer“; dies ist keine Transferfunktion von Velum oder beschädigt</translation>
    </message>
    <message>
        <source>written by a newer Velum (transfer version %1, this one reads up to %2); update Velum</source>
        <translation>von einem neueren Velum geschrieben (Transferversion %1, dieses liest bis %2); Velum aktualisieren</translation>
    </message>
    <message>
        <source>%1%2: expected %3[NAME] or %4[NAME].FIELD</source>
        <translation>%1%2: erwartet wird %3[NAME] oder %4[NAME].FELD</translation>
    </message>
    <message>
        <source>%1 has nothing that is called &apos;%2&apos;; there %3 %4</source>
        <translation>%1 enthält nichts, was „%2“ heißt; es gibt: %4</translation>
    </message>
    <message>
        <source>%1: %2 items are called &apos;%3&apos;: %4; say which by its id or its place</source>
        <translation>%1: %2 Einträge heißen „%3“: %4; mit Nummer oder Platz angeben, welcher gemeint ist</translation>
    </message>
    <message>
        <source>%1 has %2 items; &apos;%3&apos; is none of them (use * for each)</source>
        <translation>%1 hat %2 Einträge; „%3“ ist keiner davon (* nimmt jeden)</translation>
    </message>
    <message>
        <source>%1 is not there: it is null</source>
        <translation>%1 gibt es nicht: es ist null</translation>
    </message>
    <message>
        <source>cuts.%1.membrane: the cut is a %2; say cuts.%3.shape=membrane first</source>
        <translation>cuts.%1.membrane: der Schnitt ist %2; zuerst cuts.%3.shape=membrane setzen</translation>
    </message>
    <message>
        <source>%1 Unit: %2.</source>
        <translation>%1 Einheit: %2.</translation>
    </message>
    <message>
        <source>%1 has %2 items; &apos;%3&apos; is none of them</source>
        <translation>%1 hat %2 Einträge; „%3“ ist keiner davon</translation>
    </message>
    <message>
        <source>%1 cannot change in a film</source>
        <translation>%1 kann sich in einem Film nicht ändern</translation>
    </message>
    <message>
        <source>timeline: %1 has two tracks; they are one now, with the keys of both</source>
        <translation>timeline: %1 hat zwei Spuren; sie sind nun eine, mit den Schlüsselbildern beider</translation>
    </message>
    <message>
        <source>; where both had one at a time, the first one&apos;s stays (left out: %1)</source>
        <translation>; wo beide zur selben Zeit eines hatten, bleibt das der ersten (weggelassen: %1)</translation>
    </message>
    <message>
        <source>; of these only the first %1, more there cannot be</source>
        <translation>; davon nur die ersten %1, mehr gehen nicht</translation>
    </message>
    <message>
        <source>timeline.tracks has %1 items, and more it cannot have</source>
        <translation>timeline.tracks hat %1 Einträge, mehr gehen nicht</translation>
    </message>
    <message>
        <source>the track of %1 has %2 keys, and more it cannot have</source>
        <translation>die Spur von %1 hat %2 Schlüsselbilder, mehr gehen nicht</translation>
    </message>
    <message>
        <source>The machine has no memory left for this; use a smaller volume or picture.</source>
        <translation>Der Rechner hat dafür keinen Speicher mehr; ein kleineres Volumen oder Bild verwenden.</translation>
    </message>
    <message>
        <source>no graphics</source>
        <translation>keine Grafik</translation>
    </message>
    <message>
        <source>%1: there are no more</source>
        <translation>%1: mehr gibt es nicht</translation>
    </message>
    <message>
        <source>%1, not fewer: %2</source>
        <translation>%1, nicht weniger: %2</translation>
    </message>
    <message>
        <source>%1, not more: %2</source>
        <translation>%1, nicht mehr: %2</translation>
    </message>
    <message>
        <source>%1, the nearest to %2: several come and go at once</source>
        <translation>%1, am nächsten zu %2: mehrere kommen und gehen zugleich</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no command%2; velum-batch help lists them</source>
        <translation>„%1“ ist kein Befehl%2; velum-batch help nennt sie alle</translation>
    </message>
    <message>
        <source>no default</source>
        <translation>keine Voreinstellung</translation>
    </message>
    <message>
        <source>%1: a %2 is not closed</source>
        <translation>%1: nicht geschlossen: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is one argument too many for %2</source>
        <translation>„%1“ ist ein Argument zu viel für %2</translation>
    </message>
    <message>
        <source>there is no cut; cut.add adds one</source>
        <translation>es gibt keinen Schnitt; cut.add fügt einen hinzu</translation>
    </message>
    <message>
        <source>there are several cuts; say which, by cut=NAME</source>
        <translation>es gibt mehrere Schnitte; mit cut=NAME angeben, welcher gemeint ist</translation>
    </message>
    <message>
        <source>nothing is open that could be cut</source>
        <translation>es ist nichts offen, was sich schneiden ließe</translation>
    </message>
    <message>
        <source>a path is missing</source>
        <translation>ein Pfad fehlt</translation>
    </message>
    <message>
        <source>there is nothing to %1</source>
        <translation>es gibt nichts zu tun: %1</translation>
    </message>
    <message>
        <source>set wants a field and a value</source>
        <translation>set braucht ein Feld und einen Wert</translation>
    </message>
    <message>
        <source>the cut is no plane, or there is no room for another</source>
        <translation>der Schnitt ist keine Ebene, oder für einen weiteren ist kein Platz</translation>
    </message>
    <message>
        <source>%1 has no keys</source>
        <translation>%1 hat keine Schlüsselbilder</translation>
    </message>
    <message>
        <source>%1 has no key at %2 s</source>
        <translation>%1 hat kein Schlüsselbild bei %2 s</translation>
    </message>
    <message>
        <source>Set key</source>
        <translation>Schlüsselbild setzen</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Schlüsselbild entfernen</translation>
    </message>
    <message>
        <source>%1 was not grown</source>
        <translation>%1 wurde nicht durch Wachsen erzeugt</translation>
    </message>
    <message>
        <source>growth.pullAt %1: there is nothing that could be pulled</source>
        <translation>growth.pullAt %1: dort ist nichts, was sich herausziehen ließe</translation>
    </message>
    <message>
        <source>Stop growing</source>
        <translation>Wachsen anhalten</translation>
    </message>
    <message>
        <source>growth.addSeed %1: the value there is none of its range</source>
        <translation>growth.addSeed %1: der Wert dort liegt nicht im Bereich</translation>
    </message>
    <message>
        <source>growth.notThis %1: it does not grow there</source>
        <translation>growth.notThis %1: dort wächst es nicht</translation>
    </message>
    <message>
        <source>growth.barrier wants the points of a stroke: [[X,Y,Z],[X,Y,Z]]</source>
        <translation>growth.barrier braucht die Punkte eines Strichs: [[X,Y,Z],[X,Y,Z]]</translation>
    </message>
    <message>
        <source>growth.change changes %1, not &apos;%2&apos;</source>
        <translation>growth.change ändert %1, nicht „%2“</translation>
    </message>
    <message>
        <source>Name of %1 as in the file</source>
        <translation>Name von %1 wie in der Datei</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>look.window: there is no volume whose values it could show</source>
        <translation>look.window: es gibt kein Volumen, dessen Werte es zeigen könnte</translation>
    </message>
    <message>
        <source>look.window %1: give %2</source>
        <translation>look.window %1: %2 angeben</translation>
    </message>
    <message>
        <source>look.showThis %1: that is outside the volume</source>
        <translation>look.showThis %1: das liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>channel %1: the volume mixes %2</source>
        <translation>Kanal %1: das Volumen mischt %2</translation>
    </message>
    <message>
        <source>the model has no instance %1</source>
        <translation>das Modell hat keine Instanz %1</translation>
    </message>
    <message>
        <source>structure %1 has no voxels that a point could follow</source>
        <translation>Struktur %1 hat keine Voxel, denen ein Punkt folgen könnte</translation>
    </message>
    <message>
        <source>point %1 of the mark follows nothing and has no place</source>
        <translation>Punkt %1 der Marke folgt nichts und hat keinen Ort</translation>
    </message>
    <message>
        <source>a name is of a structure or of a type of the model: give structure=NAME or type=PATH</source>
        <translation>ein Name ist der einer Struktur oder eines Typs des Modells: structure=NAME oder type=PFAD angeben</translation>
    </message>
    <message>
        <source>a region is of a structure: give structure=NAME</source>
        <translation>ein Gebiet ist das einer Struktur: structure=NAME angeben</translation>
    </message>
    <message>
        <source>no point of mark %1 lies in a structure or in an instance that it could follow</source>
        <translation>kein Punkt der Marke %1 liegt in einer Struktur oder in einer Instanz, der er folgen könnte</translation>
    </message>
    <message>
        <source>Style of lettering: %1</source>
        <translation>Stil der Schrift: %1</translation>
    </message>
    <message>
        <source>the cut is no membrane; cut.add membrane adds one</source>
        <translation>der Schnitt ist keine Membran; cut.add membrane fügt eine hinzu</translation>
    </message>
    <message>
        <source>membrane.protectValues: low must be less than high</source>
        <translation>membrane.protectValues: low muss kleiner als high sein</translation>
    </message>
    <message>
        <source>membrane.protectAt %1: that is outside the volume</source>
        <translation>membrane.protectAt %1: das liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>membrane.pin %1: that is beside the frame of the membrane</source>
        <translation>membrane.pin %1: das liegt neben dem Rahmen der Membran</translation>
    </message>
    <message>
        <source>a scene has at most %1 cuts</source>
        <translation>eine Szene hat höchstens %1 Schnitte</translation>
    </message>
    <message>
        <source>there is no model whose types could be named</source>
        <translation>es gibt kein Modell, dessen Typen sich benennen ließen</translation>
    </message>
    <message>
        <source>the model has no type or compartment &apos;%1&apos;%2</source>
        <translation>das Modell hat keinen Typ und kein Kompartiment „%1“%2</translation>
    </message>
    <message>
        <source>all types</source>
        <translation>alle Typen</translation>
    </message>
    <message>
        <source>model.leaveBy type: say what is left of the types</source>
        <translation>model.leaveBy type: angeben, was von den Typen übrig bleibt</translation>
    </message>
    <message>
        <source>model.protect: the cut is no membrane</source>
        <translation>model.protect: der Schnitt ist keine Membran</translation>
    </message>
    <message>
        <source>no type has a number to be seen; model.target gives one</source>
        <translation>kein Typ hat eine Anzahl, die zu sehen sein soll; model.target gibt eine</translation>
    </message>
    <message>
        <source>model.bringToSize: there is no other data beside a model</source>
        <translation>model.bringToSize: neben dem Modell gibt es keine anderen Daten</translation>
    </message>
    <message>
        <source>Number of %1 to be seen</source>
        <translation>Sichtbare Anzahl von %1</translation>
    </message>
    <message>
        <source>Set number of %1</source>
        <translation>Anzahl von %1 setzen</translation>
    </message>
    <message>
        <source>Leave %1 as above</source>
        <translation>%1 wie darüber übrig lassen</translation>
    </message>
    <message>
        <source>Keep %1 in view</source>
        <translation>%1 im Blick behalten</translation>
    </message>
    <message>
        <source>Let %1 be hidden</source>
        <translation>%1 verdecken lassen</translation>
    </message>
    <message>
        <source>Protect by membrane:</source>
        <translation>Durch Membran schützen:</translation>
    </message>
    <message>
        <source>Draw membrane to</source>
        <translation>Membran heranziehen an</translation>
    </message>
    <message>
        <source>No force of</source>
        <translation>Ohne Kraft:</translation>
    </message>
    <message>
        <source>structure.protect: the cut is no membrane</source>
        <translation>structure.protect: der Schnitt ist keine Membran</translation>
    </message>
    <message>
        <source>Turn cut</source>
        <translation>Schnitt drehen</translation>
    </message>
    <message>
        <source>Tilt cut</source>
        <translation>Schnitt kippen</translation>
    </message>
    <message>
        <source>Resize cut</source>
        <translation>Schnittgröße ändern</translation>
    </message>
    <message>
        <source>Move cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>the table is known in whole volumes of one channel only</source>
        <translation>den Tisch gibt es nur in ganzen Volumen mit einem Kanal</translation>
    </message>
    <message>
        <source>Finding the body</source>
        <translation>Körper wird gesucht</translation>
    </message>
    <message>
        <source>no single body stands out from the air of this volume</source>
        <translation>kein einzelner Körper hebt sich von der Luft dieses Volumens ab</translation>
    </message>
    <message>
        <source>Found the body</source>
        <translation>Körper gefunden</translation>
    </message>
    <message>
        <source>Move view</source>
        <translation>Ansicht bewegen</translation>
    </message>
    <message>
        <source>Key view</source>
        <translation>Ansicht als Schlüsselbild</translation>
    </message>
    <message>
        <source>%1; unsaved work is not protected</source>
        <translation>%1; ungespeicherte Arbeit ist nicht geschützt</translation>
    </message>
    <message>
        <source>a scene of %1 MiB is too large for a journal</source>
        <translation>eine Szene von %1 MiB ist zu groß für den Verlauf</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>ist keine Datei</translation>
    </message>
    <message>
        <source>it is larger than %1 MiB</source>
        <translation>ist größer als %1 MiB</translation>
    </message>
    <message>
        <source>the scan measures %1, the labels %2</source>
        <translation>der Scan misst %1, die Labels %2</translation>
    </message>
    <message>
        <source>check that they are of this scan, and the voxel size of both</source>
        <translation>prüfen, ob sie zu diesem Scan gehören, und die Voxelgröße beider</translation>
    </message>
    <message>
        <source>the labels do not overlap the scan at all: %1; %2</source>
        <translation>die Labels überlappen den Scan gar nicht: %1; %2</translation>
    </message>
    <message>
        <source>only %1 % of what is labelled lies in the scan: %2; %3</source>
        <translation>nur %1 % des Bezeichneten der Labels liegen im Scan: %2; %3</translation>
    </message>
    <message>
        <source>all of the labels lie in a few voxels of the scan: %1; %2</source>
        <translation>alle Labels liegen in wenigen Voxeln des Scans: %1; %2</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>lit sphere %1: %2; it looks like porcelain</source>
        <translation>Lichtkugel %1: %2; sie sieht aus wie Porzellan</translation>
    </message>
    <message>
        <source>there is no lit sphere %1; it looks like porcelain</source>
        <translation>es gibt keine Lichtkugel %1; sie sieht aus wie Porzellan</translation>
    </message>
    <message>
        <source>%1: %2 MiB is too much for a scene file</source>
        <translation>%1: %2 MiB sind zu viel für eine Szenendatei</translation>
    </message>
    <message>
        <source>%1 has moved; it was found as %2</source>
        <translation>%1 ist umgezogen; gefunden wurde es als %2</translation>
    </message>
    <message>
        <source>%1 has changed since the scene was saved</source>
        <translation>%1 hat sich geändert, seit die Szene gespeichert wurde</translation>
    </message>
    <message>
        <source>%1: the picture holds no scene of ours</source>
        <translation>%1: das Bild enthält keine Szene von Velum</translation>
    </message>
    <message>
        <source>%1: there is no such file or folder</source>
        <translation>%1: diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>%1: a look, which is put on what is open: Look &gt; Import look, or --transfer</source>
        <translation>%1: ein Aussehen; es wird auf das Geöffnete gelegt: Aussehen &gt; Aussehen importieren, oder --transfer</translation>
    </message>
    <message>
        <source>%1: the scene has a model already; open it by itself</source>
        <translation>%1: die Szene hat schon ein Modell; es allein öffnen</translation>
    </message>
    <message>
        <source>%1: %2 MiB is too much for a scene file; it was not written</source>
        <translation>%1: %2 MiB sind zu viel für eine Szenendatei; sie wurde nicht geschrieben</translation>
    </message>
    <message>
        <source>%1; &quot;Bring to size&quot; on the page Model enlarges it, or the command model.bringToSize</source>
        <translation>%1; „Größe anpassen“ auf der Seite Modell vergrößert es, oder der Befehl model.bringToSize</translation>
    </message>
    <message>
        <source>nothing was named to open</source>
        <translation>es wurde nichts zum Öffnen genannt</translation>
    </message>
    <message>
        <source>own paper: no picture is named; it is smooth</source>
        <translation>eigenes Papier: kein Bild ist genannt; es ist glatt</translation>
    </message>
    <message>
        <source>own paper: %1; it is smooth</source>
        <translation>eigenes Papier: %1; es ist glatt</translation>
    </message>
    <message>
        <source>%1: nothing can be written there: %2</source>
        <translation>%1: dort kann nichts geschrieben werden: %2</translation>
    </message>
    <message>
        <source>%1: %2 GiB are free; the pyramid may take up to %3 GiB</source>
        <translation>%1: %2 GiB sind frei; die Pyramide braucht bis zu %3 GiB</translation>
    </message>
    <message>
        <source>%1: cannot be read piece by piece</source>
        <translation>%1: kann nicht stückweise gelesen werden</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>sie ist beschädigt</translation>
    </message>
    <message>
        <source>no journal is in it</source>
        <translation>darin ist kein Verlauf</translation>
    </message>
    <message>
        <source>%1: unsaved work there cannot be looked for (%2)</source>
        <translation>%1: ungespeicherte Arbeit kann dort nicht gesucht werden (%2)</translation>
    </message>
    <message>
        <source>%1: this work is open in another window</source>
        <translation>%1: diese Arbeit ist in einem anderen Fenster offen</translation>
    </message>
    <message>
        <source>%1: this work cannot be taken (%2)</source>
        <translation>%1: diese Arbeit kann nicht übernommen werden (%2)</translation>
    </message>
    <message>
        <source>%1: the work there cannot be read (%2)</source>
        <translation>%1: die Arbeit dort kann nicht gelesen werden (%2)</translation>
    </message>
    <message>
        <source>%1: cannot be deleted (%2)</source>
        <translation>%1: kann nicht gelöscht werden (%2)</translation>
    </message>
    <message>
        <source>finish.paper: own is without a picture; give the file of one</source>
        <translation>finish.paper: own hat kein Bild; die Datei eines Bildes angeben</translation>
    </message>
    <message>
        <source>%1 ml that are not part of the largest body are hidden</source>
        <translation>%1 ml, die nicht zum größten Körper gehören, sind ausgeblendet</translation>
    </message>
    <message>
        <source>nothing lies beside the body</source>
        <translation>neben dem Körper liegt nichts</translation>
    </message>
    <message>
        <source>%1: there is no such sample</source>
        <translation>%1: dieses Phantom gibt es nicht</translation>
    </message>
    <message>
        <source>the scene&apos;s %1 %2 is not there, nor near the scene; put it back, or name it with --set %3=FILE</source>
        <translation>%1 der Szene fehlt und ist auch nicht in ihrer Nähe: %2; zurücklegen oder mit --set %3=DATEI nennen</translation>
    </message>
    <message>
        <source>%1: made of blocks, as of a coarser grid; shapes are smoothed by %2 %3 (smoothing 0: as in the file)</source>
        <translation>%1: aus Blöcken, wie von einem gröberen Gitter; Formen sind um %2 %3 geglättet (Glättung 0: wie in der Datei)</translation>
    </message>
    <message>
        <source>the journal cannot be written (%1)</source>
        <translation>der Verlauf kann nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>there is no volume to read anew</source>
        <translation>es gibt kein Volumen, das neu gelesen werden könnte</translation>
    </message>
    <message>
        <source>structures were grown in this volume and would lie elsewhere; remove them first</source>
        <translation>in diesem Volumen sind Strukturen gewachsen und lägen anderswo; sie zuerst entfernen</translation>
    </message>
    <message>
        <source>Add data</source>
        <translation>Daten hinzufügen</translation>
    </message>
    <message>
        <source>Carry over to other data</source>
        <translation>Auf andere Daten übertragen</translation>
    </message>
    <message>
        <source>%1: cannot be locked (%2)</source>
        <translation>%1: kann nicht gesperrt werden (%2)</translation>
    </message>
    <message>
        <source>%1: cannot be written; check the free space</source>
        <translation>%1: kann nicht geschrieben werden; freien Platz prüfen</translation>
    </message>
    <message>
        <source>%1: cannot be read again</source>
        <translation>%1: kann nicht noch einmal gelesen werden</translation>
    </message>
    <message>
        <source>%1 bytes in %2 file%3, %4</source>
        <translation>Dateien: %2, %1 Bytes, %4</translation>
    </message>
    <message>
        <source>%1: there are no such files</source>
        <translation>%1: diese Dateien gibt es nicht</translation>
    </message>
    <message>
        <source>%1 lies in the data&apos;s folder %2; have it elsewhere, as it would be data the next time</source>
        <translation>%1 liegt im Ordner der Daten, %2; anderswo ablegen, da es sonst beim nächsten Mal zu den Daten zählt</translation>
    </message>
    <message>
        <source>%1 and %2 would both become %3; let the pattern&apos;s * stand for what differs, as in &apos;studies/*/ct.nrrd&apos;, and have {name} or {dir} in the output&apos;s name</source>
        <translation>%1 und %2 würden beide zu %3; das * des Musters muss für das stehen, was sie unterscheidet, wie in „studies/*/ct.nrrd“, und im Namen der Ausgabe {name} oder {dir} stehen</translation>
    </message>
    <message>
        <source>%1 is not shown</source>
        <translation>%1 ist ausgeblendet</translation>
    </message>
    <message>
        <source>%1 lies beside the picture</source>
        <translation>%1 liegt neben dem Bild</translation>
    </message>
    <message>
        <source>%1 is left on %2 of %3 pixels</source>
        <translation>%1 bleibt auf %2 von %3 Pixeln</translation>
    </message>
    <message>
        <source>%1 %2: that is outside the volume</source>
        <translation>%1 %2: das liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>%1 %2: give x,y,z</source>
        <translation>%1 %2: x,y,z angeben</translation>
    </message>
    <message>
        <source>%1 %2: no value along it is from %3 to %4; draw it elsewhere, or give the range</source>
        <translation>%1 %2: kein Wert darauf liegt zwischen %3 und %4; anderswo zeichnen oder den Bereich angeben</translation>
    </message>
    <message>
        <source>others %1: the value there is not from %2 to %3, so it does not grow there; choose a place that it takes</source>
        <translation>others %1: der Wert dort liegt nicht zwischen %2 und %3, also wächst es dort nicht; eine Stelle wählen, die dazugehört</translation>
    </message>
    <message>
        <source>guard and others: what is told where it leaks is not guarded; leave one of them out</source>
        <translation>guard und others: was gesagt bekommt, wo es ausläuft, wird nicht bewacht; eines davon weglassen</translation>
    </message>
    <message>
        <source>range: give A,B</source>
        <translation>range: A,B angeben</translation>
    </message>
    <message>
        <source>range A,B: A must not be more than B</source>
        <translation>range A,B: A darf nicht größer als B sein</translation>
    </message>
    <message>
        <source>distance needs plane: it is from the plane that it is measured</source>
        <translation>distance braucht plane: der Abstand wird von der Ebene gemessen (plane)</translation>
    </message>
    <message>
        <source>guard needs plane: it watches how wide the structure is away from the plane</source>
        <translation>guard braucht plane: bewacht wird, wie breit die Struktur abseits der Ebene ist</translation>
    </message>
    <message>
        <source>plane: give nx,ny,nz,d</source>
        <translation>plane: nx,ny,nz,d angeben</translation>
    </message>
    <message>
        <source>plane: the normal must not be 0,0,0</source>
        <translation>plane: die Normale der Ebene darf nicht 0,0,0 sein</translation>
    </message>
    <message>
        <source>within %1: no voxel has that label</source>
        <translation>within %1: kein Voxel hat dieses Label</translation>
    </message>
    <message>
        <source>there is no volume to grow in: name a file that has one</source>
        <translation>es gibt kein Volumen zum Wachsen: eine Datei nennen, die eines hat</translation>
    </message>
    <message>
        <source>the labels have no number left for another structure</source>
        <translation>die Labels haben keine Zahl mehr für eine weitere Struktur</translation>
    </message>
    <message>
        <source>%1, a part</source>
        <translation>%1, ein Teil</translation>
    </message>
    <message>
        <source>of %1 frames, not %2</source>
        <translation>von %1 Einzelbildern, nicht %2</translation>
    </message>
    <message>
        <source>%1 %2, not %3</source>
        <translation>%1 %2, nicht %3</translation>
    </message>
    <message>
        <source>%1: is no list of frames that Velum has written; choose another folder, or name</source>
        <translation>%1: ist keine von Velum geschriebene Liste von Einzelbildern; einen anderen Ordner oder Namen wählen</translation>
    </message>
    <message>
        <source>%1: tells of another film (%2); choose another folder, or --overwrite</source>
        <translation>%1: gehört zu einem anderen Film (%2); einen anderen Ordner wählen, oder --overwrite</translation>
    </message>
    <message>
        <source>%1: tells of another film than the lists beside it (%2)</source>
        <translation>%1: gehört zu einem anderen Film als die Listen daneben (%2)</translation>
    </message>
    <message>
        <source>Looking for frame %1</source>
        <translation>Einzelbild %1 wird gesucht</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made (%2)</source>
        <translation>%1: der Ordner kann nicht angelegt werden (%2)</translation>
    </message>
    <message>
        <source>part %1: expected K/N, as 3/16, with K from 1 to N</source>
        <translation>part %1: K/N angeben, etwa 3/16, mit K von 1 bis N</translation>
    </message>
    <message>
        <source>%1: holds frames of several films (%2); keep each in a folder of its own</source>
        <translation>%1: enthält Einzelbilder mehrerer Filme (%2); jeden in einem eigenen Ordner ablegen</translation>
    </message>
    <message>
        <source>%1: there are no frames of a film</source>
        <translation>%1: dort sind keine Einzelbilder eines Films</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frames missing or broken: %4; draw them with --resume</source>
        <translation>%1: %2 von %3 Einzelbildern fehlen oder sind beschädigt: %4; mit --resume zeichnen</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Einzelbild %1 von %2</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>a film needs a name, such as turn.mp4 or frames/</source>
        <translation>ein Film braucht einen Namen, etwa turn.mp4 oder frames/</translation>
    </message>
    <message>
        <source>%1 pictures for a frame: expected 1 to %2</source>
        <translation>%1 Bilder für ein Einzelbild: 1 bis %2 angeben</translation>
    </message>
    <message>
        <source>shutter %1: expected 0 to 1</source>
        <translation>Verschluss %1: 0 bis 1 angeben</translation>
    </message>
    <message>
        <source>%1: films are written as .mp4, .webm or .gif, as pictures in .png, .tif or .exr, or into a folder</source>
        <translation>%1: Filme werden als .mp4, .webm oder .gif geschrieben, als Bilder in .png, .tif oder .exr, oder in einen Ordner</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>frames to go on from</source>
        <translation>Einzelbilder zum Fortsetzen</translation>
    </message>
    <message>
        <source>%1: a video has no %2; write the frames to a folder, then the film of them</source>
        <translation>%1: ein Video hat keine %2; die Einzelbilder in einen Ordner schreiben, dann den Film daraus</translation>
    </message>
    <message>
        <source>%1 of %2 frames could not be drawn: %3 (%4)</source>
        <translation>%1 von %2 Einzelbildern konnten nicht gezeichnet werden: %3 (%4)</translation>
    </message>
    <message>
        <source>, layers</source>
        <translation>, Ebenen</translation>
    </message>
    <message>
        <source>, %1 dpi</source>
        <translation>, %1 dpi</translation>
    </message>
    <message>
        <source>%1 (%2 bytes)</source>
        <translation>%1 (%2 Bytes)</translation>
    </message>
    <message>
        <source>Frame %1 of %2%3</source>
        <translation>Einzelbild %1 von %2%3</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, noch %1</translation>
    </message>
    <message>
        <source>no film &apos;%1&apos;: %2</source>
        <translation>kein Film „%1“: %2</translation>
    </message>
    <message>
        <source>there is no such cut that could come in</source>
        <translation>es gibt keinen Schnitt, der hereinkommen könnte</translation>
    </message>
    <message>
        <source>the volume has no time steps</source>
        <translation>das Volumen hat keine Zeitschritte</translation>
    </message>
    <message>
        <source>no structure is pulled out of a cut</source>
        <translation>keine Struktur ist aus einem Schnitt herausgezogen</translation>
    </message>
    <message>
        <source>no membrane is on</source>
        <translation>keine Membran ist eingeschaltet</translation>
    </message>
    <message>
        <source>there are no structures</source>
        <translation>es gibt keine Strukturen</translation>
    </message>
    <message>
        <source>there is no model of molecules</source>
        <translation>es gibt kein Modell aus Molekülen</translation>
    </message>
    <message>
        <source>no cut is on</source>
        <translation>kein Schnitt ist eingeschaltet</translation>
    </message>
    <message>
        <source>the structure is empty: there is nothing to fly to</source>
        <translation>die Struktur ist leer: es gibt nichts, zu dem geflogen werden könnte</translation>
    </message>
    <message>
        <source>a title needs words</source>
        <translation>ein Titel braucht Wörter</translation>
    </message>
    <message>
        <source>there is no structure &apos;%1&apos; in %2</source>
        <translation>es gibt keine Struktur „%1“ in %2</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>der Szene</translation>
    </message>
    <message>
        <source>the structure &apos;%1&apos; is empty</source>
        <translation>die Struktur „%1“ ist leer</translation>
    </message>
    <message>
        <source>without structures that the other labels do not have: %1%2</source>
        <translation>ohne Strukturen, die die anderen Labels nicht haben: %1%2</translation>
    </message>
    <message>
        <source>structures that were grown are left out: they are of other data</source>
        <translation>gewachsene Strukturen sind weggelassen: sie gehören zu anderen Daten</translation>
    </message>
    <message>
        <source>surfaces are left out: they are of other data</source>
        <translation>Oberflächen sind weggelassen: sie gehören zu anderen Daten</translation>
    </message>
    <message>
        <source>the scene has no volume in whose place another one could come</source>
        <translation>die Szene hat kein Volumen, das sich durch ein anderes ersetzen ließe</translation>
    </message>
    <message>
        <source>the volume is of another kind: it has the preset that fits it</source>
        <translation>das Volumen ist von anderer Art: es hat die Vorgabe, die zu ihm passt</translation>
    </message>
    <message>
        <source>a map of %1 pixels is not %2 x %3</source>
        <translation>eine Karte von %1 Pixeln ist nicht %2 x %3</translation>
    </message>
    <message>
        <source>%1:%2 min</source>
        <translation>%1:%2 min</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>a map of %1 keys is not %2 x %3, or has no step</source>
        <translation>eine Karte von %1 Schlüsseln ist nicht %2 x %3 oder hat keine Schrittweite</translation>
    </message>
    <message>
        <source>the looks of %1 other channels are left out</source>
        <translation>das Aussehen von %1 anderen Kanälen ist weggelassen</translation>
    </message>
    <message>
        <source>lengths in it are in %1, which the file does not say</source>
        <translation>Längen darin sind in %1, was die Datei nicht sagt</translation>
    </message>
    <message>
        <source>%1: neither a scene, a picture of ours nor a transfer function; name one of these</source>
        <translation>%1: weder eine Szene noch ein Bild von Velum noch eine Transferfunktion; eines davon nennen</translation>
    </message>
    <message>
        <source>%1 instances are too many to find which of them hold %2 points: at most %3 can be looked at for one point; give pointInstances</source>
        <translation>%1 Instanzen sind zu viele, um zu finden, welche davon %2 Punkte enthalten: für einen Punkt lassen sich höchstens %3 untersuchen; pointInstances angeben</translation>
    </message>
    <message>
        <source>Measuring structures</source>
        <translation>Strukturen werden vermessen</translation>
    </message>
    <message>
        <source>there is no volume whose values could be measured</source>
        <translation>es gibt kein Volumen, dessen Werte sich messen ließen</translation>
    </message>
    <message>
        <source>it holds no voxel that has a value</source>
        <translation>sie enthält kein Voxel mit einem Wert</translation>
    </message>
    <message>
        <source>it meets no voxel that has a value</source>
        <translation>sie trifft kein Voxel mit einem Wert</translation>
    </message>
    <message>
        <source>there is no structure %1 that has voxels</source>
        <translation>es gibt keine Struktur %1 mit Voxeln</translation>
    </message>
    <message>
        <source>it lacks points</source>
        <translation>ihr fehlen Punkte</translation>
    </message>
    <message>
        <source>one of its legs has no length</source>
        <translation>einer ihrer Schenkel hat keine Länge</translation>
    </message>
    <message>
        <source>there is no surface under both points</source>
        <translation>unter beiden Punkten ist keine Oberfläche</translation>
    </message>
    <message>
        <source>the points lie outside of the volume</source>
        <translation>die Punkte liegen außerhalb des Volumens</translation>
    </message>
    <message>
        <source>there is no surface at %1, %2, %3</source>
        <translation>bei %1, %2, %3 ist keine Oberfläche</translation>
    </message>
    <message>
        <source>Measuring along the surface</source>
        <translation>Entlang der Oberfläche wird gemessen</translation>
    </message>
    <message>
        <source>Measuring values</source>
        <translation>Werte werden gemessen</translation>
    </message>
    <message>
        <source>%1: give %2, not %3 numbers</source>
        <translation>%1: %2 angeben, nicht %3 Zahlen</translation>
    </message>
    <message>
        <source>%1 %2: %3; expected points and a radius, x,y,z:x,y,z@radius</source>
        <translation>%1 %2: %3; erwartet werden Punkte und ein Radius, x,y,z:x,y,z@radius</translation>
    </message>
    <message>
        <source>a point has three numbers</source>
        <translation>ein Punkt hat drei Zahlen</translation>
    </message>
    <message>
        <source>the radius must be more than 0</source>
        <translation>der Radius muss größer als 0 sein</translation>
    </message>
    <message>
        <source>it goes on after its end</source>
        <translation>es geht nach dem Ende weiter</translation>
    </message>
    <message>
        <source>sketch: there is no volume under the strokes</source>
        <translation>sketch: unter den Strichen ist kein Volumen</translation>
    </message>
    <message>
        <source>sketch: the strokes lie outside the volume, or nothing under them differs from the rest by its values</source>
        <translation>sketch: die Striche liegen außerhalb des Volumens, oder nichts unter ihnen unterscheidet sich durch seine Werte vom Rest</translation>
    </message>
    <message>
        <source>types %1: no type or compartment of the model is called so%2</source>
        <translation>types %1: kein Typ und kein Kompartiment des Modells heißt so%2</translation>
    </message>
    <message>
        <source> (is %1 meant?)</source>
        <translation> (ist %1 gemeint?)</translation>
    </message>
    <message>
        <source>values A,B: A must be less than B</source>
        <translation>values A,B: A muss kleiner als B sein</translation>
    </message>
    <message>
        <source>place %1,%2,%3: that is outside the volume</source>
        <translation>place %1,%2,%3: das liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>leastPiece %1: give a number of voxels, 1 or more, or auto</source>
        <translation>leastPiece %1: eine Zahl von Voxeln angeben, 1 oder mehr, oder auto</translation>
    </message>
    <message>
        <source>axis 0,0,0: it has no direction</source>
        <translation>axis 0,0,0: das ist keine Richtung</translation>
    </message>
    <message>
        <source>sketch: it fits the curve to its strokes: leave values and place out</source>
        <translation>sketch: passt die Kurve an die Striche an: values und place weglassen</translation>
    </message>
    <message>
        <source>there is no model whose types a membrane could go around</source>
        <translation>es gibt kein Modell, um dessen Typen eine Membran gehen könnte</translation>
    </message>
    <message>
        <source>the model is of another scale than the data beside it, by whose grid sheets go; bring it to size first (model.bringToSize)</source>
        <translation>das Modell hat einen anderen Maßstab als die Daten daneben, nach deren Gitter Tücher gehen; zuerst seine Größe anpassen (model.bringToSize)</translation>
    </message>
    <message>
        <source>there is no volume to clip</source>
        <translation>es gibt kein Volumen zum Beschneiden</translation>
    </message>
    <message>
        <source>lies beside the frame: move it, or make the frame larger</source>
        <translation>liegt neben dem Rahmen: sie verschieben oder den Rahmen vergrößern</translation>
    </message>
    <message>
        <source>is %1 from the rest plane, and the sheet goes %2 to either side: deepen the reach to %3</source>
        <translation>ist %1 von der Ruheebene entfernt, und das Tuch geht %2 nach jeder Seite: die Reichweite auf %3 vergrößern</translation>
    </message>
    <message>
        <source>Move pin</source>
        <translation>Nadel verschieben</translation>
    </message>
    <message>
        <source>Resize force</source>
        <translation>Größe der Kraft ändern</translation>
    </message>
    <message>
        <source>Move force</source>
        <translation>Kraft verschieben</translation>
    </message>
    <message>
        <source>Counting what is seen</source>
        <translation>Sichtbares wird gezählt</translation>
    </message>
    <message>
        <source>there is no model to count in</source>
        <translation>es gibt kein Modell, in dem gezählt werden könnte</translation>
    </message>
    <message>
        <source>%1: bars are written as .svg or .csv</source>
        <translation>%1: Balken werden als .svg oder .csv geschrieben</translation>
    </message>
    <message>
        <source>%1, %2 x %3 pixels</source>
        <translation>%1, %2 x %3 Pixel</translation>
    </message>
    <message>
        <source>Next to nothing is seen of %1: what is around %2 hides %3.</source>
        <translation>Von %1 ist fast nichts zu sehen: was um %2 liegt, verdeckt %3.</translation>
    </message>
    <message>
        <source>there is no model: open one first</source>
        <translation>es gibt kein Modell: zuerst eines öffnen</translation>
    </message>
    <message>
        <source>%1: expected %2</source>
        <translation>%1: erwartet wird %2</translation>
    </message>
    <message>
        <source>a whole number of instances, or a share such as 20%</source>
        <translation>eine ganze Zahl von Instanzen oder ein Anteil mit %-Zeichen, etwa 20 %</translation>
    </message>
    <message>
        <source>the legend leaves out what the data do not have: %1</source>
        <translation>die Legende lässt weg, was die Daten nicht haben: %1</translation>
    </message>
    <message>
        <source>there is no model to export: open one first</source>
        <translation>es gibt kein Modell zum Exportieren: zuerst eines öffnen</translation>
    </message>
    <message>
        <source>%1: models are written as .cif, .cif.gz, .glb, .csv or .ply</source>
        <translation>%1: Modelle werden als .cif, .cif.gz, .glb, .csv oder .ply geschrieben</translation>
    </message>
    <message>
        <source>Choosing instances</source>
        <translation>Instanzen werden gewählt</translation>
    </message>
    <message>
        <source>nothing of the model shows: cuts, or types that are hidden, leave no instance of it</source>
        <translation>vom Modell ist nichts zu sehen: Schnitte oder ausgeblendete Typen lassen keine Instanz übrig</translation>
    </message>
    <message>
        <source>of %1 copies of the model the first is written</source>
        <translation>von %1 Kopien des Modells wird die erste geschrieben</translation>
    </message>
    <message>
        <source>colours are those of types: shades of chains and elements are left out</source>
        <translation>die Farben sind die der Typen: Abstufungen von Ketten und Elementen sind weggelassen</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>das Modell</translation>
    </message>
    <message>
        <source>%1 is %2 times smaller than the other data, and not seen beside them</source>
        <translation>%1 ist %2-mal kleiner als die anderen Daten und neben ihnen nicht zu sehen</translation>
    </message>
    <message>
        <source>%1 is %2 times larger than the other data, which are not seen beside it</source>
        <translation>%1 ist %2-mal größer als die anderen Daten, die daneben nicht zu sehen sind</translation>
    </message>
    <message>
        <source>the number of %1</source>
        <translation>die Anzahl von %1</translation>
    </message>
    <message>
        <source>; %1 set by hand %2 down, to %3</source>
        <translation>; von Hand gesetzt und nun weniger: %1, auf %3</translation>
    </message>
    <message>
        <source>; %1 set by hand %2</source>
        <translation>; von Hand gesetzt und unverändert: %1</translation>
    </message>
    <message>
        <source>%1 of %2 %3 drawn</source>
        <translation>%1 von %2 %3 gezeichnet</translation>
    </message>
    <message>
        <source>other cuts take the rest, or these spare none of it</source>
        <translation>andere Schnitte nehmen den Rest, oder diese sparen nichts davon aus</translation>
    </message>
    <message>
        <source>other cuts take the rest, or numbers set by hand hold it back</source>
        <translation>andere Schnitte nehmen den Rest, oder von Hand gesetzte Zahlen halten ihn zurück</translation>
    </message>
    <message>
        <source>, not %1: there are no more</source>
        <translation>, nicht %1: mehr gibt es nicht</translation>
    </message>
    <message>
        <source>, not %1: %2</source>
        <translation>, nicht %1: %2</translation>
    </message>
    <message>
        <source>no cut is on whose share could be set</source>
        <translation>kein Schnitt ist eingeschaltet, dessen Anteil sich setzen ließe</translation>
    </message>
    <message>
        <source>other cuts take the rest</source>
        <translation>andere Schnitte nehmen den Rest</translation>
    </message>
    <message>
        <source>these lie outside of the cuts</source>
        <translation>diese liegen außerhalb der Schnitte</translation>
    </message>
    <message>
        <source>%1 of %2 %3 seen</source>
        <translation>%1 von %2 %3 zu sehen</translation>
    </message>
    <message>
        <source>, not %1, as so many are drawn</source>
        <translation>, nicht %1, so viele sind gezeichnet</translation>
    </message>
    <message>
        <source>, not %1: all are drawn, and %2 are behind others or outside the picture</source>
        <translation>, nicht %1: alle sind gezeichnet, und %2 liegen hinter anderen oder außerhalb des Bildes</translation>
    </message>
    <message>
        <source>, not %1: all %2 that can be drawn are, and %3 are behind others or outside the picture</source>
        <translation>, nicht %1: alle %2, die sich zeichnen lassen, sind gezeichnet, und %3 liegen hinter anderen oder außerhalb des Bildes</translation>
    </message>
    <message>
        <source>, not %1: these lie outside of the cuts</source>
        <translation>, nicht %1: diese liegen außerhalb der Schnitte</translation>
    </message>
    <message>
        <source>, the nearest to %1 in %2 pictures</source>
        <translation>, am nächsten zu %1 in %2 Bildern</translation>
    </message>
    <message>
        <source>%1: %2 have this name; say which: %3, %4</source>
        <translation>%1: %2 haben diesen Namen; angeben, welcher gemeint ist: %3, %4</translation>
    </message>
    <message>
        <source>name a type or a compartment of the model</source>
        <translation>einen Typ oder ein Kompartiment des Modells nennen</translation>
    </message>
    <message>
        <source>%1: the model has no type or compartment of this name%2</source>
        <translation>%1: das Modell hat keinen Typ und kein Kompartiment dieses Namens%2</translation>
    </message>
    <message>
        <source>; info lists them</source>
        <translation>; info zählt sie auf</translation>
    </message>
    <message>
        <source>the picture has no layer %1</source>
        <translation>das Bild hat keine Ebene %1</translation>
    </message>
    <message>
        <source>%1 is not drawn, or outside of the picture</source>
        <translation>%1 ist nicht gezeichnet oder liegt außerhalb des Bildes</translation>
    </message>
    <message>
        <source>nothing hides %1</source>
        <translation>nichts verdeckt %1</translation>
    </message>
    <message>
        <source>%1 of %2 is hidden</source>
        <translation>%1 von %2 ist verdeckt</translation>
    </message>
    <message>
        <source>what is no model</source>
        <translation>was kein Modell ist</translation>
    </message>
    <message>
        <source>, the rest by %1 more</source>
        <translation>, der Rest durch %1 weitere</translation>
    </message>
    <message>
        <source>the two pictures differ in size</source>
        <translation>die beiden Bilder sind verschieden groß</translation>
    </message>
    <message>
        <source>Way to %1</source>
        <translation>Weg zu %1</translation>
    </message>
    <message>
        <source>Only instances are cleared: what the volume shows before them stays; cut it, or choose a look that one sees through</source>
        <translation>Freigestellt werden nur Instanzen: was das Volumen davor zeigt, bleibt; es schneiden oder ein Aussehen wählen, durch das man hindurchsieht</translation>
    </message>
    <message>
        <source>lengths are in %1, which no file of surfaces says</source>
        <translation>Längen sind in %1, was keine Datei mit Oberflächen sagt</translation>
    </message>
    <message>
        <source>there is no membrane with id %1</source>
        <translation>es gibt keine Membran mit der Nummer %1</translation>
    </message>
    <message>
        <source>of a streamed volume the level that is in memory is written, %1 x %2 x %3 voxels</source>
        <translation>von einem gestreamten Volumen wird die Stufe geschrieben, die im Speicher ist, %1 x %2 x %3 Voxel</translation>
    </message>
    <message>
        <source>of %1 time steps the one that is shown is written</source>
        <translation>von %1 Zeitschritten wird der gezeigte geschrieben</translation>
    </message>
    <message>
        <source>size %1: expected WIDTHxHEIGHT in pixels, 1 to 65536, or with a unit: 1280x720, 12x8cm, 120x80mm, 5x3in</source>
        <translation>size %1: BREITExHÖHE in Pixeln angeben, 1 bis 65536, oder mit Einheit: 1280x720, 12x8cm, 120x80mm, 5x3in</translation>
    </message>
    <message>
        <source>%1; with lines and letters as .svg or .pdf</source>
        <translation>%1; mit Linien und Buchstaben als .svg oder .pdf</translation>
    </message>
    <message>
        <source>the plate has %1 pixels an inch; journals ask for %2 or more: make it %3 pixels wide</source>
        <translation>die Tafel hat %1 Pixel je Zoll; Zeitschriften verlangen mindestens %2: sie %3 Pixel breit machen</translation>
    </message>
    <message>
        <source>the thinnest line is %1 pt wide; journals ask for %2 pt or more</source>
        <translation>die dünnste Linie ist %1 pt breit; Zeitschriften verlangen mindestens %2 pt</translation>
    </message>
    <message>
        <source>the smallest letters have %1 pt; journals ask for %2 pt or more</source>
        <translation>die kleinsten Buchstaben haben %1 pt; Zeitschriften verlangen mindestens %2 pt</translation>
    </message>
    <message>
        <source>the largest letters have %1 pt; journals ask for %2 pt or less</source>
        <translation>die größten Buchstaben haben %1 pt; Zeitschriften verlangen höchstens %2 pt</translation>
    </message>
    <message>
        <source>Tracing lines</source>
        <translation>Linien werden nachgezeichnet</translation>
    </message>
    <message>
        <source>width and level, as 400 50</source>
        <translation>Breite und Mitte, etwa 400 50</translation>
    </message>
    <message>
        <source>, or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>%1 has no voxels to export</source>
        <translation>%1 hat keine Voxel zum Exportieren</translation>
    </message>
    <message>
        <source>there are no structures to export: nothing is labelled</source>
        <translation>es gibt keine Strukturen zum Exportieren: kein Label ist vergeben</translation>
    </message>
    <message>
        <source>Choosing structures</source>
        <translation>Strukturen werden gewählt</translation>
    </message>
    <message>
        <source>Surface of %1</source>
        <translation>Oberfläche von %1</translation>
    </message>
    <message>
        <source>there are no structures: open labels first, or grow some</source>
        <translation>es gibt keine Strukturen: zuerst Labels öffnen oder welche wachsen lassen</translation>
    </message>
    <message>
        <source>there is no structure &apos;%1&apos;%2; name one, or give its number (see info)</source>
        <translation>es gibt keine Struktur „%1“%2; eine nennen oder ihre Zahl angeben (siehe info)</translation>
    </message>
    <message>
        <source>measuring structures</source>
        <translation>Strukturen werden vermessen</translation>
    </message>
    <message>
        <source>measuring values</source>
        <translation>Werte werden gemessen</translation>
    </message>
    <message>
        <source>a plate has at most 32767 pixels along each axis: make it smaller</source>
        <translation>eine Tafel hat höchstens 32767 Pixel je Achse: sie kleiner machen</translation>
    </message>
    <message>
        <source>the drawing cannot be drawn: </source>
        <translation>die Zeichnung kann nicht gezeichnet werden: </translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the scene inside it is damaged: it ends early</source>
        <translation>die Szene darin ist beschädigt: sie endet zu früh</translation>
    </message>
    <message>
        <source>the scene inside it is damaged, or too long</source>
        <translation>die Szene darin ist beschädigt oder zu lang</translation>
    </message>
    <message>
        <source>the scene inside it is damaged</source>
        <translation>die Szene darin ist beschädigt</translation>
    </message>
    <message>
        <source>the scene inside it is too long</source>
        <translation>die Szene darin ist zu lang</translation>
    </message>
    <message>
        <source>%1 MiB of scene are too much for a drawing</source>
        <translation>%1 MiB Szene sind zu viel für eine Zeichnung</translation>
    </message>
    <message>
        <source>a plate cannot be written as PNG: </source>
        <translation>eine Tafel kann nicht als PNG geschrieben werden: </translation>
    </message>
    <message>
        <source>tracing regions</source>
        <translation>Gebiete werden nachgezeichnet</translation>
    </message>
    <message>
        <source>tracing lines</source>
        <translation>Linien werden nachgezeichnet</translation>
    </message>
    <message>
        <source>the drawing cannot be written as PDF: </source>
        <translation>die Zeichnung kann nicht als PDF geschrieben werden: </translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no language of Velum; it speaks en and de</source>
        <translation>„%1“ ist keine Sprache von Velum; es spricht en und de</translation>
    </message>
    <message>
        <source>%1: pictures of the window are written as .png, .jpg or .bmp</source>
        <translation>%1: Bilder des Fensters werden als .png, .jpg oder .bmp geschrieben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2, a whole number of %3 to %4</source>
        <translation>„%1“ ist nicht %2, eine ganze Zahl von %3 bis %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no page of the side panel</source>
        <translation>„%1“ ist keine Seite der Seitenleiste</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no command of the window</source>
        <translation>„%1“ ist kein Befehl des Fensters</translation>
    </message>
    <message>
        <source>%1: cannot be done now</source>
        <translation>%1: ist jetzt nicht möglich</translation>
    </message>
    <message>
        <source>no unsaved work was left behind</source>
        <translation>es gibt keine liegengebliebene ungespeicherte Arbeit</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>the file is prestack</source>
        <translation>die Datei ist ungestapelt</translation>
    </message>
    <message>
        <source>Cut along the view</source>
        <translation>Quer zur Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>Remove cut</source>
        <translation>Schnitt entfernen</translation>
    </message>
    <message>
        <source>Duplicate cut</source>
        <translation>Schnitt duplizieren</translation>
    </message>
    <message>
        <source>Flip cut</source>
        <translation>Schnitt wenden</translation>
    </message>
    <message>
        <source>Rename cut</source>
        <translation>Schnitt umbenennen</translation>
    </message>
    <message>
        <source>Move cut in the list</source>
        <translation>Schnitt in der Liste verschieben</translation>
    </message>
    <message>
        <source>Put all back</source>
        <translation>Alle zurücklegen</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Zweite Ebene</translation>
    </message>
    <message>
        <source>Film: turn</source>
        <translation>Film: Drehteller</translation>
    </message>
    <message>
        <source>Film: cut</source>
        <translation>Film: Schnitte kommen</translation>
    </message>
    <message>
        <source>Film: membrane</source>
        <translation>Film: Membranen sinken ein</translation>
    </message>
    <message>
        <source>Film: pull out</source>
        <translation>Film: Herausziehen</translation>
    </message>
    <message>
        <source>Film: equalize</source>
        <translation>Film: Abgleichen</translation>
    </message>
    <message>
        <source>Film: fly</source>
        <translation>Film: Flug</translation>
    </message>
    <message>
        <source>Film: time steps</source>
        <translation>Film: Zeitschritte</translation>
    </message>
    <message>
        <source>Film: before and after</source>
        <translation>Film: Vorher und nachher</translation>
    </message>
    <message>
        <source>Film: title</source>
        <translation>Film: Titel</translation>
    </message>
    <message>
        <source>Ease key</source>
        <translation>Übergang des Schlüsselbilds</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Schlüsselbild verschieben</translation>
    </message>
    <message>
        <source>Remove track</source>
        <translation>Spur entfernen</translation>
    </message>
    <message>
        <source>Clear film</source>
        <translation>Film löschen</translation>
    </message>
    <message>
        <source>Draw barrier</source>
        <translation>Barriere ziehen</translation>
    </message>
    <message>
        <source>Add caption</source>
        <translation>Bildtext hinzufügen</translation>
    </message>
    <message>
        <source>Remove caption</source>
        <translation>Bildtext entfernen</translation>
    </message>
    <message>
        <source>Choose preset</source>
        <translation>Vorgabe wählen</translation>
    </message>
    <message>
        <source>Choose finish</source>
        <translation>Ausführung wählen</translation>
    </message>
    <message>
        <source>Choose look</source>
        <translation>Aussehen wählen</translation>
    </message>
    <message>
        <source>Change window</source>
        <translation>Grauwertfenster ändern</translation>
    </message>
    <message>
        <source>Show channel alone</source>
        <translation>Kanal allein zeigen</translation>
    </message>
    <message>
        <source>Change channel&apos;s colour</source>
        <translation>Farbe des Kanals ändern</translation>
    </message>
    <message>
        <source>Choose lit sphere</source>
        <translation>Lichtkugel wählen</translation>
    </message>
    <message>
        <source>Change rendering</source>
        <translation>Darstellung ändern</translation>
    </message>
    <message>
        <source>Make the look a surface</source>
        <translation>Aussehen zur Oberfläche machen</translation>
    </message>
    <message>
        <source>Import look</source>
        <translation>Aussehen importieren</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Add membrane</source>
        <translation>Membran hinzufügen</translation>
    </message>
    <message>
        <source>Protect values</source>
        <translation>Werte schützen</translation>
    </message>
    <message>
        <source>Add pin</source>
        <translation>Nadel hinzufügen</translation>
    </message>
    <message>
        <source>Change membrane: rule</source>
        <translation>Membran ändern: Regel</translation>
    </message>
    <message>
        <source>Move to keep</source>
        <translation>Dorthin, wo es erhalten bleibt</translation>
    </message>
    <message>
        <source>Bring model to size</source>
        <translation>Größe des Modells anpassen</translation>
    </message>
    <message>
        <source>Meet numbers to be seen</source>
        <translation>Sichtbare Anzahlen erreichen</translation>
    </message>
    <message>
        <source>Show whole</source>
        <translation>Ganz zeigen</translation>
    </message>
    <message>
        <source>Show cut</source>
        <translation>Geschnitten zeigen</translation>
    </message>
    <message>
        <source>Invert what is shown</source>
        <translation>Eingeblendetes umkehren</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>label</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Grauwertfenster</translation>
    </message>
    <message>
        <source>lit sphere</source>
        <translation>Lichtkugel</translation>
    </message>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>close other programs that draw, make the picture smaller, or lower VELUM_GPU_MEMORY_MB</source>
        <translation>andere Programme schließen, die zeichnen, das Bild kleiner machen oder VELUM_GPU_MEMORY_MB senken</translation>
    </message>
    <message>
        <source>the driver has no memory for %1 (%2): %3</source>
        <translation>der Treiber hat keinen Speicher für %1 (%2): %3</translation>
    </message>
    <message>
        <source>the driver has run out of memory: %1</source>
        <translation>dem Treiber ist der Speicher ausgegangen: %1</translation>
    </message>
    <message>
        <source>the driver cannot map %1 (%2 bytes): make the picture smaller</source>
        <translation>der Treiber kann %1 (%2 Bytes) nicht einblenden: das Bild kleiner machen</translation>
    </message>
    <message>
        <source>%1, and OpenGL 4.5 is needed: Mesa&apos;s software driver draws instead, which is slower; install or update the graphics driver to draw with the card</source>
        <translation>%1, und OpenGL 4.5 ist nötig: Stattdessen zeichnet der Softwaretreiber von Mesa, langsamer; mit einem neueren Grafiktreiber zeichnet die Karte</translation>
    </message>
    <message>
        <source>%1; OpenGL 4.5 is needed: install or update the graphics driver; Mesa&apos;s software driver will do, too%2</source>
        <translation>%1; OpenGL 4.5 ist nötig: den Grafiktreiber installieren oder aktualisieren; der Softwaretreiber von Mesa genügt%2</translation>
    </message>
    <message>
        <source> (it was tried: %1)</source>
        <translation> (er wurde versucht: %1)</translation>
    </message>
    <message>
        <source>VELUM_CONTEXT: &apos;%1&apos; is not one of auto, egl, osmesa</source>
        <translation>VELUM_CONTEXT: „%1“ ist keines von auto, egl, osmesa</translation>
    </message>
    <message>
        <source>the graphics driver has no %1</source>
        <translation>der Grafiktreiber hat kein %1</translation>
    </message>
    <message>
        <source>%1 offers OpenGL %2.%3</source>
        <translation>%1 bietet OpenGL %2.%3</translation>
    </message>
    <message>
        <source>%1 lacks %2 of OpenGL 4.5</source>
        <translation>%1 fehlt %2 aus OpenGL 4.5</translation>
    </message>
    <message>
        <source>the driver that GALLIUM_DRIVER names (%1) makes no OpenGL</source>
        <translation>der Treiber, den GALLIUM_DRIVER nennt (%1), bietet kein OpenGL</translation>
    </message>
    <message>
        <source>it needs %1 MiB, and the driver has %2 MiB for it</source>
        <translation>nötig sind %1 MiB, und der Treiber hat dafür %2 MiB</translation>
    </message>
    <message>
        <source>%1 has %2 item%3; [%4] is none of them: places begin with 0, an id is [#%5]</source>
        <translation>%1 hat %2 Einträge; [%4] ist keiner davon: die Zählung beginnt bei 0, eine Id ist [#%5]</translation>
    </message>
    <message>
        <source>%1: the file is there already; say where to save</source>
        <translation>%1: die Datei gibt es schon; angeben, wohin gespeichert wird</translation>
    </message>
    <message>
        <source>film.save turn.mp4 640x480</source>
        <translation>film.save turn.mp4 640x480</translation>
    </message>
    <message>
        <source>animate %1: not one of %2</source>
        <translation>animate %1: keines von %2</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is not one of %2</source>
        <translation>Schnittbild „%1“ ist keines von %2</translation>
    </message>
    <message>
        <source>bits %1: 8 or 16</source>
        <translation>bits %1: 8 oder 16</translation>
    </message>
    <message>
        <source>layers: a section has none; leave them out with section</source>
        <translation>layers: ein Schnittbild hat keine; bei section weglassen</translation>
    </message>
    <message>
        <source>seconds: the scene has a film of its own, of %1 s; set timeline.duration, timeline.rangeStart or timeline.rangeEnd, or choose another film with animate</source>
        <translation>seconds: die Szene hat einen eigenen Film von %1 s; timeline.duration, timeline.rangeStart oder timeline.rangeEnd setzen oder mit animate einen anderen Film wählen</translation>
    </message>
    <message>
        <source>seed %1: nothing is known of the values there; give the range</source>
        <translation>seed %1: die Werte dort sind unbekannt; den Bereich angeben</translation>
    </message>
    <message>
        <source>seed %1: the value there is %2, not from %3 to %4; choose another place, or the range</source>
        <translation>seed %1: der Wert dort ist %2, nicht von %3 bis %4; eine andere Stelle oder den Bereich wählen</translation>
    </message>
    <message>
        <source>seed or strokes are needed: a place on the structure</source>
        <translation>seed oder strokes sind nötig: eine Stelle auf der Struktur</translation>
    </message>
    <message>
        <source>this display (%1) gives windows no OpenGL</source>
        <translation>diese Anzeige (%1) gibt Fenstern kein OpenGL</translation>
    </message>
    <message>
        <source>parts are drawn of pictures in files: .png, .tif, .exr, and not of sections</source>
        <translation>Teile werden von Bildern in Dateien gezeichnet: .png, .tif, .exr, und nicht von Schnittbildern</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no argument here; these are %2; a text with = stands in quotes</source>
        <translation>„%1“ ist hier kein Argument; es gibt %2; ein Text mit = steht in Anführungszeichen</translation>
    </message>
    <message>
        <source>part %1/%2: the picture has %3 rows</source>
        <translation>Teil %1/%2: das Bild hat %3 Zeilen</translation>
    </message>
    <message>
        <source>%1: it is there, of all %2 parts</source>
        <translation>%1: ist da, aus allen %2 Teilen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 parts are there; it is put together when all are</source>
        <translation>%1: %2 von %3 Teilen sind da; zusammengesetzt wird es, wenn alle da sind</translation>
    </message>
    <message>
        <source>1 frame repeats a segment at its place; it is joined</source>
        <translation>1 Einzelbild wiederholt ein Segment an seinem Ort; es ist vereint</translation>
    </message>
    <message>
        <source>1 voxel belongs to several segments; the last one has it</source>
        <translation>1 Voxel gehört zu mehreren Segmenten; das letzte bekommt es</translation>
    </message>
    <message>
        <source>%1 name of a structure is changed: DICOM has %2 characters for it, and no backslash</source>
        <translation>%1 Name einer Struktur ist geändert: DICOM hat dafür %2 Zeichen und keinen umgekehrten Schrägstrich</translation>
    </message>
    <message>
        <source>1 voxel of the layers is of no segment; it is left out</source>
        <translation>1 Voxel der Ebenen gehört zu keinem Segment; es ist weggelassen</translation>
    </message>
    <message>
        <source>1 point or open line of the structure set is left out</source>
        <translation>1 Punkt oder offene Linie des Structure-Sets ist weggelassen</translation>
    </message>
    <message>
        <source>1 contour lies across the others and is left out</source>
        <translation>1 Kontur liegt quer zu den anderen und ist weggelassen</translation>
    </message>
    <message>
        <source>1 voxel belongs to several structures; the smaller one has it</source>
        <translation>1 Voxel gehört zu mehreren Strukturen; die kleinere bekommt es</translation>
    </message>
    <message>
        <source>1 structure has another id than in the file that it comes from; a store keeps that</source>
        <translation>1 Struktur hat eine andere Zahl als in der Datei, aus der sie kommt; ein Datenspeicher behält sie</translation>
    </message>
    <message>
        <source>1 name of a structure is changed: line ends, or what ends a name in XML, cannot stand in it</source>
        <translation>1 Name einer Struktur ist geändert: Zeilenenden, oder was in XML einen Namen beendet, können nicht darin stehen</translation>
    </message>
    <message>
        <source>balls stand for 1 type whose structure is not to be found</source>
        <translation>Kugeln stehen für 1 Typ, dessen Struktur nicht zu finden ist</translation>
    </message>
    <message>
        <source>balls stand for %1 type whose structure is not to be found, %2</source>
        <translation>Kugeln stehen für %1 Typ, dessen Struktur nicht zu finden ist: %2</translation>
    </message>
    <message>
        <source>the balls of 1 molecule become atoms without an element and a radius</source>
        <translation>die Kugeln von 1 Molekül werden zu Atomen ohne Element und Radius</translation>
    </message>
    <message>
        <source>1 strand is written as its instances, without its curve</source>
        <translation>1 Strang ist als seine Instanzen geschrieben, ohne seine Kurve</translation>
    </message>
    <message>
        <source>%1 of %2 integers of 64 bits has more digits than a double and is rounded</source>
        <translation>%1 von %2 ganzen Zahlen zu 64 Bit hat mehr Stellen als ein double und ist gerundet</translation>
    </message>
    <message>
        <source>(several fields)</source>
        <translation>(mehrere Felder)</translation>
    </message>
    <message>
        <source>1 image of another orientation was left out</source>
        <translation>1 Bild anderer Ausrichtung wurde weggelassen</translation>
    </message>
    <message>
        <source>1 image repeats the place of another and was left out</source>
        <translation>1 Bild wiederholt den Ort eines anderen und wurde weggelassen</translation>
    </message>
    <message>
        <source>%2%1 of %3 traces share a place with an earlier one; %4</source>
        <translation>%2%1 von %3 Spuren teilen den Ort einer früheren; %4</translation>
    </message>
    <message>
        <source>%1 of %2 traces is missing and shown as 0</source>
        <translation>%1 von %2 Spuren fehlt und wird als 0 gezeigt</translation>
    </message>
    <message>
        <source>%1 of %2 traces claims another length than the file&apos;s %3 samples, which was taken</source>
        <translation>%1 von %2 Spuren nennt eine andere Länge als die %3 Werte der Datei, die genommen wurde</translation>
    </message>
    <message>
        <source>Pull out</source>
        <translation>Herausziehen</translation>
    </message>
    <message>
        <source>the only frame could not be drawn (%1)</source>
        <translation>Das einzige Bild konnte nicht gezeichnet werden (%1)</translation>
    </message>
    <message>
        <source>1 segment has a number of its own here: in the file its value is another layer&apos;s, too</source>
        <translation>1 Segment hat hier eine eigene Zahl: in der Datei ist sein Wert auch der einer anderen Ebene</translation>
    </message>
    <message>
        <source>%2%1 of %3 traces has the place of an earlier one; %4</source>
        <translation>%2%1 von %3 Spuren hat den Ort einer früheren; %4</translation>
    </message>
    <message>
        <source>%1: put together of %2 parts</source>
        <translation>%1: aus %2 Teilen zusammengesetzt</translation>
    </message>
    <message>
        <source>the graphics driver was reset while it drew: draw again</source>
        <translation>der Grafiktreiber wurde beim Zeichnen zurückgesetzt: noch einmal zeichnen</translation>
    </message>
    <message>
        <source>the graphics driver is reset whenever it draws this: update it, or have Mesa&apos;s software driver draw, which is slower (LIBGL_ALWAYS_SOFTWARE=1)</source>
        <translation>der Grafiktreiber wird jedes Mal zurückgesetzt, wenn er dies zeichnet: ihn aktualisieren oder den Softwaretreiber von Mesa zeichnen lassen, der langsamer ist (LIBGL_ALWAYS_SOFTWARE=1)</translation>
    </message>
    <message>
        <source>the graphics driver was reset: the window has to be drawn anew</source>
        <translation>der Grafiktreiber wurde zurückgesetzt: das Fenster muss neu gezeichnet werden</translation>
    </message>
    <message>
        <source>the graphics driver makes no OpenGL context</source>
        <translation>der Grafiktreiber erzeugt keinen OpenGL-Kontext</translation>
    </message>
    <message>
        <source>%1 (libraries say: %2)</source>
        <translation>%1 (Bibliotheken melden: %2)</translation>
    </message>
</context>
<context>
    <name>Memory</name>
    <message>
        <source>balls of pixels</source>
        <translation>Kugeln der Pixel</translation>
    </message>
    <message>
        <source>bend stencils</source>
        <translation>Muster der Biegung</translation>
    </message>
    <message>
        <source>blocks of copies</source>
        <translation>Blöcke der Kopien</translation>
    </message>
    <message>
        <source>blue noise</source>
        <translation>blaues Rauschen</translation>
    </message>
    <message>
        <source>bricks of labels</source>
        <translation>Blöcke der Labels</translation>
    </message>
    <message>
        <source>bundles that may show</source>
        <translation>Bündel, die sichtbar sein können</translation>
    </message>
    <message>
        <source>cell ranges</source>
        <translation>Bereiche der Zellen</translation>
    </message>
    <message>
        <source>cloth</source>
        <translation>Tuchmodell</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>compartments of types</source>
        <translation>Kompartimente der Arten</translation>
    </message>
    <message>
        <source>copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>copies with slots</source>
        <translation>Kopien mit Plätzen</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>berichtigte Orte</translation>
    </message>
    <message>
        <source>counts of draws</source>
        <translation>Zahlen der Aufrufe</translation>
    </message>
    <message>
        <source>cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>depths of instances</source>
        <translation>Tiefen der Instanzen</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>Aufrufe</translation>
    </message>
    <message>
        <source>extinction table</source>
        <translation>Tabelle der Dichten</translation>
    </message>
    <message>
        <source>farthest depths</source>
        <translation>größte Tiefen</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>ghosts</source>
        <translation>Geisterbilder</translation>
    </message>
    <message>
        <source>gradients</source>
        <translation>Gradienten</translation>
    </message>
    <message>
        <source>grid of cuts</source>
        <translation>Gitter der Schnitte</translation>
    </message>
    <message>
        <source>instances of pixels</source>
        <translation>Instanzen der Pixel</translation>
    </message>
    <message>
        <source>instances seen</source>
        <translation>gesehene Instanzen</translation>
    </message>
    <message>
        <source>instances that are nearest</source>
        <translation>nächste Instanzen</translation>
    </message>
    <message>
        <source>kernels</source>
        <translation>Kernel</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>light extinction</source>
        <translation>Abschwächung des Lichts</translation>
    </message>
    <message>
        <source>light grid</source>
        <translation>Gitter des Lichts</translation>
    </message>
    <message>
        <source>lit spheres</source>
        <translation>Lichtkugeln</translation>
    </message>
    <message>
        <source>lit spheres of structures</source>
        <translation>Lichtkugeln der Strukturen</translation>
    </message>
    <message>
        <source>longest distance in a mask</source>
        <translation>größter Abstand in einer Maske</translation>
    </message>
    <message>
        <source>mask of a focus</source>
        <translation>Maske eines Fokus</translation>
    </message>
    <message>
        <source>means of structure shares</source>
        <translation>Mittel der Anteile der Strukturen</translation>
    </message>
    <message>
        <source>no cells</source>
        <translation>keine Zellen</translation>
    </message>
    <message>
        <source>no labels</source>
        <translation>keine Labels</translation>
    </message>
    <message>
        <source>no shares</source>
        <translation>keine Anteile</translation>
    </message>
    <message>
        <source>no volume</source>
        <translation>kein Volumen</translation>
    </message>
    <message>
        <source>normal, distance</source>
        <translation>Normale, Abstand</translation>
    </message>
    <message>
        <source>openness</source>
        <translation>Offenheit</translation>
    </message>
    <message>
        <source>own paper</source>
        <translation>eigenes Papier</translation>
    </message>
    <message>
        <source>pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>pages seen</source>
        <translation>gesehene Seiten</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>placed kernels</source>
        <translation>gesetzte Kernel</translation>
    </message>
    <message>
        <source>places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorausgesagte Orte</translation>
    </message>
    <message>
        <source>refined sheet</source>
        <translation>verfeinertes Tuch</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>seeds of a mask</source>
        <translation>Startpunkte einer Maske</translation>
    </message>
    <message>
        <source>shade of instances</source>
        <translation>Schattierung der Instanzen</translation>
    </message>
    <message>
        <source>sheets</source>
        <translation>Tücher</translation>
    </message>
    <message>
        <source>skip map</source>
        <translation>Karte des Leeren</translation>
    </message>
    <message>
        <source>slots of copies</source>
        <translation>Plätze der Kopien</translation>
    </message>
    <message>
        <source>spares</source>
        <translation>Schonung</translation>
    </message>
    <message>
        <source>spares of types</source>
        <translation>Schonung der Arten</translation>
    </message>
    <message>
        <source>states of instances</source>
        <translation>Zustände der Instanzen</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>structure covers</source>
        <translation>Hüllen der Strukturen</translation>
    </message>
    <message>
        <source>structure shares</source>
        <translation>Anteile der Strukturen</translation>
    </message>
    <message>
        <source>structure, instance</source>
        <translation>Struktur, Instanz</translation>
    </message>
    <message>
        <source>structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>sums</source>
        <translation>Summen</translation>
    </message>
    <message>
        <source>surface colour</source>
        <translation>Farbe der Oberfläche</translation>
    </message>
    <message>
        <source>surface depth</source>
        <translation>Tiefe der Oberfläche</translation>
    </message>
    <message>
        <source>surface ids</source>
        <translation>Kennungen der Oberfläche</translation>
    </message>
    <message>
        <source>surface normal, distance</source>
        <translation>Normale der Oberfläche, Abstand</translation>
    </message>
    <message>
        <source>transfer table</source>
        <translation>Tabelle der Transferfunktion</translation>
    </message>
    <message>
        <source>types</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>velocities</source>
        <translation>Geschwindigkeiten</translation>
    </message>
    <message>
        <source>view of a focus</source>
        <translation>Ansicht eines Fokus</translation>
    </message>
    <message>
        <source>view of states</source>
        <translation>Ansicht der Zustände</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>picture of a view</source>
        <translation>Bild einer Ansicht</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>%1 already exists.
Replace it?</source>
        <translation>%1 gibt es schon.
Ersetzen?</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Velum cannot start: %1</source>
        <translation>Velum kann nicht starten: %1</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Sort</source>
        <translation>Ordnen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorne</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>schräg</translation>
    </message>
</context>
<context>
    <name>SayTime</name>
    <message>
        <source>today %1</source>
        <translation>heute %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>gestern %1</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Add cut</source>
        <translation>Schnitt hinzufügen</translation>
    </message>
    <message>
        <source>Align cut</source>
        <translation>Schnitt ausrichten</translation>
    </message>
    <message>
        <source>Change tint</source>
        <translation>Tönung ändern</translation>
    </message>
    <message>
        <source>Choose channel</source>
        <translation>Kanal wählen</translation>
    </message>
    <message>
        <source>Choose paper</source>
        <translation>Papier wählen</translation>
    </message>
    <message>
        <source>Cut to pull out of</source>
        <translation>Schnitt zum Herausziehen</translation>
    </message>
    <message>
        <source>Fade what has no label</source>
        <translation>Verblassen lassen, was kein Label hat</translation>
    </message>
    <message>
        <source>Hide labels</source>
        <translation>Labels ausblenden</translation>
    </message>
    <message>
        <source>Hide model</source>
        <translation>Modell ausblenden</translation>
    </message>
    <message>
        <source>Hide the table</source>
        <translation>Tisch ausblenden</translation>
    </message>
    <message>
        <source>Hide this tissue</source>
        <translation>Dieses Gewebe ausblenden</translation>
    </message>
    <message>
        <source>Labels on sections</source>
        <translation>Labels auf Schnittbildern</translation>
    </message>
    <message>
        <source>Let sheet through</source>
        <translation>Tuch durchlassen</translation>
    </message>
    <message>
        <source>Move key of camera</source>
        <translation>Schlüsselbild der Kamera verschieben</translation>
    </message>
    <message>
        <source>Move point of mark</source>
        <translation>Punkt der Marke verschieben</translation>
    </message>
    <message>
        <source>Plane through three points</source>
        <translation>Ebene durch drei Punkte</translation>
    </message>
    <message>
        <source>Protect from sheet</source>
        <translation>Vor dem Tuch schützen</translation>
    </message>
    <message>
        <source>Pull sheet</source>
        <translation>Tuch heranziehen</translation>
    </message>
    <message>
        <source>Push sheet</source>
        <translation>Tuch wegdrücken</translation>
    </message>
    <message>
        <source>Show labels</source>
        <translation>Labels einblenden</translation>
    </message>
    <message>
        <source>Show model</source>
        <translation>Modell einblenden</translation>
    </message>
    <message>
        <source>Show the table</source>
        <translation>Tisch einblenden</translation>
    </message>
    <message>
        <source>Show thinned</source>
        <translation>Ausgedünnt zeigen</translation>
    </message>
    <message>
        <source>Show this tissue</source>
        <translation>Dieses Gewebe zeigen</translation>
    </message>
    <message>
        <source>Turn cut off</source>
        <translation>Schnitt ausschalten</translation>
    </message>
    <message>
        <source>Turn cut on</source>
        <translation>Schnitt einschalten</translation>
    </message>
    <message>
        <source>Turn force</source>
        <translation>Kraft drehen</translation>
    </message>
    <message>
        <source>Move opacity point</source>
        <translation>Punkt der Deckkraft verschieben</translation>
    </message>
    <message>
        <source>Add opacity point</source>
        <translation>Punkt der Deckkraft hinzufügen</translation>
    </message>
    <message>
        <source>Remove opacity point</source>
        <translation>Punkt der Deckkraft entfernen</translation>
    </message>
    <message>
        <source>Move gradient point</source>
        <translation>Punkt des Gradienten verschieben</translation>
    </message>
    <message>
        <source>Add gradient point</source>
        <translation>Punkt des Gradienten hinzufügen</translation>
    </message>
    <message>
        <source>Remove gradient point</source>
        <translation>Punkt des Gradienten entfernen</translation>
    </message>
    <message>
        <source>Add force to %1</source>
        <translation>Kraft hinzufügen: %1</translation>
    </message>
    <message>
        <source>Add to %1</source>
        <translation>%1 ergänzen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Hinzufügen: %1</translation>
    </message>
    <message>
        <source>Change growth of %1</source>
        <translation>Wachsen ändern: %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Ändern: %1</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>%1 färben</translation>
    </message>
    <message>
        <source>Draw membrane to %1</source>
        <translation>Membran heranziehen: %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>End solo of %1</source>
        <translation>Allein beenden: %1</translation>
    </message>
    <message>
        <source>Forget %1</source>
        <translation>%1 vergessen</translation>
    </message>
    <message>
        <source>Ghosts of %1</source>
        <translation>Geisterbilder: %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Keep %1</source>
        <translation>%1 behalten</translation>
    </message>
    <message>
        <source>Leave of %1</source>
        <translation>Übrig lassen: %1</translation>
    </message>
    <message>
        <source>Leave %1</source>
        <translation>%1 übrig lassen</translation>
    </message>
    <message>
        <source>Let follow the group: %1</source>
        <translation>Der Gruppe folgen lassen: %1</translation>
    </message>
    <message>
        <source>List in legend: %1</source>
        <translation>In Legende aufnehmen: %1</translation>
    </message>
    <message>
        <source>Lit sphere of %1</source>
        <translation>Lichtkugel: %1</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name: %1</translation>
    </message>
    <message>
        <source>No force of %1</source>
        <translation>Keine Kraft: %1</translation>
    </message>
    <message>
        <source>Not this: %1</source>
        <translation>Dies nicht: %1</translation>
    </message>
    <message>
        <source>Opacity of %1</source>
        <translation>Deckkraft: %1</translation>
    </message>
    <message>
        <source>Palette&apos;s colour of %1</source>
        <translation>Farbe der Palette: %1</translation>
    </message>
    <message>
        <source>Protect by membrane: %1</source>
        <translation>Durch Membran schützen: %1</translation>
    </message>
    <message>
        <source>Pull out %1</source>
        <translation>%1 herausziehen</translation>
    </message>
    <message>
        <source>Put back %1</source>
        <translation>%1 zurücklegen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Show as material: %1</source>
        <translation>Als Material zeigen: %1</translation>
    </message>
    <message>
        <source>Show solid: %1</source>
        <translation>Massiv zeigen: %1</translation>
    </message>
    <message>
        <source>Show whole %1</source>
        <translation>%1 ganz zeigen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 einblenden</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 glätten</translation>
    </message>
    <message>
        <source>Solo %1</source>
        <translation>Allein: %1</translation>
    </message>
    <message>
        <source>Spare %1</source>
        <translation>%1 aussparen</translation>
    </message>
    <message>
        <source>Style of lettering: %1</source>
        <translation>Stil der Schrift: %1</translation>
    </message>
    <message>
        <source>Take out of legend: %1</source>
        <translation>Aus Legende nehmen: %1</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>Measure a distance: click two points, in the picture or on sections</source>
        <translation>Abstand messen: zwei Punkte anklicken, im Bild oder auf Schnittbildern</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Measure an angle: click three points, the second is where its legs meet</source>
        <translation>Winkel messen: drei Punkte anklicken, im zweiten treffen sich die Schenkel</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>W&amp;eg</translation>
    </message>
    <message>
        <source>Measure a way along points; a double click or Enter ends it</source>
        <translation>Weg entlang von Punkten messen; Doppelklick oder Eingabe beendet ihn</translation>
    </message>
    <message>
        <source>A&amp;rea</source>
        <translation>&amp;Fläche</translation>
    </message>
    <message>
        <source>Measure the area within points; a double click or Enter ends it</source>
        <translation>Fläche zwischen Punkten messen; Doppelklick oder Eingabe beendet sie</translation>
    </message>
    <message>
        <source>Arro&amp;w</source>
        <translation>&amp;Pfeil</translation>
    </message>
    <message>
        <source>Point at something: click where the arrow begins, then its head</source>
        <translation>Auf etwas zeigen: den Anfang des Pfeils anklicken, dann die Spitze</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>Te&amp;xt</translation>
    </message>
    <message>
        <source>Write words beside a place: click it, then type</source>
        <translation>Wörter neben eine Stelle schreiben: sie anklicken, dann tippen</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Name structures and molecules: click them</source>
        <translation>Strukturen und Moleküle benennen: sie anklicken</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>&amp;Kreis</translation>
    </message>
    <message>
        <source>Values in a ball: click its middle, then its rim</source>
        <translation>Werte in einer Kugel: die Mitte anklicken, dann den Rand</translation>
    </message>
    <message>
        <source>&amp;Box</source>
        <translation>&amp;Quader</translation>
    </message>
    <message>
        <source>Values in a box along the volume&apos;s axes: click two corners</source>
        <translation>Werte in einem Quader entlang der Achsen des Volumens: zwei Ecken anklicken</translation>
    </message>
    <message>
        <source>Pro&amp;file</source>
        <translation>P&amp;rofil</translation>
    </message>
    <message>
        <source>Values along a line: click its two ends</source>
        <translation>Werte entlang einer Linie: beide Enden anklicken</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Stays until the next key</source>
        <translation>Bleibt bis zum nächsten Schlüsselbild</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Goes evenly to the next key</source>
        <translation>Geht gleichmäßig zum nächsten Schlüsselbild</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>Begins slowly</source>
        <translation>Beginnt langsam</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Auslauf</translation>
    </message>
    <message>
        <source>Ends slowly</source>
        <translation>Endet langsam</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beides</translation>
    </message>
    <message>
        <source>Begins and ends slowly, at rest in each key</source>
        <translation>Beginnt und endet langsam, in jedem Schlüsselbild in Ruhe</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Passes the keys between without a stop</source>
        <translation>Geht ohne Halt durch die Schlüsselbilder dazwischen</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>&amp;Turntable</source>
        <translation>&amp;Drehteller</translation>
    </message>
    <message>
        <source>The eye goes round the data</source>
        <translation>Das Auge geht um die Daten herum</translation>
    </message>
    <message>
        <source>&amp;Cuts come in</source>
        <translation>&amp;Schnitte kommen</translation>
    </message>
    <message>
        <source>Cuts come in from where the data ends</source>
        <translation>Schnitte kommen vom Ende der Daten herein</translation>
    </message>
    <message>
        <source>&amp;Membranes sink in</source>
        <translation>&amp;Membranen sinken ein</translation>
    </message>
    <message>
        <source>Membranes sink into the data</source>
        <translation>Membranen sinken in die Daten</translation>
    </message>
    <message>
        <source>&amp;Pull out</source>
        <translation>&amp;Herausziehen</translation>
    </message>
    <message>
        <source>Structures come out of the cuts one after the other</source>
        <translation>Strukturen kommen nacheinander aus den Schnitten</translation>
    </message>
    <message>
        <source>&amp;Equalize</source>
        <translation>&amp;Abgleichen</translation>
    </message>
    <message>
        <source>A model from whole, over all that its cuts can take, to what they leave</source>
        <translation>Ein Modell vom Ganzen, über alles, was seine Schnitte nehmen können, zu dem, was sie übrig lassen</translation>
    </message>
    <message>
        <source>&amp;Fly to a structure</source>
        <translation>&amp;Flug zu einer Struktur</translation>
    </message>
    <message>
        <source>The eye goes to a structure</source>
        <translation>Das Auge geht zu einer Struktur</translation>
    </message>
    <message>
        <source>Time &amp;steps</source>
        <translation>&amp;Zeitschritte</translation>
    </message>
    <message>
        <source>The volume goes through its time steps</source>
        <translation>Das Volumen geht durch seine Zeitschritte</translation>
    </message>
    <message>
        <source>&amp;Before and after</source>
        <translation>&amp;Vorher und nachher</translation>
    </message>
    <message>
        <source>Whole, then cut open</source>
        <translation>Ganz, dann aufgeschnitten</translation>
    </message>
    <message>
        <source>T&amp;itle</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>Words over the picture come and go</source>
        <translation>Wörter über dem Bild kommen und gehen</translation>
    </message>
    <message>
        <source>MP4 video (H.264)</source>
        <translation>MP4-Video (H.264)</translation>
    </message>
    <message>
        <source>WebM video (VP9)</source>
        <translation>WebM-Video (VP9)</translation>
    </message>
    <message>
        <source>GIF</source>
        <translation>GIF</translation>
    </message>
    <message>
        <source>PNG frames</source>
        <translation>PNG-Einzelbilder</translation>
    </message>
    <message>
        <source>EXR frames</source>
        <translation>EXR-Einzelbilder</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>V&amp;ier Ansichten</translation>
    </message>
    <message>
        <source>&amp;Soft tissue</source>
        <translation>&amp;Weichteile</translation>
    </message>
    <message>
        <source>&amp;Abdomen</source>
        <translation>&amp;Abdomen</translation>
    </message>
    <message>
        <source>&amp;Lung</source>
        <translation>&amp;Lunge</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Knochen</translation>
    </message>
    <message>
        <source>B&amp;rain</source>
        <translation>&amp;Gehirn</translation>
    </message>
    <message>
        <source>An&amp;giography</source>
        <translation>A&amp;ngiographie</translation>
    </message>
    <message>
        <source>SUV 0 to &amp;5</source>
        <translation>SUV 0 bis &amp;5</translation>
    </message>
    <message>
        <source>SUV 0 to 1&amp;0</source>
        <translation>SUV 0 bis 1&amp;0</translation>
    </message>
    <message>
        <source>SUV 0 to &amp;20</source>
        <translation>SUV 0 bis &amp;20</translation>
    </message>
    <message>
        <source>CT of a trunk, 0.7 × 0.7 × 1 mm</source>
        <translation>CT eines Rumpfes, 0,7 × 0,7 × 1 mm</translation>
    </message>
    <message>
        <source>MR of a head, 1 mm</source>
        <translation>MR eines Kopfes, 1 mm</translation>
    </message>
    <message>
        <source>Micro-CT, 10 µm</source>
        <translation>Mikro-CT, 10 µm</translation>
    </message>
    <message>
        <source>Light sheet 5×, 1.3 × 1.3 × 5 µm</source>
        <translation>Lichtblatt 5×, 1,3 × 1,3 × 5 µm</translation>
    </message>
    <message>
        <source>Confocal 20×, 0.62 × 0.62 × 2 µm</source>
        <translation>Konfokal 20×, 0,62 × 0,62 × 2 µm</translation>
    </message>
    <message>
        <source>Confocal 40×, 0.31 × 0.31 × 1 µm</source>
        <translation>Konfokal 40×, 0,31 × 0,31 × 1 µm</translation>
    </message>
    <message>
        <source>Confocal 63×, 0.2 × 0.2 × 0.5 µm</source>
        <translation>Konfokal 63×, 0,2 × 0,2 × 0,5 µm</translation>
    </message>
    <message>
        <source>Electron microscope, 10 nm</source>
        <translation>Elektronenmikroskop, 10 nm</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>A&amp;ussehen</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Schnitt</translation>
    </message>
    <message>
        <source>&amp;Structures</source>
        <translation>St&amp;rukturen</translation>
    </message>
    <message>
        <source>Mar&amp;ks</source>
        <translation>&amp;Marken</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>&amp;Zeit</translation>
    </message>
    <message>
        <source>Fil&amp;m</source>
        <translation>&amp;Film</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>CT: bone</source>
        <translation>CT: Knochen</translation>
    </message>
    <message>
        <source>CT: skin</source>
        <translation>CT: Haut</translation>
    </message>
    <message>
        <source>CT: skin over bone</source>
        <translation>CT: Haut über Knochen</translation>
    </message>
    <message>
        <source>CT: skin, white bone beneath</source>
        <translation>CT: Haut, weißer Knochen darunter</translation>
    </message>
    <message>
        <source>CT: muscle and organs</source>
        <translation>CT: Muskeln und Organe</translation>
    </message>
    <message>
        <source>CT: lung</source>
        <translation>CT: Lunge</translation>
    </message>
    <message>
        <source>CT: contrast vessels and bone</source>
        <translation>CT: Gefäße mit Kontrast und Knochen</translation>
    </message>
    <message>
        <source>CT of 8 bits: bone</source>
        <translation>CT mit 8 Bit: Knochen</translation>
    </message>
    <message>
        <source>PET: hot metal</source>
        <translation>PET: glühendes Metall</translation>
    </message>
    <message>
        <source>PET: inverse grey</source>
        <translation>PET: umgekehrtes Grau</translation>
    </message>
    <message>
        <source>MR: head</source>
        <translation>MR: Kopf</translation>
    </message>
    <message>
        <source>MR: brain</source>
        <translation>MR: Gehirn</translation>
    </message>
    <message>
        <source>Angiography: vessels</source>
        <translation>Angiographie: Gefäße</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>Ultramicroscopy: tissue</source>
        <translation>Ultramikroskopie: Gewebe</translation>
    </message>
    <message>
        <source>Microscopy: bright structures</source>
        <translation>Mikroskopie: helle Strukturen</translation>
    </message>
    <message>
        <source>Micro-CT: hard over soft</source>
        <translation>Mikro-CT: Hartes über Weichem</translation>
    </message>
    <message>
        <source>Seismic amplitudes</source>
        <translation>Seismische Amplituden</translation>
    </message>
    <message>
        <source>Seismic velocities</source>
        <translation>Seismische Geschwindigkeiten</translation>
    </message>
    <message>
        <source>First guess</source>
        <translation>Erste Vermutung</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>Sizes go with the picture&apos;s rows; no page</source>
        <translation>Größen richten sich nach den Zeilen des Bildes; keine Seite</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Zeitschrift</translation>
    </message>
    <message>
        <source>A figure of a journal: 7 point letters without serifs, fine lines</source>
        <translation>Abbildung einer Zeitschrift: Buchstaben von 7 Punkt ohne Serifen, feine Linien</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>A plate of a book: letters with serifs, hairlines, little halo</source>
        <translation>Tafel eines Buches: Buchstaben mit Serifen, Haarlinien, wenig Saum</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>Wandtafel</translation>
    </message>
    <message>
        <source>Light and large, for dark grounds and talks</source>
        <translation>Hell und groß, für dunkle Gründe und Vorträge</translation>
    </message>
    <message>
        <source>Poster</source>
        <translation>Poster</translation>
    </message>
    <message>
        <source>Heavy letters that are read from two metres</source>
        <translation>Kräftige Buchstaben, aus zwei Metern lesbar</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Gemalt</translation>
    </message>
    <message>
        <source>Flat calm colours and outlines, as cells are painted</source>
        <translation>Flächige ruhige Farben und Umrisse, wie Zellen gemalt werden</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Light from the side, shadows, and darkness in the depths; no outlines</source>
        <translation>Licht von der Seite, Schatten und Dunkel in der Tiefe; keine Umrisse</translation>
    </message>
    <message>
        <source>Technical</source>
        <translation>Technisch</translation>
    </message>
    <message>
        <source>Atoms by their element, in plain light</source>
        <translation>Atome nach ihrem Element, in schlichtem Licht</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>The picture as it is</source>
        <translation>Das Bild, wie es ist</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>A plate of an atlas: half the lit spheres, dark contours, smooth paper</source>
        <translation>Tafel eines Atlas: halb Lichtkugeln, dunkle Konturen, glattes Papier</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>Aquarell</translation>
    </message>
    <message>
        <source>Light washes with fine outlines on rough paper</source>
        <translation>Helle Lasuren mit feinen Umrissen auf rauem Papier</translation>
    </message>
    <message>
        <source>Gouache</source>
        <translation>Gouache</translation>
    </message>
    <message>
        <source>Opaque colours on canvas</source>
        <translation>Deckende Farben auf Leinwand</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Bleistift</translation>
    </message>
    <message>
        <source>Grey tones with strokes along the form</source>
        <translation>Grautöne mit Strichen entlang der Form</translation>
    </message>
    <message>
        <source>Pen and ink</source>
        <translation>Feder und Tusche</translation>
    </message>
    <message>
        <source>Black outlines and strokes on white</source>
        <translation>Schwarze Umrisse und Striche auf Weiß</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>Kupferstich</translation>
    </message>
    <message>
        <source>Brown lines along the form on laid paper</source>
        <translation>Braune Linien entlang der Form auf geripptem Papier</translation>
    </message>
    <message>
        <source>Sepia</source>
        <translation>Sepia</translation>
    </message>
    <message>
        <source>An old master&apos;s study on parchment</source>
        <translation>Studie eines alten Meisters auf Pergament</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>Kohle</translation>
    </message>
    <message>
        <source>Deep shade and broad lines on grey paper</source>
        <translation>Tiefe Schatten und breite Linien auf grauem Papier</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Kreide</translation>
    </message>
    <message>
        <source>Light on a dark board</source>
        <translation>Hell auf dunkler Tafel</translation>
    </message>
    <message>
        <source>Wax model</source>
        <translation>Wachsmodell</translation>
    </message>
    <message>
        <source>As a model of an old collection, on linen</source>
        <translation>Wie ein Modell einer alten Sammlung, auf Leinen</translation>
    </message>
    <message>
        <source>Cartoon</source>
        <translation>Comic</translation>
    </message>
    <message>
        <source>Few tones and bold outlines</source>
        <translation>Wenige Töne und kräftige Umrisse</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgenbild</translation>
    </message>
    <message>
        <source>Light edges on black</source>
        <translation>Helle Kanten auf Schwarz</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tusche</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Ivory</source>
        <translation>Elfenbein</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Dark skin</source>
        <translation>Dunkle Haut</translation>
    </message>
    <message>
        <source>Flesh</source>
        <translation>Fleisch</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Arterie</translation>
    </message>
    <message>
        <source>Vein</source>
        <translation>Vene</translation>
    </message>
    <message>
        <source>Nerve</source>
        <translation>Nerv</translation>
    </message>
    <message>
        <source>Cartilage</source>
        <translation>Knorpel</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Wachs</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>Porzellan</translation>
    </message>
    <message>
        <source>Plaster</source>
        <translation>Gips</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>Jade</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Pearl</source>
        <translation>Perlmutt</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>Samt</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronze</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>Silber</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>Gold</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Angiography</source>
        <translation>Angiographie</translation>
    </message>
    <message>
        <source>0 to 5</source>
        <translation>0 bis 5</translation>
    </message>
    <message>
        <source>0 to 10</source>
        <translation>0 bis 10</translation>
    </message>
    <message>
        <source>0 to 20</source>
        <translation>0 bis 20</translation>
    </message>
    <message>
        <source>A head</source>
        <translation>Ein Kopf</translation>
    </message>
    <message>
        <source>a membrane goes round the skull</source>
        <translation>eine Membran um den Schädel</translation>
    </message>
    <message>
        <source>A trunk</source>
        <translation>Ein Rumpf</translation>
    </message>
    <message>
        <source>organs pulled out of a cut</source>
        <translation>Organe, herausgezogen</translation>
    </message>
    <message>
        <source>A virus</source>
        <translation>Ein Virus</translation>
    </message>
    <message>
        <source>a cell model, cut open</source>
        <translation>ein Zellmodell, aufgeschnitten</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Add &amp;box</source>
        <translation>&amp;Quader hinzufügen</translation>
    </message>
    <message>
        <source>x </source>
        <translation>x </translation>
    </message>
    <message>
        <source>y </source>
        <translation>y </translation>
    </message>
    <message>
        <source>z </source>
        <translation>z </translation>
    </message>
    <message>
        <source>Edge along the box&apos;s x</source>
        <translation>Kante entlang x des Quaders</translation>
    </message>
    <message>
        <source>Edge along the box&apos;s y</source>
        <translation>Kante entlang y des Quaders</translation>
    </message>
    <message>
        <source>Edge along the box&apos;s axis</source>
        <translation>Kante entlang der Achse des Quaders</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Add sp&amp;here</source>
        <translation>K&amp;ugel hinzufügen</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Add c&amp;ylinder</source>
        <translation>&amp;Zylinder hinzufügen</translation>
    </message>
    <message>
        <source>long </source>
        <translation>lang </translation>
    </message>
    <message>
        <source>Length along the axis</source>
        <translation>Länge entlang der Achse</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Add co&amp;ne</source>
        <translation>Kege&amp;l hinzufügen</translation>
    </message>
    <message>
        <source>Diameter of the base</source>
        <translation>Durchmesser der Grundfläche</translation>
    </message>
    <message>
        <source>high </source>
        <translation>hoch </translation>
    </message>
    <message>
        <source>Height from apex to base</source>
        <translation>Höhe von der Spitze zur Grundfläche</translation>
    </message>
    <message>
        <source>Membrane</source>
        <translation>Membran</translation>
    </message>
    <message>
        <source>Width of the rest plane</source>
        <translation>Breite der Ruheebene</translation>
    </message>
    <message>
        <source>Height of the rest plane</source>
        <translation>Höhe der Ruheebene</translation>
    </message>
    <message>
        <source>reach </source>
        <translation>Reichw. </translation>
    </message>
    <message>
        <source>How far the sheet may go, both sides together: half of it to either side of the rest plane</source>
        <translation>Wie weit das Tuch gehen darf, beide Seiten zusammen: je die Hälfte auf jeder Seite der Ruheebene</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Add a cut &amp;everywhere</source>
        <translation>Schnitt ü&amp;berall hinzufügen</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Drawn, but hidden behind others or outside the picture</source>
        <translation>Gezeichnet, aber hinter anderen verdeckt oder außerhalb des Bildes</translation>
    </message>
    <message>
        <source>Removed by cuts or not shown</source>
        <translation>Von Schnitten entfernt oder ausgeblendet</translation>
    </message>
    <message>
        <source>%1 % show it</source>
        <translation>%1 % zeigen es</translation>
    </message>
    <message>
        <source>on %1 % it is behind others</source>
        <translation>auf %1 % liegt es hinter anderem</translation>
    </message>
    <message>
        <source>on %1 % cuts remove it</source>
        <translation>auf %1 % entfernen es Schnitte</translation>
    </message>
    <message>
        <source>The reach is short.</source>
        <translation>Die Reichweite ist kurz.</translation>
    </message>
    <message>
        <source>The frame stands where it cannot keep more.</source>
        <translation>Der Rahmen steht, wo er nicht mehr erhalten kann.</translation>
    </message>
    <message>
        <source>Too much is protected.</source>
        <translation>Zu viel ist geschützt.</translation>
    </message>
    <message>
        <source>The cuts leave nothing of what the scene shows: flip a cut, move it, or turn it off</source>
        <translation>Die Schnitte lassen nichts von dem übrig, was die Szene zeigt: einen Schnitt wenden, verschieben oder ausschalten</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Particles along the rest plane&apos;s width and height.</source>
        <translation>Partikel entlang Breite und Höhe der Ruheebene.</translation>
    </message>
    <message>
        <source>At rest the sheet is refined up to so many along an edge.</source>
        <translation>In Ruhe wird das Tuch bis zu so vielen entlang einer Kante verfeinert.</translation>
    </message>
    <message>
        <source>Stiffness against stretching.</source>
        <translation>Steifheit gegen Dehnen.</translation>
    </message>
    <message>
        <source>Stiffness against bending.</source>
        <translation>Steifheit gegen Biegen.</translation>
    </message>
    <message>
        <source>Pull back to the rest plane.</source>
        <translation>Rückzug zur Ruheebene.</translation>
    </message>
    <message>
        <source>How the sheet itself is shown: hidden, grid, surface.</source>
        <translation>Wie das Tuch selbst gezeigt wird: ausgeblendet, Gitter, Oberfläche.</translation>
    </message>
    <message>
        <source>Opacity of an inlay&apos;s image.</source>
        <translation>Deckkraft des Bildes eines Inlays.</translation>
    </message>
    <message>
        <source>-1: only behind the rest plane; 1: only in front; 0: both.</source>
        <translation>-1: nur hinter der Ruheebene; 1: nur davor; 0: beides.</translation>
    </message>
    <message>
        <source>Distance at which structures have faded; 0: the reach.</source>
        <translation>Abstand, in dem Strukturen verblasst sind; 0: die Reichweite.</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>Gently</source>
        <translation>Sanft</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Ein und aus</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Top left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>How long it takes.</source>
        <translation>Wie lange es dauert.</translation>
    </message>
    <message>
        <source>How often the eye goes round; below 0: the other way.</source>
        <translation>Wie oft das Auge herumgeht; unter 0: andersherum.</translation>
    </message>
    <message>
        <source>Begins and ends at rest.</source>
        <translation>Beginnt und endet in Ruhe.</translation>
    </message>
    <message>
        <source>When it begins.</source>
        <translation>Wann es beginnt.</translation>
    </message>
    <message>
        <source>Which one comes in; nothing: all that are on.</source>
        <translation>Welcher hereinkommt; nichts: alle eingeschalteten.</translation>
    </message>
    <message>
        <source>Goes out again in the second half.</source>
        <translation>Geht in der zweiten Hälfte wieder hinaus.</translation>
    </message>
    <message>
        <source>0: one after the other; 1: all at once.</source>
        <translation>0: nacheinander; 1: alle zugleich.</translation>
    </message>
    <message>
        <source>Share of the time that all stand out at the end.</source>
        <translation>Anteil der Zeit, in der am Ende alle herausragen.</translation>
    </message>
    <message>
        <source>Share of the time in which nothing changes.</source>
        <translation>Anteil der Zeit, in der sich nichts ändert.</translation>
    </message>
    <message>
        <source>Its name or number.</source>
        <translation>Ihr Name oder ihre Nummer.</translation>
    </message>
    <message>
        <source>How much of the picture&apos;s height the ball about it is to fill.</source>
        <translation>Wie viel der Höhe des Bildes die Kugel um sie füllen soll.</translation>
    </message>
    <message>
        <source>How often it goes through its time steps.</source>
        <translation>Wie oft es durch seine Zeitschritte geht.</translation>
    </message>
    <message>
        <source>The words.</source>
        <translation>Die Wörter.</translation>
    </message>
    <message>
        <source>How long it takes to come, and to go.</source>
        <translation>Wie lange es zum Kommen und zum Gehen braucht.</translation>
    </message>
    <message>
        <source>Where it stands.</source>
        <translation>Wo es steht.</translation>
    </message>
    <message>
        <source>Opens a file or folder in the place of what is open.</source>
        <translation>Öffnet eine Datei oder einen Ordner anstelle des Geöffneten.</translation>
    </message>
    <message>
        <source>Adds labels, a surface or a model beside what is open.</source>
        <translation>Fügt Labels, eine Oberfläche oder ein Modell zum Geöffneten hinzu.</translation>
    </message>
    <message>
        <source>Takes the scene and its film over to other data, such as another patient.</source>
        <translation>Überträgt die Szene und ihren Film auf andere Daten, etwa einen anderen Patienten.</translation>
    </message>
    <message>
        <source>Writes the scene: what is open, and how it is shown.</source>
        <translation>Schreibt die Szene: was geöffnet ist und wie es gezeigt wird.</translation>
    </message>
    <message>
        <source>Makes a picture of the scene, with the scene inside.</source>
        <translation>Macht ein Bild der Szene, das die Szene enthält.</translation>
    </message>
    <message>
        <source>Sets a field of the scene, with all that follows from it.</source>
        <translation>Setzt ein Feld der Szene, mit allem, was daraus folgt.</translation>
    </message>
    <message>
        <source>Tells what a field of the scene is, as set takes it.</source>
        <translation>Nennt ein Feld der Szene so, wie set es annimmt.</translation>
    </message>
    <message>
        <source>Takes the last change back.</source>
        <translation>Nimmt die letzte Änderung zurück.</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>Wiederholt, was zurückgenommen wurde.</translation>
    </message>
    <message>
        <source>Waits until sheets rest and all has grown.</source>
        <translation>Wartet, bis Tücher ruhen und alles gewachsen ist.</translation>
    </message>
    <message>
        <source>Tells the commands that lead to what is open, a line each: a script.</source>
        <translation>Nennt die Befehle, die zum Geöffneten führen, je eine Zeile: ein Skript.</translation>
    </message>
    <message>
        <source>Looks at all that is seen from one side.</source>
        <translation>Blickt von einer Seite auf alles Sichtbare.</translation>
    </message>
    <message>
        <source>Looks at all that is seen as when data is opened.</source>
        <translation>Blickt auf alles Sichtbare wie beim Öffnen von Daten.</translation>
    </message>
    <message>
        <source>Puts the crosshair in a place.</source>
        <translation>Setzt das Fadenkreuz an einen Ort.</translation>
    </message>
    <message>
        <source>Chooses which views there are.</source>
        <translation>Wählt, welche Ansichten es gibt.</translation>
    </message>
    <message>
        <source>Adds a cut where it is of use at once.</source>
        <translation>Fügt einen Schnitt hinzu, wo er sofort nützt.</translation>
    </message>
    <message>
        <source>Adds a plane through the middle that faces the eye.</source>
        <translation>Fügt eine Ebene durch die Mitte hinzu, quer zur Blickrichtung.</translation>
    </message>
    <message>
        <source>Removes a cut.</source>
        <translation>Entfernt einen Schnitt.</translation>
    </message>
    <message>
        <source>Adds a copy of a cut, right behind it.</source>
        <translation>Fügt eine Kopie eines Schnitts hinzu, gleich nach ihm.</translation>
    </message>
    <message>
        <source>Puts a cut elsewhere, with what was pulled out of it.</source>
        <translation>Setzt einen Schnitt an einen anderen Ort, mit dem, was aus ihm herausgezogen ist.</translation>
    </message>
    <message>
        <source>Lets a cut take away the other side.</source>
        <translation>Lässt einen Schnitt die andere Seite wegnehmen.</translation>
    </message>
    <message>
        <source>Turns a cut on or off.</source>
        <translation>Schaltet einen Schnitt ein oder aus.</translation>
    </message>
    <message>
        <source>Gives a cut another name.</source>
        <translation>Gibt einem Schnitt einen anderen Namen.</translation>
    </message>
    <message>
        <source>Moves a cut up or down in the list.</source>
        <translation>Schiebt einen Schnitt in der Liste nach oben oder unten.</translation>
    </message>
    <message>
        <source>Adds a membrane that protects what is said, as far as it can.</source>
        <translation>Fügt eine Membran hinzu, die das Genannte schützt, so weit sie kann.</translation>
    </message>
    <message>
        <source>Lets a membrane&apos;s sheet go around all values of a range.</source>
        <translation>Lässt das Tuch einer Membran um alle Werte eines Bereichs herumgehen.</translation>
    </message>
    <message>
        <source>Lets the sheet go around material like that in a place: what a click does.</source>
        <translation>Lässt das Tuch um Material wie an einem Ort herumgehen: was ein Klick tut.</translation>
    </message>
    <message>
        <source>Puts a ball in that pushes the sheet away or draws it.</source>
        <translation>Setzt eine Kugel ein, die das Tuch wegdrückt oder heranzieht.</translation>
    </message>
    <message>
        <source>Holds the sheet in a place.</source>
        <translation>Hält das Tuch an einem Ort.</translation>
    </message>
    <message>
        <source>Chooses how kernels push, with the cloth that goes with it.</source>
        <translation>Wählt, wie Kernel drücken, mit dem dazugehörigen Tuch.</translation>
    </message>
    <message>
        <source>Moves a membrane along its axis to where it keeps what it protects.</source>
        <translation>Schiebt eine Membran entlang ihrer Achse dorthin, wo sie erhält, was sie schützt.</translation>
    </message>
    <message>
        <source>Pulls a structure out of a cut.</source>
        <translation>Zieht eine Struktur aus einem Schnitt.</translation>
    </message>
    <message>
        <source>Puts back what stands out.</source>
        <translation>Legt zurück, was herausragt.</translation>
    </message>
    <message>
        <source>Puts back all that stands out.</source>
        <translation>Legt alles zurück, was herausragt.</translation>
    </message>
    <message>
        <source>Adds a second plane across one, so that the two open a wedge.</source>
        <translation>Fügt eine zweite Ebene quer zu einer hinzu, sodass beide einen Keil öffnen.</translation>
    </message>
    <message>
        <source>Grows a structure out of the volume, from places on it.</source>
        <translation>Lässt eine Struktur aus dem Volumen wachsen, von Stellen auf ihr aus.</translation>
    </message>
    <message>
        <source>Pulls out of a cut what is in a place of its face; what has no label grows from there.</source>
        <translation>Zieht aus einem Schnitt, was an einer Stelle seiner Schnittfläche ist; was kein Label hat, wächst von dort.</translation>
    </message>
    <message>
        <source>Lets a structure that was grown go on from another place.</source>
        <translation>Lässt eine gewachsene Struktur von einer anderen Stelle aus weitergehen.</translation>
    </message>
    <message>
        <source>Says of a place that it is not of a structure that was grown.</source>
        <translation>Sagt von einer Stelle, dass sie nicht zu einer gewachsenen Struktur gehört.</translation>
    </message>
    <message>
        <source>Lets a structure that was held grow as far as it is pulled, and minds no leak of it any more.</source>
        <translation>Lässt eine gehaltene Struktur so weit wachsen, wie sie gezogen wird, und achtet auf kein Auslaufen mehr.</translation>
    </message>
    <message>
        <source>Ends what is growing: what has grown so far stays.</source>
        <translation>Beendet das Wachsen: bisher Gewachsenes bleibt.</translation>
    </message>
    <message>
        <source>Draws a stroke that a structure does not grow through.</source>
        <translation>Zieht einen Strich, durch den eine Struktur nicht wächst.</translation>
    </message>
    <message>
        <source>Changes how a structure grows: it grows anew.</source>
        <translation>Ändert, wie eine Struktur wächst: sie wächst neu.</translation>
    </message>
    <message>
        <source>Forgets a structure that was grown.</source>
        <translation>Vergisst eine gewachsene Struktur.</translation>
    </message>
    <message>
        <source>Shows structures, or hides them.</source>
        <translation>Blendet Strukturen ein oder aus.</translation>
    </message>
    <message>
        <source>Shows the labels, or hides them.</source>
        <translation>Blendet die Labels ein oder aus.</translation>
    </message>
    <message>
        <source>Shows those that are hidden and hides those that are shown.</source>
        <translation>Blendet die ausgeblendeten ein und die eingeblendeten aus.</translation>
    </message>
    <message>
        <source>Shows a structure alone; where it is alone already, what was shown before.</source>
        <translation>Zeigt eine Struktur allein; ist sie schon allein, das vorher Gezeigte.</translation>
    </message>
    <message>
        <source>Gives structures a colour of their own.</source>
        <translation>Gibt Strukturen eine eigene Farbe.</translation>
    </message>
    <message>
        <source>Makes structures more or less opaque.</source>
        <translation>Macht Strukturen mehr oder weniger deckend.</translation>
    </message>
    <message>
        <source>Shows structures as material or as solid surfaces.</source>
        <translation>Zeigt Strukturen als Material oder als massive Oberflächen.</translation>
    </message>
    <message>
        <source>Gives structures a lit sphere of their own in a finished picture.</source>
        <translation>Gibt Strukturen in einem ausgeführten Bild eine eigene Lichtkugel.</translation>
    </message>
    <message>
        <source>Smooths the shapes that structures have in their file.</source>
        <translation>Glättet die Formen, die Strukturen in ihrer Datei haben.</translation>
    </message>
    <message>
        <source>Gives a structure another name.</source>
        <translation>Gibt einer Struktur einen anderen Namen.</translation>
    </message>
    <message>
        <source>Lets a cut leave structures whole, or go through them again.</source>
        <translation>Lässt einen Schnitt Strukturen ganz lassen oder wieder durch sie hindurchgehen.</translation>
    </message>
    <message>
        <source>Lets a membrane&apos;s sheet go around structures, or draws it to them.</source>
        <translation>Lässt das Tuch einer Membran um Strukturen herumgehen oder zieht es zu ihnen.</translation>
    </message>
    <message>
        <source>Gives the volume colours, opacity and light made for a kind of data.</source>
        <translation>Gibt dem Volumen Farben, Deckkraft und Licht für eine Art von Daten.</translation>
    </message>
    <message>
        <source>Gives the picture what an illustrator adds at the end.</source>
        <translation>Gibt dem Bild, was ein Illustrator am Ende hinzufügt.</translation>
    </message>
    <message>
        <source>Gives a model light, lines and colours that go together.</source>
        <translation>Gibt einem Modell Licht, Linien und Farben, die zusammengehören.</translation>
    </message>
    <message>
        <source>Sets the grey window of sections.</source>
        <translation>Setzt das Grauwertfenster der Schnittbilder.</translation>
    </message>
    <message>
        <source>Makes the material at a place seen, and all else a veil.</source>
        <translation>Macht das Material an einer Stelle sichtbar und alles andere zum Schleier.</translation>
    </message>
    <message>
        <source>Shows one of the channels that are mixed alone, or all again.</source>
        <translation>Zeigt einen der gemischten Kanäle allein oder wieder alle.</translation>
    </message>
    <message>
        <source>Gives a channel that is mixed a colour.</source>
        <translation>Gibt einem gemischten Kanal eine Farbe.</translation>
    </message>
    <message>
        <source>Paints material as a picture of a lit sphere is painted.</source>
        <translation>Malt Material, wie das Bild einer Lichtkugel gemalt ist.</translation>
    </message>
    <message>
        <source>Chooses how rays are cast.</source>
        <translation>Wählt, wie Strahlen ausgesandt werden.</translation>
    </message>
    <message>
        <source>Makes a look that lets one see through one of surfaces.</source>
        <translation>Macht aus einem durchsichtigen Aussehen eines aus Oberflächen.</translation>
    </message>
    <message>
        <source>Takes the transfer function of a file.</source>
        <translation>Übernimmt die Transferfunktion einer Datei.</translation>
    </message>
    <message>
        <source>Sets what is behind everything.</source>
        <translation>Setzt, was hinter allem liegt.</translation>
    </message>
    <message>
        <source>Leaves out what is not part of the largest body: a scanner&apos;s table, head rests, cables.</source>
        <translation>Lässt weg, was nicht zum größten Körper gehört: Tisch des Scanners, Kopfstützen, Kabel.</translation>
    </message>
    <message>
        <source>Shows types of a model, or hides them.</source>
        <translation>Blendet Typen eines Modells ein oder aus.</translation>
    </message>
    <message>
        <source>Shows the model, or hides it.</source>
        <translation>Blendet das Modell ein oder aus.</translation>
    </message>
    <message>
        <source>Enlarges the model, or makes it smaller, so that it is seen beside the other data, at their right.</source>
        <translation>Vergrößert oder verkleinert das Modell so, dass es rechts neben den anderen Daten zu sehen ist.</translation>
    </message>
    <message>
        <source>Gives types a colour of their own.</source>
        <translation>Gibt Typen eine eigene Farbe.</translation>
    </message>
    <message>
        <source>Gives types the palette&apos;s colours again.</source>
        <translation>Gibt Typen wieder die Farben der Palette.</translation>
    </message>
    <message>
        <source>Shows types as if nothing had been said of them.</source>
        <translation>Zeigt Typen, als wäre nichts über sie gesagt.</translation>
    </message>
    <message>
        <source>Says how instances of types show that cuts have removed.</source>
        <translation>Sagt, wie Instanzen von Typen erscheinen, die Schnitte entfernt haben.</translation>
    </message>
    <message>
        <source>Shows types alone; where they are alone already, what was shown before.</source>
        <translation>Zeigt Typen allein; sind sie schon allein, das vorher Gezeigte.</translation>
    </message>
    <message>
        <source>Lets a membrane&apos;s sheet go around types of a model, or draws it to them.</source>
        <translation>Lässt das Tuch einer Membran um Typen eines Modells herumgehen oder zieht es zu ihnen.</translation>
    </message>
    <message>
        <source>Says how many instances of a type or compartment are to be seen.</source>
        <translation>Sagt, wie viele Instanzen eines Typs oder Kompartiments sichtbar sein sollen.</translation>
    </message>
    <message>
        <source>Lets cuts leave as many instances as are to be seen of all types that have such a number.</source>
        <translation>Lässt Schnitte so viele Instanzen übrig lassen, wie von allen Typen mit einer solchen Anzahl sichtbar sein sollen.</translation>
    </message>
    <message>
        <source>Lets cuts leave so many instances of a type that a number of them is seen.</source>
        <translation>Lässt Schnitte so viele Instanzen eines Typs übrig lassen, dass eine Anzahl davon sichtbar ist.</translation>
    </message>
    <message>
        <source>Lets cuts leave so many instances of a type or compartment; its number stays when that of its group is set.</source>
        <translation>Lässt Schnitte so viele Instanzen eines Typs oder Kompartiments übrig lassen; die Anzahl bleibt, wenn die der Gruppe gesetzt wird.</translation>
    </message>
    <message>
        <source>Forgets the numbers of types: they follow those of their group.</source>
        <translation>Vergisst die Anzahlen von Typen: sie folgen denen ihrer Gruppe.</translation>
    </message>
    <message>
        <source>Lets a cut leave a share of the instances of types.</source>
        <translation>Lässt einen Schnitt einen Anteil der Instanzen von Typen übrig lassen.</translation>
    </message>
    <message>
        <source>Sets how a cut leaves the instances of types.</source>
        <translation>Setzt, wie ein Schnitt die Instanzen von Typen übrig lässt.</translation>
    </message>
    <message>
        <source>Lets a cut leave of types what it leaves of the compartment that they are in.</source>
        <translation>Lässt einen Schnitt von Typen übrig lassen, was er von ihrem Kompartiment übrig lässt.</translation>
    </message>
    <message>
        <source>Turns all cuts off: no instance is removed.</source>
        <translation>Schaltet alle Schnitte aus: keine Instanz wird entfernt.</translation>
    </message>
    <message>
        <source>Gives up shares and falloffs: where an instance is decides whether it is drawn.</source>
        <translation>Gibt Anteile und Abfall auf: der Ort einer Instanz entscheidet, ob sie gezeichnet wird.</translation>
    </message>
    <message>
        <source>Clears away what hides a type or compartment, or lets it be hidden again.</source>
        <translation>Räumt weg, was einen Typ oder ein Kompartiment verdeckt, oder lässt es wieder verdecken.</translation>
    </message>
    <message>
        <source>Gives a type or compartment the name by which it is shown.</source>
        <translation>Gibt einem Typ oder Kompartiment den Namen, unter dem es gezeigt wird.</translation>
    </message>
    <message>
        <source>Lists types, and compartments as one entry each, in the legend, or takes them out of its list; with an empty list it names what is seen most.</source>
        <translation>Nimmt Typen, und Kompartimente als je einen Eintrag, in die Legende auf oder aus ihrer Liste; ist die Liste leer, nennt sie, was am meisten zu sehen ist.</translation>
    </message>
    <message>
        <source>Lists structures in the legend, or takes them out of its list; with an empty list it names what is shown.</source>
        <translation>Nimmt Strukturen in die Legende auf oder aus ihrer Liste; ist die Liste leer, nennt sie das Eingeblendete.</translation>
    </message>
    <message>
        <source>Adds a caption over the picture, whose fields are set as any other: set lettering.captions[#1].opacity 0.5.</source>
        <translation>Fügt einen Bildtext über dem Bild hinzu, dessen Felder sich wie alle anderen setzen lassen: set lettering.captions[#1].opacity 0.5.</translation>
    </message>
    <message>
        <source>Removes a caption.</source>
        <translation>Entfernt einen Bildtext.</translation>
    </message>
    <message>
        <source>Adds a mark: a measure, an arrow, or words beside a place; its fields are set as any other: set lettering.marks[#1].wordsAt 0.1,0.</source>
        <translation>Fügt eine Marke hinzu: eine Messung, einen Pfeil oder Wörter neben einer Stelle; ihre Felder lassen sich wie alle anderen setzen: set lettering.marks[#1].wordsAt 0.1,0.</translation>
    </message>
    <message>
        <source>Removes marks.</source>
        <translation>Entfernt Marken.</translation>
    </message>
    <message>
        <source>Adds a copy of each mark.</source>
        <translation>Fügt von jeder Marke eine Kopie hinzu.</translation>
    </message>
    <message>
        <source>Shows or hides marks.</source>
        <translation>Blendet Marken ein oder aus.</translation>
    </message>
    <message>
        <source>Gives all lettering a style by name: typeface, sizes on the page, colour, halo.</source>
        <translation>Gibt aller Schrift einen benannten Stil: Schriftart, Größen auf der Seite, Farbe, Saum.</translation>
    </message>
    <message>
        <source>Makes a key of a field: what the field is at a time of the film.</source>
        <translation>Macht ein Schlüsselbild eines Feldes: was das Feld zu einer Zeit des Films ist.</translation>
    </message>
    <message>
        <source>Removes a key.</source>
        <translation>Entfernt ein Schlüsselbild.</translation>
    </message>
    <message>
        <source>Says how a field gets from a key to the next one.</source>
        <translation>Sagt, wie ein Feld von einem Schlüsselbild zum nächsten kommt.</translation>
    </message>
    <message>
        <source>Moves a key to another time, or copies it.</source>
        <translation>Verschiebt ein Schlüsselbild auf eine andere Zeit oder kopiert es.</translation>
    </message>
    <message>
        <source>Removes all keys of a field.</source>
        <translation>Entfernt alle Schlüsselbilder eines Feldes.</translation>
    </message>
    <message>
        <source>Removes all keys.</source>
        <translation>Entfernt alle Schlüsselbilder.</translation>
    </message>
    <message>
        <source>Shows the scene at a time of its film; changes nothing.</source>
        <translation>Zeigt die Szene zu einer Zeit ihres Films; ändert nichts.</translation>
    </message>
    <message>
        <source>Makes keys of whatever is changed at the playhead from now on.</source>
        <translation>Macht von nun an Schlüsselbilder von allem, was an der Abspielmarke geändert wird.</translation>
    </message>
    <message>
        <source>Draws the film of the scene, and writes it as a video or as frames.</source>
        <translation>Zeichnet den Film der Szene und schreibt ihn als Video oder als Einzelbilder.</translation>
    </message>
    <message>
        <source>Ready-made film: the eye goes round.</source>
        <translation>Fertiger Film: das Auge geht herum.</translation>
    </message>
    <message>
        <source>Ready-made film: cuts come in from where the data ends.</source>
        <translation>Fertiger Film: Schnitte kommen vom Ende der Daten herein.</translation>
    </message>
    <message>
        <source>Ready-made film: membranes sink in.</source>
        <translation>Fertiger Film: Membranen sinken ein.</translation>
    </message>
    <message>
        <source>Ready-made film: structures come out of the cuts one after the other.</source>
        <translation>Fertiger Film: Strukturen kommen nacheinander aus den Schnitten.</translation>
    </message>
    <message>
        <source>Ready-made film: a model from whole, over all that its cuts can take, to what they leave.</source>
        <translation>Fertiger Film: ein Modell vom Ganzen, über alles, was seine Schnitte nehmen können, zu dem, was sie übrig lassen.</translation>
    </message>
    <message>
        <source>Ready-made film: the eye goes to a structure.</source>
        <translation>Fertiger Film: das Auge geht zu einer Struktur.</translation>
    </message>
    <message>
        <source>Ready-made film: the volume goes through its time steps.</source>
        <translation>Fertiger Film: das Volumen geht durch seine Zeitschritte.</translation>
    </message>
    <message>
        <source>Ready-made film: whole, then cut open.</source>
        <translation>Fertiger Film: ganz, dann aufgeschnitten.</translation>
    </message>
    <message>
        <source>Ready-made film: words come and go.</source>
        <translation>Fertiger Film: Wörter kommen und gehen.</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Pull out</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Look</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Finish</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Anterior</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>V&amp;orne</translation>
    </message>
    <message>
        <source>P&amp;osterior</source>
        <translation>&amp;Posterior</translation>
    </message>
    <message>
        <source>B&amp;ack</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Superior</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>In&amp;ferior</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>O&amp;blique</source>
        <translation>Schr&amp;äg</translation>
    </message>
    <message>
        <source>Three sections and 3D</source>
        <translation>Drei Schnittbilder und 3D</translation>
    </message>
    <message>
        <source>3&amp;D only</source>
        <translation>Nur 3&amp;D</translation>
    </message>
    <message>
        <source>The 3D view alone</source>
        <translation>Die 3D-Ansicht allein</translation>
    </message>
    <message>
        <source>3D and one s&amp;ection</source>
        <translation>3D und &amp;ein Schnittbild</translation>
    </message>
    <message>
        <source>The 3D view and the current section</source>
        <translation>Die 3D-Ansicht und das aktuelle Schnittbild</translation>
    </message>
    <message>
        <source>One se&amp;ction</source>
        <translation>Ein Schnit&amp;tbild</translation>
    </message>
    <message>
        <source>The current section alone</source>
        <translation>Das aktuelle Schnittbild allein</translation>
    </message>
    <message>
        <source>Change range of types</source>
        <translation>Bereich der Typen ändern</translation>
    </message>
    <message>
        <source>Follow the view</source>
        <translation>Dem Blick folgen</translation>
    </message>
    <message>
        <source>Keep in view</source>
        <translation>Im Blick behalten</translation>
    </message>
    <message>
        <source>Let be hidden</source>
        <translation>Verdecken lassen</translation>
    </message>
    <message>
        <source>Lock the view</source>
        <translation>Blick festhalten</translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation>Marke verschieben</translation>
    </message>
    <message>
        <source>Move words of mark</source>
        <translation>Wörter der Marke verschieben</translation>
    </message>
    <message>
        <source>Remove force</source>
        <translation>Kraft entfernen</translation>
    </message>
    <message>
        <source>Remove pin</source>
        <translation>Nadel entfernen</translation>
    </message>
    <message>
        <source>Remove stroke</source>
        <translation>Strich entfernen</translation>
    </message>
    <message>
        <source>Sketch what to let through</source>
        <translation>Skizzieren, was durchgelassen wird</translation>
    </message>
    <message>
        <source>Sketch what to protect</source>
        <translation>Skizzieren, was geschützt wird</translation>
    </message>
    <message>
        <source>Stop gradient opacity</source>
        <translation>Deckkraft nach Gradient ausschalten</translation>
    </message>
    <message>
        <source>Use gradient opacity</source>
        <translation>Deckkraft nach Gradient einschalten</translation>
    </message>
    <message>
        <source>Share of the time that whole and cut are seen, each.</source>
        <translation>Anteil der Zeit, in der das Ganze und das Geschnittene je zu sehen sind.</translation>
    </message>
    <message>
        <source>Lets each point of marks follow what is there: the instance of the model that holds it, or the structure in which it lies, in its middle.</source>
        <translation>Jeden Punkt von Marken dem folgen lassen, was dort ist: der Instanz des Modells, die ihn enthält, oder der Struktur, in der er liegt, in ihrer Mitte.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 durchschneiden</translation>
    </message>
    <message>
        <source>Grow on: %1</source>
        <translation>Weiterwachsen: %1</translation>
    </message>
    <message>
        <source>Let follow %1</source>
        <translation>Folgen lassen: %1</translation>
    </message>
    <message>
        <source>Let go %1</source>
        <translation>Loslassen: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::ActionTable</name>
    <message>
        <source>%1: %2; the usual keys are in force</source>
        <translation>%1: %2; die üblichen Tasten gelten</translation>
    </message>
    <message>
        <source>%1: %2; the keys hold until Velum ends</source>
        <translation>%1: %2; die Tasten gelten, bis Velum endet</translation>
    </message>
</context>
<context>
    <name>velum::gui::AlignRow</name>
    <message>
        <source>Nearest</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Point the axis to the patient&apos;s %1; a plane takes away what lies there</source>
        <translation>Achse am Patienten nach %1 richten; eine Ebene nimmt weg, was dort liegt</translation>
    </message>
    <message>
        <source>Point the axis to the %1; a plane takes away what lies there</source>
        <translation>Achse nach %1 richten; eine Ebene nimmt weg, was dort liegt</translation>
    </message>
    <message>
        <source>Align to %1</source>
        <translation>Ausrichten: %1</translation>
    </message>
    <message>
        <source>Turn the axis to the patient&apos;s axis that is nearest</source>
        <translation>Achse auf die nächste Achse des Patienten drehen</translation>
    </message>
    <message>
        <source>Turn the axis to x, y or z, whichever is nearest</source>
        <translation>Achse auf x, y oder z drehen, je nachdem, was am nächsten liegt</translation>
    </message>
</context>
<context>
    <name>velum::gui::AreaMeter</name>
    <message>
        <source>There is no cut out of which it could be pulled: add one first (C)</source>
        <translation>Es gibt keinen Schnitt, aus dem es herausgezogen werden könnte: zuerst einen hinzufügen (C)</translation>
    </message>
</context>
<context>
    <name>velum::gui::BarrierTool</name>
    <message>
        <source>Draw across the place where the structure leaks. [ and ] change the width. Esc ends.</source>
        <translation>Quer über die Stelle ziehen, an der die Struktur ausläuft. [ und ] ändern die Breite. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>velum::gui::BrushTool</name>
    <message>
        <source>What is under the strokes is like all the rest: nothing in it tells it apart by its values.</source>
        <translation>Was unter den Strichen liegt, ist wie alles andere: an den Werten ist es nicht zu unterscheiden.</translation>
    </message>
</context>
<context>
    <name>velum::gui::CaptionForm</name>
    <message>
        <source>(no words)</source>
        <translation>(keine Wörter)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a caption: words over the picture, also in files</source>
        <translation>Bildtext hinzufügen: Wörter über dem Bild, auch in Dateien</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected caption (Del)</source>
        <translation>Ausgewählten Bildtext entfernen (Entf)</translation>
    </message>
    <message>
        <source>Captions</source>
        <translation>Bildtexte</translation>
    </message>
    <message>
        <source>Add caption</source>
        <translation>Bildtext hinzufügen</translation>
    </message>
    <message>
        <source>Remove caption</source>
        <translation>Bildtext entfernen</translation>
    </message>
    <message>
        <source>The captions over the picture; Del removes one</source>
        <translation>Die Bildtexte über dem Bild; Entf entfernt einen</translation>
    </message>
    <message>
        <source>Words of the caption</source>
        <translation>Wörter des Bildtextes</translation>
    </message>
    <message>
        <source>The words, in as many lines as are typed; long lines are broken in the picture</source>
        <translation>Die Wörter, in so vielen Zeilen wie getippt; lange Zeilen werden im Bild umbrochen</translation>
    </message>
    <message>
        <source>Change caption</source>
        <translation>Bildtext ändern</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Where the caption stands; captions at one place stand below each other</source>
        <translation>Wo der Bildtext steht; Bildtexte am selben Ort stehen untereinander</translation>
    </message>
    <message>
        <source>Place of the caption</source>
        <translation>Ort des Bildtextes</translation>
    </message>
    <message>
        <source>Move caption</source>
        <translation>Bildtext verschieben</translation>
    </message>
    <message>
        <source>Top left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of its letters, in that of other lettering, %</source>
        <translation>Größe seiner Buchstaben im Vergleich zur übrigen Schrift, %</translation>
    </message>
    <message>
        <source>Size of the caption</source>
        <translation>Größe des Bildtextes</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How much it covers, %; at 0 it takes no room either</source>
        <translation>Wie stark er deckt, %; bei 0 nimmt er auch keinen Platz ein</translation>
    </message>
    <message>
        <source>Opacity of the caption</source>
        <translation>Deckkraft des Bildtextes</translation>
    </message>
    <message>
        <source>caption</source>
        <translation>Bildtext</translation>
    </message>
    <message>
        <source>Change colour of caption</source>
        <translation>Farbe des Bildtextes ändern</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Bildtext</translation>
    </message>
</context>
<context>
    <name>velum::gui::CarryCommands</name>
    <message>
        <source>Carr&amp;y over to other data...</source>
        <translation>Auf &amp;andere Daten übertragen...</translation>
    </message>
    <message>
        <source>Show other data as this scene shows its own: look, cuts and film</source>
        <translation>Andere Daten so zeigen, wie diese Szene ihre eigenen zeigt: Aussehen, Schnitte und Film</translation>
    </message>
    <message>
        <source>Carrying over to %1</source>
        <translation>Wird auf %1 übertragen</translation>
    </message>
</context>
<context>
    <name>velum::gui::CarryDialog</name>
    <message>
        <source>Carry over to other data</source>
        <translation>Auf andere Daten übertragen</translation>
    </message>
    <message>
        <source>The look, the cuts and the film of this scene go to other data: another patient, another specimen. Undo brings this data back, and saving asks for a file of its own.</source>
        <translation>Aussehen, Schnitte und Film dieser Szene gehen auf andere Daten über: anderer Patient, anderes Präparat. Rückgängig bringt diese Daten zurück, und beim Speichern wird nach einer eigenen Datei gefragt.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>The other volume: a file, or a folder of DICOM images</source>
        <translation>Das andere Volumen: eine Datei oder ein Ordner mit DICOM-Bildern</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Labels of the other volume, where there are some</source>
        <translation>Labels des anderen Volumens, falls es welche gibt</translation>
    </message>
    <message>
        <source>Places by</source>
        <translation>Orte nach</translation>
    </message>
    <message>
        <source>By what camera, cuts and marks are found again: the box of the data, or a structure of both</source>
        <translation>Wonach Kamera, Schnitte und Marken wiedergefunden werden: nach dem Quader der Daten oder nach einer Struktur, die beide haben</translation>
    </message>
    <message>
        <source>File...</source>
        <translation>Datei...</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation>Ordner...</translation>
    </message>
    <message>
        <source>Choose a folder: %1</source>
        <translation>Ordner wählen: %1</translation>
    </message>
    <message>
        <source>Carry over</source>
        <translation>Übertragen</translation>
    </message>
    <message>
        <source>Read the other data, and show it as this scene shows its own</source>
        <translation>Die anderen Daten lesen und so zeigen, wie diese Szene ihre eigenen zeigt</translation>
    </message>
    <message>
        <source>The box of the data</source>
        <translation>Quader der Daten</translation>
    </message>
    <message>
        <source>There is no %1</source>
        <translation>Nicht vorhanden: %1</translation>
    </message>
    <message>
        <source>Looking for structures that both have ...</source>
        <translation>Strukturen, die beide haben, werden gesucht ...</translation>
    </message>
    <message>
        <source>With labels, structures are found again by their names; without, they are left out.</source>
        <translation>Mit Labels werden Strukturen an ihren Namen wiedergefunden; ohne sie entfallen sie.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures are in both.</source>
        <translation>
            <numerusform>%n Struktur ist in beiden.</numerusform>
            <numerusform>%n Strukturen sind in beiden.</numerusform>
        </translation>
    </message>
    <message>
        <source>No structure is in both by its name.</source>
        <translation>Keine Struktur ist dem Namen nach in beiden.</translation>
    </message>
</context>
<context>
    <name>velum::gui::ChannelList</name>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Show or hide this channel; Alt+click: show it alone, or all again</source>
        <translation>Kanal ein- oder ausblenden; Alt+Klick: ihn allein zeigen oder wieder alle</translation>
    </message>
    <message>
        <source>Colour of the channel</source>
        <translation>Farbe des Kanals</translation>
    </message>
    <message>
        <source>Edit the colour and opacity of this channel</source>
        <translation>Farbe und Deckkraft dieses Kanals bearbeiten</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 einblenden</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::ColorButton</name>
    <message>
        <source>%1: click to choose another colour</source>
        <translation>%1: klicken, um eine andere Farbe zu wählen</translation>
    </message>
</context>
<context>
    <name>velum::gui::CommandFinder</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was ist zu tun?</translation>
    </message>
    <message>
        <source>Letters of the command</source>
        <translation>Buchstaben des Befehls</translation>
    </message>
    <message>
        <source>A few letters of a command, preset, structure or number, as “shadows 80”, or a command as in a script; Up and Down choose, Enter does it, Esc leaves</source>
        <translation>Einige Buchstaben eines Befehls, einer Vorgabe, einer Struktur oder einer Zahl, etwa „schatten 80“, oder ein Befehl wie in einem Skript; Auf und Ab wählen, Eingabe führt aus, Esc verlässt</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Run &gt; %1</source>
        <translation>Ausführen &gt; %1</translation>
    </message>
    <message>
        <source>Nothing has these letters in its name. Fewer letters find more.</source>
        <translation>Kein Name enthält diese Buchstaben. Weniger Buchstaben finden mehr.</translation>
    </message>
</context>
<context>
    <name>velum::gui::CommandsWindow</name>
    <message>
        <source>Commands so far</source>
        <translation>Bisherige Befehle</translation>
    </message>
    <message>
        <source>A script that leads to what is open: velum-batch run FILE does it again</source>
        <translation>Ein Skript, das zu dem führt, was offen ist: velum-batch run DATEI wiederholt es</translation>
    </message>
    <message>
        <source>A command, as cut.add plane</source>
        <translation>Ein Befehl, etwa cut.add plane</translation>
    </message>
    <message>
        <source>A command to do</source>
        <translation>Auszuführender Befehl</translation>
    </message>
    <message>
        <source>Enter does it; the names are completed as one types, and the guide&apos;s page Commands lists them</source>
        <translation>Eingabe führt ihn aus; Namen werden beim Tippen ergänzt, die Seite Commands der Anleitung nennt alle Befehle</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy what is selected, or all lines</source>
        <translation>Auswahl oder alle Zeilen kopieren</translation>
    </message>
    <message>
        <source>&amp;Save...</source>
        <translation>&amp;Speichern...</translation>
    </message>
    <message>
        <source>Write all lines as a script</source>
        <translation>Alle Zeilen als Skript schreiben</translation>
    </message>
    <message>
        <source>%1 is for scripts; in the window the menus do it.</source>
        <translation>%1 ist für Skripte; im Fenster tun es die Menüs.</translation>
    </message>
    <message>
        <source>Save as a script</source>
        <translation>Als Skript speichern</translation>
    </message>
    <message>
        <source>Scripts (*.txt)</source>
        <translation>Skripte (*.txt)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>velum::gui::CountKey</name>
    <message>
        <source>Of the instances of a row: those that the picture shows; those that are drawn, but hidden behind others or outside the picture; those that cuts remove or that are not shown</source>
        <translation>Von den Instanzen einer Zeile: die, die das Bild zeigt; die, die gezeichnet, aber hinter anderen verdeckt oder außerhalb des Bildes sind; die, die Schnitte entfernen oder die ausgeblendet sind</translation>
    </message>
    <message>
        <source>Of the pixels that a structure would take: those that show it, those where others are before it, those where cuts remove it</source>
        <translation>Von den Pixeln, die eine Struktur einnähme: die, die sie zeigen; die, vor denen anderes steht; die, an denen Schnitte sie entfernen</translation>
    </message>
    <message>
        <source>Colours of the bars: %1</source>
        <translation>Farben der Balken: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::CutForm</name>
    <message>
        <source>Distance of the plane from the middle of the data, along its normal</source>
        <translation>Abstand der Ebene von der Mitte der Daten, entlang ihrer Normalen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>az </source>
        <translation>az </translation>
    </message>
    <message>
        <source>el </source>
        <translation>el </translation>
    </message>
    <message>
        <source>turn </source>
        <translation>Dreh. </translation>
    </message>
    <message>
        <source>Turn of the box about its axis, degrees</source>
        <translation>Drehung des Quaders um seine Achse, Grad</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Where the plane&apos;s normal or the shape&apos;s axis points</source>
        <translation>Wohin die Normale der Ebene oder die Achse der Form zeigt</translation>
    </message>
    <message>
        <source>Align to</source>
        <translation>Richten</translation>
    </message>
    <message>
        <source>Looking for where the membrane keeps what it protects</source>
        <translation>Gesucht wird, wo die Membran erhält, was sie schützt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>How the cut surface looks: lit material, or the data&apos;s grey values as on a section</source>
        <translation>Wie die Schnittfläche aussieht: beleuchtetes Material oder die Grauwerte der Daten wie auf einem Schnittbild</translation>
    </message>
    <message>
        <source>Change cut face</source>
        <translation>Schnittfläche ändern</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Beleuchtet</translation>
    </message>
    <message>
        <source>Section (grey values)</source>
        <translation>Schnittbild</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the grey section on the cut&apos;s face, %</source>
        <translation>Deckkraft des grauen Schnittbildes auf der Schnittfläche, %</translation>
    </message>
    <message>
        <source>Opacity of the face</source>
        <translation>Deckkraft der Schnittfläche</translation>
    </message>
    <message>
        <source>Change face opacity</source>
        <translation>Deckkraft der Schnittfläche ändern</translation>
    </message>
    <message>
        <source>Only with the cut above</source>
        <translation>Nur mit dem Schnitt darüber</translation>
    </message>
    <message>
        <source>Removes only what the cut before it in the list removes, too: two planes open a wedge, a sphere and a plane a bowl</source>
        <translation>Entfernt nur, was auch der Schnitt davor in der Liste entfernt: zwei Ebenen öffnen einen Keil, Kugel und Ebene eine Schale</translation>
    </message>
    <message>
        <source>Join cuts</source>
        <translation>Schnitte verbinden</translation>
    </message>
    <message>
        <source>Part cuts</source>
        <translation>Schnitte trennen</translation>
    </message>
    <message>
        <source>Joined</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>the %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>the patient&apos;s left</source>
        <translation>links am Patienten</translation>
    </message>
    <message>
        <source>Centre: towards %1</source>
        <translation>Mitte: nach %1</translation>
    </message>
    <message>
        <source>In the patient&apos;s axes</source>
        <translation>In den Achsen des Patienten</translation>
    </message>
    <message>
        <source>Along x, y and z</source>
        <translation>Entlang x, y und z</translation>
    </message>
    <message>
        <source>Azimuth of the axis, degrees: 0 %1, 90 %2, -90 %3, 180 %4</source>
        <translation>Azimut der Achse, Grad: 0 %1, 90 %2, -90 %3, 180 %4</translation>
    </message>
    <message>
        <source>Elevation of the axis, degrees: 90 %1, -90 %2</source>
        <translation>Höhenwinkel der Achse, Grad: 90 %1, -90 %2</translation>
    </message>
    <message>
        <source>Centre, %1</source>
        <translation>Mitte, %1</translation>
    </message>
    <message>
        <source>Size, %1</source>
        <translation>Größe, %1</translation>
    </message>
    <message>
        <source>Take away the other side (X)</source>
        <translation>Die andere Seite wegnehmen (X)</translation>
    </message>
    <message>
        <source>Keep what is inside and take away all that is outside (X)</source>
        <translation>Das Innere behalten und alles außerhalb wegnehmen (X)</translation>
    </message>
</context>
<context>
    <name>velum::gui::CutList</name>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>The eye turns a cut on and off; F2 or a double click renames it; Alt+Up and Alt+Down move it</source>
        <translation>Das Auge schaltet einen Schnitt ein und aus; F2 oder Doppelklick benennt ihn um; Alt+Auf und Alt+Ab verschieben ihn</translation>
    </message>
</context>
<context>
    <name>velum::gui::CutPanel</name>
    <message>
        <source>Nothing is cut away. Add a plane (C), a box or a round shape; drag its handles in the picture.</source>
        <translation>Nichts ist weggeschnitten. Eine Ebene (C), einen Quader oder eine runde Form hinzufügen und an den Griffen im Bild ziehen.</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Add plane</source>
        <translation>Neue Ebene</translation>
    </message>
    <message>
        <source>Cut away what lies before the crosshair, across the body&apos;s axis that faces you (C)</source>
        <translation>Wegschneiden, was vor dem Fadenkreuz liegt, quer zu der Körperachse, die dem Betrachter zugewandt ist (C)</translation>
    </message>
    <message>
        <source>Add other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Another shape, or a plane that is placed another way</source>
        <translation>Eine andere Form oder eine anders gelegte Ebene</translation>
    </message>
    <message>
        <source>An elastic sheet that cuts around what matters instead of through it (M)</source>
        <translation>Ein elastisches Tuch, das um das Wichtige herum schneidet statt hindurch (M)</translation>
    </message>
    <message>
        <source>Cut along the view</source>
        <translation>Quer zur Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>Plane through three points...</source>
        <translation>Ebene durch drei Punkte...</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of the selected cut</source>
        <translation>Kopie des ausgewählten Schnitts hinzufügen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move the cut up in the list (Alt+Up)</source>
        <translation>Schnitt in der Liste nach oben schieben (Alt+Auf)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move the cut down in the list (Alt+Down)</source>
        <translation>Schnitt in der Liste nach unten schieben (Alt+Ab)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected cut (Del)</source>
        <translation>Ausgewählten Schnitt entfernen (Entf)</translation>
    </message>
    <message>
        <source>A scene holds %1 cuts at most; remove one first.</source>
        <translation>Eine Szene fasst höchstens %1 Schnitte; zuerst einen entfernen.</translation>
    </message>
    <message>
        <source>Looking for where the membrane keeps what it protects</source>
        <translation>Gesucht wird, wo die Membran erhält, was sie schützt</translation>
    </message>
</context>
<context>
    <name>velum::gui::CutRoom</name>
    <message>
        <source>What is cut away</source>
        <translation>Was weggeschnitten wird</translation>
    </message>
    <message>
        <source>&amp;Add plane</source>
        <translation>&amp;Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Cut away the half that faces you</source>
        <translation>Die zugewandte Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut along the &amp;view</source>
        <translation>Quer zur Blick&amp;richtung schneiden</translation>
    </message>
    <message>
        <source>A plane through the middle that faces you exactly</source>
        <translation>Eine Ebene durch die Mitte, genau quer zur Blickrichtung</translation>
    </message>
    <message>
        <source>Plane through three &amp;points</source>
        <translation>Ebene durch drei &amp;Punkte</translation>
    </message>
    <message>
        <source>Click three points in the picture or on sections</source>
        <translation>Drei Punkte im Bild oder auf Schnittbildern anklicken</translation>
    </message>
    <message>
        <source>Add &amp;membrane</source>
        <translation>&amp;Membran hinzufügen</translation>
    </message>
    <message>
        <source>An elastic sheet that cuts around what matters instead of through it</source>
        <translation>Ein elastisches Tuch, das um das Wichtige herum schneidet statt hindurch</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Wenden</translation>
    </message>
    <message>
        <source>Take away the other side</source>
        <translation>Die andere Seite wegnehmen</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of the selected cut</source>
        <translation>Kopie des ausgewählten Schnitts hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>En&amp;tfernen</translation>
    </message>
    <message>
        <source>Remove the selected cut</source>
        <translation>Ausgewählten Schnitt entfernen</translation>
    </message>
    <message>
        <source>Add cut</source>
        <translation>Schnitt hinzufügen</translation>
    </message>
    <message>
        <source>Membrane</source>
        <translation>Membran</translation>
    </message>
    <message>
        <source>Show handle&amp;s</source>
        <translation>&amp;Griffe zeigen</translation>
    </message>
    <message>
        <source>Handles over the views; a click beside the data puts them away, too</source>
        <translation>Griffe über den Ansichten; ein Klick neben die Daten legt sie ebenfalls weg</translation>
    </message>
    <message>
        <source>A third of the data in size, where it opens what you see</source>
        <translation>Ein Drittel der Daten groß, wo es öffnet, was zu sehen ist</translation>
    </message>
</context>
<context>
    <name>velum::gui::CutTitle</name>
    <message>
        <source>Cut %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>Kopie von %1</translation>
    </message>
    <message>
        <source>Way to %1</source>
        <translation>Weg zu %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::EmptyState</name>
    <message>
        <source>Not a medical device.</source>
        <translation>Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Drop a scan here</source>
        <translation>Einen Scan hier ablegen</translation>
    </message>
    <message>
        <source>A folder of DICOM images, NIfTI, NRRD, MetaImage, MRC, TIFF, VTI, SEG-Y, OpenVDB, OME-Zarr, N5, Imaris,
BigDataViewer; cell models; labels and surfaces beside it; a Velum scene, or a picture that was saved from one.</source>
        <translation>Ein Ordner mit DICOM-Bildern, NIfTI, NRRD, MetaImage, MRC, TIFF, VTI, SEG-Y, OpenVDB, OME-Zarr, N5, Imaris,
BigDataViewer; Zellmodelle; dazu Labels und Oberflächen; eine Velum-Szene oder ein Bild, das aus einer gespeichert wurde.</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Dateien öffnen...</translation>
    </message>
    <message>
        <source>Choose files (Ctrl+O)</source>
        <translation>Dateien wählen (Strg+O)</translation>
    </message>
    <message>
        <source>Open DICOM folder...</source>
        <translation>DICOM-Ordner öffnen...</translation>
    </message>
    <message>
        <source>Choose a folder of images (Ctrl+Shift+O)</source>
        <translation>Ordner mit Bildern wählen (Strg+Umschalt+O)</translation>
    </message>
    <message>
        <source>Or begin with a sample</source>
        <translation>Oder mit einem Beispiel beginnen</translation>
    </message>
    <message>
        <source>Open a sample: %1</source>
        <translation>Beispiel öffnen: %1</translation>
    </message>
    <message>
        <source>%1: %2. Computed, not scanned; nothing is downloaded</source>
        <translation>%1: %2. Berechnet, nicht gescannt; nichts wird heruntergeladen</translation>
    </message>
</context>
<context>
    <name>velum::gui::EqualizeSteps</name>
    <message>
        <source>1 Cut</source>
        <translation>1 Schnitt</translation>
    </message>
    <message>
        <source>Add a plane that opens the model</source>
        <translation>Ebene hinzufügen, die das Modell öffnet</translation>
    </message>
    <message>
        <source>Cut the model open: the bars say what of each type is left.</source>
        <translation>Das Modell aufschneiden: die Balken sagen, was von jedem Typ übrig ist.</translation>
    </message>
    <message>
        <source>2 Balance</source>
        <translation>2 Abgleich</translation>
    </message>
    <message>
        <source>Go to the bars</source>
        <translation>Zu den Balken gehen</translation>
    </message>
    <message>
        <source>Drag the end of a bar: to the right to bring back what was cut, to the left to thin what is in the way.</source>
        <translation>Am Ende eines Balkens ziehen: nach rechts holt Weggeschnittenes zurück, nach links dünnt aus, was im Weg steht.</translation>
    </message>
    <message>
        <source>3 Clear</source>
        <translation>3 Frei</translation>
    </message>
    <message>
        <source>Keep the selected types in view: what stands before them goes</source>
        <translation>Ausgewählte Typen im Blick behalten: was davor steht, verschwindet</translation>
    </message>
    <message>
        <source>Select what the picture is about and press Clear: then nothing stands before it. Or go on without.</source>
        <translation>Auswählen, worum es im Bild geht, und „Frei“ drücken: dann steht nichts davor. Oder ohne dies fortfahren.</translation>
    </message>
    <message>
        <source>4 Save</source>
        <translation>4 Speichern</translation>
    </message>
    <message>
        <source>Save the picture, at any size</source>
        <translation>Bild speichern, in beliebiger Größe</translation>
    </message>
    <message>
        <source>Save the picture. It opens as its scene, to be changed again.</source>
        <translation>Das Bild speichern. Es lässt sich als seine Szene öffnen und weiter ändern.</translation>
    </message>
</context>
<context>
    <name>velum::gui::Equalizer</name>
    <message>
        <source>Finding how many are to be drawn for %1 to be seen</source>
        <translation>Gesucht wird, wie viele zu zeichnen sind, damit %1 sichtbar sind</translation>
    </message>
</context>
<context>
    <name>velum::gui::EqualizerBar</name>
    <message>
        <source>Which cuts the handles of the bars set</source>
        <translation>Welche Schnitte die Griffe der Balken einstellen</translation>
    </message>
    <message>
        <source>On: bars in percent of their row. Off: numbers on a logarithmic ruler, so that rare types show</source>
        <translation>Ein: Balken in Prozent ihrer Zeile. Aus: Zahlen auf logarithmischem Lineal, damit seltene Typen zu sehen sind</translation>
    </message>
    <message>
        <source>Bars in percent</source>
        <translation>Balken in Prozent</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>No cut removes anything. Click to turn all cuts off</source>
        <translation>Kein Schnitt entfernt etwas. Klicken, um alle Schnitte auszuschalten</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>Where an instance is decides whether it is drawn. Click to give up shares and falloffs</source>
        <translation>Ob eine Instanz gezeichnet wird, entscheidet ihr Ort. Klicken, um Anteile und Abfall aufzugeben</translation>
    </message>
    <message>
        <source>Thinned</source>
        <translation>Ausgedünnt</translation>
    </message>
    <message>
        <source>Of some types a share is left, drawn by lot: move the handles of the bars. Click to have the shares again that were left by these buttons</source>
        <translation>Von einigen Typen bleibt ein ausgeloster Anteil: die Griffe der Balken bewegen. Klicken, um die Anteile wiederzuhaben, die diese Knöpfe aufgegeben haben</translation>
    </message>
    <message>
        <source>All cuts that are on</source>
        <translation>Alle Schnitte, die eingeschaltet sind</translation>
    </message>
    <message>
        <source>There is none: the first handle adds one that is everywhere</source>
        <translation>Es gibt keinen: der erste Griff fügt einen hinzu, der überall gilt</translation>
    </message>
    <message>
        <source>All cuts</source>
        <translation>Alle Schnitte</translation>
    </message>
    <message numerus="yes">
        <source>%n cuts</source>
        <translation>
            <numerusform>%n Schnitt</numerusform>
            <numerusform>%n Schnitte</numerusform>
        </translation>
    </message>
    <message>
        <source>Handles set: %1</source>
        <translation>Griffe wirken auf: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::ExportCommands</name>
    <message>
        <source>Save p&amp;icture...</source>
        <translation>&amp;Bild speichern...</translation>
    </message>
    <message>
        <source>Draw and save a picture of any size</source>
        <translation>Ein Bild beliebiger Größe zeichnen und speichern</translation>
    </message>
    <message>
        <source>Export s&amp;heet...</source>
        <translation>&amp;Tuch exportieren...</translation>
    </message>
    <message>
        <source>Write the sheet of a membrane as a surface</source>
        <translation>Das Tuch einer Membran als Oberfläche schreiben</translation>
    </message>
    <message>
        <source>Export clipped vol&amp;ume...</source>
        <translation>Beschnittenes &amp;Volumen exportieren...</translation>
    </message>
    <message>
        <source>Write the volume without what the cuts take away</source>
        <translation>Das Volumen ohne das schreiben, was die Schnitte wegnehmen</translation>
    </message>
    <message>
        <source>Export s&amp;tructures...</source>
        <translation>Strukturen e&amp;xportieren...</translation>
    </message>
    <message>
        <source>Write structures as surfaces or as labels, for other programs</source>
        <translation>Strukturen als Oberflächen oder Labels schreiben, für andere Programme</translation>
    </message>
    <message>
        <source>Export mo&amp;del...</source>
        <translation>&amp;Modell exportieren...</translation>
    </message>
    <message>
        <source>Write the instances that cuts leave of the model</source>
        <translation>Die Instanzen schreiben, die Schnitte vom Modell übrig lassen</translation>
    </message>
    <message>
        <source>Export &amp;bars...</source>
        <translation>Ba&amp;lken exportieren...</translation>
    </message>
    <message>
        <source>Write how many instances of each type are seen, hidden and removed: SVG or CSV</source>
        <translation>Schreiben, wie viele Instanzen jedes Typs sichtbar, verdeckt und entfernt sind: SVG oder CSV</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>;;Drawing of lines and letters (*.svg *.pdf)</source>
        <translation>;;Zeichnung aus Linien und Buchstaben (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>There is no membrane: add one first (M).</source>
        <translation>Es gibt keine Membran: zuerst eine hinzufügen (M).</translation>
    </message>
    <message>
        <source>No model is open.</source>
        <translation>Kein Modell ist geöffnet.</translation>
    </message>
    <message>
        <source>Export model</source>
        <translation>Modell exportieren</translation>
    </message>
    <message>
        <source>Export bars</source>
        <translation>Balken exportieren</translation>
    </message>
    <message>
        <source>SVG (*.svg);;Table (*.csv)</source>
        <translation>SVG (*.svg);;Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Export sheet</source>
        <translation>Tuch exportieren</translation>
    </message>
    <message>
        <source>There is no volume to clip.</source>
        <translation>Es gibt kein Volumen zum Beschneiden.</translation>
    </message>
    <message>
        <source>Export clipped volume</source>
        <translation>Beschnittenes Volumen exportieren</translation>
    </message>
    <message>
        <source>There are no structures to export.</source>
        <translation>Es gibt keine Strukturen zum Exportieren.</translation>
    </message>
    <message>
        <source>Export structures</source>
        <translation>Strukturen exportieren</translation>
    </message>
</context>
<context>
    <name>velum::gui::ExportStructuresDialog</name>
    <message>
        <source>Export structures</source>
        <translation>Strukturen exportieren</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>Datei wählen...</translation>
    </message>
    <message>
        <source>Choose where they go and in which format</source>
        <translation>Wählen, wohin und in welchem Format</translation>
    </message>
    <message>
        <source>&amp;All structures</source>
        <translation>&amp;Alle Strukturen</translation>
    </message>
    <message>
        <source>Every structure that has voxels, hidden ones, too</source>
        <translation>Jede Struktur, die Voxel hat, auch ausgeblendete</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n ausgewählt</numerusform>
            <numerusform>%n ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Selected ones</source>
        <translation>Au&amp;sgewählte</translation>
    </message>
    <message>
        <source>&amp;Only %1</source>
        <translation>&amp;Nur %1</translation>
    </message>
    <message>
        <source>Those that are selected in the list of structures</source>
        <translation>Die in der Liste der Strukturen ausgewählten</translation>
    </message>
    <message>
        <source>A &amp;file for each</source>
        <translation>Je eine &amp;Datei</translation>
    </message>
    <message>
        <source>Write a file for each structure, with its name behind the one that you choose</source>
        <translation>Für jede Struktur eine Datei schreiben, mit ihrem Namen hinter dem gewählten</translation>
    </message>
    <message>
        <source>Smoothing of surfaces</source>
        <translation>Glättung der Oberflächen</translation>
    </message>
    <message>
        <source>How far surfaces are rounded off: 0 as the picture shows them. Their volume stays</source>
        <translation>Wie weit Oberflächen gerundet werden: 0 wie im Bild. Ihr Volumen bleibt</translation>
    </message>
</context>
<context>
    <name>velum::gui::ExtrusionList</name>
    <message>
        <source>Structures that are pulled out</source>
        <translation>Herausgezogene Strukturen</translation>
    </message>
    <message>
        <source>What stands out of the cuts, and how far</source>
        <translation>Was aus den Schnitten herausragt, und wie weit</translation>
    </message>
    <message>
        <source>What has no label</source>
        <translation>Was kein Label hat</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>%1 out of %2</source>
        <translation>%1 aus %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::ExtrusionPanel</name>
    <message>
        <source>Pull out</source>
        <translation>Herausziehen</translation>
    </message>
    <message>
        <source>Drag structures out of the cut: press on one in the picture and pull</source>
        <translation>Strukturen aus dem Schnitt ziehen: auf eine im Bild drücken und ziehen</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Zweite Ebene</translation>
    </message>
    <message>
        <source>A plane across the selected one: the two open a wedge, and structures can be pulled out of both</source>
        <translation>Eine Ebene quer zur ausgewählten: die beiden öffnen einen Keil, Strukturen lassen sich aus beiden ziehen</translation>
    </message>
    <message>
        <source>How far it stands out</source>
        <translation>Wie weit es herausragt</translation>
    </message>
    <message>
        <source>How far the structure stands out of the cut&apos;s face; 0 puts it back</source>
        <translation>Wie weit die Struktur aus der Schnittfläche ragt; 0 legt sie zurück</translation>
    </message>
    <message>
        <source>Out by</source>
        <translation>Heraus um</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>The selected structures go back into the cut</source>
        <translation>Die ausgewählten Strukturen gehen in den Schnitt zurück</translation>
    </message>
    <message>
        <source>Put all back</source>
        <translation>Alle zurück</translation>
    </message>
    <message>
        <source>Everything goes back into the cuts</source>
        <translation>Alles geht in die Schnitte zurück</translation>
    </message>
    <message>
        <source>Colour of what is pulled out</source>
        <translation>Farbe des Herausgezogenen</translation>
    </message>
    <message>
        <source>Its own colour; until it has one, what has grown is coloured by its values</source>
        <translation>Seine eigene Farbe; bis es eine hat, wird Gewachsenes nach seinen Werten gefärbt</translation>
    </message>
    <message>
        <source>Name of what is pulled out</source>
        <translation>Name des Herausgezogenen</translation>
    </message>
    <message>
        <source>Its name, as in the list of structures</source>
        <translation>Sein Name, wie in der Liste der Strukturen</translation>
    </message>
    <message>
        <source>Pull out %1</source>
        <translation>%1 herausziehen</translation>
    </message>
    <message>
        <source>Select a plane first: the second one is put across it.</source>
        <translation>Zuerst eine Ebene auswählen: die zweite wird quer dazu gelegt.</translation>
    </message>
</context>
<context>
    <name>velum::gui::ExtrusionRoom</name>
    <message>
        <source>Pull out</source>
        <translation>Herausziehen</translation>
    </message>
    <message>
        <source>Structures that stand out of the cuts</source>
        <translation>Strukturen, die aus den Schnitten herausragen</translation>
    </message>
    <message>
        <source>Growing has stopped; what was found so far stays.</source>
        <translation>Das Wachsen ist angehalten; was bisher gefunden ist, bleibt.</translation>
    </message>
    <message>
        <source>Pull &amp;out structures</source>
        <translation>Strukturen &amp;herausziehen</translation>
    </message>
    <message>
        <source>Drag a bone, a vessel or an organ out of the cut</source>
        <translation>Knochen, Gefäß oder Organ aus dem Schnitt ziehen</translation>
    </message>
    <message>
        <source>Second plane (&amp;wedge)</source>
        <translation>Zweite Ebene (&amp;Keil)</translation>
    </message>
    <message>
        <source>A plane across the selected one: the two open a wedge</source>
        <translation>Eine Ebene quer zur ausgewählten: die beiden öffnen einen Keil</translation>
    </message>
    <message>
        <source>Put all bac&amp;k</source>
        <translation>Alle zurü&amp;cklegen</translation>
    </message>
    <message>
        <source>Everything goes back into the cuts</source>
        <translation>Alles geht in die Schnitte zurück</translation>
    </message>
</context>
<context>
    <name>velum::gui::FieldForm</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Ändern: %1</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
</context>
<context>
    <name>velum::gui::FieldKey</name>
    <message>
        <source>Key this</source>
        <translation>Schlüsselbild hiervon</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>Schlüsselbild: %1</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Schlüsselbild entfernen</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>Schlüsselbild entfernen: %1</translation>
    </message>
    <message>
        <source>What it is at the playhead of the film</source>
        <translation>Was es an der Abspielmarke des Films ist</translation>
    </message>
    <message>
        <source>Key of %1</source>
        <translation>Schlüsselbild von %1</translation>
    </message>
    <message>
        <source>A film changes it; its key at the playhead: click to remove it</source>
        <translation>Ein Film ändert es; Schlüsselbild an der Abspielmarke: klicken, um es zu entfernen</translation>
    </message>
    <message>
        <source>A film changes it; click for a key at the playhead</source>
        <translation>Ein Film ändert es; klicken für ein Schlüsselbild an der Abspielmarke</translation>
    </message>
</context>
<context>
    <name>velum::gui::FileCommands</name>
    <message>
        <source>All that Velum reads (%1)</source>
        <translation>Alles, was Velum liest (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Neues &amp;Fenster</translation>
    </message>
    <message>
        <source>Open a second window with a scene of its own</source>
        <translation>Ein zweites Fenster mit eigener Szene öffnen</translation>
    </message>
    <message>
        <source>&amp;Cancel what is running</source>
        <translation>Laufendes abbre&amp;chen</translation>
    </message>
    <message>
        <source>Stop the load or the picture</source>
        <translation>Laden oder Bild anhalten</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>Leave Velum</source>
        <translation>Velum verlassen</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Close what is open</source>
        <translation>Schließen, was offen ist</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Öffnen...</translation>
    </message>
    <message>
        <source>Open a volume, labels, surfaces or a scene</source>
        <translation>Volumen, Labels, Oberflächen oder eine Szene öffnen</translation>
    </message>
    <message>
        <source>Open &amp;folder...</source>
        <translation>Or&amp;dner öffnen...</translation>
    </message>
    <message>
        <source>Open a folder of DICOM images, or a store in Zarr or N5</source>
        <translation>Ordner mit DICOM-Bildern oder einen Datenspeicher in Zarr oder N5 öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Add labels or surfaces...</source>
        <translation>Labels oder Oberflächen &amp;hinzufügen...</translation>
    </message>
    <message>
        <source>Open beside what is open</source>
        <translation>Neben dem öffnen, was offen ist</translation>
    </message>
    <message>
        <source>Make a &amp;phantom</source>
        <translation>&amp;Phantom erzeugen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Compute the phantom %1 and its labels</source>
        <translation>Das Phantom %1 und seine Labels berechnen</translation>
    </message>
    <message>
        <source>&amp;Save scene</source>
        <translation>&amp;Szene speichern</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Sa&amp;ve scene as...</source>
        <translation>Szene speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>Szene unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>die Szene</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Änderungen speichern: %1?</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>Was nicht gespeichert ist, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Don&apos;t save</source>
        <translation>&amp;Nicht speichern</translation>
    </message>
    <message>
        <source>Open a folder of DICOM images</source>
        <translation>Ordner mit DICOM-Bildern öffnen</translation>
    </message>
    <message>
        <source>Open labels beside what is open</source>
        <translation>Labels neben dem öffnen, was offen ist</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Szene speichern</translation>
    </message>
</context>
<context>
    <name>velum::gui::FileLoads</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Looking into %1</source>
        <translation>%1 wird untersucht</translation>
    </message>
    <message>
        <source>Making a phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>Opening a sample</source>
        <translation>Beispiel wird geöffnet</translation>
    </message>
    <message>
        <source>Restoring %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Missing data</source>
        <translation>Fehlende Daten</translation>
    </message>
    <message>
        <source>The %1 of the scene is missing: %2</source>
        <translation>Der Szene fehlen Daten (%1): %2</translation>
    </message>
    <message>
        <source>It was %1, and is not near the scene, nor where you worked last.</source>
        <translation>Es war %1 und liegt weder bei der Szene noch dort, wo zuletzt gearbeitet wurde.</translation>
    </message>
    <message>
        <source>&amp;Locate...</source>
        <translation>&amp;Suchen...</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Überspringen</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Wo ist %1?</translation>
    </message>
    <message>
        <source>opened without its %1 (%2)</source>
        <translation>geöffnet ohne: %1 (%2)</translation>
    </message>
    <message>
        <source>%1: of %2 planes, %3 are missing, and hatched in the sections</source>
        <translation>%1: von %2 Ebenen fehlen %3, in den Schnittbildern schraffiert</translation>
    </message>
</context>
<context>
    <name>velum::gui::FilmCommands</name>
    <message>
        <source>S&amp;ave film...</source>
        <translation>Film s&amp;peichern...</translation>
    </message>
    <message>
        <source>Draw the film of the scene, and save it as a video or as frames</source>
        <translation>Den Film der Szene zeichnen und als Video oder Einzelbilder speichern</translation>
    </message>
    <message>
        <source>C&amp;lear film</source>
        <translation>Film l&amp;öschen</translation>
    </message>
    <message>
        <source>Remove all keys of the film</source>
        <translation>Alle Schlüsselbilder des Films entfernen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>film</source>
        <translation>film</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>Stopped: there is no frame yet.</source>
        <translation>Angehalten: noch gibt es kein Einzelbild.</translation>
    </message>
    <message>
        <source>Stopped: %1 of %2 frames are in %3</source>
        <translation>Angehalten: %1 von %2 Einzelbildern sind in %3</translation>
    </message>
    <message>
        <source>Saved %1: %2 frames</source>
        <translation>%1 gespeichert: %2 Einzelbilder</translation>
    </message>
</context>
<context>
    <name>velum::gui::FilmPreview</name>
    <message>
        <source>Drawing...</source>
        <translation>Wird gezeichnet...</translation>
    </message>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
</context>
<context>
    <name>velum::gui::FinishGrid</name>
    <message>
        <source>Finish</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>Contours, lit spheres, strokes and paper that belong together</source>
        <translation>Konturen, Lichtkugeln, Striche und Papier, die zusammengehören</translation>
    </message>
</context>
<context>
    <name>velum::gui::FinishPanel</name>
    <message>
        <source>Finish</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>The look lets one see through, and lines lie on all that is seen.</source>
        <translation>Das Aussehen ist durchsichtig, und Linien liegen auf allem, was zu sehen ist.</translation>
    </message>
    <message>
        <source>Make it a surface</source>
        <translation>Zur Oberfläche machen</translation>
    </message>
    <message>
        <source>Opacities become steep: what is nearly opaque is opaque, veils before it go; colours stay</source>
        <translation>Deckkräfte werden steil: fast Deckendes deckt, Schleier davor verschwinden; Farben bleiben</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Lines around structures and along edges, %</source>
        <translation>Linien um Strukturen und entlang von Kanten, %</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>In pixels of a picture of 1000 rows; lines grow with the picture</source>
        <translation>In Pixeln eines Bildes mit 1000 Zeilen; Linien wachsen mit dem Bild</translation>
    </message>
    <message>
        <source>Width of contours</source>
        <translation>Breite der Konturen</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>How much of them where something ends before what lies behind it, %</source>
        <translation>Wie viel davon, wo etwas vor dem endet, was dahinter liegt, %</translation>
    </message>
    <message>
        <source>Contours of outlines</source>
        <translation>Konturen der Umrisse</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>How much of them between labelled structures, %</source>
        <translation>Wie viel davon zwischen Strukturen mit Labels, %</translation>
    </message>
    <message>
        <source>Contours between structures</source>
        <translation>Konturen zwischen Strukturen</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Knicke</translation>
    </message>
    <message>
        <source>How much of them where the surface turns sharply, %; molecules of models have none</source>
        <translation>Wie viel davon, wo die Oberfläche scharf abbiegt, %; Moleküle von Modellen haben keine</translation>
    </message>
    <message>
        <source>Contours of creases</source>
        <translation>Konturen der Knicke</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tusche</translation>
    </message>
    <message>
        <source>Colour of contours and strokes</source>
        <translation>Farbe von Konturen und Strichen</translation>
    </message>
    <message>
        <source>Lit sphere</source>
        <translation>Lichtkugel</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>How much of the colour is the lit spheres&apos; instead of the light&apos;s, %</source>
        <translation>Wie viel der Farbe von den Lichtkugeln statt vom Licht kommt, %</translation>
    </message>
    <message>
        <source>Share of lit spheres</source>
        <translation>Anteil der Lichtkugeln</translation>
    </message>
    <message>
        <source>Structures have their own</source>
        <translation>Strukturen haben eigene</translation>
    </message>
    <message>
        <source>Off: structures have this one, too, whatever their menu says</source>
        <translation>Aus: auch Strukturen haben diese, was auch immer ihr Menü sagt</translation>
    </message>
    <message>
        <source>Lit spheres of structures</source>
        <translation>Lichtkugeln der Strukturen</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Hatching round the form, broader where it is darker, %</source>
        <translation>Schraffur um die Form, breiter, wo es dunkler ist, %</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>From stroke to stroke, in pixels of a picture of 1000 rows</source>
        <translation>Von Strich zu Strich, in Pixeln eines Bildes mit 1000 Zeilen</translation>
    </message>
    <message>
        <source>Distance of strokes</source>
        <translation>Abstand der Striche</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What is behind the picture instead of the background</source>
        <translation>Was statt des Hintergrundes hinter dem Bild liegt</translation>
    </message>
    <message>
        <source>Choose paper</source>
        <translation>Papier wählen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Rau</translation>
    </message>
    <message>
        <source>Laid</source>
        <translation>Gerippt</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>Leinen</translation>
    </message>
    <message>
        <source>Parchment</source>
        <translation>Pergament</translation>
    </message>
    <message>
        <source>Your own...</source>
        <translation>Eigenes...</translation>
    </message>
    <message>
        <source>A picture of paper or cloth, .png, .tif or .exr, that is laid side by side without seams</source>
        <translation>Bild von Papier oder Stoff, .png, .tif oder .exr, das nahtlos aneinandergelegt wird</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Korn</translation>
    </message>
    <message>
        <source>How much of its grain shows, %</source>
        <translation>Wie viel von seinem Korn zu sehen ist, %</translation>
    </message>
    <message>
        <source>Grain of the paper</source>
        <translation>Korn des Papiers</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>How large its grain or picture is, %</source>
        <translation>Wie groß sein Korn oder Bild ist, %</translation>
    </message>
    <message>
        <source>Size of the grain</source>
        <translation>Größe des Korns</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the paper</source>
        <translation>Farbe des Papiers</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.tiff *.exr);;All files (*)</source>
        <translation>Bilder (*.png *.tif *.tiff *.exr);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>velum::gui::FocusForm</name>
    <message>
        <source>Keeps it in view</source>
        <translation>Behält im Blick</translation>
    </message>
    <message>
        <source>What stands before the selected types and lies in the cut&apos;s region is not drawn</source>
        <translation>Was vor den ausgewählten Typen steht und im Bereich des Schnitts liegt, wird nicht gezeichnet</translation>
    </message>
    <message>
        <source>Stay before</source>
        <translation>Bleiben davor</translation>
    </message>
    <message>
        <source>Share of the selected types&apos; instances that stay though they hide what is kept in view, %</source>
        <translation>Anteil der Instanzen der ausgewählten Typen, die bleiben, obwohl sie verdecken, was im Blick behalten wird, %</translation>
    </message>
    <message>
        <source>Change share before the view</source>
        <translation>Anteil vor dem Blick ändern</translation>
    </message>
    <message>
        <source>Aperture</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>How far the view is opened for the selected types, from a hole in its middle to all of it, %</source>
        <translation>Wie weit der Blick auf die ausgewählten Typen geöffnet ist, vom Loch in seiner Mitte bis ganz, %</translation>
    </message>
    <message>
        <source>Change aperture</source>
        <translation>Öffnung ändern</translation>
    </message>
    <message>
        <source>Leaves what stands about it</source>
        <translation>Lässt stehen, was ringsum ist</translation>
    </message>
    <message>
        <source>Only what is before the nearest of what is kept in view goes, so that one sees how deep it lies</source>
        <translation>Nur was vor dem Nächsten des im Blick Behaltenen liegt, verschwindet; so ist zu sehen, wie tief es liegt</translation>
    </message>
    <message>
        <source>Leave what stands about the view</source>
        <translation>Stehen lassen, was um den Blick ist</translation>
    </message>
    <message>
        <source>Clear what stands about the view</source>
        <translation>Freiräumen, was um den Blick ist</translation>
    </message>
    <message>
        <source>As seen from here</source>
        <translation>Wie von hier gesehen</translation>
    </message>
    <message>
        <source>What is cleared stays so when you turn: to look at the opening from the side</source>
        <translation>Freigeräumtes bleibt es beim Drehen: um die Öffnung von der Seite anzusehen</translation>
    </message>
    <message>
        <source>In view: %1</source>
        <translation>Im Blick: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::GreyWindowCorner</name>
    <message>
        <source>%1: W %2  L %3 %4</source>
        <translation>%1: W %2  L %3 %4</translation>
    </message>
    <message>
        <source>Click to type the grey window (W)</source>
        <translation>Klicken, um das Grauwertfenster einzutippen (W)</translation>
    </message>
    <message>
        <source>Grey window</source>
        <translation>Grauwertfenster</translation>
    </message>
    <message>
        <source>Type %1</source>
        <translation>%1 eintippen</translation>
    </message>
    <message>
        <source>Not understood; nothing was changed</source>
        <translation>Nicht verständlich; nichts wurde geändert</translation>
    </message>
</context>
<context>
    <name>velum::gui::GrowthForm</name>
    <message>
        <source>a barrier</source>
        <translation>einer Barriere</translation>
    </message>
    <message>
        <source>%1 barriers</source>
        <translation>%1 Barrieren</translation>
    </message>
    <message>
        <source>a place that is not of it</source>
        <translation>einer Stelle, die nicht dazugehört</translation>
    </message>
    <message>
        <source>%1 places that are not of it</source>
        <translation>%1 Stellen, die nicht dazugehören</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Smallest value that belongs to it</source>
        <translation>Kleinster Wert, der dazugehört</translation>
    </message>
    <message>
        <source>Smallest value that belongs to the structure: it grows anew as it changes</source>
        <translation>Kleinster Wert, der zur Struktur gehört: sie wächst neu, wenn er sich ändert</translation>
    </message>
    <message>
        <source>Change its smallest value</source>
        <translation>Kleinsten Wert ändern</translation>
    </message>
    <message>
        <source>Largest value that belongs to it</source>
        <translation>Größter Wert, der dazugehört</translation>
    </message>
    <message>
        <source>Largest value that belongs to the structure: it grows anew as it changes</source>
        <translation>Größter Wert, der zur Struktur gehört: sie wächst neu, wenn er sich ändert</translation>
    </message>
    <message>
        <source>Change its largest value</source>
        <translation>Größten Wert ändern</translation>
    </message>
    <message>
        <source>Gradient at which it stops</source>
        <translation>Gradient, an dem es anhält</translation>
    </message>
    <message>
        <source>Growing stops where the values change by more than this from voxel to voxel; at 0 it does not ask.
Of use where two structures of like values touch</source>
        <translation>Das Wachsen hält an, wo sich die Werte von Voxel zu Voxel um mehr als dies ändern; bei 0 ohne Bedeutung.
Nützlich, wo sich zwei Strukturen ähnlicher Werte berühren</translation>
    </message>
    <message>
        <source>Stop at edges</source>
        <translation>An Kanten anhalten</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Barrier</source>
        <translation>Barriere</translation>
    </message>
    <message>
        <source>Draw a stroke that the structure does not grow through, where it would leak into another</source>
        <translation>Einen Strich ziehen, durch den die Struktur nicht wächst, wo sie in eine andere ausliefe</translation>
    </message>
    <message>
        <source>How far gaps are closed in it</source>
        <translation>Wie weit Lücken darin geschlossen werden</translation>
    </message>
    <message>
        <source>What has grown is closed: pores and gaps that no ball of this radius gets into become part of it, whatever lies there</source>
        <translation>Gewachsenes wird geschlossen: Poren und Lücken, in die keine Kugel mit diesem Radius passt, gehören dazu, was auch immer dort liegt</translation>
    </message>
    <message>
        <source>Close gaps</source>
        <translation>Lücken schließen</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>What the structure encloses becomes part of it, as marrow of its bone</source>
        <translation>Was die Struktur umschließt, gehört dazu, wie Mark zu seinem Knochen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Growing: %1 voxels so far. Esc stops it.</source>
        <translation>Wächst: bisher %1 Voxel. Esc hält an.</translation>
    </message>
    <message>
        <source>Grown from its values.</source>
        <translation>Aus seinen Werten gewachsen.</translation>
    </message>
    <message>
        <source>Grown from its values, with %1.</source>
        <translation>Aus seinen Werten gewachsen, mit %1.</translation>
    </message>
</context>
<context>
    <name>velum::gui::HandTool</name>
    <message>
        <source>Add a membrane first: pins and forces are put on its sheet.</source>
        <translation>Zuerst eine Membran hinzufügen: Nadeln und Kräfte wirken auf ihr Tuch.</translation>
    </message>
    <message>
        <source>A pin holds the sheet: click on the sheet, or on its line in a section.</source>
        <translation>Eine Nadel hält das Tuch: auf das Tuch klicken oder auf seine Linie in einem Schnittbild.</translation>
    </message>
</context>
<context>
    <name>velum::gui::HelpCommands</name>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Anleitung</translation>
    </message>
    <message>
        <source>Read the guide; no network is needed</source>
        <translation>Anleitung lesen (englisch); ohne Netz</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>&amp;Befehl suchen...</translation>
    </message>
    <message>
        <source>Find a command, preset, structure or number by a few letters</source>
        <translation>Befehl, Vorgabe, Struktur oder Zahl mit einigen Buchstaben finden</translation>
    </message>
    <message>
        <source>&amp;About Velum</source>
        <translation>&amp;Über Velum</translation>
    </message>
    <message>
        <source>Say what Velum is</source>
        <translation>Sagen, was Velum ist</translation>
    </message>
    <message>
        <source>About Velum</source>
        <translation>Über Velum</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Velum %1&lt;/h3&gt;&lt;p&gt;Volumes, cut open the way illustrators do.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not a medical device.&lt;/b&gt; Do not use it for diagnosis or treatment.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Velum %1&lt;/h3&gt;&lt;p&gt;Volumen, aufgeschnitten, wie Illustratoren es tun.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Kein Medizinprodukt.&lt;/b&gt; Nicht für Diagnose oder Behandlung verwenden.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>velum::gui::HelpWindow</name>
    <message>
        <source>Velum user guide</source>
        <translation>Anleitung zu Velum</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>To the beginning of the guide</source>
        <translation>Zum Anfang der Anleitung</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the page before (Alt+Left)</source>
        <translation>Zur vorigen Seite (Alt+Links)</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>In der Anleitung suchen</translation>
    </message>
    <message>
        <source>Words to find</source>
        <translation>Gesuchte Wörter</translation>
    </message>
    <message>
        <source>Enter finds the next place (Ctrl+F)</source>
        <translation>Eingabe findet die nächste Stelle (Strg+F)</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Anleitung</translation>
    </message>
</context>
<context>
    <name>velum::gui::HidersBox</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Clear the way</source>
        <translation>Weg freiräumen</translation>
    </message>
    <message>
        <source>Adds a cut that keeps it in view: what stands before it goes, as you turn, too</source>
        <translation>Fügt einen Schnitt hinzu, der es im Blick behält: was davor steht, verschwindet, auch beim Drehen</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Of the pixels that it would take, %1 are taken by this</source>
        <translation>Von den Pixeln, die es einnähme, nimmt dies %1 ein</translation>
    </message>
    <message>
        <source>What is no model</source>
        <translation>Was kein Modell ist</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide all of this type</source>
        <translation>Alle dieses Typs ausblenden</translation>
    </message>
</context>
<context>
    <name>velum::gui::HistoryCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Noch einmal ausführen</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>&amp;Copy as command</source>
        <translation>Als Befehl &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the last change as the line of a script that does it again</source>
        <translation>Die letzte Änderung als Zeile eines Skripts kopieren, die sie wiederholt</translation>
    </message>
    <message>
        <source>Co&amp;mmands so far...</source>
        <translation>Bis&amp;herige Befehle...</translation>
    </message>
    <message>
        <source>What has been done to what is open, as a script; and a line to type commands</source>
        <translation>Was mit dem Geöffneten getan wurde, als Skript; dazu eine Zeile zum Eintippen von Befehlen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Appearance, language, units, mouse and wheel, keys, memory</source>
        <translation>Erscheinung, Sprache, Einheiten, Maus und Rad, Tasten, Speicher</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Kopiert: %1</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;</source>
        <translation>%1 „%2“</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Copy as Pyth&amp;on</source>
        <translation>Als Pyth&amp;on kopieren</translation>
    </message>
    <message>
        <source>Copy all that was done to what is open as a program in Python</source>
        <translation>Alles, was mit dem Geöffneten getan wurde, als Programm in Python kopieren</translation>
    </message>
    <message>
        <source>Copied all that was done as a program in Python</source>
        <translation>Alles Getane als Programm in Python kopiert</translation>
    </message>
</context>
<context>
    <name>velum::gui::InsideLine</name>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>A plane through the middle that faces you (Shift+C)</source>
        <translation>Eine Ebene durch die Mitte, quer zur Blickrichtung (Umschalt+C)</translation>
    </message>
</context>
<context>
    <name>velum::gui::JobRunner</name>
    <message>
        <source>Still busy: wait, or cancel what is running first.</source>
        <translation>Noch beschäftigt: warten oder zuerst abbrechen, was läuft.</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>hält an</translation>
    </message>
</context>
<context>
    <name>velum::gui::KeptBar</name>
    <message>
        <source>The sheet is drawn to what attracts it; nothing is protected from it.</source>
        <translation>Das Tuch wird zu dem gezogen, was es anzieht; nichts ist davor geschützt.</translation>
    </message>
    <message>
        <source>This membrane protects nothing: say what is to stay with Protect this.</source>
        <translation>Diese Membran schützt nichts: mit Schützen sagen, was bleiben soll.</translation>
    </message>
    <message>
        <source>Of what the membrane protects %1 % is kept, %2 % is removed whole, %3 % is cut off.</source>
        <translation>Von dem, was die Membran schützt, bleiben %1 % erhalten, %2 % werden ganz entfernt, %3 % abgeschnitten.</translation>
    </message>
    <message>
        <source>No place along its axis, and no reach, keeps more.</source>
        <translation>Keine Stelle auf ihrer Achse und keine Reichweite erhält mehr.</translation>
    </message>
    <message>
        <source>By volume, of all that is protected, near the sheet and far from it. Removed whole: pieces of which next to nothing stays; cut off: what is taken of pieces of which a part stays.</source>
        <translation>Nach Volumen, von allem Geschützten, nah am Tuch und fern davon. Ganz entfernt: Stücke, von denen fast nichts bleibt; abgeschnitten: was Stücken genommen wird, von denen ein Teil bleibt.</translation>
    </message>
    <message>
        <source>Deepen the reach to %1</source>
        <translation>Reichweite auf %1 vertiefen</translation>
    </message>
    <message>
        <source>Move to where it can be kept</source>
        <translation>Dorthin, wo es erhalten bleibt</translation>
    </message>
    <message>
        <source>Protect less</source>
        <translation>Weniger schützen</translation>
    </message>
    <message>
        <source>Then about %1 % is kept; the sheet cuts %2 % of what its plane would cut</source>
        <translation>Dann bleiben etwa %1 % erhalten; das Tuch schneidet %2 % dessen, was seine Ebene schnitte</translation>
    </message>
    <message>
        <source>Along its axis, with a reach of %1. %2</source>
        <translation>Entlang ihrer Achse, mit einer Reichweite von %1. %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::KeysPage</name>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>The &amp;usual ones</source>
        <translation>Die ü&amp;blichen</translation>
    </message>
    <message>
        <source>Search a command or a key</source>
        <translation>Befehl oder Taste suchen</translation>
    </message>
    <message>
        <source>Words of its name, or keys as they are written</source>
        <translation>Wörter des Namens oder Tasten, wie sie geschrieben werden</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys of the chosen command</source>
        <translation>Tasten des gewählten Befehls</translation>
    </message>
    <message>
        <source>Click here and press the keys for the chosen command</source>
        <translation>Hier klicken und die Tasten für den gewählten Befehl drücken</translation>
    </message>
    <message>
        <source>The chosen command has no key</source>
        <translation>Der gewählte Befehl hat keine Taste</translation>
    </message>
    <message>
        <source>The keys that the program comes with</source>
        <translation>Die Tasten, mit denen das Programm kommt</translation>
    </message>
    <message>
        <source>%1 was the key of “%2”, which has it no longer.</source>
        <translation>%1 war die Taste von „%2“; dieser Befehl hat sie nicht mehr.</translation>
    </message>
</context>
<context>
    <name>velum::gui::LeakBox</name>
    <message>
        <source>As far as here</source>
        <translation>Bis hierher</translation>
    </message>
    <message>
        <source>It stays as it is, however far it is pulled</source>
        <translation>Es bleibt, wie es ist, wie weit auch gezogen wird</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>It is no leak: the structure goes on there</source>
        <translation>Kein Auslaufen: die Struktur geht dort weiter</translation>
    </message>
    <message>
        <source>Not this...</source>
        <translation>Dies nicht...</translation>
    </message>
    <message>
        <source>Click on what it would flow into, or draw over it: the structure goes on without that.
In the views Ctrl+Shift+click says so at any time</source>
        <translation>Auf das klicken, wohin es ausliefe, oder darüberziehen: die Struktur geht ohne dies weiter.
In den Ansichten sagt es Strg+Umschalt+Klick jederzeit</translation>
    </message>
    <message>
        <source>%1 takes most of what there is in the cut, or the darkest values, which are around everything. It has not grown yet. Narrow its values; or:</source>
        <translation>%1 nimmt das meiste ein, was im Schnitt ist, oder die dunkelsten Werte, die um alles herum liegen. Noch ist es nicht gewachsen. Werte eingrenzen; oder:</translation>
    </message>
    <message>
        <source>%1 would flow into something else: %2 out its section becomes %L3 times as large. It is held there. Narrow its values, draw a barrier, stop at edges, or click on what it is not; or:</source>
        <translation>%1 liefe in etwas anderes aus: %2 weiter draußen wird der Querschnitt %L3-mal so groß. Dort wird es gehalten. Werte eingrenzen, eine Barriere ziehen, an Kanten anhalten oder auf das klicken, was es nicht ist; oder:</translation>
    </message>
    <message>
        <source>%1 is not grown yet: the page Pull out says why, and lets it.</source>
        <translation>%1 ist noch nicht gewachsen: die Seite Ziehen sagt, warum, und lässt es zu.</translation>
    </message>
    <message>
        <source>%1 is held %2 out, where it would flow into something else: the page Pull out lets it go on.</source>
        <translation>%1 wird %2 weiter draußen gehalten, wo es in etwas anderes ausliefe: die Seite Ziehen lässt es weitergehen.</translation>
    </message>
</context>
<context>
    <name>velum::gui::LetteringForm</name>
    <message>
        <source>Lettering</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Width of the printed picture, mm: letters and lines have their size on paper; 0: sizes go with the picture&apos;s rows</source>
        <translation>Breite des gedruckten Bildes, mm: Buchstaben und Linien haben ihre Größe auf Papier; 0: Größen richten sich nach den Zeilen des Bildes</translation>
    </message>
    <message>
        <source>Width of the page</source>
        <translation>Breite der Seite</translation>
    </message>
    <message>
        <source>Change width of page</source>
        <translation>Breite der Seite ändern</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Buchstaben</translation>
    </message>
    <message>
        <source>Their size in pixels of a picture of 1000 rows; they grow with the picture</source>
        <translation>Ihre Größe in Pixeln eines Bildes mit 1000 Zeilen; sie wachsen mit dem Bild</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Größe der Buchstaben</translation>
    </message>
    <message>
        <source>Change size of letters</source>
        <translation>Größe der Buchstaben ändern</translation>
    </message>
    <message>
        <source>Their size on the page, points</source>
        <translation>Ihre Größe auf der Seite, Punkt</translation>
    </message>
    <message>
        <source>Size of the letters on the page</source>
        <translation>Größe der Buchstaben auf der Seite</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Width of the lines of marks and leaders, points; without a page in proportion to the letters</source>
        <translation>Breite der Linien von Marken und Hinweislinien, Punkt; ohne Seite im Verhältnis zu den Buchstaben</translation>
    </message>
    <message>
        <source>Width of lines</source>
        <translation>Breite der Linien</translation>
    </message>
    <message>
        <source>Change width of lines</source>
        <translation>Breite der Linien ändern</translation>
    </message>
    <message>
        <source>Typeface</source>
        <translation>Schriftart</translation>
    </message>
    <message>
        <source>Letters with serifs, as in books, or without</source>
        <translation>Buchstaben mit Serifen, wie in Büchern, oder ohne</translation>
    </message>
    <message>
        <source>Change typeface</source>
        <translation>Schriftart ändern</translation>
    </message>
    <message>
        <source>Sans</source>
        <translation>Ohne Serifen</translation>
    </message>
    <message>
        <source>Serif</source>
        <translation>Mit Serifen</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Heavy letters</source>
        <translation>Kräftige Buchstaben</translation>
    </message>
    <message>
        <source>Bold letters</source>
        <translation>Fette Buchstaben</translation>
    </message>
    <message>
        <source>Halo</source>
        <translation>Saum</translation>
    </message>
    <message>
        <source>How much of the ground&apos;s colour lies around letters and lines, so that they are read over anything, %</source>
        <translation>Wie viel von der Farbe des Grundes um Buchstaben und Linien liegt, damit sie über allem lesbar sind, %</translation>
    </message>
    <message>
        <source>Halo of the lettering</source>
        <translation>Saum der Schrift</translation>
    </message>
    <message>
        <source>Change halo</source>
        <translation>Saum ändern</translation>
    </message>
    <message>
        <source>Style of the lettering</source>
        <translation>Stil der Schrift</translation>
    </message>
    <message>
        <source>Typeface, sizes, colour and halo of all that is written over the picture</source>
        <translation>Schriftart, Größen, Farbe und Saum von allem, was über das Bild geschrieben ist</translation>
    </message>
    <message>
        <source>A width that journals ask for: %1 mm</source>
        <translation>Eine Breite, die Zeitschriften verlangen: %1 mm</translation>
    </message>
    <message>
        <source>Page of %1 mm</source>
        <translation>Seite mit %1 mm</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Names of what is seen</source>
        <translation>Namen des Sichtbaren</translation>
    </message>
    <message>
        <source>Names of structures and types with leaders to them; they find their own places</source>
        <translation>Namen von Strukturen und Typen mit Hinweislinien; sie finden ihre Orte selbst</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Where the names stand: in columns left and right, or around what is seen</source>
        <translation>Wo die Namen stehen: in Spalten links und rechts oder rund um das Sichtbare</translation>
    </message>
    <message>
        <source>Order of the names</source>
        <translation>Anordnung der Namen</translation>
    </message>
    <message>
        <source>Change order of names</source>
        <translation>Anordnung der Namen ändern</translation>
    </message>
    <message>
        <source>In columns</source>
        <translation>In Spalten</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Ringsum</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>How many names find a place at most</source>
        <translation>Wie viele Namen höchstens Platz finden</translation>
    </message>
    <message>
        <source>Most names</source>
        <translation>Höchstzahl der Namen</translation>
    </message>
    <message>
        <source>Change number of names</source>
        <translation>Zahl der Namen ändern</translation>
    </message>
    <message>
        <source>What is named</source>
        <translation>Was benannt wird</translation>
    </message>
    <message>
        <source>What is seen most</source>
        <translation>Was am meisten zu sehen ist</translation>
    </message>
    <message>
        <source>Names of structures and paths of types, with commas between them; empty: what is seen most</source>
        <translation>Namen von Strukturen und Pfade von Typen, mit Kommas dazwischen; leer: was am meisten zu sehen ist</translation>
    </message>
    <message>
        <source>Only</source>
        <translation>Nur</translation>
    </message>
    <message>
        <source>Name these</source>
        <translation>Diese benennen</translation>
    </message>
    <message>
        <source>In the corners</source>
        <translation>In den Ecken</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Colours and names of types and structures over the picture, also in files; the menu of a type lists it</source>
        <translation>Farben und Namen von Typen und Strukturen über dem Bild, auch in Dateien; das Menü eines Typs nimmt ihn auf</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>How long things are, over the picture, also in files; in perspective at the point about which the view turns</source>
        <translation>Wie lang die Dinge sind, über dem Bild, auch in Dateien; in Perspektive an dem Punkt, um den sich die Ansicht dreht</translation>
    </message>
    <message>
        <source>Time stamp</source>
        <translation>Zeitangabe</translation>
    </message>
    <message>
        <source>The time of the time step over the picture, also in files</source>
        <translation>Die Zeit des Zeitschritts über dem Bild, auch in Dateien</translation>
    </message>
    <message>
        <source>Corner of the %1</source>
        <translation>Ecke: %1</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>The corner in which the %1 stands</source>
        <translation>Die Ecke, in der es steht: %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Top left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
</context>
<context>
    <name>velum::gui::LitSphereGrid</name>
    <message>
        <source>Add your own...</source>
        <translation>Eigene hinzufügen...</translation>
    </message>
    <message>
        <source>A picture of a painted sphere that fills it to its edges: .png, .tif or .exr</source>
        <translation>Bild einer gemalten Kugel, die es bis zum Rand füllt: .png, .tif oder .exr</translation>
    </message>
    <message>
        <source>Lit sphere</source>
        <translation>Lichtkugel</translation>
    </message>
    <message>
        <source>How the material looks from each side, where structures have none of their own</source>
        <translation>Wie das Material von jeder Seite aussieht, wo Strukturen keine eigene haben</translation>
    </message>
    <message>
        <source>Add lit sphere</source>
        <translation>Lichtkugel hinzufügen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.tiff *.exr);;All files (*)</source>
        <translation>Bilder (*.png *.tif *.tiff *.exr);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>velum::gui::LookCommands</name>
    <message>
        <source>Show &amp;this</source>
        <translation>&amp;Dies zeigen</translation>
    </message>
    <message>
        <source>Click tissue to make it visible; with Shift beside what is shown, with Ctrl to hide it</source>
        <translation>Gewebe anklicken, um es sichtbar zu machen; mit Umschalt zusätzlich zu dem, was zu sehen ist, mit Strg, um es auszublenden</translation>
    </message>
    <message>
        <source>Show this</source>
        <translation>Dies zeigen</translation>
    </message>
    <message>
        <source>&amp;Import look...</source>
        <translation>Aussehen &amp;importieren...</translation>
    </message>
    <message>
        <source>Take colours and opacity from a file of ours or of 3D Slicer</source>
        <translation>Farben und Deckkraft aus einer eigenen Datei oder einer von 3D Slicer übernehmen</translation>
    </message>
    <message>
        <source>&amp;Export look...</source>
        <translation>Aussehen &amp;exportieren...</translation>
    </message>
    <message>
        <source>Write colours and opacity for other scenes, or for 3D Slicer</source>
        <translation>Farben und Deckkraft für andere Szenen oder für 3D Slicer schreiben</translation>
    </message>
    <message>
        <source>Open a volume first: %1 is a look for one.</source>
        <translation>Zuerst ein Volumen öffnen: %1 ist ein Aussehen für eines.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Import look</source>
        <translation>Aussehen importieren</translation>
    </message>
    <message>
        <source>Looks (%1);;All files (*)</source>
        <translation>Aussehen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export look</source>
        <translation>Aussehen exportieren</translation>
    </message>
</context>
<context>
    <name>velum::gui::LookPanel</name>
    <message>
        <source>Rendering</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Volume: lit, with opacity. Maximum: the brightest value along each ray. Surface: one value</source>
        <translation>Volumen: beleuchtet, mit Deckkraft. Maximum: der hellste Wert auf jedem Strahl. Oberfläche: ein Wert</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Surface (iso)</source>
        <translation>Oberfläche (iso)</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Value of the surface</source>
        <translation>Wert der Oberfläche</translation>
    </message>
    <message>
        <source>Change surface value</source>
        <translation>Wert der Oberfläche ändern</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Cubic between voxels, not linear: no stairs where voxels are long. Takes more memory</source>
        <translation>Kubisch zwischen Voxeln, nicht linear: keine Stufen, wo Voxel lang sind. Braucht mehr Speicher</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Glättung ändern</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Strength of the shadows that the key light casts, %</source>
        <translation>Stärke der Schatten, die das Hauptlicht wirft, %</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verschattung</translation>
    </message>
    <message>
        <source>Darkening of hollows and grooves (ambient occlusion), %</source>
        <translation>Abdunkeln von Mulden und Rillen (Umgebungsverschattung), %</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Background for %1</source>
        <translation>Hintergrund: %1</translation>
    </message>
    <message>
        <source>print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Value at which the surface lies%1</source>
        <translation>Wert, bei dem die Oberfläche liegt%1</translation>
    </message>
</context>
<context>
    <name>velum::gui::LookRoom</name>
    <message>
        <source>Preset, rendering, light and background</source>
        <translation>Vorgabe, Darstellung, Licht und Hintergrund</translation>
    </message>
    <message>
        <source>Contours, lit spheres, strokes and paper</source>
        <translation>Konturen, Lichtkugeln, Striche und Papier</translation>
    </message>
</context>
<context>
    <name>velum::gui::LostWork</name>
    <message>
        <source>Discard unsaved work</source>
        <translation>Nicht gespeicherte Arbeit verwerfen</translation>
    </message>
    <message>
        <source>Delete the unsaved work of %1 for good?</source>
        <translation>Die nicht gespeicherte Arbeit an %1 endgültig löschen?</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
</context>
<context>
    <name>velum::gui::MainWindow</name>
    <message>
        <source>The disk takes changes again: unsaved work is protected.</source>
        <translation>Der Datenträger nimmt wieder Änderungen an: nicht gespeicherte Arbeit ist geschützt.</translation>
    </message>
    <message>
        <source>%1, and OpenGL 4.5 is needed: Mesa&apos;s software driver draws instead, which is slower. Install or update the graphics driver to draw with the card.</source>
        <translation>%1, und OpenGL 4.5 ist nötig: Stattdessen zeichnet der Softwaretreiber von Mesa, langsamer. Mit einem neueren Grafiktreiber zeichnet die Karte.</translation>
    </message>
    <message>
        <source>The graphics driver was reset; the picture has been drawn anew.</source>
        <translation>Der Grafiktreiber wurde zurückgesetzt; das Bild ist neu gezeichnet.</translation>
    </message>
    <message>
        <source>%1: the 3D view is drawn beside the window, by %2.</source>
        <translation>%1: Die 3D-Ansicht wird neben dem Fenster gezeichnet, von %2.</translation>
    </message>
</context>
<context>
    <name>velum::gui::MarkMenu</name>
    <message>
        <source>Rename mark</source>
        <translation>Marke umbenennen</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Umbenennen...</translation>
    </message>
    <message>
        <source>Type its words</source>
        <translation>Ihre Wörter eintippen</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Bring the crosshair to it</source>
        <translation>Das Fadenkreuz dorthin bringen</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Name and value, for tables and texts</source>
        <translation>Name und Wert, für Tabellen und Texte</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of it</source>
        <translation>Eine Kopie davon hinzufügen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>A hidden mark is still measured</source>
        <translation>Eine ausgeblendete Marke wird weiter gemessen</translation>
    </message>
    <message>
        <source>Remove	Del</source>
        <translation>Entfernen	Entf</translation>
    </message>
    <message>
        <source>Take it away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Its points stay where they are now</source>
        <translation>Die Punkte bleiben, wo sie jetzt sind</translation>
    </message>
    <message>
        <source>Its points go to the middles of the molecules or structures in which they lie, and follow them</source>
        <translation>Die Punkte gehen zur Mitte der Moleküle oder Strukturen, in denen sie liegen, und folgen ihnen</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Follow what is there</source>
        <translation>Dem folgen, was dort ist</translation>
    </message>
</context>
<context>
    <name>velum::gui::MarkPanel</name>
    <message>
        <source>Nothing is marked. Take up a tool and click two points for a distance (D), three for an angle (A), in the picture or on sections.</source>
        <translation>Nichts ist markiert. Ein Werkzeug nehmen und zwei Punkte für einen Abstand (D), drei für einen Winkel (A) anklicken, im Bild oder auf Schnittbildern.</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>The eye shows and hides a mark; F2 or a double click types its words; Del removes it; Ctrl+C copies its value</source>
        <translation>Das Auge blendet eine Marke ein und aus; F2 oder Doppelklick tippt ihre Wörter; Entf entfernt sie; Strg+C kopiert ihren Wert</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Bring the crosshair to the selected mark</source>
        <translation>Das Fadenkreuz zur ausgewählten Marke bringen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of the selected mark</source>
        <translation>Kopie der ausgewählten Marke hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected mark (Del)</source>
        <translation>Ausgewählte Marke entfernen (Entf)</translation>
    </message>
    <message>
        <source>Along the surface</source>
        <translation>Entlang der Oberfläche</translation>
    </message>
    <message>
        <source>The way is measured along the surface that is seen, not through the air</source>
        <translation>Der Weg wird entlang der sichtbaren Oberfläche gemessen, nicht durch die Luft</translation>
    </message>
    <message>
        <source>Measure along the surface</source>
        <translation>Entlang der Oberfläche messen</translation>
    </message>
    <message>
        <source>Measure through the air</source>
        <translation>Durch die Luft messen</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How much it covers, %</source>
        <translation>Wie stark sie deckt, %</translation>
    </message>
    <message>
        <source>Opacity of the mark</source>
        <translation>Deckkraft der Marke</translation>
    </message>
    <message>
        <source>Change opacity of mark</source>
        <translation>Deckkraft der Marke ändern</translation>
    </message>
    <message>
        <source>Change colour of mark</source>
        <translation>Farbe der Marke ändern</translation>
    </message>
    <message>
        <source>Shown at</source>
        <translation>Gezeigt zu</translation>
    </message>
    <message>
        <source>Time steps at which the mark is shown</source>
        <translation>Zeitschritte, zu denen die Marke gezeigt wird</translation>
    </message>
    <message>
        <source>A mark is shown and listed at all time steps of a series, or drawn at one of them alone</source>
        <translation>Eine Marke wird zu allen Zeitschritten einer Serie gezeigt oder nur zu einem gezeichnet</translation>
    </message>
    <message>
        <source>Change time step of mark</source>
        <translation>Zeitschritt der Marke ändern</translation>
    </message>
    <message>
        <source>All time steps</source>
        <translation>Alle Zeitschritte</translation>
    </message>
    <message>
        <source>This time step (%1)</source>
        <translation>Dieser Zeitschritt (%1)</translation>
    </message>
    <message>
        <source>Time step %1</source>
        <translation>Zeitschritt %1</translation>
    </message>
    <message>
        <source>Hidden here: the picture shows nothing of what it points at</source>
        <translation>Hier verdeckt: das Bild zeigt nichts von dem, worauf sie weist</translation>
    </message>
</context>
<context>
    <name>velum::gui::MarkRoom</name>
    <message>
        <source>Measures, arrows, labels, and all that is written over the picture</source>
        <translation>Messungen, Pfeile, Beschriftungen und alles, was über das Bild geschrieben ist</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Names of what is &amp;seen</source>
        <translation>Namen des &amp;Sichtbaren</translation>
    </message>
    <message>
        <source>Write the names of structures and types over the picture, with leaders, also in files</source>
        <translation>Namen von Strukturen und Typen mit Hinweislinien über das Bild schreiben, auch in Dateien</translation>
    </message>
    <message>
        <source>Names of what is seen</source>
        <translation>Namen des Sichtbaren</translation>
    </message>
    <message>
        <source>Save &amp;table...</source>
        <translation>&amp;Tabelle speichern...</translation>
    </message>
    <message>
        <source>Write what all marks and structures measure: .csv or .json</source>
        <translation>Schreiben, was alle Marken und Strukturen messen: .csv oder .json</translation>
    </message>
    <message>
        <source>L&amp;ist</source>
        <translation>&amp;Liste</translation>
    </message>
    <message>
        <source>Show the list of marks</source>
        <translation>Die Liste der Marken zeigen</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Table (*.csv);;Table with profiles and ways (*.json)</source>
        <translation>Tabelle (*.csv);;Tabelle mit Profilen und Wegen (*.json)</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Wird gemessen</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>velum::gui::MarkTool</name>
    <message>
        <source>Click a point of the angle&apos;s first leg. Esc ends.</source>
        <translation>Einen Punkt auf dem ersten Schenkel anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click where the legs meet. Backspace takes a point back.</source>
        <translation>Anklicken, wo sich die Schenkel treffen. Rücktaste nimmt einen Punkt zurück.</translation>
    </message>
    <message>
        <source>Click a point of the second leg. Backspace takes a point back.</source>
        <translation>Einen Punkt auf dem zweiten Schenkel anklicken. Rücktaste nimmt einen Punkt zurück.</translation>
    </message>
    <message>
        <source>Click the first point of the way. Esc ends.</source>
        <translation>Den ersten Punkt des Weges anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click the next point; a double click or Enter ends the way. Backspace takes a point back.</source>
        <translation>Den nächsten Punkt anklicken; Doppelklick oder Eingabe beendet den Weg. Rücktaste nimmt einen Punkt zurück.</translation>
    </message>
    <message>
        <source>Click the first corner. Esc ends.</source>
        <translation>Die erste Ecke anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click the next corner; a double click, Enter or the first corner closes the area.</source>
        <translation>Die nächste Ecke anklicken; Doppelklick, Eingabe oder die erste Ecke schließt die Fläche.</translation>
    </message>
    <message>
        <source>Click where the arrow begins. Esc ends.</source>
        <translation>Anklicken, wo der Pfeil beginnt. Esc beendet.</translation>
    </message>
    <message>
        <source>Click what it points at.</source>
        <translation>Anklicken, worauf er zeigt.</translation>
    </message>
    <message>
        <source>Click the place that the words belong to. Esc ends.</source>
        <translation>Die Stelle anklicken, zu der die Wörter gehören. Esc beendet.</translation>
    </message>
    <message>
        <source>Click a structure or a molecule to name it. Esc ends.</source>
        <translation>Eine Struktur oder ein Molekül anklicken, um es zu benennen. Esc beendet.</translation>
    </message>
    <message>
        <source>Click the middle of the circle. Esc ends.</source>
        <translation>Die Mitte des Kreises anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click its rim.</source>
        <translation>Seinen Rand anklicken.</translation>
    </message>
    <message>
        <source>Click a corner of the box. Esc ends.</source>
        <translation>Eine Ecke des Quaders anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click the corner across.</source>
        <translation>Die Ecke gegenüber anklicken.</translation>
    </message>
    <message>
        <source>Click the first of two points. Esc ends.</source>
        <translation>Den ersten von zwei Punkten anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click the second point. Backspace takes the first one back.</source>
        <translation>Den zweiten Punkt anklicken. Rücktaste nimmt den ersten zurück.</translation>
    </message>
    <message>
        <source>Nothing is there: click on what is drawn. %1</source>
        <translation>Dort ist nichts: auf Gezeichnetes klicken. %1</translation>
    </message>
    <message>
        <source>Nothing there has a name. %1</source>
        <translation>Dort hat nichts einen Namen. %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::MembraneForm</name>
    <message>
        <source>Change membrane: %1</source>
        <translation>Membran ändern: %1</translation>
    </message>
    <message>
        <source>Of the pairs of neighbouring protected voxels that the plane separates: those that the sheet leaves together on the side that stays, those that go together, and as many as the sheet cuts.</source>
        <translation>Von den Paaren benachbarter geschützter Voxel, die die Ebene trennt: die, die das Tuch zusammen auf der bleibenden Seite lässt, die, die zusammen verschwinden, und die, die das Tuch schneidet.</translation>
    </message>
    <message>
        <source>Protect this</source>
        <translation>Schützen</translation>
    </message>
    <message>
        <source>Click tissue, a structure or a molecule in any view: the sheet goes around all that is like it</source>
        <translation>Gewebe, Struktur oder Molekül in einer Ansicht anklicken: das Tuch geht um alles herum, was ihm gleicht</translation>
    </message>
    <message>
        <source>Let through</source>
        <translation>Durchlassen</translation>
    </message>
    <message>
        <source>Click tissue, a structure or a molecule in any view: the sheet may cut all that is like it</source>
        <translation>Gewebe, Struktur oder Molekül in einer Ansicht anklicken: das Tuch darf alles schneiden, was ihm gleicht</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Let the sheets of all membranes move, or hold them</source>
        <translation>Die Tücher aller Membranen bewegen lassen oder halten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Hold the sheets and let them go five steps</source>
        <translation>Die Tücher halten und fünf Schritte gehen lassen</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Hang the sheet flat again and let it go anew</source>
        <translation>Das Tuch wieder flach aufhängen und neu gehen lassen</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Show the numbers of the cloth and of the forces</source>
        <translation>Die Zahlen des Tuchs und der Kräfte zeigen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Write the sheet, or what it leaves, for other programs</source>
        <translation>Das Tuch, oder was es übrig lässt, für andere Programme schreiben</translation>
    </message>
    <message>
        <source>Sheet as a surface...</source>
        <translation>Tuch als Oberfläche...</translation>
    </message>
    <message>
        <source>The sheet as a surface, for other programs</source>
        <translation>Das Tuch als Oberfläche, für andere Programme</translation>
    </message>
    <message>
        <source>Clipped volume...</source>
        <translation>Beschnittenes Volumen...</translation>
    </message>
    <message>
        <source>A volume for other programs: what the cuts take away is empty</source>
        <translation>Ein Volumen für andere Programme: was die Schnitte wegnehmen, ist leer</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwendung</translation>
    </message>
    <message>
        <source>Clip: takes away what lies before the sheet; inlay: a grey image, and what lies between it and the sheet</source>
        <translation>Wegschneiden: nimmt weg, was vor dem Tuch liegt; Inlay: ein graues Bild, und was zwischen ihm und dem Tuch liegt</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Wegschneiden</translation>
    </message>
    <message>
        <source>Inlay</source>
        <translation>Inlay</translation>
    </message>
    <message>
        <source>Inlay opacity</source>
        <translation>Deckkraft (Inlay)</translation>
    </message>
    <message>
        <source>Emphasis</source>
        <translation>Betonung</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Ausblendung</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Tuch</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Passive: the sheet starts anew from flat wherever its rest plane is put; active: the frame drags it along, and it stays behind on what holds it</source>
        <translation>Passiv: das Tuch beginnt neu und flach, wohin auch seine Ruheebene gelegt wird; aktiv: der Rahmen zieht es mit, und es bleibt an dem zurück, was es hält</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>Passiv</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Sided: the least cut says to which side a structure belongs, and it pushes the sheet to the other; paper: away from each kernel&apos;s middle</source>
        <translation>Nach Seiten: der kleinste Schnitt sagt, auf welche Seite eine Struktur gehört, und sie drückt das Tuch auf die andere; Artikel: weg von der Mitte jedes Kernels</translation>
    </message>
    <message>
        <source>Sided</source>
        <translation>Nach Seiten</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Artikel</translation>
    </message>
    <message>
        <source>Passed by</source>
        <translation>Umgangenes</translation>
    </message>
    <message>
        <source>What the section would cut and the sheet can pass by: keep it whole, remove it whole, or leave it on the side on which more of it lies</source>
        <translation>Was das Schnittbild schnitte und das Tuch umgehen kann: ganz erhalten, ganz entfernen oder auf der Seite lassen, auf der mehr davon liegt</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Nearest side</source>
        <translation>Nähere Seite</translation>
    </message>
    <message>
        <source>Kernels</source>
        <translation>Kernel</translation>
    </message>
    <message>
        <source>A kernel for so many times two voxels along each axis: 0 every voxel, 1 every second, 2 every fourth</source>
        <translation>Ein Kernel für so oft zwei Voxel entlang jeder Achse: 0 jedes Voxel, 1 jedes zweite, 2 jedes vierte</translation>
    </message>
    <message>
        <source>Area of effect</source>
        <translation>Wirkungsbereich</translation>
    </message>
    <message>
        <source>Half-width of a kernel, in kernels</source>
        <translation>Halbe Breite eines Kernels, in Kerneln</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Steifheit</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>Pull back</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>Finest</source>
        <translation>Am feinsten</translation>
    </message>
    <message>
        <source>The plane cuts nothing of what is protected; the sheet cuts %1 pairs of voxels.</source>
        <translation>Die Ebene schneidet nichts von dem, was geschützt ist; das Tuch schneidet %1 Paare von Voxeln.</translation>
    </message>
    <message>
        <source>Of what the plane would cut, %1 % stays whole, %2 % is removed whole, %3 % is cut. The sheet lies %4 from the rest plane on average.</source>
        <translation>Von dem, was die Ebene schnitte, bleiben %1 % ganz, %2 % werden ganz entfernt, %3 % geschnitten. Das Tuch liegt im Mittel %4 von der Ruheebene.</translation>
    </message>
    <message>
        <source>Let move</source>
        <translation>Bewegen lassen</translation>
    </message>
    <message>
        <source>%1 kernels, %2 × %3 particles</source>
        <translation>%1 Kernel, %2 × %3 Partikel</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>Computing forces</source>
        <translation>Kräfte werden berechnet</translation>
    </message>
    <message>
        <source>Paused at step %1</source>
        <translation>Angehalten bei Schritt %1</translation>
    </message>
    <message>
        <source>Settling, step %1</source>
        <translation>Setzt sich, Schritt %1</translation>
    </message>
    <message>
        <source>Forces and figures come from level %1 (0 is the finest)</source>
        <translation>Kräfte und Zahlen kommen von Stufe %1 (0 ist die feinste)</translation>
    </message>
    <message>
        <source>Forces took %1 ms, a step takes %L2 ms; largest speed %L3 %4/s</source>
        <translation>Kräfte brauchten %1 ms, ein Schritt braucht %L2 ms; größte Geschwindigkeit %L3 %4/s</translation>
    </message>
</context>
<context>
    <name>velum::gui::MembraneRoom</name>
    <message>
        <source>P&amp;in the sheet</source>
        <translation>Tuch he&amp;ften</translation>
    </message>
    <message>
        <source>Click the sheet of the membrane and hold it there, or drag it on</source>
        <translation>Das Tuch der Membran anklicken und dort halten oder weiterziehen</translation>
    </message>
    <message>
        <source>P&amp;ush sheet</source>
        <translation>Tuch wegdr&amp;ücken</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet goes around it</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen oder ins Bild klicken: das Tuch geht um sie herum</translation>
    </message>
    <message>
        <source>Pu&amp;ll sheet</source>
        <translation>Tuch her&amp;anziehen</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet is drawn to its middle</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen oder ins Bild klicken: das Tuch wird zu ihrer Mitte gezogen</translation>
    </message>
</context>
<context>
    <name>velum::gui::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelCommands</name>
    <message>
        <source>Colour of the type</source>
        <translation>Farbe des Typs</translation>
    </message>
    <message>
        <source>Colour of the types</source>
        <translation>Farbe der Typen</translation>
    </message>
    <message>
        <source>Protect by membrane</source>
        <translation>Durch Membran schützen</translation>
    </message>
    <message>
        <source>The selected membrane&apos;s sheet goes around it</source>
        <translation>Das Tuch der ausgewählten Membran geht darum herum</translation>
    </message>
    <message>
        <source>Keep in view</source>
        <translation>Im Blick behalten</translation>
    </message>
    <message>
        <source>What stands before it is not drawn, wherever one looks from</source>
        <translation>Was davor steht, wird nicht gezeichnet, von wo auch geschaut wird</translation>
    </message>
    <message>
        <source>What hides this?</source>
        <translation>Was verdeckt dies?</translation>
    </message>
    <message>
        <source>Says which types stand before it, and by how much</source>
        <translation>Sagt, welche Typen davor stehen, und wie sehr</translation>
    </message>
    <message>
        <source>Number to be seen: %1...</source>
        <translation>Sichtbare Anzahl: %1...</translation>
    </message>
    <message>
        <source>Number to be seen...</source>
        <translation>Sichtbare Anzahl...</translation>
    </message>
    <message>
        <source>So many are to be seen; with the numbers that other types have, as near as can be</source>
        <translation>So viele sollen sichtbar sein; mit den Anzahlen, die andere Typen haben, so nah wie möglich</translation>
    </message>
    <message>
        <source>Any number</source>
        <translation>Beliebige Anzahl</translation>
    </message>
    <message>
        <source>Let its number follow the group</source>
        <translation>Anzahl der Gruppe folgen lassen</translation>
    </message>
    <message>
        <source>The number that was set is forgotten: it follows when that of its group is set</source>
        <translation>Die gesetzte Anzahl ist vergessen: sie folgt, wenn die ihrer Gruppe gesetzt wird</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Umbenennen...</translation>
    </message>
    <message>
        <source>Give it the name by which it is shown, in pictures, too (F2)</source>
        <translation>Ihm den Namen geben, unter dem es gezeigt wird, auch in Bildern (F2)</translation>
    </message>
    <message>
        <source>List in legend</source>
        <translation>In Legende aufnehmen</translation>
    </message>
    <message>
        <source>The legend names what is listed; where nothing is, the types that are seen most</source>
        <translation>Die Legende nennt, was aufgenommen ist; wenn nichts, die Typen, die am meisten zu sehen sind</translation>
    </message>
    <message>
        <source>Name this</source>
        <translation>Dies benennen</translation>
    </message>
    <message>
        <source>Its name beside it in the picture, with a leader; the page Marks lists it</source>
        <translation>Sein Name daneben im Bild, mit Hinweislinie; die Seite Marken führt ihn auf</translation>
    </message>
    <message>
        <source>Ghosts</source>
        <translation>Geisterbilder</translation>
    </message>
    <message>
        <source>As the model</source>
        <translation>Wie das Modell</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>Gefüllt</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>Allein beenden</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Allein</translation>
    </message>
    <message>
        <source>Show again what was shown before</source>
        <translation>Wieder zeigen, was vorher zu sehen war</translation>
    </message>
    <message>
        <source>Show nothing but this (Alt+click on the eye)</source>
        <translation>Nichts als dies zeigen (Alt+Klick auf das Auge)</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Bring the camera to its instances</source>
        <translation>Die Kamera zu seinen Instanzen bringen</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Farbe...</translation>
    </message>
    <message>
        <source>Palette&apos;s colour</source>
        <translation>Farbe der Palette</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Shown, in the palette&apos;s colours, in the finish&apos;s material</source>
        <translation>Eingeblendet, in den Farben der Palette, im Material der Ausführung</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelDelegate</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What it is called from now on; nothing: %1, as in the file</source>
        <translation>Wie es von nun an heißt; leer: %1, wie in der Datei</translation>
    </message>
    <message>
        <source>How many %1 are drawn</source>
        <translation>Wie viele gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>A number of instances, or a share: 50, 20 %</source>
        <translation>Eine Anzahl von Instanzen oder ein Anteil: 50, 20 %</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelHeader</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelList</name>
    <message>
        <source>Types of the model</source>
        <translation>Typen des Modells</translation>
    </message>
    <message>
        <source>Compartments and types of the model: shown, colour, name, and how many are seen, hidden and removed</source>
        <translation>Kompartimente und Typen des Modells: eingeblendet, Farbe, Name, und wie viele sichtbar, verdeckt und entfernt sind</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number of instances and no share, such as 50 or 20 %</source>
        <translation>„%1“ ist weder eine Anzahl von Instanzen noch ein Anteil wie 50 oder 20 %</translation>
    </message>
    <message numerus="yes">
        <source>%n types</source>
        <translation>
            <numerusform>%n Typ</numerusform>
            <numerusform>%n Typen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelLookGrid</name>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Look of the model</source>
        <translation>Aussehen des Modells</translation>
    </message>
    <message>
        <source>Palette, light, outlines and background that go together</source>
        <translation>Palette, Licht, Umrisse und Hintergrund, die zusammengehören</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelPanel</name>
    <message>
        <source>Model shown</source>
        <translation>Modell eingeblendet</translation>
    </message>
    <message>
        <source>Whether the model is drawn at all</source>
        <translation>Ob das Modell überhaupt gezeichnet wird</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Colours and names of types over the picture, also in files: those that are seen most, or that are listed</source>
        <translation>Farben und Namen von Typen über dem Bild, auch in Dateien: die am meisten zu sehenden oder die aufgenommenen</translation>
    </message>
    <message>
        <source>Bring to size</source>
        <translation>Größe anpassen</translation>
    </message>
    <message>
        <source>Makes the model a third as long as the other data, and puts it beside them</source>
        <translation>Macht das Modell ein Drittel so lang wie die anderen Daten und stellt es neben sie</translation>
    </message>
    <message>
        <source>Search types</source>
        <translation>Typen suchen</translation>
    </message>
    <message>
        <source>Lists the types and compartments whose name holds these words</source>
        <translation>Führt die Typen und Kompartimente auf, deren Name diese Wörter enthält</translation>
    </message>
    <message>
        <source>The order of the types in their compartments, and which of them are listed</source>
        <translation>Die Reihenfolge der Typen in ihren Kompartimenten, und welche davon aufgeführt sind</translation>
    </message>
    <message>
        <source>Sort</source>
        <translation>Ordnen</translation>
    </message>
    <message>
        <source>By number of instances</source>
        <translation>Nach Anzahl der Instanzen</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Name</translation>
    </message>
    <message>
        <source>By mass</source>
        <translation>Nach Masse</translation>
    </message>
    <message>
        <source>By share that is %1</source>
        <translation>Nach Anteil: %1</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>All types</source>
        <translation>Alle Typen</translation>
    </message>
    <message>
        <source>Types that are seen</source>
        <translation>Typen, die zu sehen sind</translation>
    </message>
    <message>
        <source>Types of which none is seen</source>
        <translation>Typen, von denen nichts zu sehen ist</translation>
    </message>
    <message>
        <source>Types of which some are removed</source>
        <translation>Typen, von denen einige entfernt sind</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle ein</translation>
    </message>
    <message>
        <source>Show all that are listed</source>
        <translation>Alle aufgeführten einblenden</translation>
    </message>
    <message>
        <source>Hide all</source>
        <translation>Alle aus</translation>
    </message>
    <message>
        <source>Hide all that are listed</source>
        <translation>Alle aufgeführten ausblenden</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Show all that are listed, in the palette&apos;s colours and the finish&apos;s material</source>
        <translation>Alle aufgeführten einblenden, in den Farben der Palette und im Material der Ausführung</translation>
    </message>
    <message>
        <source>Types that are shown, of all</source>
        <translation>Eingeblendete Typen, von allen</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>What instances have their colours by; a type&apos;s own colour goes before</source>
        <translation>Wonach Instanzen ihre Farben haben; die eigene Farbe eines Typs geht vor</translation>
    </message>
    <message>
        <source>Choose palette</source>
        <translation>Palette wählen</translation>
    </message>
    <message>
        <source>By type</source>
        <translation>Nach Typ</translation>
    </message>
    <message>
        <source>By compartment</source>
        <translation>Nach Kompartiment</translation>
    </message>
    <message>
        <source>By function</source>
        <translation>Nach Funktion</translation>
    </message>
    <message>
        <source>By element</source>
        <translation>Nach Element</translation>
    </message>
    <message>
        <source>By chain</source>
        <translation>Nach Kette</translation>
    </message>
    <message>
        <source>Up close</source>
        <translation>Von Nahem</translation>
    </message>
    <message>
        <source>How far chains and elements show as shades of the colour where one is close, %</source>
        <translation>Wie weit Ketten und Elemente sich von Nahem als Schattierungen der Farbe zeigen, %</translation>
    </message>
    <message>
        <source>Change colours up close</source>
        <translation>Farben von Nahem ändern</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verschattung</translation>
    </message>
    <message>
        <source>Darkening between instances, %</source>
        <translation>Abdunkeln zwischen Instanzen, %</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Strength of the shadows that the key light casts, %</source>
        <translation>Stärke der Schatten, die das Hauptlicht wirft, %</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>How far what lies deepest fades into the background, %</source>
        <translation>Wie weit das am tiefsten Liegende in den Hintergrund verblasst, %</translation>
    </message>
    <message>
        <source>Ghosts</source>
        <translation>Geisterbilder</translation>
    </message>
    <message>
        <source>How instances that cuts have removed still show; a type&apos;s own choice goes before</source>
        <translation>Wie Instanzen, die Schnitte entfernt haben, noch erscheinen; die eigene Wahl eines Typs geht vor</translation>
    </message>
    <message>
        <source>Choose ghosts</source>
        <translation>Geisterbilder wählen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>Gefüllt</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Of the ghosts, %</source>
        <translation>Der Geisterbilder, %</translation>
    </message>
    <message>
        <source>Change opacity of ghosts</source>
        <translation>Deckkraft der Geisterbilder ändern</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detail</translation>
    </message>
    <message>
        <source>How much of a pixel drawn shapes may be off by, at one sample a pixel: smaller is finer, and slower</source>
        <translation>Um wie viel eines Pixels gezeichnete Formen abweichen dürfen, bei einer Abtastung je Pixel: kleiner ist feiner und langsamer</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>Of the whole model, side by side in a block</source>
        <translation>Des ganzen Modells, Seite an Seite in einem Block</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelRoom</name>
    <message>
        <source>Compartments and types of the model, its look</source>
        <translation>Kompartimente und Typen des Modells, sein Aussehen</translation>
    </message>
    <message>
        <source>Select a type or compartment first: it is kept in view.</source>
        <translation>Zuerst einen Typ oder ein Kompartiment auswählen: das wird im Blick behalten.</translation>
    </message>
    <message>
        <source>Looking what hides %1</source>
        <translation>Gesucht wird, was dies verdeckt: %1</translation>
    </message>
    <message>
        <source>Looking how many of %1 can be seen</source>
        <translation>Gesucht wird, wie viele sichtbar sein können: %1</translation>
    </message>
    <message>
        <source>Of %1 %2, %3 are seen now. At most about %4 can be, where cuts leave all of them.</source>
        <translation>Von %1 %2 sind jetzt %3 sichtbar. Höchstens etwa %4 können es sein, wo Schnitte alle stehen lassen.</translation>
    </message>
    <message>
        <source>Number to be seen</source>
        <translation>Sichtbare Anzahl</translation>
    </message>
    <message>
        <source>To be seen, a number or a share such as 20 %:</source>
        <translation>Sichtbar sein sollen, eine Anzahl oder ein Anteil wie 20 %:</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a whole number nor a share up to 100 %.</source>
        <translation>„%1“ ist weder eine ganze Zahl noch ein Anteil bis 100 %.</translation>
    </message>
    <message>
        <source>No type has a number to be seen: give one in its menu.</source>
        <translation>Für keinen Typ ist eine sichtbare Anzahl verlangt: im Menü des Typs angeben.</translation>
    </message>
    <message>
        <source>All numbers are met.</source>
        <translation>Alle Anzahlen sind erreicht.</translation>
    </message>
    <message>
        <source>As near as can be</source>
        <translation>So nah wie möglich</translation>
    </message>
    <message>
        <source>Meeting the numbers to be seen</source>
        <translation>Die sichtbaren Anzahlen werden erreicht</translation>
    </message>
    <message>
        <source>No model is open.</source>
        <translation>Kein Modell ist geöffnet.</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modell</translation>
    </message>
    <message>
        <source>Show the types of the model</source>
        <translation>Die Typen des Modells zeigen</translation>
    </message>
    <message>
        <source>Find &amp;type...</source>
        <translation>&amp;Typ suchen...</translation>
    </message>
    <message>
        <source>Search a type of the model by name</source>
        <translation>Einen Typ des Modells nach Namen suchen</translation>
    </message>
    <message>
        <source>Show all t&amp;ypes</source>
        <translation>Alle T&amp;ypen einblenden</translation>
    </message>
    <message>
        <source>Show every type of the model</source>
        <translation>Jeden Typ des Modells einblenden</translation>
    </message>
    <message>
        <source>Meet num&amp;bers to be seen</source>
        <translation>Sichtbare Anzahlen e&amp;rreichen</translation>
    </message>
    <message>
        <source>Set what cuts leave so that of each type as many are seen as is wanted</source>
        <translation>Einstellen, was Schnitte übrig lassen, sodass von jedem Typ so viele sichtbar sind wie gewünscht</translation>
    </message>
    <message>
        <source>Lege&amp;nd</source>
        <translation>Le&amp;gende</translation>
    </message>
    <message>
        <source>Colours and names of types over the picture, also in files: those that are seen most, or that are listed</source>
        <translation>Farben und Namen von Typen über dem Bild, auch in Dateien: die am meisten zu sehenden oder die aufgenommenen</translation>
    </message>
</context>
<context>
    <name>velum::gui::ModelTree</name>
    <message>
        <source>&lt; %1 %</source>
        <translation>&lt; %1 %</translation>
    </message>
    <message>
        <source>&gt; %1 %</source>
        <translation>&gt; %1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 (%L2 %)</source>
        <translation>%1 (%L2 %)</translation>
    </message>
    <message>
        <source>, about, while the picture is coarse</source>
        <translation>, ungefähr, solange das Bild grob ist</translation>
    </message>
    <message>
        <source>%1: %2%3</source>
        <translation>%1: %2%3</translation>
    </message>
    <message>
        <source>%1 instances</source>
        <translation>%1 Instanzen</translation>
    </message>
    <message>
        <source>, %1 atoms</source>
        <translation>, %1 Atome</translation>
    </message>
    <message>
        <source>, %1 beads</source>
        <translation>, %1 Kugeln</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie die Datei sagt</translation>
    </message>
    <message>
        <source>of its atoms</source>
        <translation>seiner Atome</translation>
    </message>
    <message>
        <source>from the volume of its beads</source>
        <translation>aus dem Volumen seiner Kugeln</translation>
    </message>
    <message>
        <source>%1 each, %2</source>
        <translation>je %1, %2</translation>
    </message>
    <message>
        <source>%1 shapes</source>
        <translation>%1 Formen</translation>
    </message>
    <message>
        <source>Function: %1</source>
        <translation>Funktion: %1</translation>
    </message>
    <message>
        <source>Structure: %1</source>
        <translation>Struktur: %1</translation>
    </message>
    <message>
        <source>Put along curves of the file</source>
        <translation>Entlang von Kurven der Datei gesetzt</translation>
    </message>
    <message>
        <source>Not in the file: made to complete the model</source>
        <translation>Nicht in der Datei: zur Vervollständigung des Modells erzeugt</translation>
    </message>
    <message>
        <source>Shown: click to hide, Alt+click to show it alone</source>
        <translation>Eingeblendet: klicken blendet aus, Alt+Klick zeigt es allein</translation>
    </message>
    <message>
        <source>Hidden: click to show, Alt+click to show it alone</source>
        <translation>Ausgeblendet: klicken blendet ein, Alt+Klick zeigt es allein</translation>
    </message>
    <message>
        <source>Click to choose another colour</source>
        <translation>Klicken, um eine andere Farbe zu wählen</translation>
    </message>
    <message>
        <source>Drag the right knob to set how many are drawn, the left one how many are seen (Ctrl+Right, Ctrl+Left; with Shift: seen)</source>
        <translation>Am rechten Knopf ziehen stellt ein, wie viele gezeichnet werden, am linken, wie viele sichtbar sind (Strg+Rechts, Strg+Links; mit Umschalt: sichtbar)</translation>
    </message>
    <message>
        <source>How many are drawn: double-click or Shift+F2 to type another number, or a share in %</source>
        <translation>Wie viele gezeichnet werden: Doppelklick oder Umschalt+F2, um eine andere Anzahl oder einen Anteil in % zu tippen</translation>
    </message>
    <message>
        <source>%1, in the file %2</source>
        <translation>%1, in der Datei %2</translation>
    </message>
    <message>
        <source>%1 instances of %2 types</source>
        <translation>%1 Instanzen von %2 Typen</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 insgesamt</translation>
    </message>
    <message>
        <source>mass unknown</source>
        <translation>Masse unbekannt</translation>
    </message>
    <message>
        <source>To be seen: %1, set by hand</source>
        <translation>Sichtbare Anzahl: %1, von Hand gesetzt</translation>
    </message>
    <message>
        <source>Drawn: %1, set by hand: it stays when the number of its group is set</source>
        <translation>Gezeichnet: %1, von Hand gesetzt: bleibt, wenn die Anzahl der Gruppe gesetzt wird</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>eingeblendet</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>partly shown</source>
        <translation>teilweise eingeblendet</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Eingeblendet</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
</context>
<context>
    <name>velum::gui::NoiseForm</name>
    <message>
        <source>Take noise out first</source>
        <translation>Zuerst Rauschen entfernen</translation>
    </message>
    <message>
        <source>Least piece</source>
        <translation>Kleinstes Stück</translation>
    </message>
    <message>
        <source>Least piece that is protected by value, voxels</source>
        <translation>Kleinstes Stück, das nach Wert geschützt wird, Voxel</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source> voxels</source>
        <translation> Voxel</translation>
    </message>
    <message>
        <source>What is protected by value counts in pieces of so many voxels or more, joined by their faces.
Automatic: as many as noise does not explain. 1: everything counts.</source>
        <translation>Was nach Wert geschützt wird, zählt in Stücken von so vielen oder mehr Voxeln, die mit Flächen zusammenhängen.
Automatisch: so viele, wie Rauschen nicht erklärt. 1: alles zählt.</translation>
    </message>
    <message>
        <source>The forces are by the values of the data with its noise taken out: what is thin and little brighter than its noise holds together, and what is around it is not taken for it</source>
        <translation>Die Kräfte richten sich nach den vom Rauschen befreiten Werten der Daten: Dünnes und wenig Helleres als das Rauschen hält zusammen, und seine Umgebung wird nicht dafür gehalten</translation>
    </message>
    <message>
        <source>Change membrane: least piece</source>
        <translation>Membran ändern: kleinstes Stück</translation>
    </message>
    <message>
        <source>Change membrane: take noise out</source>
        <translation>Membran ändern: Rauschen entfernen</translation>
    </message>
    <message>
        <source>Leaves out %1 specks under %2 voxels, %3 % of what is protected by value.</source>
        <translation>Lässt %1 Krümel unter %2 Voxeln weg, %3 % dessen, was nach Wert geschützt wird.</translation>
    </message>
    <message>
        <source>%1 voxels are %L2 %3</source>
        <translation>%1 Voxel sind %L2 %3</translation>
    </message>
</context>
<context>
    <name>velum::gui::NumberField</name>
    <message>
        <source>%1 is outside %2 to %3</source>
        <translation>%1 liegt nicht zwischen %2 und %3</translation>
    </message>
    <message>
        <source>“%1” is not understood; nothing was changed</source>
        <translation>„%1“ ist nicht verständlich; nichts wurde geändert</translation>
    </message>
</context>
<context>
    <name>velum::gui::OwnColor</name>
    <message>
        <source>Own colour</source>
        <translation>Eigene Farbe</translation>
    </message>
    <message>
        <source>Own colour of the %1</source>
        <translation>Eigene Farbe: %1</translation>
    </message>
    <message>
        <source>Off: as other lettering, dark on a light ground and light on a dark one if that has no colour</source>
        <translation>Aus: wie andere Schrift, dunkel auf hellem und hell auf dunklem Grund, wenn die keine Farbe hat</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the %1</source>
        <translation>Farbe: %1</translation>
    </message>
    <message>
        <source>Change colour of %1</source>
        <translation>Farbe ändern: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::PictureGrid</name>
    <message>
        <source>No small pictures: %1</source>
        <translation>Keine kleinen Bilder: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Allgemein</translation>
    </message>
    <message>
        <source>&amp;Mouse and wheel</source>
        <translation>&amp;Maus und Rad</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>M&amp;emory</source>
        <translation>S&amp;peicher</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Aufbewahrt in %1</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark lets the picture glow; light is easier in a bright room</source>
        <translation>Dunkel lässt das Bild leuchten; Hell ist in einem hellen Raum angenehmer</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Erscheinung</translation>
    </message>
    <message>
        <source>As the system&apos;s</source>
        <translation>Wie die des Systems</translation>
    </message>
    <message>
        <source>Of the window, from the next start on; files and scripts stay as they are</source>
        <translation>Des Fensters, ab dem nächsten Start; Dateien und Skripte bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>As it was last</source>
        <translation>Wie zuletzt</translation>
    </message>
    <message>
        <source>Four views</source>
        <translation>Vier Ansichten</translation>
    </message>
    <message>
        <source>3D only</source>
        <translation>Nur 3D</translation>
    </message>
    <message>
        <source>3D and one section</source>
        <translation>3D und ein Schnittbild</translation>
    </message>
    <message>
        <source>One section</source>
        <translation>Ein Schnittbild</translation>
    </message>
    <message>
        <source>The views in which data opens</source>
        <translation>Die Ansichten, in denen sich Daten öffnen</translation>
    </message>
    <message>
        <source>&amp;Views of new data</source>
        <translation>A&amp;nsichten neuer Daten</translation>
    </message>
    <message>
        <source>What suits the data</source>
        <translation>Was zu den Daten passt</translation>
    </message>
    <message>
        <source>In which lengths are shown; any unit can be typed</source>
        <translation>In welcher Einheit Längen gezeigt werden; eintippen lässt sich jede</translation>
    </message>
    <message>
        <source>Unit of lengt&amp;hs</source>
        <translation>Einheit der &amp;Längen</translation>
    </message>
    <message>
        <source>&amp;Left button in 3D</source>
        <translation>L&amp;inke Taste in 3D</translation>
    </message>
    <message>
        <source>Turns; the middle one moves</source>
        <translation>Dreht; die mittlere verschiebt</translation>
    </message>
    <message>
        <source>Moves; the middle one turns</source>
        <translation>Verschiebt; die mittlere dreht</translation>
    </message>
    <message>
        <source>What dragging does in the 3D view; with Shift the left button does the other</source>
        <translation>Was Ziehen in der 3D-Ansicht tut; mit Umschalt tut die linke Taste das andere</translation>
    </message>
    <message>
        <source>&amp;Wheel forward in 3D</source>
        <translation>Ra&amp;d vorwärts in 3D</translation>
    </message>
    <message>
        <source>Comes nearer</source>
        <translation>Geht näher heran</translation>
    </message>
    <message>
        <source>Goes away</source>
        <translation>Geht weiter weg</translation>
    </message>
    <message>
        <source>Which way the wheel moves the eye</source>
        <translation>Wohin das Rad das Auge bewegt</translation>
    </message>
    <message>
        <source>Wheel in &amp;sections</source>
        <translation>Rad in &amp;Schnittbildern</translation>
    </message>
    <message>
        <source>Goes through the planes; with Ctrl nearer</source>
        <translation>Geht durch die Ebenen; mit Strg näher heran</translation>
    </message>
    <message>
        <source>Comes nearer; with Ctrl through the planes</source>
        <translation>Geht näher heran; mit Strg durch die Ebenen</translation>
    </message>
    <message>
        <source>What the wheel does over a section</source>
        <translation>Was das Rad über einem Schnittbild tut</translation>
    </message>
    <message>
        <source>The right button comes nearer in 3D, and sets the grey window in sections.</source>
        <translation>Die rechte Taste geht in 3D näher heran und stellt in Schnittbildern das Grauwertfenster ein.</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>What the card has</source>
        <translation>Was die Karte hat</translation>
    </message>
    <message>
        <source>Most of the graphics card&apos;s memory that is used; larger volumes are shown reduced</source>
        <translation>So viel Speicher der Grafikkarte wird höchstens benutzt; größere Volumen werden verkleinert gezeigt</translation>
    </message>
    <message>
        <source>&amp;Graphics memory at most</source>
        <translation>&amp;Grafikspeicher höchstens</translation>
    </message>
    <message>
        <source>Counts when Velum starts next. The variable VELUM_GPU_MEMORY_MB goes before it. Where a volume does not fit it is shown reduced, which the status line says.</source>
        <translation>Gilt ab dem nächsten Start von Velum. Die Variable VELUM_GPU_MEMORY_MB geht vor. Wo ein Volumen nicht hineinpasst, wird es verkleinert gezeigt; die Statuszeile sagt es.</translation>
    </message>
    <message>
        <source>Memory for &amp;bricks</source>
        <translation>Speicher &amp;für Blöcke</translation>
    </message>
    <message>
        <source>An eighth of the machine&apos;s (%1 MiB)</source>
        <translation>Ein Achtel des Arbeitsspeichers (%1 MiB)</translation>
    </message>
    <message>
        <source>Most of the machine&apos;s memory that keeps bricks of a streamed volume; 64 MiB at least, half of it at most. Counts at once</source>
        <translation>So viel Speicher des Rechners hält höchstens Blöcke eines gestreamten Volumens; mindestens 64 MiB, höchstens die Hälfte. Gilt sofort</translation>
    </message>
    <message>
        <source>Graphics memory for b&amp;ricks</source>
        <translation>Grafikspeicher für Bl&amp;öcke</translation>
    </message>
    <message>
        <source>A quarter of the card&apos;s, 2048 MiB at most</source>
        <translation>Ein Viertel des Speichers der Karte, höchstens 2048 MiB</translation>
    </message>
    <message>
        <source>Most of the graphics card&apos;s memory for a streamed volume: where less is there than is seen, all is shown coarser. Counts at once, and the picture begins anew</source>
        <translation>So viel Speicher der Grafikkarte steht höchstens für ein gestreamtes Volumen bereit: wo mehr zu sehen ist, als hineinpasst, wird alles gröber gezeigt. Gilt sofort, und das Bild beginnt neu</translation>
    </message>
    <message>
        <source>Read whole up &amp;to</source>
        <translation>Gan&amp;z lesen bis</translation>
    </message>
    <message>
        <source>Volumes with levels of detail up to this size are read whole, larger ones are streamed. Counts for what is opened next</source>
        <translation>Volumen mit Detailstufen bis zu dieser Größe werden ganz gelesen, größere gestreamt. Gilt für das, was als Nächstes geöffnet wird</translation>
    </message>
    <message>
        <source>As the screen shows it</source>
        <translation>Wie der Bildschirm es zeigt</translation>
    </message>
    <message>
        <source>0, the finest</source>
        <translation>0, die feinste</translation>
    </message>
    <message>
        <source>%1, coarser</source>
        <translation>%1, gröber</translation>
    </message>
    <message>
        <source>The level of detail at which volumes open. A level that is chosen here is read whole, or the next that fits into half of the memory. Counts for what is opened next</source>
        <translation>Die Detailstufe, mit der sich Volumen öffnen. Eine hier gewählte Stufe wird ganz gelesen oder die nächste, die in den halben Speicher passt. Gilt für das, was als Nächstes geöffnet wird</translation>
    </message>
    <message>
        <source>Level of &amp;detail</source>
        <translation>Detailst&amp;ufe</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>velum::gui::PreparingVeil</name>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
</context>
<context>
    <name>velum::gui::PresetGrid</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Colours, opacity and light made for a kind of data</source>
        <translation>Farben, Deckkraft und Licht für eine Art von Daten</translation>
    </message>
    <message>
        <source>Presets made for other kinds of data</source>
        <translation>Vorgaben für andere Arten von Daten</translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation>Weniger</translation>
    </message>
</context>
<context>
    <name>velum::gui::ProgressStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop this (Esc)</source>
        <translation>Dies anhalten (Esc)</translation>
    </message>
</context>
<context>
    <name>velum::gui::ProtectTool</name>
    <message>
        <source>values around %1</source>
        <translation>Werte um %1</translation>
    </message>
    <message>
        <source>Nothing stands out here; click well inside of what you mean</source>
        <translation>Hier hebt sich nichts ab; mitten in das Gemeinte klicken</translation>
    </message>
    <message>
        <source>Let through: %1</source>
        <translation>Durchgelassen: %1</translation>
    </message>
    <message>
        <source>Protected: %1</source>
        <translation>Geschützt: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::PullSteps</name>
    <message>
        <source>1 Cut</source>
        <translation>1 Schnitt</translation>
    </message>
    <message>
        <source>Add a plane that opens what is shown</source>
        <translation>Ebene hinzufügen, die öffnet, was zu sehen ist</translation>
    </message>
    <message>
        <source>Cut what is shown open, and drag the cut to where it meets what you want to show.</source>
        <translation>Das Gezeigte aufschneiden und den Schnitt dorthin ziehen, wo er trifft, was gezeigt werden soll.</translation>
    </message>
    <message>
        <source>2 Pull</source>
        <translation>2 Ziehen</translation>
    </message>
    <message>
        <source>Take up the tool that drags structures out of the cut</source>
        <translation>Das Werkzeug nehmen, das Strukturen aus dem Schnitt zieht</translation>
    </message>
    <message>
        <source>Press on a bone, a vessel or an organ in the cut&apos;s face and drag it towards you. What has no label yet is found from its values as you pull.</source>
        <translation>Auf Knochen, Gefäß oder Organ in der Schnittfläche drücken und zum Betrachter ziehen. Was noch kein Label hat, wird beim Ziehen aus seinen Werten gefunden.</translation>
    </message>
    <message>
        <source>3 Finish</source>
        <translation>3 Finish</translation>
    </message>
    <message>
        <source>Go to the page Finish</source>
        <translation>Zur Seite Finish gehen</translation>
    </message>
    <message>
        <source>Pull out what else belongs to the picture; then choose how it is drawn: as a plate, in pencil, in ink.</source>
        <translation>Herausziehen, was sonst zum Bild gehört; dann wählen, wie es gezeichnet wird: als Tafel, mit Bleistift, mit Tusche.</translation>
    </message>
    <message>
        <source>4 Save</source>
        <translation>4 Speichern</translation>
    </message>
    <message>
        <source>Save the picture, at any size</source>
        <translation>Bild speichern, in beliebiger Größe</translation>
    </message>
    <message>
        <source>Save the picture. It opens as its scene, to be changed again.</source>
        <translation>Das Bild speichern. Es lässt sich als seine Szene öffnen und weiter ändern.</translation>
    </message>
</context>
<context>
    <name>velum::gui::PullTool</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>Nothing here to pull: press on the cut&apos;s face. A drag on the empty ground turns the view.</source>
        <translation>Hier ist nichts zu ziehen: auf die Schnittfläche drücken. Ziehen auf leerem Grund dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Nothing stands out here; click well inside of what you mean</source>
        <translation>Hier hebt sich nichts ab; mitten in das Gemeinte klicken</translation>
    </message>
    <message>
        <source>%1 is spared whole by this cut already: take that off in the list of cuts to pull it</source>
        <translation>%1 ist von diesem Schnitt schon ganz ausgespart: in der Liste der Schnitte abwählen, um es zu ziehen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, drag %2 to pull it out</source>
        <translation>%1, zum Herausziehen %2 ziehen</translation>
    </message>
    <message>
        <source>%1, its end</source>
        <translation>%1, sein Ende</translation>
    </message>
    <message>
        <source>Pull out %1</source>
        <translation>%1 herausziehen</translation>
    </message>
    <message numerus="yes">
        <source>Pull out %n structures</source>
        <translation>
            <numerusform>%n Struktur herausziehen</numerusform>
            <numerusform>%n Strukturen herausziehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading the voxels there; hold the button</source>
        <translation>Die Voxel dort werden gelesen; Taste gedrückt halten</translation>
    </message>
    <message>
        <source>%1 has labels of its own: a stroke with Ctrl adds to what was found from its values</source>
        <translation>%1 hat eigene Labels: ein Strich mit Strg ergänzt, was aus Werten gefunden wurde</translation>
    </message>
    <message>
        <source>Pull a structure out, or select one that was: a stroke with Ctrl adds to it</source>
        <translation>Eine Struktur herausziehen oder eine herausgezogene auswählen: ein Strich mit Strg ergänzt sie</translation>
    </message>
    <message>
        <source>Add to %1</source>
        <translation>%1 ergänzen</translation>
    </message>
    <message>
        <source>Nothing was added to %1: nothing under the stroke has its values, %2 to %3</source>
        <translation>%1 wurde nicht ergänzt: nichts unter dem Strich hat seine Werte, %2 bis %3</translation>
    </message>
    <message>
        <source>Not this: %1</source>
        <translation>Dies nicht: %1</translation>
    </message>
    <message>
        <source>%1 gives up nothing: it could not grow there. Click on what it has leaked into, away from where it was pressed on</source>
        <translation>%1 gibt nichts ab: dort konnte es nicht wachsen. Auf das klicken, worin es ausgelaufen ist, fern von der Stelle, auf die gedrückt wurde</translation>
    </message>
    <message>
        <source>Add a cut first: there is none to pull out of. Esc ends.</source>
        <translation>Zuerst einen Schnitt hinzufügen: es gibt keinen, aus dem zu ziehen wäre. Esc beendet.</translation>
    </message>
    <message>
        <source>Click on what is not of it, or draw over it: it gives up what is nearer to that. Esc takes this back.</source>
        <translation>Auf das klicken oder darüberziehen, was nicht dazugehört: abgegeben wird, was dem näher liegt. Esc nimmt dies zurück.</translation>
    </message>
    <message>
        <source>Two planes hold this: Space changes the one that it is pulled out of. Esc ends.</source>
        <translation>Zwei Ebenen halten dies: die Leertaste wechselt die, aus der gezogen wird. Esc beendet.</translation>
    </message>
    <message>
        <source>Drag a structure out of the cut. Shift takes several. A stroke with Ctrl adds to the selected one, a click or a stroke with Ctrl and Shift says what is not of it. Esc ends.</source>
        <translation>Eine Struktur aus dem Schnitt ziehen. Umschalt nimmt mehrere. Ein Strich mit Strg ergänzt die ausgewählte, ein Klick oder Strich mit Strg und Umschalt sagt, was nicht dazugehört. Esc beendet.</translation>
    </message>
    <message>
        <source>Drag the structure out of the cut. Shift takes several, Ctrl and Shift only the part that is joined to the place. Esc ends.</source>
        <translation>Die Struktur aus dem Schnitt ziehen. Umschalt nimmt mehrere, Strg und Umschalt nur den Teil, der mit der Stelle zusammenhängt. Esc beendet.</translation>
    </message>
    <message>
        <source>Drag a structure out of the cut. Shift takes several, Ctrl and the wheel, or [ and ], move the plane. Esc ends.</source>
        <translation>Eine Struktur aus dem Schnitt ziehen. Umschalt nimmt mehrere, Strg und Rad oder [ und ] verschieben die Ebene. Esc beendet.</translation>
    </message>
    <message>
        <source>What has no label</source>
        <translation>Was kein Label hat</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>ganz</translation>
    </message>
</context>
<context>
    <name>velum::gui::PyramidCommands</name>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source>%L1 GiB</source>
        <translation>%L1 GiB</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%L1 h</source>
        <translation>%L1 h</translation>
    </message>
    <message>
        <source>%1 beside it has the same voxels and coarser levels.</source>
        <translation>%1 daneben hat dieselben Voxel und gröbere Stufen.</translation>
    </message>
    <message>
        <source>A pyramid beside it would let it open at once, but it cannot be written: %1</source>
        <translation>Mit einer Pyramide daneben würde es sich sofort öffnen, sie kann aber nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>A pyramid beside it, %1, lets it open at once and be streamed. It takes up to %2 of the disk, of which %3 are free, and about %4 on a machine that has little else to do; you can go on working meanwhile. The file itself stays as it is.</source>
        <translation>Mit einer Pyramide daneben, %1, öffnet es sich sofort und wird gestreamt. Sie braucht bis zu %2 auf dem Datenträger, wovon %3 frei sind, und etwa %4 auf einem Rechner, der sonst wenig zu tun hat; weiterarbeiten ist währenddessen möglich. Die Datei selbst bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>It was begun and stopped; what is there already is not written again.</source>
        <translation>Sie wurde begonnen und angehalten; was schon da ist, wird nicht noch einmal geschrieben.</translation>
    </message>
    <message>
        <source>Make a p&amp;yramid beside it...</source>
        <translation>P&amp;yramide daneben erzeugen...</translation>
    </message>
    <message>
        <source>Write the open file with coarser levels beside it, as OME-Zarr: what opens at once, whatever its size</source>
        <translation>Die offene Datei mit gröberen Stufen daneben schreiben, als OME-Zarr: das öffnet sich sofort, wie groß es auch ist</translation>
    </message>
    <message>
        <source>Stop writing; what is on the disk stays, and the next writer goes on</source>
        <translation>Schreiben anhalten; was auf dem Datenträger ist, bleibt, und das nächste Schreiben macht dort weiter</translation>
    </message>
    <message>
        <source>%1 has levels already, or cannot be read piece by piece; Save as writes a pyramid of what is open.</source>
        <translation>%1 hat schon Stufen oder kann nicht stückweise gelesen werden; Speichern unter schreibt eine Pyramide des Geöffneten.</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>%1 has %2 of voxels and no coarser levels.</source>
        <translation>%1 hat %2 Voxel und keine gröberen Stufen.</translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>&amp;Make the pyramid</source>
        <translation>Pyramide &amp;erzeugen</translation>
    </message>
    <message>
        <source>Read it &amp;whole</source>
        <translation>&amp;Ganz lesen</translation>
    </message>
    <message>
        <source>It takes %1 of memory</source>
        <translation>Das braucht %1 Speicher</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Nicht jetzt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation>%1 wird erzeugt</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>%1 is not whole; Edit &gt; Make a pyramid goes on where it was.</source>
        <translation>%1 ist nicht vollständig; Bearbeiten &gt; Pyramide daneben erzeugen macht dort weiter.</translation>
    </message>
    <message>
        <source>Use the pyramid</source>
        <translation>Pyramide verwenden</translation>
    </message>
    <message>
        <source>%1 is whole: the open scene takes its voxels from it. Undo goes back.</source>
        <translation>%1 ist vollständig: die offene Szene nimmt ihre Voxel daraus. Rückgängig führt zurück.</translation>
    </message>
    <message>
        <source>%1 is whole. What was grown in the open file stays there; open %1 to use it.</source>
        <translation>%1 ist vollständig. Was in der offenen Datei gewachsen ist, bleibt dort; %1 öffnen, um sie zu verwenden.</translation>
    </message>
    <message>
        <source>%1 is whole: open it to use it.</source>
        <translation>%1 ist vollständig: öffnen, um sie zu verwenden.</translation>
    </message>
</context>
<context>
    <name>velum::gui::RawDialog</name>
    <message>
        <source>, big endian</source>
        <translation>, Big Endian</translation>
    </message>
    <message>
        <source>, header of %1 bytes</source>
        <translation>, Dateikopf von %1 Bytes</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>%1 has no header that says what its samples are. The picture shows how they would be read.</source>
        <translation>%1 hat keinen Dateikopf, der sagt, was die Werte sind. Das Bild zeigt, wie sie gelesen würden.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>Guesses</source>
        <translation>Vermutungen</translation>
    </message>
    <message>
        <source>Layouts that fill the file to its last byte, the smoothest first</source>
        <translation>Anordnungen, die die Datei bis zum letzten Byte füllen, die glatteste zuerst</translation>
    </message>
    <message>
        <source>&amp;Guess</source>
        <translation>Ve&amp;rmutung</translation>
    </message>
    <message>
        <source>Voxels along x</source>
        <translation>Voxel entlang x</translation>
    </message>
    <message>
        <source>Voxels along y</source>
        <translation>Voxel entlang y</translation>
    </message>
    <message>
        <source>Voxels along z</source>
        <translation>Voxel entlang z</translation>
    </message>
    <message>
        <source>&amp;Voxels</source>
        <translation>&amp;Voxel</translation>
    </message>
    <message>
        <source>Type of a sample</source>
        <translation>Typ eines Werts</translation>
    </message>
    <message>
        <source>What one sample is: its bits, and whether it has a sign</source>
        <translation>Was ein Wert ist: seine Bits, und ob er ein Vorzeichen hat</translation>
    </message>
    <message>
        <source>&amp;Type</source>
        <translation>&amp;Typ</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Bytefolge</translation>
    </message>
    <message>
        <source>Little endian (PC)</source>
        <translation>Little Endian (PC)</translation>
    </message>
    <message>
        <source>Big endian</source>
        <translation>Big Endian</translation>
    </message>
    <message>
        <source>Which byte of a sample comes first; bytes alone have none</source>
        <translation>Welches Byte eines Werts zuerst kommt; einzelne Bytes haben keine</translation>
    </message>
    <message>
        <source>&amp;Byte order</source>
        <translation>&amp;Bytefolge</translation>
    </message>
    <message>
        <source>Samples of a voxel, one after the other</source>
        <translation>Werte eines Voxels, einer nach dem anderen</translation>
    </message>
    <message>
        <source>&amp;Samples a voxel</source>
        <translation>&amp;Werte je Voxel</translation>
    </message>
    <message>
        <source>Bytes before the first sample</source>
        <translation>Bytes vor dem ersten Wert</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> Bytes</translation>
    </message>
    <message>
        <source>&amp;Header</source>
        <translation>Datei&amp;kopf</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <source>A plane as it would be read</source>
        <translation>Eine Ebene, wie sie gelesen würde</translation>
    </message>
    <message>
        <source>Plane that is shown</source>
        <translation>Gezeigte Ebene</translation>
    </message>
    <message>
        <source>Which plane along z the picture shows</source>
        <translation>Welche Ebene entlang z das Bild zeigt</translation>
    </message>
    <message>
        <source>Looking at the file...</source>
        <translation>Die Datei wird untersucht...</translation>
    </message>
    <message>
        <source>None fits; give its size</source>
        <translation>Keine passt; Größe angeben</translation>
    </message>
    <message>
        <source>Another one</source>
        <translation>Eine andere</translation>
    </message>
    <message>
        <source>The file is compressed: only opening tells whether the size is right.</source>
        <translation>Die Datei ist komprimiert: erst das Öffnen sagt, ob die Größe stimmt.</translation>
    </message>
    <message>
        <source>This fills the file: %1 bytes.</source>
        <translation>Das füllt die Datei: %1 Bytes.</translation>
    </message>
    <message>
        <source>This needs %1 bytes, the file has %2.</source>
        <translation>Das braucht %1 Bytes, die Datei hat %2.</translation>
    </message>
</context>
<context>
    <name>velum::gui::ReadyFilmDialog</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Write its keys into the film of the scene, where they can be changed</source>
        <translation>Seine Schlüsselbilder in den Film der Szene schreiben, wo sie sich ändern lassen</translation>
    </message>
    <message>
        <source>Save as film...</source>
        <translation>Als Film speichern...</translation>
    </message>
    <message>
        <source>Add it, and go on to save the film of the scene as a video</source>
        <translation>Hinzufügen und damit fortfahren, den Film der Szene als Video zu speichern</translation>
    </message>
    <message>
        <source>All that are on</source>
        <translation>Alle, die eingeschaltet sind</translation>
    </message>
    <message>
        <source>Its keys stand from %L1 s to %L2 s of the film; undo takes them back.</source>
        <translation>Seine Schlüsselbilder stehen von %L1 s bis %L2 s des Films; Rückgängig nimmt sie zurück.</translation>
    </message>
    <message>
        <source>&quot;Title&quot;</source>
        <translation>&quot;Titel&quot;</translation>
    </message>
</context>
<context>
    <name>velum::gui::RecentCard</name>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open %1
%2</source>
        <translation>%1 öffnen
%2</translation>
    </message>
</context>
<context>
    <name>velum::gui::RecentRow</name>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Aus dieser Liste entfernen</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
</context>
<context>
    <name>velum::gui::RecoveryBar</name>
    <message>
        <source>Unsaved work that cannot be read</source>
        <translation>Nicht gespeicherte Arbeit, die nicht lesbar ist</translation>
    </message>
    <message>
        <source>Unsaved work: %1</source>
        <translation>Nicht gespeicherte Arbeit: %1</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>eine Szene</translation>
    </message>
    <message>
        <source>From %1. %2 (%3)</source>
        <translation>Von: %1. %2 (%3)</translation>
    </message>
    <message>
        <source>, last change: %1</source>
        <translation>, letzte Änderung: %1</translation>
    </message>
    <message>
        <source>Never saved</source>
        <translation>Nie gespeichert</translation>
    </message>
    <message>
        <source>. What came later cannot be read (%1)</source>
        <translation>. Was später kam, ist nicht lesbar (%1)</translation>
    </message>
    <message>
        <source>From %1%2. %3%4</source>
        <translation>Von: %1%2. %3%4</translation>
    </message>
    <message>
        <source>Unsaved work of an earlier session</source>
        <translation>Nicht gespeicherte Arbeit einer früheren Sitzung</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Open it as it was at the last change</source>
        <translation>Öffnen, wie es bei der letzten Änderung war</translation>
    </message>
    <message>
        <source>&amp;Discard...</source>
        <translation>&amp;Verwerfen...</translation>
    </message>
    <message>
        <source>Delete this work for good</source>
        <translation>Diese Arbeit endgültig löschen</translation>
    </message>
    <message>
        <source>L&amp;ater</source>
        <translation>S&amp;päter</translation>
    </message>
    <message>
        <source>Keep it; it is offered again at the next start</source>
        <translation>Behalten; beim nächsten Start wird sie wieder angeboten</translation>
    </message>
    <message numerus="yes">
        <source>   (%n more)</source>
        <translation>
            <numerusform>   (%n weitere)</numerusform>
            <numerusform>   (%n weitere)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>velum::gui::Room</name>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Go to this structure and select it</source>
        <translation>Zu dieser Struktur gehen und sie auswählen</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Select this molecular type</source>
        <translation>Diesen Molekültyp auswählen</translation>
    </message>
</context>
<context>
    <name>velum::gui::SamplesRow</name>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Draft (1 sample)</source>
        <translation>Entwurf (1 Abtastung)</translation>
    </message>
    <message>
        <source>Good (4 samples)</source>
        <translation>Gut (4 Abtastungen)</translation>
    </message>
    <message>
        <source>Fine (16 samples)</source>
        <translation>Fein (16 Abtastungen)</translation>
    </message>
    <message>
        <source>Finest (64 samples)</source>
        <translation>Am feinsten (64 Abtastungen)</translation>
    </message>
    <message>
        <source>Samples:</source>
        <translation>Abtastungen:</translation>
    </message>
    <message>
        <source>Pictures that are averaged: more are smoother and take longer</source>
        <translation>Bilder, die gemittelt werden: mehr sind glatter und dauern länger</translation>
    </message>
    <message>
        <source>Samples a pixel</source>
        <translation>Abtastungen je Pixel</translation>
    </message>
    <message>
        <source>Samples a pixel, 1 to 256</source>
        <translation>Abtastungen je Pixel, 1 bis 256</translation>
    </message>
</context>
<context>
    <name>velum::gui::SaveFilmDialog</name>
    <message>
        <source>Save film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Draw the film in the background, and write it</source>
        <translation>Den Film im Hintergrund zeichnen und schreiben</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line that makes this film without a window: the same bytes, for scripts</source>
        <translation>Die Befehlszeile kopieren, die diesen Film ohne Fenster macht: dieselben Bytes, für Skripte</translation>
    </message>
    <message>
        <source>Where the film goes</source>
        <translation>Wohin der Film kommt</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen...</translation>
    </message>
    <message>
        <source>Choose where the film goes</source>
        <translation>Wählen, wohin der Film kommt</translation>
    </message>
    <message>
        <source>A video, or a picture for each frame</source>
        <translation>Ein Video oder ein Bild für jedes Einzelbild</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size of the frames, pixels</source>
        <translation>Größe der Einzelbilder, Pixel</translation>
    </message>
    <message>
        <source>Square, %1</source>
        <translation>Quadratisch, %1</translation>
    </message>
    <message>
        <source>As the view, %1</source>
        <translation>Wie die Ansicht, %1</translation>
    </message>
    <message>
        <source>Own size:</source>
        <translation>Eigene Größe:</translation>
    </message>
    <message>
        <source>Width of the frames, pixels</source>
        <translation>Breite der Einzelbilder, Pixel</translation>
    </message>
    <message>
        <source>Height of the frames, pixels</source>
        <translation>Höhe der Einzelbilder, Pixel</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Frames a second, 0.01 to 1000</source>
        <translation>Einzelbilder je Sekunde, 0,01 bis 1000</translation>
    </message>
    <message>
        <source>The whole film, or the part of it that is played</source>
        <translation>Der ganze Film oder der Teil, der abgespielt wird</translation>
    </message>
    <message>
        <source>Whole film</source>
        <translation>Ganzer Film</translation>
    </message>
    <message>
        <source>From %L1 s to %L2 s</source>
        <translation>Von %L1 s bis %L2 s</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>How many pictures are averaged in a frame while things move; each is work</source>
        <translation>Wie viele Bilder in einem Einzelbild gemittelt werden, während sich etwas bewegt; jedes ist Arbeit</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source> pictures a frame</source>
        <translation> Bilder je Einzelbild</translation>
    </message>
    <message>
        <source>How much of the pictures a video keeps, 0 to 100</source>
        <translation>Wie viel von den Bildern ein Video bewahrt, 0 bis 100</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>No background, with alpha: not in MP4</source>
        <translation>Kein Hintergrund, mit Alpha: nicht in MP4</translation>
    </message>
    <message>
        <source>16 bits a colour</source>
        <translation>16 Bit je Farbe</translation>
    </message>
    <message>
        <source>More levels of colour: of frames alone</source>
        <translation>Mehr Farbstufen: nur in Einzelbildern</translation>
    </message>
    <message>
        <source>Layers: depth, normal, structure, position</source>
        <translation>Ebenen: Tiefe, Normale, Struktur, Position</translation>
    </message>
    <message>
        <source>In each EXR frame, or as pictures beside each PNG frame</source>
        <translation>In jedem EXR-Einzelbild oder als Bilder neben jedem PNG-Einzelbild</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation>Unschärfe</translation>
    </message>
    <message>
        <source>Video quality</source>
        <translation>Videoqualität</translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s at %2 frames a second</source>
        <translation>
            <numerusform>%n Einzelbild, %1 s mit %2 Einzelbildern je Sekunde</numerusform>
            <numerusform>%n Einzelbilder, %1 s mit %2 Einzelbildern je Sekunde</numerusform>
        </translation>
    </message>
    <message>
        <source>, about %1 to draw</source>
        <translation>, etwa %1 zu zeichnen</translation>
    </message>
    <message>
        <source> The scene has no film: this one goes through the time steps.</source>
        <translation> Die Szene hat keinen Film: dieser geht durch die Zeitschritte.</translation>
    </message>
    <message>
        <source> The scene has no film: this one goes once round.</source>
        <translation> Die Szene hat keinen Film: dieser geht einmal ringsum.</translation>
    </message>
    <message>
        <source> The frames are %1, ...</source>
        <translation> Die Einzelbilder heißen %1, ...</translation>
    </message>
    <message>
        <source>%1 already exists.
Replace it?</source>
        <translation>%1 gibt es schon.
Ersetzen?</translation>
    </message>
    <message>
        <source>Frames with this name are there already.
Those of this very film are kept, those of another film are replaced. Go on?</source>
        <translation>Einzelbilder mit diesem Namen gibt es schon.
Die von genau diesem Film bleiben, die eines anderen werden ersetzt. Fortfahren?</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Kopiert: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::SavePictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Drawing a preview...</source>
        <translation>Vorschau wird gezeichnet...</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>Datei wählen...</translation>
    </message>
    <message>
        <source>Choose where the picture goes, and draw it</source>
        <translation>Wählen, wohin das Bild kommt, und es zeichnen</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line that draws this picture without a window: the same bytes, for scripts</source>
        <translation>Die Befehlszeile kopieren, die dieses Bild ohne Fenster zeichnet: dieselben Bytes, für Skripte</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the picture, in the unit beside</source>
        <translation>Breite des Bildes, in der Einheit daneben</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the picture, in the unit beside</source>
        <translation>Höhe des Bildes, in der Einheit daneben</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Pixels, or a size on paper at the resolution below</source>
        <translation>Pixel oder eine Größe auf Papier mit der Auflösung darunter</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels an inch in print; the file says it to programs that lay pages out</source>
        <translation>Pixel je Zoll im Druck; die Datei sagt es Programmen für Seitengestaltung</translation>
    </message>
    <message>
        <source>Keep the shape</source>
        <translation>Seitenverhältnis behalten</translation>
    </message>
    <message>
        <source>Width and height change together</source>
        <translation>Breite und Höhe ändern sich zusammen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>As the view</source>
        <translation>Wie die Ansicht</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>%1 x %2 pixels</source>
        <translation>%1 x %2 Pixel</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>As in the view</source>
        <translation>Wie in der Ansicht</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Transparent pictures have an alpha channel: for layouts</source>
        <translation>Durchsichtige Bilder haben einen Alphakanal: für Layouts</translation>
    </message>
    <message>
        <source>Layers: depth, normal, structure, position</source>
        <translation>Ebenen: Tiefe, Normale, Struktur, Position</translation>
    </message>
    <message>
        <source>Inside an .exr file; as pictures beside a .png or .tif file.
Of an inlay also what stands before it, its image, and what lies behind it, to be put together.</source>
        <translation>In einer .exr-Datei; als Bilder neben einer .png- oder .tif-Datei.
Von einem Inlay auch, was davor steht, sein Bild und was dahinter liegt, zum Zusammensetzen.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>%L1 x %L2 cm at %3 dpi</source>
        <translation>%L1 x %L2 cm bei %3 dpi</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Kopiert: %1</translation>
    </message>
    <message>
        <source>%1 x %2 pixels (%L3 megapixels), %4.
The picture carries the scene: drop it on the window to go on with it.</source>
        <translation>%1 x %2 Pixel (%L3 Megapixel), %4.
Das Bild trägt die Szene in sich: auf das Fenster ziehen, um damit weiterzuarbeiten.</translation>
    </message>
</context>
<context>
    <name>velum::gui::Script</name>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1; line %2 of the script was the last.</source>
        <translation>%1; Zeile %2 des Skripts war die letzte.</translation>
    </message>
</context>
<context>
    <name>velum::gui::SectionOverlay</name>
    <message>
        <source>%1 off the middle</source>
        <translation>%1 neben der Mitte</translation>
    </message>
    <message>
        <source> (turned)</source>
        <translation> (gedreht)</translation>
    </message>
</context>
<context>
    <name>velum::gui::SectionView</name>
    <message>
        <source>%1 section</source>
        <translation>Schnittbild: %1</translation>
    </message>
    <message>
        <source>Interpolation, structures, crosshair, reset (right click)</source>
        <translation>Interpolation, Strukturen, Fadenkreuz, Zurücksetzen (Rechtsklick)</translation>
    </message>
    <message>
        <source>Show the other views again (double click)</source>
        <translation>Die anderen Ansichten wieder zeigen (Doppelklick)</translation>
    </message>
    <message>
        <source>Fill the window (double click)</source>
        <translation>Das Fenster füllen (Doppelklick)</translation>
    </message>
    <message>
        <source>%1 more instances are not outlined</source>
        <translation>%1 weitere Instanzen haben keinen Umriss</translation>
    </message>
    <message>
        <source>&amp;Interpolate</source>
        <translation>&amp;Interpolieren</translation>
    </message>
    <message>
        <source>Off: voxels as blocks</source>
        <translation>Aus: Voxel als Klötze</translation>
    </message>
    <message>
        <source>&amp;Crosshair</source>
        <translation>&amp;Fadenkreuz</translation>
    </message>
    <message>
        <source>Lines where the other sections cross</source>
        <translation>Linien, wo die anderen Schnittbilder kreuzen</translation>
    </message>
    <message>
        <source>C&amp;uts</source>
        <translation>S&amp;chnitte</translation>
    </message>
    <message>
        <source>Cuts as lines; what they remove is dimmed</source>
        <translation>Schnitte als Linien; was sie entfernen, ist abgedunkelt</translation>
    </message>
    <message>
        <source>Opacity of the structures over the grey values</source>
        <translation>Deckkraft der Strukturen über den Grauwerten</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>&amp;Fit	F</source>
        <translation>&amp;Einpassen	F</translation>
    </message>
    <message>
        <source>All of the data in this view</source>
        <translation>Alle Daten in dieser Ansicht</translation>
    </message>
    <message>
        <source>&amp;Patient&apos;s axes	R</source>
        <translation>Achsen des &amp;Patienten	R</translation>
    </message>
    <message>
        <source>A&amp;xes	R</source>
        <translation>Ac&amp;hsen	R</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal again, crosshair in the middle</source>
        <translation>Wieder axial, koronal und sagittal, Fadenkreuz in der Mitte</translation>
    </message>
    <message>
        <source>Along the axes again, crosshair in the middle</source>
        <translation>Wieder entlang der Achsen, Fadenkreuz in der Mitte</translation>
    </message>
    <message>
        <source>&amp;Grey window</source>
        <translation>&amp;Grauwertfenster</translation>
    </message>
    <message>
        <source>&amp;Whole range</source>
        <translation>G&amp;anzer Bereich</translation>
    </message>
    <message>
        <source>From the smallest value to the largest</source>
        <translation>Vom kleinsten bis zum größten Wert</translation>
    </message>
    <message>
        <source>&amp;Type it...	W</source>
        <translation>&amp;Eintippen...	W</translation>
    </message>
    <message>
        <source>Width and level as numbers, or a name</source>
        <translation>Breite und Mitte als Zahlen oder ein Name</translation>
    </message>
</context>
<context>
    <name>velum::gui::SeriesDialog</name>
    <message>
        <source>(no description)</source>
        <translation>(keine Beschreibung)</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>
with %n segmentation(s)</source>
        <translation>
            <numerusform>
mit %n Segmentierung</numerusform>
            <numerusform>
mit %n Segmentierungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>%1 holds several series. Which is to be opened?</source>
        <translation>%1 enthält mehrere Serien. Welche soll geöffnet werden?</translation>
    </message>
    <message>
        <source>%1 holds a series and segmentations of it.</source>
        <translation>%1 enthält eine Serie und Segmentierungen davon.</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>&amp;Segments</source>
        <translation>&amp;Segmente</translation>
    </message>
    <message>
        <source>Segments that are opened with it</source>
        <translation>Segmente, die mit geöffnet werden</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 zu %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::ShareBar</name>
    <message>
        <source>Blue: stays whole. Grey: removed whole. Red: cut.</source>
        <translation>Blau: bleibt ganz. Grau: ganz entfernt. Rot: geschnitten.</translation>
    </message>
    <message>
        <source>%1 % stays whole, %2 % is removed whole, %3 % is cut</source>
        <translation>%1 % bleiben ganz, %2 % werden ganz entfernt, %3 % geschnitten</translation>
    </message>
</context>
<context>
    <name>velum::gui::SheetGrips</name>
    <message>
        <source>&amp;Pull the sheet instead</source>
        <translation>Tuch stattdessen &amp;heranziehen</translation>
    </message>
    <message>
        <source>&amp;Push the sheet instead</source>
        <translation>Tuch stattdessen weg&amp;drücken</translation>
    </message>
    <message>
        <source>&amp;Remove pin	Del</source>
        <translation>&amp;Nadel entfernen	Entf</translation>
    </message>
    <message>
        <source>&amp;Remove force	Del</source>
        <translation>&amp;Kraft entfernen	Entf</translation>
    </message>
</context>
<context>
    <name>velum::gui::SheetHandsForm</name>
    <message>
        <source>Pin %1</source>
        <translation>Nadel %1</translation>
    </message>
    <message>
        <source>Push %1</source>
        <translation>Wegdrücken %1</translation>
    </message>
    <message>
        <source>Pull %1</source>
        <translation>Heranziehen %1</translation>
    </message>
    <message>
        <source>Pins and forces</source>
        <translation>Nadeln und Kräfte</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>Click the sheet in any view and hold it there, or drag it on. Shift: several. (P)</source>
        <translation>Das Tuch in einer Ansicht anklicken und dort halten oder weiterziehen. Umschalt: mehrere. (P)</translation>
    </message>
    <message>
        <source>Push sheet</source>
        <translation>Wegdrücken</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet goes around it (B)</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen oder ins Bild klicken: das Tuch geht um sie herum (B)</translation>
    </message>
    <message>
        <source>Pull sheet</source>
        <translation>Heranziehen</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet is drawn to its middle (Shift+B)</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen oder ins Bild klicken: das Tuch wird zu ihrer Mitte gezogen (Umschalt+B)</translation>
    </message>
    <message>
        <source>Select it in the views; Del removes it</source>
        <translation>In den Ansichten auswählen; Entf entfernt es</translation>
    </message>
    <message>
        <source>Height over the rest plane</source>
        <translation>Höhe über der Ruheebene</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>Strength, -1000 to 1000: above 0 it pushes the sheet away, below it pulls</source>
        <translation>Stärke, -1000 bis 1000: über 0 drückt sie das Tuch weg, darunter zieht sie es heran</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
</context>
<context>
    <name>velum::gui::ShowThisTool</name>
    <message>
        <source>Hidden: values around %1 %2</source>
        <translation>Ausgeblendet: Werte um %1 %2</translation>
    </message>
    <message>
        <source>Shown: values around %1 %2</source>
        <translation>Eingeblendet: Werte um %1 %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::SidePanel</name>
    <message>
        <source>Width of the side panel</source>
        <translation>Breite der Seitenleiste</translation>
    </message>
    <message>
        <source>Drag to make the panel wider or narrower (Left, Right). Double-click: as wide as suits what is open (Home)</source>
        <translation>Ziehen macht die Leiste breiter oder schmaler (Links, Rechts). Doppelklick: so breit, wie es zum Geöffneten passt (Pos1)</translation>
    </message>
</context>
<context>
    <name>velum::gui::SketchForm</name>
    <message>
        <source>Protect</source>
        <translation>Schützen</translation>
    </message>
    <message>
        <source>Stroke over what the sheet is to go around, on a section or in the picture;
[ and ] or Alt and the wheel change the radius, Esc ends</source>
        <translation>Über das streichen, worum das Tuch herumgehen soll, auf einem Schnittbild oder im Bild;
[ und ] oder Alt und Rad ändern den Radius, Esc beendet</translation>
    </message>
    <message>
        <source>Let through</source>
        <translation>Durchlassen</translation>
    </message>
    <message>
        <source>Stroke over what the sheet may cut: its values are taken out of the curve</source>
        <translation>Über das streichen, was das Tuch schneiden darf: seine Werte werden aus der Kurve genommen</translation>
    </message>
    <message>
        <source>Remove stroke</source>
        <translation>Strich entfernen</translation>
    </message>
    <message>
        <source>Remove the selected stroke (Del)</source>
        <translation>Ausgewählten Strich entfernen (Entf)</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Skizze</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Radius of the brush, and of the selected stroke ([ and ] in the views)</source>
        <translation>Radius des Pinsels und des ausgewählten Strichs ([ und ] in den Ansichten)</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>The strokes to which the curve is fitted; Del removes one</source>
        <translation>Die Striche, an die die Kurve angepasst ist; Entf entfernt einen</translation>
    </message>
    <message>
        <source>%1, radius %2</source>
        <translation>%1, Radius %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::SpareList</name>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Leave all that are listed whole</source>
        <translation>Alle aufgeführten ganz lassen</translation>
    </message>
    <message>
        <source>Cut all that are listed</source>
        <translation>Alle aufgeführten schneiden</translation>
    </message>
    <message>
        <source>Search structures</source>
        <translation>Strukturen suchen</translation>
    </message>
    <message>
        <source>Search structures to spare</source>
        <translation>Auszusparende Strukturen suchen</translation>
    </message>
    <message>
        <source>Lists the structures whose name holds these letters</source>
        <translation>Führt die Strukturen auf, deren Name diese Buchstaben enthält</translation>
    </message>
    <message>
        <source>Structures that the cut spares</source>
        <translation>Strukturen, die der Schnitt ausspart</translation>
    </message>
    <message>
        <source>Ticked structures are left whole by the selected cut</source>
        <translation>Angekreuzte Strukturen lässt der ausgewählte Schnitt ganz</translation>
    </message>
    <message>
        <source>Spares: nothing</source>
        <translation>Spart aus: nichts</translation>
    </message>
    <message>
        <source>Spares: %1</source>
        <translation>Spart aus: %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::SpareModel</name>
    <message>
        <source>structure %1</source>
        <translation>Struktur %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::StatusLine</name>
    <message>
        <source> in copy %1 of %2</source>
        <translation> in Kopie %1 von %2</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>, %1 von %2</translation>
    </message>
    <message>
        <source>Nothing is open</source>
        <translation>Nichts ist geöffnet</translation>
    </message>
    <message>
        <source>How far the picture is refined</source>
        <translation>Wie weit das Bild verfeinert ist</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Vollständig</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Gezeichnet von %1</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Verkleinert</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>streamed</source>
        <translation>gestreamt</translation>
    </message>
    <message>
        <source>level </source>
        <translation>Stufe </translation>
    </message>
    <message numerus="yes">
        <source>, %n brick(s) to come</source>
        <translation>
            <numerusform>, noch %n Block</numerusform>
            <numerusform>, noch %n Blöcke</numerusform>
        </translation>
    </message>
    <message>
        <source>Of what is seen, how much is shown at which level of detail, 0 the finest:</source>
        <translation>Wie viel des Sichtbaren in welcher Detailstufe gezeigt wird, 0 ist die feinste:</translation>
    </message>
    <message>
        <source>Bricks take %1 of %2 MiB of the graphics memory and %3 of %4 MiB of the machine&apos;s.</source>
        <translation>Blöcke nehmen %1 von %2 MiB des Grafikspeichers und %3 von %4 MiB des Rechners ein.</translation>
    </message>
    <message>
        <source>They have no room: all is shown %L1 times coarser than pixels. Edit &gt; Preferences &gt; Memory gives more.</source>
        <translation>Sie haben keinen Platz: alles wird %L1-mal gröber als Pixel gezeigt. Bearbeiten &gt; Einstellungen &gt; Speicher gibt mehr.</translation>
    </message>
    <message>
        <source>Under the pointer: value, position in patient coordinates (L, P, S), structure</source>
        <translation>Unter dem Zeiger: Wert, Position in Patientenkoordinaten (L, P, S), Struktur</translation>
    </message>
    <message>
        <source>Under the pointer: position along x, y and z, and what is there</source>
        <translation>Unter dem Zeiger: Position entlang x, y und z, und was dort ist</translation>
    </message>
    <message>
        <source>spacing unknown</source>
        <translation>Abstände unbekannt</translation>
    </message>
    <message>
        <source>%1    %2 to %3%4</source>
        <translation>%1    %2 bis %3%4</translation>
    </message>
    <message>
        <source>Voxels, spacing, sample type and range of values of %1</source>
        <translation>Voxel, Abstände, Typ der Werte und Wertebereich von %1</translation>
    </message>
    <message numerus="yes">
        <source>%n structure(s)</source>
        <translation>
            <numerusform>%n Struktur</numerusform>
            <numerusform>%n Strukturen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 instances of %2 types</source>
        <translation>%1 Instanzen von %2 Typen</translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s)</source>
        <translation>
            <numerusform>%n Oberfläche</numerusform>
            <numerusform>%n Oberflächen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>velum::gui::StepStrip</name>
    <message>
        <source>Step %1, done</source>
        <translation>Schritt %1, getan</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
</context>
<context>
    <name>velum::gui::StrengthCanvas</name>
    <message>
        <source>Add force point</source>
        <translation>Kraftpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove force point</source>
        <translation>Kraftpunkt entfernen</translation>
    </message>
    <message>
        <source>Move force point</source>
        <translation>Kraftpunkt verschieben</translation>
    </message>
    <message>
        <source>protects</source>
        <translation>schützt</translation>
    </message>
    <message>
        <source>draws the sheet</source>
        <translation>zieht das Tuch heran</translation>
    </message>
</context>
<context>
    <name>velum::gui::StrengthForm</name>
    <message>
        <source>Protect</source>
        <translation>Schützen</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Nach Wert</translation>
    </message>
    <message>
        <source>By gradient</source>
        <translation>Nach Gradient</translation>
    </message>
    <message>
        <source>Force by</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Which property of the data the curve is over; forces of both add up</source>
        <translation>Über welcher Eigenschaft der Daten die Kurve steht; Kräfte von beiden addieren sich</translation>
    </message>
    <message>
        <source>Force by value: above the line what the sheet protects</source>
        <translation>Kraft nach Wert: über der Linie, was das Tuch schützt</translation>
    </message>
    <message>
        <source>Force of each value, -1000 to 1000. Above the line: the sheet goes around it, and where it must cut it cuts what is weaker; below: the sheet is drawn to it, to what is stronger from farther away.
Click: add a point. Drag: move it. Right click or Del: remove it.
Keys: PgUp and PgDn go from one to the next, arrows move, Ins adds.</source>
        <translation>Kraft jedes Werts, -1000 bis 1000. Über der Linie: das Tuch geht darum herum, und wo es schneiden muss, schneidet es das Schwächere; darunter: das Tuch wird herangezogen, von Stärkerem aus größerer Ferne.
Klick: Punkt hinzufügen. Ziehen: ihn verschieben. Rechtsklick oder Entf: ihn entfernen.
Tasten: Bild auf und Bild ab gehen von einem zum nächsten, Pfeile verschieben, Einfg fügt hinzu.</translation>
    </message>
    <message>
        <source>Protect in %1</source>
        <translation>Schutz in %1</translation>
    </message>
    <message>
        <source>The channel that is chosen on the page Look: what the sheet goes by</source>
        <translation>Der Kanal, der auf der Seite Look gewählt ist: wonach sich das Tuch richtet</translation>
    </message>
</context>
<context>
    <name>velum::gui::StrengthTable</name>
    <message>
        <source>Force of the structure</source>
        <translation>Kraft der Struktur</translation>
    </message>
    <message>
        <source>structure %1</source>
        <translation>Struktur %1</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Forces of structures and types</source>
        <translation>Kräfte von Strukturen und Typen</translation>
    </message>
    <message>
        <source>Force of each structure, -1000 to 1000: above 0 the sheet goes around it, below it is drawn to it.
Double click a number to change it; Del removes a structure.</source>
        <translation>Kraft jeder Struktur, -1000 bis 1000: über 0 geht das Tuch um sie herum, darunter wird es zu ihr gezogen.
Doppelklick auf eine Zahl ändert sie; Entf entfernt eine Struktur.</translation>
    </message>
    <message>
        <source>Add a structure to protect</source>
        <translation>Zu schützende Struktur hinzufügen</translation>
    </message>
    <message>
        <source>Add a structure that the sheet goes around</source>
        <translation>Eine Struktur hinzufügen, um die das Tuch herumgeht</translation>
    </message>
    <message>
        <source>The selected structures have no force any more (Del)</source>
        <translation>Die ausgewählten Strukturen haben keine Kraft mehr (Entf)</translation>
    </message>
    <message>
        <source>Add a structure or a type</source>
        <translation>Struktur oder Typ hinzufügen</translation>
    </message>
    <message>
        <source>Add a structure</source>
        <translation>Struktur hinzufügen</translation>
    </message>
</context>
<context>
    <name>velum::gui::StripLine</name>
    <message>
        <source>What has no room here</source>
        <translation>Was hier keinen Platz hat</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
</context>
<context>
    <name>velum::gui::StructureCommands</name>
    <message>
        <source>cut %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>Protect by membrane</source>
        <translation>Durch Membran schützen</translation>
    </message>
    <message>
        <source>The selected membrane&apos;s sheet goes around it</source>
        <translation>Das Tuch der ausgewählten Membran geht darum herum</translation>
    </message>
    <message>
        <source>Draw membrane to it</source>
        <translation>Membran heranziehen</translation>
    </message>
    <message>
        <source>The selected membrane&apos;s sheet is drawn to it</source>
        <translation>Das Tuch der ausgewählten Membran wird dorthin gezogen</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Massiv</translation>
    </message>
    <message>
        <source>A closed surface of its colour, whatever the curve of opacity says</source>
        <translation>Eine geschlossene Oberfläche in ihrer Farbe, was auch immer die Kurve der Deckkraft sagt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>The values in it, by the curve of opacity, tinted with its colour</source>
        <translation>Die Werte darin, nach der Kurve der Deckkraft, mit ihrer Farbe getönt</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>It is not drawn</source>
        <translation>Sie wird nicht gezeichnet</translation>
    </message>
    <message>
        <source>Lit sphere</source>
        <translation>Lichtkugel</translation>
    </message>
    <message>
        <source>How the material looks in a finished picture</source>
        <translation>Wie das Material in einem ausgeführten Bild aussieht</translation>
    </message>
    <message>
        <source>As the finish</source>
        <translation>Wie die Ausführung</translation>
    </message>
    <message>
        <source>List in legend</source>
        <translation>In Legende aufnehmen</translation>
    </message>
    <message>
        <source>The legend names what is listed; where nothing is, the structures that are shown</source>
        <translation>Die Legende nennt, was aufgenommen ist; wenn nichts, die eingeblendeten Strukturen</translation>
    </message>
    <message>
        <source>Name this</source>
        <translation>Dies benennen</translation>
    </message>
    <message>
        <source>Its name beside it in the picture, with a leader; the page Marks lists it</source>
        <translation>Sein Name daneben im Bild, mit Hinweislinie; die Seite Marken führt ihn auf</translation>
    </message>
    <message>
        <source>Measure this</source>
        <translation>Dies messen</translation>
    </message>
    <message>
        <source>Its volume and its values, in the page Marks</source>
        <translation>Ihr Volumen und ihre Werte, auf der Seite Marken</translation>
    </message>
    <message>
        <source>Key in film</source>
        <translation>Schlüsselbild im Film</translation>
    </message>
    <message>
        <source>visibility</source>
        <translation>Sichtbarkeit</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n Struktur</numerusform>
            <numerusform>%n Strukturen</numerusform>
        </translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>Allein beenden</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Allein</translation>
    </message>
    <message>
        <source>Show again what was shown before</source>
        <translation>Wieder zeigen, was vorher zu sehen war</translation>
    </message>
    <message>
        <source>Show nothing but this</source>
        <translation>Nichts als dies zeigen</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Bring the camera near and the crosshair into its middle</source>
        <translation>Die Kamera heran und das Fadenkreuz in ihre Mitte bringen</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Umbenennen...</translation>
    </message>
    <message>
        <source>Spare</source>
        <translation>Aussparen</translation>
    </message>
    <message>
        <source>Spare in %1</source>
        <translation>Aussparen in %1</translation>
    </message>
    <message>
        <source>Add or select a cut first</source>
        <translation>Zuerst einen Schnitt hinzufügen oder auswählen</translation>
    </message>
    <message>
        <source>The selected cut spares it: it stands out of the cut</source>
        <translation>Der ausgewählte Schnitt spart sie aus: sie ragt aus dem Schnitt</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren...</translation>
    </message>
    <message>
        <source>Write it as a surface or as labels, for other programs</source>
        <translation>Als Oberfläche oder als Labels schreiben, für andere Programme</translation>
    </message>
</context>
<context>
    <name>velum::gui::StructureList</name>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Colour of the structure</source>
        <translation>Farbe der Struktur</translation>
    </message>
</context>
<context>
    <name>velum::gui::StructureModel</name>
    <message>
        <source>Values: mean %1%5, deviation %2%5, from %3%5 to %4%5, of %6 voxels of the scan</source>
        <translation>Werte: Mittel %1%5, Abweichung %2%5, von %3%5 bis %4%5, aus %6 Voxeln des Scans</translation>
    </message>
    <message>
        <source>Shown: click to hide, Alt+click to show it alone</source>
        <translation>Eingeblendet: klicken blendet aus, Alt+Klick zeigt es allein</translation>
    </message>
    <message>
        <source>Hidden: click to show, Alt+click to show it alone</source>
        <translation>Ausgeblendet: klicken blendet ein, Alt+Klick zeigt es allein</translation>
    </message>
    <message>
        <source>Click to choose another colour</source>
        <translation>Klicken, um eine andere Farbe zu wählen</translation>
    </message>
    <message>
        <source>Opacity %1 %: drag to change</source>
        <translation>Deckkraft %1 %: ziehen, um sie zu ändern</translation>
    </message>
    <message>
        <source>How much of it is seen, hidden and removed: it is not in the picture</source>
        <translation>Wie viel davon sichtbar, verdeckt und entfernt ist: sie ist nicht im Bild</translation>
    </message>
    <message>
        <source>Of where it would be in the picture, %1.
Drag the knob to pull it out of the cuts (Ctrl+Right, Ctrl+Left)</source>
        <translation>Von dem, wo sie im Bild wäre, %1.
Am Knopf ziehen, um sie aus den Schnitten zu ziehen (Strg+Rechts, Strg+Links)</translation>
    </message>
    <message>
        <source>Shown alone: click to show what was shown before</source>
        <translation>Allein gezeigt: klicken zeigt, was vorher zu sehen war</translation>
    </message>
    <message>
        <source>Show it alone</source>
        <translation>Allein zeigen</translation>
    </message>
    <message>
        <source>Number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>%1 voxels, %2, surface %3</source>
        <translation>%1 Voxel, %2, Oberfläche %3</translation>
    </message>
    <message>
        <source>No voxel has this number</source>
        <translation>Kein Voxel hat diese Nummer</translation>
    </message>
    <message>
        <source>Double click: go there. F2: rename</source>
        <translation>Doppelklick: dorthin gehen. F2: umbenennen</translation>
    </message>
    <message>
        <source>structure %1</source>
        <translation>Struktur %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>eingeblendet</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Eingeblendet</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>SUVmean</source>
        <translation>SUVmean</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>SUVmax</source>
        <translation>SUVmax</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Allein</translation>
    </message>
</context>
<context>
    <name>velum::gui::StructurePanel</name>
    <message>
        <source>No structures yet</source>
        <translation>Noch keine Strukturen</translation>
    </message>
    <message>
        <source>Open a label volume beside the scan: a segmentation in NIfTI, NRRD, MetaImage or DICOM SEG. Each structure can then be coloured, hidden, and left whole by a cut.</source>
        <translation>Ein Labelvolumen neben dem Scan öffnen: eine Segmentierung in NIfTI, NRRD, MetaImage oder DICOM SEG. Jede Struktur lässt sich dann färben, ausblenden und von einem Schnitt ganz lassen.</translation>
    </message>
    <message>
        <source>Open labels beside...</source>
        <translation>Labels dazu öffnen...</translation>
    </message>
    <message>
        <source>Choose a file of labels for what is open</source>
        <translation>Eine Datei mit Labels zum Geöffneten wählen</translation>
    </message>
    <message>
        <source>Labels shown</source>
        <translation>Labels eingeblendet</translation>
    </message>
    <message>
        <source>Whether the labels change anything at all</source>
        <translation>Ob die Labels überhaupt etwas ändern</translation>
    </message>
    <message>
        <source>Open others...</source>
        <translation>Andere...</translation>
    </message>
    <message>
        <source>Open labels beside what is open, in place of these</source>
        <translation>Labels zum Geöffneten öffnen, anstelle von diesen</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tönung</translation>
    </message>
    <message>
        <source>How far structures take their own colour rather than the volume&apos;s, %</source>
        <translation>Wie weit Strukturen ihre eigene Farbe statt der des Volumens annehmen, %</translation>
    </message>
    <message>
        <source>Unlabelled</source>
        <translation>Ohne Label</translation>
    </message>
    <message>
        <source>Opacity of all that belongs to no structure, %</source>
        <translation>Deckkraft von allem, was zu keiner Struktur gehört, %</translation>
    </message>
    <message>
        <source>On sections</source>
        <translation>Im Schnittbild</translation>
    </message>
    <message>
        <source>Opacity of the structures&apos; colours on the sections, %</source>
        <translation>Deckkraft der Farben der Strukturen auf den Schnittbildern, %</translation>
    </message>
    <message>
        <source>Search name or number</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Lists the structures whose name holds these words, or that have this number (Ctrl+F)</source>
        <translation>Führt die Strukturen auf, deren Name diese Wörter enthält, oder die diese Nummer haben (Strg+F)</translation>
    </message>
    <message>
        <source>Search structures</source>
        <translation>Strukturen suchen</translation>
    </message>
    <message>
        <source>The order of the list</source>
        <translation>Die Reihenfolge der Liste</translation>
    </message>
    <message>
        <source>By number</source>
        <translation>Nach Nummer</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Name</translation>
    </message>
    <message>
        <source>By size</source>
        <translation>Nach Größe</translation>
    </message>
    <message>
        <source>By mean value</source>
        <translation>Nach mittlerem Wert</translation>
    </message>
    <message>
        <source>By largest value</source>
        <translation>Nach größtem Wert</translation>
    </message>
    <message>
        <source>List those without voxels, too</source>
        <translation>Auch Strukturen ohne Voxel aufführen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>The mean and the largest of the scan&apos;s values in each structure: HU of a CT, SUV of a PET</source>
        <translation>Mittelwert und größter Wert des Scans in jeder Struktur: HU eines CT, SUV eines PET</translation>
    </message>
    <message>
        <source>Bars</source>
        <translation>Balken</translation>
    </message>
    <message>
        <source>How much of each structure is seen, hidden and removed in the picture; drag a bar to pull the structure out of the cuts</source>
        <translation>Wie viel jeder Struktur im Bild sichtbar, verdeckt und entfernt ist; an einem Balken ziehen zieht die Struktur aus den Schnitten</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle ein</translation>
    </message>
    <message>
        <source>Show all that are listed</source>
        <translation>Alle aufgeführten einblenden</translation>
    </message>
    <message>
        <source>Hide all</source>
        <translation>Alle aus</translation>
    </message>
    <message>
        <source>Hide all that are listed</source>
        <translation>Alle aufgeführten ausblenden</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Show what is hidden and hide what is shown, of all that are listed</source>
        <translation>Ausgeblendetes einblenden und Eingeblendetes ausblenden, von allen aufgeführten</translation>
    </message>
    <message>
        <source>Structures that are shown, of those that are listed</source>
        <translation>Eingeblendete Strukturen, von den aufgeführten</translation>
    </message>
    <message>
        <source>Colour of the structure</source>
        <translation>Farbe der Struktur</translation>
    </message>
    <message>
        <source>Opacity of the selected structures, %</source>
        <translation>Deckkraft der ausgewählten Strukturen, %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Select a structure</source>
        <translation>Eine Struktur auswählen</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n Struktur</numerusform>
            <numerusform>%n Strukturen</numerusform>
        </translation>
    </message>
    <message>
        <source>How far the shape of the selected structures is smoothed, %1; 0 leaves it as the file has it</source>
        <translation>Wie weit die Form der ausgewählten Strukturen geglättet wird, %1; 0 lässt sie, wie die Datei sie hat</translation>
    </message>
    <message>
        <source>What was grown follows the values of the scan; shapes of a file can be smoothed</source>
        <translation>Gewachsenes folgt den Werten des Scans; Formen einer Datei lassen sich glätten</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
</context>
<context>
    <name>velum::gui::StructureRoom</name>
    <message>
        <source>Labelled structures: name, colour, opacity, what is shown</source>
        <translation>Strukturen mit Labels: Name, Farbe, Deckkraft, was eingeblendet ist</translation>
    </message>
    <message>
        <source>&amp;Open labels beside...</source>
        <translation>Labels &amp;dazu öffnen...</translation>
    </message>
    <message>
        <source>Choose a file of labels for what is open</source>
        <translation>Eine Datei mit Labels zum Geöffneten wählen</translation>
    </message>
    <message>
        <source>&amp;List</source>
        <translation>&amp;Liste</translation>
    </message>
    <message>
        <source>Show the list of structures</source>
        <translation>Die Liste der Strukturen zeigen</translation>
    </message>
    <message>
        <source>&amp;Find...</source>
        <translation>&amp;Suchen...</translation>
    </message>
    <message>
        <source>Search a structure by name or number</source>
        <translation>Eine Struktur nach Suchen</translation>
    </message>
    <message>
        <source>&amp;Hide or show</source>
        <translation>&amp;Aus- oder einblenden</translation>
    </message>
    <message>
        <source>Hide the selected structure, or show it</source>
        <translation>Die ausgewählte Struktur aus- oder einblenden</translation>
    </message>
    <message>
        <source>&amp;Solo</source>
        <translation>Allei&amp;n</translation>
    </message>
    <message>
        <source>Show the selected structure alone, or what was shown before</source>
        <translation>Die ausgewählte Struktur allein zeigen oder was vorher zu sehen war</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>All&amp;e einblenden</translation>
    </message>
    <message>
        <source>Show every structure</source>
        <translation>Jede Struktur einblenden</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Hingehen</translation>
    </message>
    <message>
        <source>Bring the camera near and the crosshair into the selected structure</source>
        <translation>Die Kamera heran und das Fadenkreuz in die ausgewählte Struktur bringen</translation>
    </message>
    <message>
        <source>S&amp;pare</source>
        <translation>Auss&amp;paren</translation>
    </message>
    <message>
        <source>The selected cut spares the selected structure, or cuts it again</source>
        <translation>Der ausgewählte Schnitt spart die ausgewählte Struktur aus oder schneidet sie wieder</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>E&amp;xportieren...</translation>
    </message>
    <message>
        <source>Write the selected structures as surfaces or as labels, for other programs</source>
        <translation>Die ausgewählten Strukturen als Oberflächen oder Labels schreiben, für andere Programme</translation>
    </message>
</context>
<context>
    <name>velum::gui::ThreePointTool</name>
    <message>
        <source>Click the first of three points. Esc gives up.</source>
        <translation>Den ersten von drei Punkten anklicken. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click the second point. Esc gives up.</source>
        <translation>Den zweiten Punkt anklicken. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click the third point. Esc gives up.</source>
        <translation>Den dritten Punkt anklicken. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Nothing is there: click on what is drawn. %1</source>
        <translation>Dort ist nichts: auf Gezeichnetes klicken. %1</translation>
    </message>
    <message>
        <source>The three lie on one line: click a third beside it. Esc gives up.</source>
        <translation>Die drei liegen auf einer Linie: einen dritten daneben anklicken. Esc bricht ab.</translation>
    </message>
</context>
<context>
    <name>velum::gui::TimeBar</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the time steps round and round (Space)</source>
        <translation>Die Zeitschritte immer wieder abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::TimeCommands</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Play the film, or the time steps of a series</source>
        <translation>Den Film oder die Zeitschritte einer Serie abspielen</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>The next time step, or the next key of a film</source>
        <translation>Der nächste Zeitschritt oder das nächste Schlüsselbild eines Films</translation>
    </message>
    <message>
        <source>&amp;Step before</source>
        <translation>&amp;Voriger Schritt</translation>
    </message>
    <message>
        <source>The time step before, or the key before of a film</source>
        <translation>Der vorige Zeitschritt oder das vorige Schlüsselbild eines Films</translation>
    </message>
</context>
<context>
    <name>velum::gui::TimelineRoom</name>
    <message>
        <source>&amp;Timeline</source>
        <translation>&amp;Zeitachse</translation>
    </message>
    <message>
        <source>Show the film, with its tracks and keys</source>
        <translation>Den Film zeigen, mit seinen Spuren und Schlüsselbildern</translation>
    </message>
    <message>
        <source>To the &amp;beginning</source>
        <translation>Zum An&amp;fang</translation>
    </message>
    <message>
        <source>Go to where the film begins</source>
        <translation>Dorthin gehen, wo der Film beginnt</translation>
    </message>
    <message>
        <source>Key be&amp;fore</source>
        <translation>Vori&amp;ges Schlüsselbild</translation>
    </message>
    <message>
        <source>Go to the key before</source>
        <translation>Zum vorigen Schlüsselbild gehen</translation>
    </message>
    <message>
        <source>Next &amp;key</source>
        <translation>Näc&amp;hstes Schlüsselbild</translation>
    </message>
    <message>
        <source>Go to the next key</source>
        <translation>Zum nächsten Schlüsselbild gehen</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>A&amp;ufzeichnen</translation>
    </message>
    <message>
        <source>Make keys of whatever is changed at the playhead</source>
        <translation>Schlüsselbilder von allem machen, was an der Abspielmarke geändert wird</translation>
    </message>
    <message>
        <source>Key &amp;camera</source>
        <translation>Schlüsselbild der &amp;Kamera</translation>
    </message>
    <message>
        <source>Make a key of where the eye is, at the playhead</source>
        <translation>Ein Schlüsselbild von dem Ort des Auges machen, an der Abspielmarke</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>Endl&amp;os</translation>
    </message>
    <message>
        <source>Play the film again and again</source>
        <translation>Den Film immer wieder abspielen</translation>
    </message>
    <message>
        <source>Sn&amp;ap</source>
        <translation>&amp;Einrasten</translation>
    </message>
    <message>
        <source>Keys and playhead go to frames, and to each other</source>
        <translation>Schlüsselbilder und Abspielmarke rasten auf Einzelbildern und aneinander ein</translation>
    </message>
    <message>
        <source>Recorded at %L1 s: %2</source>
        <translation>Aufgezeichnet bei %L1 s: %2</translation>
    </message>
</context>
<context>
    <name>velum::gui::TimelineStrip</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Where the playhead is, in seconds</source>
        <translation>Wo die Abspielmarke ist, in Sekunden</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Einzelbild</translation>
    </message>
    <message>
        <source>Which frame is at the playhead, the first one is 0</source>
        <translation>Welches Einzelbild an der Abspielmarke ist, das erste ist 0</translation>
    </message>
    <message>
        <source># </source>
        <translation># </translation>
    </message>
    <message>
        <source>Show more time</source>
        <translation>Mehr Zeit zeigen</translation>
    </message>
    <message>
        <source>Show more time (Ctrl and the wheel)</source>
        <translation>Mehr Zeit zeigen (Strg und Rad)</translation>
    </message>
    <message>
        <source>Show less time</source>
        <translation>Weniger Zeit zeigen</translation>
    </message>
    <message>
        <source>Show less time, larger (Ctrl and the wheel)</source>
        <translation>Weniger Zeit zeigen, größer (Strg und Rad)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole film</source>
        <translation>Den ganzen Film zeigen</translation>
    </message>
    <message>
        <source>Save film...</source>
        <translation>Film speichern...</translation>
    </message>
    <message>
        <source>Save film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Write the film as a video or as pictures</source>
        <translation>Den Film als Video oder als Bilder schreiben</translation>
    </message>
    <message>
        <source>Add film</source>
        <translation>Film hinzufügen</translation>
    </message>
    <message>
        <source>Add a film that is ready-made, to be changed then</source>
        <translation>Einen fertigen Film hinzufügen, der dann geändert werden kann</translation>
    </message>
    <message>
        <source>Length of the film</source>
        <translation>Länge des Films</translation>
    </message>
    <message>
        <source>How long the film is, in seconds</source>
        <translation>Wie lang der Film ist, in Sekunden</translation>
    </message>
    <message>
        <source>Change length of film</source>
        <translation>Länge des Films ändern</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Einzelbilder je Sekunde</translation>
    </message>
    <message>
        <source>How many pictures a second has</source>
        <translation>Wie viele Bilder eine Sekunde hat</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>Change frames per second</source>
        <translation>Einzelbilder je Sekunde ändern</translation>
    </message>
</context>
<context>
    <name>velum::gui::ToolStrip</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
</context>
<context>
    <name>velum::gui::TrackCanvas</name>
    <message>
        <source>Tracks of the film</source>
        <translation>Spuren des Films</translation>
    </message>
    <message>
        <source>Drag keys, double-click a row for a key, drag the ruler to move the playhead</source>
        <translation>Schlüsselbilder ziehen, Doppelklick auf eine Zeile für ein Schlüsselbild, am Lineal ziehen bewegt die Abspielmarke</translation>
    </message>
    <message>
        <source>Drag to move the playhead; Ctrl and the wheel show more or less time</source>
        <translation>Ziehen bewegt die Abspielmarke; Strg und Rad zeigen mehr oder weniger Zeit</translation>
    </message>
    <message>
        <source>Part of the film that is played and saved: drag its ends</source>
        <translation>Teil des Films, der abgespielt und gespeichert wird: an den Enden ziehen</translation>
    </message>
    <message>
        <source>The track counts: click to switch it off</source>
        <translation>Die Spur zählt: klicken, um sie auszuschalten</translation>
    </message>
    <message>
        <source>The track is off: click to switch it on</source>
        <translation>Die Spur ist aus: klicken, um sie einzuschalten</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Schlüsselbild verschieben</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Schlüsselbilder verschieben</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Schlüsselbild entfernen</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Schlüsselbilder entfernen</translation>
    </message>
    <message>
        <source>Change range of film</source>
        <translation>Bereich des Films ändern</translation>
    </message>
    <message>
        <source>Ease keys</source>
        <translation>Übergang der Schlüsselbilder</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste at the playhead</source>
        <translation>An der Abspielmarke einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Key at the playhead</source>
        <translation>Schlüsselbild an der Abspielmarke</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Remove track</source>
        <translation>Spur entfernen</translation>
    </message>
    <message>
        <source>Enable track</source>
        <translation>Spur einschalten</translation>
    </message>
    <message>
        <source>Disable track</source>
        <translation>Spur ausschalten</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Schlüsselbilder einfügen</translation>
    </message>
    <message>
        <source>Nothing changes yet. Record while you change things, choose Key this in the menu of a control, or add a film that is ready-made.</source>
        <translation>Noch ändert sich nichts. Beim Ändern aufzeichnen, im Menü eines Bedienelements Schlüsselbild hiervon wählen oder einen fertigen Film hinzufügen.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
</context>
<context>
    <name>velum::gui::TransferCanvas</name>
    <message>
        <source>Remove colour</source>
        <translation>Farbe entfernen</translation>
    </message>
    <message>
        <source>Move colour</source>
        <translation>Farbe verschieben</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>Add colour</source>
        <translation>Farbe hinzufügen</translation>
    </message>
    <message>
        <source>Shift transfer function</source>
        <translation>Transferfunktion verschieben</translation>
    </message>
    <message>
        <source>Stretch transfer function</source>
        <translation>Transferfunktion dehnen</translation>
    </message>
    <message>
        <source>Scale opacity</source>
        <translation>Deckkraft skalieren</translation>
    </message>
</context>
<context>
    <name>velum::gui::TransferEditor</name>
    <message>
        <source>Opacity by gradient</source>
        <translation>Deckkraft nach Gradient</translation>
    </message>
    <message>
        <source>Opacity and colour by value</source>
        <translation>Deckkraft und Farbe nach Wert</translation>
    </message>
    <message>
        <source>Click the line: add a point. Drag a point: move it. Drag between points: move all, or scale all opacities.
Shift+drag: move all. Alt+drag: stretch. Right or double click a point, or Del: remove it.
In the colours: click adds, double click changes, right click removes. Wheel: zoom. Double click the axis: whole range.
Keys: PgUp and PgDn go from one to the next, Ins adds, arrows move, Enter changes a colour, + and - zoom.</source>
        <translation>Auf die Linie klicken: Punkt hinzufügen. Einen Punkt ziehen: ihn verschieben. Zwischen Punkten ziehen: alle verschieben oder alle Deckkräfte skalieren.
Umschalt+Ziehen: alle verschieben. Alt+Ziehen: dehnen. Rechts- oder Doppelklick auf einen Punkt, oder Entf: ihn entfernen.
In den Farben: Klick fügt hinzu, Doppelklick ändert, Rechtsklick entfernt. Rad: Zoom. Doppelklick auf die Achse: ganzer Bereich.
Tasten: Bild auf und Bild ab gehen von einem zum nächsten, Einfg fügt hinzu, Pfeile verschieben, Eingabe ändert eine Farbe, + und - zoomen.</translation>
    </message>
    <message>
        <source>Factor on the opacity by how steeply the value changes, per length: low on the left keeps even material back and shows borders</source>
        <translation>Faktor auf die Deckkraft, je nachdem, wie steil sich der Wert ändert, je Länge: links niedrig hält gleichmäßiges Material zurück und zeigt Grenzen</translation>
    </message>
    <message>
        <source>Make opacity depend on how steeply the value changes, too</source>
        <translation>Die Deckkraft auch davon abhängen lassen, wie steil sich der Wert ändert</translation>
    </message>
    <message>
        <source>Colour and opacity</source>
        <translation>Farbe und Deckkraft</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the values that occur</source>
        <translation>Die Werte zeigen, die vorkommen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Heights of the histogram by their logarithm, so that rare values are seen</source>
        <translation>Höhen des Histogramms nach ihrem Logarithmus, damit seltene Werte zu sehen sind</translation>
    </message>
    <message>
        <source>Click the line to add a point, drag to move it</source>
        <translation>Klick auf die Linie: neuer Punkt; Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Value of the selected point or colour</source>
        <translation>Wert des ausgewählten Punktes oder der Farbe</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the selected point, %</source>
        <translation>Deckkraft des ausgewählten Punktes, %</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected point or colour (Del)</source>
        <translation>Ausgewählten Punkt oder Farbe entfernen (Entf)</translation>
    </message>
</context>
<context>
    <name>velum::gui::TypeSpareList</name>
    <message>
        <source>Leaves of types</source>
        <translation>Übrig gelassene Typen</translation>
    </message>
    <message>
        <source>Search types</source>
        <translation>Typen suchen</translation>
    </message>
    <message>
        <source>Search types that the cut leaves</source>
        <translation>Typen suchen, die der Schnitt übrig lässt</translation>
    </message>
    <message>
        <source>Lists the types and compartments whose name holds these words</source>
        <translation>Führt die Typen und Kompartimente auf, deren Name diese Wörter enthält</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Lässt übrig</translation>
    </message>
    <message>
        <source>Share of the instances in what is removed that stay, % of the selected rows</source>
        <translation>Anteil der Instanzen im Entfernten, der bleibt, % der ausgewählten Zeilen</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>Way from the cut&apos;s surface over which more stay; below 0: outside of it fewer do</source>
        <translation>Weg von der Schnittfläche, über den mehr bleiben; unter 0: außerhalb davon weniger</translation>
    </message>
    <message>
        <source>Change falloff</source>
        <translation>Abfall ändern</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Ausmaß</translation>
    </message>
    <message>
        <source>How far the falloff goes at the surface, %</source>
        <translation>Wie weit der Abfall an der Schnittfläche geht, %</translation>
    </message>
    <message>
        <source>Change amount of falloff</source>
        <translation>Ausmaß des Abfalls ändern</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>How the falloff runs: 1 evenly; above, it lasts longer</source>
        <translation>Wie der Abfall verläuft: 1 gleichmäßig; darüber hält er länger an</translation>
    </message>
    <message>
        <source>Change exponent of falloff</source>
        <translation>Exponent des Abfalls ändern</translation>
    </message>
    <message>
        <source>Removes whole instances only</source>
        <translation>Entfernt nur ganze Instanzen</translation>
    </message>
    <message>
        <source>Instances go when all of them is in what is removed; else when their middle is</source>
        <translation>Instanzen verschwinden, wenn sie ganz im Entfernten liegen; sonst, wenn ihre Mitte darin liegt</translation>
    </message>
    <message>
        <source>Remove whole instances</source>
        <translation>Ganze Instanzen entfernen</translation>
    </message>
    <message>
        <source>Remove instances by their middle</source>
        <translation>Instanzen nach ihrer Mitte entfernen</translation>
    </message>
    <message>
        <source>Mass, kDa</source>
        <translation>Masse, kDa</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Instanzen</translation>
    </message>
    <message>
        <source>number of instances</source>
        <translation>Anzahl der Instanzen</translation>
    </message>
    <message>
        <source>to </source>
        <translation>bis </translation>
    </message>
    <message>
        <source>from </source>
        <translation>von </translation>
    </message>
    <message>
        <source>to any</source>
        <translation>bis beliebig</translation>
    </message>
    <message>
        <source>Types of a greater %1 are not left; 0: none is too great</source>
        <translation>Typen mit größerem Wert werden nicht übrig gelassen (%1); 0: keiner ist zu groß</translation>
    </message>
    <message>
        <source>Types of a smaller %1 are not left</source>
        <translation>Typen mit kleinerem Wert werden nicht übrig gelassen (%1)</translation>
    </message>
    <message>
        <source>As what it is in</source>
        <translation>Wie das, worin es ist</translation>
    </message>
    <message>
        <source>Select a row to say how</source>
        <translation>Eine Zeile auswählen, um es zu sagen</translation>
    </message>
</context>
<context>
    <name>velum::gui::TypeSpareTree</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1, %2 % are left</source>
        <translation>%1, %2 % bleiben übrig</translation>
    </message>
    <message>
        <source>Share of its instances that the cut leaves: drag to change</source>
        <translation>Anteil seiner Instanzen, den der Schnitt übrig lässt: ziehen, um ihn zu ändern</translation>
    </message>
</context>
<context>
    <name>velum::gui::TypeSpareView</name>
    <message>
        <source>What the cut leaves of types</source>
        <translation>Was der Schnitt von Typen übrig lässt</translation>
    </message>
    <message>
        <source>How much of each type stays in what the cut removes</source>
        <translation>Wie viel von jedem Typ in dem bleibt, was der Schnitt entfernt</translation>
    </message>
</context>
<context>
    <name>velum::gui::TypeTree</name>
    <message>
        <source>All types</source>
        <translation>Alle Typen</translation>
    </message>
</context>
<context>
    <name>velum::gui::ViewCommands</name>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>Parallelpro&amp;jektion</translation>
    </message>
    <message>
        <source>Parallel (orthographic) instead of perspective</source>
        <translation>Parallel (orthografisch) statt perspektivisch</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>See all of it from the front</source>
        <translation>Alles von vorne sehen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>A bar that says how long things are, over the picture, also in files</source>
        <translation>Ein Balken, der sagt, wie lang die Dinge sind, über dem Bild, auch in Dateien</translation>
    </message>
    <message>
        <source>Time stamp</source>
        <translation>Zeitangabe</translation>
    </message>
    <message>
        <source>The time of the time step, over the picture, also in files</source>
        <translation>Die Zeit des Zeitschritts, über dem Bild, auch in Dateien</translation>
    </message>
    <message>
        <source>Add caption</source>
        <translation>Bildtext hinzufügen</translation>
    </message>
    <message>
        <source>Write words over the picture, also in files</source>
        <translation>Wörter über das Bild schreiben, auch in Dateien</translation>
    </message>
    <message>
        <source>Grey &amp;window</source>
        <translation>&amp;Grauwertfenster</translation>
    </message>
    <message>
        <source>Look from: %1</source>
        <translation>Blick von: %1</translation>
    </message>
    <message>
        <source>Axial, coronal, sagittal and 3D</source>
        <translation>Axial, koronal, sagittal und 3D</translation>
    </message>
    <message>
        <source>Three sections and 3D</source>
        <translation>Drei Schnittbilder und 3D</translation>
    </message>
    <message>
        <source>Sections along the patient&apos;s a&amp;xes</source>
        <translation>Schnittbilder entlang der A&amp;chsen des Patienten</translation>
    </message>
    <message>
        <source>Sections along the a&amp;xes</source>
        <translation>Schnittbilder entlang der A&amp;chsen</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal again, crosshair in the middle</source>
        <translation>Wieder axial, koronal und sagittal, Fadenkreuz in der Mitte</translation>
    </message>
    <message>
        <source>XY, XZ and YZ again, crosshair in the middle</source>
        <translation>Wieder XY, XZ und YZ, Fadenkreuz in der Mitte</translation>
    </message>
    <message>
        <source>&amp;Next section</source>
        <translation>&amp;Nächstes Schnittbild</translation>
    </message>
    <message>
        <source>Show the plane nearer to you</source>
        <translation>Die nähere Ebene zeigen</translation>
    </message>
    <message>
        <source>Pre&amp;vious section</source>
        <translation>&amp;Voriges Schnittbild</translation>
    </message>
    <message>
        <source>Show the plane further away</source>
        <translation>Die entferntere Ebene zeigen</translation>
    </message>
    <message>
        <source>Grey window of sections: %1</source>
        <translation>Grauwertfenster der Schnittbilder: %1</translation>
    </message>
    <message>
        <source>&amp;Type it...</source>
        <translation>&amp;Eintippen...</translation>
    </message>
    <message>
        <source>Type width and level of the grey window, or its name, in the section</source>
        <translation>Breite und Mitte des Grauwertfensters oder seinen Namen im Schnittbild eintippen</translation>
    </message>
    <message>
        <source>Orien&amp;tation cube</source>
        <translation>Orientierungs&amp;würfel</translation>
    </message>
    <message>
        <source>A cube in the corner of the 3D view: click a side to look from there</source>
        <translation>Ein Würfel in der Ecke der 3D-Ansicht: auf eine Seite klicken, um von dort zu schauen</translation>
    </message>
</context>
<context>
    <name>velum::gui::ViewCube</name>
    <message>
        <source>From where one looks</source>
        <translation>Von wo geschaut wird</translation>
    </message>
    <message>
        <source>Look from: %1. Drag to turn</source>
        <translation>Blick von: %1. Ziehen dreht</translation>
    </message>
</context>
<context>
    <name>velum::gui::Viewport</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>Wird verfeinert</translation>
    </message>
    <message>
        <source>Levels of detail</source>
        <translation>Detailstufen</translation>
    </message>
    <message>
        <source>The driver has no memory for a picture of this size: make the window smaller, or close other programs that draw</source>
        <translation>Der Treiber hat keinen Speicher für ein Bild dieser Größe: das Fenster verkleinern oder andere Programme schließen, die zeichnen</translation>
    </message>
</context>
<context>
    <name>velum::gui::VolumeCommands</name>
    <message>
        <source>&amp;Voxel size...</source>
        <translation>Voxel&amp;größe...</translation>
    </message>
    <message>
        <source>Say how large the voxels are, where the file does not or is wrong</source>
        <translation>Sagen, wie groß die Voxel sind, wenn die Datei es nicht oder falsch sagt</translation>
    </message>
    <message>
        <source>How large is a voxel?</source>
        <translation>Wie groß ist ein Voxel?</translation>
    </message>
    <message>
        <source>&amp;Samples of the file...</source>
        <translation>Werte der Date&amp;i...</translation>
    </message>
    <message>
        <source>Say what the samples of a file without a header are</source>
        <translation>Sagen, was die Werte einer Datei ohne Dateikopf sind</translation>
    </message>
    <message>
        <source>Level of de&amp;tail...</source>
        <translation>&amp;Detailstufe...</translation>
    </message>
    <message>
        <source>Choose which level of a pyramid is read, or that it is streamed</source>
        <translation>Wählen, welche Stufe einer Pyramide gelesen wird, oder dass sie gestreamt wird</translation>
    </message>
    <message>
        <source>Hi&amp;de the table</source>
        <translation>&amp;Tisch ausblenden</translation>
    </message>
    <message>
        <source>Leave out what is not part of the largest body: table, head rest, cables</source>
        <translation>Weglassen, was nicht zum größten Körper gehört: Tisch, Kopfstütze, Kabel</translation>
    </message>
    <message>
        <source>Set voxel size</source>
        <translation>Voxelgröße setzen</translation>
    </message>
    <message>
        <source>Change samples of the file</source>
        <translation>Werte der Datei ändern</translation>
    </message>
    <message>
        <source>Streamed, as fine as the screen shows it</source>
        <translation>Gestreamt, so fein, wie der Bildschirm es zeigt</translation>
    </message>
    <message>
        <source>Level %1, read whole: %2</source>
        <translation>Stufe %1, ganz gelesen: %2</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Detailstufe</translation>
    </message>
    <message>
        <source>Which level of %1 is to be read?</source>
        <translation>Welche Stufe von %1 soll gelesen werden?</translation>
    </message>
    <message>
        <source>Choose level of detail</source>
        <translation>Detailstufe wählen</translation>
    </message>
    <message>
        <source>%1 does not say how large its voxels are. Lengths and proportions are right once you say it.</source>
        <translation>%1 sagt nicht, wie groß die Voxel sind. Längen und Verhältnisse stimmen erst, wenn es angegeben ist.</translation>
    </message>
</context>
<context>
    <name>velum::gui::VoxelSizeDialog</name>
    <message>
        <source>Voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <source>&amp;Set size</source>
        <translation>&amp;Größe setzen</translation>
    </message>
</context>
<context>
    <name>velum::gui::VoxelSizeForm</name>
    <message>
        <source>Unit of the voxel size</source>
        <translation>Einheit der Voxelgröße</translation>
    </message>
    <message>
        <source>The unit of the three numbers</source>
        <translation>Die Einheit der drei Zahlen</translation>
    </message>
    <message>
        <source>The same in &amp;all directions</source>
        <translation>In &amp;allen Richtungen gleich</translation>
    </message>
    <message>
        <source>Voxels are cubes</source>
        <translation>Voxel sind Würfel</translation>
    </message>
    <message>
        <source>Voxel size along %1</source>
        <translation>Voxelgröße entlang %1</translation>
    </message>
    <message>
        <source>Edge of a voxel along %1; other units may be typed, as “0.3 um”</source>
        <translation>Kante eines Voxels entlang %1; andere Einheiten lassen sich eintippen, etwa „0,3 um“</translation>
    </message>
    <message>
        <source>Usual voxel sizes</source>
        <translation>Übliche Voxelgrößen</translation>
    </message>
    <message>
        <source>Usual sizes...</source>
        <translation>Übliche Größen...</translation>
    </message>
    <message>
        <source>What usual scanners and microscopes give, and what was answered last</source>
        <translation>Was übliche Scanner und Mikroskope liefern, und was zuletzt geantwortet wurde</translation>
    </message>
    <message>
        <source>The last answer, %1 × %2 × %3 %4</source>
        <translation>Die letzte Antwort, %1 × %2 × %3 %4</translation>
    </message>
</context>
</TS>
