<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>LabColumn</name>
    <message>
        <source>PSR</source>
        <translation>PSR</translation>
    </message>
    <message>
        <source>MCSD</source>
        <translation>MCSD</translation>
    </message>
    <message>
        <source>simplified PSR</source>
        <translation>PSR vereinfacht</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>größter</translation>
    </message>
    <message>
        <source>Paper error</source>
        <translation>Fehler wie publiziert</translation>
    </message>
    <message>
        <source>Surface to voxels</source>
        <translation>Oberfläche zu Voxeln</translation>
    </message>
    <message>
        <source>Voxels to surface</source>
        <translation>Voxel zu Oberfläche</translation>
    </message>
    <message>
        <source>Curvature K</source>
        <translation>Krümmung K</translation>
    </message>
    <message>
        <source>Volume deviation</source>
        <translation>Volumenabweichung</translation>
    </message>
    <message>
        <source>other methods</source>
        <translation>andere Verfahren</translation>
    </message>
</context>
<context>
    <name>RecentCase</name>
    <message>
        <source>Not saved under a name: %1, last changed %2</source>
        <translation>Nicht unter einem Namen gespeichert: %1, zuletzt geändert %2</translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>%1 was not read within %2 seconds; check the file, or copy it to a faster disk.</source>
        <translation>%1 wurde nicht innerhalb von %2 Sekunden gelesen; prüfen Sie die Datei oder kopieren Sie sie auf eine schnellere Platte.</translation>
    </message>
    <message>
        <source>No temporary folder can be made in %1; free some space there.</source>
        <translation>In %1 lässt sich kein Zwischenordner anlegen; schaffen Sie dort Platz.</translation>
    </message>
    <message>
        <source>%1 cannot be read because the program part glisson-import is missing; install Glisson again.</source>
        <translation>%1 lässt sich nicht lesen, weil der Programmteil glisson-import fehlt; installieren Sie Glisson neu.</translation>
    </message>
    <message>
        <source>%1 cannot be read because the system has no free file handles; close other programs.</source>
        <translation>%1 lässt sich nicht lesen, weil das System keine weiteren Dateien öffnen kann; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1 cannot be read because no file can be made in %2; free some space there.</source>
        <translation>%1 lässt sich nicht lesen, weil sich in %2 keine Datei anlegen lässt; schaffen Sie dort Platz.</translation>
    </message>
    <message>
        <source>%1 cannot be read because %2; free some space there.</source>
        <translation>%1 lässt sich nicht lesen: %2; schaffen Sie dort Platz.</translation>
    </message>
    <message>
        <source>%1 cannot be read because %2 does not start; install Glisson again.</source>
        <translation>%1 lässt sich nicht lesen, weil %2 nicht startet; installieren Sie Glisson neu.</translation>
    </message>
    <message>
        <source>%1 cannot be read because its decoder failed on it, as a damaged file makes it do; export it again.</source>
        <translation>%1 lässt sich nicht lesen, weil der Dekoder daran gescheitert ist, wie es bei beschädigten Dateien vorkommt; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 cannot be read because %2; export it again.</source>
        <translation>%1 lässt sich nicht lesen: %2; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 cannot be read because glisson-import gave another answer than asked; install Glisson again.</source>
        <translation>%1 lässt sich nicht lesen, weil glisson-import anders als gefragt geantwortet hat; installieren Sie Glisson neu.</translation>
    </message>
    <message>
        <source>%1 cannot be read: the request is unknown; install Glisson again.</source>
        <translation>%1 lässt sich nicht lesen: Die Anfrage ist unbekannt; installieren Sie Glisson neu.</translation>
    </message>
    <message>
        <source>%1 needs more memory than is allowed for reading; crop or resample it first.</source>
        <translation>%1 braucht mehr Speicher, als zum Lesen erlaubt ist; schneiden Sie das Bild zu oder verkleinern Sie es zuerst.</translation>
    </message>
    <message>
        <source>%1 cannot be read (%2); check that you may read it.</source>
        <translation>%1 lässt sich nicht lesen (%2); prüfen Sie, ob Sie die Datei lesen dürfen.</translation>
    </message>
    <message>
        <source>%1 cannot be read; export it again.</source>
        <translation>%1 lässt sich nicht lesen; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>the hand-over file cannot be written</source>
        <translation>die Übergabedatei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the hand-over file cannot be written: the temporary folder is full</source>
        <translation>die Übergabedatei lässt sich nicht schreiben, der Zwischenordner ist voll</translation>
    </message>
    <message>
        <source>the hand-over file is missing</source>
        <translation>die Übergabedatei fehlt</translation>
    </message>
    <message>
        <source>the hand-over file promises more than it holds</source>
        <translation>die Übergabedatei verspricht mehr, als sie enthält</translation>
    </message>
    <message>
        <source>the hand-over file&apos;s array has another size than its grid</source>
        <translation>das Feld der Übergabedatei hat eine andere Größe als ihr Gitter</translation>
    </message>
    <message>
        <source>the hand-over file holds an unknown choice</source>
        <translation>die Übergabedatei enthält eine unbekannte Auswahl</translation>
    </message>
    <message>
        <source>the hand-over file holds more than its message</source>
        <translation>die Übergabedatei enthält mehr als ihre Nachricht</translation>
    </message>
    <message>
        <source>the hand-over file ends early</source>
        <translation>die Übergabedatei endet zu früh</translation>
    </message>
    <message>
        <source>the hand-over file&apos;s grid is impossibly large</source>
        <translation>das Gitter der Übergabedatei ist unmöglich groß</translation>
    </message>
    <message>
        <source>the hand-over file leaves out a mask</source>
        <translation>der Übergabedatei fehlt eine Maske</translation>
    </message>
    <message>
        <source>the hand-over file&apos;s mask leaves its grid</source>
        <translation>eine Maske der Übergabedatei ragt aus ihrem Gitter</translation>
    </message>
    <message>
        <source>not an answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>%1 does not exist; check the path.</source>
        <translation>%1 existiert nicht; prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>There is no label table named %1; the tables are totalsegmentator, totalsegmentator-v1 and totalsegmentator-mr.</source>
        <translation>Es gibt keine Labeltabelle namens %1; die Tabellen sind totalsegmentator, totalsegmentator-v1 und totalsegmentator-mr.</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check that it is a file and that you may read it.</source>
        <translation>%1 lässt sich nicht öffnen; prüfen Sie, ob es eine Datei ist und Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>%1 cannot be read to its end; check the disk or the network.</source>
        <translation>%1 lässt sich nicht bis zum Ende lesen; prüfen Sie Platte oder Netz.</translation>
    </message>
    <message>
        <source>%1 is cut off: its compressed data end early; copy or export it again.</source>
        <translation>%1 ist abgeschnitten: Die komprimierten Daten enden zu früh; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 is damaged: its compressed data or their checksum are wrong; copy or export it again.</source>
        <translation>%1 ist beschädigt: Die komprimierten Daten oder ihre Prüfsumme stimmen nicht; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds more behind the end of its compressed data; copy or export it again.</source>
        <translation>%1 enthält mehr hinter dem Ende der komprimierten Daten; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 %2; copy or export the series again.</source>
        <translation>%1 %2; kopieren oder exportieren Sie die Serie erneut.</translation>
    </message>
    <message>
        <source>holds colours or inverted grey (%1) instead of plain grey values</source>
        <translation>enthält Farben oder umgekehrtes Grau (%1) statt einfacher Grauwerte</translation>
    </message>
    <message>
        <source>%1 holds %2 frames in one file, which is not read; export the series as one file per slice.</source>
        <translation>%1 enthält %2 Bilder in einer Datei, was nicht gelesen wird; exportieren Sie die Serie mit einer Datei je Schicht.</translation>
    </message>
    <message>
        <source>has an impossible number of bits per pixel in its header</source>
        <translation>hat eine unmögliche Zahl von Bits je Pixel im Kopf</translation>
    </message>
    <message>
        <source>is cut off: it holds no compressed frame</source>
        <translation>ist abgeschnitten: Das komprimierte Bild fehlt</translation>
    </message>
    <message>
        <source>is cut off within its compressed frame</source>
        <translation>ist mitten im komprimierten Bild abgeschnitten</translation>
    </message>
    <message>
        <source>is cut off: its compressed frame has no end</source>
        <translation>ist abgeschnitten: Das komprimierte Bild hat kein Ende</translation>
    </message>
    <message>
        <source>is cut off: it holds no pixels</source>
        <translation>ist abgeschnitten: Es enthält keine Pixel</translation>
    </message>
    <message>
        <source>holds %1 bytes of pixels instead of %2</source>
        <translation>enthält %1 Byte Pixel statt %2</translation>
    </message>
    <message>
        <source>stores big-endian pixels in a way that is not read</source>
        <translation>speichert Pixel in der Bytefolge Big Endian auf eine Weise, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>is cut off within its pixels</source>
        <translation>ist mitten in den Pixeln abgeschnitten</translation>
    </message>
    <message>
        <source>holds pixels of an unknown kind</source>
        <translation>enthält Pixel unbekannter Art</translation>
    </message>
    <message>
        <source>is damaged, or compressed in a way that is not read</source>
        <translation>ist beschädigt oder auf eine Weise komprimiert, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>holds no Hounsfield units: with its rescale slope of %1 and intercept of %2 its values leave -32768..32767</source>
        <translation>enthält keine Hounsfield-Einheiten: Mit der Steigung %1 und dem Achsenabschnitt %2 verlassen die Werte -32768..32767</translation>
    </message>
    <message>
        <source>has pixels that are not finite after rescaling</source>
        <translation>hat Pixel, die nach dem Umrechnen nicht endlich sind</translation>
    </message>
    <message>
        <source>%1 holds an image with many grey values, not a mask; open its folder as a CT.</source>
        <translation>%1 enthält ein Bild mit vielen Grauwerten, keine Maske; öffnen Sie den Ordner als CT.</translation>
    </message>
    <message>
        <source>%1 holds mask series such as %2 and no CT; open it as a segmentation.</source>
        <translation>%1 enthält Maskenserien wie %2 und keine CT; öffnen Sie den Ordner als Segmentierung.</translation>
    </message>
    <message>
        <source>%1 mixes slices of different patients (the %2 of %3 and %4 differ); give the folder of one series.</source>
        <translation>%1 mischt Schichten verschiedener Patienten (%2 von %3 und %4 verschieden); wählen Sie den Ordner einer Serie.</translation>
    </message>
    <message>
        <source>%1 mixes slices of different frames of reference (the %2 of %3 and %4 differ); give the folder of one series.</source>
        <translation>%1 mischt Schichten verschiedener Bezugssysteme (%2 von %3 und %4 verschieden); wählen Sie den Ordner einer Serie.</translation>
    </message>
    <message>
        <source>%1 is a series of modality %2, not CT; choose the CT series.</source>
        <translation>%1 ist eine Serie der Modalität %2, keine CT; wählen Sie die CT-Serie.</translation>
    </message>
    <message>
        <source>%1 holds masks on different grids: %2 has %3 and the others have %4; give masks of one CT.</source>
        <translation>%1 enthält Masken auf verschiedenen Gittern: %2 hat %3 und die anderen haben %4; wählen Sie Masken einer CT.</translation>
    </message>
    <message>
        <source>%1 holds masks of different patients (the %2 of %3 differs); check the folder, or read it all the same.</source>
        <translation>%1 enthält Masken verschiedener Patienten (%2 von %3 weicht ab); prüfen Sie den Ordner oder lesen Sie ihn trotzdem.</translation>
    </message>
    <message>
        <source>%1 holds masks of different frames of reference (the %2 of %3 differs); check the folder, or read it all the same.</source>
        <translation>%1 enthält Masken verschiedener Bezugssysteme (%2 von %3 weicht ab); prüfen Sie den Ordner oder lesen Sie ihn trotzdem.</translation>
    </message>
    <message>
        <source>does not say how it lies in the patient (no %1)</source>
        <translation>sagt nicht, wie es im Patienten liegt (Angabe fehlt: %1)</translation>
    </message>
    <message>
        <source>has a broken %1: it is not made of finite numbers</source>
        <translation>hat eine beschädigte Angabe (%1): Sie besteht nicht aus endlichen Zahlen</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>Pixelabstand</translation>
    </message>
    <message>
        <source>has image axes that are not perpendicular unit vectors</source>
        <translation>hat Bildachsen, die keine senkrechten Einheitsvektoren sind</translation>
    </message>
    <message>
        <source>has a pixel spacing that is not above zero</source>
        <translation>hat einen Pixelabstand, der nicht über null liegt</translation>
    </message>
    <message>
        <source>has a broken position: it lies more than 100 m from the scanner</source>
        <translation>hat eine beschädigte Position: Sie liegt mehr als 100 m vom Scanner entfernt</translation>
    </message>
    <message>
        <source>has a rescale slope or intercept that is not a usable number</source>
        <translation>hat eine Steigung oder einen Achsenabschnitt zum Umrechnen, der keine brauchbare Zahl ist</translation>
    </message>
    <message>
        <source>is cut off before its header</source>
        <translation>ist vor dem Kopf abgeschnitten</translation>
    </message>
    <message>
        <source>is named like the slices beside it but is no DICOM any more</source>
        <translation>heißt wie die Schichten daneben, ist aber kein DICOM mehr</translation>
    </message>
    <message>
        <source>is damaged or cut off</source>
        <translation>ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>has no rows or columns</source>
        <translation>hat keine Zeilen oder Spalten</translation>
    </message>
    <message>
        <source>%1 file(s) hold no DICOM image and were left out, such as %2.</source>
        <translation>%1 Datei(en) enthalten kein DICOM-Bild und wurden ausgelassen, etwa %2.</translation>
    </message>
    <message>
        <source>%1 is of no known format; give a DICOM folder, .nii, .nii.gz, .nrrd, .seg.nrrd, .mha or .mhd.</source>
        <translation>%1 hat kein bekanntes Format; wählen Sie einen DICOM-Ordner, .nii, .nii.gz, .nrrd, .seg.nrrd, .mha oder .mhd.</translation>
    </message>
    <message>
        <source>%1 is of no known format; give a DICOM folder, .nii, .nii.gz, .nrrd, .seg.nrrd, .mha or .mhd file.</source>
        <translation>%1 hat kein bekanntes Format; wählen Sie einen DICOM-Ordner oder eine Datei .nii, .nii.gz, .nrrd, .seg.nrrd, .mha oder .mhd.</translation>
    </message>
    <message>
        <source>%1 has an impossible grid of %2x%3x%4 voxels; export it again.</source>
        <translation>%1 hat ein unmögliches Gitter von %2x%3x%4 Voxeln; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 promises %2 GiB of voxels, more than the %3 GiB that are allowed; crop or resample it first.</source>
        <translation>%1 verspricht %2 GiB Voxel, mehr als die erlaubten %3 GiB; schneiden Sie das Bild zu oder verkleinern Sie es zuerst.</translation>
    </message>
    <message>
        <source>%1 has a position or direction in its header that is not a finite number; export it again.</source>
        <translation>%1 hat eine Position oder Richtung im Kopf, die keine endliche Zahl ist; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has a voxel size of zero in its header; export it again.</source>
        <translation>%1 hat eine Voxelgröße von null im Kopf; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has axes that are not at right angles (%2 mm at the corners); resample it to a straight grid first.</source>
        <translation>%1 hat Achsen, die nicht rechtwinklig sind (%2 mm an den Ecken); rechnen Sie das Bild zuerst auf ein gerades Gitter um.</translation>
    </message>
    <message>
        <source>The axes were set at right angles (%1 mm at the corners).</source>
        <translation>Die Achsen wurden rechtwinklig gestellt (%1 mm an den Ecken).</translation>
    </message>
    <message>
        <source>%1 is cut off: it holds %2 of the %3 bytes of voxels its header promises; copy or export it again.</source>
        <translation>%1 ist abgeschnitten: Enthalten sind %2 der %3 Byte Voxel, die der Kopf verspricht; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>%1 holds voxels that are not finite numbers; export it again.</source>
        <translation>%1 enthält Voxel, die keine endlichen Zahlen sind; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds more than the %2 bytes of voxels its header promises; copy or export it again.</source>
        <translation>%1 enthält mehr als die %2 Byte Voxel, die der Kopf verspricht; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has a header that ITK reads otherwise: %2; export it again.</source>
        <translation>%1 hat einen Kopf, den ITK anders liest: %2; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 voxels instead of %2</source>
        <translation>%1 Voxel statt %2</translation>
    </message>
    <message>
        <source>%1 values per voxel instead of %2</source>
        <translation>%1 Werte je Voxel statt %2</translation>
    </message>
    <message>
        <source>voxels of another type</source>
        <translation>Voxel eines anderen Typs</translation>
    </message>
    <message>
        <source>a corner lies %1 mm from ours</source>
        <translation>eine Ecke liegt %1 mm von unserer</translation>
    </message>
    <message>
        <source>a corner lies far from ours</source>
        <translation>eine Ecke liegt weit von unserer</translation>
    </message>
    <message>
        <source>%1 has a header that ITK reads otherwise: %2, as a voxel size (pixdim) unlike the sform makes it do; choose sform or qform.</source>
        <translation>%1 hat einen Kopf, den ITK anders liest: %2, wie es eine Voxelgröße (pixdim) bewirkt, die der sform widerspricht; wählen Sie sform oder qform.</translation>
    </message>
    <message>
        <source>%1 holds other voxels than ITK finds in it; export it again.</source>
        <translation>%1 enthält andere Voxel, als ITK darin findet; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 names its data file &quot;%2&quot;, which is not a plain name beside it; save header and data as one file.</source>
        <translation>%1 nennt als Datendatei „%2“, was kein einfacher Name daneben ist; speichern Sie Kopf und Daten in einer Datei.</translation>
    </message>
    <message>
        <source>%1 names its data file &quot;%2&quot;, which is not beside it; copy both files.</source>
        <translation>%1 nennt als Datendatei „%2“, die nicht daneben liegt; kopieren Sie beide Dateien.</translation>
    </message>
    <message>
        <source>%1 holds neither mask series nor organ files; choose the folder that holds the masks.</source>
        <translation>%1 enthält weder Maskenserien noch Organdateien; wählen Sie den Ordner mit den Masken.</translation>
    </message>
    <message>
        <source>%1 is a single DICOM file, which is not read as a segmentation; give a folder of mask series, or save the segmentation as .seg.nrrd or .nii.gz.</source>
        <translation>%1 ist eine einzelne DICOM-Datei, die nicht als Segmentierung gelesen wird; wählen Sie einen Ordner mit Maskenserien oder speichern Sie die Segmentierung als .seg.nrrd oder .nii.gz.</translation>
    </message>
    <message>
        <source>%1 cannot be decoded by ITK; export it again.</source>
        <translation>%1 lässt sich von ITK nicht dekodieren; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has a JPEG 2000 frame that is damaged or cut off; copy or export the series again.</source>
        <translation>%1 hat ein JPEG-2000-Bild, das beschädigt oder abgeschnitten ist; kopieren oder exportieren Sie die Serie erneut.</translation>
    </message>
    <message>
        <source>%1 holds values that are not whole numbers, so it is an image and not a label map; open it as a CT.</source>
        <translation>%1 enthält Werte, die keine ganzen Zahlen sind, ist also ein Bild und kein Labelbild; öffnen Sie die Datei als CT.</translation>
    </message>
    <message>
        <source>%1 holds values such as %2, so it is an image and not a label map; open it as a CT.</source>
        <translation>%1 enthält Werte wie %2, ist also ein Bild und kein Labelbild; öffnen Sie die Datei als CT.</translation>
    </message>
    <message>
        <source>%1 holds more than %2 values, so it is an image and not a label map; open it as a CT.</source>
        <translation>%1 enthält mehr als %2 Werte, ist also ein Bild und kein Labelbild; öffnen Sie die Datei als CT.</translation>
    </message>
    <message>
        <source>%1 holds no label %2 that could be given a kind; its structures go by name: %3.</source>
        <translation>%1 enthält kein Label %2, das eine Art bekommen könnte; die Strukturen darin haben Namen: %3.</translation>
    </message>
    <message>
        <source>%1 holds no label %2 that could be given a kind; its labels are %3.</source>
        <translation>%1 enthält kein Label %2, das eine Art bekommen könnte; die Labels darin sind %3.</translation>
    </message>
    <message>
        <source>%1 holds no structure named &quot;%2&quot; that could be given a kind; it holds %3.</source>
        <translation>%1 enthält keine Struktur namens „%2“, die eine Art bekommen könnte; enthalten sind %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty: no voxel is set.</source>
        <translation>„%1“ ist leer: Kein Voxel ist gesetzt.</translation>
    </message>
    <message>
        <source>%1 holds no label: no voxel is set; choose the file with the segmentation.</source>
        <translation>%1 enthält kein Label: Kein Voxel ist gesetzt; wählen Sie die Datei mit der Segmentierung.</translation>
    </message>
    <message>
        <source>%1 holds several layers; a folder of masks holds one organ per file, so open this file by itself.</source>
        <translation>%1 enthält mehrere Ebenen; ein Maskenordner enthält ein Organ je Datei, öffnen Sie diese Datei also für sich.</translation>
    </message>
    <message>
        <source>%1 holds %2 labels; a folder of masks holds one organ per file, so open this file by itself.</source>
        <translation>%1 enthält %2 Labels; ein Maskenordner enthält ein Organ je Datei, öffnen Sie diese Datei also für sich.</translation>
    </message>
    <message>
        <source>%1 has a line without &quot;=&quot; in its MetaImage header; export it again.</source>
        <translation>%1 hat eine Zeile ohne „=“ im MetaImage-Kopf; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has a header field with a name of more than 255 bytes; it is damaged, so export it again.</source>
        <translation>%1 hat ein Kopffeld mit einem Namen von mehr als 255 Byte und ist beschädigt; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds voxels of the MetaImage type &quot;%2&quot;, which is not read; save it as integers or floats.</source>
        <translation>%1 enthält Voxel des MetaImage-Typs „%2“, der nicht gelesen wird; speichern Sie ganze Zahlen oder Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>%1 has an unknown number of dimensions; save the one volume with three that is meant.</source>
        <translation>%1 hat eine unbekannte Zahl von Dimensionen; speichern Sie das eine gemeinte Volumen mit dreien.</translation>
    </message>
    <message>
        <source>%1 has %2 dimensions; save the one volume with three that is meant.</source>
        <translation>%1 hat %2 Dimensionen; speichern Sie das eine gemeinte Volumen mit dreien.</translation>
    </message>
    <message>
        <source>%1 has several values per voxel; save one value per voxel.</source>
        <translation>%1 hat mehrere Werte je Voxel; speichern Sie einen Wert je Voxel.</translation>
    </message>
    <message>
        <source>%1 has a size that is not a whole number in its MetaImage header; export it again.</source>
        <translation>%1 hat eine Größe im MetaImage-Kopf, die keine ganze Zahl ist; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 says nowhere how it lies in the patient (Offset, TransformMatrix, ElementSpacing); export it again with its orientation.</source>
        <translation>%1 sagt nirgends, wie es im Patienten liegt (Offset, TransformMatrix, ElementSpacing); exportieren Sie die Daten erneut mit ihrer Orientierung.</translation>
    </message>
    <message>
        <source>%1 has a voxel size that is not above zero in its MetaImage header; export it again.</source>
        <translation>%1 hat eine Voxelgröße im MetaImage-Kopf, die nicht über null liegt; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has an axis in its TransformMatrix that is not a unit vector; resample it to a straight grid first.</source>
        <translation>%1 hat eine Achse in der TransformMatrix, die kein Einheitsvektor ist; rechnen Sie das Bild zuerst auf ein gerades Gitter um.</translation>
    </message>
    <message>
        <source>%1 is a MetaIO file of type &quot;%2&quot;, not an image; give the image.</source>
        <translation>%1 ist eine MetaIO-Datei vom Typ „%2“, kein Bild; wählen Sie das Bild.</translation>
    </message>
    <message>
        <source>%1 stores its voxels as text or behind a foreign header, which is not read; save it as one .mha file.</source>
        <translation>%1 speichert die Voxel als Text oder hinter einem fremden Kopf, was nicht gelesen wird; speichern Sie eine Datei .mha.</translation>
    </message>
    <message>
        <source>%1 spreads its slices over several files, which is not read; save it as one .mha file.</source>
        <translation>%1 verteilt die Schichten auf mehrere Dateien, was nicht gelesen wird; speichern Sie eine Datei .mha.</translation>
    </message>
    <message>
        <source>%1 is cut off within its NIfTI header; copy or export it again.</source>
        <translation>%1 ist mitten im NIfTI-Kopf abgeschnitten; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 is NIfTI-2, which is not read; save it as NIfTI-1.</source>
        <translation>%1 ist NIfTI-2, was nicht gelesen wird; speichern Sie NIfTI-1.</translation>
    </message>
    <message>
        <source>%1 is one half of a .hdr/.img pair; save it as one .nii file.</source>
        <translation>%1 ist die Hälfte eines Paares .hdr/.img; speichern Sie eine Datei .nii.</translation>
    </message>
    <message>
        <source>%1 is not a NIfTI file although its name says so; export it again.</source>
        <translation>%1 ist keine NIfTI-Datei, obwohl der Name das sagt; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds voxels of NIfTI type %2, which are not single numbers; save it as integers or floats.</source>
        <translation>%1 enthält Voxel des NIfTI-Typs %2, die keine einzelnen Zahlen sind; speichern Sie ganze Zahlen oder Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>%1 contradicts itself about the bits per voxel in its header; export it again.</source>
        <translation>%1 widerspricht sich im Kopf über die Bits je Voxel; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has %2 dimensions; a volume with three is needed.</source>
        <translation>%1 hat %2 Dimensionen; gebraucht wird ein Volumen mit dreien.</translation>
    </message>
    <message>
        <source>%1 is a time series or has several values per voxel (dimension %2 is %3); save the one volume that is meant.</source>
        <translation>%1 ist eine Zeitreihe oder hat mehrere Werte je Voxel (Dimension %2 ist %3); speichern Sie das eine gemeinte Volumen.</translation>
    </message>
    <message>
        <source>%1 does not say how it lies in the patient: its %2; export it again.</source>
        <translation>%1 sagt nicht, wie es im Patienten liegt: %2; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>sform holds a number that is not finite (NaN or infinite)</source>
        <translation>die sform enthält eine Zahl, die nicht endlich ist (NaN oder unendlich)</translation>
    </message>
    <message>
        <source>voxel size (pixdim) holds a number that is not finite (NaN or infinite)</source>
        <translation>die Voxelgröße (pixdim) enthält eine Zahl, die nicht endlich ist (NaN oder unendlich)</translation>
    </message>
    <message>
        <source>voxel size (pixdim) is zero</source>
        <translation>die Voxelgröße (pixdim) ist null</translation>
    </message>
    <message>
        <source>qform holds a number that is not finite (NaN or infinite)</source>
        <translation>die qform enthält eine Zahl, die nicht endlich ist (NaN oder unendlich)</translation>
    </message>
    <message>
        <source>%1 says nowhere how it lies in the patient (no sform, no qform); export it again with its orientation.</source>
        <translation>%1 sagt nirgends, wie es im Patienten liegt (keine sform, keine qform); exportieren Sie die Daten erneut mit ihrer Orientierung.</translation>
    </message>
    <message>
        <source>%1 lies in two places: its sform and qform are %2 mm apart; choose sform or qform.</source>
        <translation>%1 liegt an zwei Orten: sform und qform sind %2 mm auseinander; wählen Sie sform oder qform.</translation>
    </message>
    <message>
        <source>%1 has an impossible data offset in its NIfTI header; export it again.</source>
        <translation>%1 hat einen unmöglichen Datenanfang im NIfTI-Kopf; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 is cut off before its voxels; copy or export it again.</source>
        <translation>%1 ist vor den Voxeln abgeschnitten; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 is not a NRRD file although its name says so; export it again.</source>
        <translation>%1 ist keine NRRD-Datei, obwohl der Name das sagt; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has no &quot;%2&quot; in its NRRD header; export it again.</source>
        <translation>%1 hat kein „%2“ im NRRD-Kopf; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds voxels of NRRD type &quot;%2&quot;, which is not read; save it as integers or floats.</source>
        <translation>%1 enthält Voxel des NRRD-Typs „%2“, der nicht gelesen wird; speichern Sie ganze Zahlen oder Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>%1 says nowhere how it lies in the patient (no &quot;space&quot;); export it again with its orientation.</source>
        <translation>%1 sagt nirgends, wie es im Patienten liegt (kein „space“); exportieren Sie die Daten erneut mit ihrer Orientierung.</translation>
    </message>
    <message>
        <source>%1 lies in the space &quot;%2&quot;, which is not read; save it in LPS or RAS.</source>
        <translation>%1 liegt im Raum „%2“, der nicht gelesen wird; speichern Sie in LPS oder RAS.</translation>
    </message>
    <message>
        <source>%1 has no vector in its header field &quot;%2&quot;; export it again.</source>
        <translation>%1 hat keinen Vektor im Kopffeld „%2“; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 does not have one direction and kind per axis in its NRRD header; export it again.</source>
        <translation>%1 hat im NRRD-Kopf nicht je Achse eine Richtung und eine Art; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 is a time series; save the one volume that is meant.</source>
        <translation>%1 ist eine Zeitreihe; speichern Sie das eine gemeinte Volumen.</translation>
    </message>
    <message>
        <source>%1 is a time series or has several values per voxel; save the one volume that is meant.</source>
        <translation>%1 ist eine Zeitreihe oder hat mehrere Werte je Voxel; speichern Sie das eine gemeinte Volumen.</translation>
    </message>
    <message>
        <source>%1 does not have three axes with a direction in its NRRD header; export it again.</source>
        <translation>%1 hat im NRRD-Kopf nicht drei Achsen mit einer Richtung; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has a size that is not a whole number in its NRRD header; export it again.</source>
        <translation>%1 hat eine Größe im NRRD-Kopf, die keine ganze Zahl ist; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 gives its lengths in %2; save it in mm.</source>
        <translation>%1 gibt die Längen in %2 an; speichern Sie in mm.</translation>
    </message>
    <message>
        <source>%1 has no layer %2 for its segment &quot;%3&quot;; export it again.</source>
        <translation>%1 hat keine Ebene %2 für das Segment „%3“; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 gives no byte order in its NRRD header; export it again.</source>
        <translation>%1 nennt im NRRD-Kopf keine Bytefolge; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 skips part of its data (&quot;%2&quot;), which is not read; save it as one plain .nrrd file.</source>
        <translation>%1 überspringt einen Teil der Daten („%2“), was nicht gelesen wird; speichern Sie eine einfache Datei .nrrd.</translation>
    </message>
    <message>
        <source>%1 is stored with the encoding &quot;%2&quot;; save it as raw or gzip.</source>
        <translation>%1 ist mit der Kodierung „%2“ gespeichert; speichern Sie mit raw oder gzip.</translation>
    </message>
    <message>
        <source>%1 has a rescale slope of %2 where its series has %3, so its Hounsfield units would be wrong; copy or export the series again.</source>
        <translation>%1 hat die Steigung %2, seine Serie aber %3, sodass die Hounsfield-Einheiten falsch wären; kopieren oder exportieren Sie die Serie erneut.</translation>
    </message>
    <message>
        <source>The slices have rescale slopes of their own, from %1 to %2.</source>
        <translation>Die Schichten haben eigene Steigungen zum Umrechnen, von %1 bis %2.</translation>
    </message>
    <message>
        <source>does not say to which series it belongs</source>
        <translation>sagt nicht, zu welcher Serie es gehört</translation>
    </message>
    <message>
        <source>says that it belongs to another series than the rest</source>
        <translation>gibt an, zu einer anderen Serie als der Rest zu gehören</translation>
    </message>
    <message>
        <source>has %1 rows and %2 columns, unlike the other slices of its series (%3 and %4)</source>
        <translation>hat %1 Zeilen und %2 Spalten, anders als die übrigen Schichten der Serie (%3 und %4)</translation>
    </message>
    <message>
        <source>is of modality %1, unlike the other slices of its series</source>
        <translation>hat die Modalität %1, anders als die übrigen Schichten der Serie</translation>
    </message>
    <message>
        <source>has a pixel spacing of %1 x %2 mm, unlike the other slices of its series (%3 x %4 mm)</source>
        <translation>hat einen Pixelabstand von %1 x %2 mm, anders als die übrigen Schichten der Serie (%3 x %4 mm)</translation>
    </message>
    <message>
        <source>has another orientation than the other slices of its series</source>
        <translation>hat eine andere Orientierung als die übrigen Schichten der Serie</translation>
    </message>
    <message>
        <source>%1 lies where the series of %2 lacks a slice or goes on, but says that it is a localizer; export the series again, or take that file out of the folder.</source>
        <translation>%1 liegt dort, wo der Serie von %2 eine Schicht fehlt oder sie weitergeht, gibt aber an, ein Übersichtsbild zu sein; exportieren Sie die Serie erneut oder nehmen Sie diese Datei aus dem Ordner.</translation>
    </message>
    <message>
        <source>%1 lies where the series of %2 lacks a slice or goes on, but says that it is of another series; export the series again, or take that file out of the folder.</source>
        <translation>%1 liegt dort, wo der Serie von %2 eine Schicht fehlt oder sie weitergeht, gibt aber an, zu einer anderen Serie zu gehören; exportieren Sie die Serie erneut oder nehmen Sie diese Datei aus dem Ordner.</translation>
    </message>
    <message>
        <source>%1, such as %2</source>
        <translation>%1, etwa %2</translation>
    </message>
    <message>
        <source>%1 image</source>
        <translation>%1 Bild</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1 image (localizer)</source>
        <translation>%1 Bild (Übersicht)</translation>
    </message>
    <message>
        <source>%1 images (localizer)</source>
        <translation>%1 Bilder (Übersicht)</translation>
    </message>
    <message>
        <source>%1 image of the series &quot;%2&quot;</source>
        <translation>%1 Bild der Serie „%2“</translation>
    </message>
    <message>
        <source>%1 images of the series &quot;%2&quot;</source>
        <translation>%1 Bilder der Serie „%2“</translation>
    </message>
    <message>
        <source>%1 image of the series %2</source>
        <translation>%1 Bild der Serie %2</translation>
    </message>
    <message>
        <source>%1 images of the series %2</source>
        <translation>%1 Bilder der Serie %2</translation>
    </message>
    <message>
        <source>%1 holds two series of different patients: %2, and %3; open the folder of one, or one slice of it.</source>
        <translation>%1 enthält zwei Serien verschiedener Patienten: %2, und %3; öffnen Sie den Ordner einer Serie oder eine Schicht daraus.</translation>
    </message>
    <message>
        <source>%1 holds two series: %2, and %3; open the folder of one, or one slice of it.</source>
        <translation>%1 enthält zwei Serien: %2, und %3; öffnen Sie den Ordner einer Serie oder eine Schicht daraus.</translation>
    </message>
    <message>
        <source>%1 holds no DICOM slice that can be read as a volume; choose the folder with the slices.</source>
        <translation>%1 enthält keine DICOM-Schicht, die sich als Volumen lesen lässt; wählen Sie den Ordner mit den Schichten.</translation>
    </message>
    <message>
        <source>%1 holds only localizer images; choose the folder with the slices.</source>
        <translation>%1 enthält nur Übersichtsbilder; wählen Sie den Ordner mit den Schichten.</translation>
    </message>
    <message>
        <source>Left out: %1.</source>
        <translation>Ausgelassen: %1.</translation>
    </message>
    <message>
        <source>%1 is not a volume: all %2 images lie at one position; choose the series with the volume.</source>
        <translation>%1 ist kein Volumen: Alle %2 Bilder liegen an einer Position; wählen Sie die Serie mit dem Volumen.</translation>
    </message>
    <message>
        <source>%1 holds %2 images at every position, so it is a time series or several phases; give the folder of one phase.</source>
        <translation>%1 enthält %2 Bilder an jeder Position, ist also eine Zeitreihe oder hat mehrere Phasen; wählen Sie den Ordner einer Phase.</translation>
    </message>
    <message>
        <source>%1 slice(s) lie where another one lies already (%2)</source>
        <translation>%1 Schicht(en) liegen, wo schon eine andere liegt (%2)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>between %1 and %2 there are %3 mm instead of %4 mm (a missing or uneven slice)</source>
        <translation>zwischen %1 und %2 liegen %3 mm statt %4 mm (eine fehlende oder ungleiche Schicht)</translation>
    </message>
    <message>
        <source>the slice %1 lies %2 mm off the even spacing</source>
        <translation>die Schicht %1 liegt %2 mm neben dem gleichmäßigen Abstand</translation>
    </message>
    <message>
        <source>%1 lies %2 mm from %3, so one of the two has a broken position; copy or export the series again.</source>
        <translation>%1 liegt %2 mm von %3 entfernt, eine der beiden hat also eine beschädigte Position; kopieren oder exportieren Sie die Serie erneut.</translation>
    </message>
    <message>
        <source>%1 is no regular volume: %2; choose another series, or read it all the same, resampled to a regular grid.</source>
        <translation>%1 ist kein gleichmäßiges Volumen: %2; wählen Sie eine andere Serie oder lesen Sie diese trotzdem, umgerechnet auf ein gleichmäßiges Gitter.</translation>
    </message>
    <message>
        <source>%1, and %2</source>
        <translation>%1, und %2</translation>
    </message>
    <message>
        <source>%1 is not a volume: it holds a single slice; choose the folder with the whole series.</source>
        <translation>%1 ist kein Volumen: Es enthält eine einzige Schicht; wählen Sie den Ordner mit der ganzen Serie.</translation>
    </message>
    <message>
        <source>the gantry was tilted by %1 degrees</source>
        <translation>die Gantry war um %1 Grad gekippt</translation>
    </message>
    <message>
        <source>slices are shifted sideways by up to %1 mm</source>
        <translation>Schichten sind um bis zu %1 mm seitlich verschoben</translation>
    </message>
    <message>
        <source>Resampled to a regular grid with consent: %1.</source>
        <translation>Mit Einwilligung auf ein gleichmäßiges Gitter umgerechnet: %1.</translation>
    </message>
    <message>
        <source>%1 has a header without an end; it is cut off or damaged, so copy or export it again.</source>
        <translation>%1 hat einen Kopf ohne Ende, ist also abgeschnitten oder beschädigt; kopieren oder exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has %2 in its header field &quot;%3&quot;; export it again.</source>
        <translation>%1 hat %2 im Kopffeld „%3“; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>a text such as &quot;%1&quot; for a number</source>
        <translation>einen Text wie „%1“ statt einer Zahl</translation>
    </message>
    <message>
        <source>%1 instead of %2 numbers</source>
        <translation>%1 statt %2 Zahlen</translation>
    </message>
    <message>
        <source>%1 has no whole number in its header field &quot;%2&quot;; export it again.</source>
        <translation>%1 hat keine ganze Zahl im Kopffeld „%2“; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds no Hounsfield units: with its scale of %2 its values leave -32768..32767 by far; export it again.</source>
        <translation>%1 enthält keine Hounsfield-Einheiten: Mit dem Maßstab %2 verlassen die Werte -32768..32767 bei Weitem; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 holds several layers and is a segmentation, not a CT; open it as a segmentation.</source>
        <translation>%1 enthält mehrere Ebenen und ist eine Segmentierung, keine CT; öffnen Sie die Datei als Segmentierung.</translation>
    </message>
    <message>
        <source>%1 holds the same value in every voxel and is no CT; choose another series.</source>
        <translation>%1 enthält in jedem Voxel denselben Wert und ist keine CT; wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>%1 holds only the values %2 and %3, so it is a mask and no CT; open it as a segmentation.</source>
        <translation>%1 enthält nur die Werte %2 und %3, ist also eine Maske und keine CT; öffnen Sie die Datei als Segmentierung.</translation>
    </message>
    <message>
        <source>%1 voxels lay beyond -32768..32767 HU and were set to the nearest of these.</source>
        <translation>%1 Voxel lagen außerhalb von -32768..32767 HE und wurden auf den nächsten dieser Werte gesetzt.</translation>
    </message>
    <message>
        <source>No voxel is below 0 HU (%1 to %2): these may be no Hounsfield units.</source>
        <translation>Kein Voxel liegt unter 0 HE (%1 bis %2): Das sind vielleicht keine Hounsfield-Einheiten.</translation>
    </message>
    <message>
        <source>No voxel is above %1 HU: these may be no Hounsfield units.</source>
        <translation>Kein Voxel liegt über %1 HE: Das sind vielleicht keine Hounsfield-Einheiten.</translation>
    </message>
    <message>
        <source>%1 belongs to another patient than the CT %2 (their %3 differ); choose the right files, or read them all the same.</source>
        <translation>%1 gehört zu einem anderen Patienten als die CT %2 (verschieden: %3); wählen Sie die richtigen Dateien oder lesen Sie diese trotzdem.</translation>
    </message>
    <message>
        <source>%1 belongs to another frame of reference than the CT %2 (their %3 differ); choose the right files, or read them all the same.</source>
        <translation>%1 gehört zu einem anderen Bezugssystem als die CT %2 (verschieden: %3); wählen Sie die richtigen Dateien oder lesen Sie diese trotzdem.</translation>
    </message>
    <message>
        <source>PatientID and FrameOfReferenceUID</source>
        <translation>PatientID und FrameOfReferenceUID</translation>
    </message>
    <message>
        <source>PatientID</source>
        <translation>PatientID</translation>
    </message>
    <message>
        <source>FrameOfReferenceUID</source>
        <translation>FrameOfReferenceUID</translation>
    </message>
    <message>
        <source>Labels and CT do not both name their patient; they are matched by their geometry alone.</source>
        <translation>Labels und CT nennen nicht beide ihren Patienten; sie sind nur nach ihrer Lage zugeordnet.</translation>
    </message>
    <message>
        <source>%1 does not lie on the grid of the CT (labels: %2; CT: %3); choose the right files, or read them all the same.</source>
        <translation>%1 liegt nicht auf dem Gitter der CT (Labels: %2; CT: %3); wählen Sie die richtigen Dateien oder lesen Sie diese trotzdem.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no voxel left on the CT&apos;s grid.</source>
        <translation>„%1“ hat auf dem Gitter der CT kein Voxel mehr.</translation>
    </message>
    <message>
        <source>Labels were resampled (nearest) with consent from %1 to the CT&apos;s grid of %2.</source>
        <translation>Die Labels wurden mit Einwilligung (nächstes Voxel) von %1 auf das Gitter der CT mit %2 umgerechnet.</translation>
    </message>
    <message>
        <source>%1x%2x%3 voxels of %4x%5x%6 mm at (%7, %8, %9)</source>
        <translation>%1x%2x%3 Voxel zu %4x%5x%6 mm bei (%7; %8; %9)</translation>
    </message>
    <message>
        <source>%1 has an empty grid (%2); export it again.</source>
        <translation>%1 hat ein leeres Gitter (%2); exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has a voxel spacing, origin or direction that is not a finite number; export it again.</source>
        <translation>%1 hat einen Voxelabstand, einen Ursprung oder eine Richtung, die keine endliche Zahl ist; exportieren Sie die Daten erneut.</translation>
    </message>
    <message>
        <source>%1 has image axes that are not perpendicular unit vectors; resample it to a straight grid first.</source>
        <translation>%1 hat Bildachsen, die keine senkrechten Einheitsvektoren sind; rechnen Sie das Bild zuerst auf ein gerades Gitter um.</translation>
    </message>
    <message>
        <source>The image</source>
        <translation>Das Bild</translation>
    </message>
    <message>
        <source>The case</source>
        <translation>Der Fall</translation>
    </message>
    <message>
        <source>%1: %2 mL lie outside the liver mask and are counted as liver.</source>
        <translation>%1: %2 mL liegen außerhalb der Lebermaske und zählen als Leber.</translation>
    </message>
    <message>
        <source>%1: %2 mL do not touch the liver and are not counted in it.</source>
        <translation>%1: %2 mL berühren die Leber nicht und zählen nicht zu ihr.</translation>
    </message>
    <message>
        <source>%1 and the vessels overlap by %2 mL; counted as lesion.</source>
        <translation>%1 und die Gefäße überlappen um %2 mL; sie zählen als Läsion.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3 mL; counted once.</source>
        <translation>%1 und %2 überlappen um %3 mL; sie zählen einmal.</translation>
    </message>
    <message>
        <source>Vessels: %1 mL enclosed by the liver but outside its mask are counted as liver.</source>
        <translation>Gefäße: %1 mL, von der Leber umschlossen, aber außerhalb ihrer Maske, zählen als Leber.</translation>
    </message>
    <message>
        <source>Vessels: %1 mL of the liver mask are vessel not enclosed by liver, where trunks leave it, and are not counted.</source>
        <translation>Gefäße: %1 mL der Lebermaske sind Gefäß, das nicht von Leber umschlossen ist, wo Stämme austreten, und zählen nicht.</translation>
    </message>
    <message>
        <source>%1 holds no liver, or an empty one; choose a segmentation with a liver label.</source>
        <translation>%1 enthält keine Leber oder eine leere; wählen Sie eine Segmentierung mit einem Leberlabel.</translation>
    </message>
    <message>
        <source>The number of smoothing iterations is %1; choose 0 to 1000.</source>
        <translation>Die Zahl der Glättungsschritte ist %1; wählen Sie 0 bis 1000.</translation>
    </message>
    <message>
        <source>One iteration of the windowed sinc filter collapses the surface; choose 0, or 2 to 1000.</source>
        <translation>Ein einziger Schritt des Sinc-Filters lässt die Oberfläche zusammenfallen; wählen Sie 0 oder 2 bis 1000.</translation>
    </message>
    <message>
        <source>The decimation is %1; choose a share from 0 to 0.99.</source>
        <translation>Die Dezimierung ist %1; wählen Sie einen Anteil von 0 bis 0,99.</translation>
    </message>
    <message>
        <source>The mask is empty, so there is no surface to make; choose another structure.</source>
        <translation>Die Maske ist leer, es gibt also keine Oberfläche zu erzeugen; wählen Sie eine andere Struktur.</translation>
    </message>
    <message>
        <source>The mask has no voxel set; there is no surface to reconstruct.</source>
        <translation>In der Maske ist kein Voxel gesetzt; es gibt keine Oberfläche zu rekonstruieren.</translation>
    </message>
    <message>
        <source>No voxel of the mask has a gradient, so paper sampling finds no surface.</source>
        <translation>Kein Voxel der Maske hat einen Gradienten, die Abtastung wie im Artikel findet also keine Oberfläche.</translation>
    </message>
    <message>
        <source>The label has no surface to measure errors from: none of its voxels has a gradient; choose another.</source>
        <translation>Das Label hat keine Oberfläche, von der aus Fehler zu messen wären: Keines seiner Voxel hat einen Gradienten; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The label is too small for depth %1: depth %2 is the deepest that its voxels carry.</source>
        <translation>Das Label ist zu klein für die Tiefe %1: Die Tiefe %2 ist die größte, die seine Voxel tragen.</translation>
    </message>
    <message>
        <source>The number of timed runs is %1; choose 1 to 100.</source>
        <translation>Die Zahl der Läufe mit Zeitmessung ist %1; wählen Sie 1 bis 100.</translation>
    </message>
    <message>
        <source>The cutting plane has no direction; place it again.</source>
        <translation>Die Schnittebene hat keine Richtung; setzen Sie sie neu.</translation>
    </message>
    <message>
        <source>The mesh cannot be cut because it has defects (%1); reconstruct it again.</source>
        <translation>Das Netz lässt sich nicht schneiden, weil es Mängel hat (%1); rekonstruieren Sie es erneut.</translation>
    </message>
    <message>
        <source>The mesh cannot be cut cleanly by this plane; move the plane by a fraction of a millimetre.</source>
        <translation>Das Netz lässt sich mit dieser Ebene nicht sauber schneiden; schieben Sie die Ebene um einen Bruchteil eines Millimeters.</translation>
    </message>
    <message>
        <source>The surface is not a closed manifold, so it cannot be simplified; reconstruct it again.</source>
        <translation>Die Oberfläche ist keine geschlossene Mannigfaltigkeit und lässt sich nicht vereinfachen; rekonstruieren Sie sie erneut.</translation>
    </message>
    <message>
        <source>Simplification needs either a number of triangles or a distance.</source>
        <translation>Das Vereinfachen braucht entweder eine Zahl von Dreiecken oder einen Abstand.</translation>
    </message>
    <message>
        <source>Simplification needs 4 triangles or more, not %1.</source>
        <translation>Das Vereinfachen braucht 4 Dreiecke oder mehr, nicht %1.</translation>
    </message>
    <message>
        <source>The distance of simplification must be above 0 mm.</source>
        <translation>Der Abstand des Vereinfachens muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The mesh has no triangles and encloses no volume; reconstruct it again.</source>
        <translation>Das Netz hat keine Dreiecke und umschließt kein Volumen; rekonstruieren Sie es erneut.</translation>
    </message>
    <message>
        <source>The mesh encloses no volume (%1); reconstruct it again or close it first.</source>
        <translation>Das Netz umschließt kein Volumen (%1); rekonstruieren Sie es erneut oder schließen Sie es zuerst.</translation>
    </message>
    <message>
        <source>open: no triangles</source>
        <translation>offen: keine Dreiecke</translation>
    </message>
    <message>
        <source>orientation: inward</source>
        <translation>Orientierung: nach innen</translation>
    </message>
    <message>
        <source>open: %1 %2</source>
        <translation>offen: %1 %2</translation>
    </message>
    <message>
        <source>orientation: %1 %2</source>
        <translation>Orientierung: %1 %2</translation>
    </message>
    <message>
        <source>edge: %1 %2</source>
        <translation>Kante: %1 %2</translation>
    </message>
    <message>
        <source>vertex: %1 %2</source>
        <translation>Punkt: %1 %2</translation>
    </message>
    <message>
        <source>degenerate: %1 %2</source>
        <translation>entartet: %1 %2</translation>
    </message>
    <message>
        <source>self-intersection: %1 %2</source>
        <translation>Selbstdurchdringung: %1 %2</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>edge is not manifold</source>
        <translation>Kante ist nicht mannigfaltig</translation>
    </message>
    <message>
        <source>edges are not manifold</source>
        <translation>Kanten sind nicht mannigfaltig</translation>
    </message>
    <message>
        <source>vertex is not manifold</source>
        <translation>Punkt ist nicht mannigfaltig</translation>
    </message>
    <message>
        <source>vertices are not manifold</source>
        <translation>Punkte sind nicht mannigfaltig</translation>
    </message>
    <message>
        <source>pair of triangles</source>
        <translation>Paar Dreiecke</translation>
    </message>
    <message>
        <source>pairs of triangles</source>
        <translation>Paare Dreiecke</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The depth must lie between 5 and 10, not %1.</source>
        <translation>Die Tiefe muss zwischen 5 und 10 liegen, nicht %1.</translation>
    </message>
    <message>
        <source>The point weight must be a number of 0 or more.</source>
        <translation>Das Punktgewicht muss eine Zahl von 0 oder mehr sein.</translation>
    </message>
    <message>
        <source>The scale must be above 1 and at most 4, not %1.</source>
        <translation>Der Maßstab muss über 1 und höchstens bei 4 liegen, nicht %1.</translation>
    </message>
    <message>
        <source>%1 of %2 self-intersections of smoothing undone by moving %3 vertices</source>
        <translation>%1 von %2 Selbstdurchdringungen der Glättung durch Verschieben von %3 Punkten behoben</translation>
    </message>
    <message>
        <source>PSR d=%1 paper</source>
        <translation>PSR d=%1 wie im Artikel</translation>
    </message>
    <message>
        <source>PSR d=%1 unbiased</source>
        <translation>PSR d=%1 unverzerrt</translation>
    </message>
    <message>
        <source>PSR d=auto paper</source>
        <translation>PSR d=auto wie im Artikel</translation>
    </message>
    <message>
        <source>PSR d=auto unbiased</source>
        <translation>PSR d=auto unverzerrt</translation>
    </message>
    <message>
        <source>%1 screened %2</source>
        <translation>%1 mit Punktgewicht %2</translation>
    </message>
    <message>
        <source>MCSD %1 decimation %2 %</source>
        <translation>MCSD %1, Dezimierung %2 %</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>ungeglättet</translation>
    </message>
    <message>
        <source>sinc %1</source>
        <translation>Sinc %1</translation>
    </message>
    <message>
        <source>Laplacian %1</source>
        <translation>Laplace %1</translation>
    </message>
    <message>
        <source>%1 smooth-first</source>
        <translation>%1, erst geglättet</translation>
    </message>
    <message>
        <source>%1 split normals</source>
        <translation>%1, geteilte Normalen</translation>
    </message>
    <message>
        <source>%1 voxel</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>%1 piece</source>
        <translation>%1 Teil</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>%1 cavity</source>
        <translation>%1 Hohlraum</translation>
    </message>
    <message>
        <source>%1 cavities</source>
        <translation>%1 Hohlräume</translation>
    </message>
    <message>
        <source>%1 of %2 lost: %3</source>
        <translation>%1 von %2 verloren: %3</translation>
    </message>
    <message>
        <source>%1 lost: %2</source>
        <translation>%1 verloren: %2</translation>
    </message>
    <message>
        <source>%1 in the mesh, %2 in the mask: thin walls are open</source>
        <translation>%1 im Netz, %2 in der Maske: Dünne Wände sind offen</translation>
    </message>
    <message>
        <source>%1 in the mesh, %2 in the mask</source>
        <translation>%1 im Netz, %2 in der Maske</translation>
    </message>
    <message>
        <source>%1 of %2 not represented: %3</source>
        <translation>%1 von %2 nicht dargestellt: %3</translation>
    </message>
    <message>
        <source>Euler number %1, the mask&apos;s %2</source>
        <translation>Eulerzahl %1, die der Maske %2</translation>
    </message>
    <message>
        <source>Euler number %1, the mask&apos;s %2 to %3</source>
        <translation>Eulerzahl %1, die der Maske %2 bis %3</translation>
    </message>
    <message>
        <source>%1 thinner than three cells (%2 mm): %3</source>
        <translation>%1 dünner als drei Zellen (%2 mm): %3</translation>
    </message>
    <message>
        <source>only %1 % of the centreline lies inside the mesh</source>
        <translation>nur %1 % der Mittellinie liegen im Netz</translation>
    </message>
    <message>
        <source>touches the border of the image and is cut off there</source>
        <translation>berührt den Rand des Bildes und ist dort abgeschnitten</translation>
    </message>
    <message>
        <source>depth %1 used instead of %2: finer cells would be below half a voxel</source>
        <translation>Tiefe %1 statt %2 verwendet: Feinere Zellen lägen unter einem halben Voxel</translation>
    </message>
    <message>
        <source>volume %1 against the voxels</source>
        <translation>Volumen %1 gegenüber den Voxeln</translation>
    </message>
    <message>
        <source>decimation left out: at the default it broke the mesh (%1)</source>
        <translation>Dezimierung weggelassen: Mit der Vorgabe zerstörte sie das Netz (%1)</translation>
    </message>
    <message>
        <source>The data could not be compressed because zlib did not start; free some memory and try again.</source>
        <translation>Die Daten ließen sich nicht komprimieren, weil zlib nicht startete; geben Sie Speicher frei und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>The data could not be compressed because zlib reported an error; try again.</source>
        <translation>Die Daten ließen sich nicht komprimieren, weil zlib einen Fehler meldete; versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>sample patient</source>
        <translation>Beispielpatient</translation>
    </message>
    <message>
        <source>marching cubes</source>
        <translation>Marching Cubes</translation>
    </message>
    <message>
        <source>smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>decimation</source>
        <translation>Dezimierung</translation>
    </message>
    <message>
        <source>marching cubes, smoothing, decimation</source>
        <translation>Marching Cubes, Glättung, Dezimierung</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>solve</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>extract</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>measures</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>simplify</source>
        <translation>Vereinfachung</translation>
    </message>
    <message>
        <source>slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>headers</source>
        <translation>Köpfe</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner fehlt</translation>
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
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei existiert bereits</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent überschritten</translation>
    </message>
    <message>
        <source>simplified from %1 to %2 triangles</source>
        <translation>von %1 auf %2 Dreiecke vereinfacht</translation>
    </message>
    <message>
        <source>more than %1 triangles are kept: with fewer the surface would cross itself or lose a piece</source>
        <translation>mehr als %1 Dreiecke bleiben: Mit weniger würde sich die Oberfläche selbst durchdringen oder ein Teil verlieren</translation>
    </message>
    <message>
        <source>%1, simplified to %2 triangles</source>
        <translation>%1, vereinfacht auf %2 Dreiecke</translation>
    </message>
    <message>
        <source>%1, simplified to %2 mm</source>
        <translation>%1, vereinfacht auf %2 mm</translation>
    </message>
    <message>
        <source>%1: it is not known what &quot;%2&quot; is; open the files again and choose its kind.</source>
        <translation>%1: Es ist nicht bekannt, was „%2“ ist; öffnen Sie die Dateien erneut und wählen Sie die Art.</translation>
    </message>
    <message>
        <source>%1 has no voxels and is not in the model.</source>
        <translation>%1 hat keine Voxel und ist nicht im Modell.</translation>
    </message>
    <message>
        <source>%1 is part of the parenchyma, as %2 is.</source>
        <translation>%1 ist Teil des Parenchyms wie %2.</translation>
    </message>
    <message>
        <source>%1 holds no liver, or an empty one; choose a segmentation with a liver, or open it again and choose Parenchyma where you are asked what a label is.</source>
        <translation>%1 enthält keine Leber oder eine leere; wählen Sie eine Segmentierung mit einer Leber oder öffnen Sie sie erneut und wählen Sie Parenchym, wo Sie nach einem Label gefragt werden.</translation>
    </message>
    <message>
        <source>Not part of a liver model: %1.</source>
        <translation>Nicht Teil eines Lebermodells: %1.</translation>
    </message>
    <message>
        <source>%1 has no mask in this case; read the segmentation again.</source>
        <translation>%1 hat in diesem Fall keine Maske; lesen Sie die Segmentierung erneut.</translation>
    </message>
    <message>
        <source>%1 (%2) is not on the grid of %3 (%4); choose the labels of this CT.</source>
        <translation>%1 (%2) liegt nicht auf dem Gitter von %3 (%4); wählen Sie die Labels dieser CT.</translation>
    </message>
    <message>
        <source>The model has no structure %1; build it from the segmentation of this case.</source>
        <translation>Das Modell hat keine Struktur %1; erzeugen Sie es aus der Segmentierung dieses Falls.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2): choose another folder or make room.</source>
        <translation>„%1“ lässt sich nicht schreiben (%2): Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2): check the path and your rights.</source>
        <translation>„%1“ lässt sich nicht lesen (%2): Prüfen Sie den Pfad und Ihre Rechte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a regular file: name a file.</source>
        <translation>„%1“ ist keine gewöhnliche Datei: Nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than 2 GiB and is not read: simplify it first.</source>
        <translation>„%1“ ist größer als 2 GiB und wird nicht gelesen: Vereinfachen Sie das Netz zuerst.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; ended while it was being read: copy it again.</source>
        <translation>„%1“ endete beim Lesen: Kopieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; %2: write the mesh again with the program it came from.</source>
        <translation>„%1“ %2: Schreiben Sie das Netz mit dem Programm neu, aus dem es stammt.</translation>
    </message>
    <message>
        <source>ends in the middle (%1 bytes)</source>
        <translation>endet mittendrin (%1 Byte)</translation>
    </message>
    <message>
        <source>The mesh has a coordinate that is no finite number: reconstruct the structure again.</source>
        <translation>Das Netz hat eine Koordinate, die keine endliche Zahl ist: Rekonstruieren Sie die Struktur erneut.</translation>
    </message>
    <message>
        <source>is no GLB 2.0 file of its own length</source>
        <translation>ist keine GLB-2.0-Datei ihrer eigenen Länge</translation>
    </message>
    <message>
        <source>does not begin with its JSON</source>
        <translation>beginnt nicht mit dem JSON</translation>
    </message>
    <message>
        <source>has no binary chunk after its JSON</source>
        <translation>hat keinen Binärblock nach dem JSON</translation>
    </message>
    <message>
        <source>has bytes after its binary chunk</source>
        <translation>hat Bytes nach dem Binärblock</translation>
    </message>
    <message>
        <source>has an accessor of another type than this program writes</source>
        <translation>hat einen Accessor eines anderen Typs, als dieses Programm schreibt</translation>
    </message>
    <message>
        <source>has an accessor that does not fit its bytes</source>
        <translation>hat einen Accessor, der nicht zu den Bytes passt</translation>
    </message>
    <message>
        <source>has a vertex that is no finite number</source>
        <translation>hat einen Punkt, der keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>has indices that are not three for each triangle</source>
        <translation>hat nicht drei Indizes je Dreieck</translation>
    </message>
    <message>
        <source>has a face that names a vertex it does not have</source>
        <translation>hat eine Fläche, die einen fehlenden Punkt nennt</translation>
    </message>
    <message>
        <source>has a structure with a transformation of its own</source>
        <translation>hat eine Struktur mit eigener Transformation</translation>
    </message>
    <message>
        <source>has a structure of several primitives</source>
        <translation>hat eine Struktur aus mehreren Primitiven</translation>
    </message>
    <message>
        <source>has more than one root node</source>
        <translation>hat mehr als einen Wurzelknoten</translation>
    </message>
    <message>
        <source>has JSON that is damaged or not of this program</source>
        <translation>hat JSON, das beschädigt oder nicht von diesem Programm ist</translation>
    </message>
    <message>
        <source>There is no mesh to write as GLB: build the model first.</source>
        <translation>Es gibt kein Netz für die GLB-Datei: Rekonstruieren Sie zuerst das Modell.</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; has no triangles and cannot be written as GLB: leave it out.</source>
        <translation>Das Netz „%1“ hat keine Dreiecke und lässt sich nicht als GLB schreiben: Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>The model is larger than a GLB file can be: export STL only.</source>
        <translation>Das Modell ist größer, als eine GLB-Datei sein kann: Exportieren Sie nur STL.</translation>
    </message>
    <message>
        <source>The GLB could not be composed: export without it.</source>
        <translation>Die GLB-Datei ließ sich nicht zusammensetzen: Exportieren Sie ohne sie.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no manifest of this version: verify the package with the program that wrote it.</source>
        <translation>„%1“ ist kein Verzeichnis dieser Version: Prüfen Sie das Paket mit dem Programm, das es geschrieben hat.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: export the plan again.</source>
        <translation>„%1“ ist beschädigt: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>has &quot;%1&quot; where a number belongs</source>
        <translation>hat „%1“, wo eine Zahl hingehört</translation>
    </message>
    <message>
        <source>has a facet with %1 corners</source>
        <translation>hat eine Facette mit %1 Ecken</translation>
    </message>
    <message>
        <source>ends before &quot;endsolid&quot;</source>
        <translation>endet vor „endsolid“</translation>
    </message>
    <message>
        <source>has a property of the unknown type &quot;%1&quot;</source>
        <translation>hat eine Eigenschaft des unbekannten Typs „%1“</translation>
    </message>
    <message>
        <source>names no PLY format</source>
        <translation>nennt kein PLY-Format</translation>
    </message>
    <message>
        <source>is a PLY of the format &quot;%1&quot;, which is not read</source>
        <translation>ist ein PLY des Formats „%1“, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>has an element without a count</source>
        <translation>hat ein Element ohne Anzahl</translation>
    </message>
    <message>
        <source>has a property before its first element</source>
        <translation>hat eine Eigenschaft vor dem ersten Element</translation>
    </message>
    <message>
        <source>ends inside its PLY header</source>
        <translation>endet mitten im PLY-Kopf</translation>
    </message>
    <message>
        <source>has fewer rows than its header says</source>
        <translation>hat weniger Zeilen, als der Kopf sagt</translation>
    </message>
    <message>
        <source>has a face with fewer than three corners</source>
        <translation>hat eine Fläche mit weniger als drei Ecken</translation>
    </message>
    <message>
        <source>says it has %1 rows of &quot;%2&quot;, more than its bytes can hold</source>
        <translation>nennt %1 Zeilen „%2“, mehr, als die Bytes fassen können</translation>
    </message>
    <message>
        <source>has a list of more than 64 entries</source>
        <translation>hat eine Liste mit mehr als 64 Einträgen</translation>
    </message>
    <message>
        <source>has a vertex without finite x, y and z</source>
        <translation>hat einen Punkt ohne endliches x, y und z</translation>
    </message>
    <message>
        <source>has a face with &quot;%1&quot; where an index belongs</source>
        <translation>hat eine Fläche mit „%1“, wo ein Index hingehört</translation>
    </message>
    <message>
        <source>says it has %1 triangles but is %2 bytes long</source>
        <translation>nennt %1 Dreiecke, ist aber %2 Byte lang</translation>
    </message>
    <message>
        <source>is no STL file</source>
        <translation>ist keine STL-Datei</translation>
    </message>
    <message>
        <source>is no PLY file</source>
        <translation>ist keine PLY-Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no mesh format&apos;s extension: name an .stl, .ply, .obj or .vtp file.</source>
        <translation>„%1“ hat keine Endung eines Netzformats: Nennen Sie eine Datei .stl, .ply, .obj oder .vtp.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no mesh format&apos;s extension: use .stl, .ply, .obj, .vtp or .glb.</source>
        <translation>„%1“ hat keine Endung eines Netzformats: Verwenden Sie .stl, .ply, .obj, .vtp oder .glb.</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>hat keine Dreiecke</translation>
    </message>
    <message>
        <source>has a data block that is no base64 text</source>
        <translation>hat einen Datenblock, der kein Base64-Text ist</translation>
    </message>
    <message>
        <source>keeps its data as an appended block, which is not read</source>
        <translation>hält die Daten in einem angehängten Block, der nicht gelesen wird</translation>
    </message>
    <message>
        <source>has a data block that is not as long as it says</source>
        <translation>hat einen Datenblock, der nicht so lang ist, wie er sagt</translation>
    </message>
    <message>
        <source>has a data array of the type &quot;%1&quot;, which is not read</source>
        <translation>hat ein Datenfeld des Typs „%1“, der nicht gelesen wird</translation>
    </message>
    <message>
        <source>has no &quot;%1&quot; of its polygons</source>
        <translation>hat kein „%1“ zu den Polygonen</translation>
    </message>
    <message>
        <source>has polygons whose offsets do not fit its connectivity</source>
        <translation>hat Polygone, deren Anfänge nicht zu den Verbindungen passen</translation>
    </message>
    <message>
        <source>is no VTP file</source>
        <translation>ist keine VTP-Datei</translation>
    </message>
    <message>
        <source>is compressed or big-endian, which is not read</source>
        <translation>ist komprimiert oder in der Bytefolge Big Endian, was nicht gelesen wird</translation>
    </message>
    <message>
        <source>has no points or no polygons</source>
        <translation>hat keine Punkte oder keine Polygone</translation>
    </message>
    <message>
        <source>has points that are not three numbers each</source>
        <translation>hat Punkte, die nicht aus je drei Zahlen bestehen</translation>
    </message>
    <message>
        <source>The export&apos;s time &quot;%1&quot; is not YYYYMMDD-HHMM.</source>
        <translation>Die Zeit des Exports „%1“ ist nicht JJJJMMTT-HHMM.</translation>
    </message>
    <message>
        <source>The case has no plan: place a plane before exporting.</source>
        <translation>Der Fall hat keinen Plan: Setzen Sie vor dem Export eine Ebene.</translation>
    </message>
    <message>
        <source>The case has no plan named &quot;%1&quot;.</source>
        <translation>Der Fall hat keinen Plan namens „%1“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was read back and %2, so nothing was exported: export again.</source>
        <translation>„%1“ %2, wie das Zurücklesen zeigte; es wurde nichts exportiert: Exportieren Sie erneut.</translation>
    </message>
    <message>
        <source>is not what was written</source>
        <translation>ist nicht, was geschrieben wurde</translation>
    </message>
    <message>
        <source>has defects once rounded to the file&apos;s precision (%1)</source>
        <translation>hat Mängel nach dem Runden auf die Genauigkeit der Datei (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would cross itself once rounded to the files&apos; precision (%2 %3), so nothing was exported.</source>
        <translation>„%1“ würde sich nach dem Runden auf die Genauigkeit der Dateien selbst durchdringen (%2 %3); es wurde nichts exportiert.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would cross itself once rounded to the files&apos; precision (%2 %3), so nothing was exported: move the plane a little and export again.</source>
        <translation>„%1“ würde sich nach dem Runden auf die Genauigkeit der Dateien selbst durchdringen (%2 %3); es wurde nichts exportiert: Schieben Sie die Ebene ein wenig und exportieren Sie erneut.</translation>
    </message>
    <message>
        <source>does not hold every structure</source>
        <translation>enthält nicht jede Struktur</translation>
    </message>
    <message>
        <source>has its structures in disorder</source>
        <translation>hat die Strukturen in falscher Reihenfolge</translation>
    </message>
    <message>
        <source>has defects in &quot;%1&quot; once rounded to the file&apos;s precision</source>
        <translation>hat Mängel in „%1“ nach dem Runden auf die Genauigkeit der Datei</translation>
    </message>
    <message>
        <source>The package did not pass its own check, so nothing was exported: %1</source>
        <translation>Das Paket hat die eigene Prüfung nicht bestanden, es wurde nichts exportiert: %1</translation>
    </message>
    <message>
        <source>has %1 triangles instead of %2</source>
        <translation>hat %1 Dreiecke statt %2</translation>
    </message>
    <message>
        <source>has bounds that are off by %1 mm</source>
        <translation>hat Grenzen, die um %1 mm abweichen</translation>
    </message>
    <message>
        <source>has an area of %1 mm2</source>
        <translation>hat eine Fläche von %1 mm2</translation>
    </message>
    <message>
        <source>is turned inside out</source>
        <translation>ist umgestülpt</translation>
    </message>
    <message>
        <source>has a volume of %1 mL instead of %2 mL</source>
        <translation>hat ein Volumen von %1 mL statt %2 mL</translation>
    </message>
    <message>
        <source>has a corner %1 mm from its place</source>
        <translation>hat eine Ecke %1 mm neben ihrem Ort</translation>
    </message>
    <message>
        <source>has a header that begins with &quot;solid&quot;, which some readers take for text</source>
        <translation>hat einen Kopf, der mit „solid“ beginnt, was manche Programme für Text halten</translation>
    </message>
    <message>
        <source>does not say SPACE=LPS in its header</source>
        <translation>nennt SPACE=LPS nicht im Kopf</translation>
    </message>
    <message>
        <source>does not say UNIT=mm in its header</source>
        <translation>nennt UNIT=mm nicht im Kopf</translation>
    </message>
    <message>
        <source>has a root matrix that does not take millimetres LPS to metres with +Y up</source>
        <translation>hat eine Wurzelmatrix, die Millimeter LPS nicht in Meter mit +Y nach oben überführt</translation>
    </message>
    <message>
        <source>The structure &quot;%1&quot; has not been built yet: let its model finish, then export again.</source>
        <translation>Die Struktur „%1“ ist noch nicht rekonstruiert: Lassen Sie das Modell fertig werden und exportieren Sie dann erneut.</translation>
    </message>
    <message>
        <source>The structure &quot;%1&quot; has defects (%2) and is not exported.</source>
        <translation>Die Struktur „%1“ hat Mängel (%2) und wird nicht exportiert.</translation>
    </message>
    <message>
        <source>Structures deviate from their voxels: %1; look at them, then export again and confirm the question.</source>
        <translation>Strukturen weichen von ihren Voxeln ab: %1; sehen Sie sie an, exportieren Sie dann erneut und bestätigen Sie die Frage.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Resection %1 of the plan does not divide the liver, so there is no resected part: move its plane into the liver or remove it, then export again.</source>
        <translation>Resektion %1 des Plans teilt die Leber nicht, es gibt also kein Resektat: Schieben Sie die Ebene in die Leber oder entfernen Sie sie und exportieren Sie dann erneut.</translation>
    </message>
    <message>
        <source>The resected parts and the remnant do not add up to the liver: move the plane a little and export again.</source>
        <translation>Resektat und Rest ergeben zusammen nicht die Leber: Schieben Sie die Ebene ein wenig und exportieren Sie erneut.</translation>
    </message>
    <message>
        <source>The model has no parenchyma, so there is nothing to export: build the model first.</source>
        <translation>Das Modell hat kein Parenchym, es gibt also nichts zu exportieren: Rekonstruieren Sie zuerst das Modell.</translation>
    </message>
    <message>
        <source>plan.json does not say axes LPS and units mm: export the plan again.</source>
        <translation>plan.json nennt nicht die Achsen LPS und die Einheit mm: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>plan.json and manifest.json do not agree on &quot;%1&quot;: export the plan again.</source>
        <translation>plan.json und manifest.json stimmen bei „%1“ nicht überein: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>plan.json is damaged: export the plan again.</source>
        <translation>plan.json ist beschädigt: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>The package cannot be written into &quot;%1&quot; (%2): choose another folder or make room.</source>
        <translation>Das Paket lässt sich nicht nach „%1“ schreiben (%2): Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>The manifest names &quot;%1&quot;, which is outside the package: export the plan again.</source>
        <translation>Das Verzeichnis nennt „%1“ außerhalb des Pakets: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; %2: export the plan again.</source>
        <translation>„%1“ %2: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>has been changed since the export</source>
        <translation>wurde seit dem Export geändert</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not belong to the package: remove it or export the plan again.</source>
        <translation>„%1“ gehört nicht zum Paket: Entfernen Sie die Datei oder exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in model.glb %2: export the plan again.</source>
        <translation>„%1“ in model.glb %2: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>holds more structures than the manifest</source>
        <translation>enthält mehr Strukturen als das Verzeichnis</translation>
    </message>
    <message>
        <source>The package cannot be read (%1): check your rights.</source>
        <translation>Das Paket lässt sich nicht lesen (%1): Prüfen Sie Ihre Rechte.</translation>
    </message>
    <message>
        <source>The manifest does not list &quot;%1&quot;: export the plan again.</source>
        <translation>Das Verzeichnis führt „%1“ nicht auf: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no navigation package, it has no manifest.json: name the package&apos;s folder.</source>
        <translation>„%1“ ist kein Navigationspaket, manifest.json fehlt: Nennen Sie den Ordner des Pakets.</translation>
    </message>
    <message>
        <source>The plan has no such plane; choose one of its resections first.</source>
        <translation>Der Plan hat keine solche Ebene; wählen Sie zuerst eine seiner Resektionen.</translation>
    </message>
    <message>
        <source>The plane&apos;s origin and normal must be finite numbers and the normal must not be zero.</source>
        <translation>Ursprung und Normale der Ebene müssen endliche Zahlen sein, und die Normale darf nicht null sein.</translation>
    </message>
    <message>
        <source>The camera looks along its own up direction; turn the view first.</source>
        <translation>Die Kamera blickt entlang ihrer eigenen Oben-Richtung; drehen Sie zuerst die Ansicht.</translation>
    </message>
    <message>
        <source>%1 is open read-only, because another program is editing it or it is write-protected; save the case under another name.</source>
        <translation>%1 ist nur zum Lesen geöffnet, weil ein anderes Programm es bearbeitet oder es schreibgeschützt ist; speichern Sie den Fall unter anderem Namen.</translation>
    </message>
    <message>
        <source>%1 is not a Glisson case; choose a .glisson file.</source>
        <translation>%1 ist kein Glisson-Fall; wählen Sie eine Datei .glisson.</translation>
    </message>
    <message>
        <source>%1 was written by a newer Glisson (format %2, this one reads up to %3); update Glisson to open it.</source>
        <translation>%1 wurde von einem neueren Glisson geschrieben (Format %2, dieses liest bis %3); aktualisieren Sie Glisson, um den Fall zu öffnen.</translation>
    </message>
    <message>
        <source>%1 is damaged or cut short; open an older copy of the case.</source>
        <translation>%1 ist beschädigt oder abgeschnitten; öffnen Sie eine ältere Kopie des Falls.</translation>
    </message>
    <message>
        <source>%1 cannot be written; check that its folder is there and that you may write to it.</source>
        <translation>%1 lässt sich nicht schreiben; prüfen Sie, ob der Ordner da ist und Sie darin schreiben dürfen.</translation>
    </message>
    <message>
        <source>%1 cannot be written (%2); save the case under another name.</source>
        <translation>%1 lässt sich nicht schreiben (%2); speichern Sie den Fall unter anderem Namen.</translation>
    </message>
    <message>
        <source>A case without a segmentation cannot be saved; open one first.</source>
        <translation>Ein Fall ohne Segmentierung lässt sich nicht speichern; öffnen Sie zuerst eine.</translation>
    </message>
    <message>
        <source>%1 is being edited by another program or is write-protected; save the case under another name.</source>
        <translation>%1 wird von einem anderen Programm bearbeitet oder ist schreibgeschützt; speichern Sie den Fall unter anderem Namen.</translation>
    </message>
    <message>
        <source>%1 is not a file; choose a .glisson file.</source>
        <translation>%1 ist keine Datei; wählen Sie eine Datei .glisson.</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check that you may read it.</source>
        <translation>%1 lässt sich nicht öffnen; prüfen Sie, ob Sie die Datei lesen dürfen.</translation>
    </message>
    <message>
        <source>%1 is damaged (%2); open an older copy of the case.</source>
        <translation>%1 ist beschädigt (%2); öffnen Sie eine ältere Kopie des Falls.</translation>
    </message>
    <message>
        <source>a vector has no three numbers</source>
        <translation>ein Vektor hat keine drei Zahlen</translation>
    </message>
    <message>
        <source>a structure has an unknown kind</source>
        <translation>eine Struktur hat eine unbekannte Art</translation>
    </message>
    <message>
        <source>a plane&apos;s normal is not of unit length</source>
        <translation>die Normale einer Ebene hat nicht die Länge eins</translation>
    </message>
    <message>
        <source>a mask lies outside its grid</source>
        <translation>eine Maske liegt außerhalb ihres Gitters</translation>
    </message>
    <message>
        <source>its %1 is missing</source>
        <translation>der Teil %1 fehlt</translation>
    </message>
    <message>
        <source>its %1 does not match its checksum</source>
        <translation>der Teil %1 passt nicht zu seiner Prüfsumme</translation>
    </message>
    <message>
        <source>a structure has no mask</source>
        <translation>eine Struktur hat keine Maske</translation>
    </message>
    <message>
        <source>a document has not the form of version %1</source>
        <translation>ein Dokument hat nicht die Form der Version %1</translation>
    </message>
    <message>
        <source>its case has no CT source</source>
        <translation>dem Fall fehlt die Quelle der CT</translation>
    </message>
    <message>
        <source>its history cannot be read</source>
        <translation>der Verlauf lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1 cannot be written because the disk is full; free some space, the last saved state is intact.</source>
        <translation>%1 lässt sich nicht schreiben, weil die Platte voll ist; schaffen Sie Platz, der zuletzt gespeicherte Stand ist unversehrt.</translation>
    </message>
    <message>
        <source>%1 is open read-only; save the case under another name to go on editing.</source>
        <translation>%1 ist nur zum Lesen geöffnet; speichern Sie den Fall unter anderem Namen, um ihn weiter zu bearbeiten.</translation>
    </message>
    <message>
        <source>%1 is in use by another program; try again when it has finished.</source>
        <translation>%1 wird von einem anderen Programm benutzt; versuchen Sie es erneut, wenn es fertig ist.</translation>
    </message>
    <message>
        <source>%1 cannot be read or written; check the folder, its rights and the disk.</source>
        <translation>%1 lässt sich nicht lesen oder schreiben; prüfen Sie den Ordner, seine Rechte und die Platte.</translation>
    </message>
    <message>
        <source>%1 cannot be written to the disk; check the disk and save under another name.</source>
        <translation>%1 lässt sich nicht auf die Platte schreiben; prüfen Sie die Platte und speichern Sie unter anderem Namen.</translation>
    </message>
    <message>
        <source>a part is larger than 4 GiB</source>
        <translation>ein Teil ist größer als 4 GiB</translation>
    </message>
    <message>
        <source>a part claims more bytes than it can hold</source>
        <translation>ein Teil nennt mehr Bytes, als er enthalten kann</translation>
    </message>
    <message>
        <source>a part does not unpack to its size</source>
        <translation>ein Teil lässt sich nicht auf seine Größe entpacken</translation>
    </message>
    <message>
        <source>a mask has an impossible size</source>
        <translation>eine Maske hat eine unmögliche Größe</translation>
    </message>
    <message>
        <source>a mask is larger than 4 GiB</source>
        <translation>eine Maske ist größer als 4 GiB</translation>
    </message>
    <message>
        <source>a mesh has an impossible size</source>
        <translation>ein Netz hat eine unmögliche Größe</translation>
    </message>
    <message>
        <source>a mesh has a vertex that is not finite</source>
        <translation>ein Netz hat einen Punkt, der nicht endlich ist</translation>
    </message>
    <message>
        <source>a mesh has a triangle without its vertex</source>
        <translation>ein Netz hat ein Dreieck ohne seinen Punkt</translation>
    </message>
    <message>
        <source>%1 cannot be read; check that it is there and that you may read it.</source>
        <translation>%1 lässt sich nicht lesen; prüfen Sie, ob die Datei da ist und Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>%1 does not divide the liver: nothing is resected.</source>
        <translation>%1 teilt die Leber nicht: Nichts wird reseziert.</translation>
    </message>
    <message>
        <source>%1 does not divide the liver: all of it is resected.</source>
        <translation>%1 teilt die Leber nicht: Sie wird ganz reseziert.</translation>
    </message>
    <message>
        <source>%1 has a plane that is not finite; place it again.</source>
        <translation>%1 hat eine Ebene, die nicht endlich ist; setzen Sie sie neu.</translation>
    </message>
    <message>
        <source>%1: only %2 mm of branches are labelled inside the liver, too few to say what they supply or drain.</source>
        <translation>%1: Nur %2 mm Äste sind in der Leber markiert, zu wenig, um zu sagen, was sie versorgen oder drainieren.</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>territories</source>
        <translation>Territorien</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>%1: the mask does not lie on the grid of the liver; read the segmentation again.</source>
        <translation>%1: Die Maske liegt nicht auf dem Gitter der Leber; lesen Sie die Segmentierung neu ein.</translation>
    </message>
    <message>
        <source>%1: separate pieces taken for continuations of the branch nearest to them: %2</source>
        <translation>%1: getrennte Stücke, die als Fortsetzung des nächsten Astes gelten: %2</translation>
    </message>
    <message>
        <source>%1: separate pieces that own nothing because what they hang on is not known: %2</source>
        <translation>%1: getrennte Stücke, denen nichts zugeordnet wird, weil unbekannt ist, woran sie hängen: %2</translation>
    </message>
    <message>
        <source>The label of the portal vein has no main bifurcation, so left and right are not proposed; pick branches.</source>
        <translation>Das Label der Pfortader hat keine Hauptgabelung, daher werden links und rechts nicht vorgeschlagen; wählen Sie Äste.</translation>
    </message>
    <message>
        <source>The proposed left side has %1 % of the portal branches&apos; length, which is unusual; look at it closely.</source>
        <translation>Die vorgeschlagene linke Seite hat %1 % der Länge der Pfortaderäste, was ungewöhnlich ist; sehen Sie sie genau an.</translation>
    </message>
    <message>
        <source>%1: the portal vein has no branch %2; it has 0 to %3.</source>
        <translation>%1: Die Pfortader hat keinen Ast %2; sie hat 0 bis %3.</translation>
    </message>
    <message>
        <source>%1: branch %2 is picked twice; name it once.</source>
        <translation>%1: Ast %2 ist zweimal gewählt; nennen Sie ihn einmal.</translation>
    </message>
    <message>
        <source>%1 owns nothing of the liver; pick a branch that supplies it.</source>
        <translation>%1 gehört nichts von der Leber; wählen Sie einen Ast, der sie versorgt.</translation>
    </message>
    <message>
        <source>No branch of the portal vein is picked; pick branches, or give a map of segments 1 to 8.</source>
        <translation>Kein Ast der Pfortader ist gewählt; wählen Sie Äste oder geben Sie eine Karte der Segmente 1 bis 8 an.</translation>
    </message>
    <message>
        <source>%1 (%2) is not on the grid of the case (%3); choose a map of this CT.</source>
        <translation>%1 (%2) liegt nicht auf dem Gitter des Falls (%3); wählen Sie eine Karte dieses CT.</translation>
    </message>
    <message>
        <source>%1 has no label 1 to 8 inside the liver; choose a map of liver segments.</source>
        <translation>%1 hat kein Label 1 bis 8 in der Leber; wählen Sie eine Karte der Lebersegmente.</translation>
    </message>
    <message>
        <source>No branches of a portal vein are known inside the liver, so what a plan devascularises is not known.</source>
        <translation>In der Leber sind keine Äste einer Pfortader bekannt, daher ist nicht bekannt, was ein Plan devaskularisiert.</translation>
    </message>
    <message>
        <source>No branches of hepatic veins are known inside the liver, so what a plan congests is not known.</source>
        <translation>In der Leber sind keine Äste von Lebervenen bekannt, daher ist nicht bekannt, was ein Plan staut.</translation>
    </message>
    <message>
        <source>&quot;manifest.json&quot; has been changed since the export: export the plan again.</source>
        <translation>„manifest.json“ wurde seit dem Export geändert: Exportieren Sie den Plan erneut.</translation>
    </message>
    <message>
        <source>%1 and %2 both hold %3; open one of them at a time.</source>
        <translation>%1 und %2 enthalten beide %3; öffnen Sie nur eines davon.</translation>
    </message>
    <message>
        <source>a case</source>
        <translation>einen Fall</translation>
    </message>
    <message>
        <source>a CT</source>
        <translation>eine CT</translation>
    </message>
    <message>
        <source>a segmentation</source>
        <translation>eine Segmentierung</translation>
    </message>
    <message>
        <source>%1 holds neither a CT, nor a segmentation, nor a case; choose a DICOM folder, NIfTI, NRRD, MetaImage or .glisson file.</source>
        <translation>%1 enthält weder eine CT noch eine Segmentierung noch einen Fall; wählen Sie einen DICOM-Ordner oder eine Datei in NIfTI, NRRD, MetaImage oder .glisson.</translation>
    </message>
    <message>
        <source>%1 holds a CT without a segmentation; open the CT and its segmentation together.</source>
        <translation>%1 enthält eine CT ohne Segmentierung; öffnen Sie die CT und ihre Segmentierung zusammen.</translation>
    </message>
    <message>
        <source>The CT of this case is no longer at %1; put it back to see the slices.</source>
        <translation>Die CT dieses Falls liegt nicht mehr unter %1; legen Sie sie zurück, um die Schichten zu sehen.</translation>
    </message>
    <message>
        <source>The CT at %1 does not lie on the grid of the labels and is not shown.</source>
        <translation>Die CT unter %1 liegt nicht auf dem Gitter der Labels und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>The liver&apos;s mask is empty; there is nothing to place a plane on.</source>
        <translation>Die Maske der Leber ist leer; es gibt nichts, worauf sich eine Ebene setzen ließe.</translation>
    </message>
    <message>
        <source>%1 has the label %2 of unknown kind; open it again and choose its kind.</source>
        <translation>%1 hat das Label %2 unbekannter Art; öffnen Sie die Datei erneut und wählen Sie die Art.</translation>
    </message>
    <message>
        <source>%1 could not be reconstructed: %2</source>
        <translation>%1 ließ sich nicht rekonstruieren: %2</translation>
    </message>
    <message>
        <source>The normal (0, 0, 0) has no direction; enter at least one component.</source>
        <translation>Die Normale (0, 0, 0) hat keine Richtung; geben Sie mindestens eine Komponente ein.</translation>
    </message>
    <message>
        <source>The plane can be placed as soon as the liver&apos;s volumes are computed.</source>
        <translation>Die Ebene lässt sich setzen, sobald die Volumina der Leber berechnet sind.</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>%1 has no surface yet.</source>
        <translation>%1 hat noch keine Oberfläche.</translation>
    </message>
    <message>
        <source>Choose a format.</source>
        <translation>Wählen Sie ein Format.</translation>
    </message>
    <message>
        <source>The work ended with an unknown error.</source>
        <translation>Die Arbeit endete mit einem unbekannten Fehler.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs and try again.</source>
        <translation>Dafür reicht der Speicher nicht; schließen Sie andere Programme und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>vena cava</source>
        <translation>Hohlvene</translation>
    </message>
    <message>
        <source>artery</source>
        <translation>Arterie</translation>
    </message>
    <message>
        <source>tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>cyst</source>
        <translation>Zyste</translation>
    </message>
    <message>
        <source>gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>bile duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>tumour %1</source>
        <translation>Tumor %1</translation>
    </message>
    <message>
        <source>cyst %1</source>
        <translation>Zyste %1</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>%1 of layer %2</source>
        <translation>%1 der Ebene %2</translation>
    </message>
    <message>
        <source>Resection %1</source>
        <translation>Resektion %1</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Strecke %1</translation>
    </message>
    <message>
        <source>Plan %1</source>
        <translation>Plan %1</translation>
    </message>
    <message>
        <source>The height is not given, so no standardised liver volume and no threshold is shown.</source>
        <translation>Die Größe ist nicht angegeben, also werden kein Standard-Lebervolumen und kein Schwellenwert gezeigt.</translation>
    </message>
    <message>
        <source>The weight is not given, so no standardised liver volume and no threshold is shown.</source>
        <translation>Das Gewicht ist nicht angegeben, also werden kein Standard-Lebervolumen und kein Schwellenwert gezeigt.</translation>
    </message>
    <message>
        <source>A height of %1 cm is outside 120 to 220 cm, for which the formulas hold, so no standardised liver volume and no threshold is shown.</source>
        <translation>Eine Größe von %1 cm liegt außerhalb von 120 bis 220 cm, wofür die Formeln gelten, also werden kein Standard-Lebervolumen und kein Schwellenwert gezeigt.</translation>
    </message>
    <message>
        <source>A weight of %1 kg is outside 30 to 250 kg, for which the formulas hold, so no standardised liver volume and no threshold is shown.</source>
        <translation>Ein Gewicht von %1 kg liegt außerhalb von 30 bis 250 kg, wofür die Formeln gelten, also werden kein Standard-Lebervolumen und kein Schwellenwert gezeigt.</translation>
    </message>
    <message>
        <source>A body surface area of %1 m2 is outside 1.2 to 2.6 m2, for which the formulas hold, so no standardised liver volume and no threshold is shown.</source>
        <translation>Eine Körperoberfläche von %1 m2 liegt außerhalb von 1,2 bis 2,6 m2, wofür die Formeln gelten, also werden kein Standard-Lebervolumen und kein Schwellenwert gezeigt.</translation>
    </message>
    <message>
        <source>The liver&apos;s condition is not given, so no threshold is shown.</source>
        <translation>Der Zustand der Leber ist nicht angegeben, also wird kein Schwellenwert gezeigt.</translation>
    </message>
    <message>
        <source>Kubota&apos;s 40 or 50 % of the functional volume depend on ICG R15, which is not asked for, so they are not shown.</source>
        <translation>Kubotas 40 oder 50 % des funktionellen Volumens hängen von ICG R15 ab, wonach nicht gefragt wird, also werden sie nicht gezeigt.</translation>
    </message>
    <message>
        <source>The plan does not divide the liver, so there is no remnant to compare.</source>
        <translation>Der Plan teilt die Leber nicht, also gibt es keinen Leberrest zu vergleichen.</translation>
    </message>
    <message>
        <source>below this: R1; from this on: accepted</source>
        <translation>darunter: R1; ab hier: anerkannt</translation>
    </message>
    <message>
        <source>the old rule</source>
        <translation>die alte Regel</translation>
    </message>
    <message>
        <source>below this: worse, in non-anatomical resections</source>
        <translation>darunter: schlechter, bei nicht anatomischen Resektionen</translation>
    </message>
    <message>
        <source>The height and the weight must be positive numbers in cm and kg; type them again or leave them out.</source>
        <translation>Größe und Gewicht müssen positive Zahlen in cm und kg sein; geben Sie sie erneut ein oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>the patient has an unknown liver condition or tumour type</source>
        <translation>der Patient hat einen unbekannten Leberzustand oder Tumortyp</translation>
    </message>
    <message>
        <source>The plan has no such resection; choose one of its resections first.</source>
        <translation>Der Plan hat keine solche Resektion; wählen Sie zuerst eine seiner Resektionen.</translation>
    </message>
    <message>
        <source>The point&apos;s coordinates must be finite numbers.</source>
        <translation>Die Koordinaten des Punktes müssen endliche Zahlen sein.</translation>
    </message>
    <message>
        <source>A resection needs at least one plane; place it first.</source>
        <translation>Eine Resektion braucht mindestens eine Ebene; setzen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>The safety margin must be a number of millimetres, 0 or more.</source>
        <translation>Der Sicherheitsabstand muss eine Zahl in Millimetern sein, 0 oder mehr.</translation>
    </message>
    <message>
        <source>The plan has no such assigned island; choose one of those it has.</source>
        <translation>Der Plan hat keine solche zugewiesene Insel; wählen Sie eine von denen, die er hat.</translation>
    </message>
    <message>
        <source>The plan has no such measured distance; choose one of those it has.</source>
        <translation>Der Plan hat keine solche gemessene Strecke; wählen Sie eine von denen, die er hat.</translation>
    </message>
    <message>
        <source>move plane %1 of %2</source>
        <translation>Ebene %1 von %2 verschieben</translation>
    </message>
    <message>
        <source>move plane %1</source>
        <translation>Ebene %1 verschieben</translation>
    </message>
    <message>
        <source>move plane</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>remove plane %1 of %2</source>
        <translation>Ebene %1 von %2 entfernen</translation>
    </message>
    <message>
        <source>remove plane %1</source>
        <translation>Ebene %1 entfernen</translation>
    </message>
    <message>
        <source>remove plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>add plane to %1</source>
        <translation>Ebene zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>add plane</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>add resection</source>
        <translation>Resektion hinzufügen</translation>
    </message>
    <message>
        <source>remove distance</source>
        <translation>Strecke entfernen</translation>
    </message>
    <message>
        <source>measure distance</source>
        <translation>Strecke messen</translation>
    </message>
    <message>
        <source>change safety margin</source>
        <translation>Sicherheitsabstand ändern</translation>
    </message>
    <message>
        <source>add island to the resected side</source>
        <translation>Insel dem Resektat zuschlagen</translation>
    </message>
    <message>
        <source>add island to the remnant</source>
        <translation>Insel dem Leberrest zuschlagen</translation>
    </message>
    <message>
        <source>give island back</source>
        <translation>Insel zurückgeben</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>The three points lie on one line, so they give no plane; click one of them elsewhere.</source>
        <translation>Die drei Punkte liegen auf einer Geraden und ergeben keine Ebene; klicken Sie einen davon woanders.</translation>
    </message>
    <message>
        <source>The line has no length in the view, so it gives no plane; draw it again across the liver.</source>
        <translation>Die Linie hat in der Ansicht keine Länge und ergibt keine Ebene; ziehen Sie sie erneut über die Leber.</translation>
    </message>
    <message>
        <source>The case has no such plan; choose one of its plans first.</source>
        <translation>Der Fall hat keinen solchen Plan; wählen Sie zuerst einen seiner Pläne.</translation>
    </message>
    <message>
        <source>A case keeps at least one plan; make another one before this one is deleted.</source>
        <translation>Ein Fall behält mindestens einen Plan; legen Sie einen anderen an, bevor Sie diesen löschen.</translation>
    </message>
    <message>
        <source>A name cannot be empty; type another one.</source>
        <translation>Ein Name darf nicht leer sein; geben Sie einen anderen ein.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is taken; type another one.</source>
        <translation>Der Name „%1“ ist vergeben; geben Sie einen anderen ein.</translation>
    </message>
    <message>
        <source>%1 copy %2</source>
        <translation>%1 Kopie %2</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>The case has no tumour &quot;%1&quot; that is named once; it has: %2.</source>
        <translation>Der Fall hat keinen Tumor „%1“, der genau einmal so heißt; er hat: %2.</translation>
    </message>
    <message>
        <source>The proposed plane is geometry only: it ignores inflow, outflow and access.</source>
        <translation>Die vorgeschlagene Ebene ist nur Geometrie: Zufluss, Abfluss und Zugang bleiben unberücksichtigt.</translation>
    </message>
    <message>
        <source>No plane keeps %1 mm around %2: each one that does takes the whole functional liver or nothing of it.</source>
        <translation>Keine Ebene hält %1 mm um %2 ein: Jede, die es täte, nähme die ganze funktionelle Leber oder nichts davon.</translation>
    </message>
    <message>
        <source>The proposed plane around %1 does not keep its margin; place the plane by hand.</source>
        <translation>Die vorgeschlagene Ebene um %1 hält ihren Abstand nicht ein; setzen Sie die Ebene von Hand.</translation>
    </message>
    <message>
        <source>margin plane</source>
        <translation>Ebene am Sicherheitsabstand</translation>
    </message>
    <message>
        <source>The piece at (%1, %2, %3) mm is no island of its own, so it counts on the side where the planes leave it.</source>
        <translation>Das Stück bei (%1; %2; %3) mm ist keine eigene Insel, also zählt es auf der Seite, auf der es die Ebenen lassen.</translation>
    </message>
    <message>
        <source>%1 is in %2 only.</source>
        <translation>%1 gibt es nur in %2.</translation>
    </message>
    <message>
        <source>%1 has %2 planes in %3 and %4 in %5.</source>
        <translation>%1 hat %2 Ebenen in %3 und %4 in %5.</translation>
    </message>
    <message>
        <source>Plane %1 of %2 is turned by %3 degrees and lies %4 mm from where it was placed in %5.</source>
        <translation>Ebene %1 von %2 ist um %3 Grad gedreht und liegt %4 mm von dort entfernt, wo sie in %5 gesetzt wurde.</translation>
    </message>
    <message>
        <source>%1: %2 in %3, %4 in %5.</source>
        <translation>%1: %2 in %3, %4 in %5.</translation>
    </message>
    <message>
        <source>%1 and %2 are alike.</source>
        <translation>%1 und %2 sind gleich.</translation>
    </message>
    <message>
        <source>Two to four plans can be compared; choose that many.</source>
        <translation>Zwei bis vier Pläne lassen sich vergleichen; wählen Sie so viele.</translation>
    </message>
    <message>
        <source>Safety margin</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Functional remnant</source>
        <translation>Funktioneller Leberrest</translation>
    </message>
    <message>
        <source>Resected</source>
        <translation>Reseziert</translation>
    </message>
    <message>
        <source>Margin of %1, at least</source>
        <translation>Abstand von %1, mindestens</translation>
    </message>
    <message>
        <source>Vessels of 3 mm and more crossed</source>
        <translation>Gekreuzte Gefäße ab 3 mm</translation>
    </message>
    <message>
        <source>%1 mL</source>
        <translation>%1 mL</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 Stellen</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>angeschnitten</translation>
    </message>
    <message>
        <source>left</source>
        <translation>belassen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>%1 cannot be written; check the folder.</source>
        <translation>%1 kann nicht geschrieben werden; prüfen Sie den Ordner.</translation>
    </message>
    <message>
        <source>The plan&apos;s numbers are still being computed; try again in a moment.</source>
        <translation>Die Zahlen des Plans werden noch berechnet; versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Territory %1</source>
        <translation>Territorium %1</translation>
    </message>
    <message>
        <source>accept %1</source>
        <translation>%1 freigeben</translation>
    </message>
    <message>
        <source>withdraw the acceptance of %1</source>
        <translation>Freigabe zurücknehmen: %1</translation>
    </message>
    <message>
        <source>Who accepts a structure needs a name of one line, at most 200 bytes long; type it again.</source>
        <translation>Wer eine Struktur freigibt, braucht einen Namen in einer Zeile, höchstens 200 Byte lang; geben Sie ihn noch einmal ein.</translation>
    </message>
    <message>
        <source>The time at which a structure was accepted is no time; accept it again.</source>
        <translation>Die Zeit, zu der eine Struktur freigegeben wurde, ist keine; geben Sie sie noch einmal frei.</translation>
    </message>
    <message>
        <source>%1 has no surface yet, so it cannot be accepted; reconstruct the model first.</source>
        <translation>%1 hat noch keine Oberfläche und kann deshalb nicht freigegeben werden; rekonstruieren Sie zuerst das Modell.</translation>
    </message>
    <message>
        <source>its patient cannot be read</source>
        <translation>die Angaben zum Patienten sind nicht lesbar</translation>
    </message>
    <message>
        <source>%1 is larger than 4 GiB and cannot be embedded in a case; send its files beside the case.</source>
        <translation>%1 ist größer als 4 GiB und kann nicht in einen Fall eingebettet werden; schicken Sie ihre Dateien neben dem Fall.</translation>
    </message>
    <message>
        <source>%1 holds an embedded CT that is damaged (%2) and not shown; the rest of the case is whole, ask for the file again to see the slices.</source>
        <translation>%1 enthält eine eingebettete CT, die beschädigt ist (%2) und nicht gezeigt wird; der übrige Fall ist unversehrt, lassen Sie sich die Datei noch einmal schicken, um die Schichten zu sehen.</translation>
    </message>
    <message>
        <source>its description cannot be read</source>
        <translation>ihre Beschreibung ist nicht lesbar</translation>
    </message>
    <message>
        <source>its size is impossible</source>
        <translation>ihre Größe ist unmöglich</translation>
    </message>
    <message>
        <source>it does not lie on the grid of the labels</source>
        <translation>sie liegt nicht auf dem Gitter der Labels</translation>
    </message>
    <message>
        <source>its voxels do not match their SHA-256</source>
        <translation>ihre Voxel passen nicht zu ihrer SHA-256</translation>
    </message>
    <message>
        <source>embedded in %1</source>
        <translation>eingebettet in %1</translation>
    </message>
    <message>
        <source>The case shows no CT that could be embedded; open it where its CT lies.</source>
        <translation>Der Fall zeigt keine CT, die eingebettet werden könnte; öffnen Sie ihn dort, wo seine CT liegt.</translation>
    </message>
    <message>
        <source>The CT at %1 is not the one this case was made from (its files have changed): the CT embedded in the case is shown.</source>
        <translation>Die CT unter %1 ist nicht die, aus der dieser Fall entstand (ihre Dateien wurden geändert): Gezeigt wird die in den Fall eingebettete CT.</translation>
    </message>
    <message>
        <source>The CT of this case is not at %1: the CT embedded in the case is shown.</source>
        <translation>Die CT dieses Falls liegt nicht unter %1: Gezeigt wird die in den Fall eingebettete CT.</translation>
    </message>
    <message>
        <source>%1 is the file this case is kept in; save the copy under another name.</source>
        <translation>%1 ist die Datei, in der dieser Fall liegt; speichern Sie die Kopie unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>The case holds neither name, id nor birth date of the patient; write the report without them.</source>
        <translation>Der Fall enthält weder Namen, ID noch Geburtsdatum des Patienten; schreiben Sie den Bericht ohne sie.</translation>
    </message>
    <message>
        <source>The branches marked earlier are not in this portal vein; left and right are proposed anew.</source>
        <translation>Die früher markierten Äste sind nicht in dieser Pfortader; links und rechts werden neu vorgeschlagen.</translation>
    </message>
    <message>
        <source>A territory needs a name and points that are finite numbers; point at its branches again.</source>
        <translation>Ein Territorium braucht einen Namen und Punkte mit endlichen Koordinaten; zeigen Sie erneut auf seine Äste.</translation>
    </message>
    <message>
        <source>its territories cannot be read</source>
        <translation>seine Territorien sind nicht lesbar</translation>
    </message>
    <message>
        <source>The plan holds a number that is not finite, a normal that is not of unit length or a bend that is none; place the plane again.</source>
        <translation>Der Plan enthält eine Zahl, die nicht endlich ist, eine Normale, die nicht die Länge eins hat, oder eine Biegung, die keine ist; setzen Sie die Ebene neu.</translation>
    </message>
    <message>
        <source>bend plane %1 of %2</source>
        <translation>Ebene %1 von %2 biegen</translation>
    </message>
    <message>
        <source>bend plane %1</source>
        <translation>Ebene %1 biegen</translation>
    </message>
    <message>
        <source>bend plane</source>
        <translation>Ebene biegen</translation>
    </message>
    <message>
        <source>flatten plane %1 of %2</source>
        <translation>Ebene %1 von %2 ebnen</translation>
    </message>
    <message>
        <source>flatten plane %1</source>
        <translation>Ebene %1 ebnen</translation>
    </message>
    <message>
        <source>flatten plane</source>
        <translation>Ebene ebnen</translation>
    </message>
    <message>
        <source>The plane has no bend; bend it first.</source>
        <translation>Die Ebene hat keine Biegung; biegen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>The plan has a bent plane, whose sides are no convex parts; flatten it first.</source>
        <translation>Der Plan hat eine gebogene Ebene, deren Seiten keine konvexen Teile sind; ebnen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>A bend needs an axis within the plane, a half size of 10 to 1000 mm and 16 heights of at most 1000 mm; bend the plane again.</source>
        <translation>Eine Biegung braucht eine Achse in der Ebene, eine halbe Größe von 10 bis 1000 mm und 16 Höhen von höchstens 1000 mm; biegen Sie die Ebene neu.</translation>
    </message>
    <message>
        <source>a plane&apos;s bend has not 16 heights</source>
        <translation>die Biegung einer Ebene hat nicht 16 Höhen</translation>
    </message>
    <message>
        <source>Plane %1 of %2 is bent in %3 only.</source>
        <translation>Ebene %1 von %2 ist nur in %3 gebogen.</translation>
    </message>
    <message>
        <source>Plane %1 of %2 is bent in another way in %3 than in %4.</source>
        <translation>Ebene %1 von %2 ist in %3 anders gebogen als in %4.</translation>
    </message>
    <message>
        <source>%1 holds an embedded CT that needs more memory than there is and is not shown; close other programs, then open the case again.</source>
        <translation>%1 enthält eine eingebettete CT, die mehr Speicher braucht, als vorhanden ist, und nicht gezeigt wird; schließen Sie andere Programme und öffnen Sie den Fall erneut.</translation>
    </message>
    <message>
        <source>The CT at %1 cannot be read: the CT embedded in the case is shown.</source>
        <translation>Die CT unter %1 ist nicht lesbar: Gezeigt wird die in den Fall eingebettete CT.</translation>
    </message>
    <message>
        <source>A case holds at most 100 territories of at most 100 points each; point at fewer branches.</source>
        <translation>Ein Fall enthält höchstens 100 Territorien mit je höchstens 100 Punkten; zeigen Sie auf weniger Äste.</translation>
    </message>
    <message>
        <source>A rater needs a name; enter one.</source>
        <translation>Ein Gutachter braucht einen Namen; geben Sie einen ein.</translation>
    </message>
    <message>
        <source>There is a rater &quot;%1&quot; already; enter another name.</source>
        <translation>Es gibt schon einen Gutachter „%1“; geben Sie einen anderen Namen ein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no session of a blind rating (line %2 %3); choose a CSV file that a rating was kept in.</source>
        <translation>„%1“ ist keine Sitzung einer blinden Beurteilung (Zeile %2 %3); wählen Sie eine CSV-Datei, in der eine Beurteilung gesichert wurde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no session of a blind rating (its quotes are not closed); choose a CSV file that a rating was kept in.</source>
        <translation>„%1“ ist keine Sitzung einer blinden Beurteilung (Anführungszeichen sind nicht geschlossen); wählen Sie eine CSV-Datei, in der eine Beurteilung gesichert wurde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; rates other models than these; open the case and the structure that it was begun with.</source>
        <translation>„%1“ beurteilt andere Modelle als diese; öffnen Sie den Fall und die Struktur, mit denen die Sitzung begann.</translation>
    </message>
    <message>
        <source>starts a rater whose name is missing or was there before</source>
        <translation>beginnt einen Gutachter, dessen Name fehlt oder schon vorkam</translation>
    </message>
    <message>
        <source>does not name its columns</source>
        <translation>nennt die Spalten nicht</translation>
    </message>
    <message>
        <source>has another number of cells</source>
        <translation>hat eine andere Zahl von Zellen</translation>
    </message>
    <message>
        <source>holds no such number as %1</source>
        <translation>enthält keine solche Zahl wie %1</translation>
    </message>
    <message>
        <source>names no model, or one that was there before</source>
        <translation>nennt kein Modell oder eines, das schon vorkam</translation>
    </message>
    <message>
        <source>starts a rater without models</source>
        <translation>beginnt einen Gutachter ohne Modelle</translation>
    </message>
    <message>
        <source>is missing, or is another rater&apos;s</source>
        <translation>fehlt oder gehört einem anderen Gutachter</translation>
    </message>
    <message>
        <source>holds a rating outside 1 to 5, or no time beside it</source>
        <translation>enthält ein Urteil außerhalb von 1 bis 5 oder keine Zeit daneben</translation>
    </message>
    <message>
        <source>holds a rating behind a model that was not rated</source>
        <translation>enthält ein Urteil hinter einem Modell, das nicht beurteilt wurde</translation>
    </message>
    <message>
        <source>differs from the lines before in %1</source>
        <translation>weicht von den Zeilen davor ab in %1</translation>
    </message>
    <message>
        <source>does not hold the model that its seed gives</source>
        <translation>enthält nicht das Modell, das der Startwert (seed) ergibt</translation>
    </message>
    <message>
        <source>There is no reconstruction method &quot;%1&quot;; choose psr, mcsd, %2.</source>
        <translation>Es gibt kein Rekonstruktionsverfahren &quot;%1&quot;; psr, mcsd, %2 wählen.</translation>
    </message>
    <message>
        <source>The method %1 has no variant &quot;%2&quot;; choose %3.</source>
        <translation>Das Verfahren %1 hat keine Variante &quot;%2&quot;; %3 wählen.</translation>
    </message>
    <message>
        <source>PSR, k-NN normals</source>
        <translation>PSR mit k-NN-Normalen</translation>
    </message>
    <message>
        <source>PSR, k-NN normals d=%1</source>
        <translation>PSR mit k-NN-Normalen d=%1</translation>
    </message>
    <message>
        <source>Poisson reconstruction with normals from planes fitted to the 10 (or 40) nearest boundary samples, turned outward by the mask.</source>
        <translation>Poisson-Rekonstruktion mit Normalen aus Ebenen durch die 10 (oder 40) nächsten Randpunkte, von der Maske nach außen gerichtet.</translation>
    </message>
    <message>
        <source>MPU implicits</source>
        <translation>MPU-Implizitflächen</translation>
    </message>
    <message>
        <source>MPU implicits eps=%1</source>
        <translation>MPU-Implizitflächen eps=%1</translation>
    </message>
    <message>
        <source>MPU implicits eps=%1 d=%2</source>
        <translation>MPU-Implizitflächen eps=%1 d=%2</translation>
    </message>
    <message>
        <source>Quadrics fitted in the cells of an octree until they are within a tolerance of the boundary samples, and blended.</source>
        <translation>Quadriken in den Zellen eines Octrees, bis sie die Randpunkte innerhalb einer Toleranz treffen, stetig überblendet.</translation>
    </message>
    <message>
        <source>Scale-adaptive PSR</source>
        <translation>Skalenadaptive PSR</translation>
    </message>
    <message>
        <source>Scale-adaptive PSR %1 voxel</source>
        <translation>Skalenadaptive PSR %1 Voxel</translation>
    </message>
    <message>
        <source>Screened Poisson reconstruction of unbiased samples with cells of 0.8 voxels, then triangles sized by the local curvature.</source>
        <translation>Poisson-Rekonstruktion mit Punktgewicht aus unverzerrten Punkten mit Zellen von 0,8 Voxeln, dann Dreiecke in der Größe, die die Krümmung zulässt.</translation>
    </message>
    <message>
        <source>PSR, k-NN normals d=%1 k=%2</source>
        <translation>PSR mit k-NN-Normalen d=%1 k=%2</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>The piece at (%1, %2, %3) mm is given to the other side, but on the surface it hangs together with the rest: give it back, or move the plane, then export again.</source>
        <translation>Das Stück bei (%1, %2, %3) mm ist der anderen Seite gegeben, hängt auf der Oberfläche aber mit dem Übrigen zusammen: Geben Sie es zurück oder verschieben Sie die Ebene und exportieren Sie erneut.</translation>
    </message>
    <message>
        <source>an edit of structures has not the same ones before and after</source>
        <translation>eine Bearbeitung von Strukturen hat vorher und nachher nicht dieselben</translation>
    </message>
    <message>
        <source>%1 lacks a rescale slope or intercept that its series has, so its Hounsfield units would be wrong; copy or export the series again.</source>
        <translation>%1 fehlt eine Steigung oder ein Achsenabschnitt zum Umrechnen, die seine Serie hat, sodass die Hounsfield-Einheiten falsch wären; kopieren oder exportieren Sie die Serie erneut.</translation>
    </message>
    <message>
        <source>Labels of another patient than the CT&apos;s were taken with consent (their %1 differ).</source>
        <translation>Labels eines anderen Patienten als dem der CT wurden mit Zustimmung übernommen (verschieden: %1).</translation>
    </message>
    <message>
        <source>Labels of another frame of reference than the CT&apos;s were taken with consent (their %1 differ).</source>
        <translation>Labels eines anderen Bezugssystems als dem der CT wurden mit Zustimmung übernommen (verschieden: %1).</translation>
    </message>
    <message>
        <source>The CT at %1 is not the one this case was made from (its files have changed): its slices are not shown; put the files of then back to see them.</source>
        <translation>Die CT unter %1 ist nicht die, aus der dieser Fall entstand (ihre Dateien wurden geändert): Ihre Schichten werden nicht gezeigt; legen Sie die damaligen Dateien zurück, um sie zu sehen.</translation>
    </message>
    <message>
        <source>The labels lie on a part of the CT&apos;s grid (%1 of its voxels).</source>
        <translation>Die Labels liegen auf einem Teil des Gitters der CT (%1 ihrer Voxel).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; reaches the border of the labels&apos; grid and may be cut off there.</source>
        <translation>„%1“ reicht bis an den Rand des Gitters der Labels und ist dort vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>A note that names the patient is left out.</source>
        <translation>Eine Anmerkung, die den Patienten nennt, ist weggelassen.</translation>
    </message>
    <message>
        <source>%1 is open in another program or write-protected: changes are kept in a copy of it; save that under another name.</source>
        <translation>%1 ist in einem anderen Programm geöffnet oder schreibgeschützt: Änderungen werden in einer Kopie aufbewahrt; speichern Sie diese unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>The change is in no file: save the case under another name.</source>
        <translation>Die Änderung steht in keiner Datei: speichern Sie den Fall unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>There is not enough memory for this model; close other programs and try again.</source>
        <translation>Für dieses Modell reicht der Speicher nicht; schließen Sie andere Programme und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>Not read as a mask: %1, a CT beside the masks.</source>
        <translation>Nicht als Maske gelesen: %1, eine CT neben den Masken.</translation>
    </message>
    <message>
        <source>not simplified: only a closed manifold surface can be</source>
        <translation>nicht vereinfacht: Das geht nur bei einer geschlossenen, mannigfaltigen Oberfläche</translation>
    </message>
    <message>
        <source>Margins know the voxel size only; segmentation, breathing, registration and transection are not included.</source>
        <translation>Abstände berücksichtigen nur die Voxelgröße; Segmentierung, Atmung, Registrierung und Durchtrennung sind nicht enthalten.</translation>
    </message>
    <message>
        <source>%1 takes nothing: other resections of the plan already take all that it would.</source>
        <translation>%1 nimmt nichts: Andere Resektionen des Plans nehmen schon alles, was sie nähme.</translation>
    </message>
    <message>
        <source>The resections of the plan together take all of the liver, so nothing of it remains.</source>
        <translation>Die Resektionen des Plans nehmen zusammen die ganze Leber, sodass nichts von ihr bleibt.</translation>
    </message>
    <message>
        <source>The plane around %1 keeps at least %2 mm, takes by itself %3 mL of functional liver and crosses %4 vessels of 3 mm and more.</source>
        <translation>Die Ebene um %1 hält mindestens %2 mm Abstand, nimmt für sich allein %3 mL funktionelle Leber und kreuzt %4 Gefäße ab 3 mm.</translation>
    </message>
    <message>
        <source>It crosses %1, %2 mm wide.</source>
        <translation>Sie kreuzt %1, %2 mm weit.</translation>
    </message>
    <message>
        <source>It cuts along %1, %2 mm wide.</source>
        <translation>Sie schneidet längs an %1 entlang, %2 mm weit.</translation>
    </message>
    <message>
        <source>The plan has changed while the plane around %1 was sought, so it is not placed; ask for it again.</source>
        <translation>Der Plan hat sich geändert, während die Ebene um %1 gesucht wurde, deshalb wird sie nicht gesetzt; fordern Sie sie neu an.</translation>
    </message>
    <message>
        <source>not picked</source>
        <translation>nicht gewählt</translation>
    </message>
    <message>
        <source>no triangle can be spared within %1 mm</source>
        <translation>innerhalb von %1 mm ist kein Dreieck zu entbehren</translation>
    </message>
    <message>
        <source>A map of segments needs its path, and no branches beside it; choose the map again.</source>
        <translation>Eine Segmentkarte braucht ihren Pfad und keine Äste daneben; wählen Sie die Karte neu.</translation>
    </message>
    <message>
        <source>A flat plane is the same however it is turned about its normal; bend it first.</source>
        <translation>Eine flache Ebene bleibt dieselbe, wie man sie auch um ihre Normale dreht; biegen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>spin plane %1 of %2</source>
        <translation>Ebene %1 von %2 um die Normale drehen</translation>
    </message>
    <message>
        <source>spin plane %1</source>
        <translation>Ebene %1 um die Normale drehen</translation>
    </message>
    <message>
        <source>spin plane</source>
        <translation>Ebene um die Normale drehen</translation>
    </message>
    <message>
        <source>The map of segments at %1 does not say any more what it said when it was chosen; choose it again.</source>
        <translation>Die Segmentkarte unter %1 sagt nicht mehr, was sie bei der Wahl sagte; wählen Sie sie neu.</translation>
    </message>
</context>
<context>
    <name>StructureKind</name>
    <message>
        <source>Parenchyma</source>
        <translation>Parenchym</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Hohlvene</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Arterie</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Cyst</source>
        <translation>Zyste</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>Not part of the liver model</source>
        <translation>Nicht Teil des Lebermodells</translation>
    </message>
</context>
<context>
    <name>glisson::AcceptanceBox</name>
    <message>
        <source>Accept</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Accept as...</source>
        <translation>Freigeben als...</translation>
    </message>
    <message>
        <source>Accept all that nobody has accepted</source>
        <translation>Alle freigeben, die niemand freigegeben hat</translation>
    </message>
    <message>
        <source>Withdraw acceptance</source>
        <translation>Freigabe zurücknehmen</translation>
    </message>
    <message>
        <source>Select a structure in the list first.</source>
        <translation>Wählen Sie zuerst eine Struktur in der Liste.</translation>
    </message>
    <message>
        <source>It has no surface yet.</source>
        <translation>Sie hat noch keine Oberfläche.</translation>
    </message>
    <message>
        <source>Your name. It stands beside what you accept, in the case, the report and the package:</source>
        <translation>Ihr Name. Er steht bei dem, was Sie freigeben, im Fall, im Bericht und im Paket:</translation>
    </message>
    <message>
        <source>Accepted by %1, %2</source>
        <translation>Freigegeben von %1, %2</translation>
    </message>
    <message>
        <source>Nobody has accepted it yet.</source>
        <translation>Noch von niemandem freigegeben.</translation>
    </message>
</context>
<context>
    <name>glisson::CaseOpener</name>
    <message>
        <source>Making the sample patient</source>
        <translation>Beispielpatient entsteht</translation>
    </message>
    <message>
        <source>Reading files</source>
        <translation>Dateien werden gelesen</translation>
    </message>
    <message>
        <source>Choose the segmentation of the CT</source>
        <translation>Segmentierung der CT wählen</translation>
    </message>
    <message>
        <source>The segmentation of this CT</source>
        <translation>Die Segmentierung dieser CT</translation>
    </message>
    <message>
        <source>A CT alone makes no model. Choose the file or the folder that holds its segmentation.</source>
        <translation>Aus einer CT allein wird kein Modell. Wählen Sie die Datei oder den Ordner mit ihrer Segmentierung.</translation>
    </message>
    <message>
        <source>A file...</source>
        <translation>Eine Datei...</translation>
    </message>
    <message>
        <source>A folder...</source>
        <translation>Ein Ordner...</translation>
    </message>
</context>
<context>
    <name>glisson::CasePanel</name>
    <message>
        <source>Open files...</source>
        <translation>Dateien öffnen...</translation>
    </message>
    <message>
        <source>A CT with its segmentation, or a case (Ctrl+O)</source>
        <translation>Eine CT mit ihrer Segmentierung oder ein Fall (Strg+O)</translation>
    </message>
    <message>
        <source>Which label is what</source>
        <translation>Welches Label was ist</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>CT: %1</source>
        <translation>CT: %1</translation>
    </message>
    <message>
        <source>No CT is shown.</source>
        <translation>Es wird keine CT gezeigt.</translation>
    </message>
    <message>
        <source>Labels: %1</source>
        <translation>Labels: %1</translation>
    </message>
    <message>
        <source>Grid: %1 x %2 x %3 voxels of %4 x %5 x %6 mm</source>
        <translation>Gitter: %1 x %2 x %3 Voxel zu %4 x %5 x %6 mm</translation>
    </message>
    <message>
        <source>Nothing is loaded.</source>
        <translation>Nichts geladen.</translation>
    </message>
    <message>
        <source>%1 deviates: %2</source>
        <translation>%1 weicht ab: %2</translation>
    </message>
    <message>
        <source>Problems and notes: %1</source>
        <translation>Probleme und Hinweise: %1</translation>
    </message>
</context>
<context>
    <name>glisson::CompareWindow</name>
    <message>
        <source>Resections</source>
        <translation>Resektionen</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Safety margin</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Resected</source>
        <translation>Reseziert</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Functional remnant (FLR)</source>
        <translation>Funktioneller Rest (FLR)</translation>
    </message>
    <message>
        <source>FLR of the functional liver</source>
        <translation>FLR der funktionellen Leber</translation>
    </message>
    <message>
        <source>Area of the cut</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>Tumours removed</source>
        <translation>Tumoren entfernt</translation>
    </message>
    <message>
        <source>Tumours cut</source>
        <translation>Tumoren angeschnitten</translation>
    </message>
    <message>
        <source>Tumours left</source>
        <translation>Tumoren belassen</translation>
    </message>
    <message>
        <source>Least margin, at least</source>
        <translation>Kleinster Abstand, mindestens</translation>
    </message>
    <message>
        <source>Vessels of 3 mm and more crossed</source>
        <translation>Gekreuzte Gefäße ab 3 mm</translation>
    </message>
    <message>
        <source>Compare plans</source>
        <translation>Pläne vergleichen</translation>
    </message>
    <message>
        <source>Plans compared</source>
        <translation>Verglichene Pläne</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Two to four plans are compared.</source>
        <translation>Zwei bis vier Pläne werden verglichen.</translation>
    </message>
    <message>
        <source>Out of date until the plane rests</source>
        <translation>Veraltet, bis die Ebene ruht</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größter</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>kleinster</translation>
    </message>
</context>
<context>
    <name>glisson::Document</name>
    <message>
        <source>place plane</source>
        <translation>Ebene setzen</translation>
    </message>
    <message>
        <source>new plan</source>
        <translation>neuer Plan</translation>
    </message>
    <message>
        <source>duplicate plan</source>
        <translation>Plan duplizieren</translation>
    </message>
    <message>
        <source>rename plan</source>
        <translation>Plan umbenennen</translation>
    </message>
    <message>
        <source>delete plan</source>
        <translation>Plan löschen</translation>
    </message>
    <message>
        <source>change patient facts</source>
        <translation>Angaben zum Patienten ändern</translation>
    </message>
    <message>
        <source>change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumina</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Numbers of all plans</source>
        <translation>Zahlen aller Pläne</translation>
    </message>
    <message>
        <source>edit plans</source>
        <translation>Pläne bearbeiten</translation>
    </message>
    <message>
        <source>accept structures</source>
        <translation>Strukturen freigeben</translation>
    </message>
    <message>
        <source>Saving a copy with the CT</source>
        <translation>Kopie mit der CT speichern</translation>
    </message>
    <message>
        <source>propose territories</source>
        <translation>Territorien vorschlagen</translation>
    </message>
    <message>
        <source>confirm territories</source>
        <translation>Territorien bestätigen</translation>
    </message>
    <message>
        <source>pick territory</source>
        <translation>Territorium wählen</translation>
    </message>
    <message>
        <source>change territories</source>
        <translation>Territorien ändern</translation>
    </message>
    <message>
        <source>edit structures</source>
        <translation>Strukturen bearbeiten</translation>
    </message>
    <message>
        <source>choose map of segments</source>
        <translation>Segmentkarte wählen</translation>
    </message>
</context>
<context>
    <name>glisson::ErrorLegend</name>
    <message>
        <source>Distance from the surface&apos;s vertices to the mask&apos;s surface (its level set of 0.5). Larger ones have the last colour.</source>
        <translation>Abstand der Eckpunkte der Oberfläche zur Oberfläche der Maske (Niveaufläche 0,5). Größere haben die letzte Farbe.</translation>
    </message>
    <message>
        <source>distance to the voxels</source>
        <translation>Abstand zu den Voxeln</translation>
    </message>
</context>
<context>
    <name>glisson::ExportPanel</name>
    <message>
        <source>Export package...</source>
        <translation>Paket exportieren...</translation>
    </message>
    <message>
        <source>A folder for navigation: the structures, the remnant, the resected part and the resection surface, with plan.json and a manifest. Every file is read back and compared before it counts as exported. Millimetres, LPS.</source>
        <translation>Ein Ordner für die Navigation: die Strukturen, der Rest, der Resektatteil und die Resektionsfläche, mit plan.json und einem Verzeichnis. Jede Datei wird zurückgelesen und verglichen, bevor sie als exportiert gilt. Millimeter, LPS.</translation>
    </message>
    <message>
        <source>STL, one file per structure</source>
        <translation>STL, eine Datei je Struktur</translation>
    </message>
    <message>
        <source>GLB, one file with colours</source>
        <translation>GLB, eine Datei mit Farben</translation>
    </message>
    <message>
        <source>Write the patient&apos;s id into plan.json</source>
        <translation>Patienten-ID in plan.json schreiben</translation>
    </message>
    <message>
        <source>Otherwise nothing in the package names the patient.</source>
        <translation>Sonst nennt nichts im Paket den Patienten.</translation>
    </message>
    <message>
        <source>Writes the navigation package (Ctrl+E)</source>
        <translation>Schreibt das Navigationspaket (Strg+E)</translation>
    </message>
    <message>
        <source>These structures deviate from their voxels; you will be asked before they are exported:</source>
        <translation>Diese Strukturen weichen von ihren Voxeln ab; vor dem Export werden Sie gefragt:</translation>
    </message>
    <message>
        <source>Exported and verified: %1</source>
        <translation>Exportiert und geprüft: %1</translation>
    </message>
    <message>
        <source>Folder for the package</source>
        <translation>Ordner für das Paket</translation>
    </message>
    <message>
        <source>Structures deviate</source>
        <translation>Strukturen weichen ab</translation>
    </message>
    <message>
        <source>The surfaces of these structures differ from their voxels more than they should. A navigation system would show them as they are.</source>
        <translation>Die Oberflächen dieser Strukturen weichen stärker von ihren Voxeln ab, als sie sollten. Ein Navigationssystem würde sie so zeigen.</translation>
    </message>
    <message>
        <source>Export all the same</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Out of date, exported before the last change: %1</source>
        <translation>Veraltet, vor der letzten Änderung exportiert: %1</translation>
    </message>
    <message>
        <source>not exported</source>
        <translation>nicht exportiert</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>exportiert</translation>
    </message>
    <message>
        <source>Nobody has accepted these structures; the package says so: %1</source>
        <translation>Niemand hat diese Strukturen freigegeben; das Paket sagt es: %1</translation>
    </message>
    <message>
        <source>Plan: %1</source>
        <translation>Plan: %1</translation>
    </message>
</context>
<context>
    <name>glisson::FlrCardBox</name>
    <message>
        <source>FLR card</source>
        <translation>FLR-Karte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>over 3 months of chemotherapy</source>
        <translation>über 3 Monate Chemotherapie</translation>
    </message>
    <message>
        <source>injured</source>
        <translation>geschädigt</translation>
    </message>
    <message>
        <source>colorectal metastases</source>
        <translation>kolorektale Metastasen</translation>
    </message>
    <message>
        <source>hepatocellular carcinoma</source>
        <translation>hepatozelluläres Karzinom</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>computing</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <source>Body surface</source>
        <translation>Körperoberfläche</translation>
    </message>
    <message>
        <source>Mosteller</source>
        <translation>Mosteller</translation>
    </message>
    <message>
        <source>SLV</source>
        <translation>SLV</translation>
    </message>
    <message>
        <source>Urata</source>
        <translation>Urata</translation>
    </message>
    <message>
        <source>Vauthey</source>
        <translation>Vauthey</translation>
    </message>
    <message>
        <source>Margin %1: %2 (%3)</source>
        <translation>Abstand %1: %2 (%3)</translation>
    </message>
    <message>
        <source>Published numbers for information, not advice.</source>
        <translation>Veröffentlichte Zahlen zur Information, keine Empfehlung.</translation>
    </message>
    <message>
        <source>FLR of the functional liver</source>
        <translation>FLR der funktionellen Leber</translation>
    </message>
    <message>
        <source>FLR of SLV (Urata)</source>
        <translation>FLR des SLV (Urata)</translation>
    </message>
    <message>
        <source>FLR of SLV (Vauthey)</source>
        <translation>FLR des SLV (Vauthey)</translation>
    </message>
    <message>
        <source>FLR per body surface</source>
        <translation>FLR je Körperoberfläche</translation>
    </message>
    <message>
        <source>FLR of the body weight</source>
        <translation>FLR des Körpergewichts</translation>
    </message>
</context>
<context>
    <name>glisson::IslandBox</name>
    <message>
        <source>Separated pieces</source>
        <translation>Abgetrennte Stücke</translation>
    </message>
    <message>
        <source>Give to the other side</source>
        <translation>Der anderen Seite geben</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Out of date until the plane rests</source>
        <translation>Veraltet, bis die Ebene ruht</translation>
    </message>
    <message>
        <source>of the resected side</source>
        <translation>des Resektats</translation>
    </message>
    <message>
        <source>of the remnant</source>
        <translation>des Rests</translation>
    </message>
    <message>
        <source>%1 of functional liver; a marked piece counts on the other side</source>
        <translation>%1 funktionelle Leber; ein markiertes Stück zählt zur anderen Seite</translation>
    </message>
</context>
<context>
    <name>glisson::JobBar</name>
    <message>
        <source>Shows what waits, each with its Cancel</source>
        <translation>Zeigt, was wartet, jedes mit eigenem Abbrechen</translation>
    </message>
    <message>
        <source>Cancel all</source>
        <translation>Alle abbrechen</translation>
    </message>
    <message>
        <source>3D: left turns, middle pans, right zooms</source>
        <translation>3D: links dreht, Mitte schiebt, rechts zoomt</translation>
    </message>
    <message>
        <source>Slices: wheel steps, left click places the crosshair, right zooms, middle pans, Ctrl+right changes the window</source>
        <translation>Schichten: Rad blättert, Linksklick setzt das Fadenkreuz, rechts zoomt, Mitte schiebt, Strg+rechts ändert das Fenster</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht zur klinischen Anwendung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 warten</translation>
    </message>
</context>
<context>
    <name>glisson::LabPlot</name>
    <message>
        <source>triangles (logarithmic)</source>
        <translation>Dreiecke (logarithmisch)</translation>
    </message>
    <message>
        <source>mean paper error (mm)</source>
        <translation>mittlerer Fehler wie publiziert (mm)</translation>
    </message>
    <message>
        <source>front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>front of simplified PSR</source>
        <translation>Front der vereinfachten PSR</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>mean paper error %1 mm</source>
        <translation>mittlerer Fehler wie publiziert %1 mm</translation>
    </message>
    <message>
        <source>score %1</source>
        <translation>Bewertung %1</translation>
    </message>
    <message>
        <source>on the front</source>
        <translation>auf der Front</translation>
    </message>
    <message>
        <source>slider&apos;s model, not scored</source>
        <translation>Modell des Reglers, nicht bewertet</translation>
    </message>
    <message>
        <source>of the slider: no part of scores and fronts</source>
        <translation>vom Regler: nicht Teil von Bewertungen und Fronten</translation>
    </message>
    <message>
        <source>front so far</source>
        <translation>Front bisher</translation>
    </message>
</context>
<context>
    <name>glisson::LabSetup</name>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>PSR is given</source>
        <translation>PSR erhält</translation>
    </message>
    <message>
        <source>samples as published</source>
        <translation>Punkte wie publiziert</translation>
    </message>
    <message>
        <source>unbiased samples</source>
        <translation>unverzerrte Punkte</translation>
    </message>
    <message>
        <source>As published, samples are voxel centres, half a voxel inside; unbiased ones lie on the voxels&apos; faces.</source>
        <translation>Wie publiziert sind die Punkte Voxelmitten, einen halben Voxel innen; unverzerrte liegen auf den Flächen der Voxel.</translation>
    </message>
    <message>
        <source>a cube of 1.1</source>
        <translation>einen Würfel von 1,1</translation>
    </message>
    <message>
        <source>a cube of 1.25</source>
        <translation>einen Würfel von 1,25</translation>
    </message>
    <message>
        <source>The cube that PSR solves in, in sizes of the structure; the authors&apos; base code has 1.25.</source>
        <translation>Der Würfel, in dem PSR löst, in Größen der Struktur; der Code, von dem die Autoren ausgingen, hat 1,25.</translation>
    </message>
    <message>
        <source>Compare methods</source>
        <translation>Verfahren vergleichen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The PSR model of this depth is made and shown at once.</source>
        <translation>Das PSR-Modell dieser Tiefe wird sofort erzeugt und gezeigt.</translation>
    </message>
    <message>
        <source>The slider&apos;s model becomes A.</source>
        <translation>Das Modell des Reglers wird A.</translation>
    </message>
    <message>
        <source>The slider&apos;s model becomes B.</source>
        <translation>Das Modell des Reglers wird B.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Table as CSV...</source>
        <translation>Tabelle als CSV ...</translation>
    </message>
    <message>
        <source>Plot PNG...</source>
        <translation>Bild PNG ...</translation>
    </message>
    <message>
        <source>Plot SVG...</source>
        <translation>Bild SVG ...</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Zuerst einen Fall öffnen.</translation>
    </message>
    <message>
        <source>The methods are being compared.</source>
        <translation>Die Verfahren werden gerade verglichen.</translation>
    </message>
    <message>
        <source>Choose a method.</source>
        <translation>Ein Verfahren wählen.</translation>
    </message>
    <message>
        <source>Every model of these methods is there.</source>
        <translation>Alle Modelle dieser Verfahren sind da.</translation>
    </message>
    <message>
        <source>Makes and measures the models that are missing; each appears as soon as it is done.</source>
        <translation>Erzeugt und vermisst die fehlenden Modelle; jedes erscheint, sobald es fertig ist.</translation>
    </message>
    <message>
        <source>Models that are done stay.</source>
        <translation>Fertige Modelle bleiben.</translation>
    </message>
    <message>
        <source>Nothing is being compared.</source>
        <translation>Es wird nichts verglichen.</translation>
    </message>
    <message>
        <source>%1 of %2 models</source>
        <translation>%1 von %2 Modellen</translation>
    </message>
    <message>
        <source>%1 could not be made (see the table)</source>
        <translation>%1 nicht erzeugt (siehe Tabelle)</translation>
    </message>
    <message>
        <source>PSR depth %1, shown as</source>
        <translation>PSR-Tiefe %1, gezeigt als</translation>
    </message>
    <message>
        <source>There are no models yet.</source>
        <translation>Es gibt noch keine Modelle.</translation>
    </message>
    <message>
        <source>The plot as a picture</source>
        <translation>Das Diagramm als Bild</translation>
    </message>
    <message>
        <source>Every measure of every model</source>
        <translation>Alle Maße aller Modelle</translation>
    </message>
    <message>
        <source>Blind rating...</source>
        <translation>Blinde Beurteilung...</translation>
    </message>
    <message>
        <source>Makes models of this structure by PSR and MCSD and shows them to raters one at a time, without names.</source>
        <translation>Erzeugt Modelle dieser Struktur mit PSR und MCSD und zeigt sie einzeln und ohne Namen zur Beurteilung.</translation>
    </message>
    <message>
        <source>Shows the best PSR, the best MCSD and the MCSD most similar to that PSR to raters one at a time, without names.</source>
        <translation>Zeigt die beste PSR, die beste MCSD und die dieser PSR ähnlichste MCSD nacheinander und ohne Namen zur Bewertung.</translation>
    </message>
</context>
<context>
    <name>glisson::LabSide</name>
    <message>
        <source>%1, distances</source>
        <translation>%1, Abstände</translation>
    </message>
    <message>
        <source>%1, numbers</source>
        <translation>%1, Zahlen</translation>
    </message>
</context>
<context>
    <name>glisson::LabTable</name>
    <message>
        <source>Filter: a text that any column holds</source>
        <translation>Filter: ein Text in irgendeiner Spalte</translation>
    </message>
    <message>
        <source>%1 of %2 models</source>
        <translation>%1 von %2 Modellen</translation>
    </message>
</context>
<context>
    <name>glisson::LabTableModel</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Defects</source>
        <translation>Defekte</translation>
    </message>
</context>
<context>
    <name>glisson::LabViews</name>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Wischen</translation>
    </message>
    <message>
        <source>One view: A left of the line, B right of it. Drag the line, or move it with the arrow keys.</source>
        <translation>Eine Ansicht: A links der Linie, B rechts. Die Linie ziehen oder mit den Pfeiltasten bewegen.</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Outlines of A, B and the voxels over the CT</source>
        <translation>Umrisse von A, B und den Voxeln über dem CT</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Slices show outlines; choose side by side or swipe.</source>
        <translation>Schichten zeigen Umrisse; Nebeneinander oder Wischen wählen.</translation>
    </message>
    <message>
        <source>click a model in the plot</source>
        <translation>ein Modell im Diagramm anklicken</translation>
    </message>
    <message>
        <source>click a model with Shift or the right button</source>
        <translation>ein Modell mit Umschalt oder der rechten Taste anklicken</translation>
    </message>
    <message>
        <source>%1 is being made ...</source>
        <translation>%1 wird erzeugt ...</translation>
    </message>
    <message>
        <source>Defects: %1</source>
        <translation>Defekte: %1</translation>
    </message>
    <message>
        <source>%1, its errors are being measured ...</source>
        <translation>%1, Fehler werden gemessen ...</translation>
    </message>
</context>
<context>
    <name>glisson::LabWorkspace</name>
    <message>
        <source>Comparing methods: %1</source>
        <translation>Vergleich der Verfahren: %1</translation>
    </message>
    <message>
        <source>Table as CSV</source>
        <translation>Tabelle als CSV</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Plot as PNG</source>
        <translation>Diagramm als PNG</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Plot as SVG</source>
        <translation>Diagramm als SVG</translation>
    </message>
    <message>
        <source>SVG (*.svg)</source>
        <translation>SVG (*.svg)</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>&quot;Compare methods&quot; makes the models of the chosen structure; each appears here as soon as it is measured. Click one to see it as A, click another with Shift or the right button to see it as B.</source>
        <translation>„Verfahren vergleichen“ erzeugt die Modelle der gewählten Struktur; jedes erscheint hier, sobald es vermessen ist. Ein Modell anklicken, um es als A zu sehen; ein weiteres mit Umschalt oder der rechten Taste, um es als B zu sehen.</translation>
    </message>
</context>
<context>
    <name>glisson::LabelDialog</name>
    <message>
        <source>Which label is what?</source>
        <translation>Welches Label ist was?</translation>
    </message>
    <message>
        <source>These labels carry no name Glisson knows. Choose what each one is; nothing is guessed.</source>
        <translation>Diese Labels tragen keinen Namen, den Glisson kennt. Wählen Sie, was jedes ist; geraten wird nichts.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Choose a kind for every label first.</source>
        <translation>Wählen Sie zuerst für jedes Label eine Art.</translation>
    </message>
    <message>
        <source>no table: chosen one by one</source>
        <translation>keine Tabelle: einzeln gewählt</translation>
    </message>
    <message>
        <source>All others: not part of the model</source>
        <translation>Alle anderen: nicht Teil des Modells</translation>
    </message>
    <message>
        <source>Numbers of</source>
        <translation>Nummern von</translation>
    </message>
</context>
<context>
    <name>glisson::MainActions</name>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Narrow liver</source>
        <translation>Leber, eng</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open files...</source>
        <translation>Dateien ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open &amp;folder...</source>
        <translation>&amp;Ordner öffnen...</translation>
    </message>
    <message>
        <source>Open the sample &amp;patient</source>
        <translation>&amp;Beispielpatient öffnen</translation>
    </message>
    <message>
        <source>&amp;Last cases</source>
        <translation>&amp;Letzte Fälle</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>&amp;Export package...</source>
        <translation>Paket &amp;exportieren...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
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
        <source>&amp;Structures</source>
        <translation>&amp;Strukturen</translation>
    </message>
    <message>
        <source>&amp;Workspace panel</source>
        <translation>&amp;Arbeitsbereich</translation>
    </message>
    <message>
        <source>&amp;Hide identity</source>
        <translation>&amp;Person verbergen</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>3D seen &amp;from</source>
        <translation>3D gesehen v&amp;on</translation>
    </message>
    <message>
        <source>Anterior (1)</source>
        <translation>Vorn (1)</translation>
    </message>
    <message>
        <source>Left (3)</source>
        <translation>Links (3)</translation>
    </message>
    <message>
        <source>Superior (7)</source>
        <translation>Oben (7)</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>&amp;CT window</source>
        <translation>&amp;CT-Fenster</translation>
    </message>
    <message>
        <source>&amp;Plane</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Place plane on the liver</source>
        <translation>Ebene auf die Leber &amp;setzen</translation>
    </message>
    <message>
        <source>Move 1 mm to the &amp;resected side</source>
        <translation>1 mm zur &amp;Resektatseite</translation>
    </message>
    <message>
        <source>Move 1 mm to the re&amp;mnant</source>
        <translation>1 mm zur Rest&amp;seite</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation>Nach &amp;oben drehen</translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation>Nach &amp;unten drehen</translation>
    </message>
    <message>
        <source>Remo&amp;ve plane</source>
        <translation>Ebene &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>&amp;Über Glisson</translation>
    </message>
    <message>
        <source>Place plane &amp;otherwise</source>
        <translation>Ebene anders &amp;setzen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>Place a plane first.</source>
        <translation>Setzen Sie zuerst eine Ebene.</translation>
    </message>
    <message>
        <source>&amp;Report as PDF...</source>
        <translation>&amp;Bericht als PDF...</translation>
    </message>
    <message>
        <source>Save a copy with the &amp;CT...</source>
        <translation>Kopie mit der &amp;CT speichern...</translation>
    </message>
    <message>
        <source>The case shows no CT.</source>
        <translation>Der Fall zeigt keine CT.</translation>
    </message>
    <message>
        <source>Report with the patient&apos;s &amp;name...</source>
        <translation>Bericht mit dem &amp;Namen des Patienten...</translation>
    </message>
    <message>
        <source>Name, id and birth date stand in it; otherwise the case&apos;s code alone stands for the patient.</source>
        <translation>Er enthält Namen, ID und Geburtsdatum; sonst steht allein der Code des Falls für den Patienten.</translation>
    </message>
    <message>
        <source>The case holds neither name, id nor birth date of the patient.</source>
        <translation>Der Fall enthält weder Namen, ID noch Geburtsdatum des Patienten.</translation>
    </message>
    <message>
        <source>&amp;Blind rating of models...</source>
        <translation>&amp;Blinde Beurteilung von Modellen...</translation>
    </message>
    <message>
        <source>&amp;Map of the cut</source>
        <translation>Schnitt&amp;karte</translation>
    </message>
    <message>
        <source>&amp;Spin about its normal</source>
        <translation>Um die &amp;Normale drehen</translation>
    </message>
    <message>
        <source>Spin &amp;back</source>
        <translation>Um die Normale &amp;zurückdrehen</translation>
    </message>
</context>
<context>
    <name>glisson::MainWindow</name>
    <message>
        <source>%1 is ready (%2 s).</source>
        <translation>%1 ist fertig (%2 s).</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Exported and verified: %1</source>
        <translation>Exportiert und geprüft: %1</translation>
    </message>
    <message>
        <source>Reading the CT</source>
        <translation>CT wird gelesen</translation>
    </message>
    <message>
        <source>%1 labels</source>
        <translation>%1 Labels</translation>
    </message>
    <message>
        <source>open one</source>
        <translation>öffnen</translation>
    </message>
    <message>
        <source>%1 of %2 made</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>plane placed</source>
        <translation>Ebene gesetzt</translation>
    </message>
    <message>
        <source>no plane yet</source>
        <translation>noch keine Ebene</translation>
    </message>
    <message>
        <source>Open a CT with its segmentation, or a case</source>
        <translation>Eine CT mit ihrer Segmentierung oder einen Fall öffnen</translation>
    </message>
    <message>
        <source>Images and cases (*.glisson *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm)</source>
        <translation>Bilder und Fälle (*.glisson *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a folder that holds a CT and its segmentation</source>
        <translation>Einen Ordner mit einer CT und ihrer Segmentierung öffnen</translation>
    </message>
    <message>
        <source>Save the case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>Glisson cases (*.glisson)</source>
        <translation>Glisson-Fälle (*.glisson)</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>Über Glisson</translation>
    </message>
    <message>
        <source>Glisson %1</source>
        <translation>Glisson %1</translation>
    </message>
    <message>
        <source>Planning of liver resections: the parenchyma by Poisson surface reconstruction, vessels and tumours by marching cubes.

Not for clinical use: this is no medical device. Check every number before you rely on it.</source>
        <translation>Planung von Leberresektionen: das Parenchym durch Poisson-Oberflächenrekonstruktion, Gefäße und Tumoren durch Marching Cubes.

Nicht zur klinischen Anwendung: Dies ist kein Medizinprodukt. Prüfen Sie jede Zahl, bevor Sie sich auf sie verlassen.</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Bericht als PDF</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Bericht geschrieben: %1</translation>
    </message>
    <message>
        <source>Saved with the CT: %1</source>
        <translation>Mit der CT gespeichert: %1</translation>
    </message>
    <message>
        <source>Save a copy with the CT</source>
        <translation>Kopie mit der CT speichern</translation>
    </message>
    <message>
        <source>The CT of %1 x %2 x %3 voxels adds about %4 MB to the copy.</source>
        <translation>Die CT mit %1 x %2 x %3 Voxeln macht die Kopie um etwa %4 MB größer.</translation>
    </message>
    <message>
        <source>Whoever gets the file sees the slices, and the patient&apos;s name, id and birth date where the case holds them.</source>
        <translation>Wer die Datei bekommt, sieht die Schichten und, wo der Fall sie enthält, Namen, ID und Geburtsdatum des Patienten.</translation>
    </message>
    <message>
        <source>Choose the file...</source>
        <translation>Datei wählen...</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>%1 is open already.</source>
        <translation>%1 ist bereits geöffnet.</translation>
    </message>
    <message>
        <source>Changes are not on disk</source>
        <translation>Änderungen sind nicht gespeichert</translation>
    </message>
    <message>
        <source>The last changes could not be written and go with the window.</source>
        <translation>Die letzten Änderungen konnten nicht geschrieben werden und gehen mit dem Fenster verloren.</translation>
    </message>
    <message>
        <source>Save under another name...</source>
        <translation>Unter anderem Namen speichern...</translation>
    </message>
    <message>
        <source>Close and lose them</source>
        <translation>Schließen und verwerfen</translation>
    </message>
</context>
<context>
    <name>glisson::MeasureBox</name>
    <message>
        <source>Click two points of the model in the 3D view; it can be turned in between. Escape ends.</source>
        <translation>Klicken Sie zwei Punkte des Modells in der 3D-Ansicht an; sie darf dazwischen gedreht werden. Escape beendet.</translation>
    </message>
    <message>
        <source>Measured distances</source>
        <translation>Gemessene Abstände</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Between two points clicked in the 3D view; kept in the plan and its report</source>
        <translation>Zwischen zwei Punkten, die in der 3D-Ansicht angeklickt werden; bleibt im Plan und seinem Bericht</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>Select a distance in the list first.</source>
        <translation>Wählen Sie zuerst einen Abstand in der Liste.</translation>
    </message>
</context>
<context>
    <name>glisson::MessageBar</name>
    <message>
        <source>Read (%1 more)</source>
        <translation>Gelesen (noch %1)</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Gelesen</translation>
    </message>
</context>
<context>
    <name>glisson::ModelPanel</name>
    <message>
        <source>Reconstruct model</source>
        <translation>Modell rekonstruieren</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>The structures are being reconstructed.</source>
        <translation>Die Strukturen werden rekonstruiert.</translation>
    </message>
    <message>
        <source>Every structure has its surface.</source>
        <translation>Jede Struktur hat ihre Oberfläche.</translation>
    </message>
    <message>
        <source>Makes the surfaces that are missing.</source>
        <translation>Erzeugt die fehlenden Oberflächen.</translation>
    </message>
    <message>
        <source>%1 of %2 structures have a surface.</source>
        <translation>%1 von %2 Strukturen haben eine Oberfläche.</translation>
    </message>
    <message>
        <source>Nothing is loaded.</source>
        <translation>Nichts geladen.</translation>
    </message>
</context>
<context>
    <name>glisson::ModelView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>resected</source>
        <translation>Resektat</translation>
    </message>
</context>
<context>
    <name>glisson::PlaceMenu</name>
    <message>
        <source>Through a clicked point, as seen</source>
        <translation>Durch einen angeklickten Punkt, in Blickrichtung</translation>
    </message>
    <message>
        <source>Through three clicked points</source>
        <translation>Durch drei angeklickte Punkte</translation>
    </message>
    <message>
        <source>Along a line drawn across the view</source>
        <translation>Entlang einer in der Ansicht gezogenen Linie</translation>
    </message>
    <message>
        <source>Axial, through the crosshair</source>
        <translation>Axial, durch das Fadenkreuz</translation>
    </message>
    <message>
        <source>Coronal, through the crosshair</source>
        <translation>Koronal, durch das Fadenkreuz</translation>
    </message>
    <message>
        <source>Sagittal, through the crosshair</source>
        <translation>Sagittal, durch das Fadenkreuz</translation>
    </message>
    <message>
        <source>Around a tumour, at the safety margin</source>
        <translation>Um einen Tumor, im Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>The case has no tumour.</source>
        <translation>Der Fall hat keinen Tumor.</translation>
    </message>
</context>
<context>
    <name>glisson::PlanBar</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Safety margin</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Edit the list of plans</source>
        <translation>Liste der Pläne bearbeiten</translation>
    </message>
    <message>
        <source>Add planes</source>
        <translation>Ebenen hinzufügen</translation>
    </message>
    <message>
        <source>New plan</source>
        <translation>Neuer Plan</translation>
    </message>
    <message>
        <source>Duplicate plan</source>
        <translation>Plan duplizieren</translation>
    </message>
    <message>
        <source>Rename plan...</source>
        <translation>Plan umbenennen...</translation>
    </message>
    <message>
        <source>Delete plan</source>
        <translation>Plan löschen</translation>
    </message>
    <message>
        <source>Add a resection</source>
        <translation>Resektion hinzufügen</translation>
    </message>
    <message>
        <source>Add a plane to this resection</source>
        <translation>Ebene zu dieser Resektion hinzufügen</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>Margins below it are shown in red; planes around a tumour are proposed for it</source>
        <translation>Kleinere Abstände erscheinen rot; Ebenen um einen Tumor werden für ihn vorgeschlagen</translation>
    </message>
    <message>
        <source>The plane that is shown with handles and moved</source>
        <translation>Die Ebene, die mit Griffen gezeigt und bewegt wird</translation>
    </message>
    <message>
        <source>Place a plane first.</source>
        <translation>Setzen Sie zuerst eine Ebene.</translation>
    </message>
    <message>
        <source>A case keeps at least one plan.</source>
        <translation>Ein Fall behält mindestens einen Plan.</translation>
    </message>
    <message>
        <source>%1, plane %2</source>
        <translation>%1, Ebene %2</translation>
    </message>
    <message>
        <source>Rename plan</source>
        <translation>Plan umbenennen</translation>
    </message>
    <message>
        <source>Name of the plan:</source>
        <translation>Name des Plans:</translation>
    </message>
    <message>
        <source>Compare plans...</source>
        <translation>Pläne vergleichen...</translation>
    </message>
    <message>
        <source>Duplicate this plan or make a new one first.</source>
        <translation>Duplizieren Sie erst diesen Plan oder legen Sie einen neuen an.</translation>
    </message>
</context>
<context>
    <name>glisson::PlanPanel</name>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>durchtrennt</translation>
    </message>
    <message>
        <source>left</source>
        <translation>belassen</translation>
    </message>
    <message>
        <source>FLR</source>
        <translation>FLR</translation>
    </message>
    <message>
        <source>Future liver remnant: functional liver left, and its share of the functional liver</source>
        <translation>Künftiger Leberrest (future liver remnant): verbleibende funktionelle Leber und ihr Anteil an der funktionellen Leber</translation>
    </message>
    <message>
        <source>RESECTED</source>
        <translation>RESEKTAT</translation>
    </message>
    <message>
        <source>Volume on the resected side, and its share of the whole liver</source>
        <translation>Volumen des Resektats und sein Anteil an der ganzen Leber</translation>
    </message>
    <message>
        <source>REMNANT</source>
        <translation>REST</translation>
    </message>
    <message>
        <source>Volume left, tumours in it included, and its share of the whole liver</source>
        <translation>Verbleibendes Volumen samt Tumoren darin und sein Anteil an der ganzen Leber</translation>
    </message>
    <message>
        <source>Tumours</source>
        <translation>Tumoren</translation>
    </message>
    <message>
        <source>Vessels crossed</source>
        <translation>Durchtrennte Gefäße</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>computing</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <source>MARGIN</source>
        <translation>ABSTAND</translation>
    </message>
    <message>
        <source>no plane</source>
        <translation>keine Ebene</translation>
    </message>
    <message>
        <source>no tumour</source>
        <translation>kein Tumor</translation>
    </message>
    <message>
        <source>MARGIN %1, %2</source>
        <translation>ABSTAND %1, %2</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>tumour is cut</source>
        <translation>Tumor durchtrennt</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>Out of date until the plane rests</source>
        <translation>Veraltet, bis die Ebene ruht</translation>
    </message>
    <message>
        <source>Vessels crossed: %1</source>
        <translation>Durchtrennte Gefäße: %1</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>The liver&apos;s volumes are being computed.</source>
        <translation>Die Volumina der Leber werden berechnet.</translation>
    </message>
    <message>
        <source>%1, at least %2</source>
        <translation>%1, mindestens %2</translation>
    </message>
    <message>
        <source>%1 from the cut; a tumour that is left has no margin</source>
        <translation>%1 vom Schnitt; ein belassener Tumor hat keinen Abstand</translation>
    </message>
    <message>
        <source>Margin, mm</source>
        <translation>Abstand, mm</translation>
    </message>
    <message>
        <source>Liver %1, functional %2</source>
        <translation>Leber %1, funktionell %2</translation>
    </message>
    <message>
        <source>the liver is not divided</source>
        <translation>Leber ungeteilt</translation>
    </message>
    <message>
        <source>TUMOURS, margin of the removed %1</source>
        <translation>TUMOREN, Abstand der entfernten %1</translation>
    </message>
    <message>
        <source>TUMOURS, none is removed</source>
        <translation>TUMOREN, keiner wird entfernt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>in the remnant</source>
        <translation>im Leberrest</translation>
    </message>
    <message>
        <source>Tumours in the remnant, which have no margin: %1</source>
        <translation>Tumoren im Leberrest, ohne Abstand: %1</translation>
    </message>
    <message>
        <source>is cut, %1 left</source>
        <translation>durchtrennt, %1 belassen</translation>
    </message>
    <message>
        <source>%1 tumours are cut</source>
        <translation>%1 Tumoren durchtrennt</translation>
    </message>
    <message>
        <source>Vessels crossed: -, %1</source>
        <translation>Durchtrennte Gefäße: -, %1</translation>
    </message>
    <message>
        <source>%1, along the cut</source>
        <translation>%1, längs des Schnitts</translation>
    </message>
    <message>
        <source>Resection</source>
        <translation>Resektion</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>As the planes leave it, without separated pieces given to the other side</source>
        <translation>Wie die Ebenen es lassen, ohne abgetrennte Stücke, die der anderen Seite gegeben sind</translation>
    </message>
    <message>
        <source>Area of the cut</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>%1, uncertainty of the cut ±%2, area of the cut %3</source>
        <translation>%1, Unsicherheit des Schnitts ±%2, Schnittfläche %3</translation>
    </message>
    <message>
        <source>at %1; a click shows it in the slices</source>
        <translation>bei %1; ein Klick zeigt es in den Schichten</translation>
    </message>
</context>
<context>
    <name>glisson::PlaneEditor</name>
    <message>
        <source>Resection plane</source>
        <translation>Resektionsebene</translation>
    </message>
    <message>
        <source>Place plane on the liver</source>
        <translation>Ebene auf die Leber setzen</translation>
    </message>
    <message>
        <source>Swap sides</source>
        <translation>Seiten tauschen</translation>
    </message>
    <message>
        <source>Remove plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>A point of the plane, mm: to the patient&apos;s left, posterior, superior</source>
        <translation>Ein Punkt der Ebene, mm: nach links, hinten, oben vom Patienten aus</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>The direction that points to the resected side; made one long when entered</source>
        <translation>Die Richtung zur Resektatseite; wird nach der Eingabe auf Länge eins gebracht</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Kippen</translation>
    </message>
    <message>
        <source>Place the plane in another way</source>
        <translation>Ebene anders setzen</translation>
    </message>
    <message>
        <source>Move towards the remnant</source>
        <translation>Zum Rest hin schieben</translation>
    </message>
    <message>
        <source>Move towards the resected side</source>
        <translation>Zum Resektat hin schieben</translation>
    </message>
    <message>
        <source>Turn left as seen in the 3D view</source>
        <translation>Nach links drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Turn right as seen in the 3D view</source>
        <translation>Nach rechts drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Turn up as seen in the 3D view</source>
        <translation>Nach oben drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Turn down as seen in the 3D view</source>
        <translation>Nach unten drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Through the middle of the liver, edge-on as seen in the 3D view (P)</source>
        <translation>Durch die Mitte der Leber, in 3D von der Kante gesehen (P)</translation>
    </message>
    <message>
        <source>Place a plane first.</source>
        <translation>Setzen Sie zuerst eine Ebene.</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>one point</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>its group</source>
        <translation>seine Gruppe</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Eben</translation>
    </message>
    <message>
        <source>Show 16 control points and drag them along the normal: the plane becomes a Bezier surface</source>
        <translation>16 Kontrollpunkte zeigen und entlang der Normale ziehen: Die Ebene wird eine Bézierfläche</translation>
    </message>
    <message>
        <source>What a drag moves: one point, or all corners, edge or inner points (Shift)</source>
        <translation>Was ein Ziehen bewegt: einen Punkt oder alle Eck-, Rand- oder inneren Punkte (Umschalt)</translation>
    </message>
    <message>
        <source>Press Bend first.</source>
        <translation>Drücken Sie zuerst „Biegen“.</translation>
    </message>
    <message>
        <source>Make the bent surface the plane again</source>
        <translation>Aus der gebogenen Fläche wieder die Ebene machen</translation>
    </message>
    <message>
        <source>The plane is flat.</source>
        <translation>Die Ebene ist eben.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>The control point whose height is shown, highlighted in the 3D view: a click on it there chooses it, too</source>
        <translation>Der Kontrollpunkt, dessen Höhe gezeigt wird, in der 3D-Ansicht hervorgehoben: auch ein Klick auf ihn dort wählt ihn</translation>
    </message>
    <message>
        <source>The control point&apos;s height over the plane, towards the resected side; its group moves along where groups are dragged</source>
        <translation>Die Höhe des Kontrollpunkts über der Ebene, zur resezierten Seite hin; seine Gruppe geht mit, wo Gruppen gezogen werden</translation>
    </message>
</context>
<context>
    <name>glisson::PlanePlacer</name>
    <message>
        <source>Click a point of the model in the 3D view. Escape ends.</source>
        <translation>Klicken Sie in der 3D-Ansicht einen Punkt des Modells an. Escape beendet.</translation>
    </message>
    <message>
        <source>Click three points of the model in the 3D view; it can be turned in between. Escape ends.</source>
        <translation>Klicken Sie in der 3D-Ansicht drei Punkte des Modells an; es lässt sich dazwischen drehen. Escape beendet.</translation>
    </message>
    <message>
        <source>Draw a line across the liver in the 3D view: what lies to its right is resected. Escape ends.</source>
        <translation>Ziehen Sie in der 3D-Ansicht eine Linie über die Leber: Was rechts davon liegt, wird reseziert. Escape beendet.</translation>
    </message>
    <message>
        <source>Plane around a tumour</source>
        <translation>Ebene um einen Tumor</translation>
    </message>
</context>
<context>
    <name>glisson::RatingPage</name>
    <message>
        <source>Very low</source>
        <translation>Sehr gering</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Gering</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Very high</source>
        <translation>Sehr hoch</translation>
    </message>
    <message>
        <source>Model %1 of %2</source>
        <translation>Modell %1 von %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>glisson::RatingPlot</name>
    <message>
        <source>%1 ratings</source>
        <translation>%1 Urteile</translation>
    </message>
</context>
<context>
    <name>glisson::RatingResultsPage</name>
    <message>
        <source>difference %1, t = %2, df = %3, %4</source>
        <translation>Differenz %1, t = %2, df = %3, %4</translation>
    </message>
    <message>
        <source>Box plot of the ratings by method</source>
        <translation>Kastengrafik der Urteile nach Verfahren</translation>
    </message>
    <message>
        <source>Welch&apos;s test takes all ratings for independent of each other. Those of one rater are not: where the tests disagree, trust the paired one over the raters.</source>
        <translation>Der Welch-Test hält alle Urteile für unabhängig voneinander. Die eines Gutachters sind es nicht: Wo die Tests sich widersprechen, gilt der gepaarte über die Gutachter.</translation>
    </message>
    <message>
        <source>The p values are not corrected for the number of comparisons.</source>
        <translation>Die p-Werte sind nicht für die Zahl der Vergleiche korrigiert.</translation>
    </message>
    <message>
        <source>Save CSV...</source>
        <translation>CSV speichern...</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>no test: fewer than two values on a side</source>
        <translation>kein Test: weniger als zwei Werte auf einer Seite</translation>
    </message>
    <message>
        <source>no test: nothing varies</source>
        <translation>kein Test: nichts streut</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation>Urteile</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>%1 less %2</source>
        <translation>%1 minus %2</translation>
    </message>
    <message>
        <source>Welch&apos;s t-test of all ratings: %1</source>
        <translation>Welch-t-Test aller Urteile: %1</translation>
    </message>
    <message>
        <source>Paired t-test over the raters&apos; means: %1</source>
        <translation>Gepaarter t-Test über die Mittel der Gutachter: %1</translation>
    </message>
    <message>
        <source>Paired t-test over the patients by %1 alone: %2</source>
        <translation>Gepaarter t-Test über die Patienten, nur %1: %2</translation>
    </message>
    <message>
        <source>Raters who have finished: %1. Median time for a rating: %2 s.</source>
        <translation>Gutachter, die fertig sind: %1. Median der Zeit je Urteil: %2 s.</translation>
    </message>
    <message>
        <source>Writes the ratings, and in a file beside them the numbers of all tests.</source>
        <translation>Schreibt die Beurteilungen und in eine Datei daneben die Zahlen aller Tests.</translation>
    </message>
    <message>
        <source>Paired t-test over the grades by %1 alone: %2</source>
        <translation>Gepaarter t-Test über die Stufen, nur %1: %2</translation>
    </message>
    <message>
        <source>Models of one grade are paired: %1</source>
        <translation>Gepaart sind Modelle einer Stufe: %1</translation>
    </message>
</context>
<context>
    <name>glisson::RatingWindow</name>
    <message>
        <source>Blind rating</source>
        <translation>Blinde Beurteilung</translation>
    </message>
    <message>
        <source>%1 goes on with model %2 of %3.</source>
        <translation>%1 macht mit Modell %2 von %3 weiter.</translation>
    </message>
    <message>
        <source>Thank you, %1: all ratings are kept.</source>
        <translation>Danke, %1: Alle Urteile sind gesichert.</translation>
    </message>
    <message>
        <source>Blind rating of %1 models</source>
        <translation>Blinde Beurteilung von %1 Modellen</translation>
    </message>
    <message>
        <source>Each rater sees the models one at a time, in a random order, and is not told how they were made. The first %1 are shown twice, and their second rating counts. The mouse turns a model; a button or the keys 1 to 5 rate it and show the next. Take less than a minute for each; a pause stops the time.</source>
        <translation>Jeder Gutachter sieht die Modelle einzeln in zufälliger Reihenfolge und erfährt nicht, wie sie entstanden sind. Die ersten %1 erscheinen zweimal, und ihr zweites Urteil zählt. Die Maus dreht ein Modell; eine Schaltfläche oder die Tasten 1 bis 5 beurteilen es und zeigen das nächste. Nehmen Sie sich je weniger als eine Minute; eine Pause hält die Zeit an.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Evaluate the quality of the virtual models (parenchyma) for their use in resection planning and surgery guidance.</source>
        <translation>Beurteilen Sie die Qualität der virtuellen Modelle (Parenchym) für ihren Einsatz in der Resektionsplanung und zur Führung im Eingriff.</translation>
    </message>
    <message>
        <source>Name of the rater</source>
        <translation>Name des Gutachters</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next rater</source>
        <translation>Nächster Gutachter</translation>
    </message>
    <message>
        <source>Start rating</source>
        <translation>Beurteilung beginnen</translation>
    </message>
    <message>
        <source>Enter the name of the rater first.</source>
        <translation>Geben Sie zuerst den Namen des Gutachters ein.</translation>
    </message>
    <message>
        <source>Enter the question first.</source>
        <translation>Geben Sie zuerst die Frage ein.</translation>
    </message>
    <message>
        <source>Go on with a kept session...</source>
        <translation>Gesicherte Sitzung fortsetzen...</translation>
    </message>
    <message>
        <source>Show results</source>
        <translation>Ergebnisse zeigen</translation>
    </message>
    <message>
        <source>No rater has finished yet.</source>
        <translation>Noch ist kein Gutachter fertig.</translation>
    </message>
    <message>
        <source>Kept after every rating in %1</source>
        <translation>Nach jedem Urteil gesichert in %1</translation>
    </message>
    <message>
        <source>Kept session</source>
        <translation>Gesicherte Sitzung</translation>
    </message>
    <message>
        <source>Ratings (*.csv)</source>
        <translation>Urteile (*.csv)</translation>
    </message>
    <message>
        <source>Save the ratings</source>
        <translation>Urteile speichern</translation>
    </message>
    <message>
        <source>Models for the blind rating</source>
        <translation>Modelle für die blinde Beurteilung</translation>
    </message>
    <message>
        <source>%1 has not finished and takes no part in the results.</source>
        <translation>%1 ist nicht fertig und geht nicht in die Ergebnisse ein.</translation>
    </message>
    <message>
        <source>Another rater...</source>
        <translation>Anderer Gutachter...</translation>
    </message>
    <message>
        <source>Results are shown after the last model.</source>
        <translation>Die Ergebnisse erscheinen nach dem letzten Modell.</translation>
    </message>
    <message>
        <source>Evaluate the quality of the virtual models (%1) for their use in resection planning and surgery guidance.</source>
        <translation>Beurteilen Sie die Qualität der virtuellen Modelle (%1) für ihren Einsatz in der Resektionsplanung und zur Führung im Eingriff.</translation>
    </message>
</context>
<context>
    <name>glisson::ReadingQuestion</name>
    <message>
        <source>The labels will be moved onto the CT&apos;s grid (nearest voxel). Borders may shift by half a voxel.</source>
        <translation>Die Labels werden auf das Gitter der CT gelegt (nächstes Voxel). Grenzen können sich um ein halbes Voxel verschieben.</translation>
    </message>
    <message>
        <source>The CT was taken with a tilted gantry. It will be straightened by resampling; fine detail is softened.</source>
        <translation>Die CT wurde mit gekippter Gantry aufgenommen. Sie wird durch Umrechnen begradigt; feine Einzelheiten werden weicher.</translation>
    </message>
    <message>
        <source>Slices are missing or unevenly spaced. The gaps will be filled by resampling: what lies in them is unseen.</source>
        <translation>Schichten fehlen oder liegen ungleich weit auseinander. Die Lücken werden durch Umrechnen gefüllt: Was darin liegt, bleibt ungesehen.</translation>
    </message>
    <message>
        <source>CT and labels name different patients or studies. If they do not belong together, every number is wrong.</source>
        <translation>CT und Labels nennen verschiedene Patienten oder Studien. Gehören sie nicht zusammen, ist jede Zahl falsch.</translation>
    </message>
    <message>
        <source>A question before reading</source>
        <translation>Eine Frage vor dem Lesen</translation>
    </message>
    <message>
        <source>The file places its voxels in two ways that disagree (sform and qform). The wrong one moves or mirrors the liver. Choose the one your other programs use.</source>
        <translation>Die Datei beschreibt die Lage ihrer Voxel auf zwei Arten, die sich widersprechen (sform und qform). Die falsche verschiebt oder spiegelt die Leber. Wählen Sie die, welche Ihre anderen Programme verwenden.</translation>
    </message>
    <message>
        <source>Use sform</source>
        <translation>sform verwenden</translation>
    </message>
    <message>
        <source>Use qform</source>
        <translation>qform verwenden</translation>
    </message>
    <message>
        <source>Read it all the same</source>
        <translation>Trotzdem lesen</translation>
    </message>
</context>
<context>
    <name>glisson::ReportText</name>
    <message>
        <source>id %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geb. %1</translation>
    </message>
    <message>
        <source>CT of %1</source>
        <translation>CT vom %1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Liver, tumours in it included</source>
        <translation>Leber, mit den Tumoren darin</translation>
    </message>
    <message>
        <source>Functional liver</source>
        <translation>Funktionelle Leber</translation>
    </message>
    <message>
        <source>Resected</source>
        <translation>Reseziert</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Functional remnant (FLR), share of the functional liver</source>
        <translation>Funktioneller Rest (FLR), Anteil der funktionellen Leber</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>longest diameter</source>
        <translation>größter Durchmesser</translation>
    </message>
    <message>
        <source>to the capsule</source>
        <translation>zur Kapsel</translation>
    </message>
    <message>
        <source>nearest vessel</source>
        <translation>nächstes Gefäß</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>%1 from the cut</source>
        <translation>%1 vom Schnitt</translation>
    </message>
    <message>
        <source>Tumours (safety margin %1)</source>
        <translation>Tumoren (Sicherheitsabstand %1)</translation>
    </message>
    <message>
        <source>Separated piece</source>
        <translation>Abgetrenntes Stück</translation>
    </message>
    <message>
        <source>counts with</source>
        <translation>zählt zu</translation>
    </message>
    <message>
        <source>functional</source>
        <translation>funktionell</translation>
    </message>
    <message>
        <source>the resected side</source>
        <translation>der resezierten Seite</translation>
    </message>
    <message>
        <source>the remnant</source>
        <translation>dem Rest</translation>
    </message>
    <message>
        <source>of the resected side</source>
        <translation>des Resektats</translation>
    </message>
    <message>
        <source>of the remnant</source>
        <translation>des Rests</translation>
    </message>
    <message>
        <source>Separated pieces</source>
        <translation>Abgetrennte Stücke</translation>
    </message>
    <message>
        <source>Vessel crossed</source>
        <translation>Gekreuztes Gefäß</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Vessels crossed: %1</source>
        <translation>Gekreuzte Gefäße: %1</translation>
    </message>
    <message>
        <source>liver: %1</source>
        <translation>Leber: %1</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>published</source>
        <translation>veröffentlicht</translation>
    </message>
    <message>
        <source>Body surface (Mosteller)</source>
        <translation>Körperoberfläche (Mosteller)</translation>
    </message>
    <message>
        <source>Standardised liver volume, SLV (Urata)</source>
        <translation>Standardisiertes Lebervolumen, SLV (Urata)</translation>
    </message>
    <message>
        <source>Standardised liver volume, SLV (Vauthey)</source>
        <translation>Standardisiertes Lebervolumen, SLV (Vauthey)</translation>
    </message>
    <message>
        <source>FLR card: published numbers for information, not advice</source>
        <translation>FLR-Karte: veröffentlichte Zahlen zur Information, keine Empfehlung</translation>
    </message>
    <message>
        <source>lies in</source>
        <translation>liegt in</translation>
    </message>
    <message>
        <source>Territories and the remnant&apos;s blood: estimates</source>
        <translation>Territorien und die Durchblutung des Rests: Schätzungen</translation>
    </message>
    <message>
        <source>Territory</source>
        <translation>Territorium</translation>
    </message>
    <message>
        <source>resected</source>
        <translation>Resektat</translation>
    </message>
    <message>
        <source>remnant</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Left and right are proposed from the main bifurcation; nobody has confirmed them.</source>
        <translation>Links und rechts sind von der Hauptgabelung aus vorgeschlagen; niemand hat sie bestätigt.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>a point of it, mm LPS</source>
        <translation>ein Punkt darauf, mm LPS</translation>
    </message>
    <message>
        <source>normal, to the resected side</source>
        <translation>Normale, zur resezierten Seite</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Measured distances</source>
        <translation>Gemessene Abstände</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>made by</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>voxels, mL</source>
        <translation>Voxel, mL</translation>
    </message>
    <message>
        <source>surface, mL</source>
        <translation>Oberfläche, mL</translation>
    </message>
    <message>
        <source>accepted by</source>
        <translation>freigegeben von</translation>
    </message>
    <message>
        <source>no surface yet</source>
        <translation>noch keine Oberfläche</translation>
    </message>
    <message>
        <source>Structures and parameters</source>
        <translation>Strukturen und Parameter</translation>
    </message>
    <message>
        <source>SHA-256 of the surfaces&apos; vertices and triangles</source>
        <translation>SHA-256 der Ecken und Dreiecke der Oberflächen</translation>
    </message>
    <message>
        <source>Not accepted by anybody: %1.</source>
        <translation>Von niemandem freigegeben: %1.</translation>
    </message>
    <message>
        <source>Resection plan: %1</source>
        <translation>Resektionsplan: %1</translation>
    </message>
    <message>
        <source>from anterior</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>from superior</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from the left</source>
        <translation>von links</translation>
    </message>
    <message>
        <source>Pre-operative, supine, rigid: pneumoperitoneum and mobilisation move the liver by centimetres; registration error not included. Not for clinical use.</source>
        <translation>Präoperativ, in Rückenlage, starr: Pneumoperitoneum und Mobilisation verschieben die Leber um Zentimeter; Registrierfehler nicht enthalten. Nicht für den klinischen Gebrauch.</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>not for clinical use</source>
        <translation>nicht für den klinischen Gebrauch</translation>
    </message>
    <message>
        <source>%1 is bent: a cubic Bezier surface over a square of %2 mm around its point, u along %3, v = normal x u along %4. Control points, mm above the plane, from -u and -v on, u running fastest: %5. Beside the square it levels out: d mm beyond the border the height is the cubic one at d - d^2 / (2 w) mm, w = %6 mm, and from w on it stays the same.</source>
        <translation>%1 ist gebogen: eine kubische Bézierfläche über einem Quadrat von %2 mm um ihren Punkt, u entlang %3, v = Normale x u entlang %4. Kontrollpunkte in mm über der Ebene, von -u und -v an, u läuft am schnellsten: %5. Neben dem Quadrat läuft sie flach aus: d mm jenseits des Rands gilt die kubische Höhe bei d - d^2 / (2 w) mm, w = %6 mm, und ab w bleibt sie gleich.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Tumours cut: %1 (%2).</source>
        <translation>Durchtrennte Tumoren: %1 (%2).</translation>
    </message>
    <message>
        <source>Tumours left behind: %1 (%2).</source>
        <translation>Belassene Tumoren: %1 (%2).</translation>
    </message>
    <message>
        <source>Notes on the input and the surfaces</source>
        <translation>Anmerkungen zu Eingabe und Oberflächen</translation>
    </message>
    <message>
        <source>Written %1 UTC; case %2, model revision %3.</source>
        <translation>Geschrieben %1 UTC; Fall %2, Modellrevision %3.</translation>
    </message>
    <message>
        <source>Resection</source>
        <translation>Resektion</translation>
    </message>
    <message>
        <source>area of the cut</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>Area of the cut</source>
        <translation>Schnittfläche</translation>
    </message>
</context>
<context>
    <name>glisson::ReportWriter</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>glisson::Resectogram</name>
    <message>
        <source>Resection surface, laid flat</source>
        <translation>Resektionsfläche, flach ausgebreitet</translation>
    </message>
    <message>
        <source>Cut, from the resected side</source>
        <translation>Schnitt, von der resezierten Seite</translation>
    </message>
    <message>
        <source>under %1 mm to a tumour</source>
        <translation>unter %1 mm zu einem Tumor</translation>
    </message>
    <message>
        <source>perhaps under %1 mm</source>
        <translation>vielleicht unter %1 mm</translation>
    </message>
    <message>
        <source>Lines: every %1 mm</source>
        <translation>Linien: alle %1 mm</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut, laid flat</source>
        <translation>Schnitt, flach</translation>
    </message>
    <message>
        <source>&lt; %1 mm</source>
        <translation>&lt; %1 mm</translation>
    </message>
    <message>
        <source>perhaps &lt; %1</source>
        <translation>evtl. &lt; %1</translation>
    </message>
    <message>
        <source>Lines: %1 mm</source>
        <translation>Linien: %1 mm</translation>
    </message>
    <message>
        <source>The resection surface, laid flat, as seen from the resected side; red: nearer to a tumour than the safety margin; yellow: perhaps nearer, by the size of the voxels; a line every %1 mm of distance</source>
        <translation>Die Resektionsfläche, flach ausgebreitet, von der resezierten Seite gesehen; rot: näher an einem Tumor als der Sicherheitsabstand; gelb: vielleicht näher, nach der Größe der Voxel; alle %1 mm Abstand eine Linie</translation>
    </message>
    <message>
        <source>Folds the map of the cut up</source>
        <translation>Klappt die Schnittkarte ein</translation>
    </message>
    <message>
        <source>Shows the map of the cut</source>
        <translation>Zeigt die Schnittkarte</translation>
    </message>
</context>
<context>
    <name>glisson::ScreenshotTaker</name>
    <message>
        <source>%1 structures could not be reconstructed.</source>
        <translation>%1 Strukturen ließen sich nicht rekonstruieren.</translation>
    </message>
    <message>
        <source>%1 cannot be written; check the folder.</source>
        <translation>%1 lässt sich nicht schreiben; prüfen Sie den Ordner.</translation>
    </message>
    <message>
        <source>The case has no plan &quot;%1&quot;; it has: %2.</source>
        <translation>Der Fall hat keinen Plan „%1“; er hat: %2.</translation>
    </message>
</context>
<context>
    <name>glisson::SliceView</name>
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
        <source>%1 mm
slice %2 of %3</source>
        <translation>%1 mm
Schicht %2 von %3</translation>
    </message>
    <message>
        <source>W %1
L %2</source>
        <translation>W %1
L %2</translation>
    </message>
    <message>
        <source>Axial slices</source>
        <translation>Axiale Schichten</translation>
    </message>
    <message>
        <source>Coronal slices</source>
        <translation>Koronale Schichten</translation>
    </message>
    <message>
        <source>Sagittal slices</source>
        <translation>Sagittale Schichten</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
</context>
<context>
    <name>glisson::StartPage</name>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Planning of liver resections. Not for clinical use.</source>
        <translation>Planung von Leberresektionen. Nicht zur klinischen Anwendung.</translation>
    </message>
    <message>
        <source>Open the sample patient</source>
        <translation>Beispielpatient öffnen</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Dateien öffnen...</translation>
    </message>
    <message>
        <source>Or drop here: a CT (DICOM folder, NIfTI, NRRD, MetaImage) together with its segmentation, or a .glisson case.</source>
        <translation>Oder hier ablegen: eine CT (DICOM-Ordner, NIfTI, NRRD, MetaImage) zusammen mit ihrer Segmentierung oder einen Fall (.glisson).</translation>
    </message>
    <message>
        <source>1. Open a CT and its segmentation: the model is reconstructed by itself.
2. Place the resection plane on the liver and move it: volumes and margins follow.
3. Export the package for navigation.</source>
        <translation>1. CT und Segmentierung öffnen: Das Modell entsteht von selbst.
2. Resektionsebene auf die Leber setzen und bewegen: Volumina und Abstände folgen.
3. Das Paket für die Navigation exportieren.</translation>
    </message>
    <message>
        <source>Last cases</source>
        <translation>Letzte Fälle</translation>
    </message>
</context>
<context>
    <name>glisson::StructureList</name>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Volume of the labelled voxels</source>
        <translation>Volumen der markierten Voxel</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Farbe...</translation>
    </message>
    <message>
        <source>Select a structure in the list first.</source>
        <translation>Wählen Sie zuerst eine Struktur in der Liste.</translation>
    </message>
    <message>
        <source>No surface yet.</source>
        <translation>Noch keine Oberfläche.</translation>
    </message>
    <message>
        <source>Surface %1, voxels %2 (%3), %4 triangles</source>
        <translation>Oberfläche %1, Voxel %2 (%3), %4 Dreiecke</translation>
    </message>
    <message>
        <source>Defect: %1</source>
        <translation>Mangel: %1</translation>
    </message>
    <message>
        <source>Deviation: %1</source>
        <translation>Abweichung: %1</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
    <message>
        <source>Accepted by a person</source>
        <translation>Von einem Menschen freigegeben</translation>
    </message>
</context>
<context>
    <name>glisson::SurfaceView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
</context>
<context>
    <name>glisson::TerritoryBox</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Estimate: no vessel inside the liver is labelled, so nothing is known of the remnant&apos;s blood.</source>
        <translation>Schätzung: In der Leber ist kein Gefäß markiert, daher ist über die Durchblutung des Rests nichts bekannt.</translation>
    </message>
    <message>
        <source>Estimate of the remnant: devascularised %1, congested %2, either %3. FLR without them %4, %5.</source>
        <translation>Schätzung für den Rest: ohne Zufluss %1, gestaut %2, eines von beiden %3. FLR ohne sie %4, %5.</translation>
    </message>
    <message>
        <source>Click a branch of the portal vein in the 3D view: it and all behind it become a territory. Escape ends.</source>
        <translation>Klicken Sie einen Ast der Pfortader in der 3D-Ansicht an: Er und alles dahinter werden ein Territorium. Escape beendet.</translation>
    </message>
    <message>
        <source>Territories (estimates)</source>
        <translation>Territorien (Schätzungen)</translation>
    </message>
    <message>
        <source>Estimate territories</source>
        <translation>Territorien schätzen</translation>
    </message>
    <message>
        <source>Left and right are right</source>
        <translation>Links und rechts stimmen</translation>
    </message>
    <message>
        <source>Pick a branch</source>
        <translation>Ast wählen</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Territory</source>
        <translation>Territorium</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Resected</source>
        <translation>Reseziert</translation>
    </message>
    <message>
        <source>Out of date until the plane rests</source>
        <translation>Veraltet, bis die Ebene ruht</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>The vessels&apos; trees are being computed.</source>
        <translation>Die Gefäßbäume werden berechnet.</translation>
    </message>
    <message>
        <source>Which part of the liver hangs on which branch, and what the plan cuts off from blood</source>
        <translation>Welcher Teil der Leber an welchem Ast hängt und was der Plan von der Durchblutung abschneidet</translation>
    </message>
    <message>
        <source>You have looked at the proposed left and right and found them right</source>
        <translation>Sie haben die Vorschläge für links und rechts angesehen und für richtig befunden</translation>
    </message>
    <message>
        <source>Back to left and right as proposed</source>
        <translation>Zurück zum Vorschlag für links und rechts</translation>
    </message>
    <message>
        <source>Left and right are shown already.</source>
        <translation>Links und rechts werden schon gezeigt.</translation>
    </message>
    <message>
        <source>%1 of it stays</source>
        <translation>%1 davon bleiben</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>unassigned</source>
        <translation>nicht zugeordnet</translation>
    </message>
    <message>
        <source>none of them</source>
        <translation>keinem davon</translation>
    </message>
    <message>
        <source>%1 (proposed)</source>
        <translation>%1 (vorgeschlagen)</translation>
    </message>
    <message>
        <source>Branches in the 3D view</source>
        <translation>Äste in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>The portal branches, each in the colour of the territory that hangs on it; grey ones belong to none of them</source>
        <translation>Die Pfortaderäste, jeder in der Farbe des Territoriums, das an ihm hängt; graue gehören zu keinem</translation>
    </message>
    <message>
        <source>Show the branches in the 3D view and look at them first.</source>
        <translation>Zeigen Sie die Äste in der 3D-Ansicht und sehen Sie sie zuerst an.</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>Choose a map of liver segments 1 to 8</source>
        <translation>Karte der Lebersegmente 1 bis 8 wählen</translation>
    </message>
    <message>
        <source>Label maps (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd)</source>
        <translation>Label-Karten (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Segments from a file...</source>
        <translation>Segmente aus einer Datei...</translation>
    </message>
    <message>
        <source>A map with labels 1 to 8 on the grid of the CT, instead of branches; the case keeps where it lies</source>
        <translation>Eine Karte mit den Labels 1 bis 8 auf dem Raster der CT statt Ästen; der Fall merkt sich, wo sie liegt</translation>
    </message>
    <message>
        <source>The segments of a map hang on no branches.</source>
        <translation>Die Segmente einer Karte hängen an keinen Ästen.</translation>
    </message>
</context>
<context>
    <name>glisson::TerritoryEstimator</name>
    <message>
        <source>Territories</source>
        <translation>Territorien</translation>
    </message>
</context>
<context>
    <name>glisson::TitleLine</name>
    <message>
        <source>Hide identity</source>
        <translation>Person verbergen</translation>
    </message>
    <message>
        <source>Hides the person for pictures; the case&apos;s code stays</source>
        <translation>Verbirgt die Person für Bilder; der Code des Falls bleibt</translation>
    </message>
    <message>
        <source>No case</source>
        <translation>Kein Fall</translation>
    </message>
    <message>
        <source>identity hidden</source>
        <translation>Person verborgen</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>id %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geb. %1</translation>
    </message>
    <message>
        <source>CT of %1</source>
        <translation>CT vom %1</translation>
    </message>
    <message>
        <source>CT is %1 days old</source>
        <translation>CT ist %1 Tage alt</translation>
    </message>
</context>
<context>
    <name>glisson::TumourBox</name>
    <message>
        <source>Tumours: size and place</source>
        <translation>Tumoren: Größe und Lage</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>The longest diameter, of the voxels&apos; boxes</source>
        <translation>Der längste Durchmesser, aus den Quadern der Voxel</translation>
    </message>
    <message>
        <source>Sizes of tumours</source>
        <translation>Größen der Tumoren</translation>
    </message>
    <message>
        <source>Territory: not known; estimate territories first.</source>
        <translation>Territorium: nicht bekannt; erst die Territorien schätzen.</translation>
    </message>
    <message>
        <source>Lies in: %1</source>
        <translation>Liegt in: %1</translation>
    </message>
    <message>
        <source>(out of date)</source>
        <translation>(veraltet)</translation>
    </message>
    <message>
        <source>To the capsule: %1</source>
        <translation>Zur Kapsel: %1</translation>
    </message>
    <message>
        <source>Nearest vessel: %1, %2</source>
        <translation>Nächstes Gefäß: %1, %2</translation>
    </message>
    <message>
        <source>Nearest vessel: the case has no vessels.</source>
        <translation>Nächstes Gefäß: der Fall hat keine Gefäße.</translation>
    </message>
    <message>
        <source>To the capsule: at least %1, for the liver goes on beyond the image there</source>
        <translation>Zur Kapsel: mindestens %1, denn dort reicht die Leber über das Bild hinaus</translation>
    </message>
</context>
<context>
    <name>glisson::VtkWidget</name>
    <message>
        <source>No 3D picture: OpenGL 3.2 does not work on this computer.</source>
        <translation>Kein 3D-Bild: OpenGL 3.2 funktioniert auf diesem Computer nicht.</translation>
    </message>
</context>
<context>
    <name>glisson::WorkspaceBar</name>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
</context>
</TS>
