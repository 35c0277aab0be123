<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
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
    <name>SectionView</name>
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
        <translation>Breite und Mitte als Zahlen, oder ein Name</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Add caption</source>
        <translation>Bildtext hinzufügen</translation>
    </message>
    <message>
        <source>Add cut</source>
        <translation>Schnitt hinzufügen</translation>
    </message>
    <message>
        <source>Add membrane</source>
        <translation>Membran hinzufügen</translation>
    </message>
    <message>
        <source>Add pin</source>
        <translation>Nadel hinzufügen</translation>
    </message>
    <message>
        <source>Align cut</source>
        <translation>Schnitt ausrichten</translation>
    </message>
    <message>
        <source>Bring model to size</source>
        <translation>Größe des Modells anpassen</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Change channel&apos;s colour</source>
        <translation>Farbe des Kanals ändern</translation>
    </message>
    <message>
        <source>Change rendering</source>
        <translation>Darstellung ändern</translation>
    </message>
    <message>
        <source>Change tint</source>
        <translation>Tönung ändern</translation>
    </message>
    <message>
        <source>Change window</source>
        <translation>Grauwertfenster ändern</translation>
    </message>
    <message>
        <source>Choose channel</source>
        <translation>Kanal wählen</translation>
    </message>
    <message>
        <source>Choose finish</source>
        <translation>Ausführung wählen</translation>
    </message>
    <message>
        <source>Choose lit sphere</source>
        <translation>Lichtkugel wählen</translation>
    </message>
    <message>
        <source>Choose look</source>
        <translation>Aussehen wählen</translation>
    </message>
    <message>
        <source>Choose paper</source>
        <translation>Papier wählen</translation>
    </message>
    <message>
        <source>Choose preset</source>
        <translation>Vorgabe wählen</translation>
    </message>
    <message>
        <source>Clear film</source>
        <translation>Film löschen</translation>
    </message>
    <message>
        <source>Cut along the view</source>
        <translation>Quer zur Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>Cut to pull out of</source>
        <translation>Schnitt zum Herausziehen</translation>
    </message>
    <message>
        <source>Draw barrier</source>
        <translation>Barriere ziehen</translation>
    </message>
    <message>
        <source>Duplicate cut</source>
        <translation>Schnitt duplizieren</translation>
    </message>
    <message>
        <source>Fade what has no label</source>
        <translation>Ausblenden, was kein Label hat</translation>
    </message>
    <message>
        <source>Flip cut</source>
        <translation>Schnitt wenden</translation>
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
        <source>Import look</source>
        <translation>Aussehen importieren</translation>
    </message>
    <message>
        <source>Invert what is shown</source>
        <translation>Eingeblendetes umkehren</translation>
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
        <source>Make the look a surface</source>
        <translation>Aussehen zur Oberfläche machen</translation>
    </message>
    <message>
        <source>Meet numbers to be seen</source>
        <translation>Sichtbare Anzahlen erreichen</translation>
    </message>
    <message>
        <source>Move cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Move cut in the list</source>
        <translation>Schnitt in der Liste verschieben</translation>
    </message>
    <message>
        <source>Move force</source>
        <translation>Kraft verschieben</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Schlüsselbild verschieben</translation>
    </message>
    <message>
        <source>Move key of camera</source>
        <translation>Schlüsselbild der Kamera verschieben</translation>
    </message>
    <message>
        <source>Move pin</source>
        <translation>Nadel verschieben</translation>
    </message>
    <message>
        <source>Move point of mark</source>
        <translation>Punkt der Marke verschieben</translation>
    </message>
    <message>
        <source>Move to keep</source>
        <translation>Dorthin, wo es erhalten bleibt</translation>
    </message>
    <message>
        <source>Move view</source>
        <translation>Ansicht ändern</translation>
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
        <source>Protect values</source>
        <translation>Werte schützen</translation>
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
        <source>Put all back</source>
        <translation>Alle zurücklegen</translation>
    </message>
    <message>
        <source>Remove caption</source>
        <translation>Bildtext entfernen</translation>
    </message>
    <message>
        <source>Remove cut</source>
        <translation>Schnitt entfernen</translation>
    </message>
    <message>
        <source>Remove track</source>
        <translation>Spur entfernen</translation>
    </message>
    <message>
        <source>Rename cut</source>
        <translation>Schnitt umbenennen</translation>
    </message>
    <message>
        <source>Resize force</source>
        <translation>Größe der Kraft ändern</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Zweite Ebene</translation>
    </message>
    <message>
        <source>Show channel alone</source>
        <translation>Kanal allein zeigen</translation>
    </message>
    <message>
        <source>Show cut</source>
        <translation>Geschnitten zeigen</translation>
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
        <translation>eine Membran geht um den Schädel</translation>
    </message>
    <message>
        <source>A trunk</source>
        <translation>Ein Rumpf</translation>
    </message>
    <message>
        <source>organs pulled out of a cut</source>
        <translation>Organe, aus einem Schnitt gezogen</translation>
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
        <translation>Abstand, in dem Strukturen ausgeblendet sind; 0: die Reichweite.</translation>
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
        <translation>Wählt, wie Kernels drücken, mit dem dazugehörigen Tuch.</translation>
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
        <translation>Zeigt einen der gemischten Kanäle allein, oder wieder alle.</translation>
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
        <source>Resize cut</source>
        <translation>Größe des Schnitts ändern</translation>
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
        <source>Turn cut</source>
        <translation>Schnitt drehen</translation>
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
        <translation>Kanal ein- oder ausblenden; Alt+Klick: ihn allein zeigen, oder wieder alle</translation>
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
        <translation>Auswahl kopieren, oder alle Zeilen</translation>
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
        <translation>Schnittbild (Grauwerte)</translation>
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
        <translation>Eine andere Form, oder eine anders gelegte Ebene</translation>
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
        <translation>1 Schneiden</translation>
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
        <translation>2 Abgleichen</translation>
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
        <translation>3 Freiräumen</translation>
    </message>
    <message>
        <source>Keep the selected types in view: what stands before them goes</source>
        <translation>Ausgewählte Typen im Blick behalten: was davor steht, verschwindet</translation>
    </message>
    <message>
        <source>Select what the picture is about and press Clear: then nothing stands before it. Or go on without.</source>
        <translation>Auswählen, worum es im Bild geht, und Freiräumen drücken: dann steht nichts davor. Oder ohne dies fortfahren.</translation>
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
        <translation>Ordner mit DICOM-Bildern oder einen Speicher in Zarr oder N5 öffnen</translation>
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
        <translation>Der Szene fehlt: %1: %2</translation>
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
        <translation>Noch beschäftigt: warten, oder zuerst abbrechen, was läuft.</translation>
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
        <translation>Wörter des Namens, oder Tasten, wie sie geschrieben werden</translation>
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
        <translation>Wo die Namen stehen: in Spalten links und rechts, oder rund um das Sichtbare</translation>
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
        <translation>Entfernen	Del</translation>
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
        <translation>Folgen, was dort ist</translation>
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
        <translation>Eine Marke wird zu allen Zeitschritten einer Serie gezeigt, oder nur zu einem gezeichnet</translation>
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
        <translation>Hier verdeckt: Das Bild zeigt nichts von dem, worauf sie weist</translation>
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
        <translation>Was das Schnittbild schnitte und das Tuch umgehen kann: ganz erhalten, ganz entfernen, oder auf der Seite lassen, auf der mehr davon liegt</translation>
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
        <translation>Halbe Breite eines Kernels, in Kernels</translation>
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
        <translation>%1 Kernels, %2 × %3 Partikel</translation>
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
        <translation>Das Tuch der Membran anklicken und dort halten, oder weiterziehen</translation>
    </message>
    <message>
        <source>P&amp;ush sheet</source>
        <translation>Tuch wegdr&amp;ücken</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet goes around it</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen, oder ins Bild klicken: das Tuch geht um sie herum</translation>
    </message>
    <message>
        <source>Pu&amp;ll sheet</source>
        <translation>Tuch her&amp;anziehen</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet is drawn to its middle</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen, oder ins Bild klicken: das Tuch wird zu ihrer Mitte gezogen</translation>
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
        <translation>Farben und Namen von Typen über dem Bild, auch in Dateien: die am meisten zu sehenden, oder die aufgenommenen</translation>
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
        <translation>Farben und Namen von Typen über dem Bild, auch in Dateien: die am meisten zu sehenden, oder die aufgenommenen</translation>
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
        <translation>, %1 Perlen</translation>
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
        <translation>aus dem Volumen seiner Perlen</translation>
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
        <translation>Ein Achtel dessen des Rechners (%1 MiB)</translation>
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
        <translation>Ein Viertel dessen der Karte, höchstens 2048 MiB</translation>
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
        <translation>Die Detailstufe, mit der sich Volumen öffnen. Eine hier gewählte Stufe wird ganz gelesen, oder die nächste, die in den halben Speicher passt. Gilt für das, was als Nächstes geöffnet wird</translation>
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
        <translation>1 Schneiden</translation>
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
        <translation>2 Herausziehen</translation>
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
        <translation>3 Ausführen</translation>
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
        <translation>Eine Pyramide daneben ließe es sofort öffnen, kann aber nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>A pyramid beside it, %1, lets it open at once and be streamed. It takes up to %2 of the disk, of which %3 are free, and about %4 on a machine that has little else to do; you can go on working meanwhile. The file itself stays as it is.</source>
        <translation>Eine Pyramide daneben, %1, öffnet es sofort und lässt es streamen. Sie braucht bis zu %2 auf dem Datenträger, wovon %3 frei sind, und etwa %4 auf einem Rechner, der sonst wenig zu tun hat; weiterarbeiten ist währenddessen möglich. Die Datei selbst bleibt, wie sie ist.</translation>
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
        <translation>, Vorspann von %1 Bytes</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>%1 has no header that says what its samples are. The picture shows how they would be read.</source>
        <translation>%1 hat keinen Vorspann, der sagt, was die Werte sind. Das Bild zeigt, wie sie gelesen würden.</translation>
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
        <translation>Vor&amp;spann</translation>
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
        <translation>Ein Video, oder ein Bild für jedes Einzelbild</translation>
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
        <translation>Der ganze Film, oder der Teil, der abgespielt wird</translation>
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
        <translation>Einzelbilder je Sekunde</translation>
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
        <translation>In jedem EXR-Einzelbild, oder als Bilder neben jedem PNG-Einzelbild</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation>Bewegungsunschärfe</translation>
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
Die dieses Films werden behalten, die eines anderen Films ersetzt. Fortfahren?</translation>
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
        <translation>Pixel, oder eine Größe auf Papier mit der Auflösung darunter</translation>
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
        <translation>Verhältnis behalten</translation>
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
        <translation>&amp;Nadel entfernen	Del</translation>
    </message>
    <message>
        <source>&amp;Remove force	Del</source>
        <translation>&amp;Kraft entfernen	Del</translation>
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
        <translation>Das Tuch in einer Ansicht anklicken und dort halten, oder weiterziehen. Umschalt: mehrere. (P)</translation>
    </message>
    <message>
        <source>Push sheet</source>
        <translation>Wegdrücken</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet goes around it (B)</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen, oder ins Bild klicken: das Tuch geht um sie herum (B)</translation>
    </message>
    <message>
        <source>Pull sheet</source>
        <translation>Heranziehen</translation>
    </message>
    <message>
        <source>Drag a ball in a section, or click in the picture: the sheet is drawn to its middle (Shift+B)</source>
        <translation>Eine Kugel in einem Schnittbild aufziehen, oder ins Bild klicken: das Tuch wird zu ihrer Mitte gezogen (Umschalt+B)</translation>
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
        <translation>Wie viel davon sichtbar, verdeckt und entfernt ist: es ist nicht im Bild</translation>
    </message>
    <message>
        <source>Of where it would be in the picture, %1.
Drag the knob to pull it out of the cuts (Ctrl+Right, Ctrl+Left)</source>
        <translation>Von dem, wo es im Bild wäre, %1.
Am Knopf ziehen, um es aus den Schnitten zu ziehen (Strg+Rechts, Strg+Links)</translation>
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
        <translation>Name oder Nummer suchen</translation>
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
        <translation>Eine Struktur nach Name oder Nummer suchen</translation>
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
        <translation>Die ausgewählte Struktur allein zeigen, oder was vorher zu sehen war</translation>
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
        <translation>Der ausgewählte Schnitt spart die ausgewählte Struktur aus, oder schneidet sie wieder</translation>
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
        <translation>Den Film abspielen, oder die Zeitschritte einer Serie</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>The next time step, or the next key of a film</source>
        <translation>Der nächste Zeitschritt, oder das nächste Schlüsselbild eines Films</translation>
    </message>
    <message>
        <source>&amp;Step before</source>
        <translation>&amp;Voriger Schritt</translation>
    </message>
    <message>
        <source>The time step before, or the key before of a film</source>
        <translation>Der vorige Zeitschritt, oder das vorige Schlüsselbild eines Films</translation>
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
        <translation>Auf die Linie klicken: Punkt hinzufügen. Einen Punkt ziehen: ihn verschieben. Zwischen Punkten ziehen: alle verschieben, oder alle Deckkräfte skalieren.
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
        <translation>Klick auf die Linie: neuer Punkt; ziehen</translation>
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
        <translation>Breite und Mitte des Grauwertfensters, oder seinen Namen, im Schnittbild eintippen</translation>
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
        <translation>Sagen, was die Werte einer Datei ohne Vorspann sind</translation>
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
